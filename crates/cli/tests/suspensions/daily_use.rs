//! Mistakes and questions of every day about a suspension, with their answers.

use crate::support;
use crate::support::{Scratch, Sweep, done, percuss, root, run_in as run};
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

/// Mistakes of every day are answered with the remedy.
#[test]
fn mistakes_are_answered_with_the_remedy() {
    let folder = Scratch::new("own-remedies");
    fails(&folder, 2, &["template"], &["double-wishbone, ", "--list"]);
    done(&folder, &["template", "double-wishbone", "-o", "my.toml"]);
    let at_stop = ["mass", "my.toml", "--at", "bump_stop"];
    let link = ["mass", "my.toml", "--link", "zzz", "--point", "0,0,0", "--normal", "0,0,1"];
    fails(&folder, 2, &link, &["there are the links", "\"lower_arm\"", "the contacts", "\"bump_stop\""]);
    fails(&folder, 2, &["mass", "my.toml", "--at", "zzz"], &["there are the contacts", "\"contact_patch\""]);
    let travel = ["--travel", "wheel_centre:0,0,0:0,0,1=50"];
    fails(&folder, 1, &[&at_stop[..], &travel].concat(), &["in m", "write 50mm"]);
    let shift = ["--move", "lower_ball=0,0,5"];
    fails(&folder, 2, &[&at_stop[..], &shift].concat(), &["moved by 5 m", "write 5mm", "in mm"]);
    done(&folder, &[&at_stop[..], &["--move", "lower_ball=0,0,5mm"]].concat());
    let heavy = run(&folder, &[&at_stop[..], &["--link-mass", "wheel=16500"]].concat());
    assert!(heavy.code == 0 && heavy.stderr.contains("write 16500g"), "{}", heavy.stderr);
    let vary = ["sweep", "my.toml", "--at", "bump_stop", "--vary", "wheel_centre=-50mm:50mm:5"];
    fails(&folder, 2, &vary, &["is a link", "travel:wheel_centre:0,0,0:0,0,1=", "wheel-travel="]);
    fails(
        &folder,
        2,
        &[&at_stop[..], &["--base", "floating"]].concat(),
        &["[chassis]", "needs mass and inertia"],
    );
    let text = fs::read_to_string(folder.path("my.toml")).unwrap();
    let chassis = "[chassis]\nmass = 1200\ncom = [-1200, 0, 500]\ninertia = [400, 1500, 1600]\n\n[lower_arm]";
    folder.write("floating.toml", &text.replace("[lower_arm]", chassis));
    done(&folder, &["mass", "floating.toml", "--at", "bump_stop", "--base", "floating"]);
}

/// Messages about numbers without a unit on a robot arm.
#[test]
fn numbers_without_a_unit_get_a_hint() {
    let arm = support::root().join("models/six_r_arm.urdf").to_string_lossy().into_owned();
    let folder = Scratch::new("own-units");
    let contact = ["--link", "tool", "--point", "0.08,0,0", "--normal", "0,0,-1"];
    let mass = run(&folder, &[&["mass", &arm], &contact[..], &["--set", "shoulder=-40"]].concat());
    assert!(mass.stderr.contains("in rad: for degrees write -40deg"), "{}", mass.stderr);
    assert!(mass.stdout.contains("rotor inertias       none in the model"), "{}", mass.stdout);
    let with = run(&folder, &[&["mass", &arm], &contact[..], &["--armature", "elbow=0.6"]].concat());
    assert!(!with.stdout.contains("rotor inertias"), "{}", with.stdout);
    let vary = |range: &str| {
        let words = [&["sweep", &arm], &contact[..], &["--vary", range, "--unit", "deg"]].concat();
        run(&folder, &words).stderr
    };
    assert!(vary("elbow=0:1:3").contains("elbow=0deg:1deg:3"));
    assert!(!vary("elbow=0deg:60deg:3").contains("unit of the table"));
    let limit =
        ["damp", "--mass-from", &arm, "--limit", "elbow:uper", "--stiffness", "1e4", "--restitution", "0.3"];
    fails(&folder, 2, &limit, &["did you mean elbow:upper?", "lower and upper"]);
    let speed = run(
        &folder,
        &[&["safe-speed", &arm], &contact[..], &["--region", "chest", "--force", "280"]].concat(),
    );
    assert!(
        speed.stdout.contains("rotor inertias       none in the model"),
        "{}{}",
        speed.stdout,
        speed.stderr
    );
}

/// Messages about travels name the flag and a form that works there; a travel of metres is a number without a unit.
#[test]
fn travels_get_the_form_that_works() {
    let folder = Scratch::new("own-travels");
    let sheet =
        |name: &str| root().join(format!("models/suspensions/{name}.toml")).to_string_lossy().into_owned();
    let (corner, axle) = (sheet("double-wishbone"), sheet("solid-axle-panhard"));
    for words in [
        ["sweep", "--wheel-travel", "-80:80:3"],
        ["mass", "--wheel-travel", "80"],
        ["mass", "--heave", "-80"],
    ] {
        let given = [&words[..1], &[&*corner, "--at", "bump_stop"], &words[1..]].concat();
        fails(&folder, 2, &given, &["without a unit is in metres", "80mm"]);
    }
    fails(&folder, 2, &["kinematics", &corner, "--wheel-travel", "80"], &["without a unit is in metres"]);
    let range = "travel:wheel_centre_left:0,0,0:0,0,1=FROM:TO:COUNT";
    let sweep = ["sweep", &axle, "--at", "spring_left", "--wheel-travel"];
    fails(&folder, 2, &[&sweep[..], &["-5mm:5mm:3"]].concat(), &[range]);
    // That form is accepted, with the prefix and without it.
    let rows = |of: &str| {
        let vary = of.replace("FROM:TO:COUNT", "-5mm:5mm:3");
        done(&folder, &["sweep", &axle, "--at", "spring_left", "--vary", &vary])
    };
    assert_eq!(rows(range), rows(range.trim_start_matches("travel:")));
    // Several contacts of an axle: the missing ratio has its reason.
    let compared = done(&folder, &["compare", &axle, "--at", "spring_left,spring_right"]);
    assert!(compared.contains("No ratio contact/wheel is given"), "{compared}");
    // Designs whose stops touch at different travels.
    let text = fs::read_to_string(&corner).expect("a sheet");
    assert!(text.contains("gap = 30.0"));
    let other = folder.write("other.toml", &text.replace("gap = 30.0", "gap = 40.0"));
    let compared = done(&folder, &["compare", &corner, &other, "--at", "bump_stop"]);
    assert!(compared.contains("each at its own touch: double-wishbone after 61.17 mm"), "{compared}");
    let at_travel = ["compare", &corner, &other, "--at", "bump_stop", "--wheel-travel", "20mm"];
    assert!(!done(&folder, &at_travel).contains("own touch"));
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
    for words in ["at the touch; 1.181 in as drawn", "2.408 in up from the pose as drawn"] {
        assert!(text.contains(words), "{words}: {text}");
    }
    let list = done(&folder, &["mass", "car.toml", "--at", "all"]);
    assert!(list.contains("gap, in  wheel travel, in"), "{list}");
    let wrong = "[model]\npath = \"car.toml\"\nmove = { lower_bal = [0, 0, 0.01], upper_bal = [0, 0, 0.01] }\n[contact]\nat = \"bump_stop\"\n";
    folder.write("study.toml", wrong);
    fails(&folder, 2, &["run", "study.toml"], &["lower_bal", "upper_bal"]);
    assert!(!run(&folder, &["run", "study.toml"]).stderr.contains("\\n"));
}

/// A slow impact on a soft contact does not rebound under gravity: the line of the restitution says so.
#[test]
fn a_restitution_that_gravity_prevents_is_named_at_the_number() {
    let folder = Scratch::new("own-gravity");
    let words = [
        "damp",
        "--mass",
        "10kg",
        "--stiffness",
        "1e3",
        "--restitution",
        "0.3",
        "--speed",
        "0.02",
        "--for",
        "mujoco",
    ];
    let text = done(&folder, &words).replace("\n                     ", " ");
    let line = text.lines().find(|line| line.starts_with("restitution")).expect("the restitution");
    assert!(line.contains("leaves almost no rebound"), "{text}");
    let fast = done(
        &folder,
        &[
            "damp",
            "--mass",
            "10kg",
            "--stiffness",
            "1e6",
            "--restitution",
            "0.3",
            "--speed",
            "5",
            "--for",
            "mujoco",
        ],
    );
    assert!(!fast.contains("almost no rebound"), "{fast}");
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

/// A study prints its main number below a sweep that is written to a file, also with a travel of its pose.
#[test]
fn a_study_with_a_sweep_prints_its_main_number() {
    let folder = Scratch::new("own-sweep-number");
    done(&folder, &["template", "double-wishbone", "-o", "my.toml"]);
    let study = "[model]\npath = \"my.toml\"\n[contact]\nat = \"spring\"\n[pose]\ntravel = \"wheel-travel=20mm\"\n\
                 [sweep]\noutput = \"rows.csv\"\nvary = \"wheel-travel=-30mm:30mm:7\"\n";
    folder.write("study.toml", study);
    let outcome = run(&folder, &["run", "study.toml", "--notes"]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let mass = done(&folder, &["mass", "my.toml", "--at", "spring", "--wheel-travel", "20mm"]);
    let number = mass.lines().next().unwrap();
    assert!(outcome.stdout.starts_with(number), "{} and {number}", outcome.stdout);
    assert!(outcome.stdout.contains("at the pose of the study"), "{}", outcome.stdout);
    assert!(outcome.stderr.contains("the rows vary the travel"), "{}", outcome.stderr);
    assert_eq!(fs::read_to_string(folder.path("rows.csv")).unwrap().lines().count(), 8);
}

/// The contact point is shown in the unit and the axes of the sheet too.
#[test]
fn the_contact_point_is_shown_in_the_axes_of_the_sheet() {
    let folder = Scratch::new("own-axes");
    done(&folder, &["template", "double-wishbone", "--unit", "in", "--axes", "adams", "-o", "my.toml"]);
    let text = done(&folder, &["mass", "my.toml", "--at", "spring"]).replace("\n                     ", " ");
    let line = text.lines().find(|line| line.starts_with("in the sheet")).expect("the line");
    // The seat of the spring as drawn, [0, 570, 205] mm in the axes of ISO 8855.
    for part in [
        "-22.4409",
        "8.0709",
        " in, normal (0.027626, 0.193385, 0.980734), axes adams (x backward, y right, z up)",
    ] {
        assert!(line.contains(part), "{part}: {line}");
    }
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

/// Messages about keys: the line of the section, no suggestion by the name of the section alone, and the findings about the sheet before
/// an error that they may explain.
#[test]
fn messages_name_the_place_and_the_cause() {
    let folder = Scratch::new("messages");
    let sheet =
        std::fs::read_to_string(root().join("models/suspensions/double-wishbone.toml")).expect("the sheet");
    let line = 1 + sheet.lines().position(|line| line == "[points]").expect("the section");
    let of = |from: &str, to: &str| {
        assert!(sheet.contains(from));
        let path = folder.write("car.toml", &sheet.replacen(from, to, 1));
        percuss(&format!("mass {path} --at bump_stop"))
    };
    let missing = of("lower_ball = ", "# ");
    let place = format!("car.toml:{}: error: points.lower_ball: the key is missing", line + 1);
    assert!(missing.code == 2 && missing.stderr.contains(&place), "{}", missing.stderr);
    let unknown = of("lower_ball = ", "hello = ");
    assert!(
        unknown.stderr.contains("points.hello") && !unknown.stderr.contains("did you mean"),
        "{}",
        unknown.stderr
    );
    assert!(!unknown.stderr.contains("misspelled"), "{}", unknown.stderr);
    let near = of("lower_ball = ", "lower_bal = ");
    assert!(near.stderr.contains("did you mean \"points.lower_ball\"?"), "{}", near.stderr);
    // The travel is not reached, because a point is on the wrong side.
    let path =
        folder.write("car.toml", &sheet.replacen("lower_ball = [5.0, 720.0", "lower_ball = [5.0, -720.0", 1));
    let side = percuss(&format!("mass {path} --at spring --wheel-travel 500mm"));
    assert_eq!(side.code, 1, "{}", side.stderr);
    let (cause, error) =
        (side.stderr.find("points.lower_ball: lower_arm"), side.stderr.find("error: --wheel-travel"));
    assert!(cause.is_some() && cause < error, "{}", side.stderr);
    assert!(side.stderr.contains("change the sign of its y"), "{}", side.stderr);
}

/// Printed positions and normals state their axes; the summary of an import has the unit and the axes of the sheet. Details of the
/// solution are shown with --notes.
#[test]
fn printed_positions_state_their_axes() {
    let folder = Scratch::new("printed-axes");
    folder.write(
        "car.toml",
        &done(&folder, &["template", "double-wishbone", "--axes", "adams", "--unit", "cm"]),
    );
    let words = |words: &[&str]| done(&folder, words).split_whitespace().collect::<Vec<_>>().join(" ");
    let imported = words(&["import", "car.toml", "-o", "car.urdf"]);
    for word in ["(0.00, -76.00, 30.00) cm, axes adams", "track 152.00 cm", "length, cm", "lower_arm 33.572"]
    {
        assert!(imported.contains(word), "{word} is not in {imported}");
    }
    let plain = words(&["mass", "car.toml", "--at", "bump_stop"]);
    for word in [
        "in the link frame, out of bump_stop_pad",
        "axes of the vehicle (x forward, y left, z up)",
        "axes adams (x backward, y right, z up)",
        "per upward travel of wheel_centre",
    ] {
        assert!(plain.contains(word), "{word} is not in {plain}");
    }
    let detailed = words(&["mass", "car.toml", "--at", "bump_stop", "--notes"]);
    for word in ["assembly mode", "rank gap", "loops driven by", "condition"] {
        assert!(detailed.contains(word) && !plain.contains(word), "{word}: {plain}");
    }
}

/// The table of a study has the data of the vehicle that the command has as flags.
#[test]
fn a_study_has_the_data_of_the_vehicle() {
    let folder = Scratch::new("kinematics-vehicle");
    let sheet = done(&folder, &["template", "double-wishbone"]);
    folder.write("car.toml", &sheet.replace("[spring]\n", "[spring]\nrate = \"28 N/mm\"\n"));
    let columns = "anti_dive,body_frequency,wheel_hop_frequency";
    let study = |bias: &str| {
        format!(
            "[model]\npath = \"car.toml\"\n[kinematics]\nvary = \"wheel-travel=-20mm:20mm:3\"\ncolumns = [\"{}\"]\nvehicle = {{ axle = \
             \"front\", brake_bias = {bias}, cg_height = \"500 mm\", wheelbase = 2.6, sprung_mass = 350, tyre_rate = \"200 N/mm\" }}\n",
            columns.replace(',', "\", \"")
        )
    };
    folder.write("study.toml", &study("\"60%\""));
    let of_command = done(
        &folder,
        &[
            "kinematics",
            "car.toml",
            "--wheel-travel",
            "-20mm:20mm:3",
            "--columns",
            columns,
            "--axle",
            "front",
            "--brake-bias",
            "60%",
            "--cg-height",
            "500mm",
            "--wheelbase",
            "2.6",
            "--sprung-mass",
            "350",
            "--tyre-rate",
            "200N/mm",
        ],
    );
    assert!(of_command.contains("anti dive") && of_command.contains("wheel hop frequency"), "{of_command}");
    assert_eq!(done(&folder, &["run", "study.toml"]), of_command);
    folder.write("study.toml", &study("1.6"));
    let refused = run(&folder, &["run", "study.toml"]);
    assert!(
        refused.code == 2 && refused.stderr.contains("kinematics.vehicle.brake_bias"),
        "{}",
        refused.stderr
    );
}
