//! Mistakes and questions of every day about a suspension, with their answers.

use crate::support;
use crate::support::{Scratch, Sweep, done, run_in as run};
use serde_json::Value;
use std::fs;

/// Asserts that a command is refused, or has no result, with these words in its message.
#[track_caller]
fn fails(folder: &Scratch, code: i32, words: &[&str], expected: &[&str]) {
    let outcome = run(folder, words);
    assert_eq!(outcome.code, code, "{words:?}: {}{}", outcome.stdout, outcome.stderr);
    for word in expected {
        assert!(outcome.stderr.contains(word), "{words:?}: {word} is not in {}", outcome.stderr);
    }
}

/// Exchanged seats of a spring: a finding about the points in every result, and one about the motion at the spring.
#[test]
fn exchanged_seats_are_named_in_every_result() {
    let folder = Scratch::new("own-seats");
    for template in ["double-wishbone", "pushrod-rocker", "macpherson-strut"] {
        let sheet = done(&folder, &["template", template]);
        let swapped = sheet
            .replace("\nspring_seat =", "\nOTHER =")
            .replace("\nspring_chassis_seat =", "\nspring_seat =");
        folder.write("car.toml", &swapped.replace("\nOTHER =", "\nspring_chassis_seat ="));
        for (contact, words) in
            [("bump_stop", "exchange the two points"), ("spring", "extends while the wheel moves up")]
        {
            let told = run(&folder, &["mass", "car.toml", "--at", contact]).stderr.replace("\n  ", " ");
            assert!(told.contains(words), "{template} {contact}: {told}");
        }
        folder.write("car.toml", &sheet);
        assert!(!run(&folder, &["mass", "car.toml", "--at", "spring"]).stderr.contains("warning"));
    }
}

/// A sheet in inches has pounds and results in inches; one message of a study has several findings without escaped line ends.
#[test]
fn inches_and_pounds_are_read_and_shown() {
    let folder = Scratch::new("own-inches");
    let sheet = done(&folder, &["template", "double-wishbone", "--unit", "in", "--axes", "adams"]);
    let metric = done(&folder, &["template", "double-wishbone", "--unit", "mm"]);
    let mass = |name: &str, text: &str| {
        folder.write(name, text);
        let json = done(&folder, &["mass", name, "--at", "bump_stop", "--format", "json"]);
        serde_json::from_str::<Value>(&json).expect("JSON")["effective_mass"].as_f64().expect("finite")
    };
    assert!(sheet.contains("mass = 4.2\n") && metric.contains("mass = 4.2\n"));
    let pounds = "mass = \"9.259415011764858 lb\"\n";
    let [in_kg, in_lb] =
        ["mass = 4.2\n", pounds].map(|by| mass("car.toml", &sheet.replacen("mass = 4.2\n", by, 1)));
    assert!((in_lb / in_kg - 1.0).abs() < 1e-13, "{in_kg}, {in_lb}");
    // Coordinates of the template are rounded to a ten-thousandth of an inch.
    let of_metric = mass("metric.toml", &metric);
    assert!((in_kg / of_metric - 1.0).abs() < 1e-3, "{in_kg}, {of_metric}");
    folder.write("car.toml", &sheet);
    let text = done(&folder, &["mass", "car.toml", "--at", "bump_stop"]);
    for words in ["gap of 1.181 in closed", "wheel 2.408 in up from the design position"] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let list = done(&folder, &["mass", "car.toml", "--at", "all"]);
    assert!(list.contains("gap, in  wheel travel, in"), "{list}");
    let wrong = "[model]\npath = \"car.toml\"\nmove = { lower_bal = [0, 0, 0.01], upper_bal = [0, 0, 0.01] }\n[contact]\nat = \"bump_stop\"\n";
    folder.write("study.toml", wrong);
    fails(&folder, 2, &["run", "study.toml"], &["lower_bal", "upper_bal"]);
    assert!(!run(&folder, &["run", "study.toml"]).stderr.contains("\\n"));
}

/// Rows of a sweep at a stop have its gap, with and without poses, in every format; other sweeps have no such column.
#[test]
fn rows_at_a_stop_have_its_gap() {
    let folder = Scratch::new("own-gap");
    done(&folder, &["template", "double-wishbone", "-o", "my.toml"]);
    let gap_at = |flags: &[&str]| {
        let words = [&["mass", "my.toml", "--at", "bump_stop", "--format", "json"], flags].concat();
        let report: Value = serde_json::from_str(&done(&folder, &words)).unwrap();
        report["named_contact"]["gap"].as_f64().unwrap()
    };
    // Rows that the path follower evaluates without poses, and rows of a travel.
    for (range, flag, first, last) in [
        (["--vary", "lower_arm_hinge=-0.1:0.1:9"], "--set", "lower_arm_hinge=-0.1", "lower_arm_hinge=0.1"),
        (["--wheel-travel", "-40mm:40mm:9"], "--wheel-travel", "-40mm", "40mm"),
    ] {
        let sweep = [&["sweep", "my.toml", "--at", "bump_stop"][..], &range].concat();
        let table = Sweep::read(&done(&folder, &sweep));
        for (row, at) in [(0, first), (8, last)] {
            let (found, expected): (f64, f64) =
                (table.cell(row, "gap").parse().unwrap(), gap_at(&[flag, at]));
            assert!((found - expected).abs() < 1e-9, "{range:?}, row {row}: {found} and {expected}");
        }
        let in_millimetres = done(&folder, &[&sweep[..], &["--unit", "mm"]].concat());
        assert!(in_millimetres.lines().next().unwrap().contains(",gap_mm,"), "{in_millimetres}");
        done(&folder, &[&sweep[..], &["-o", "rows.json"]].concat());
        let report: Value =
            serde_json::from_str(&fs::read_to_string(folder.path("rows.json")).unwrap()).unwrap();
        let gap = report["rows"][8]["gap"].as_f64().unwrap();
        assert!((gap - gap_at(&[flag, last])).abs() < 1e-9);
        for file in ["rows.parquet", "rows.xlsx", "rows.jsonl"] {
            done(&folder, &[&sweep[..], &["-o", file]].concat());
        }
    }
    let spring = ["sweep", "my.toml", "--at", "spring", "--wheel-travel", "-40mm:40mm:3"];
    assert!(!done(&folder, &spring).lines().next().unwrap().contains("gap"));
}

/// A worksheet of a workbook is chosen by a flag, in every command and in studies.
#[test]
fn a_worksheet_is_chosen_by_a_flag() {
    let folder = Scratch::new("own-worksheet");
    let points = support::root().join("models/suspensions/double-wishbone-points.xlsx");
    fs::copy(points, folder.path("car.xlsm")).unwrap();
    let import = ["import", "car.xlsm", "-o", "car.urdf", "--template", "double-wishbone"];
    fails(&folder, 2, &import, &["no masses", "points = \"car.xlsm\""]);
    fails(
        &folder,
        2,
        &[&import[..], &["--worksheet", "Rear"]].concat(),
        &["no worksheet is named \"Rear\"", "has: \""],
    );
    let mass = ["mass", "car.xlsm", "--at", "bump_stop", "--worksheet", "Rear"];
    fails(&folder, 2, &mass, &["no worksheet is named \"Rear\""]);
    let study = "[model]\npath = \"car.xlsm\"\nworksheet = \"Rear\"\n[contact]\nat = \"bump_stop\"\n";
    folder.write("study.toml", study);
    fails(&folder, 2, &["run", "study.toml"], &["no worksheet is named \"Rear\""]);
}

/// Printed positions and normals state their axes; the summary of an import has the unit and the axes of the sheet. Details of the
/// solution are shown with --details.
#[test]
fn printed_positions_state_their_axes() {
    let folder = Scratch::new("printed-axes");
    folder.write(
        "car.toml",
        &done(&folder, &["template", "double-wishbone", "--axes", "adams", "--unit", "cm"]),
    );
    let words = |words: &[&str]| done(&folder, words).split_whitespace().collect::<Vec<_>>().join(" ");
    let imported = words(&["import", "car.toml", "-o", "car.urdf"]);
    for word in ["(0.00, −76.00, 30.00) cm, axes adams", "track 152.00 cm", "length, cm", "lower_arm 33.572"]
    {
        assert!(imported.contains(word), "{word} is not in {imported}");
    }
    let plain = words(&["mass", "car.toml", "--at", "bump_stop"]);
    let detailed = words(&["mass", "car.toml", "--at", "bump_stop", "--details"]);
    for word in [
        "in the link frame, out of bump_stop_pad",
        "axes of the vehicle (x forward, y left, z up)",
        "axes adams (x backward, y right, z up)",
        "per upward travel of wheel_centre",
    ] {
        assert!(detailed.contains(word) && !plain.contains(word), "{word} is not in {detailed}");
    }
    for word in ["assembly mode", "rank gap", "loops driven by", "condition"] {
        assert!(detailed.contains(word) && !plain.contains(word), "{word}: {plain}");
    }
}
