//! docs/FIGURE3.md shows what the command prints: every line under a `$ percuss …` stands in its output, in that order.

mod support;

use support::{percuss, root};

#[test]
fn the_page_shows_what_is_printed() {
    let page = std::fs::read_to_string(root().join("docs/FIGURE3.md")).expect("the page");
    let mut commands = 0;
    for block in page.split("```console\n").skip(1) {
        let block = block.split("```").next().unwrap_or("");
        let mut lines = block.lines();
        let command = lines.next().and_then(|l| l.strip_prefix("$ percuss ")).expect("a command");
        let outcome = percuss(command);
        assert_eq!(outcome.code, 0, "{command}: {}", outcome.stderr);
        let mut rest = outcome.stdout.as_str();
        for line in lines {
            let at = rest
                .find(line)
                .unwrap_or_else(|| panic!("{line:?} is not, or not there, in\n{}", outcome.stdout));
            rest = &rest[at + line.len()..];
        }
        commands += 1;
    }
    assert_eq!(commands, 6);
}

/// The XML of the page is the model's, but for spaces.
#[test]
fn the_page_quotes_the_model() {
    let squeezed = |text: &str| text.split_whitespace().collect::<String>();
    let page = std::fs::read_to_string(root().join("docs/FIGURE3.md")).expect("the page");
    let model =
        std::fs::read_to_string(root().join("models/massless_arm_suspension.urdf")).expect("the model");
    let quoted = page.split("```xml\n").nth(1).and_then(|t| t.split("```").next()).expect("some XML");
    for element in quoted.split_inclusive('>').map(squeezed).filter(|e| !e.is_empty()) {
        assert!(squeezed(&model).contains(&element), "{element}");
    }
}
