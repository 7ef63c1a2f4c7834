//! Words of the names of hardpoints, and the names of other programs, from the data file `names.toml`.

use super::super::template::Template;
use crate::options::Side;
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

/// Names and words of the data file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Vocabulary {
    programs: BTreeMap<String, Program>,
    /// Patterns of each point: required words, and optional ones in brackets.
    pub points: BTreeMap<String, Vec<String>>,
    /// Patterns in their place for a template with a rocker.
    pub points_with_rocker: BTreeMap<String, Vec<String>>,
    pub words: BTreeMap<String, Vec<String>>,
    sides: Sides,
}

/// Names of one program.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Program {
    title: String,
    /// Points of percuss for each name, the first that the template has.
    names: BTreeMap<String, Vec<String>>,
    /// Names of ends of a coil-over, a spring around a damper.
    #[serde(default)]
    coil_overs: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Sides {
    left: Vec<String>,
    right: Vec<String>,
}

pub(super) static VOCABULARY: LazyLock<Vocabulary> =
    LazyLock::new(|| toml::from_str(include_str!("names.toml")).expect("the names of this crate are valid"));

/// Words of a pattern of a point.
pub(super) struct Pattern {
    pub required: BTreeSet<&'static str>,
    pub optional: BTreeSet<&'static str>,
}

impl Pattern {
    fn parse(text: &'static str) -> Self {
        let (required, optional) = text.split_once(" (").unwrap_or((text, ""));
        let words = |text: &'static str| text.trim_end_matches(')').split_whitespace().collect();
        Self { required: words(required), optional: words(optional) }
    }

    pub fn matches(&self, words: &BTreeSet<&str>) -> bool {
        self.required.is_subset(words)
            && words.iter().all(|word| self.required.contains(word) || self.optional.contains(word))
    }
}

/// Patterns of a point; `has_rocker`: the template has a rocker.
pub(super) fn patterns_of(point: &str, has_rocker: bool) -> impl Iterator<Item = Pattern> {
    let vocabulary = &*VOCABULARY;
    let of_rocker = vocabulary.points_with_rocker.get(point).filter(|_| has_rocker);
    of_rocker.or_else(|| vocabulary.points.get(point)).into_iter().flatten().map(|text| Pattern::parse(text))
}

/// Words of a name in lower case, without numbers: split at other characters and where a capital begins a word.
fn split_name(name: &str) -> Vec<String> {
    let chars: Vec<char> = name.chars().collect();
    let mut words = vec![String::new()];
    for (i, c) in chars.iter().enumerate() {
        let before = i.checked_sub(1).map(|i| chars[i]);
        let is_next_small = chars.get(i + 1).is_some_and(|c| c.is_lowercase());
        let begins = c.is_uppercase()
            && before.is_some_and(|before| before.is_lowercase() || before.is_uppercase() && is_next_small);
        if begins || !c.is_alphabetic() {
            words.push(String::new());
        }
        if c.is_alphabetic()
            && let Some(word) = words.last_mut()
        {
            word.extend(c.to_lowercase());
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

/// Side of a word at the beginning or the end of a name.
fn side_of(word: &str) -> Option<Side> {
    let Sides { left, right } = &VOCABULARY.sides;
    let is_in = |list: &[String]| list.iter().any(|known| known == word);
    if is_in(left) { Some(Side::Left) } else { is_in(right).then_some(Side::Right) }
}

/// Name in lower case without the prefix `hps_` and a word of the side, and this side.
fn without_side(name: &str) -> (String, Option<Side>) {
    const SEPARATORS: [char; 7] = ['_', ' ', '-', '.', '(', '[', ':'];
    let lower = name.trim().trim_end_matches([')', ']']).to_lowercase();
    let plain = lower.strip_prefix("hps_").unwrap_or(&lower);
    let ends = [plain.split_once(SEPARATORS), plain.rsplit_once(SEPARATORS).map(|(rest, end)| (end, rest))];
    let without = ends
        .into_iter()
        .flatten()
        .find_map(|(word, rest)| Some((rest.trim_matches(SEPARATORS).to_owned(), Some(side_of(word)?))));
    without.unwrap_or_else(|| (plain.to_owned(), None))
}

/// Readings of a name: its words as they are, without a word of the side, and without the axle ("front", "rear") at the beginning.
fn readings(
    words: &[String],
    side: Option<Side>,
    has_axle: bool,
    found: &mut Vec<(Vec<String>, Option<Side>)>,
) {
    found.push((words.to_vec(), side));
    let [first, .., last] = words else { return };
    let (tail, head) = (&words[1..], &words[..words.len() - 1]);
    if side.is_none() {
        for (word, rest) in [(first, tail), (last, head)] {
            if let Some(side) = side_of(word) {
                readings(rest, Some(side), has_axle, found);
            }
        }
    }
    if !has_axle && ["front", "rear"].contains(&&**first) {
        readings(tail, side, true, found);
    }
}

/// Meaning of the words; `None` if a word is unknown.
fn meaning_of(words: &[String]) -> Option<BTreeSet<&'static str>> {
    let mut meaning = BTreeSet::new();
    for word in words {
        meaning.extend(VOCABULARY.words.get(word)?.iter().map(String::as_str));
    }
    Some(meaning)
}

/// Point of percuss for a name of a table.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Found {
    pub point: &'static str,
    pub side: Option<Side>,
    /// Program with this name; `None`: read by its words.
    pub program: Option<&'static str>,
    pub is_coil_over: bool,
}

/// Point of the template that a name means: a name of a program, or else its words. `None` if no point has the name, or several.
pub(super) fn point_of(name: &str, template: &'static Template) -> Option<Found> {
    let own = |point: &str| template.points.iter().find(|(key, _)| key == point).map(|(key, _)| &**key);
    let (plain, side) = without_side(name);
    // A name of percuss with a mark of the side.
    if let Some(point) = own(&plain.replace([' ', '-', '.'], "_")).filter(|_| side.is_some()) {
        return Some(Found { point, side, program: None, is_coil_over: false });
    }
    let of_program = VOCABULARY.programs.values().find_map(|program| {
        let point = program.names.get(&plain)?.iter().find_map(|point| own(point))?;
        let is_coil_over = program.coil_overs.contains(&plain);
        Some(Found { point, side, program: Some(&program.title), is_coil_over })
    });
    if of_program.is_some() {
        return of_program;
    }
    let words = split_name(name);
    // More words belong to a sentence; the number of readings stays small.
    if words.len() > 12 {
        return None;
    }
    let (mut all, mut found) = (Vec::new(), Vec::<Found>::new());
    readings(&words, None, false, &mut all);
    let has_rocker = own("pushrod_rocker").is_some();
    for (words, side) in all {
        let Some(mut meaning) = meaning_of(&words) else { continue };
        let is_coil_over = meaning.remove("coil-over");
        let points = template
            .points
            .iter()
            .filter(|(point, _)| patterns_of(point, has_rocker).any(|pattern| pattern.matches(&meaning)));
        found.extend(points.map(|(point, _)| Found { point, side, program: None, is_coil_over }));
    }
    let first = found.iter().find(|one| one.side.is_some()).or(found.first())?;
    found.iter().all(|one| one.point == first.point).then(|| first.clone())
}

/// Point with a meaning like that of a name: at least two words in common, and more than any other.
pub(in super::super) fn near_meaning<'k>(
    name: &str,
    points: impl Iterator<Item = &'k str>,
) -> Option<&'k str> {
    let words = split_name(name);
    let known = words.iter().filter_map(|word| VOCABULARY.words.get(word)).flatten();
    let meaning: BTreeSet<&str> = known.map(String::as_str).collect();
    let score = |point: &str| {
        let of_pattern = |pattern: Pattern| {
            let of_point =
                pattern.required.union(&pattern.optional).filter(|word| meaning.contains(*word)).count();
            (of_point, std::cmp::Reverse(pattern.required.difference(&meaning).count()))
        };
        patterns_of(point, false).map(of_pattern).max().unwrap_or((0, std::cmp::Reverse(0)))
    };
    let mut ranked: Vec<_> = points.map(|point| (score(point), point)).collect();
    ranked.sort_by_key(|(score, _)| std::cmp::Reverse(*score));
    match ranked[..] {
        [(first, point), (second, _), ..] if first.0 >= 2 && first > second => Some(point),
        [(first, point)] if first.0 >= 2 => Some(point),
        _ => None,
    }
}

/// True if all words of a name are known.
pub(in super::super) fn has_known_words(name: &str) -> bool {
    let words = split_name(name);
    !words.is_empty()
        && words.iter().all(|word| VOCABULARY.words.contains_key(word) || side_of(word).is_some())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_split_into_words() {
        for (name, words) in [
            ("LowerWishboneFrontPivot", "lower wishbone front pivot"),
            ("LCA_IF", "lca if"),
            ("lwb.front", "lwb front"),
            ("LCAFront", "lca front"),
            ("1 Outer track-rod ball joint (left)", "outer track rod ball joint left"),
        ] {
            assert_eq!(split_name(name).join(" "), words);
        }
    }
}
