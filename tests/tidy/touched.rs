//! Number of source files between user and mechanics that a flag or a number of a report touches.

use super::{files, root};
use std::collections::BTreeSet;
use std::fs;

/// Crates between the user and the mechanics.
const CRATES: [&str; 5] = ["study", "cli", "python", "capi", "web"];

/// Folders with fields, and the permitted median of the number of sources that contain the name of a field.
const PERMITTED: [(&str, usize); 2] =
    [("crates/study/src/question/tables", 4), ("crates/study/src/reports", 3)];

/// Words of a source.
fn words(text: &str) -> BTreeSet<&str> {
    text.split(|c: char| !c.is_alphanumeric() && c != '_').collect()
}

/// Name of the public field on a line, if it has two words: names of one word are those of other things too.
fn field(line: &str) -> Option<&str> {
    let (name, _) = line.strip_prefix("    pub ")?.split_once(": ")?;
    let is_name = name.chars().all(|c| c.is_alphanumeric() || c == '_');
    (is_name && name.contains('_')).then_some(name)
}

#[test]
fn a_flag_touches_four_sources_and_a_number_three() {
    let sources: Vec<(String, String)> = files(".rs")
        .iter()
        .filter_map(|path| {
            path.strip_prefix(root()).ok().map(|inside| (inside.to_string_lossy().replace('\\', "/"), path))
        })
        .filter(|(inside, _)| CRATES.iter().any(|name| inside.starts_with(&format!("crates/{name}/src/"))))
        .map(|(inside, path)| (inside, fs::read_to_string(path).expect("text")))
        .collect();
    let words: Vec<BTreeSet<&str>> = sources.iter().map(|(_, text)| words(text)).collect();
    for (folder, permitted) in PERMITTED {
        let of_folder = sources.iter().filter(|(path, _)| path.starts_with(folder));
        let names: BTreeSet<&str> = of_folder.flat_map(|(_, text)| text.lines().filter_map(field)).collect();
        let mut counts: Vec<usize> =
            names.iter().map(|name| words.iter().filter(|words| words.contains(name)).count()).collect();
        counts.sort_unstable();
        assert!(counts.len() > 30, "{folder}: {counts:?}");
        let median = counts[counts.len() / 2];
        assert!(
            median <= permitted,
            "{folder}: a field is in {median} sources; {permitted} at most: {counts:?}"
        );
    }
}
