//! `percuss export`. The files run in MuJoCo in tests/external/impact_models.py.

use crate::support::{Scratch, percuss};
use std::f64::consts::PI;

const IMPACT: &str = "--link coupler --point 0.2,0,0 --normal 1,0.3,0 --set crank_hinge=60deg --restitution 0.3 --stiffness 1e6";

/// Half of the difference of two angles of the crank, rad, and the error of rates from their difference: a few times its square.
const STEP: f64 = 1e-4;
const DIFFERENCE_ERROR: f64 = 1e-6;
/// Roundings of angles.
const ROUNDING: f64 = 1e-14;

/// Report of the contact of the coupler at an angle of the crank, rad.
fn report(angle: f64) -> serde_json::Value {
    let contact = "--link coupler --point 0.2,0,0 --normal 1,0.3,0";
    let outcome =
        percuss(&format!("mass models/four_bar.urdf {contact} --set crank_hinge={angle:?} --format json"));
    serde_json::from_str(&outcome.stdout).expect("a report")
}

/// Number of a report.
fn number(report: &serde_json::Value, key: &str) -> f64 {
    report.pointer(key).and_then(serde_json::Value::as_f64).expect("a number")
}

/// Numbers of an attribute of the only element that has it.
fn numbers(text: &str, attribute: &str) -> Vec<f64> {
    let (_, rest) = text.split_once(&format!(" {attribute}=\"")).expect("the attribute");
    rest.split('"').next().unwrap_or_default().split(' ').map(|x| x.parse().expect("a number")).collect()
}

#[test]
fn the_keyframe_has_the_pose_and_the_velocity_of_the_contact() {
    let folder = Scratch::new("export");
    let file = folder.path("impact.xml");
    let outcome = percuss(&format!("export models/four_bar.urdf {IMPACT} --speed 0.02 -o {file}"));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let text = std::fs::read_to_string(&file).expect("the file");
    // Differences of two poses on both sides of the pose of the contact.
    let [before, middle, after] = [PI / 3.0 - STEP, PI / 3.0, PI / 3.0 + STEP].map(report);
    let (qpos, qvel) = (numbers(&text, "qpos"), numbers(&text, "qvel"));
    let turned = number(&after, "/pose/crank_hinge/0") - number(&before, "/pose/crank_hinge/0");
    for (index, joint) in ["crank_hinge", "crank_pin", "rocker_hinge"].into_iter().enumerate() {
        let key = format!("/pose/{joint}/0");
        assert!((qpos[index] - number(&middle, &key)).abs() < ROUNDING, "{joint}");
        let rate = (number(&after, &key) - number(&before, &key)) / turned;
        assert!((qvel[index] / qvel[0] - rate).abs() < DIFFERENCE_ERROR, "{joint}: {} {rate}", qvel[index]);
    }
    let along = |axis: usize| {
        let key = format!("/contact/point_world/{axis}");
        let normal = number(&middle, &format!("/contact/normal_world/{axis}"));
        (number(&after, &key) - number(&before, &key)) / turned * normal
    };
    let closing_speed = (0..3).map(along).sum::<f64>() * qvel[0];
    assert!((closing_speed / 0.02 - 1.0).abs() < DIFFERENCE_ERROR, "{closing_speed}");
    // The model is read again, and both files are replaced without --force.
    assert_eq!(percuss(&format!("check {file}")).code, 0);
    assert_eq!(percuss(&format!("export models/four_bar.urdf {IMPACT} -o {file}")).code, 0);
    std::fs::write(folder.path("impact.py"), "print()\n").expect("a file");
    let outcome = percuss(&format!("export models/four_bar.urdf {IMPACT} -o {file}"));
    assert_eq!(outcome.code, 2);
    assert!(outcome.stderr.contains("impact.py"), "{}", outcome.stderr);
}

/// A body of 2 kg and the moments (0.02, 0.03, 0.04) kg·m² that floats: the keyframe has its free joint at the velocity of the impact, and a
/// link of the name of the ground is refused.
#[test]
fn floating_bases_get_a_free_joint() {
    let folder = Scratch::new("export-floating");
    let file = folder.path("impact.xml");
    let contact =
        "--link body --point 0.3,0,0 --normal 0,0,-1 --restitution 0.3 --stiffness 1e6 --speed 0.02";
    let outcome = percuss(&format!("export models/floating_body.urdf --base floating {contact} -o {file}"));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let text = std::fs::read_to_string(&file).expect("the file");
    assert!(text.contains("<freejoint name=\"body_floating\"/>"), "{text}");
    let mass = percuss(
        "mass models/floating_body.urdf --base floating --link body --point 0.3,0,0 --normal 0,0,-1 --format json",
    );
    let report: serde_json::Value = serde_json::from_str(&mass.stdout).expect("a report");
    let qvel = numbers(&text, "qvel");
    // Closing speed along −z at (0.3, 0, 0): −v_z + 0.3 ω_y.
    assert!((0.3 * qvel[4] - qvel[2] - 0.02).abs() < ROUNDING, "{qvel:?}");
    // The impulse m̄ v through the contact point: v_z = −m̄ v / m.
    let body = number(&report, "/effective_mass") * 0.02 / -qvel[2];
    let check = percuss("check models/floating_body.urdf --format json");
    let check: serde_json::Value = serde_json::from_str(&check.stdout).expect("a report");
    assert!((body / number(&check, "/total_mass") - 1.0).abs() < ROUNDING, "{body}");
}

/// Near a dead centre m̄ changes over the penetration: a warning states the restitution that constant parameters reach, and the bound of the
/// report contains it. A slow impact on a stiff contact has none.
#[test]
fn a_restitution_that_is_not_reached_is_reported() {
    let folder = Scratch::new("export-shift");
    let file = folder.path("impact.xml");
    let report = |flags: &str| {
        let contact = "--link coupler --point 0.36,-0.15,0 --normal 0,1,0 --restitution 0.3";
        let outcome = percuss(&format!(
            "export models/antiparallelogram.urdf {contact} {flags} --format json --force -o {file}"
        ));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        let report: serde_json::Value = serde_json::from_str(&outcome.stdout).expect("a report");
        let codes = report["diagnostics"].to_string();
        (report, codes.contains("restitution-not-reached"))
    };
    let (slow, is_warned) = report("--stiffness 400N/mm --speed 1mm/s");
    assert!(!is_warned && number(&slow, "/error_bound") <= 1.01e-3, "{slow}");
    let (fast, is_warned) = report("--stiffness 400N/mm --speed 1m/s");
    let shift = number(&fast, "/predicted_restitution") - 0.3;
    assert!(is_warned && shift.abs() > 1e-3 && number(&fast, "/error_bound") > shift.abs(), "{fast}");
}
