//! `percuss damp`: the damper for a given restitution, compared with closed forms; additional results of a model;
//! refusals.

use crate::support::{Scratch, Sweep, json, percuss, root};
use serde_json::Value;

const STOP: &str = "--link bump_stop_pad --point 0,0,0 --along-line bump_stop:0,0,0 --against chassis";
const WISHBONE: &str = "models/double_wishbone.urdf";

/// Number of rows of a printed table, including the header. Indented lines continue a row.
fn lines(line: &str) -> usize {
    percuss(line).stdout.lines().filter(|text| !text.starts_with(' ')).count()
}

#[track_caller]
fn assert_close(got: &Value, expected: f64, tolerance: f64) {
    let got = got.as_f64().unwrap_or_else(|| panic!("{got} is no number"));
    assert!((got - expected).abs() <= tolerance * expected.abs(), "got {got}, expected {expected}");
}

/// e = exp(−2ζC) with C = arccos ζ/√(1−ζ²), F = k x + c ẋ, ω = √(k/m).
#[test]
fn the_default_is_the_linear_law_without_tension() {
    let (m, k, e, v): (f64, f64, f64, f64) = (12.0, 4e5, 0.4, 0.5);
    let report = json("damp --mass 12kg --stiffness 4e5 --restitution 0.4 --speed 0.5 --format json");
    let ratio = report["damping_ratio"].as_f64().expect("a ratio");
    let c = ratio.acos() / (1.0 - ratio * ratio).sqrt();
    let omega = f64::sqrt(k / m);
    assert_close(&report["achieved_restitution"], e, 1e-12);
    assert!(((-2.0 * ratio * c).exp() / e - 1.0).abs() < 1e-12);
    assert_close(&report["damping"], 2.0 * ratio * (k * m).sqrt(), 1e-14);
    assert_close(&report["contact_duration"], 2.0 * c / omega, 1e-12);
    assert_close(&report["max_penetration"], v / omega * e.sqrt(), 1e-12);
    assert_close(&report["energy_lost"], 0.5 * m * v * v * (1.0 - e * e), 1e-12);
    assert_close(&report["rebound_speed"], e * v, 1e-12);
    // Hunt–Crossley dissipation for the same restitution: a(0.4) = 2.0824981641…, divided by the speed.
    assert_close(&report["dissipation"], 2.08249816414701 / v, 1e-11);
    assert_eq!((&report["law"], &report["separation"]), (&"kelvin-voigt".into(), &"force".into()));
    assert_eq!(report["schema"], "percuss.damp/1");
    for absent in ["drift", "body_alone"] {
        assert!(report[absent].is_null(), "{absent}");
    }
    assert_eq!(
        report["exports"].as_object().map(serde_json::Map::len),
        Some(lines("damp --list-tools") - 1),
        "all tools, in JSON"
    );
}

#[test]
fn the_textbook_half_period_is_the_other_separation() {
    let report = json("damp --mass 2 --stiffness 1e4 --restitution 0.5 --separation gap --format json");
    let l = -(0.5f64.ln());
    assert_close(&report["damping_ratio"], l / (std::f64::consts::PI.powi(2) + l * l).sqrt(), 1e-13);
    assert_eq!(report["separation"], "gap");
    for unknown in ["max_penetration", "peak_force", "energy_lost", "rebound_speed", "dissipation"] {
        assert!(report[unknown].is_null(), "{unknown} needs a speed");
    }
    assert!(report["contact_duration"].as_f64().is_some(), "a linear contact takes as long at every speed");
}

#[test]
fn an_approximation_says_how_far_off_it_is() {
    let report = json(
        "damp --mass 3 --stiffness 1e6 --restitution 0.5 --speed 2 --law lankarani-nikravesh --exponent 1.5 --format json",
    );
    // a = 3(1 − e²)/4; the restitution achieved follows from the exact relation: 0.7252.
    assert_close(&report["dissipation"], 0.75 * 0.75 / 2.0, 1e-14);
    assert_close(&report["achieved_restitution"], 0.7252, 1e-4);
    assert_eq!(report["law_is_exact"], false);
    assert!(report["damping"].is_null() && report["damping_ratio"].is_null());
    let text =
        percuss("damp --mass 3 --stiffness 1e6 --restitution 0.5 --speed 2 --law lankarani-nikravesh").stdout;
    assert!(text.contains("error +0.2252"), "{text}");
}

#[test]
fn a_model_tells_its_mass_its_drift_and_what_the_body_alone_would_do() {
    let report = json(&format!(
        "damp --mass-from {WISHBONE} {STOP} --stiffness 2e5 --restitution 0.3 --speed 0.5 --for mujoco --format json"
    ));
    let mass = json(&format!("mass {WISHBONE} {STOP} --format json"));
    assert_eq!(report["effective_mass"], mass["effective_mass"]);
    assert_eq!(report["inputs"], mass["inputs"]);
    let m = mass["effective_mass"].as_f64().expect("a mass");
    // The drift is dm/dδ over m, with the penetration δ; reference: finite differences over the driving joint.
    let per_metre = report["drift"]["per_metre"].as_f64().expect("a slope");
    let at = |angle: f64| {
        let line = format!("mass {WISHBONE} {STOP} --set lower_arm_hinge={angle} --format json");
        json(&line)["effective_mass"].as_f64().expect("a mass")
    };
    let gap = |angle: f64| {
        let line = format!("mass {WISHBONE} {STOP} --set lower_arm_hinge={angle} --format json");
        let points: Vec<f64> = json(&line)["contact"]["point_world"]
            .as_array()
            .expect("a point")
            .iter()
            .filter_map(Value::as_f64)
            .collect();
        let normal: Vec<f64> = json(&line)["contact"]["normal_world"]
            .as_array()
            .expect("a normal")
            .iter()
            .filter_map(Value::as_f64)
            .collect();
        (points, normal)
    };
    let h = 1e-4;
    let ((ahead, n), (behind, _)) = (gap(h), gap(-h));
    let closed: f64 = (0..3).map(|i| (ahead[i] - behind[i]) * n[i]).sum();
    let slope = (at(h) - at(-h)) / closed / m;
    assert!((slope / per_metre - 1.0).abs() < 1e-3, "{slope} {per_metre}");
    let over = report["drift"]["over_penetration"].as_f64().expect("a drift");
    let linear = per_metre * report["max_penetration"].as_f64().expect("a penetration");
    assert!((over / linear - 1.0).abs() < 0.5 && over > 0.0, "{over} {linear}");
    // c computed for 24 kg gives the damping ratio ζ √(24/m̄) at m̄.
    let (alone, ratio) = (23.965, report["damping_ratio"].as_f64().expect("a ratio"));
    assert_close(&report["body_alone"]["mass"], alone, 1e-12);
    let weak = ratio * (alone / m).sqrt();
    let e = (-2.0 * weak * weak.acos() / (1.0 - weak * weak).sqrt()).exp();
    assert_close(&report["body_alone"]["restitution"], e, 1e-12);
    let mujoco = &report["exports"]["mujoco"];
    assert!(mujoco["parameters"]["equality_solref"].is_array(), "loops are closed by constraints");
    assert!(mujoco["snippet"].as_str().expect("text").contains("<equality solref="));
}

#[test]
fn mass_and_studies_take_a_restitution_too() {
    let flags = "--stiffness 2e5 --restitution 0.3 --speed 0.5";
    let damp = json(&format!("damp --mass-from {WISHBONE} {STOP} {flags} --for drake --format json"));
    let mass = json(&format!("mass {WISHBONE} {STOP} {flags} --for drake --format json"));
    for (key, value) in damp.as_object().expect("an object") {
        // In the result of `mass`, the diagnostics are in the common list.
        let expected = if key == "diagnostics" { &serde_json::json!([]) } else { value };
        assert!(mass["damper"][key] == *expected, "{key}");
    }
    assert!(json(&format!("mass {WISHBONE} {STOP} --format json"))["damper"].is_null());
    let text = percuss(&format!("mass {WISHBONE} {STOP} {flags}")).stdout;
    assert!(text.contains("contact link alone") && text.contains("mass kg"), "{text}");
    let scratch = Scratch::new("damp-study");
    let study = scratch.write(
        "stop.toml",
        &format!(
            "[model]\npath = {:?}\n[contact]\nlink = \"bump_stop_pad\"\npoint = [0, 0, 0]\nagainst = \"chassis\"\n\
             along_line = {{ link = \"bump_stop\", point = [0, 0, 0] }}\n[damping]\nrestitution = 0.3\nstiffness = 2e5\n\
             speed = 0.5\nfor = [\"drake\"]\n",
            root().join(WISHBONE).to_string_lossy()
        ),
    );
    let from_study = json(&format!("run {study} --format json"));
    for key in ["damping", "dissipation", "drift", "exports"] {
        assert_eq!(from_study["damper"][key], damp[key], "{key}");
    }
}

#[test]
fn the_force_history_is_drawn() {
    let scratch = Scratch::new("damp-course");
    let impact = "damp --mass 12 --stiffness 4e5 --restitution 0.4 --speed 0.5";
    let csv = scratch.path("course.csv");
    assert_eq!(percuss(&format!("{impact} --output {csv}")).code, 0);
    let course = Sweep::read(&std::fs::read_to_string(&csv).expect("written"));
    let column = |name: &str| -> Vec<f64> {
        (0..2000).map(|row| course.number(row, name).expect("a number")).collect()
    };
    let (x, f) = (column("penetration"), column("force"));
    // The loop of force over penetration encloses the energy lost: ½ m v² (1 − e²) = 1.26 J.
    let area: f64 = (1..2000).map(|i| 0.5 * (f[i] + f[i - 1]) * (x[i] - x[i - 1])).sum();
    assert!((area / 1.26 - 1.0).abs() < 1e-3, "{area}");
    for (name, begin) in [("course.xlsx", &b"PK"[..]), ("course.parquet", b"PAR1"), ("course.pdf", b"%PDF")] {
        let file = scratch.path(name);
        assert_eq!(percuss(&format!("{impact} --output {file}")).code, 0);
        assert!(std::fs::read(&file).expect("written").starts_with(begin), "{name}");
    }
    let svg = scratch.path("course.svg");
    assert_eq!(percuss(&format!("{impact} --output {svg}")).code, 0);
    let drawn = std::fs::read_to_string(&svg).expect("written");
    assert!(drawn.contains("time (ms)") && drawn.contains("compression (mm)"));
    let png = scratch.path("course.png");
    assert_eq!(percuss(&format!("{impact} --output {png}")).code, 0);
    assert!(std::fs::read(&png).expect("written").starts_with(b"\x89PNG"));
}

#[test]
fn names_stand_for_what_they_are_known_for() {
    let base = "damp --mass 12 --stiffness 2e5 --restitution 0.3 --format json --law";
    let half_period = json(&format!("{base} anagnostopoulos"));
    assert_eq!(
        (&half_period["separation"], &half_period["law_alias"]),
        (&"gap".into(), &"anagnostopoulos".into())
    );
    let l = -(0.3f64.ln());
    assert_close(&half_period["damping_ratio"], l / (std::f64::consts::PI.powi(2) + l * l).sqrt(), 1e-13);
    assert_eq!(json(&format!("{base} tsuji"))["exponent"], 1.5);
    assert_eq!(json(&format!("{base} tsuji --exponent 1.5"))["exponent"], 1.5);
    for contradiction in
        ["tsuji --exponent 1", "anagnostopoulos --separation force", "anagnostopoulos --exponent 2"]
    {
        let outcome = percuss(&format!("{base} {contradiction}"));
        assert_eq!(outcome.code, 2, "{contradiction}");
        assert!(outcome.stderr.contains("implies the"), "{}", outcome.stderr);
    }
}

#[test]
fn units_may_follow_numbers() {
    let plain = json(
        "damp --mass 12 --stiffness 4e5 --restitution 0.4 --speed 0.5 --time-step 1e-4 --for ode --format json",
    );
    let typed = json(
        "damp --mass 12kg --stiffness 400N/mm --restitution 40% --speed 500mm/s --time-step 0.1ms --for ode --format json",
    );
    assert_eq!(plain, typed);
    for (flags, words) in [
        ("--stiffness 400lb --restitution 0.4", "N/mm"),
        ("--stiffness 400mm --restitution 0.4", "N/mm"),
        ("--stiffness 4e5 --restitution 0.4 --speed 1N", "km/h"),
        ("--stiffness 400N/mm --restitution 0.4 --exponent 1.5", "N/m^1.5"),
        ("--stiffness 4e5 --restitution 40", "from 0 to 1"),
    ] {
        let outcome = percuss(&format!("damp --mass 12 {flags}"));
        assert_eq!(outcome.code, 2, "{flags}");
        assert!(outcome.stderr.contains(words), "{flags}: {}", outcome.stderr);
    }
}

/// Every simulator integrates its own law; the parameters are for this law, and a finding states this.
#[test]
fn exports_are_for_the_restitution_not_for_the_law() {
    let base = "damp --mass 12 --stiffness 4e5 --restitution 0.3 --speed 0.5 --for mujoco,drake --for mujoco --format json";
    let exact = json(base);
    let other = json(&format!("{base} --law flores"));
    assert_eq!(exact["exports"], other["exports"]);
    assert_eq!(exact["exports"].as_object().map(serde_json::Map::len), Some(2));
    assert_eq!(exact["diagnostics"], serde_json::json!([]));
    // At 9.81 m/s² the weight is a tenth of the spring's force: a note of each compliant export.
    for tool in exact["exports"].as_object().expect("an object").values() {
        let notes = tool["assumptions"].as_array().expect("an array");
        assert!(
            notes.iter().any(|note| note.as_str().is_some_and(|note| note.contains("gravity"))),
            "{tool}"
        );
    }
    assert_eq!(other["diagnostics"][0]["code"], "exports-own-law");
    assert_eq!(json(&format!("{base} --separation gap"))["diagnostics"][0]["code"], "exports-own-law");
}

#[test]
fn the_own_mass_of_the_contact_body_may_be_given() {
    let report =
        json("damp --mass 12 --stiffness 4e5 --restitution 0.3 --own-mass 3 --for chrono --format json");
    let ratio = report["damping_ratio"].as_f64().expect("a ratio") / 2.0;
    let e = (-2.0 * ratio * ratio.acos() / (1.0 - ratio * ratio).sqrt()).exp();
    assert_close(&report["body_alone"]["restitution"], e, 1e-12);
    assert!(report["exports"]["chrono"]["error"].is_null());
    let outcome = percuss("damp --mass 12 --stiffness 4e5 --restitution 0.3 --for chrono");
    assert!(outcome.code == 2 && outcome.stderr.contains("--own-mass"), "{}", outcome.stderr);
}

/// Simulators treat mimics, locks and holds as constraints, like loops.
#[test]
fn constraints_of_any_kind_are_stiffened_in_mujoco() {
    let arm = "damp --mass-from models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 0,1,1 --set elbow=70deg \
               --stiffness 1e5 --restitution 0.5 --speed 0.1 --for mujoco --format json";
    let settings = |flags: &str| {
        json(&format!("{arm} {flags}"))["exports"]["mujoco"]["parameters"]["equality_solref"].is_array()
    };
    assert!(!settings(""), "a tree needs none");
    assert!(settings("--lock yaw"));
    assert!(settings("--hold forearm:0,0,0:0,0,1"));
}

/// Free body with an impact after which the root's origin remains at rest (1 m is the centre of percussion:
/// 0.5 + 0.5/(2·0.5) m): a pure rotation.
#[test]
fn the_drift_of_a_body_that_only_turns_is_known() {
    let scratch = Scratch::new("damp-turns");
    let model = scratch.write(
        "body.urdf",
        "<robot name=\"p\"><link name=\"base\"><inertial><origin xyz=\"0.5 0 0\"/><mass value=\"2\"/>\
         <inertia ixx=\"0.5\" ixy=\"0\" ixz=\"0\" iyy=\"0.5\" iyz=\"0\" izz=\"0.5\"/></inertial></link></robot>",
    );
    let impact = format!(
        "damp --mass-from {model} --base floating --link base --point 1,0,0 --stiffness 1e5 --restitution 0.5 --speed 0.1 \
         --format json"
    );
    // A normal that turns with the body causes no change. Relative to a fixed normal, the body inclines, and m̄
    // changes in second order.
    let turning = json(&format!("{impact} --normal 0,1,0"));
    assert!(turning["drift"]["over_penetration"].as_f64().expect("known").abs() < 1e-12);
    let still = json(&format!("{impact} --normal 0,1,0 --normal-frame world"));
    let depth = still["max_penetration"].as_f64().expect("a depth");
    // 1/m̄ = 1/2 + (0.5 cos δ)²/0.5 at 1 m/s of the point per rad/s; here cos² δ = 1 − δ².
    let expected = 1.0 / (0.5 + 0.5 * depth.cos().powi(2)) - 1.0;
    let over = still["drift"]["over_penetration"].as_f64().expect("known");
    assert!((over / expected - 1.0).abs() < 1e-3, "{over} {expected}");
    // Only the other body moves; its mass is constant.
    let wall = json(
        "damp --mass-from models/physical_pendulum.urdf --link body --point 0,0,-0.5 --normal 0,0,1 --against-mass 3 \
         --stiffness 1e5 --restitution 0.5 --speed 0.1 --format json",
    );
    assert_eq!((&wall["effective_mass"], &wall["drift"]["over_penetration"]), (&3.0.into(), &0.0.into()));
}

/// Curvature of the motion of one hinge: κ = 1/l + r/l² = 3.6/m for l = 0.5 m and r = 0.4 m. Step of half of the accuracy:
/// 1e-3/(2 (1 + e) κ v).
#[test]
fn rigid_contacts_of_a_lever_have_the_step_of_its_curvature() {
    let report = json(
        "damp --mass-from models/physical_pendulum.urdf --link body --point 0,0,-0.5 --normal 1,0,0 --stiffness 1e5 \
         --restitution 0.5 --speed 0.1 --for all --format json",
    );
    for (tool, error) in [("rapier", 1e-6), ("jolt", 1e-4)] {
        let export = &report["exports"][tool];
        assert_close(&export["time_step"], 1e-3 / (2.0 * 1.5 * 3.6 * 0.1), 1e-4);
        let bound = export["error_bound"].as_f64().expect("a bound");
        assert!((5e-4 + error..5.1e-4 + error).contains(&bound), "{tool}: {bound}");
    }
    // The effective mass without the hinge, 1/(1/3 + 0.1²/0.07) = 2.1 kg, is near m̄ = 2.2 kg.
    assert_eq!(report["exports"]["jolt"]["parameters"]["mNumVelocitySteps"], 50.0);
}

/// Effective inertia of a joint stop: 1/(e M⁻¹ eᵀ); at the elbow of the two rods M₂₂ − M₁₂²/M₁₁, with the M of
/// planar_2r.urdf.
#[test]
fn the_stop_of_a_joint_has_the_inertia_of_both_sides() {
    let report = json(
        "damp --mass-from models/planar_2r.urdf --limit elbow --set elbow=1 --armature elbow=0.4 \
         --stiffness 200Nm/rad --restitution 0.5 --speed 0.1 --for mujoco --format json",
    );
    let (m1, l1, m2, l2): (f64, f64, f64, f64) = (4.0, 0.5, 2.0, 0.4);
    let (a, b, c) =
        (m1 * l1 * l1 / 3.0 + m2 * l1 * l1, m2 * l2 * l2 / 3.0, m2 * l1 * l2 / 2.0 * 1.0_f64.cos());
    let (m11, m12, m22) = (a + b + 2.0 * c + 0.3, b + c, b + 0.4);
    assert_close(&report["effective_mass"], m22 - m12 * m12 / m11, 1e-13);
    assert_eq!(report["stop"], serde_json::json!({"joint": "elbow", "motion": "turn"}));
    assert!(report["body_alone"].is_null());
    // κ = ω² f, f = d + (1 − d) α; α is the inertia divided by the inertia at zero with the other joint free.
    let (at_0, c) = (0.0_f64.cos(), m2 * l1 * l2 / 2.0);
    let open = m22 - (b + c * at_0).powi(2) / (a + b + 2.0 * c * at_0 + 0.3);
    let inertia = m22 - m12 * m12 / m11;
    let scale = 0.9999 + 1e-4 * inertia / open;
    let solref = &report["exports"]["mujoco"]["parameters"]["solreflimit"];
    assert_close(&solref[0], -200.0 / inertia * scale, 1e-12);

    // The ratio of ERP and CFM is the stiffness. With `--for all`, simulators without joint stops give the reason.
    let all = json(
        "damp --mass-from models/planar_2r.urdf --limit elbow --set elbow=1 --stiffness 200 --restitution 0.5 --speed 0.1 \
         --for all --format json",
    );
    let ode = &all["exports"]["ode"];
    let [erp, cfm] = ["stop_erp", "stop_cfm"].map(|name| ode["parameters"][name].as_f64().expect("a number"));
    assert_close(&ode["time_step"], erp / cfm / 200.0, 1e-9);
    assert_eq!(ode["units"]["stop_cfm"], "rad/(N·m·s)");
    assert!(ode["snippet"].as_str().is_some_and(|text| text.contains("dParamStopCFM")), "{ode}");
    for (tool, written) in
        [("mujoco", true), ("newton", true), ("physx", true), ("drake", false), ("jolt", false)]
    {
        assert_eq!(all["exports"][tool]["error"].is_null(), written, "{tool}");
    }

    let out = percuss(
        "damp --mass-from models/planar_2r.urdf --limit elbow --stiffness 2Nm/deg --restitution 0.5 --speed 10deg/s",
    )
    .stdout;
    for shown in ["effective inertia", "kg·m²", "N·m/rad", " rad/s", " mrad", "peak moment, at"] {
        assert!(out.contains(shown), "{shown}: {out}");
    }
    let slide = json(
        "damp --mass-from models/slider_crank.urdf --limit guide --set crank_hinge=1 --stiffness 1e6 --restitution 0.5 \
         --format json",
    );
    // The stop of a prismatic joint is a contact along its axis.
    let contact = json(
        "mass models/slider_crank.urdf --link slider --point 0,0,0 --normal 1,0,0 --set crank_hinge=1 --format json",
    );
    assert_eq!(slide["effective_mass"], contact["effective_mass"]);
    assert_eq!(slide["stop"]["motion"], "slide");
    for (line, told) in [
        ("--limit nope --stiffness 1 --restitution 0.5", "no joint is named \"nope\""),
        ("--limit elbow --stiffness 1N/mm --restitution 0.5", "expected N·m/rad"),
        ("--limit elbow:upper --stiffness 1 --restitution 0.5", "has no <limit>"),
        ("--limit elbow --link outer --stiffness 1 --restitution 0.5", "cannot be used with"),
        (
            "--limit elbow --stiffness 1 --restitution 0.5 --for rapier",
            "stops are written for mujoco, ode, newton, physx",
        ),
        (
            "--limit elbow --stiffness 1 --restitution 0.5 --for drake",
            "let the two links collide at the stop",
        ),
    ] {
        let outcome = percuss(&format!("damp --mass-from models/planar_2r.urdf {line}"));
        assert_eq!(outcome.code, 2, "{line}");
        assert!(outcome.stderr.contains(told), "{line}: {}", outcome.stderr);
    }
}
