//! `percuss import`: usable models from all templates, flags, refusals. The hardpoints are invented round values.

use crate::support::{Outcome, Scratch, json, percuss, percuss_with_stdin, root};

const SPINDLE: &str = r#""Spindle": {"Mass": 2, "COM": [0, 0.9, -0.02], "Inertia": [0.02, 0.03, 0.025]}, "Axle": {"Inertia": 0.01}"#;
const UPRIGHT: &str = r#""Upright": {"Mass": 3, "COM": [0.01, 0.8, 0], "Inertia": [0.05, 0.04, 0.03]}"#;
const TIE_ROD: &str =
    r#""Tierod": {"Location Chassis": [-0.2, 0.4, 0.02], "Location Upright": [-0.15, 0.8, -0.03]}"#;

/// Wishbone with its mass properties in all notations, and its points.
fn wishbone(name: &str, z: f64, tip: &str) -> String {
    format!(
        r#""{name}": {{"Mass": 2, "COM": [0, 0.6, {z}], "Inertia": [0.1, 0.1, 0.15], "Moments of Inertia": [0.1, 0.1, 0.15],
        "Products of Inertia": [0, 0, 0], "Location Chassis Front": [0.2, 0.4, {z}], "Location Chassis Back": [-0.2, 0.42, {z}],
        "Location Upright": {tip}}}"#
    )
}

/// Spring and shock absorber, with the lower seats on the given body.
fn seats(body: &str) -> String {
    let one = |name| {
        format!(
            r#""{name}": {{"Location Chassis": [0.05, 0.55, 0.35], "Location {body}": [0.06, 0.62, -0.1]}}"#
        )
    };
    format!("{}, {}", one("Spring"), one("Shock"))
}

/// Sections of a template; unknown keys only give warnings.
fn sections(template: &str) -> Vec<String> {
    let upright_of_wishbones =
        UPRIGHT.replace("\"Inertia\"", "\"Products of Inertia\": [0, 0, 0], \"Moments of Inertia\"");
    let upper = wishbone("Upper Control Arm", 0.2, "[-0.03, 0.75, 0.22]");
    let lower = wishbone("Lower Control Arm", -0.1, "[0.01, 0.82, -0.16]");
    let fixed = |texts: &[&str]| texts.iter().map(|t| (*t).to_owned()).collect::<Vec<_>>();
    let trailing_arm = r#""Trailing Arm": {"Mass": 5, "COM": [0.25, 0.7, 0], "Inertia": [0.06, 0.05, 0.1],
        "Location Chassis Outer": [0.5, 0.85, 0.02], "Location Chassis Inner": [0.4, 0.5, -0.03],
        "Location Chassis": [0.7, 0.8, 0.03], "Location Spindle": [0, 0.8, 0]}"#;
    match template {
        "DoubleWishbone" => fixed(&[SPINDLE, &upright_of_wishbones, TIE_ROD, &upper, &lower, &seats("Arm")]),
        "DoubleWishboneReduced" => fixed(&[SPINDLE, UPRIGHT, TIE_ROD, &upper, &lower, &seats("Upright")]),
        "MacPhersonStrut" => fixed(&[
            SPINDLE,
            UPRIGHT,
            TIE_ROD,
            &wishbone("Control Arm", -0.1, "[0.01, 0.82, -0.16]"),
            r#""Strut": {"Mass": 2.5, "Inertia": [0.02, 0.021, 0.004]}"#,
            &seats("Upright"),
        ]),
        "SemiTrailingArm" => fixed(&[SPINDLE, trailing_arm, &seats("Arm")]),
        "ThreeLinkIRS" => {
            let link = |name: &str, z: f64| {
                format!(
                    r#""{name} Link": {{"Mass": 1, "COM": [-0.05, 0.5, {z}], "Inertia": [0.002, 0.02, 0.021],
                    "Location Chassis": [-0.06, 0.25, {z}], "Location Arm": [-0.05, 0.8, {z}], "Universal Joint Axis": [1, 0, 0]}}"#
                )
            };
            fixed(&[SPINDLE, trailing_arm, &link("Upper", 0.2), &link("Lower", -0.1), &seats("Arm")])
        }
        "MultiLink" => {
            let link = |name: &str, chassis: &str, upright: &str, axis: &str| {
                format!(
                    r#""{name}": {{"Mass": 1.5, "COM": [0.1, 0.6, -0.1], "Inertia": [0.04, 0.041, 0.01], "Location Chassis": {chassis},
                    "Location Upright": {upright}, "Universal Joint Axis Link": [0, 0, 1], "Universal Joint Axis Chassis": {axis}}}"#
                )
            };
            fixed(&[
                SPINDLE,
                UPRIGHT,
                TIE_ROD,
                &wishbone("Upper Arm", 0.1, "[0.04, 0.82, 0.15]"),
                &link("Lateral", "[0.02, 0.35, -0.1]", "[0.02, 0.8, -0.1]", "[1, 0, 0]"),
                &link("Trailing Link", "[0.7, 0.83, -0.15]", "[0, 0.83, -0.15]", "[0, 1, 0]"),
                &seats("Link"),
            ])
        }
        other => panic!("no such template: {other}"),
    }
}

fn hardpoints(template: &str) -> String {
    format!(
        r#"{{"Name": "test", "Type": "Suspension", "Template": "{template}", {}}}"#,
        sections(template).join(",\n")
    )
}

const TEMPLATES: [&str; 6] = [
    "DoubleWishbone",
    "DoubleWishboneReduced",
    "MacPhersonStrut",
    "SemiTrailingArm",
    "ThreeLinkIRS",
    "MultiLink",
];

fn import(text: &str, flags: &str) -> Outcome {
    percuss_with_stdin(&format!("import - -o - {flags}"), text.as_bytes())
}

/// m̄ of an imported model at the moving seat, along the line to the chassis seat.
fn at_the_shock(model: &str, ending: &str) -> f64 {
    let line = format!(
        "mass - --link shock_seat{ending} --point 0,0,0 --along-line shock_chassis_seat{ending}:0,0,0 --format json"
    );
    let outcome = percuss_with_stdin(&line, model.as_bytes());
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let report: serde_json::Value = serde_json::from_str(&outcome.stdout).expect("JSON");
    report["effective_mass"].as_f64().unwrap_or_else(|| panic!("{report}"))
}

#[test]
fn every_template_becomes_a_model_that_answers_on_either_side_and_both() {
    let folder = Scratch::new("import-templates");
    for template in TEMPLATES {
        let file = folder.write("corner.json", &hardpoints(template));
        let mut masses = Vec::new();
        for (side, endings) in [("left", &[""][..]), ("right", &[""]), ("both", &["_left", "_right"])] {
            let model = folder.path(&format!("{template}_{side}.urdf"));
            let outcome = percuss(&format!("import {file} -o {model} --side {side}"));
            assert_eq!(outcome.code, 0, "{template} {side}: {}", outcome.stderr);
            for words in ["read in", "axes iso", "track", "mass, kg"] {
                assert!(outcome.stdout.contains(words), "{template} {side}: {words}: {}", outcome.stdout);
            }
            assert!(outcome.stderr.contains("no wheel is given"), "{}", outcome.stderr);
            let check = json(&format!("check {model} --format json"));
            let sides = endings.len() as u64;
            assert_eq!(
                check["degrees_of_freedom"].as_u64(),
                Some(2 * sides),
                "{template} {side}: travel and spin"
            );
            assert_eq!(check["redundant_constraints"], 0, "{template} {side}");
            let text = std::fs::read_to_string(&model).unwrap();
            assert!(
                text.contains("corner.json") && text.contains(template),
                "the comment names source and template"
            );
            masses.extend(endings.iter().map(|ending| at_the_shock(&text, ending)));
        }
        // All four corners are mirror images, and the sides are not coupled on a fixed chassis.
        for mass in &masses {
            assert!((mass / masses[0] - 1.0).abs() < 1e-11, "{template}: {masses:?}");
        }
    }
}

#[test]
fn a_wheel_weighs_on_the_spindle() {
    for template in TEMPLATES {
        let text = hardpoints(template);
        let bare = at_the_shock(&import(&text, "").stdout, "");
        let outcome = import(&text, "--wheel-mass 20kg --wheel-inertia 0.5,0.9,0.5 --wheel-radius 300mm");
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        assert!(!outcome.stderr.contains("no wheel"), "{}", outcome.stderr);
        let heavy = at_the_shock(&outcome.stdout, "");
        assert!(heavy > 1.2 * bare, "{template}: {bare} {heavy}");
        assert!(outcome.stdout.contains("<link name=\"contact_patch\"/>"));
        let point_mass = import(&text, "--wheel-mass 20000g").stdout;
        assert!(!point_mass.contains("contact_patch"));
        assert!(at_the_shock(&point_mass, "") < heavy && at_the_shock(&point_mass, "") > bare, "{template}");
    }
}

/// A sliding rack adds one degree of freedom; locked, it equals the fixed rack.
#[test]
fn a_rack_slides_where_it_is_asked_to() {
    let text = hardpoints("MacPhersonStrut");
    let (fixed, sliding) = (import(&text, "").stdout, import(&text, "--rack-mass 3").stdout);
    let freedom = |model: &str| {
        let outcome = percuss_with_stdin("check - --format json", model.as_bytes());
        serde_json::from_str::<serde_json::Value>(&outcome.stdout).unwrap()["degrees_of_freedom"]
            .as_u64()
            .unwrap()
    };
    assert_eq!((freedom(&fixed), freedom(&sliding)), (2, 3));
    let line = "mass - --link shock_seat --point 0,0,0 --along-line shock_chassis_seat:0,0,0 --lock rack --tolerance 1e-11 --expect";
    let locked = percuss_with_stdin(&format!("{line} {}", at_the_shock(&fixed, "")), sliding.as_bytes());
    assert_eq!(locked.code, 0, "{}", locked.stderr);
    assert!(at_the_shock(&sliding, "") < at_the_shock(&fixed, ""));
    let none = import(&hardpoints("SemiTrailingArm"), "--rack-mass 3");
    assert_eq!(none.code, 0);
    assert!(none.stderr.contains("rack"), "{}", none.stderr);
}

#[test]
fn errors_in_a_file_are_reported() {
    let good = hardpoints("DoubleWishbone");
    let cases = [
        (good.replace("\"Location Chassis Front\"", "\"Location Front\""), 2, "Location Chassis Front"),
        (good.replace("\"Spindle\"", "\"Spindel\""), 2, "Spindle"),
        (good.replace("\"Name\": \"test\", ", ""), 2, "Name"),
        (good.replace("DoubleWishbone", "TripleWishbone"), 2, "TripleWishbone"),
        (good.replace("\"Suspension\"", "\"Tire\""), 2, "Tire"),
        (good.replace("[0, 0.9, -0.02]", "[0, 0.9]"), 2, "COM"),
        (good.replace("[0, 0.9, -0.02]", "\"here\""), 2, "COM"),
        (good.replace("[0, 0.9, -0.02]", "[0, 1e999, 0]"), 2, ""),
        (good.replace("\"Mass\": 2,", "\"Mass\": -2,"), 2, "ass"),
        // A wishbone with coincident hinge points.
        (good.replace("[-0.2, 0.42, 0.2]", "[0.2, 0.4, 0.2]"), 2, "Upper Control Arm"),
        ("<robot/>".into(), 2, "JSON"),
        (String::new(), 2, "JSON"),
        ("[1, 2]".into(), 2, ""),
        (good[..good.len() / 2].to_owned(), 2, "JSON"),
        ("[".repeat(100_000), 2, ""),
        // Implausible contents, and readable files with unknown keys or comments.
        (good.replace("[0, 0.9, -0.02]", "[0, 900, -20]"), 2, "--unit mm"),
        (good.replace("\"Name\"", "\"Colour\": \"red\", \"Name\""), 0, "Colour"),
        (good.replace("\"Name\"", "// a comment\n\"Name\""), 0, "no wheel"),
    ];
    for (text, code, words) in cases {
        let start: String = text.chars().take(200).collect();
        let outcome = import(&text, "");
        assert_eq!(outcome.code, code, "{start}\n{}", outcome.stderr);
        assert!(outcome.stderr.contains(words), "{start}\n{words} is missing in {}", outcome.stderr);
        assert!(!outcome.stderr.contains("panicked"), "{}", outcome.stderr);
        assert_eq!(outcome.stdout.is_empty(), code != 0, "{start}");
    }
    // A missing key is reported with its path and the file.
    let folder = Scratch::new("import-refusals");
    let file =
        folder.write("corner.json", &good.replace("\"Location Chassis Front\": [0.2, 0.4, -0.1],", ""));
    let outcome = percuss(&format!("import {file} -o {}", folder.path("model.urdf")));
    assert_eq!(outcome.code, 2);
    for words in ["corner.json", "Lower Control Arm", "Location Chassis Front"] {
        assert!(outcome.stderr.contains(words), "{words}: {}", outcome.stderr);
    }
    assert!(!std::path::Path::new(&folder.path("model.urdf")).exists());
}

#[test]
fn flags_that_mean_nothing_are_refused() {
    let good = hardpoints("DoubleWishbone");
    let cases = [
        ("--wheel-mass 0", "above 0"),
        ("--wheel-mass -3", ""),
        ("--wheel-mass 3m", "mass"),
        ("--wheel-inertia 1,1,1", "--wheel-mass"),
        ("--wheel-mass 3 --wheel-inertia 1,1", "expected 3"),
        ("--wheel-mass 3 --wheel-inertia 1,-1,1", ""),
        ("--wheel-radius 0.3", "--wheel-mass"),
        ("--wheel-mass 3 --wheel-radius 0", "above 0"),
        ("--rack-mass nan", "finite"),
        ("--side front", "left, right, both"),
        ("--max-size 10", "larger than the limit"),
        ("--strict", "no wheel"),
    ];
    for (flags, words) in cases {
        let outcome = import(&good, flags);
        assert_eq!(outcome.code, 2, "{flags}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(words), "{flags}: {}", outcome.stderr);
        assert_eq!(outcome.stdout, "", "{flags}");
    }
    assert_eq!(percuss("import nothing.json -o -").code, 2);
    let folder = Scratch::new("import-output");
    let file = folder.write("corner.json", &good);
    let nowhere = percuss(&format!("import {file} -o {}", folder.path("none/model.urdf")));
    assert_eq!(nowhere.code, 2);
    assert!(nowhere.stderr.contains("cannot be written"), "{}", nowhere.stderr);
    assert_eq!(percuss(&format!("import {file}")).code, 2, "an output is required");
}

/// The file in Chrono's format describes the car of the sheet, except for the anti-roll bar, which the format
/// lacks.
#[test]
fn the_shipped_file_of_chrono_is_the_car_of_the_sheet() {
    let folder = Scratch::new("import-chrono");
    let text =
        std::fs::read_to_string(root().join("models/suspensions/double-wishbone.toml")).expect("a sheet");
    let mut is_bar = false;
    let without: Vec<&str> = text
        .lines()
        .filter(|line| {
            if line.starts_with('[') {
                is_bar = ["[anti_roll_bar]", "[drop_link]"].contains(line);
            }
            !is_bar && !line.starts_with("anti_roll_bar") && !line.starts_with("drop_link")
        })
        .collect();
    let sheet = folder.write("my.toml", &(without.join("\n") + "\n"));
    let (of_sheet, of_chrono) = (folder.path("sheet.urdf"), folder.path("chrono.urdf"));
    let wheel = "--wheel-mass 18.5kg --wheel-inertia 0.62,1.05,0.62 --wheel-radius 0.3";
    let file = "models/suspensions/double-wishbone-chrono.json";
    for side in ["left", "both"] {
        let ending = if side == "left" { "" } else { "_right" };
        for line in [
            format!("import {sheet} -o {of_sheet} --side {side} --strict"),
            format!("import {file} -o {of_chrono} --side {side} {wheel} --strict"),
        ] {
            let outcome = percuss(&line);
            assert_eq!(outcome.code, 0, "{line}: {}", outcome.stderr);
        }
        let mass = |model: &str, contact: &str| {
            let report = json(&format!("mass {model} {contact} --format json"));
            report["effective_mass"].as_f64().unwrap_or_else(|| panic!("{contact}: {report}"))
        };
        for (seat, above) in [("spring_seat", "spring_chassis_seat"), ("contact_patch", "wheel_centre")] {
            let contact = format!(
                "--link {seat}{ending} --point 0,0,0 --along-line {above}{ending}:0,0,0 --against chassis"
            );
            let (a, b) = (mass(&of_sheet, &contact), mass(&of_chrono, &contact));
            // The same values are in mm in one file and in m in the other: they differ by roundings of 1e-16, and m̄
            // by some hundred times as much.
            assert!((a / b - 1.0).abs() < 1e-12, "{side} {seat}: {a} {b}");
        }
    }
}
