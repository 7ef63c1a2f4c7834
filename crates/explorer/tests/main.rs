//! Tests of the page as a file; the script is tested in a browser by tests/external/explorer.

use percuss_explorer::{PageContent, page};
use serde_json::json;

#[test]
fn texts_of_a_model_stay_data() {
    let hostile = "</script><script>alert(1)</script><!--";
    let start = json!({ "name": hostile });
    let html = page(&PageContent { title: hostile, generator: "percuss", start: &start, engine: b"engine" });
    let opened = html.matches("<script").count() - html.matches("\"<script").count();
    // Start, engine and the script; the bundle itself has no such text.
    assert_eq!(opened, 3, "a text of the model opened an element");
    assert!(!html.contains("alert(1)</script>"));
    assert!(html.contains("\\u003c/script>\\u003cscript>alert(1)"));
}

#[test]
fn the_page_loads_nothing() {
    let html = page(&PageContent { title: "t", generator: "percuss", start: &json!({}), engine: b"engine" });
    let head = &html[..html.find("<style>").unwrap()];
    assert!(head.contains("default-src 'none'"));
    assert_eq!(head.matches("'sha256-").count(), 2);
    assert!(!head.contains("unsafe-inline") && !head.contains("https:") && !head.contains("http:"));
}

/// The whole file is at most 2.64 MB with an engine of at most 1.38 MB; base64 adds a third.
#[test]
fn the_page_without_its_engine_is_small() {
    const LARGEST_PAGE: usize = 2_640_000;
    const LARGEST_ENGINE: usize = 1_380_000;
    let html = page(&PageContent { title: "t", generator: "percuss", start: &json!({}), engine: &[] });
    assert!(html.len() < LARGEST_PAGE - LARGEST_ENGINE / 3 * 4, "{} bytes", html.len());
}
