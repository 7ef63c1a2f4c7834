//! Masses by the state of rotors and joints, and peak forces with friction: `percuss impact`.

use crate::support::{json, percuss};
use serde_json::Value;

const FOUR_BAR: &str =
    "impact models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 --restitution 0.3";

fn close(value: &Value, expected: f64) {
    let got = value.as_f64().unwrap_or_else(|| panic!("{value} is no number; expected {expected}"));
    // Rounding of a few operations.
    assert!((got - expected).abs() < 1e-12 * expected.abs().max(1.0), "{got} {expected}");
}

/// With friction the peak force is that of a frictionless contact of the mass m̄/(1+µt), and differs in the bearings.
#[test]
fn peak_forces_include_the_friction() {
    let smooth = json(&format!("{FOUR_BAR} --speed 2 --stiffness 200N/mm --format json"));
    let rough = json(&format!("{FOUR_BAR} --speed 2 --stiffness 200N/mm --friction 0.2 --format json"));
    let slope = rough["friction"]["slope"].as_f64().expect("a slope");
    let mass = rough["mass"]["effective_mass"].as_f64().expect("a mass") / (1.0 + 0.2 * slope);
    close(&rough["contact_law"]["mass_in_compression"], mass);
    assert_eq!(rough["contact_law"]["direction_changes"], false);
    let damp = format!("damp --mass {mass} --restitution 0.3 --speed 2 --stiffness 200N/mm --format json");
    close(&rough["contact_law"]["peak_force"], json(&damp)["peak_force"].as_f64().expect("a force"));
    let bearing = |report: &Value| {
        let reactions = report["reactions"].as_array().expect("reactions");
        reactions.iter().find(|r| r["name"] == "rocker_hinge").expect("the hinge")["peak_force"].clone()
    };
    assert!(bearing(&rough)[0].is_number() && bearing(&rough)[2].is_null());
    assert_ne!(bearing(&rough)[0], bearing(&smooth)[0]);
    assert!(smooth["contact_law"]["mass_in_compression"].is_null());
    let codes = rough["diagnostics"].to_string();
    assert!(!codes.contains("without-friction"), "{codes}");
    let text = percuss(&format!("{FOUR_BAR} --speed 2 --stiffness 200N/mm --friction 0.2")).stdout;
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words.contains("(same work of compression)") && words.contains("peak N"), "{text}");
}

/// Masses with rotors decoupled and coupled, and of the locked body, for a sliding and a sticking point.
#[test]
fn masses_are_compared_by_the_state_of_rotors_and_joints() {
    let arm = "models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --set elbow=40deg";
    let impact =
        |flags: &str| json(&format!("impact {arm} {flags} --restitution 0.1 --speed 1 --format json"));
    let report = impact("");
    let states = report["mass_states"].as_array().expect("states");
    let value = |k: usize, key: &str| states[k][key].as_f64().expect("a mass");
    close(&states[1]["sliding"], report["mass"]["effective_mass"].as_f64().expect("a mass"));
    close(&states[1]["sticking"], report["sticking_mass"].as_f64().expect("a mass"));
    let decoupled = impact("--armature shoulder=0 --armature elbow=0");
    close(&states[0]["sliding"], decoupled["mass"]["effective_mass"].as_f64().expect("a mass"));
    close(&states[0]["sticking"], decoupled["sticking_mass"].as_f64().expect("a mass"));
    for k in 0..3 {
        assert!(value(k, "sticking") >= value(k, "sliding"), "{report}");
    }
    assert!(value(0, "sliding") <= value(1, "sliding"));
    let text = percuss(&format!("impact {arm} --restitution 0.1 --speed 1")).stdout;
    assert!(text.contains("rotors decoupled") && text.contains("joints locked"), "{text}");
}

/// The normal is perpendicular to the rod, and the point moves along it: nothing slides, whatever the angle.
#[test]
fn a_point_that_does_not_slide_has_no_friction() {
    for degrees in 0..90 {
        let pendulum = format!(
            "models/physical_pendulum.urdf --link body --point 0,0,-0.5 --normal 1,0,0 --set hinge={degrees}deg"
        );
        let line = format!("impact {pendulum} --friction 0.3 --restitution 0.5 --speed 1 --format json");
        let friction = &json(&line)["friction"];
        assert_eq!(
            friction["tangential_impulse_world"],
            serde_json::json!([0.0, 0.0, 0.0]),
            "{degrees}: {friction}"
        );
        let line = format!("mass {pendulum} --friction-thresholds --format json");
        let thresholds = &json(&line)["friction_thresholds"];
        assert!(thresholds["jamming"].is_null(), "{degrees}: {thresholds}");
    }
}
