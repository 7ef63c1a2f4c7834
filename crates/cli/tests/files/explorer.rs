//! The page of `percuss explore`. The page itself is tested in a browser by tests/external/explorer.

use crate::support::{Scratch, percuss};
use std::fs;

const SHEET: &str = "explore models/suspensions/double-wishbone.toml";

#[test]
fn a_page_is_written_or_the_missing_engine_is_explained() {
    let folder = Scratch::new("explore");
    let path = folder.path("page.html");
    let outcome = percuss(&format!("{SHEET} -o {path}"));
    if cfg!(feature = "explorer") {
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        let page = fs::read_to_string(&path).expect("written");
        assert!(page.contains("made by percuss") && page.contains("default-src 'none'"));
        let refused = percuss(&format!("{SHEET} --at nowhere -o {path}"));
        assert!(refused.code == 2 && refused.stderr.contains("nowhere"), "{}", refused.stderr);
        let pose = folder.write("pose.json", "{ \"pose\": { \"spin\": 0 } }");
        let refused = percuss(&format!("{SHEET} --at spring --pose {pose} -o {path}"));
        assert!(refused.code == 2 && refused.stderr.contains("--set"), "{}", refused.stderr);
        let study = "models/studies/variants.toml";
        let outcome = percuss(&format!("explore {study} -o {path}"));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        let page = fs::read_to_string(&path).expect("written");
        assert!(page.contains("\"name\":\"ball 5 mm higher\""), "the variants are in the page");
        // Included files are in the page, in base64; a workbook is refused.
        folder.write("arm.xml", "<mujocoinclude><worldbody><body name=\"arm\"><joint axis=\"0 1 0\"/><geom size=\"1\"/></body></worldbody></mujocoinclude>");
        let scene = folder.write("scene.xml", "<mujoco><include file=\"arm.xml\"/></mujoco>");
        let outcome = percuss(&format!("explore {scene} -o {path}"));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        let page = fs::read_to_string(&path).expect("written");
        assert!(page.contains("arm.xml\":\"PG11am9jb2luY2x1ZGU"), "base64 of <mujocoinclude>");
        let refused =
            percuss(&format!("explore models/suspensions/double-wishbone-with-table.toml -o {path}"));
        assert!(refused.code == 2 && refused.stderr.contains("workbook"), "{}", refused.stderr);
        let refused = percuss(&format!("explore {study} --at spring -o {path}"));
        assert!(refused.code == 2 && refused.stderr.contains("is a study"), "{}", refused.stderr);
    } else {
        assert_eq!(outcome.code, 2);
        let command = "`cargo run --release --features explorer -- explore models/four_bar.urdf`";
        assert!(outcome.stderr.contains(command), "{}", outcome.stderr);
        assert!(!fs::exists(&path).expect("a readable folder"));
    }
}
