//! Reflected inertias at a pose and over ranges, without a contact: tables, figures, and substitutes for simulators without loops.

use crate::support::{Scratch, Sweep, json, percuss, refused, root};
use serde_json::Value;

const BAR: &str = "impact models/four_bar.urdf";

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn reflected_inertias_need_no_contact() {
    let alone =
        json(&format!("{BAR} --reflected crank_hinge --reflected crank_hinge=0:360deg:37 --format json"));
    assert_eq!(alone["schema"], "percuss.reflected/1");
    let contact = "--link coupler --point 0.35,0.1,0 --normal 0,1,0 --restitution 0.3 --speed 1";
    let full = json(&format!(
        "{BAR} {contact} --reflected crank_hinge --reflected crank_hinge=0:360deg:37 --format json"
    ));
    for key in ["reflected_inertia", "reflected_over"] {
        assert_eq!(alone[key], full[key], "{key}");
    }
    let set = json(&format!("{BAR} --set crank_hinge=90deg --reflected crank_hinge --format json"));
    let range =
        &json(&format!("{BAR} --reflected crank_hinge=90deg:91deg:2 --format json"))["reflected_over"][0];
    let (at, of_range) = (number(&set["reflected_inertia"][0]["held"]), number(&range["held"][0]));
    assert!((at / of_range - 1.0).abs() < 1e-12, "{at} {of_range}");
    let text = percuss(&format!("{BAR} --reflected crank_hinge --reflected rocker_hinge")).stdout;
    assert!(text.contains("driving joints       crank_hinge") && text.contains("rocker_hinge:"), "{text}");
    // With a flag of an impact, a contact and a restitution are required.
    refused(&format!("{BAR} --reflected crank_hinge --speed 1"), &["a contact of the model is required"]);
    let contact = "--link coupler --point 0.35,0.1,0 --normal 0,1,0";
    refused(&format!("{BAR} {contact} --reflected crank_hinge --speed 1"), &["--restitution: it is missing"]);
    refused(&format!("{BAR} {contact} --speed 1"), &["--restitution"]);
}

#[test]
fn ranges_are_written_as_tables_and_figures() {
    let folder = Scratch::new("reflected");
    let line = format!("{BAR} --reflected crank_hinge=-40deg:40deg:9");
    let csv = folder.path("inertia.csv");
    let report = json(&format!("{line} --output {csv} --format json"));
    let range = &report["reflected_over"][0];
    let table = Sweep::read(&std::fs::read_to_string(&csv).expect("a table"));
    for k in 0..9 {
        assert_eq!(table.cell(k, "joint"), "crank_hinge");
        for (column, key) in [("position", "positions"), ("free", "free"), ("held", "held")] {
            assert_eq!(table.number(k, column), range[key][k].as_f64(), "{column}");
        }
        assert_eq!(table.number(k, "mimic_tree"), range["substitute"]["inertias"][k].as_f64());
    }
    let formats = [
        ("inertia.csv", &b"joint,"[..]),
        ("a.xlsx", b"PK"),
        ("a.parquet", b"PAR1"),
        ("a.png", b"\x89PNG"),
        ("a.pdf", b"%PDF"),
    ];
    for (name, start) in formats {
        let path = folder.path(name);
        // The second run replaces the file of the first.
        for _ in 0..2 {
            let outcome = percuss(&format!("{line} -o {path}"));
            assert_eq!(outcome.code, 0, "{name}: {}", outcome.stderr);
            assert!(std::fs::read(&path).expect("a file").starts_with(start), "{name}");
        }
        std::fs::write(&path, "not by percuss").expect("a writable folder");
        refused(&format!("{line} -o {path}"), &["--force"]);
        assert_eq!(percuss(&format!("{line} -o {path} --force")).code, 0, "{name}");
    }
    // The free and the held inertia are two curves if they differ, and one curve in a mechanism with one degree of freedom.
    let svg = |line: &str| {
        let path = folder.path("curves.svg");
        let outcome = percuss(&format!("{line} -o {path}"));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        std::fs::read_to_string(&path).expect("a figure")
    };
    let one = svg(&line);
    assert!(one.contains("other joints free or held") && one.contains("best constant"), "{one}");
    let arm = svg("impact models/planar_2r.urdf --set elbow=40deg --reflected shoulder=-30deg:30deg:7");
    assert!(arm.contains("other joints free<") && arm.contains("other drivers held"), "{arm}");
    let two = svg("impact models/planar_2r.urdf --reflected shoulder=0:1:5 --reflected elbow=0:1:5");
    assert!(
        two.contains("Inertia reflected to shoulder") && two.contains("Inertia reflected to elbow"),
        "{two}"
    );
    for (flags, words) in [
        ("--reflected crank_hinge -o x.csv", "a range --reflected JOINT=FROM:TO:COUNT"),
        ("--reflected crank_hinge=0:1:3 -o x.txt", ".parquet"),
        (
            "--reflected crank_hinge=0:1:3 -o x.svg --link coupler --point 0.35,0.1,0 --normal 0,1,0 --restitution 0.3 --speed 0.5 \
          --stiffness 2e6 --in-time",
            "both --in-time",
        ),
    ] {
        refused(&format!("{BAR} {flags}"), &[words]);
    }
}

#[test]
fn ranges_are_checked_against_limits_and_positions() {
    let warned = percuss("impact models/six_r_arm.urdf --reflected elbow=0:5:5");
    assert!(warned.code == 0 && warned.stderr.contains("outside the limits"), "{}", warned.stderr);
    let inside = percuss("impact models/six_r_arm.urdf --reflected elbow=0:2:5");
    assert!(!inside.stderr.contains("outside"), "{}", inside.stderr);
    refused(
        &format!("{BAR} --reflected crank_hinge=0:1:3 --set crank_hinge=1"),
        &["--reflected", "already set (--set)"],
    );
    // A contact at the stop sets the position of the joint only for the impact, not for the range.
    let stop = "impact models/six_r_arm.urdf --at elbow:upper --restitution 0.2 --speed 2 --reflected elbow=0:1:3 --format json";
    let plain = "impact models/six_r_arm.urdf --reflected elbow=0:1:3 --format json";
    assert_eq!(json(stop)["reflected_over"], json(plain)["reflected_over"]);
    // The velocities of a ball joint have distinct labels.
    let ball = json("impact models/multi_link.urdf --reflected upper_ball --format json");
    let labels: Vec<&Value> = ball["reflected_inertia"]
        .as_array()
        .expect("three")
        .iter()
        .map(|record| &record["direction"])
        .collect();
    assert_eq!(labels, ["about x", "about y", "about z"]);
    let text = percuss("impact models/multi_link.urdf --reflected upper_ball").stdout;
    assert!(text.contains("upper_ball about x:") && text.contains("upper_ball about z:"), "{text}");
}

/// The substitute is written as a URDF with mimic joints and without loops. Its inertia with the armature differs from the inertia of the
/// linkage by the stated largest error.
#[test]
fn a_substitute_with_mimic_joints_has_the_stated_error() {
    let folder = Scratch::new("mimic");
    let text = std::fs::read_to_string(root().join("models/four_bar.urdf")).expect("the model");
    let mut tree = text[text.find("<robot").expect("a robot")..].replace(" independent=\"true\"", "");
    let (start, end) =
        (tree.find("<loop ").expect("a loop"), tree.find("</loop>").expect("its end") + "</loop>".len());
    tree.replace_range(start..end, "");
    for range in ["90deg:130deg:21", "10deg:14deg:11", "250deg:265deg:31"] {
        let report =
            json(&format!("{BAR} --armature crank_hinge=0.3 --reflected crank_hinge={range} --format json"));
        let found = &report["reflected_over"][0];
        let substitute = &found["substitute"];
        let mut model = tree.clone();
        for mimic in substitute["joints"].as_array().expect("joints") {
            let name =
                format!("<joint name=\"{}\" type=\"continuous\">", mimic["joint"].as_str().expect("a name"));
            let element = format!(
                "{name}<mimic joint=\"crank_hinge\" multiplier=\"{}\" offset=\"{}\"/>",
                mimic["multiplier"], mimic["offset"]
            );
            assert!(model.contains(&name), "{name}");
            model = model.replace(&name, &element);
        }
        let model = folder.write("tree.urdf", &model);
        let armature = 0.3 + number(&substitute["armature"]);
        assert!(armature >= 0.0);
        let own = json(&format!(
            "impact {model} --armature crank_hinge={armature} --reflected crank_hinge={range} --format json"
        ));
        let own = own["reflected_over"][0]["held"].as_array().expect("values");
        let errors = own.iter().zip(found["held"].as_array().expect("values"));
        let error = errors.map(|(own, exact)| (number(own) / number(exact) - 1.0).abs()).fold(0.0, f64::max);
        let stated = number(&substitute["largest_error"]);
        assert!((error - stated).abs() < 1e-9, "{range}: {error} {stated}");
        // If the ratios change fast over the range, the constant armature alone can be better.
        let is_better = stated < number(&found["largest_error"]);
        assert_eq!(is_better, range != "250deg:265deg:31", "{range}: {stated}");
    }
    let text = percuss(&format!("{BAR} --reflected crank_hinge=10deg:14deg:5")).stdout;
    assert!(text.contains("mimic joints         for a simulator without loops"), "{text}");
}

/// A joint whose position is given drives its loop, so that `held` has a value and names the other drivers. Without it, a joint that is no
/// automatic driver has a warning.
#[test]
fn joints_with_given_positions_drive() {
    let folder = Scratch::new("drives");
    let link = |name: &str, x: f64, mass: f64| {
        format!(
            "<link name=\"{name}\"><inertial><origin xyz=\"{x} 0 0\"/><mass value=\"{mass}\"/><inertia ixx=\"1e-3\" iyy=\"0.01\" \
             izz=\"0.01\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
        )
    };
    let hinge = |name: &str, parent: &str, child: &str, x: f64| {
        format!(
            "<joint name=\"{name}\" type=\"continuous\"><parent link=\"{parent}\"/><child link=\"{child}\"/><origin xyz=\"{x} 0 0\"/>\
             <axis xyz=\"0 0 1\"/></joint>"
        )
    };
    // Five bars with motors at both hinges on the ground.
    let loop_at = "<loop name=\"tip\" type=\"revolute\"><predecessor link=\"rod_l\"><origin xyz=\"0.5 0 0\"/></predecessor><successor \
                   link=\"rod_r\"><origin xyz=\"0.5 0 0\"/></successor><axis xyz=\"0 0 1\"/></loop>";
    let parts = [
        "<robot name=\"five\"><link name=\"ground\"/>".to_owned(),
        link("arm_l", 0.15, 0.8)
            + &link("rod_l", 0.25, 0.5)
            + &link("arm_r", 0.15, 0.8)
            + &link("rod_r", 0.25, 0.5),
        hinge("left", "ground", "arm_l", 0.0) + &hinge("elbow_l", "arm_l", "rod_l", 0.3),
        hinge("right", "ground", "arm_r", 0.4) + &hinge("elbow_r", "arm_r", "rod_r", 0.3),
        format!("{loop_at}</robot>"),
    ];
    let model = folder.write("five.urdf", &parts.concat());
    for (left, right) in [(1.2, 2.3), (1.4, 1.9), (2.0, 1.3)] {
        let pose = format!("impact {model} --set left={left} --set right={right}");
        let report =
            json(&format!("{pose} --reflected left --reflected right --reflected elbow_l --format json"));
        assert_eq!(report["drivers"], serde_json::json!(["left", "right"]));
        let records = report["reflected_inertia"].as_array().expect("records");
        let mut product = Vec::new();
        for (record, other) in records.iter().zip(["right", "left"]) {
            assert_eq!(record["other_drivers"], serde_json::json!([other]));
            // The inertia with the other joints free is never larger.
            let (held, free) = (number(&record["held"]), number(&record["free"]));
            assert!(held >= free * (1.0 - 1e-12), "{held} {free}");
            product.push(held * free);
        }
        // Schur complements of a 2×2 matrix G: G₁₁ / (G⁻¹)₁₁ = G₁₁ (G₁₁ − G₁₂²/G₂₂), so that held·free of both joints differ by G₁₁/G₂₂ squared.
        let ratio = number(&records[0]["held"]) / number(&records[1]["held"]);
        assert!((product[0] / product[1] / (ratio * ratio) - 1.0).abs() < 1e-9, "{product:?}");
        assert!(records[2]["held"].is_null());
        let codes: Vec<&Value> =
            report["diagnostics"].as_array().expect("findings").iter().map(|found| &found["code"]).collect();
        assert!(codes.iter().any(|code| *code == "no-driver"), "{codes:?}");
        // Equal to the inertia at the mass matrix of the motors, from a range about the pose.
        let range = json(&format!(
            "impact {model} --set right={right} --reflected left={left}:{}:2 --format json",
            left + 0.01
        ));
        let of_range = number(&range["reflected_over"][0]["held"][0]);
        assert!((of_range / number(&records[0]["held"]) - 1.0).abs() < 1e-9, "{of_range}");
    }
}
