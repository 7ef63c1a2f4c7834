//! Where the keys of a study file stand, and which of them mean nothing: with the one that is nearest.

use crate::study_schema::{alternatives, properties, study_keys, study_schema};
use serde_json::Value;
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// Suggestions for a key that means nothing: more are no help.
const SUGGESTIONS: usize = 2;

/// The keys of a study file, and where they stand.
#[derive(Clone, Debug, Default)]
pub struct StudyKeys {
    /// The key with its tables, `variant[1].name` for those of lists, and its bytes and those of its value.
    places: Vec<(String, Range<usize>, Range<usize>)>,
    /// Where lines begin, bytes.
    lines: Vec<usize>,
}

/// A key that means nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownKey {
    /// The key, with the tables that it stands in.
    pub key: String,
    /// Its line, from 1.
    pub line: usize,
    /// What was meant perhaps, or what is possible.
    pub hint: String,
}

impl StudyKeys {
    /// The places of all keys, and the keys that mean nothing.
    ///
    /// # Errors
    /// Text that is no TOML.
    pub(crate) fn of(text: &str) -> Result<(Self, Vec<UnknownKey>), toml::de::Error> {
        let document = DeTable::parse(text)?;
        let begins = |(at, byte): (usize, u8)| (byte == b'\n').then_some(at + 1);
        let lines = [0].into_iter().chain(text.bytes().enumerate().filter_map(begins)).collect();
        let mut keys = Self { places: Vec::new(), lines };
        let mut unknown = Vec::new();
        keys.walk(document.get_ref(), Some(study_schema()), ("", ""), &mut unknown);
        unknown.sort_by_key(|key| key.line);
        Ok((keys, unknown))
    }

    /// The line of a byte, from 1.
    pub(crate) fn line_at(&self, byte: usize) -> usize {
        self.lines.partition_point(|begin| *begin <= byte)
    }

    /// The line of a key, from 1: of the table around it where it is missing itself; none where that is too.
    pub fn line_of(&self, key: &str) -> Option<usize> {
        let mut key = key;
        loop {
            if let Some((_, place, _)) = self.places.iter().find(|(name, ..)| name == key) {
                return Some(self.line_at(place.start));
            }
            key = key.rsplit_once('.')?.0;
        }
    }

    /// The innermost key whose value holds these bytes.
    pub(crate) fn key_at(&self, bytes: &Range<usize>) -> Option<&str> {
        let holds = |(_, _, value): &&(String, Range<usize>, Range<usize>)| {
            value.start <= bytes.start && bytes.end <= value.end
        };
        let innermost = self.places.iter().filter(holds).min_by_key(|(.., value)| value.len());
        innermost.map(|(name, ..)| name.as_str())
    }

    /// A table; `schema` is none where any key may stand.
    fn walk(
        &mut self,
        table: &DeTable,
        schema: Option<&Value>,
        (path, plain): (&str, &str),
        unknown: &mut Vec<UnknownKey>,
    ) {
        let all = schema.map(alternatives).unwrap_or_default();
        let known = all.iter().find_map(|one| properties(one));
        for (key, value) in table {
            let name: &str = key.get_ref();
            let below = |path: &str| if path.is_empty() { name.to_owned() } else { format!("{path}.{name}") };
            let (path, plain) = (below(path), below(plain));
            self.places.push((path.clone(), key.span(), value.span()));
            let of_key = match known {
                Some(known) => match known.get(name) {
                    Some(of_key) => Some(of_key),
                    None => {
                        let table = plain.rsplit_once('.').map_or("", |(table, _)| table);
                        let possible: Vec<&str> = known.keys().map(String::as_str).collect();
                        let hint = hint(name, table, &possible);
                        unknown.push(UnknownKey { key: plain, line: self.line_at(key.span().start), hint });
                        continue;
                    }
                },
                None => None,
            };
            match value.get_ref() {
                DeValue::Table(table) => self.walk(table, of_key, (&path, &plain), unknown),
                DeValue::Array(list) => {
                    let items = of_key.map(alternatives).unwrap_or_default();
                    let items = items.into_iter().find_map(|one| one.get("items"));
                    for (i, one) in list.iter().enumerate() {
                        let path = format!("{path}[{i}]");
                        self.places.push((path.clone(), one.span(), one.span()));
                        if let DeValue::Table(table) = one.get_ref() {
                            self.walk(table, items, (&path, &plain), unknown);
                        }
                    }
                }
                _ => {}
            }
        }
    }
}

/// What was meant by a key of a table, or what is possible there.
fn hint(name: &str, table: &str, possible: &[&str]) -> String {
    let whole = |key: &str| if table.is_empty() { key.to_owned() } else { format!("{table}.{key}") };
    let near = nearest(name, possible);
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

/// The names that a few letters change into this one, the nearest alone.
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
