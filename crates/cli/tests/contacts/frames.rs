//! Contact points given in another frame than that of the contact link: pose of the conversion, and effect in a
//! sweep.

use crate::support::{Scratch, Sweep, json, percuss, root};

const FOUR_BAR: &str = "models/four_bar.urdf --link coupler --normal 0,1,0";
const WISHBONE: &str = "models/double_wishbone.urdf --link bump_stop_pad --along-line bump_stop:0,0,0 --turning-normal --against chassis";
/// In the world frame, near the pad.
const WISHBONE_POINT: &str = "--frame world --point=0.02,0.5,-0.01";
const TRAVEL: &str = "travel:wheel_centre:0,0,0:0,0,1";

fn swept(line: &str) -> Sweep {
    let outcome = percuss(line);
    assert_eq!(outcome.code, 0, "{line}\n{}", outcome.stderr);
    Sweep::read(&outcome.stdout)
}

/// m̄ of the row in which a column has the given value.
fn at(line: &str, column: &str, value: f64) -> f64 {
    let sweep = swept(line);
    let row = (0..sweep.rows.len())
        .find(|row| (sweep.number(*row, column).unwrap() - value).abs() < 1e-12)
        .unwrap_or_else(|| panic!("{line} has no row at {value}"));
    sweep.number(row, "effective_mass").expect("a finite mass")
}

/// The result at a pose does not depend on the range of the sweep, its direction or its number of rows.
#[track_caller]
fn assert_same(line: &str, what: &str, column: &str, ranges: &[&str], value: f64) {
    let masses: Vec<f64> = ranges
        .iter()
        .map(|range| at(&format!("sweep {line} --vary {what}={range}"), column, value))
        .collect();
    for m in &masses {
        assert!((m / masses[0] - 1.0).abs() < 1e-12, "{line} at {value}: {masses:?}");
    }
}

#[test]
fn a_point_in_the_world_is_the_same_for_every_range() {
    let world = format!("{FOUR_BAR} --frame world --point 0.35,0.4,0");
    let ranges = ["30deg:60deg:2", "-30deg:30deg:3", "0:30deg:7", "30deg:-300deg:12", "90deg:30deg:61"];
    assert_same(&world, "crank_hinge", "crank_hinge", &ranges, 30f64.to_radians());
    let world = format!("{WISHBONE} {WISHBONE_POINT}");
    let ranges = ["0:80mm:3", "-80mm:80mm:5", "40mm:40mm:1", "80mm:-80mm:33", "-40mm:40mm:161"];
    assert_same(&world, TRAVEL, "travel:wheel_centre", &ranges, 0.04);
    let ranges = ["0:80mm:3", "-80mm:80mm:5", "0:0:1", "80mm:-80mm:33"];
    assert_same(&world, TRAVEL, "travel:wheel_centre", &ranges, 0.0);
    let ranges = ["0.2:0.3:2", "-0.2:0.2:5", "0.2:0:2"];
    assert_same(&world, "lower_arm_hinge", "lower_arm_hinge", &ranges, 0.2);
    // Against another link with a moving frame.
    let against = format!("{FOUR_BAR} --against rocker --frame against --point=-0.2,0.5,0");
    let ranges = ["30deg:60deg:2", "-30deg:30deg:3", "0:30deg:7"];
    assert_same(&against, "crank_hinge", "crank_hinge", &ranges, 30f64.to_radians());
}

/// At zero, the frames of the four-bar are parallel and the crank's pin is at (0, 0.3), so the point is known in
/// closed form.
#[test]
fn the_point_moves_with_the_link_and_the_normal_keeps_its_axes() {
    let world = format!("sweep {FOUR_BAR} --frame world --point 0.35,0.4,0 --vary crank_hinge=20deg:80deg:4");
    let by_hand = FOUR_BAR.to_owned() + " --point 0.35,0.1,0";
    let turned = swept(&format!("sweep {by_hand} --vary crank_hinge=20deg:80deg:4"));
    let (kept, mut apart) = (swept(&world), 0.0);
    for row in 0..4 {
        let angle = kept.cell(row, "crank_hinge");
        // Reference for one pose: the normal in world axes, the point in the link frame.
        let one =
            json(&format!("mass {by_hand} --normal-frame world --set crank_hinge={angle} --format json"));
        assert_eq!(one["contact"]["normal_world"], serde_json::json!([0.0, 1.0, 0.0]));
        let (m, expected) =
            (kept.number(row, "effective_mass").unwrap(), one["effective_mass"].as_f64().unwrap());
        assert!((m / expected - 1.0).abs() < 1e-12, "row {row}: {m} {expected}");
        apart = f64::max(apart, (m / turned.number(row, "effective_mass").unwrap() - 1.0).abs());
    }
    assert!(apart > 0.01, "a normal that turns with the link is another");
}

/// A study behaves like the flags; its messages name keys instead of flags.
#[test]
fn a_study_converts_as_the_flags_do() {
    let scratch = Scratch::new("frames-study");
    let text = |vary: &str| {
        let model = root().join("models/four_bar.urdf");
        format!(
            "[model]\npath = {:?}\n[contact]\nlink = \"coupler\"\npoint = [0.35, 0.4, 0]\nnormal = [0, 1, 0]\nframe = \"world\"\n\
             [sweep]\nvary = \"{vary}\"\n",
            model.display()
        )
    };
    let study = percuss(&format!("run {}", scratch.write("a.toml", &text("crank_hinge=-1:2:7"))));
    let flags =
        percuss(&format!("sweep {FOUR_BAR} --frame world --point 0.35,0.4,0 --vary crank_hinge=-1:2:7"));
    assert_eq!((study.code, study.stdout), (0, flags.stdout));
}
