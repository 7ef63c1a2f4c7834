//! `percuss kinematics --compliance`: an independent program, reciprocity, the rigid limit.

use super::kinematics::{close, rows, value};
use crate::support::{Scratch, done, root};
use serde_json::Value;
use std::fmt::Write;

/// Sheet with bushes and a spring of 42 N/mm; `preload`: its force at the design position, N.
fn with_bushes(build: &str, preload: Option<f64>, stiffer: f64) -> String {
    let text = std::fs::read_to_string(root().join("models/suspensions/double-wishbone-bushes.toml"));
    let preload = preload.map_or_else(String::new, |force| format!("preload = \"{force} N\"\n"));
    let text = text.expect("a shipped sheet");
    let spring = format!("[spring]\nrate = \"42 N/mm\"\n{preload}");
    let text =
        text.replace("[spring]\n", &spring).replace("build = \"left\"", &format!("build = \"{build}\""));
    let mut changed = String::new();
    for line in text.lines() {
        let (key, rest) = line.split_once(" = ").unwrap_or((line, ""));
        let number = || rest.trim_matches('"').split(' ').next().and_then(|word| word.parse::<f64>().ok());
        match (key, number()) {
            ("radial" | "axial", Some(k)) => writeln!(changed, "{key} = \"{} kN/mm\"", k * stiffer),
            ("torsional" | "conical", Some(_)) if stiffer > 1.0 => Ok(()),
            _ => writeln!(changed, "{line}"),
        }
        .expect("a string");
    }
    changed
}

/// Values of an own program: four rigid bodies in maximal coordinates with finite rotations, energies of the bushes in axes of their links, second
/// derivatives of the Lagrange function by automatic differentiation.
#[test]
fn compliance_equals_an_independent_program() {
    let folder = Scratch::new("kinematics-compliance");
    let names = [
        "toe_per_lateral_force",
        "camber_per_braking_force",
        "wheel_centre_x_per_driving_force",
        "wheel_centre_z_per_vertical_force",
        "toe_per_aligning_torque",
    ];
    let cases = [
        (
            None,
            [
                -8.071455582363953e-07,
                2.4283206366994455e-06,
                4.268800789400759e-07,
                6.914888688251684e-05,
                -4.691808717780049e-06,
            ],
        ),
        (
            Some(5000.0),
            [
                -7.812318799095405e-07,
                2.3769345241302575e-06,
                4.2871327562307463e-07,
                6.865121747213125e-05,
                -4.6910439336077034e-06,
            ],
        ),
    ];
    for (preload, expected) in cases {
        folder.write("car.toml", &with_bushes("left", preload, 1.0));
        let row = &rows(&folder, "car.toml", &["--compliance"])[0];
        for (name, expected) in names.into_iter().zip(expected) {
            // Condition of the stiffness, 1e5, and the rounding of both programs.
            assert!(
                (value(row, name) / expected - 1.0).abs() < 1e-10,
                "{name}: {} {expected}",
                value(row, name)
            );
        }
    }
}

/// Stiff bushes leave the wheel rate of the rigid linkage; the loads and displacements of two points are reciprocal; on two equal sides the
/// sum of single loads is the parallel or opposed one.
#[test]
fn compliance_is_reciprocal_and_has_the_rigid_limit() {
    let folder = Scratch::new("kinematics-reciprocal");
    folder.write("car.toml", &with_bushes("left", None, 1e5));
    let row = &rows(&folder, "car.toml", &["--compliance"])[0];
    let vertical = value(row, "wheel_centre_z_per_vertical_force");
    // The bushes are 1e5 times as stiff: a part of 1e-5 of the spring's travel, times their number and leverage.
    close(1.0 / vertical / value(row, "wheel_rate"), 1.0, 1e-6, "wheel rate");
    folder.write("car.toml", &with_bushes("both", Some(5000.0), 1.0));
    let [single, parallel, opposed] = ["single", "parallel", "opposed"]
        .map(|wheels| rows(&folder, "car.toml", &["--compliance", wheels])[0].clone());
    let braked = value(&single, "contact_patch_y_per_braking_force_left");
    close(
        -value(&single, "contact_patch_x_per_lateral_force_left") * 1e6,
        braked * 1e6,
        1e-9,
        "no reciprocity",
    );
    for name in ["toe", "camber", "wheel_centre_y", "contact_patch_y"] {
        let of = |row: &Value| value(row, &format!("{name}_per_lateral_force_left")) * 1e6;
        // The sides are coupled by nothing in this sheet.
        close(of(&parallel), of(&single), 1e-8, name);
        close(of(&opposed), of(&single), 1e-8, name);
    }
    let held = &rows(&folder, "car.toml", &["--compliance", "--travel-held"])[0];
    assert!(value(held, "wheel_centre_z_per_lateral_force_left").abs() < 1e-15);
    assert!(held["toe_per_vertical_force_left"].is_null());
}

/// The gradient of a motion ratio is the difference of motion ratios over the travel.
#[test]
fn ratio_gradients_are_differences() {
    let folder = Scratch::new("kinematics-ratio-gradient");
    folder.write("car.toml", &with_bushes("left", None, 1.0));
    let found = rows(&folder, "car.toml", &["--wheel-travel", "-1mm:1mm:3"]);
    for name in ["spring", "damper", "bump_stop", "rebound_stop"] {
        let ratio = |row: usize| value(&found[row], &format!("motion_ratio_{name}"));
        let difference = (ratio(2) - ratio(0)) / 2e-3;
        // Central difference over 1 mm: the third derivative of the ratio is at most 10/m³.
        close(value(&found[1], &format!("ratio_gradient_{name}")), difference, 1e-5, name);
    }
    // A second run knows the table by its columns and replaces it.
    for _ in 0..2 {
        done(&folder, &["kinematics", "car.toml", "--compliance", "-o", "travel.csv"]);
    }
}

/// A bush at the end of a rod frees the spin that the rigid joint holds. Without a torsional stiffness the rigid mass is not the limit of soft
/// contacts, and the verdict is withheld with a warning; with it, the torsional row counts in the residual stiffness.
#[test]
fn the_spin_of_a_rod_is_judged_by_its_bush() {
    let folder = Scratch::new("compliance-spin");
    let text = done(&folder, &["template", "multi-link"]);
    let report = |rates: &str| -> Value {
        let bush = "[bush.trailing_link_chassis]\nradial = \"5 kN/mm\"\naxial = \"5 kN/mm\"";
        folder.write("car.toml", &format!("{text}\n{bush}\n{rates}"));
        let words = ["mass", "car.toml", "--at", "bump_stop", "--stiffness", "200N/mm", "--format", "json"];
        serde_json::from_str(&done(&folder, &words)).expect("JSON")
    };
    let warned = |report: &Value| {
        let found = report["diagnostics"].as_array().expect("findings");
        found.iter().any(|finding| finding["code"] == "no-compliance")
    };
    let free = report("conical = \"200 N·m/rad\"\n");
    assert!(warned(&free) && free["compliance"]["rigid_up_to"].is_null(), "{}", free["compliance"]);
    let held = report("torsional = \"60 N·m/rad\"\nconical = \"200 N·m/rad\"\n");
    assert!(!warned(&held), "{}", held["diagnostics"]);
    assert_eq!(held["compliance"]["rows"][0]["direction"], "torsional");
}
