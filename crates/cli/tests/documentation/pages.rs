//! Pages of the book and the README agree with the commands: every line under a `$ percuss …` occurs in the output, in
//! the same order.

use crate::support::{assert_page_shows_what_is_printed, root};
use std::collections::BTreeSet;
use std::path::Path;

/// Every page, with the number of its commands.
const PAGES: [(&str, usize); 42] = [
    ("README.md", 4),
    ("crates/cli/README.md", 3),
    ("docs/INTRODUCTION.md", 1),
    ("docs/SUMMARY.md", 0),
    ("docs/explanation/ASSEMBLY_MODES.md", 1),
    ("docs/explanation/DECISIONS.md", 0),
    ("docs/explanation/EFFECTIVE_MASS.md", 2),
    ("docs/explanation/FIGURE3.md", 6),
    ("docs/explanation/HELD_CONTACTS.md", 2),
    ("docs/explanation/LIMITS.md", 1),
    ("docs/explanation/SIMULATOR_ERRORS.md", 0),
    ("docs/howto/C.md", 0),
    ("docs/howto/CLUSTER.md", 0),
    ("docs/howto/CODE.md", 2),
    ("docs/howto/DESIGNS.md", 8),
    ("docs/howto/EXPLORER.md", 0),
    ("docs/howto/GALLERY.md", 0),
    ("docs/howto/IMPACT.md", 15),
    ("docs/howto/IMPACT_RECIPES.md", 15),
    ("docs/howto/KINEMATICS.md", 3),
    ("docs/howto/LOOPS.md", 2),
    ("docs/howto/MAPS.md", 2),
    ("docs/howto/PYTHON.md", 0),
    ("docs/howto/REPORTS.md", 1),
    ("docs/howto/RUST.md", 0),
    ("docs/howto/STANDALONE.md", 0),
    ("docs/howto/SUSPENSIONS.md", 9),
    ("docs/reference/BOUNDS.md", 0),
    ("docs/reference/COMMANDS.md", 1),
    ("docs/reference/FORMULAS.md", 0),
    ("docs/reference/MJCF.md", 0),
    ("docs/reference/SDFORMAT.md", 0),
    ("docs/reference/NOTATION.md", 0),
    ("docs/reference/OUTPUTS.md", 1),
    ("docs/reference/PYTHON_NAMES.md", 0),
    ("docs/reference/SIMULATORS.md", 2),
    ("docs/reference/STUDIES.md", 2),
    ("docs/reference/STUDY_KEYS.md", 0),
    ("docs/reference/SUSPENSIONS.md", 1),
    ("docs/tutorials/ROBOT_ARM.md", 7),
    ("docs/tutorials/SIMULATOR.md", 7),
    ("docs/tutorials/SUSPENSION.md", 11),
];

#[test]
fn the_pages_show_what_is_printed() {
    for (page, commands) in PAGES {
        assert_page_shows_what_is_printed(page, commands);
    }
}

/// The list above contains all pages.
#[test]
fn no_page_is_left_out() {
    fn pages(folder: &Path, found: &mut BTreeSet<String>) {
        for entry in std::fs::read_dir(folder).expect("a readable folder").flatten() {
            let path = entry.path();
            if path.is_dir() {
                pages(&path, found);
            } else if path.extension().is_some_and(|ending| ending == "md") {
                let below = path.strip_prefix(root()).expect("a path below the root");
                found.insert(below.to_string_lossy().replace('\\', "/"));
            }
        }
    }
    let mut found = BTreeSet::from(["README.md", "crates/cli/README.md"].map(str::to_owned));
    pages(&root().join("docs"), &mut found);
    let listed: BTreeSet<String> = PAGES.iter().map(|(page, _)| (*page).to_owned()).collect();
    assert_eq!(listed, found);
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
