//! `percuss kinematics --compliance`: an independent program, reciprocity, the rigid limit.

use super::kinematics::{close, rows, value};
use crate::support::{Scratch, done, root, run_in};
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

/// Sheet with preloads of bushes beside that of the spring.
fn with_preloads() -> String {
    let text = with_bushes("left", Some(5000.0), 1.0);
    let lower = "preload = [\"300 N\", \"-2 kN\", \"150 N\"]\npreload_torque = [8, \"-15 N·m\", 30]\n";
    let text = text.replace("[bush.lower_front]\n", &format!("[bush.lower_front]\n{lower}"));
    text.replace("[bush.upper_back]\n", "[bush.upper_back]\npreload = [-500, 900, 400]\n")
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
            with_bushes("left", None, 1.0),
            [
                -8.071455582363953e-07,
                2.4283206366994455e-06,
                4.268800789400759e-07,
                6.914888688251684e-05,
                -4.691808717780049e-06,
            ],
        ),
        (
            with_bushes("left", Some(5000.0), 1.0),
            [
                -7.812318799095405e-07,
                2.3769345241302575e-06,
                4.2871327562307463e-07,
                6.865121747213125e-05,
                -4.6910439336077034e-06,
            ],
        ),
        (
            with_preloads(),
            [
                -7.807053115048067e-07,
                2.374338721089841e-06,
                4.287406185886627e-07,
                6.86140744365846e-05,
                -4.6910707906667225e-06,
            ],
        ),
    ];
    for (sheet, expected) in cases {
        folder.write("car.toml", &sheet);
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

/// With preloads of bushes and held wheels: values of the own program. The other side of the vehicle has the mirror image.
#[test]
fn preloads_act_on_held_wheels_and_on_both_sides() {
    let folder = Scratch::new("kinematics-preload");
    folder.write("car.toml", &with_preloads());
    let row = &rows(&folder, "car.toml", &["--compliance", "--travel-held"])[0];
    let expected = [
        ("toe_per_lateral_force", -7.290655252624142e-07),
        ("camber_per_braking_force", 2.4945898732153364e-07),
        ("wheel_centre_x_per_driving_force", 4.2869230040616404e-07),
        ("toe_per_aligning_torque", -4.688596322751872e-06),
    ];
    for (name, expected) in expected {
        assert!((value(row, name) / expected - 1.0).abs() < 1e-9, "{name}: {} {expected}", value(row, name));
    }
    folder.write("car.toml", &with_preloads().replace("build = \"left\"", "build = \"both\""));
    let row = &rows(&folder, "car.toml", &["--compliance"])[0];
    for name in ["toe_per_lateral_force", "camber_per_braking_force", "toe_per_aligning_torque"] {
        let [left, right] = ["left", "right"].map(|side| value(row, &format!("{name}_{side}")));
        assert!((left / right - 1.0).abs() < 1e-9, "{name}: {left} {right}");
    }
    // A preload in the direction of an ideal joint has no stiffness that carries it.
    let text = with_preloads().replace("torsional = \"60 N·m/rad\"", "torsional = \"0 N·m/rad\"");
    folder.write("car.toml", &text);
    let refused = run_in(&folder, &["kinematics", "car.toml", "--compliance"]);
    assert!(
        refused.code == 2 && refused.stderr.contains("a preload needs a finite stiffness"),
        "{}",
        refused.stderr
    );
}

/// Bushing file of Adams/Car: rates k (N/mm) and kt (N·mm/deg), as curves with a jump of the slope beyond ±2 mm.
fn bush_file(k: [f64; 3], kt: [f64; 3]) -> String {
    let mut text = "[MDI_HEADER]\n FILE_TYPE = 'bus'\n FILE_VERSION = 4.0\n(COMMENTS)\n{comment_string}\n'a test'\n[UNITS]\n LENGTH = 'mm'\n FORCE = 'newton'\n \
                    ANGLE = 'degrees'\n MASS = 'kg'\n TIME = 'second'\n[DAMPING]\n FX_DAMPING = 0.8\n FY_DAMPING = 0.8\n FZ_DAMPING = 0.2\n"
        .to_owned();
    for (axis, (k, kt)) in ["X", "Y", "Z"].into_iter().zip(k.into_iter().zip(kt)) {
        for (name, rate) in [("F", k), ("T", kt)] {
            writeln!(text, "[{name}{axis}_CURVE]\n{{ x f}}").expect("a string");
            for x in [-6.0, -4.0, -3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 4.0, 6.0_f64] {
                let beyond = (x.abs() - 3.0).max(0.0) * x.signum();
                writeln!(text, " {x} {}", rate * (x + 2.0 * beyond)).expect("a string");
            }
        }
    }
    text
}

/// A bushing file gives the same motions as its rates in the sheet; curves, preload, offsets and missing units.
#[test]
fn bushing_files_of_adams_are_rates() {
    let folder = Scratch::new("kinematics-bus");
    let rates = "radial = [\"9 kN/mm\", \"6 kN/mm\"]\naxial = \"1.1 kN/mm\"\nconical = [\"250 N·m/rad\", \"100 N·m/rad\"]\n\
                 torsional = \"60 N·m/rad\"\ndamping = [\"800 N·s/m\", \"800 N·s/m\", \"200 N·s/m\"]\nx_axis = [0, 0, 1]\n";
    let of_sheet = with_bushes("left", Some(5000.0), 1.0);
    let (head, rest) = of_sheet.split_once("[bush.lower_front]\n").expect("a bush");
    let rest = &rest[rest.find("[bush.lower_back]").expect("a bush")..];
    let sheet = |keys: &str| format!("{head}[bush.lower_front]\n{keys}\n{rest}");
    let degree = std::f64::consts::PI / 180.0 * 1e3;
    let text = bush_file([9000.0, 6000.0, 1100.0], [250.0 * degree, 100.0 * degree, 60.0 * degree]);
    let values = |keys: &str, file: &str| {
        folder.write("car.toml", &sheet(keys));
        folder.write("front.bus", file);
        rows(&folder, "car.toml", &["--compliance"])[0].clone()
    };
    let by_file = "file = \"front.bus\"\nx_axis = [0, 0, 1]\n";
    let compared = |expected: &Value, found: &Value, tolerance: f64| {
        let names = ["toe_per_lateral_force", "camber_per_braking_force", "toe_per_aligning_torque"];
        names.iter().all(|name| (value(found, name) / value(expected, name) - 1.0).abs() < tolerance)
    };
    let expected = values(rates, &text);
    assert!(compared(&expected, &values(by_file, &text), 1e-9));
    // In N and inches.
    let inches = text.replace("'mm'", "'inch'");
    assert!(!compared(&expected, &values(by_file, &inches), 1e-3));
    // A force at zero is a preload of the other sign, along the axis z of the hinge; here both are 500 N.
    let along = |length: f64| [-390.0, 10.0, 10.0].map(|x| x / length);
    let [x, y, z] = along(f64::hypot(f64::hypot(390.0, 10.0), 10.0)).map(|x| 500.0 * x);
    let preloaded = values(&format!("{rates}preload = [{x}, {y}, {z}]\n"), &text);
    let with_preload = text.replace("FZ_DAMPING = 0.2", "FZ_DAMPING = 0.2\n[PRELOAD]\n FZ_PRELOAD = 500");
    assert!(compared(&preloaded, &values(by_file, &with_preload), 1e-10));
    assert!(!compared(&expected, &preloaded, 1e-6));
    let message = |file: &str, keys: &str| values_or_error(&folder, &sheet(keys), file);
    let curved = text.replace(" 1 9000\n", " 1 15000\n");
    let (code, warned) = message(&curved, by_file);
    assert!(code == 0 && warned.contains("the curve FX is not linear"), "{code} {warned}");
    for (file, keys, expected) in [
        (
            text.replace("[DAMPING]", "[OFFSET]\n FX_OFFSET = 2\n[DAMPING]"),
            by_file,
            "FX_OFFSET = 2 is not read",
        ),
        (text.replace(" FORCE = 'newton'\n", ""), by_file, "no FORCE"),
        (text.replace("'newton'", "'stone'"), by_file, "FORCE = \"stone\"; expected one of"),
        (text.replace(" 1 9000\n", " 1 x\n"), by_file, "increasing deflections"),
        ("[MDI_HEADER]\n FILE_TYPE = 'bus'\n".to_owned(), by_file, "no bushing file"),
        (text.clone(), "file = \"front.bus\"\n", "x_axis = [x, y, z]"),
        (text.clone(), "file = \"front.bus\"\nx_axis = [0, 0, 1]\nradial = \"9 kN/mm\"\n", "delete radial"),
        (text.clone(), "file = \"none.bus\"\n", "none.bus"),
    ] {
        let (code, stderr) = message(&file, keys);
        assert!(code == 2 && stderr.contains(expected), "{expected}: {code} {stderr}");
    }
}

/// Exit code and messages of a sheet with a bushing file.
fn values_or_error(folder: &Scratch, sheet: &str, file: &str) -> (i32, String) {
    folder.write("car.toml", sheet);
    folder.write("front.bus", file);
    let found = run_in(folder, &["kinematics", "car.toml", "--compliance"]);
    (found.code, found.stderr)
}

/// A sheet as URDF+ keeps its bushes: the same free and rigid mass and residual stiffness.
#[test]
fn bushes_survive_in_a_urdf() {
    let folder = Scratch::new("compliance-urdf");
    folder.write("car.toml", &with_preloads());
    done(&folder, &["import", "car.toml", "-o", "car.urdf"]);
    let of = |file: &str| -> Value {
        let words = ["mass", file, "--at", "bump_stop", "--stiffness", "200N/mm", "--format", "json"];
        serde_json::from_str(&done(&folder, &words)).expect("JSON")
    };
    let [sheet, urdf] = ["car.toml", "car.urdf"].map(of);
    let ratio = |name: &str| value(&urdf["compliance"], name) / value(&sheet["compliance"], name);
    // Rotations are rounded as angles.
    close(ratio("free_mass"), 1.0, 1e-9, "free_mass");
    // In a URDF the torsion of the bushes carries the preloads in the place of the load of the tyre: another geometric stiffness.
    close(ratio("residual_compliance"), 1.0, 2e-3, "residual_compliance");
    let text = std::fs::read_to_string(folder.path("car.urdf")).expect("a URDF");
    assert!(text.contains("<preload ") && text.contains("<bushing name=\"lower_front\""), "{text}");
    // An elastic gear needs a rotor.
    folder.write("car.urdf", &text.replace("</robot>", "<elastic joint=\"spin\" stiffness=\"9\"/></robot>"));
    let found = run_in(&folder, &["mass", "car.urdf", "--at", "bump_stop"]);
    assert!(found.code == 2 && found.stderr.contains("rotor (armature)"), "{}", found.stderr);
    folder.write("car.urdf", &text.replace("<stiffness ", "<stiff "));
    let found = run_in(&folder, &["mass", "car.urdf", "--at", "bump_stop"]);
    assert!(found.code == 2 && found.stderr.contains("<bushing> has no <stiffness"), "{}", found.stderr);
}

/// Bushes a million times as stiff leave the impact of the rigid mass, and the steps stay bounded.
#[test]
fn stiff_bushes_leave_the_rigid_impact() {
    let folder = Scratch::new("compliance-stiff");
    let text = with_bushes("left", None, 1e6).replace("[tyre]\nvertical = \"210 N/mm\"\n", "");
    folder.write("car.toml", &text.replace("rate = \"42 N/mm\"\n", ""));
    let words = [
        "impact",
        "car.toml",
        "--at",
        "bump_stop",
        "--speed",
        "1",
        "--stiffness",
        "200N/mm",
        "--restitution",
        "1",
    ];
    let flags = ["--in-time", "--compliance", "--format", "json"];
    let report: Value = serde_json::from_str(&done(&folder, &[&words[..], &flags].concat())).expect("JSON");
    let found = &report["in_time"]["compliant"];
    // P = (1 + e) m̄ v.
    let mass = value(&report, "impulse") / 2.0;
    let expected = [
        ("peak_force", (200e3 * mass).sqrt()),
        ("duration", std::f64::consts::PI * (mass / 200e3).sqrt()),
        ("impulse_mass", mass),
        ("restitution", 1.0),
    ];
    for (name, expected) in expected {
        // The vibration of the free mass has the part k m̄/(k_bush m_free) of the speed: 200 N/mm, 37 MN/mm, 151 kg and 6.3 kg give 1.3e-7.
        assert!(
            (value(found, name) / expected - 1.0).abs() < 1e-6,
            "{name}: {} {expected}",
            value(found, name)
        );
    }
    // The forces of the ideal joints are those of the rigid impact.
    let reactions = report["reactions"].as_array().expect("reactions");
    for name in ["lower_ball", "upper_ball", "tie_rod_ball", "spin"] {
        let named = |one: &&Value| one["name"] == name || one["element"] == name;
        let rigid = reactions.iter().find(named).unwrap_or_else(|| panic!("{name}"))["peak_force"].as_array();
        let squares = rigid.expect("a force").iter().map(|part| part.as_f64().expect("a number").powi(2));
        let elements = found["elements"].as_array().expect("elements");
        let elastic = value(elements.iter().find(named).unwrap_or_else(|| panic!("{name}")), "peak_force");
        let rigid = squares.sum::<f64>().sqrt();
        // The slope of the contact force excites the free mass: a part √(k m̄/(k_bush m_free)), 3.6e-4, of the force.
        assert!((elastic / rigid - 1.0).abs() < 4e-4, "{name}: {elastic}, rigid {rigid}");
    }
    let bush =
        found["elements"].as_array().expect("elements").iter().find(|one| one["element"] == "lower_front");
    let bearing = value(bush.expect("a bush"), "peak_force");
    assert!(bearing > 100.0 && bearing < value(found, "peak_force"), "{bearing}");
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

/// Values of Project Chrono's data/vehicle/hmmwv/suspension/HMMWV_DoubleWishboneFront_bushings.json (BSD-3-Clause), with a tie rod of 6 kg.
const HMMWV: &str = r#"{"Name": "HMMWV", "Type": "Suspension", "Template": "DoubleWishbone",
  "Spindle": {"Mass": 14.705, "COM": [-0.040, 0.910, -0.026], "Inertia": [0.04117, 0.07352, 0.04117]},
  "Upright": {"Mass": 19.450, "COM": [-0.040, 0.751, -0.026], "Moments of Inertia": [0.1656, 0.1934, 0.04367], "Products of Inertia": [0, 0, 0]},
  "Upper Control Arm": {"Mass": 5.813, "COM": [-0.106, 0.589, 0.218], "Moments of Inertia": [0.03, 0.03, 0.06276], "Products of Inertia": [0, 0, 0],
    "Location Upright": [-0.053, 0.716, 0.215], "Location Chassis Front": [-0.048, 0.446, 0.245], "Location Chassis Back": [-0.268, 0.478, 0.196],
    "Bushing Data": BUSHING},
  "Lower Control Arm": {"Mass": 23.965, "COM": [0.000, 0.547, -0.059], "Moments of Inertia": [0.4, 0.4, 0.8938], "Products of Inertia": [0, 0, 0],
    "Location Upright": [-0.036, 0.787, -0.118], "Location Chassis Front": [0.223, 0.307, 0.000], "Location Chassis Back": [-0.223, 0.307, 0.000],
    "Bushing Data": BUSHING},
  "Tierod": {"Mass": 6.0, "Inertia": [0.05, 0.05, 0.5], "Location Chassis": [-0.250, 0.448, 0.054], "Location Upright": [-0.176, 0.821, -0.016]},
  "Spring": {"Location Chassis": [0.104, 0.510, 0.197], "Location Arm": [0.097, 0.543, -0.047]},
  "Shock": {"Location Chassis": [0.104, 0.498, 0.323], "Location Arm": [0.097, 0.543, -0.047]},
  "Axle": {"Inertia": 0.4}}"#;

/// Bushes of a file of Chrono::Vehicle end to end, against an independent program: rigid mass, masses of impulse and peak force over the stiffness
/// of the contact.
#[test]
fn bushings_of_chrono_have_the_reference_masses() {
    let folder = Scratch::new("compliance-hmmwv");
    let bushing = r#"{"Stiffness Linear": 7e7, "Damping Linear": 3.5e4, "Stiffness Rotational": 1e5, "Damping Rotational": 500,
      "DOF": {"Stiffness Linear": 0, "Damping Linear": 0, "Stiffness Rotational": 0, "Damping Rotational": 0}}"#;
    folder.write("hmmwv.json", &HMMWV.replace("BUSHING", bushing));
    for (stiffness, impulse_mass, force) in [
        ("50N/mm", 215.5, 0.996),
        ("200N/mm", 217.7, 0.983),
        ("1000N/mm", 228.7, 0.918),
        ("10000N/mm", 261.0, 0.637),
    ] {
        let words = ["mass", "hmmwv.json", "--at", "spring", "--stiffness", stiffness, "--format", "json"];
        let found = run_in(&folder, &words);
        let report: Value = serde_json::from_str(&found.stdout).expect("JSON");
        let mass = value(&report, "effective_mass");
        assert!((mass / 214.693_424_736_646_25 - 1.0).abs() < 1e-12, "{mass}");
        let impact = &report["compliance"]["contact"]["impact"];
        let ratio = (value(impact, "force_mass") / mass).sqrt();
        // The reference has four and three digits.
        let reached = value(impact, "impulse_mass");
        assert!(
            (reached / impulse_mass - 1.0).abs() < 2e-3 && (ratio - force).abs() < 6e-4,
            "{reached} {ratio}"
        );
    }
}
