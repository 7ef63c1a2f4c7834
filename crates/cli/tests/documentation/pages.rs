//! Pages of the book and the README agree with the commands: every line under a `$ percuss …` occurs in the output, in
//! the same order.

use crate::support::blocks::{Part, agree, commands, parts};
use crate::support::{percuss, root, workshop};
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// Pages below a folder.
fn add_pages(folder: &Path, pages: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a readable folder").flatten() {
        let path = entry.path();
        if path.is_dir() {
            add_pages(&path, pages);
        } else if path.extension().is_some_and(|ending| ending == "md") {
            pages.push(path);
        }
    }
}

#[test]
fn the_pages_show_what_is_printed() {
    let mut pages = ["README.md", "crates/cli/README.md"].map(|page| root().join(page)).to_vec();
    add_pages(&root().join("docs"), &mut pages);
    pages.sort();
    let mut commands = 0;
    for page in &pages {
        let text = std::fs::read_to_string(page).expect("the page");
        let executed = assert_page_shows_what_is_printed(&page.display().to_string(), &text);
        assert_eq!(executed, text.matches("$ percuss ").count(), "commands on {}", page.display());
        commands += executed;
    }
    assert!(commands > 100, "only {commands} commands on {} pages", pages.len());
}

/// Asserts that every line under a `$ percuss …` of a page occurs in the output of the command, in the same order; returns the
/// number of commands.
///
/// The commands of a page run one after another, and their files are removed after the page. A command with no line under it
/// prints nothing to stdout.
fn assert_page_shows_what_is_printed(page: &str, text: &str) -> usize {
    let before = entries(workshop());
    let mut count = 0;
    for part in parts(text) {
        // Commands are in console blocks only, so that none is left out.
        let block = match part {
            Part::Block { info: "console", text } => text,
            Part::Block { text, .. } | Part::Prose(text) => {
                let indent = if matches!(part, Part::Prose(_)) { "    " } else { "" };
                let command = text.lines().find(|line| line.starts_with(&format!("{indent}percuss ")));
                assert_eq!(command, None, "{page}: not in a console block");
                continue;
            }
        };
        for (line, shown) in commands(block) {
            let words = line.replace("\\\n", " ");
            let words = words.strip_prefix("percuss ").unwrap_or_else(|| panic!("{page}: {line}"));
            let outcome = percuss(words);
            assert_eq!(outcome.code, 0, "{page}: {line}: {}", outcome.stderr);
            assert_lines_are_printed(&format!("{page}: {line}"), shown, &outcome.stdout);
            count += 1;
        }
    }
    for name in entries(workshop()).difference(&before) {
        let path = workshop().join(name);
        let removed = if path.is_dir() { std::fs::remove_dir_all(path) } else { std::fs::remove_file(path) };
        removed.expect("removed");
    }
    count
}

fn entries(folder: &Path) -> BTreeSet<OsString> {
    std::fs::read_dir(folder).expect("a readable folder").flatten().map(|entry| entry.file_name()).collect()
}

/// Asserts that the lines occur in the printed text, in the same order; without lines, that nothing is printed.
fn assert_lines_are_printed(at: &str, lines: &str, printed: &str) {
    let mut rest = printed;
    let mut shown = 0;
    for line in lines.lines().filter(|line| !line.is_empty()) {
        shown += 1;
        let mut end = 0;
        let found = rest.split_inclusive('\n').find(|printed| {
            end += printed.len();
            let (line, printed) = (line.trim_end(), printed.trim_end());
            printed.contains(line) || agree(line, printed)
        });
        assert!(found.is_some(), "{at}: {line:?} is not, or not there, in\n{printed}");
        rest = &rest[end..];
    }
    assert!(shown > 0 || printed.is_empty(), "{at}: the page shows nothing of\n{printed}");
}

/// The XML on the page equals the model, except for white space.
#[test]
fn the_page_quotes_the_model() {
    let squeezed = |text: &str| text.split_whitespace().collect::<String>();
    let page = std::fs::read_to_string(root().join("docs/explanation/FIGURE3.md")).expect("the page");
    let model =
        std::fs::read_to_string(root().join("models/massless_arm_suspension.urdf")).expect("the model");
    let quoted = page.split("```xml\n").nth(1).and_then(|t| t.split("```").next()).expect("some XML");
    for element in quoted.split_inclusive('>').map(squeezed).filter(|e| !e.is_empty()) {
        assert!(squeezed(&model).contains(&element), "{element}");
    }
}
