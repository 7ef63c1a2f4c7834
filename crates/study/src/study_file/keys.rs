//! Positions of the keys of a study file, and its unknown keys, each with the nearest known key.

use crate::study_file::schema::{alternatives, properties, study_keys, study_schema};
use crate::values::message_text::truncate_for_message;
use serde_json::{Map, Value};
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// Largest number of suggestions for an unknown key.
const SUGGESTIONS: usize = 2;
/// Largest number of reported unknown keys; further keys are only counted.
const REPORTED: usize = 50;
/// Longest key, bytes, that is compared with the known keys, which are shorter. The cost is the product of the lengths.
const LONGEST_COMPARED: usize = 64;

/// Keys of a study file with their positions.
#[derive(Clone, Debug, Default)]
pub struct StudyKeys {
    /// Keys and list elements; a container precedes its content.
    nodes: Vec<KeyNode>,
    /// Offsets of the line starts, bytes.
    lines: Vec<usize>,
}

/// Key or list element. Paths are computed from the containers, so that memory is linear in the size of the file.
#[derive(Clone, Debug)]
struct KeyNode {
    /// Index of the containing table or list; `None` at the top level.
    parent: Option<usize>,
    step: PathStep,
    /// Byte range of the key or element.
    key_bytes: Range<usize>,
    /// Byte range of the value.
    value: Range<usize>,
}

/// Last part of a path: key, or index in a list.
#[derive(Clone, Debug)]
enum PathStep {
    Key(Box<str>),
    Item(usize),
}

/// Unknown key of a study file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownKey {
    /// Path of the key.
    pub key: String,
    /// Line of the key, from 1.
    pub line: usize,
    /// Suggested key, or the possible keys.
    pub hint: String,
}

/// Unknown keys: the first `REPORTED` keys in the order of the file, and the number of further keys.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct UnknownKeys {
    pub first: Vec<UnknownKey>,
    pub omitted: usize,
}

/// Index of each unknown key in `places`, with the known keys of its table.
type UnknownNodes = Vec<(usize, &'static Map<String, Value>)>;

impl StudyKeys {
    /// Positions of all keys, and the unknown keys.
    ///
    /// # Errors
    /// Text that is not valid TOML.
    pub(crate) fn from_text(text: &str) -> Result<(Self, UnknownKeys), toml::de::Error> {
        let document = DeTable::parse(text)?;
        let begins = |(at, byte): (usize, u8)| (byte == b'\n').then_some(at + 1);
        let lines = [0].into_iter().chain(text.bytes().enumerate().filter_map(begins)).collect();
        let mut keys = Self { nodes: Vec::new(), lines };
        let mut unknown = UnknownNodes::new();
        keys.collect_keys(document.get_ref(), Some(study_schema()), None, &mut unknown);
        unknown.sort_by_key(|(place, _)| keys.nodes[*place].key_bytes.start);
        let first = unknown.iter().take(REPORTED).map(|(place, known)| keys.unknown(*place, known)).collect();
        let more = unknown.len().saturating_sub(REPORTED);
        Ok((keys, UnknownKeys { first, omitted: more }))
    }

    /// Line of a byte offset, from 1.
    pub(crate) fn line_at(&self, byte: usize) -> usize {
        self.lines.partition_point(|begin| *begin <= byte)
    }

    /// Line of a key, from 1. For a missing key, the line of its table; `None` if the table is missing too.
    pub fn line_of(&self, key: &str) -> Option<usize> {
        let mut key = key;
        loop {
            if let Some(place) = (0..self.nodes.len()).find(|place| self.is_path_of(*place, key)) {
                return Some(self.line_at(self.nodes[place].key_bytes.start));
            }
            key = key.rsplit_once('.')?.0;
        }
    }

    /// True if the file has the key or list element.
    pub fn contains(&self, key: &str) -> bool {
        (0..self.nodes.len()).any(|place| self.is_path_of(place, key))
    }

    /// Key of a variant that replaces a key of the study, such as `variant[0].set` for `pose.set`; `key` if the variant does not have it.
    pub(crate) fn of_variant(&self, number: Option<usize>, key: &str) -> String {
        let last = key.rsplit('.').next().unwrap_or(key);
        let own = |number: usize| [last, key].map(|part| format!("variant[{number}].{part}"));
        let known = number.and_then(|number| own(number).into_iter().find(|own| self.contains(own)));
        known.unwrap_or_else(|| key.to_owned())
    }

    /// Path of the innermost key or list element with a value that contains a byte range. A long path is cut.
    pub(crate) fn key_at(&self, bytes: &Range<usize>) -> Option<String> {
        let holds = |place: &usize| {
            let value = &self.nodes[*place].value;
            value.start <= bytes.start && bytes.end <= value.end
        };
        let innermost =
            (0..self.nodes.len()).filter(holds).min_by_key(|place| self.nodes[*place].value.len());
        innermost.map(|place| self.path(place, true))
    }

    /// Path of a key or list element, such as `variant[1].name`; without `items`, `variant.name`. A long path is cut.
    fn path(&self, place: usize, items: bool) -> String {
        let mut steps = Vec::new();
        let mut next = Some(place);
        while let Some(at) = next {
            steps.push(&self.nodes[at].step);
            next = self.nodes[at].parent;
        }
        let mut path = String::new();
        for step in steps.into_iter().rev() {
            match step {
                PathStep::Key(name) if path.is_empty() => path.push_str(&truncate_for_message(name)),
                PathStep::Key(name) => path.extend([".", &truncate_for_message(name)]),
                PathStep::Item(number) if items => path.push_str(&format!("[{number}]")),
                PathStep::Item(_) => {}
            }
        }
        truncate_for_message(&path).into_owned()
    }

    /// True if `key` is the full path of the key or list element at index `place`.
    fn is_path_of(&self, place: usize, key: &str) -> bool {
        let (mut place, mut rest) = (place, key);
        loop {
            let KeyNode { parent: above, step, .. } = &self.nodes[place];
            let before = match step {
                PathStep::Key(name) => rest.strip_suffix(&**name),
                PathStep::Item(number) if rest.ends_with(']') => rest.strip_suffix(&*format!("[{number}]")),
                PathStep::Item(_) => None,
            };
            rest = match (before, above, step) {
                (Some(before), None, _) => return before.is_empty(),
                (Some(before), Some(_), PathStep::Item(_)) => before,
                (Some(before), Some(_), PathStep::Key(_)) => match before.strip_suffix('.') {
                    Some(before) => before,
                    None => return false,
                },
                (None, ..) => return false,
            };
            place = above.unwrap_or(place);
        }
    }

    /// Record of an unknown key for the report; `known`: the known keys of its table.
    fn unknown(&self, place: usize, known: &Map<String, Value>) -> UnknownKey {
        let KeyNode { parent: above, step, key_bytes: at, .. } = &self.nodes[place];
        let PathStep::Key(name) = step else { unreachable!("elements of lists have no name") };
        let table = above.map_or_else(String::new, |above| self.path(above, false));
        let possible: Vec<&str> = known.keys().map(String::as_str).collect();
        let hint = hint(name, &table, &possible);
        UnknownKey { key: self.path(place, false), line: self.line_at(at.start), hint }
    }

    /// Adds a key or list element with the byte ranges of its name and value; returns its index.
    fn add(&mut self, above: Option<usize>, step: PathStep, at: Range<usize>, value: Range<usize>) -> usize {
        self.nodes.push(KeyNode { parent: above, step, key_bytes: at, value });
        self.nodes.len() - 1
    }

    /// Records the keys of a table. If `schema` is `None` or lists no keys, any key is valid.
    fn collect_keys(
        &mut self,
        table: &DeTable,
        schema: Option<&'static Value>,
        above: Option<usize>,
        unknown: &mut UnknownNodes,
    ) {
        let all = schema.map(alternatives).unwrap_or_default();
        let known = all.iter().find_map(|one| properties(one));
        for (key, value) in table {
            let name: &str = key.get_ref();
            let place = self.add(above, PathStep::Key(name.into()), key.span(), value.span());
            let of_key = match known {
                Some(known) => match known.get(name) {
                    Some(of_key) => Some(of_key),
                    None => {
                        unknown.push((place, known));
                        continue;
                    }
                },
                None => None,
            };
            match value.get_ref() {
                DeValue::Table(table) => self.collect_keys(table, of_key, Some(place), unknown),
                DeValue::Array(list) => {
                    let items = of_key.map(alternatives).unwrap_or_default();
                    let items = items.into_iter().find_map(|one| one.get("items"));
                    for (i, one) in list.iter().enumerate() {
                        let place = self.add(Some(place), PathStep::Item(i), one.span(), one.span());
                        if let DeValue::Table(table) = one.get_ref() {
                            self.collect_keys(table, items, Some(place), unknown);
                        }
                    }
                }
                _ => {}
            }
        }
    }
}

/// Suggestion for an unknown key of a table, or the list of the keys of the table.
fn hint(name: &str, table: &str, possible: &[&str]) -> String {
    let whole = |key: &str| if table.is_empty() { key.to_owned() } else { format!("{table}.{key}") };
    let near = if name.len() > LONGEST_COMPARED { Vec::new() } else { nearest(name, possible) };
    if !near.is_empty() {
        let near: Vec<String> = near.into_iter().map(|key| format!("\"{}\"", whole(key))).collect();
        return format!("did you mean {}?", near.join(" or "));
    }
    let all = study_keys();
    let elsewhere = |key: &&String| key.rsplit('.').next() == Some(name);
    let elsewhere: Vec<String> =
        all.iter().filter(elsewhere).take(SUGGESTIONS).map(|k| format!("\"{k}\"")).collect();
    if !elsewhere.is_empty() {
        return format!("there is {}", elsewhere.join(" and "));
    }
    let place = if table.is_empty() { "a study".to_owned() } else { format!("[{table}]") };
    format!("the keys of {place} are {}", possible.join(", "))
}

/// Known names with the smallest edit distance from a name; empty if the distance exceeds 1 + (length of the name)/4.
fn nearest<'k>(name: &str, possible: &[&'k str]) -> Vec<&'k str> {
    let plain = name.replace('-', "_").to_lowercase();
    let distance = |key: &str| strsim::osa_distance(&plain, key).min(strsim::osa_distance(name, key));
    let most = 1 + name.chars().count() / 4;
    let all = possible.iter().map(|key| (distance(key), *key)).filter(|(distance, _)| *distance <= most);
    let mut near: Vec<(usize, &str)> = all.collect();
    near.sort();
    let least = near.first().map_or(0, |(distance, _)| *distance);
    near.into_iter().take_while(|(d, _)| *d == least).take(SUGGESTIONS).map(|(_, key)| key).collect()
}
