//! At a change point: the limits of m̄ along the branches, by closed forms; and what else is told about the loops there.

mod support;

use serde_json::Value;
use support::{Scratch, json, percuss};

/// A link of a parallelogram: kg, centre of mass on x, moment of inertia.
fn link(name: &str, mass: f64, x: f64, inertia: f64) -> String {
    format!(
        "<link name=\"{name}\"><inertial><origin xyz=\"{x} 0 0\"/><mass value=\"{mass}\"/>\
         <inertia ixx=\"{inertia}\" iyy=\"{inertia}\" izz=\"{inertia}\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\n"
    )
}

fn hinge(name: &str, parent: &str, child: &str, x: f64) -> String {
    format!(
        "<joint name=\"{name}\" type=\"continuous\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
         <origin xyz=\"{x} 0 0\"/><axis xyz=\"0 0 1\"/></joint>\n"
    )
}

/// A parallelogram folded flat along x with its joints at 0, on a carrier: cranks 0.5 m, coupler 1 m. With the cranks
/// at rate ω: each crank has I_O = 0.01 + 3·0.1² = 0.04 kg·m², the coupler's points move at 0.5 ω.
fn parallelogram(carrier: &str, prefix: &str, successor: &str) -> String {
    let [crank, coupler, rocker] = ["crank", "coupler", "rocker"].map(|part| format!("{prefix}_{part}"));
    link(&crank, 3.0, 0.1, 0.01)
        + &link(&coupler, 2.0, 0.2, 0.03)
        + &link(&rocker, 3.0, 0.1, 0.01)
        + &hinge(&format!("{prefix}1"), carrier, &crank, 0.0)
        + &hinge(&format!("{prefix}2"), &crank, &coupler, 0.5)
        + &hinge(&format!("{prefix}3"), carrier, &rocker, 1.0)
        + &format!(
            "<loop name=\"{prefix}_pin\" type=\"revolute\"><predecessor link=\"{coupler}\"><origin xyz=\"1 0 0\"/>\
             </predecessor><successor link=\"{rocker}\"><origin {successor}/></successor><axis xyz=\"0 0 1\"/></loop>\n"
        )
}

const STRAIGHT: &str = "xyz=\"0.5 0 0\"";

fn robot(scratch: &Scratch, name: &str, parts: &[String]) -> String {
    scratch.write(name, &format!("<robot name=\"r\"><link name=\"ground\"/>\n{}</robot>", parts.concat()))
}

fn limits(report: &Value) -> Vec<Option<f64>> {
    report["branch_limits"].as_array().expect("a list").iter().map(Value::as_f64).collect()
}

/// 1/m̄ is carried on over eight places up to 4 % of the size away: some 1e-10 remain.
#[track_caller]
fn assert_one_is(limits: &[Option<f64>], expected: f64) {
    assert!(limits.iter().flatten().any(|m| (m / expected - 1.0).abs() < 1e-8), "{expected} in {limits:?}");
}

#[test]
fn a_platform_on_three_cranks_has_one_branch() {
    let folded = "mass models/parallelogram.urdf --link platform --point 0.3,0.1,0 --set first_hinge=-90deg --format json";
    // The platform does not turn: 6 + 3·0.08/0.4² kg across the cranks, nothing along them.
    let across = json(&format!("{folded} --normal 0,1,0"));
    assert_eq!(across["singular_pose"], true);
    assert_eq!(limits(&across).len(), 1);
    assert_one_is(&limits(&across), 7.5);
    assert_eq!(limits(&json(&format!("{folded} --normal 1,0,0"))), [None]);
}

#[test]
fn groups_at_crossings_of_their_own_are_taken_together() {
    let scratch = Scratch::new("crossings-two");
    let model = robot(
        &scratch,
        "two.urdf",
        &[parallelogram("ground", "a", STRAIGHT), parallelogram("a_coupler", "b", STRAIGHT)],
    );
    let report =
        json(&format!("mass {model} --link a_coupler --point 0.1,0.05,0 --normal 0,1,0 --format json"));
    assert_eq!(
        (&report["degrees_of_freedom"], &report["generic_degrees_of_freedom"]),
        (&4.into(), &2.into())
    );
    assert_eq!(limits(&report).len(), 4);
    // Both as parallelograms, the first coupler at 1 m/s (ω_a = 2), least over w = ω_b:
    // (0.08 + 0.5)·4 + 6 (1 + 0.1 w)² + 0.02 w² + 2 (1 + 0.5 w)².
    assert_one_is(&limits(&report), 2.32 + 8.0 - 3.2 * 3.2 / (4.0 * 0.58));
}

#[test]
fn a_branch_with_more_freedoms_is_one_branch() {
    let scratch = Scratch::new("crossings-spin");
    // The loop is closed by a ball: the coupler's pin to the crank is a ball too, so that it can roll about its length.
    let text = parallelogram("ground", "a", STRAIGHT)
        .replace("name=\"a2\" type=\"continuous\"", "name=\"a2\" type=\"spherical\"")
        .replace("type=\"revolute\"", "type=\"spherical\"");
    let model = robot(&scratch, "spin.urdf", &[text]);
    let report = json(&format!("mass {model} --link a_coupler --point 0.1,0,0 --normal 0,1,0 --format json"));
    assert_eq!(
        (&report["degrees_of_freedom"], &report["generic_degrees_of_freedom"]),
        (&3.into(), &2.into())
    );
    assert_eq!(limits(&report).len(), 2, "{:?}", limits(&report));
    assert_one_is(&limits(&report), 2.32);
}

#[test]
fn axes_may_point_opposite_ways() {
    let scratch = Scratch::new("crossings-reversed");
    let turned = "xyz=\"0.5 0 0\" rpy=\"3.141592653589793 0 0\"";
    let [straight, reversed] = [STRAIGHT, turned].map(|frame| {
        let model = robot(&scratch, "model.urdf", &[parallelogram("ground", "a", frame)]);
        json(&format!(
            "mass {model} --link a_coupler --point 0.1,0,0 --normal 0,1,0 --set a1=0.7 --format json"
        ))
    });
    let mass = |report: &Value| report["effective_mass"].as_f64().expect("a mass");
    assert!((mass(&straight) / mass(&reversed) - 1.0).abs() < 1e-12);
    let codes = |report: &Value| -> Vec<String> {
        let all = report["diagnostics"].as_array().expect("a list");
        all.iter().map(|d| d["code"].as_str().unwrap_or_default().to_owned()).collect()
    };
    assert!(codes(&reversed).contains(&"reversed-axis".to_owned()));
    assert!(!codes(&straight).contains(&"reversed-axis".to_owned()));
}

#[test]
fn held_contacts_are_judged_beside_the_zero_pose() {
    // Stretched out, nothing of the arm moves along x; bent, it does: a held x takes one freedom and is not redundant.
    let held = "mass models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --hold outer:0.4,0,0:1,0,0 --format json";
    let bent = json(&format!("{held} --set elbow=90deg"));
    for (key, expected) in
        [("degrees_of_freedom", 1), ("generic_degrees_of_freedom", 1), ("redundant_constraints", 0)]
    {
        assert_eq!(bent[key], expected, "{key}");
    }
    let stretched = json(held);
    assert_eq!((&stretched["degrees_of_freedom"], &stretched["singular_pose"]), (&2.into(), &true.into()));
    // Held in all directions, z adds nothing to a planar arm: named.
    let all = json(&held.replace(":1,0,0", ""));
    assert_eq!(all["redundant_loops"], serde_json::json!([["hold of outer"]]));
    assert_eq!(all["redundant_constraints"], 1);
}

#[test]
fn separable_loops_are_named_apart() {
    let check = json("check models/six_bar.urdf --format json");
    assert_eq!(check["redundant_loops"], serde_json::json!([["rocker_pin"], ["output_pin"]]));
    let check = json("check models/parallelogram.urdf --format json");
    assert_eq!(check["redundant_loops"], serde_json::json!([["second_pin", "third_pin"]]));
}

#[test]
fn a_drive_of_very_many_turns_says_how_far_it_came() {
    let outcome = percuss(
        "mass models/four_bar.urdf --link coupler --point 0.1,0,0 --normal 0,1,0 --set crank_hinge=1e6",
    );
    assert_eq!(outcome.code, 1);
    for word in ["crank_hinge = 1000000", "too far", "still closed at", "whole turns"] {
        assert!(outcome.stderr.contains(word), "{word}: {}", outcome.stderr);
    }
}
