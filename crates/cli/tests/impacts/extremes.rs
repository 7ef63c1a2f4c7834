//! Extremes over ranges of joints: command `extremes`.

use crate::support::{json, percuss};
use serde_json::Value;

/// Rounding of a few operations.
const ROUNDING: f64 = 1e-12;

#[test]
fn extremes_of_an_arm() {
    let command = "extremes models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --normal-frame world \
                   --range shoulder=-180deg:180deg --range elbow=20deg:160deg";
    let report = json(&format!("{command} --format json"));
    for key in ["least", "most"] {
        let found = &report[key];
        // The mass at the positions of the extreme, by percuss mass.
        let position = |i: usize| found["positions"][i]["position"].as_f64().expect("a position");
        let mass = json(&format!(
            "mass models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --normal-frame world --set shoulder={} \
             --set elbow={} --format json",
            position(0),
            position(1)
        ));
        let (a, b) = (found["effective_mass"].as_f64().expect("a mass"), mass["effective_mass"].as_f64());
        assert!((a / b.expect("a mass") - 1.0).abs() < 1e-9, "{key}: {found}");
        // The search compares masses: positions are accurate to the square root of rounding, times the curvature.
        assert!(found["residual"].as_f64().expect("a residual") < 1e-5, "{found}");
        assert!(found["agreeing"].as_u64().expect("a number") > 1, "{found}");
    }
    // Over all normals of the plane the smallest mass is smaller and the largest larger.
    let plane = json(&format!("{command} --normals across:0,0,1 --format json"));
    let mass = |report: &Value, key: &str| report[key]["effective_mass"].as_f64().expect("a mass");
    let ratio = |key: &str| mass(&plane, key) / mass(&report, key);
    assert!(ratio("least") <= 1.0 + ROUNDING && ratio("most") >= 1.0 - ROUNDING);
    assert!(plane["most"]["normal_world"][2].as_f64().expect("a number").abs() < ROUNDING);
    assert!(report["most"]["normal_world"].is_null());
    let text = percuss(&format!("{command} --normals across:0,0,1")).stdout;
    assert!(text.contains("up to its sign"), "{text}");
    let wrong = percuss(&format!("{command} --normals across:0,0"));
    assert!(wrong.code == 2 && wrong.stderr.contains("across:X,Y,Z"), "{}", wrong.stderr);
    let text = percuss(command).stdout;
    assert!(text.contains("starts agree") && text.contains("no proof"), "{text}");
    for (more, words) in [
        ("--range nope=0:1", "--range"),
        ("--range elbow=1:0", "--range"),
        ("--range elbow=0:1m", "--range"),
        ("--range elbow", "--range"),
    ] {
        let arm = "extremes models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0";
        let outcome = percuss(&format!("{arm} {more}"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{more}: {}", outcome.stderr);
    }
    // The message about a follower lists the joints that drive.
    let follower = percuss(
        "extremes models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 --range rocker_hinge=0:0.1",
    );
    assert!(follower.code == 2 && follower.stderr.contains("expected one of"), "{}", follower.stderr);
    assert!(follower.stderr.contains("crank_hinge"), "{}", follower.stderr);
    // With a held direction of the tip the masses are those of percuss mass; held in all directions, every pose is immovable.
    let arm = "--link outer --point 0.4,0,0 --normal 1,0,0 --hold outer:0.4,0,0";
    let ranges = "--range elbow=0.8:1.2 --range shoulder=-0.3:0.1 --format json";
    let held = json(&format!("extremes models/planar_2r.urdf {arm}:0,1,0 {ranges}"));
    for key in ["least", "most"] {
        let at = |i: usize| held[key]["positions"][i]["position"].as_f64().expect("a position");
        let there = format!("--set elbow={} --set shoulder={}", at(0), at(1));
        let mass = json(&format!("mass models/planar_2r.urdf {arm}:0,1,0 {there} --format json"));
        let exact = mass["effective_mass"].as_f64().expect("a mass");
        assert!((held[key]["effective_mass"].as_f64().expect("a mass") / exact - 1.0).abs() < 1e-9, "{held}");
        // A scan of the ranges finds nothing beyond.
        for (elbow, shoulder) in [(0.8, -0.3), (0.8, 0.1), (1.2, -0.3), (1.2, 0.1), (1.0, -0.1)] {
            let there = format!("--set elbow={elbow} --set shoulder={shoulder}");
            let mass = json(&format!("mass models/planar_2r.urdf {arm}:0,1,0 {there} --format json"));
            let other = mass["effective_mass"].as_f64().expect("a mass");
            let is_beyond =
                if key == "least" { other < exact * (1.0 - 1e-9) } else { other > exact * (1.0 + 1e-9) };
            assert!(!is_beyond, "{key}: {exact}, {other} at {there}");
        }
    }
    let fixed = json(&format!("extremes models/planar_2r.urdf {arm} {ranges}"));
    assert_eq!(
        (&fixed["least"]["status"], &fixed["most"]["status"]),
        (&"immovable".into(), &"immovable".into())
    );
    // Without limits and ranges nothing varies.
    let refused = percuss(
        "extremes models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --against-mass 2",
    );
    assert!(refused.code == 2 && refused.stderr.contains("--against-mass"), "{}", refused.stderr);
    let outcome = percuss("extremes models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0");
    assert!(outcome.code == 2 && outcome.stderr.contains("no joint varies"), "{}", outcome.stderr);
}

/// The extremes of an inertia and of a bearing impulse agree with impacts at the reported positions.
#[test]
fn extremes_of_other_quantities() {
    let contact = "models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0";
    let range = "--range elbow=20deg:160deg --format json";
    for (quantity, unit) in
        [("held:shoulder", "kg·m²"), ("reflected:shoulder", "kg·m²"), ("bearing:elbow", "kg")]
    {
        let report = json(&format!("extremes {contact} {range} --quantity {quantity}"));
        assert_eq!(report["unit"], unit);
        assert!(report["least"]["effective_mass"].is_null());
        for end in ["least", "most"] {
            let value = report[end]["value"].as_f64().expect("a value");
            let elbow = report[end]["positions"][0]["position"].as_f64().expect("a position");
            let impact = json(&format!(
                "impact {contact} --set elbow={elbow} --restitution 0 --speed 1 --reflected shoulder --format json"
            ));
            let expected = match quantity {
                "held:shoulder" => impact["reflected_inertia"][0]["held"].as_f64(),
                "reflected:shoulder" => impact["reflected_inertia"][0]["free"].as_f64(),
                _ => {
                    let reactions = impact["reactions"].as_array().expect("reactions");
                    let elbow = reactions.iter().find(|r| r["name"] == "elbow").expect("the elbow");
                    let force = elbow["force"].as_array().expect("a force");
                    Some(force.iter().filter_map(|x| x.as_f64()).map(|x| x * x).sum::<f64>().sqrt())
                }
            };
            let expected = expected.expect("a number");
            assert!(
                (value - expected).abs() < 1e-6 * (1.0 + expected),
                "{quantity} {end}: {value} {expected}"
            );
        }
    }
    for (more, words) in [
        ("--quantity held:nothing", "--quantity"),
        ("--quantity weight", "bearing:JOINT"),
        ("--quantity held:shoulder --normals any", "effective masses only"),
    ] {
        let outcome = percuss(&format!("extremes {contact} --range elbow=20deg:160deg {more}"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{more}: {}", outcome.stderr);
    }
}

/// Towards the stretched arm along the normal the impulse in the shoulder has no bound, and at a bent pose the impulse is zero.
#[test]
fn an_unbounded_bearing_impulse_is_named() {
    let command = "extremes models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --normal-frame world \
                   --range shoulder=-180deg:180deg --range elbow=-20deg:160deg --quantity bearing:shoulder";
    let report = json(&format!("{command} --format json"));
    assert!(
        report["most"]["value"].is_null() && report["most"]["status"] == "immovable",
        "{}",
        report["most"]
    );
    assert_eq!(report["least"]["value"], 0.0);
    let text = percuss(command).stdout;
    assert!(
        text.contains("unbounded: it grows towards") && text.contains("smallest             0 kg"),
        "{text}"
    );
}

/// Only the joints with a range vary; the others are listed. A given position excludes a joint from the default ranges and contradicts a
/// range.
#[test]
fn extremes_list_the_held_joints() {
    let arm = "extremes models/six_r_arm.urdf --link tool --point 0,0,0 --normal 0,0,1 --starts 2";
    let one = json(&format!("{arm} --range shoulder=-1:1 --set elbow=0.5 --format json"));
    assert_eq!(one["ranges"].as_array().expect("ranges").len(), 1);
    let held = one["held"].as_array().expect("held joints");
    assert!(held.len() == 5 && held.contains(&serde_json::json!(["elbow", [0.5]])), "{held:?}");
    assert!(one["diagnostics"].as_array().expect("findings").is_empty());
    let all = json(&format!("{arm} --set elbow=0.5 --format json"));
    assert_eq!(all["ranges"].as_array().expect("ranges").len(), 5);
    assert_eq!(all["held"], serde_json::json!([["elbow", [0.5]]]));
    let text = percuss(&format!("{arm} --range shoulder=-1:1 --set elbow=0.5")).stdout;
    assert!(text.contains("held") && text.contains("elbow at 0.5"), "{text}");
    let both = percuss(&format!("{arm} --range elbow=-1:1 --set elbow=0.5"));
    assert!(both.code == 2 && both.stderr.contains("has a range and a given position"), "{}", both.stderr);
    let outside = percuss(&format!("{arm} --range shoulder=-10:10"));
    assert!(outside.code == 0 && outside.stderr.contains("leaves the limits -2 to 2"), "{}", outside.stderr);
}

/// Gap of a bump stop at the extremes: open at the drawn position of the arm, and the same as that of the table of contacts there.
#[test]
fn an_open_stop_is_marked() {
    let sheet = "extremes models/suspensions/double-wishbone.toml --at bump_stop --starts 2";
    let open = percuss(&format!("{sheet} --range upper_arm_hinge=-0.02:0.02"));
    assert!(
        open.code == 0 && open.stdout.matches("the stop is open").count() == 2,
        "{}{}",
        open.stdout,
        open.stderr
    );
    let report = json(&format!("{sheet} --range upper_arm_hinge=-0.02:0.02 --format json"));
    assert!(report["least"]["gap"].as_f64().expect("a gap") > 0.0, "{}", report["least"]);
    let plain = json(
        "extremes models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --range elbow=0.4:1 --format json",
    );
    assert!(plain["least"]["gap"].is_null());
}
