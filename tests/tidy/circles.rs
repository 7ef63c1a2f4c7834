//! Cycles among the imports of a crate's files.

use super::imports::Imports;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Groups of files in which each file imports every other, directly or indirectly (the strongly connected components
/// with more than one file).
pub fn circles(imports: &Imports) -> Vec<BTreeSet<&str>> {
    let files: BTreeSet<&str> = imports.keys().flat_map(|(a, b)| [a.as_str(), b.as_str()]).collect();
    let mut found: Vec<BTreeSet<&str>> = Vec::new();
    for &file in files.iter().filter(|&&file| reached(imports, file).contains(file)) {
        if found.iter().all(|circle| !circle.contains(file)) {
            let ahead = reached(imports, file);
            found.push(ahead.into_iter().filter(|&other| reached(imports, other).contains(file)).collect());
        }
    }
    found
}

/// Files that `file` imports, directly or indirectly.
fn reached<'a>(imports: &'a Imports, file: &'a str) -> BTreeSet<&'a str> {
    let mut seen = BTreeSet::new();
    let mut open = vec![file];
    while let Some(at) = open.pop() {
        for (_, to) in imports.keys().filter(|(from, _)| from == at) {
            if seen.insert(to.as_str()) {
                open.push(to);
            }
        }
    }
    seen
}

/// Imports between the top folders of a crate. A file in no folder counts by itself.
pub fn between_folders(imports: &Imports) -> Imports {
    let folder = |file: &str| file.split_once('/').map_or(file, |(folder, _)| folder).to_string();
    let mut found = Imports::new();
    for ((from, to), names) in imports.iter().filter(|((from, to), _)| folder(from) != folder(to)) {
        found.entry((folder(from), folder(to))).or_default().extend(names.iter().cloned());
    }
    found
}

/// Text for a cycle: each of its imports, with the imported names.
pub fn describe(circle: &BTreeSet<&str>, imports: &Imports) -> String {
    let mut text = String::new();
    for ((from, to), names) in imports {
        if circle.contains(from.as_str()) && circle.contains(to.as_str()) {
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            writeln!(text, "    {from} imports {} of {to}", names.join(", ")).expect("a String takes all");
        }
    }
    text
}
