//! Pages agree with the commands: every line under a `$ percuss …` occurs in the output, in the same order.

use crate::support::{assert_page_shows_what_is_printed, root};

#[test]
fn the_pages_show_what_is_printed() {
    assert_page_shows_what_is_printed("docs/explanation/FIGURE3.md", 6);
    assert_page_shows_what_is_printed("docs/howto/DESIGNS.md", 7);
    assert_page_shows_what_is_printed("docs/reference/STUDIES.md", 1);
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
