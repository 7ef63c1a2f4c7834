//! Contact patches over the motion of a wheel, stops beyond their touch, and pins of universal joints.

use crate::support::{Scratch, Sweep, json, percuss, refused, root};
use serde_json::Value;
use std::process::Command;

const SWING_ARM: &str = "models/suspensions/swing-arm.toml";
const SEMI_TRAILING: &str = "models/suspensions/semi-trailing-arm.toml";

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// The lowest point of a wheel is another material point at each pose: generated code follows it.
#[test]
fn generated_code_follows_the_lowest_point() {
    for sheet in [SWING_ARM, SEMI_TRAILING] {
        let folder = Scratch::new(&format!("patch-{}", sheet.len()));
        let output = folder.path("code");
        let outcome =
            percuss(&format!("generate {sheet} --at contact_patch --name car --gradient -o {output}"));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        let header = std::fs::read_to_string(format!("{output}/car.h")).expect("a header");
        let text = header + &std::fs::read_to_string(format!("{output}/car.c")).expect("the code");
        assert!(text.contains("lowest point of the wheel"), "{text}");
        let input = |line: &str| {
            let (index, rest) = line.split_once("q[")?.1.split_once(']')?;
            Some((index.parse::<usize>().ok()?, rest.split('"').nth(1)?.to_owned()))
        };
        let mut joints: Vec<(usize, String)> = text.lines().filter_map(input).collect();
        joints.sort();
        joints.dedup();
        let mut expected = Vec::new();
        let mut program =
            String::from("#include <stdio.h>\n#include \"car.h\"\nint main(void) {\n double m;\n");
        for travel in ["-50mm", "0mm", "60mm"] {
            let report =
                json(&format!("mass {sheet} --at contact_patch --wheel-travel {travel} --format json"));
            let q = |joint: &String| number(&report["pose"][joint][0]).to_string();
            let q: Vec<String> = joints.iter().map(|(_, joint)| q(joint)).collect();
            program += &format!(
                " {{ const double q[] = {{{}}}; int s = car_mass(q, &m); printf(\"%d %.17g\\n\", s, m); }}\n",
                q.join(", ")
            );
            expected.push((number(&report["effective_mass"]), number(&report["contact"]["point_link"][0])));
        }
        // The point moves on the wheel by centimetres.
        assert!((expected[0].1 - expected[2].1).abs() > 0.01, "{expected:?}");
        std::fs::write(format!("{output}/main.c"), program + " return 0;\n}\n").expect("a program");
        let compiled = Command::new("cc")
            .args(["-O1", "car.c", "main.c", "-lm", "-o", "main"])
            .current_dir(&output)
            .output()
            .expect("a C compiler");
        assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
        let run = Command::new(format!("{output}/main")).output().expect("the program runs");
        let run = String::from_utf8(run.stdout).expect("text");
        for (line, (mass, _)) in run.lines().zip(&expected) {
            let (status, found) = line.split_once(' ').expect("two numbers");
            let found: f64 = found.parse().expect("a number");
            // The stated error of the code's samples is 1e-9.
            assert!(status == "0" && (found / mass - 1.0).abs() < 1e-9, "{sheet}: {line}, {mass}");
        }
        assert_eq!(run.lines().count(), expected.len(), "{run}");
    }
}

/// The extremes over the range of an arm are those of the sweep, in which the contact point is the lowest one of each row.
#[test]
fn extremes_follow_the_lowest_point() {
    for (sheet, arm) in [(SWING_ARM, "swing_arm_hinge"), (SEMI_TRAILING, "anti_roll_bar_hinge")] {
        let range = "-0.25:0.3";
        let found = json(&format!("extremes {sheet} --at contact_patch --range {arm}={range} --format json"));
        let sweep = percuss(&format!("sweep {sheet} --at contact_patch --vary {arm}={range}:401"));
        let sweep = Sweep::read(&sweep.stdout);
        let masses: Vec<f64> =
            (0..401).map(|row| sweep.number(row, "effective_mass").expect("finite")).collect();
        let least = masses.iter().copied().fold(f64::INFINITY, f64::min);
        let most = masses.iter().copied().fold(0.0, f64::max);
        for (key, of_sweep, sign) in [("least", least, 1.0), ("most", most, -1.0)] {
            let value = number(&found[key]["effective_mass"]);
            // The grid misses an interior extreme by the square of its step.
            assert!((value / of_sweep - 1.0).abs() < 1e-5, "{sheet} {key}: {value}, {of_sweep}");
            assert!(sign * (value - of_sweep) <= 1e-9 * of_sweep, "{sheet} {key}: {value}, {of_sweep}");
            assert!(number(&found[key]["residual"]) < 1e-6, "{sheet} {key}: {found}");
        }
        // A point fixed to the wheel as drawn has other extremes.
        let drawn = json(&format!("mass {sheet} --at contact_patch --format json"));
        let point: Vec<String> =
            (0..3).map(|k| number(&drawn["contact"]["point_link"][k]).to_string()).collect();
        let normal: Vec<String> =
            (0..3).map(|k| number(&drawn["contact"]["normal_world"][k]).to_string()).collect();
        let link = drawn["contact"]["link"].as_str().expect("a link");
        let fixed = json(&format!(
            "extremes {sheet} --link {link} --point {} --normal {} --normal-frame world --range {arm}={range} --format json",
            point.join(","),
            normal.join(",")
        ));
        let difference =
            number(&fixed["most"]["effective_mass"]) / number(&found["most"]["effective_mass"]) - 1.0;
        assert!(difference.abs() > 1e-4, "{sheet}: {difference}");
    }
}

/// Pins of a universal joint that a sheet does not state are noted once, and `pin` states them.
#[test]
fn assumed_pins_are_noted() {
    let text = std::fs::read_to_string(root().join("models/suspensions/multi-link.toml")).expect("the sheet");
    let folder = Scratch::new("assumed-pins");
    let sheet = |name: &str, pin: &str| {
        let stated = text.replacen("mass = 3.4\n", &format!("mass = 3.4\n{pin}\n"), 1);
        assert_ne!(stated, text);
        folder.write(name, &stated)
    };
    let plain = sheet("plain.toml", "");
    let noted = percuss(&format!("mass {plain} --at bump_stop --notes"));
    assert_eq!(noted.stderr.matches("are assumed").count(), 1, "{}", noted.stderr);
    assert!(noted.stderr.contains("trailing_link.pin = [x, y, z]"), "{}", noted.stderr);
    // The slender rods have no inertia about their line.
    assert!(!noted.stderr.contains("lateral") && !noted.stderr.contains("tie_rod"), "{}", noted.stderr);
    let mass =
        |sheet: &str| number(&json(&format!("mass {sheet} --at bump_stop --format json"))["effective_mass"]);
    // The assumed pin, normal to the link and to x: (x × l) with l from (520, 560, 250) to (50, 700, 180).
    let same = sheet("same.toml", "pin = [0.0, 70.0, 140.0]");
    assert!((mass(&same) / mass(&plain) - 1.0).abs() < 1e-12);
    let quiet = percuss(&format!("mass {same} --at bump_stop --notes"));
    assert!(!quiet.stderr.contains("are assumed"), "{}", quiet.stderr);
    let other = sheet("other.toml", "pin = [0.3, 1.0, 0.0]");
    let change = mass(&other) / mass(&plain) - 1.0;
    assert!(change.abs() > 1e-4 && change.abs() < 0.02, "{change}");
    let parallel = sheet("parallel.toml", "pin = [-470.0, 140.0, -70.0]");
    refused(&format!("mass {parallel} --at bump_stop"), &["trailing_link.pin", "parallel to the link"]);
    let unknown =
        folder.write("unknown.toml", &text.replacen("mass = 1.8\n", "mass = 1.8\npin = [1, 0, 0]\n", 1));
    refused(&format!("mass {unknown} --at bump_stop"), &["upper_arm.pin"]);
}

/// The rack of a steered axle moves in an impact; the motion ratio is that with the rack held, the slope of the gap.
#[test]
fn the_motion_ratio_of_a_steered_axle_holds_the_rack() {
    let folder = Scratch::new("steered");
    for (name, build) in [("left", "left"), ("both", "both")] {
        let text = std::fs::read_to_string(root().join("models/suspensions/double-wishbone.toml"))
            .expect("the sheet");
        let text = text.replace("slides = false", "slides = true");
        let text = text.replacen("build = \"left\"", &format!("build = \"{build}\""), 1);
        let sheet = folder.write(&format!("{name}.toml"), &text);
        let (contact, motion) =
            if build == "both" { ("spring_left", "heave") } else { ("spring", "wheel-travel") };
        let ratios = |flags: &str| {
            let report = json(&format!("mass {sheet} --at {contact} {flags} --format json"));
            report["motion_ratios"].as_array().expect("a list").clone()
        };
        let (held, locked) = (ratios(""), ratios("--lock rack"));
        assert!(!held.is_empty() && held.len() == locked.len(), "{held:?} {locked:?}");
        for (held, locked) in held.iter().zip(&locked) {
            assert_eq!((&held["held"], &locked["held"]), (&Value::from("rack"), &Value::Null));
            let [a, b] = [held, locked].map(|ratio| number(&ratio["contact_per_wheel"]));
            assert!((a / b - 1.0).abs() < 1e-10, "{a} {b}");
        }
        let words = |line: String| {
            let outcome = percuss(&line);
            outcome.stdout.split_whitespace().collect::<Vec<_>>().join(" ")
        };
        let text = words(format!("mass {sheet} --at {contact}"));
        assert!(text.contains("with the joint rack held"), "{text}");
        let list = words(format!("mass {sheet} --at all"));
        assert!(list.contains("with the joint rack held") && !list.contains("--lock rack"), "{list}");
        // The slope of the gap of the stop at the touch, from poses alone.
        let stop = if build == "both" { "bump_stop_left" } else { "bump_stop" };
        let touch = json(&format!("mass {sheet} --at {stop} --format json"));
        let at = number(&touch["named_contact"]["wheel_travel"][0]["travel"]);
        let ratio = number(&touch["motion_ratios"][0]["contact_per_wheel"]);
        let gap = |travel: f64| {
            let flags = format!("--{motion} {travel} --lock rack --format json");
            number(&json(&format!("mass {sheet} --at {stop} {flags}"))["named_contact"]["gap"])
        };
        let h = 1e-4;
        let slope = (gap(at - h) - gap(at + h)) / (2.0 * h);
        // The third derivative of the gap is below 1e2 / m², so that the difference quotient is exact to 1e-6.
        assert!((ratio / slope - 1.0).abs() < 1e-6, "{build}: {ratio} {slope}");
    }
}

/// The motion ratio of a contact patch is per travel of the wheel centre, with a fixed and with a sliding rack: the slope of the height of
/// the lowest point, a central difference.
#[test]
fn the_ratio_of_a_contact_patch_is_per_travel_of_the_centre() {
    let folder = Scratch::new("patch-ratio");
    let sheet =
        std::fs::read_to_string(root().join("models/suspensions/double-wishbone.toml")).expect("a sheet");
    let sheet = sheet
        .replace("camber = \"0 deg\"", "camber = \"-4 deg\"")
        .replace("toe = \"0 deg\"", "toe = \"1 deg\"");
    let sliding = sheet.replace("slides = false", "slides = true");
    assert_ne!(sheet, sliding);
    for (name, text) in [("fixed.toml", &sheet), ("sliding.toml", &sliding)] {
        folder.write(name, text);
        let path = folder.path(name);
        let report = |flags: &str| json(&format!("mass {path} --at contact_patch {flags} --format json"));
        let rack = if name == "sliding.toml" { "--set rack=0" } else { "" };
        let height = |travel: &str| {
            number(&report(&format!("{rack} --wheel-travel {travel}"))["contact"]["point_world"][2])
        };
        let slope = (height("0.1mm") - height("-0.1mm")) / 2e-4;
        let ratios = report("")["motion_ratios"].clone();
        assert_eq!(ratios[0]["link"], "wheel_centre", "{name}: {ratios}");
        let ratio = number(&ratios[0]["contact_per_wheel"]);
        // Error of the difference: the square of the travel times the third derivative.
        assert!((ratio + slope).abs() < 1e-6 && (slope - 1.0).abs() > 1e-4, "{name}: {ratio}, {slope}");
        assert_eq!(ratios[0]["held"].is_null(), name == "fixed.toml", "{ratios}");
    }
}
