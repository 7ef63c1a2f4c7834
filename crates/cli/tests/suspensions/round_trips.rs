//! A changed sheet is written in the format that was read: TOML, CSV, XLSX, a table beside a sheet, a subsystem of Adams/Car.

use crate::support::{Scratch, done, root, run_in as run};
use serde_json::Value;

const SOLVE: [&str; 4] = ["--solve", "upper_ball.z", "--for", "roll_centre_height=90mm"];

/// Roll centre height (m), and the unsprung mass (kg), of a sheet.
fn values(folder: &Scratch, sheet: &str) -> [f64; 2] {
    let report: Value =
        serde_json::from_str(&done(folder, &["kinematics", sheet, "--format", "json"])).expect("JSON");
    ["roll_centre_height", "unsprung_mass"].map(|name| report["rows"][0][name].as_f64().expect("a value"))
}

/// Lines of two texts that differ.
fn different(old: &str, new: &str) -> Vec<(String, String)> {
    assert_eq!(old.lines().count(), new.lines().count());
    let lines = old.lines().zip(new.lines()).filter(|(old, new)| old != new);
    lines.map(|(old, new)| (old.to_owned(), new.to_owned())).collect()
}

/// Points of the example as rows of a table, with a separator and a decimal mark.
fn points(folder: &Scratch, separator: &str, mark: &str) -> Vec<String> {
    let text = done(folder, &["template", "double-wishbone"]);
    let section =
        text.split("\n[points]\n").nth(1).and_then(|rest| rest.split("\n\n").next()).expect("points");
    let row = |line: &str| {
        let (key, rest) = line.split_once(" = [").expect("a point");
        let numbers = rest.split(']').next().expect("a list").split(", ");
        let numbers: Vec<String> = numbers.map(|number| number.replace('.', mark)).collect();
        format!("{key}{separator}{}", numbers.join(separator))
    };
    section.lines().map(row).collect()
}

/// Sheet of the example with its points in a table.
fn sheet_with_table(folder: &Scratch, table: &str) -> String {
    let text = done(folder, &["template", "double-wishbone"]);
    let (head, rest) = text.split_once("\n[points]\n").expect("points");
    let (_, bodies) = rest.split_once("\n\n").expect("bodies");
    // The first line of the head that is a key.
    head.replacen("\ntemplate =", &format!("\npoints = \"{table}\"\ntemplate ="), 1) + "\n" + bodies
}

/// Every format: the changed file has the required value, the mass of the same move, and one changed line.
#[test]
fn changed_files_have_the_format_that_was_read() {
    let folder = Scratch::new("round-trips");
    for file in ["car.toml", "car.csv", "car.xlsx"] {
        done(&folder, &["template", "double-wishbone", "-o", file]);
    }
    let commas = points(&folder, ";", ",").join("\n");
    folder.write(
        "points.csv",
        &format!("# Punkte\r\nName;X [mm];Y [mm];Z [mm]\r\n{}\r\n", commas.replace('\n', "\r\n")),
    );
    folder.write("commas.toml", &sheet_with_table(&folder, "points.csv"));
    let numbered: String = points(&folder, ",", ".")
        .iter()
        .enumerate()
        .map(|(i, row)| format!("{i},\"{}\n", row.replacen(',', "\",", 1)))
        .collect();
    folder.write("numbered.csv", &numbered);
    folder.write("numbered.toml", &sheet_with_table(&folder, "numbered.csv"));
    let of_adams: String = points(&folder, " ", ".")
        .iter()
        .map(|row| {
            let cells: Vec<&str> = row.split(' ').collect();
            let turned = [1, 2].map(|k| -cells[k].parse::<f64>().expect("a number"));
            format!(
                " '{}'   'left/right'   {:?}   {:?}   {}   'remark'\n",
                cells[0], turned[0], turned[1], cells[3]
            )
        })
        .collect();
    let head = "[UNITS]\n LENGTH = 'mm'\n$ a comment\n[HARDPOINT]\n{hardpoint_name symmetry x_value y_value z_value}\n";
    folder.write("car.sub", &format!("{head}{of_adams}"));
    folder.write("adams.toml", &sheet_with_table(&folder, "car.sub"));
    let text = done(&folder, &["template", "double-wishbone"]);
    let renamed = text
        .replace("\nupper_ball = ", "\nUBJ = ")
        .replace("\n[points]\n", "\n[names]\nupper_ball = \"UBJ\"\n\n[points]\n");
    folder.write("names.toml", &renamed);
    let expected = {
        let report =
            done(&folder, &[&["kinematics", "car.toml"][..], &SOLVE, &["--format", "json"]].concat());
        let report: Value = serde_json::from_str(&report).expect("JSON");
        let new = report["coordinates"][0]["new"].as_f64().expect("a number");
        let old = report["coordinates"][0]["old"].as_f64().expect("a number");
        let by = format!("upper_ball=0,0,{}mm", new - old);
        let moved = done(&folder, &["kinematics", "car.toml", "--move", &by, "--format", "json"]);
        let moved: Value = serde_json::from_str(&moved).expect("JSON");
        moved["rows"][0]["unsprung_mass"].as_f64().expect("a mass")
    };
    for (sheet, file) in [
        ("car.toml", "car.toml"),
        ("car.csv", "car.csv"),
        ("car.xlsx", "car.xlsx"),
        ("commas.toml", "points.csv"),
        ("numbered.toml", "numbered.csv"),
        ("adams.toml", "car.sub"),
        ("names.toml", "names.toml"),
    ] {
        let before = values(&folder, sheet);
        assert!((before[0] - 0.09).abs() > 1e-3, "{sheet}");
        let (_, ending) = file.split_once('.').expect("an ending");
        let new = format!("new.{ending}");
        done(&folder, &[&["kinematics", sheet][..], &SOLVE, &["-o", &new, "--force"]].concat());
        if sheet == file {
            // A comparison of both files lists the point.
            let words = ["compare", sheet, &new, "--at", "bump_stop", "--format", "json"];
            assert!(done(&folder, &words).contains("\"upper_ball\""), "{sheet}");
        }
        if ending == "xlsx" {
            std::fs::copy(folder.path(&new), folder.path(file)).expect("a copy");
        } else {
            let [old, changed] =
                [file, &new].map(|name| std::fs::read_to_string(folder.path(name)).expect("a text"));
            let lines = different(&old, &changed);
            assert_eq!(lines.len(), 1, "{sheet}: {lines:?}");
            let [old_line, new_line] = [&lines[0].0, &lines[0].1]
                .map(|line| line.replace(|c: char| c.is_ascii_digit() || "-.,".contains(c), ""));
            assert_eq!(old_line, new_line, "{sheet}: only numbers change");
            folder.write(file, &changed);
        }
        let [height, mass] = values(&folder, sheet);
        // The accuracy of the search, 1e-8 of a millimetre, and thirteen digits of the coordinate.
        assert!(
            (height - 0.09).abs() < 1e-10 && (mass - expected).abs() < 1e-7,
            "{sheet}: {height} {mass} {expected}"
        );
    }
}

/// The endings differ, a coordinate has no cell of its own, or two points are one point of the file.
#[test]
fn files_that_cannot_be_changed_are_refused() {
    let folder = Scratch::new("round-trips-refused");
    folder.write("points.csv", &points(&folder, ",", ".").join("\n"));
    folder.write("car.toml", &sheet_with_table(&folder, "points.csv"));
    let refused = |words: &[&str], expected: &str| {
        let outcome = run(&folder, &[&["kinematics", "car.toml"], words].concat());
        let told = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(outcome.code == 2 && told.contains(expected), "{words:?}: {told}");
    };
    refused(
        &[&SOLVE[..], &["-o", "new.toml"]].concat(),
        "points.csv, and the changed file has the same format",
    );
    let rows = points(&folder, ",", ".");
    let coil: Vec<String> = rows
        .iter()
        .filter(|row| !row.starts_with("spring"))
        .map(|row| {
            row.replace("damper_seat", "coilover lower").replace("damper_chassis_seat", "coilover upper")
        })
        .collect();
    folder.write("points.csv", &coil.join("\n"));
    let words = ["--solve", "spring_seat.z", "--for", "motion_ratio_spring=0.6", "-o", "new.csv"];
    refused(&words, "are one point of the file");
}

/// A template as a table gives the mechanism of the template in TOML.
#[test]
fn templates_are_written_as_tables() {
    let folder = Scratch::new("template-tables");
    let listed = done(&folder, &["template", "--list"]);
    let names =
        listed.lines().filter_map(|line| line.split_whitespace().next().filter(|_| !line.starts_with(' ')));
    let mut count = 0;
    for template in names {
        let mass = |file: &str| -> Vec<f64> {
            done(&folder, &["template", template, "-o", file, "--force"]);
            let report = done(&folder, &["mass", file, "--at", "all", "--format", "json", "--strict"]);
            let report: Value = serde_json::from_str(&report).expect("JSON");
            let contacts = report["contacts"].as_array().expect("contacts");
            contacts
                .iter()
                .map(|contact| contact["report"]["effective_mass"].as_f64().expect("a mass"))
                .collect()
        };
        let expected = mass("car.toml");
        assert!(expected.len() > 2, "{template}");
        assert_eq!(mass("car.csv"), expected, "{template}");
        if count % 5 == 0 {
            assert_eq!(mass("car.xlsx"), expected, "{template}");
        }
        count += 1;
    }
    assert_eq!(count, 21);
    let outcome = run(&folder, &["template", "double-wishbone", "-o", "car.json"]);
    assert!(outcome.code == 2 && outcome.stderr.contains(".csv"), "{}", outcome.stderr);
}

/// A file of Chrono::Vehicle: a hardpoint is moved, found again by the search, and written into the JSON, whose comments stay.
#[test]
fn files_of_chrono_are_moved_and_changed() {
    let folder = Scratch::new("round-trips-chrono");
    let text = std::fs::read_to_string(root().join("models/suspensions/double-wishbone-chrono.json"))
        .expect("a file");
    folder.write("car.json", &format!("// a comment\n{text}"));
    let gradient = |file: &str, more: &[&str]| -> f64 {
        let report = done(&folder, &[&["kinematics", file, "--format", "json"], more].concat());
        let report: Value = serde_json::from_str(&report).expect("JSON");
        report["rows"][0]["camber_gradient"].as_f64().expect("a value").to_degrees()
    };
    let target = gradient("car.json", &["--move", "upper_ball=0,0,4mm"]);
    assert!((target - gradient("car.json", &[])).abs() > 1e-3);
    let value = format!("camber_gradient={target}deg/m");
    done(&folder, &["kinematics", "car.json", "--solve", "upper_ball.z", "--for", &value, "-o", "new.json"]);
    let [old, new] =
        ["car.json", "new.json"].map(|file| std::fs::read_to_string(folder.path(file)).expect("a text"));
    assert_eq!(different(&old, &new).len(), 1, "{new}");
    // The accuracy of the search, 1e-8 of a degree per metre.
    assert!((gradient("new.json", &[]) - target).abs() < 1e-7);
    let outcome = run(&folder, &["kinematics", "car.json", "--move", "uper_ball=0,0,4mm"]);
    assert!(outcome.code == 2 && outcome.stderr.contains("upper_ball"), "{}", outcome.stderr);
}
