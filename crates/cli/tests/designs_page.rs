//! The pages show what the commands print: every line under a `$ percuss …` stands in its output, in that order.

mod support;

use support::{percuss, root};

#[test]
fn the_pages_show_what_is_printed() {
    assert_eq!(commands_of("docs/DESIGNS.md"), 7);
    assert_eq!(commands_of("docs/STUDIES.md"), 1);
}

/// Runs the commands of a page; how many there are.
fn commands_of(page: &str) -> usize {
    let page = std::fs::read_to_string(root().join(page)).expect("the page");
    let mut commands = 0;
    for block in page.split("```console\n").skip(1) {
        let block = block.split("```").next().unwrap_or("");
        let mut lines = block.lines();
        let command = lines.next().and_then(|l| l.strip_prefix("$ percuss ")).expect("a command");
        let outcome = percuss(command);
        assert_eq!(outcome.code, 0, "{command}: {}", outcome.stderr);
        let mut rest = outcome.stdout.as_str();
        let mut shown = 0;
        for line in lines {
            let at = rest
                .find(line)
                .unwrap_or_else(|| panic!("{line:?} is not, or not there, in\n{}", outcome.stdout));
            rest = &rest[at + line.len()..];
            shown += 1;
        }
        assert!(shown > 0, "{command} shows nothing");
        commands += 1;
    }
    commands
}
