//! Several named contacts in one comparison: each equals its own command.

use crate::support::{Scratch, Sweep, json, percuss, refused};
use serde_json::Value;

const SHEET: &str = "models/suspensions/double-wishbone.toml";
const RANGE: &str = "--wheel-travel -30mm:30mm:7";

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

#[test]
fn several_contacts_of_a_sheet_are_each_what_mass_and_sweep_say() {
    let folder = Scratch::new("several-contacts");
    let report = json(&format!("compare {SHEET} --at bump_stop,spring {RANGE} --format json"));
    for (i, contact) in ["bump_stop", "spring"].into_iter().enumerate() {
        let design = &report["designs"][i];
        assert_eq!((&design["name"], &design["contact"]), (&contact.into(), &contact.into()));
        assert_eq!((&design["reference"], &design["difference_percent"]), (&Value::Null, &Value::Null));
        let mass = json(&format!("mass {SHEET} --at {contact} --format json"));
        assert_eq!(design["effective_mass"], mass["effective_mass"]);
        assert_eq!(design["motion_ratio"], mass["motion_ratios"][0]["contact_per_wheel"]);
        let sweep = Sweep::read(&percuss(&format!("sweep {SHEET} --at {contact} {RANGE}")).stdout);
        for row in 0..7 {
            let compared = &report["rows"][row];
            assert_eq!(compared["effective_mass"][i].as_f64(), sweep.number(row, "effective_mass"));
            assert_eq!(compared["motion_ratio"][i].as_f64(), sweep.number(row, "motion_ratio"));
            assert!(compared["motion_ratio"][i].is_number(), "{compared}");
        }
    }
    // The table and the figure show the motion ratios beside the masses.
    let (csv, svg) = (folder.path("both.csv"), folder.path("both.svg"));
    for output in [&csv, &svg] {
        let outcome = percuss(&format!("compare {SHEET} --at bump_stop,spring {RANGE} --output {output}"));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    }
    let table = Sweep::read(&std::fs::read_to_string(csv).expect("a table"));
    assert_eq!(table.number(2, "spring motion_ratio"), report["rows"][2]["motion_ratio"][1].as_f64());
    let drawn = std::fs::read_to_string(svg).expect("a figure");
    assert!(
        drawn.contains("motion ratio, contact per wheel travel") && !drawn.contains("difference"),
        "{drawn}"
    );
    // All contacts are those that the table of mass lists, in its order.
    let listed = json(&format!("mass {SHEET} --at all --format json"));
    let all = json(&format!("compare {SHEET} --at all --format json"));
    let names = |report: &Value, list: &str, key: &str| -> Vec<Value> {
        report[list].as_array().expect("a list").iter().map(|item| item[key].clone()).collect()
    };
    assert_eq!(names(&all, "designs", "contact"), names(&listed, "contacts", "name"));
    refused(&format!("compare {SHEET} --at bump_stop,sprnig"), &["spring"]);
    refused(&format!("compare {SHEET} --at spring"), &["bump_stop,spring"]);
}

/// Figures over the travel of the wheel mark the touch of a stop; curves that coincide are one curve with both names.
#[test]
fn figures_mark_the_touch_and_name_coinciding_curves() {
    let folder = Scratch::new("touch-marks");
    let svg = folder.path("touch.svg");
    let drawn = |words: &str| {
        let outcome = percuss(&format!("{words} --output {svg} --force"));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        std::fs::read_to_string(&svg).expect("a figure")
    };
    // The bump stop touches at 61.17 mm.
    let marks = |to: &str| {
        drawn(&format!("sweep {SHEET} --at bump_stop --wheel-travel -20mm:{to}:9")).matches(">touch<").count()
    };
    assert_eq!((marks("80mm"), marks("60mm")), (1, 0));
    let compared = drawn(&format!("compare {SHEET} --at bump_stop,spring --wheel-travel -20mm:80mm:5"));
    assert_eq!(compared.matches(">touch: bump_stop<").count(), 1);
    // A stop on the rod of the damper has the motion ratio of the damper.
    let sheet = percuss("template macpherson-strut").stdout;
    let is_kept = |line: &&str| !line.starts_with("bump_stop");
    let sheet = sheet.lines().filter(is_kept).collect::<Vec<_>>().join("\n");
    let sheet = sheet.replace("[bump_stop]\non = \"upright\"", "[bump_stop]\non = \"damper\"");
    let car = folder.write("car.toml", &sheet);
    let curves = drawn(&format!("kinematics {car} --wheel-travel -40mm:40mm:9"));
    assert!(curves.contains(">damper, bump stop<"), "{curves}");
}

/// Each contact of a variant is compared with the same contact of the first design.
#[test]
fn contacts_and_variants_of_a_study() {
    let folder = Scratch::new("contacts-and-variants");
    let sheet = crate::support::root().join(SHEET);
    let study = format!(
        "[model]\npath = {:?}\n[contact]\nat = \"bump_stop\"\n\
         [[variant]]\nname = \"at the spring\"\ncontact.at = \"spring\"\n\
         [[variant]]\nname = \"light\"\nlink_mass = {{ upright = 4 }}\n\
         [[variant]]\nname = \"light, at the spring\"\ncontact.at = \"spring\"\nlink_mass = {{ upright = 4 }}\n",
        sheet.to_string_lossy()
    );
    let path = folder.write("study.toml", &study);
    let report = json(&format!("compare {path} --format json"));
    let flags = [
        "--at bump_stop",
        "--at spring",
        "--at bump_stop --link-mass upright=4kg",
        "--at spring --link-mass upright=4kg",
    ];
    let masses =
        flags.map(|flags| number(&json(&format!("mass {SHEET} {flags} --format json"))["effective_mass"]));
    for (i, reference) in [None, None, Some(0), Some(1)].into_iter().enumerate() {
        let design = &report["designs"][i];
        assert_eq!(number(&design["effective_mass"]), masses[i]);
        assert_eq!(design["reference"].as_u64(), reference.map(|at| at as u64));
        let percent = reference.map(|at: usize| 100.0 * (masses[i] / masses[at] - 1.0));
        // A difference of two quotients: a few roundings.
        assert_eq!(percent.is_some(), design["difference_percent"].is_number());
        assert!(percent.is_none_or(|p| (p - number(&design["difference_percent"])).abs() < 1e-9), "{design}");
    }
    // A contact of its own; an incomplete one is an error at its line.
    let own = "[[variant]]\nname = \"own\"\ncontact = { link = \"wheel_centre\", point = [0, 0, 0], normal = [0, 0, 1] }\n";
    let with_own = folder.write("own.toml", &(study.clone() + own));
    let last = json(&format!("compare {with_own} --format json"))["designs"][4].clone();
    let flags = format!("mass {SHEET} --link wheel_centre --point 0,0,0 --normal 0,0,1 --format json");
    assert_eq!(last["effective_mass"], json(&flags)["effective_mass"]);
    assert_eq!((&last["reference"], &last["contact"]), (&Value::Null, &Value::Null));
    let incomplete =
        folder.write("incomplete.toml", &(study.clone() + &own.replace("point = [0, 0, 0], ", "")));
    refused(&format!("compare {incomplete}"), &["incomplete.toml:17", "point is missing"]);
    let misspelt = folder.write("misspelt.toml", &(study.clone() + &own.replace("point =", "pont =")));
    refused(
        &format!("compare {misspelt}"),
        &["misspelt.toml:17", "variant.contact.pont", "did you mean", "point"],
    );
    let html = folder.path("report.html");
    let outcome = percuss(&format!("run {path} --report {html}"));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let page = std::fs::read_to_string(html).expect("a report");
    assert!(page.contains("Contacts and variants") && page.contains("light, at the spring"));
}

/// Report of a sweep in JSON.
fn swept(folder: &Scratch, words: &str) -> Value {
    let path = folder.path("swept.json");
    let outcome = percuss(&format!("{words} --output {path} --force"));
    assert_eq!(outcome.code, 0, "{words}: {}", outcome.stderr);
    serde_json::from_str(&std::fs::read_to_string(path).expect("a report")).expect("JSON")
}

/// The motion ratio of a sweep over heave or roll belongs to this motion: the ratio of `percuss kinematics`, per upward
/// travel of the wheel on the side of the contact. A contact on the other side than the single moved wheel has none.
#[test]
fn motion_ratios_of_heave_and_roll_are_those_of_the_kinematics() {
    let folder = Scratch::new("ratios-of-heave");
    for template in ["solid-axle-panhard", "pushrod-rocker", "semi-trailing-arm", "double-wishbone"] {
        let text = percuss(&format!("template {template}")).stdout;
        let sheet = folder.write("car.toml", &text.replace("build = \"left\"", "build = \"both\""));
        for motion in ["heave", "roll"] {
            let range = format!("--{motion} -20mm:20mm:3");
            let kinematics = json(&format!("kinematics {sheet} {range} --format json"));
            for contact in ["spring", "damper", "bump_stop"] {
                for side in ["left", "right"] {
                    let words = format!("sweep {sheet} --at {contact}_{side} {range}");
                    let report = swept(&folder, &words);
                    assert_eq!(report["motion_ratio_of"], motion);
                    for row in 0..3 {
                        let per_wheel = &kinematics["rows"][row][&format!("motion_ratio_{contact}_{side}")];
                        let expected = number(per_wheel);
                        let found = number(&report["rows"][row]["motion_ratio"]);
                        assert!((found / expected - 1.0).abs() < 1e-9, "{words} {row}: {found}, {expected}");
                    }
                }
            }
        }
    }
    let sheet = folder.path("car.toml");
    let one_wheel = "--vary travel:wheel_centre_left:0,0,0:0,0,1=0:1mm:2";
    for (contact, has_ratio) in [("bump_stop_left", true), ("bump_stop_right", false)] {
        let report = swept(&folder, &format!("sweep {sheet} --at {contact} {one_wheel}"));
        assert_eq!(report["rows"][1]["motion_ratio"].is_number(), has_ratio, "{contact}");
    }
    let report = swept(&folder, &format!("sweep {SHEET} --at spring --wheel-travel 0:1mm:2"));
    assert_eq!(report["motion_ratio_of"], "wheel-travel");
    let words = "sweep models/four_bar.urdf --link coupler --point 0,0,0 --normal 0,1,0 --vary crank_hinge=0deg:1deg:2";
    let report = swept(&folder, words);
    assert!(report.get("motion_ratio_of").is_none());
}
