//! The page of `percuss explore`. The page itself is tested in a browser by tests/external/explorer.

use crate::support::{Scratch, percuss};
use std::fs;

const SHEET: &str = "explore models/suspensions/double-wishbone.toml";

#[test]
fn a_build_without_the_engine_says_how_to_get_it() {
    let folder = Scratch::new("explore");
    let path = folder.path("page.html");
    let outcome = percuss(&format!("{SHEET} -o {path}"));
    if cfg!(feature = "explorer") {
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        let page = fs::read_to_string(&path).expect("written");
        assert!(page.contains("made by percuss") && page.contains("default-src 'none'"));
        let refused = percuss(&format!("{SHEET} --at nowhere -o {path}"));
        assert!(refused.code == 2 && refused.stderr.contains("nowhere"), "{}", refused.stderr);
        let refused = percuss(&format!("{SHEET} --at spring --pose pose.json -o {path}"));
        assert!(refused.code == 2 && refused.stderr.contains("--set"), "{}", refused.stderr);
        let study = "models/studies/variants.toml";
        let outcome = percuss(&format!("explore {study} -o {path}"));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        let page = fs::read_to_string(&path).expect("written");
        assert!(page.contains("\"name\":\"ball 5 mm higher\""), "the variants are in the page");
        let refused = percuss(&format!("explore {study} --at spring -o {path}"));
        assert!(refused.code == 2 && refused.stderr.contains("is a study"), "{}", refused.stderr);
    } else {
        assert_eq!(outcome.code, 2);
        assert!(outcome.stderr.contains("--features explorer"), "{}", outcome.stderr);
        assert!(!fs::exists(&path).expect("a readable folder"));
    }
}
