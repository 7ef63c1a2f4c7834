//! `percuss mass` and `percuss check`: output that scripts rely on, and messages for mistakes.

use crate::support::{Scratch, command, json, percuss, percuss_with_stdin, root};

const PENDULUM: &str = "mass models/point_mass_pendulum.urdf --link rod --point 0,0,-0.8 --normal 1,0,0";
const ARM: &str = "mass models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 0,0,-1";

/// Effective mass of a command.
fn kilograms(line: &str) -> f64 {
    json(&format!("{line} --format json"))["effective_mass"].as_f64().expect("a finite mass")
}

#[test]
fn mass_json_has_all_its_keys_always() {
    let keys = [
        "schema",
        "percuss",
        "inputs",
        "effective_mass",
        "status",
        "singular_pose",
        "degrees_of_freedom",
        "generic_degrees_of_freedom",
        "redundant_constraints",
        "rank_gap",
        "route",
        "condition",
        "effective_mass_error",
        "bodies",
        "rotors",
        "pose",
        "closure_residual",
        "closure_inexactness",
        "characteristic_length",
        "contact",
        "diagnostics",
    ];
    let immovable = PENDULUM.replace("1,0,0", "0,1,0");
    let massless = "mass - --link tip --point 1,0,0 --normal 0,1,0";
    let massless = percuss_with_stdin(&format!("{massless} --format json"), MASSLESS_TIP.as_bytes());
    assert_eq!(massless.code, 0, "{}", massless.stderr);
    let massless: serde_json::Value = serde_json::from_str(&massless.stdout).expect("JSON");
    let finite = json(&format!("{PENDULUM} --format json"));
    let immovable = json(&format!("{immovable} --format json"));
    for (report, status) in [(&finite, "finite"), (&immovable, "immovable"), (&massless, "massless")] {
        for key in keys {
            assert!(report.get(key).is_some(), "{status} lacks {key}");
        }
        assert_eq!(report["status"], status);
        assert_eq!(report["effective_mass"].is_null(), status != "finite");
        assert_eq!(report["schema"], "percuss.mass/1");
        for key in ["link", "against", "point_world", "normal_world", "point_link", "normal_link"] {
            assert!(report["contact"].get(key).is_some(), "contact lacks {key}");
        }
    }
    assert_eq!(finite["bodies"][2]["link"], "bob");
    assert!((finite["bodies"][2]["share"].as_f64().unwrap() - 1.0).abs() < 1e-15);
    assert_eq!(finite["inputs"][0]["sha256"].as_str().unwrap().len(), 64);
    assert_eq!(finite["pose"]["hinge"], serde_json::json!([0.0]));
    assert_eq!(finite["diagnostics"][0]["line"], 9);
}

const MASSLESS_TIP: &str = r#"<robot name="r"><link name="g"/><link name="tip"/>
  <joint name="j" type="continuous"><parent link="g"/><child link="tip"/><axis xyz="0 0 1"/></joint></robot>"#;

#[test]
fn check_json_has_its_keys() {
    let report = json("check models/planar_2r.urdf --format json");
    for key in [
        "links",
        "joints",
        "closures",
        "degrees_of_freedom",
        "generic_degrees_of_freedom",
        "redundant_constraints",
        "total_mass",
        "pose",
        "diagnostics",
    ] {
        assert!(report.get(key).is_some(), "{key} is missing");
    }
    assert_eq!(report["total_mass"], 6.0);
    assert_eq!(report["joints"][0]["armature"], serde_json::json!([0.3]));
}

#[test]
fn csv_is_a_header_and_a_row_of_equal_length() {
    let outcome = percuss(&format!("{ARM} --set elbow=30deg --format csv"));
    let lines: Vec<Vec<&str>> = outcome.stdout.lines().map(|l| l.split(',').collect()).collect();
    assert_eq!(lines.len(), 2);
    assert_eq!(lines[0].len(), lines[1].len());
    let wanted = [
        "row",
        "elbow",
        "status",
        "effective_mass",
        "closure_residual",
        "singular_pose",
        "motion_ratio",
        "estimate",
        "estimate_error_percent",
        "shoulder",
    ];
    assert_eq!(&lines[0][..wanted.len()], wanted);
    assert_eq!(lines[1][1].parse::<f64>().unwrap(), std::f64::consts::PI / 6.0);
    assert_eq!(lines[1][6], "");
}

#[test]
fn flags_mean_what_they_say() {
    let m = kilograms(ARM);
    // Negative first components in both notations; the result does not depend on the sign of the normal.
    assert_eq!(kilograms(&ARM.replace("--normal 0,0,-1", "--normal=-0,0,1")), m);
    assert_eq!(kilograms(&ARM.replace("--normal 0,0,-1", "--normal -0,0,2")), m);
    // Units.
    assert_eq!(kilograms(&ARM.replace("0.08,0,0", "80mm,0cm,0m")), m);
    let posed = kilograms(&format!("{ARM} --set elbow=40deg"));
    assert_eq!(posed, kilograms(&format!("{ARM} --set elbow={}rad", 40.0 * std::f64::consts::PI / 180.0)));
    assert!((posed / m - 1.0).abs() > 1e-3);
    // A lock or a rotor increases m̄; a floating base reduces it.
    assert!(kilograms(&format!("{ARM} --lock elbow")) > m * 1.001);
    assert!(kilograms(&format!("{ARM} --armature elbow=0.5")) > m * 1.001);
    let turret = "mass models/six_r_arm.urdf --link turret --point 0.1,0,0 --normal 0,1,0";
    let heavy_base = kilograms(turret);
    let of_point = format!("{turret} --base floating --link-mass pedestal=40kg");
    assert!(kilograms(&of_point) < heavy_base);
    assert!(percuss(&of_point).stderr.contains("\"pedestal\" has a mass and no moments of inertia"));
    // A floating base needs a mass.
    let massless = percuss(&format!("{turret} --base floating"));
    assert_eq!(massless.code, 2);
    let said = "--base: the root link \"pedestal\" has no mass; a floating root link needs mass and inertia";
    assert!(massless.stderr.contains(said), "{}", massless.stderr);
    // A free body in series.
    let other = kilograms(&format!("{ARM} --against-mass 500g"));
    assert!((1.0 / other - (1.0 / m + 2.0)).abs() < 1e-12 / m);
    // The same normal given by a line, and the same contact in the world frame.
    let along = ARM.replace("--normal 0,0,-1", "--along-line tool:0.08,0,-3");
    assert!((kilograms(&along) / m - 1.0).abs() < 1e-14);
    let world = ARM.replace("0.08,0,0", "1.14,0,0.4");
    assert!((kilograms(&format!("{world} --frame world")) / m - 1.0).abs() < 1e-13);
    // Against another link of the same arm; `world` is the ground.
    assert!(kilograms(&format!("{ARM} --against forearm")) < m * 0.999);
    assert_eq!(kilograms(&format!("{ARM} --against world")), m);
}

#[test]
fn a_reader_that_leaves_early_is_no_error() {
    let mut child = command(["completions", "zsh"])
        .stdout(std::process::Stdio::piped())
        .stderr(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!((output.status.code(), output.stderr.as_slice()), (Some(0), &b""[..]));
}

/// Rounding of a few operations.
const ROUNDING: f64 = 1e-12;

/// Free rod of mass 1 and length 2 at the angle θ to the surface, s = sin θ, c = cos θ: µ_s = 3sc/(1+3s²), µ_j = (tan θ + 4/tan θ)/3.
/// Coupler of a four-bar linkage: the contact wedges from 1/t.
#[test]
fn thresholds_of_friction_have_their_closed_forms() {
    let folder = Scratch::new("friction-thresholds");
    let rod = r#"<robot name="rod"><link name="rod"><inertial><mass value="1"/>
        <inertia ixx="0" ixy="0" ixz="0" iyy="0.333333333333333333" iyz="0" izz="0.333333333333333333"/></inertial></link></robot>"#;
    let rod = folder.write("rod.urdf", rod);
    let value = |found: &serde_json::Value| found.as_f64().expect("a number");
    for degrees in [10.0_f64, 35.0, 60.0, 80.0] {
        let (s, c) = degrees.to_radians().sin_cos();
        let line = format!("mass {rod} --base floating --link rod --point 1,0,0 --normal {s},0,{}", -c);
        let report = json(&format!("{line} --friction-thresholds --format json"));
        let found = &report["friction_thresholds"];
        let (sticking, jamming) = (3.0 * s * c / (1.0 + 3.0 * s * s), (s / c + 4.0 * c / s) / 3.0);
        assert!((value(&found["sticking"]) / sticking - 1.0).abs() < ROUNDING, "{degrees}: {found}");
        assert!((value(&found["jamming"]) / jamming - 1.0).abs() < ROUNDING, "{degrees}: {found}");
        assert!(found["slope"].is_null());
        assert!(json(&format!("{line} --format json"))["friction_thresholds"].is_null());
    }
    let bar = "models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0";
    let found = &json(&format!("mass {bar} --friction-thresholds --format json"))["friction_thresholds"];
    let slope = (0.3 - 0.5 / 21.0) * 12.0;
    assert!((value(&found["jamming"]) * slope - 1.0).abs() < ROUNDING, "{found}");
    assert!(found["sticking"].is_null());
    let text = percuss(&format!("mass {bar} --friction-thresholds")).stdout;
    assert!(text.contains("the contact wedges from a coefficient of 0.3017"), "{text}");
    // The impact reports the same thresholds.
    let arm = "models/planar_2r.urdf --link outer --point 0.4,0,0 --normal 0,1,0 --set elbow=40deg";
    let found = &json(&format!("mass {arm} --friction-thresholds --format json"))["friction_thresholds"];
    let impact = json(&format!("impact {arm} --restitution 0.2 --speed 1 --friction 0.1 --format json"));
    assert_eq!(found["sticking"], impact["friction"]["sticking_threshold"]);
    assert_eq!(found["jamming"], impact["friction"]["jamming_threshold"]);
    let study = format!(
        "[model]\npath = \"{}\"\n[contact]\nlink = \"outer\"\npoint = [0.4, 0, 0]\nnormal = [0, 1, 0]\n[pose]\nset.elbow = \"40deg\"\n\
         [mass]\nfriction_thresholds = true\n",
        root().join("models/planar_2r.urdf").display()
    );
    let study = folder.write("study.toml", &study);
    assert_eq!(&json(&format!("run {study} --format json"))["friction_thresholds"], found);
}
