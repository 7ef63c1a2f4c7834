//! Comparisons of designs; safe speeds for other limits, in other directions, along a path.

use crate::support::{Scratch, Sweep, json, percuss, refused, root};
use serde_json::Value;

const STOP: &str = "--link bump_stop_pad --point 0,0,0 --along-line bump_stop:0,0,0 --against chassis";
const SHEETS: &str = "models/suspensions/double-wishbone.toml models/suspensions/double-wishbone-rods.toml";

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn designs_are_each_what_mass_and_sweep_say() {
    let folder = Scratch::new("designs");
    let vary = "--vary travel:spindle:0,0,0:0,0,1=-20mm:20mm:3";
    let report = json(&format!("compare {SHEETS} {STOP} {vary} --format json"));
    let sheets: Vec<&str> = SHEETS.split(' ').collect();
    let own = |sheet: &str| number(&json(&format!("mass {sheet} {STOP} --format json"))["effective_mass"]);
    let [first, other] = [own(sheets[0]), own(sheets[1])];
    let designs = report["designs"].as_array().expect("designs");
    assert_eq!(
        (number(&designs[0]["effective_mass"]), number(&designs[1]["effective_mass"])),
        (first, other)
    );
    assert_eq!(designs[0]["difference_percent"], Value::Null);
    let percent = 100.0 * (other / first - 1.0);
    assert!((number(&designs[1]["difference_percent"]) - percent).abs() < 1e-9);
    for (i, sheet) in sheets.iter().enumerate() {
        let swept = Sweep::read(&percuss(&format!("sweep {sheet} {STOP} {vary}")).stdout);
        for row in 0..3 {
            let mass = number(&report["rows"][row]["effective_mass"][i]);
            assert_eq!(Some(mass), swept.number(row, "effective_mass"), "{sheet} {row}");
        }
    }
    // Table and figure of the same comparison.
    let (csv, svg) = (folder.path("both.csv"), folder.path("both.svg"));
    for output in [&csv, &svg] {
        let outcome = percuss(&format!("compare {SHEETS} {STOP} {vary} --output {output}"));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        assert!(outcome.stdout.contains("double-wishbone-rods"), "{}", outcome.stdout);
    }
    let table = Sweep::read(&std::fs::read_to_string(csv).expect("a table"));
    assert_eq!(table.number(2, "double-wishbone"), report["rows"][2]["effective_mass"][0].as_f64());
    let drawn = std::fs::read_to_string(svg).expect("a figure");
    assert!(drawn.starts_with("<svg") && drawn.contains("double-wishbone-rods"), "{drawn}");
}

#[test]
fn variants_equal_the_same_flags() {
    let report = json("compare models/studies/variants.toml --format json");
    let sheet = "models/suspensions/double-wishbone.toml";
    let flags = [
        "",
        "--link-mass upright=4.6kg",
        "--move lower_ball=0,0,5mm",
        "--move bump_stop_pad=0,20mm,0 --move bump_stop=0,20mm,0",
    ];
    let designs = report["designs"].as_array().expect("designs");
    assert_eq!(designs.len(), flags.len());
    for (design, flags) in designs.iter().zip(flags) {
        let expected = json(&format!("mass {sheet} {STOP} {flags} --format json"));
        assert_eq!(design["effective_mass"], expected["effective_mass"], "{flags}");
    }
    assert_eq!(report["rows"].as_array().expect("rows").len(), 13);
    // `run` gives the same comparison; with a format, it gives the contact of the study.
    let run = percuss("run models/studies/variants.toml");
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(run.stdout, percuss("compare models/studies/variants.toml").stdout);
    assert_eq!(
        json("run models/studies/variants.toml --format json")["effective_mass"],
        designs[0]["effective_mass"]
    );
}

#[test]
fn a_study_changes_its_model_and_its_variants_change_that() {
    let folder = Scratch::new("designs-study");
    let pendulum = root().join("models/point_mass_pendulum.urdf");
    let text = |of_model: &str, variants: &str| {
        format!(
            "[model]\npath = {:?}\n{of_model}\n[contact]\nlink = \"rod\"\npoint = [0, 0, -0.8]\nnormal = [1, 0, 0]\n{variants}",
            pendulum.to_string_lossy()
        )
    };
    let study = folder.write(
        "masses.toml",
        &text(
            "link_mass = { bob = 4 }",
            "[[variant]]\nname = \"further\"\nlink_com = { bob = [0, 0, \"-100 mm\"] }\n\
             [[variant]]\nname = \"turned\"\nlink_inertia = { bob = [0.1, \"6400 kg cm2\", 0.6] }\n\
             [[variant]]\nname = \"light\"\nlink_mass = { bob = \"500 g\" }\narmature = { hinge = 0.64 }\nset = { hinge = 1 }\n",
        ),
    );
    let report = json(&format!("compare {study} --format json"));
    // m (r_A/r_B)²; a rotor of 0.64 kg·m² at 0.8 m counts as 1 kg.
    let own = 4.0 * (0.5f64 / 0.8).powi(2);
    let expected = [own, 4.0 * (0.6f64 / 0.8).powi(2), own + 1.0, 0.5 * (0.5f64 / 0.8).powi(2) + 1.0];
    for (design, expected) in report["designs"].as_array().expect("designs").iter().zip(expected) {
        assert!((number(&design["effective_mass"]) / expected - 1.0).abs() < 1e-12, "{design}");
    }
    for (of_model, variants, words) in [
        ("link_mass = { bub = 4 }", "", ["model.link_mass: ", "\"bub\""]),
        ("link_mass = { bob = \"4 m\" }", "", ["model.link_mass.bob", "mass"]),
        ("move = { ball = [0, 0, 1] }", "", ["model.move: ", "without hardpoints"]),
        ("", "[[variant]]\nlink_mass = { bob = 1 }", ["name", "missing"]),
        ("", "[[variant]]\nname = \"a\"\nlink_mas = { bob = 1 }", ["link_mas", "link_mass"]),
        (
            "",
            "[[variant]]\nname = \"a\"\nlink_mass = { bub = 1 }",
            ["variant[0].link_mass: \"a\"", "\"bub\""],
        ),
        ("", "[[variant]]\nname = \"a\"\n[[variant]]\nname = \"a\"", ["variant.name", "twice"]),
        (
            "",
            "[[variant]]\nname = \"a\"\nmodel = \"nowhere.urdf\"",
            ["variant[0].model: \"a\"", "no such file"],
        ),
        ("", "[[variant]]\nname = \"a\"\nset = { hange = 1 }", ["\"a\"", "\"hange\""]),
    ] {
        let bad = folder.write("bad.toml", &text(of_model, variants));
        refused(&format!("compare {bad}"), &words);
    }
    let alone = folder.write("alone.toml", &text("", ""));
    refused(&format!("compare {alone}"), &["two at least"]);
    refused(&format!("compare {alone} {}", pendulum.display()), &["is a study"]);
    refused(&format!("compare {alone} {study} --link rod"), &["--link"]);
    refused(&format!("compare {SHEETS}"), &["--link LINK"]);
    refused(&format!("compare {SHEETS} {STOP} --output both.svg"), &["--vary"]);
    refused(&format!("compare {SHEETS} {STOP} --output both.gif"), &[".csv"]);
    let swept = folder.write("swept.toml", &(text("", "") + "[sweep]\nvary = \"hinge=0:1:3\"\n"));
    refused(&format!("compare {alone} {swept}"), &["\"swept\"", "the first has no range"]);
}

const ARM: &str = "safe-speed models/six_r_arm.urdf --link tool --point 0.08,0,0 --set elbow=70deg";

/// ½ μ v² = E and μ v = P; without a region, μ is the robot's effective mass.
#[test]
fn energies_and_momenta_limit_speeds() {
    let two_body = |robot: f64| 1.0 / (1.0 / 40.0 + 1.0 / robot);
    for (limit, value, flags) in [
        ("energy", 1.5, "--energy 1.5"),
        ("energy", 1.5, "--energy 1500mJ"),
        ("momentum", 3.0, "--momentum 3Ns"),
        ("momentum", 3.0, "--momentum 3"),
    ] {
        for (region, with_region) in [("--region chest", true), ("", false)] {
            let report = json(&format!("{ARM} --normal 1,0,0 {region} {flags} --load 1 --format json"));
            assert_eq!(report["limited_by"], limit);
            for side in ["standard", "reflected"] {
                let robot = number(&report[side]["robot_mass"]);
                let mu = if with_region { two_body(robot) } else { robot };
                let expected = if limit == "energy" { (2.0 * value / mu).sqrt() } else { value / mu };
                let speed = number(&report[side]["speed"]);
                assert!(
                    (speed / expected - 1.0).abs() < 1e-12,
                    "{region} {flags} {side}: {speed} {expected}"
                );
            }
            let moving = number(&report["moving_mass"]);
            let standard = if with_region { 0.5 * moving + 1.0 } else { moving + 1.0 };
            assert!((number(&report["standard"]["robot_mass"]) / standard - 1.0).abs() < 1e-12);
        }
    }
    refused(&format!("{ARM} --normal 1,0,0 --force 280"), &["--region"]);
    refused(&format!("{ARM} --normal 1,0,0 --energy 0"), &["energy"]);
    refused(&format!("{ARM} --normal 1,0,0 --energy 1 --momentum 1"), &["--energy"]);
    let text = percuss(&format!("{ARM} --normal 1,0,0 --region chest --force 280")).stdout;
    assert!(text.starts_with("greatest speed"), "{text}");
    assert!(text.contains("the standards themselves were not read"), "{text}");
}

#[test]
fn no_direction_is_worse_than_the_worst() {
    let worst = json(&format!("{ARM} --worst-direction --region chest --force 280 --format json"));
    let slowest = number(&worst["reflected"]["speed"]);
    let list: String = (0..12)
        .map(|i| {
            let (a, b) = (f64::from(i), 0.7 * f64::from(i));
            format!(" --direction {},{},{}", a.cos() * b.sin(), a.sin() * b.sin(), b.cos())
        })
        .collect();
    let reports = json(&format!("{ARM} {list} --region chest --force 280 --format json"));
    let reports = reports.as_array().expect("a list");
    assert_eq!(reports.len(), 12);
    for report in reports {
        // Each mass has a relative error of about 1e-13.
        assert!(number(&report["reflected"]["speed"]) >= slowest * (1.0 - 1e-9), "{report}");
    }
    // The worst direction, given explicitly, has the same speed.
    let normal = worst["normal_world"].as_array().expect("a vector");
    let normal: Vec<String> = normal.iter().map(|x| number(x).to_string()).collect();
    let line = format!(
        "{ARM} --normal {} --normal-frame world --region chest --force 280 --format json",
        normal.join(",")
    );
    assert!((number(&json(&line)["reflected"]["speed"]) / slowest - 1.0).abs() < 1e-9);
    refused(
        &format!("{ARM} --worst-direction --normal 1,0,0 --region chest --force 280"),
        &["--worst-direction"],
    );
}

#[test]
fn the_slowest_row_of_a_path_counts() {
    let folder = Scratch::new("designs-path");
    let rows = [("0.1", "1.0"), ("-0.4", "0.5"), ("0.3", "1.9")];
    let table: String =
        rows.iter().map(|(shoulder, elbow)| format!("{shoulder},{elbow},0,0,0,0\n")).collect();
    let header = "shoulder,elbow,yaw,wrist_roll,wrist_pitch,tool_roll\n";
    let path = folder.write("path.csv", &format!("{header}{table}"));
    let contact = "safe-speed models/six_r_arm.urdf --link tool --point 0.08,0,0 --normal 0,0,1 --region chest --force 280 --load 2";
    let along = json(&format!("{contact} --input {path} --format json"));
    let speed = |(shoulder, elbow): &(&str, &str)| {
        let line = format!("{contact} --set shoulder={shoulder} --set elbow={elbow} --format json");
        number(&json(&line)["reflected"]["speed"])
    };
    let slowest = rows.iter().map(speed).fold(f64::INFINITY, f64::min);
    let found = number(&along["along"]["slowest"]["speed"]);
    assert!((found / slowest - 1.0).abs() < 1e-9, "{found} {slowest}");
    let row = usize::try_from(along["along"]["row"].as_u64().expect("a row")).expect("small");
    assert_eq!(speed(&rows[row]), slowest);
    assert_eq!((along["along"]["rows"].as_u64(), along["along"]["unanswered"].as_u64()), (Some(3), Some(0)));
    refused(&format!("{contact} --input {path} --worst-direction"), &["--worst-direction"]);
    refused(&format!("{contact} --input nowhere.csv"), &["--input", "nowhere.csv"]);
}
