//! `percuss kinematics --solve`: planted solutions, ranges, the changed sheet, messages.

use crate::support::{Scratch, done, run_in as run};
use serde_json::Value;

/// Report of a search.
fn search(folder: &Scratch, words: &[&str]) -> Value {
    let words = [&["kinematics", "car.toml", "--format", "json"], words].concat();
    serde_json::from_str(&done(folder, &words)).expect("JSON")
}

/// Value of a quantity of the sheet with moved hardpoints.
fn quantity(folder: &Scratch, name: &str, moves: &[String]) -> f64 {
    let mut words = vec!["kinematics", "car.toml", "--format", "json"];
    for by in moves {
        words.extend(["--move", by]);
    }
    let report: Value = serde_json::from_str(&done(folder, &words)).expect("JSON");
    report["rows"][0][name].as_f64().unwrap_or_else(|| panic!("{name} in {report}"))
}

/// Value with its unit for `--for`.
fn written(name: &str, value: f64) -> String {
    let unit = match name {
        "camber_gradient" | "toe_gradient" => return format!("{name}={}", value.to_degrees()),
        "caster" | "kingpin_inclination" | "side_view_angle" => "rad",
        "scrub_radius" | "roll_centre_height" => "m",
        _ => "",
    };
    format!("{name}={value}{unit}")
}

/// A coordinate is changed, and the value of a quantity there is the target: the search from the sheet finds a coordinate with
/// this value, and in a range that contains one solution the planted one.
#[test]
fn planted_solutions_are_found() {
    let cases = [
        ("double-wishbone", "upper_ball.z", "camber_gradient"),
        ("double-wishbone", "upper_front.z", "side_view_angle"),
        ("double-wishbone", "lower_ball.y", "scrub_radius"),
        ("double-wishbone", "tie_rod_inner.z", "toe_gradient"),
        ("macpherson-strut", "lower_ball.z", "roll_centre_height"),
        ("macpherson-strut", "strut_top.x", "caster"),
        ("pushrod-rocker", "rocker_back.z", "motion_ratio_spring"),
        ("pushrod-rocker", "pushrod_rocker.y", "motion_ratio_damper"),
        ("multi-link", "lateral_chassis.z", "roll_centre_height"),
        ("semi-trailing-arm", "arm_inner.x", "toe_gradient"),
        ("swing-axle", "pivot_front.z", "side_view_angle"),
    ];
    let folder = Scratch::new("search-planted");
    for (number, (template, unknown, name)) in cases.into_iter().enumerate() {
        folder.write("car.toml", &done(&folder, &["template", template]));
        let (point, axis) = unknown.split_once('.').expect("a coordinate");
        for planted in [3e-3, -7e-3 - 1e-4 * number as f64] {
            let mut shift = [0.0; 3];
            shift[["x", "y", "z"].iter().position(|known| *known == axis).expect("an axis")] = planted;
            let moves = [format!("{point}={},{},{}", shift[0], shift[1], shift[2])];
            let target = quantity(&folder, name, &moves);
            let report =
                search(&folder, &["--solve", unknown, "--for", &written(name, target), "--within", "12mm"]);
            let case = format!("{template} {unknown} {name} {planted}");
            assert_eq!(report["is_reached"], true, "{case}: {report}");
            let reached = report["targets"][0]["reached"].as_f64().expect("a value");
            // The accuracy of the search, 1e-8 of 1e-2, and the digits of the target.
            assert!((reached - target).abs() < 2e-10, "{case}: {reached}, {target}");
            let found = &report["coordinates"][0];
            let [old, new] = ["old", "new"].map(|key| found[key].as_f64().expect("a number"));
            // The quantities are monotonic in this range: the derivative is at least 0.01 per metre.
            assert!((1e-3 * (new - old) - planted).abs() < 1e-7, "{case}: {old} {new}");
            assert!(report["evaluations"].as_u64().expect("a count") < 60, "{case}: {report}");
        }
    }
}

#[test]
fn several_planted_coordinates_are_found_together() {
    let folder = Scratch::new("search-several");
    let cases: [(&str, &[&str], &[&str]); 3] = [
        ("double-wishbone", &["upper_ball.x", "lower_ball.y"], &["caster", "scrub_radius"]),
        (
            "double-wishbone",
            &["upper_ball.y", "tie_rod_inner.z", "upper_front.z"],
            &["roll_centre_height", "toe_gradient", "side_view_angle"],
        ),
        (
            "pushrod-rocker",
            &["rocker_back.z", "lower_ball.z"],
            &["motion_ratio_spring", "roll_centre_height"],
        ),
    ];
    for (template, unknowns, names) in cases {
        folder.write("car.toml", &done(&folder, &["template", template]));
        let planted: Vec<f64> = (0..unknowns.len()).map(|k| 4e-3 - 2.5e-3 * k as f64).collect();
        let moves: Vec<String> = unknowns
            .iter()
            .zip(&planted)
            .map(|(unknown, by)| {
                let (point, axis) = unknown.split_once('.').expect("a coordinate");
                let shift = ["x", "y", "z"].map(|known| if known == axis { *by } else { 0.0 });
                format!("{point}={},{},{}", shift[0], shift[1], shift[2])
            })
            .collect();
        let mut words = vec!["--within".to_owned(), "15mm".to_owned()];
        for (unknown, name) in unknowns.iter().zip(names) {
            let value = written(name, quantity(&folder, name, &moves));
            words.extend(["--solve".to_owned(), (*unknown).to_owned(), "--for".to_owned(), value]);
        }
        let report = search(&folder, &words.iter().map(String::as_str).collect::<Vec<_>>());
        assert_eq!(report["is_reached"], true, "{template} {names:?}: {report}");
        for (found, by) in report["coordinates"].as_array().expect("a list").iter().zip(&planted) {
            let [old, new] = ["old", "new"].map(|key| found[key].as_f64().expect("a number"));
            assert!((1e-3 * (new - old) - by).abs() < 1e-7, "{template} {names:?}: {report}");
        }
    }
}

/// Twenty cars with displaced hardpoints, and targets from a further displacement of two or three coordinates: the search finds this
/// displacement, and a second search of the first car of each kind gives the same report.
#[test]
fn planted_coordinates_of_twenty_cars_are_found_twice() {
    let folder = Scratch::new("search-family");
    let kinds: [(&str, &[&str], &[&str]); 4] = [
        ("double-wishbone", &["upper_ball.x", "lower_ball.y"], &["caster", "scrub_radius"]),
        (
            "pushrod-rocker",
            &["rocker_back.z", "lower_ball.z"],
            &["motion_ratio_spring", "roll_centre_height"],
        ),
        ("macpherson-strut", &["strut_top.x", "strut_top.y"], &["caster", "kingpin_inclination"]),
        (
            "double-wishbone",
            &["upper_ball.y", "tie_rod_inner.z", "upper_front.z"],
            &["roll_centre_height", "toe_gradient", "side_view_angle"],
        ),
    ];
    // Displacements of the sheet and of the planted coordinates: fractions of the golden ratio, in ±8 mm and ±4 mm.
    let fraction = |number: usize| (0.618_033_988_75 * number as f64).fract() - 0.5;
    let mut cars = 0;
    for (kind, (template, unknowns, names)) in kinds.into_iter().enumerate() {
        let text = done(&folder, &["template", template]);
        for car in 0..5 {
            let mut number = 100 * kind + 17 * car;
            let mut displaced = text.clone();
            for point in
                ["upper_front", "lower_front", "lower_ball", "tie_rod_outer", "strut_bottom", "rocker_pivot"]
            {
                let line = text.lines().find(|line| line.starts_with(&format!("{point} = ")));
                let Some(line) = line else { continue };
                let list = line.split(['[', ']']).nth(1).expect("a list");
                let moved: Vec<String> = list
                    .split(", ")
                    .map(|x| {
                        number += 1;
                        format!("{}", x.parse::<f64>().expect("a number") + 16.0 * fraction(number))
                    })
                    .collect();
                displaced = displaced.replace(line, &format!("{point} = [{}]", moved.join(", ")));
            }
            assert_ne!(displaced, text);
            folder.write("car.toml", &displaced);
            let planted: Vec<f64> =
                (0..unknowns.len()).map(|k| 8e-3 * fraction(number + 7 * k + 3)).collect();
            let moves: Vec<String> = unknowns
                .iter()
                .zip(&planted)
                .map(|(unknown, by)| {
                    let (point, axis) = unknown.split_once('.').expect("a coordinate");
                    let shift = ["x", "y", "z"].map(|known| if known == axis { *by } else { 0.0 });
                    format!("{point}={},{},{}", shift[0], shift[1], shift[2])
                })
                .collect();
            let mut words = vec!["--within".to_owned(), "15mm".to_owned()];
            for (unknown, name) in unknowns.iter().zip(names) {
                let value = written(name, quantity(&folder, name, &moves));
                words.extend(["--solve".to_owned(), (*unknown).to_owned(), "--for".to_owned(), value]);
            }
            let words: Vec<&str> = words.iter().map(String::as_str).collect();
            let report = search(&folder, &words);
            assert_eq!(report["is_reached"], true, "{template} {car}: {report}");
            if car == 0 {
                assert_eq!(report, search(&folder, &words), "{template}");
            }
            for (found, by) in report["coordinates"].as_array().expect("a list").iter().zip(&planted) {
                let [old, new] = ["old", "new"].map(|key| found[key].as_f64().expect("a number"));
                assert!((1e-3 * (new - old) - by).abs() < 1e-7, "{template} {car}: {by}: {report}");
            }
            cars += 1;
        }
    }
    assert_eq!(cars, 20);
}

/// A value out of reach: exit code 1, the nearest value and its coordinate; the extreme is at the end of the range.
#[test]
fn the_nearest_value_is_stated() {
    let folder = Scratch::new("search-nearest");
    folder.write("car.toml", &done(&folder, &["template", "pushrod-rocker"]));
    let words =
        "kinematics car.toml --solve rocker_back.z --for motion_ratio_spring=5 --within 10mm --format json";
    let outcome = run(&folder, &words.split(' ').collect::<Vec<_>>());
    assert!(
        outcome.code == 1 && outcome.stderr.contains("not reached within 10.00 mm"),
        "{}",
        outcome.stderr
    );
    let report: Value = serde_json::from_str(&outcome.stdout).expect("JSON");
    let found = &report["coordinates"][0];
    let [old, new] = ["old", "new"].map(|key| found[key].as_f64().expect("a number"));
    assert!(((new - old).abs() - 10.0).abs() < 0.01, "{report}");
    let [before, reached] =
        ["old", "reached"].map(|key| report["targets"][0][key].as_f64().expect("a value"));
    assert!((5.0 - reached).abs() < (5.0 - before).abs(), "{report}");
    assert!(report["evaluations"].as_u64().expect("a count") <= 400);
}

/// The changed sheet has the required value, keeps all other text, and describes the same points in any axes.
#[test]
fn the_changed_sheet_has_the_required_value() {
    let folder = Scratch::new("search-sheet");
    for axes in ["iso", "adams"] {
        let text = done(&folder, &["template", "double-wishbone", "--axes", axes, "--unit", "cm"]);
        folder.write("car.toml", &text);
        let words =
            "kinematics car.toml --solve upper_ball.z --for roll_centre_height=90mm -o new.toml --force";
        let shown = done(&folder, &words.split(' ').collect::<Vec<_>>());
        assert!(shown.contains("upper_ball.z, cm") && shown.contains("--move upper_ball=0,0,"), "{shown}");
        let changed = std::fs::read_to_string(folder.path("new.toml")).expect("a sheet");
        let lines = || text.lines().zip(changed.lines());
        assert_eq!(text.lines().count(), changed.lines().count());
        assert_eq!(lines().filter(|(old, new)| old != new).count(), 1, "{changed}");
        folder.write("car.toml", &changed);
        let height = quantity(&folder, "roll_centre_height", &[]);
        assert!((height - 0.09).abs() < 1e-10, "{axes}: {height}");
    }
}

/// A quantity of a contact names the contact: `bump_stop.motion_ratio` is the column `motion_ratio_bump_stop`, also with a side.
#[test]
fn a_required_value_names_its_contact() {
    let folder = Scratch::new("search-contact");
    let text = done(&folder, &["template", "pushrod-rocker"]);
    folder.write("car.toml", &text.replace("build = \"left\"", "build = \"both\""));
    let search = |required: &str| {
        let words =
            format!("kinematics car.toml --solve rocker_back.z --for {required} --within 10mm --format json");
        run(&folder, &words.split(' ').collect::<Vec<_>>())
    };
    for side in ["", "_left"] {
        let dotted = search(&format!("bump_stop{side}.motion_ratio=0.9"));
        assert_eq!(dotted.code, 0, "{}", dotted.stderr);
        assert_eq!(dotted.stdout, search(&format!("motion_ratio_bump_stop{side}=0.9")).stdout);
    }
    // Without a contact, the quantity is that of the spring.
    assert_eq!(search("motion_ratio=0.9").stdout, search("spring.motion_ratio=0.9").stdout);
    let words = "kinematics car.toml --solve rocker_bak.z --for motion_ratio=0.9 --within 10mm";
    let misspelled = run(&folder, &words.split(' ').collect::<Vec<_>>());
    assert!(misspelled.code == 2 && misspelled.stderr.contains("rocker_back"), "{}", misspelled.stderr);
    for (required, words) in [
        ("bump_stp.motion_ratio=0.9", &["did you mean", "motion_ratio_bump_stop"][..]),
        ("cambr=1deg", &["did you mean \"camber"]),
    ] {
        let outcome = search(required);
        assert_eq!(outcome.code, 2, "{required}");
        let told = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        words.iter().for_each(|word| assert!(told.contains(word), "{required}: {word} is not in {told}"));
    }
}

/// m̄ at the touch of a stop is a target, by hardpoints and by masses of links.
#[test]
fn planted_masses_are_found() {
    let folder = Scratch::new("search-masses");
    let mass = |changes: &[&str]| -> f64 {
        let words = [&["mass", "car.toml", "--at", "bump_stop", "--format", "json"], changes].concat();
        let report: Value = serde_json::from_str(&done(&folder, &words)).expect("JSON");
        report["effective_mass"].as_f64().expect("a mass")
    };
    for (template, unknown, change) in [
        ("double-wishbone", "upright.mass", ["--link-mass", "upright=4.1kg"]),
        ("double-wishbone", "bump_stop_pad.y", ["--move", "bump_stop_pad=0,6mm,0"]),
        ("multi-link", "spindle.mass", ["--link-mass", "spindle=5.5kg"]),
    ] {
        folder.write("car.toml", &done(&folder, &["template", template]));
        let target = mass(&change);
        let value = format!("bump_stop.mass={target}kg");
        let report = search(&folder, &["--solve", unknown, "--for", &value]);
        assert_eq!(report["is_reached"], true, "{report}");
        let found = &report["coordinates"][0];
        let new = found["new"].as_f64().expect("a number");
        let again = match unknown.strip_suffix(".mass") {
            Some(link) => mass(&["--link-mass", &format!("{link}={new}kg")]),
            None => {
                let by = new - found["old"].as_f64().expect("a number");
                mass(&["--move", &format!("bump_stop_pad=0,{by}mm,0")])
            }
        };
        // The accuracy of the search: 1e-8 of 1 kg.
        assert!((again - target).abs() < 1e-7, "{template} {unknown}: {again} {target}");
    }
    let refused = |words: &[&str], expected: &str| {
        let outcome = run(&folder, &[&["kinematics", "car.toml"], words].concat());
        assert_eq!(outcome.code, 2, "{}", outcome.stdout);
        assert!(outcome.stderr.contains(expected), "{}", outcome.stderr);
    };
    refused(&["--solve", "uprigt.mass", "--for", "bump_stop.mass=100kg"], "did you mean \"upright\"");
    refused(&["--solve", "upright.mass", "--for", "bump_stop.mass=100kg", "-o", "new.toml"], "--output");
    refused(&["--solve", "upright.mass", "--for", "bumpstop.mass=100kg"], "mass_bumpstop");
}

/// With the mass of the chassis, both kinds of base are stated, each as when it is asked for.
#[test]
fn both_bases_are_stated() {
    let folder = Scratch::new("search-bases");
    for template in ["double-wishbone", "macpherson-strut", "semi-trailing-arm", "five-link"] {
        let sheet = done(&folder, &["template", template]);
        folder.write(
            "car.toml",
            &format!("{sheet}\n[chassis]\nmass = 400\ncom = [0, 0, 400]\ninertia = [40, 200, 220]\n"),
        );
        let report = |base: &str| -> Value {
            let words = ["mass", "car.toml", "--at", "bump_stop", "--base", base, "--format", "json"];
            serde_json::from_str(&done(&folder, &words)).expect("JSON")
        };
        let [fixed, floating] = ["fixed", "floating"].map(report);
        for (own, other, name) in [(&fixed, &floating, "floating"), (&floating, &fixed, "fixed")] {
            assert_eq!(own["other_base"]["base"], name, "{template}");
            assert_eq!(own["other_base"]["effective_mass"], other["effective_mass"], "{template}");
            assert_eq!(
                own["other_base"]["effective_mass_error"], other["effective_mass_error"],
                "{template}"
            );
        }
        let text = done(&folder, &["mass", "car.toml", "--at", "bump_stop"]);
        assert!(text.contains("chassis free"), "{text}");
    }
    folder.write("car.toml", &done(&folder, &["template", "double-wishbone"]));
    let words = ["mass", "car.toml", "--at", "bump_stop", "--format", "json"];
    let report: Value = serde_json::from_str(&done(&folder, &words)).expect("JSON");
    assert!(report["other_base"].is_null(), "{report}");
}

/// At the coordinate found for a peak force, or for a compression, `percuss mass` states that value.
#[test]
fn peak_forces_and_compressions_are_those_of_the_damper() {
    let folder = Scratch::new("search-peak-force");
    let curve = "[bump_stop]\ndeflections = [0, 10, 20, 30]\nforces = [0, 300, 1500, 4000]\n";
    folder
        .write("car.toml", &done(&folder, &["template", "double-wishbone"]).replace("[bump_stop]\n", curve));
    let impact = ["--speed", "1m/s", "--restitution", "0.3"];
    for (target, key) in
        [("bump_stop.peak_force=5.9kN", "peak_force"), ("bump_stop.compression=26.8mm", "max_penetration")]
    {
        let words = [&["--solve", "bump_stop.z", "--for", target, "--within", "40mm"], &impact[..]].concat();
        let report = search(&folder, &words);
        let by: Vec<String> =
            report["moves"][0][1].as_array().expect("a move").iter().map(Value::to_string).collect();
        let shift = format!("bump_stop={}", by.join(","));
        let words = ["mass", "car.toml", "--at", "bump_stop", "--move", &shift, "--format", "json"];
        let mass: Value =
            serde_json::from_str(&done(&folder, &[&words[..], &impact].concat())).expect("JSON");
        let required = report["targets"][0]["required"].as_f64().expect("a number");
        let found = mass["damper"][key].as_f64().unwrap_or_else(|| panic!("{key} in {mass}"));
        assert!((found / required - 1.0).abs() < 1e-6, "{key}: {found} {required}");
    }
    let words = ["kinematics", "car.toml", "--solve", "bump_stop.z", "--for", "bump_stop.peak_force=5kN"];
    assert!(run(&folder, &words).stderr.contains("missing: --speed"));
}
