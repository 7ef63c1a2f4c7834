//! Position files: columns, units, errors with their positions.

use crate::support;
use crate::support::{Scratch, Sweep, json, percuss, percuss_with_stdin};
const COUPLER: &str = "sweep models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0";
const STOP: &str = "models/double_wishbone.urdf --link bump_stop_pad --point 0,0,0 --along-line bump_stop:0,0,0 --turning-normal \
                    --against chassis";

fn answered(outcome: &support::Outcome) -> Sweep {
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    Sweep::read(&outcome.stdout)
}

#[test]
fn every_row_of_a_trajectory_is_what_mass_says() {
    let scratch = Scratch::new("input-rows");
    let mut text = String::from("\u{feff}spin [deg], lower_arm_hinge , t\r\n");
    for row in 0..30 {
        let s = f64::from(row) / 29.0;
        text += &format!("{},{},{s}\r\n", 360.0 * s, 0.3 * (6.0 * s).sin());
    }
    let path = scratch.write("path.csv", &text);
    let sweep = answered(&percuss(&format!("sweep {STOP} --input {path} --ignore t")));
    assert_eq!(sweep.rows.len(), 30);
    assert_eq!(sweep.header[..4], ["row", "spin", "lower_arm_hinge", "status"]);
    for row in (0..30).step_by(7) {
        let set = format!(
            "--set spin={} --set lower_arm_hinge={}",
            sweep.cell(row, "spin"),
            sweep.cell(row, "lower_arm_hinge")
        );
        let wanted = json(&format!("mass {STOP} {set} --format json"))["effective_mass"].as_f64().unwrap();
        let got = sweep.number(row, "effective_mass").unwrap();
        assert!((got / wanted - 1.0).abs() < 1e-10, "row {row}: {got} {wanted}");
        let angle = 360.0 * f64::from(u32::try_from(row).unwrap()) / 29.0;
        assert!((sweep.number(row, "spin").unwrap() - angle.to_radians()).abs() < 1e-12);
    }
    // Standard input gives the same results; the JSON contains its digest.
    let by_stdin = percuss_with_stdin(&format!("sweep {STOP} --input - --ignore t"), text.as_bytes());
    assert_eq!(answered(&by_stdin).rows, sweep.rows);
    let out = scratch.path("rows.json");
    assert_eq!(percuss(&format!("sweep {STOP} --input {path} --ignore t --output {out}")).code, 0);
    let report: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(out).unwrap()).expect("JSON");
    assert_eq!(report["inputs"][1]["path"], path.as_str());
    assert_eq!(report["inputs"][1]["sha256"].as_str().map(str::len), Some(64));
}

/// The columns written by a sweep can be read back, even for a ball joint.
#[test]
fn a_ball_has_a_column_for_each_number() {
    let model = r#"<robot name="r"><link name="g"/><link name="a"><inertial><mass value="2"/>
        <inertia ixx="1" ixy="0" ixz="0" iyy="2" iyz="0" izz="3"/></inertial></link>
        <joint name="p" type="spherical"><parent link="g"/><child link="a"/></joint></robot>"#;
    let scratch = Scratch::new("input-ball");
    let model = scratch.write("ball.urdf", model);
    let contact = format!("{model} --link a --point 0.4,0,0 --normal 0,0.6,0.8 --normal-frame world");
    let path = scratch.write("path.csv", "p[0],p[1],p[2],p[3]\n1,0,0,0\n0.8,0.6,0,0\n0,0,0,-1\n");
    let sweep = answered(&percuss(&format!("sweep {contact} --input {path}")));
    for (row, set) in ["1,0,0,0", "0.8,0.6,0,0", "0,0,0,-1"].iter().enumerate() {
        let wanted = json(&format!("mass {contact} --set p={set} --format json"))["effective_mass"].clone();
        let got = sweep.number(row, "effective_mass").unwrap();
        assert!((got / wanted.as_f64().unwrap() - 1.0).abs() < 1e-12, "row {row}");
    }
    for (text, words) in [
        ("p[0],p[1],p[2]\n1,0,0\n", ":1: 1 position is without a column: \"p[3]\""),
        ("p\n1\n", "joint \"p\" has 4 numbers; expected columns \"p[0]\" to \"p[3]\""),
        ("p[0],p[1],p[2],p[3]\n1,0,0,0\n1,1,0,0\n", ":3: joint \"p\": the quaternion"),
        (
            "p[0] [deg],p[1],p[2],p[3]\n1,0,0,0\n",
            "[deg] is the unit of an angle (rad); expected a plain number",
        ),
    ] {
        let path = scratch.write("bad.csv", text);
        let outcome = percuss(&format!("sweep {contact} --input {path}"));
        assert_eq!((outcome.code, outcome.stdout.as_str()), (2, ""), "{text}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(words), "{text}: {}", outcome.stderr);
    }
}

#[test]
fn errors_in_a_file_are_reported_with_their_position() {
    let scratch = Scratch::new("input-errors");
    let long = "1".repeat(2 << 20);
    let cases: &[(&str, &[u8], &str)] = &[
        ("empty", b"", "path.csv: it is empty"),
        ("blank lines", b"\n\n\n", "path.csv: it is empty"),
        ("a header alone", b"crank_hinge\n", "path.csv: it has a header and no rows"),
        ("unknown", b"crank_hinge,tme\n0,0\n", "path.csv:1: column 2 (\"tme\"): no joint is named \"tme\""),
        ("its remedy", b"crank_hinge,tme\n0,0\n", "or leave the column out (--ignore \"tme\")"),
        ("nearly", b"crank_hing\n0\n", "did you mean \"crank_hinge\""),
        ("unnamed", b"crank_hinge,\n0,0\n", "path.csv:1: column 2: it has no name"),
        (
            "twice",
            b"crank_hinge,crank_hinge [deg]\n0,0\n",
            "column 2 (\"crank_hinge [deg]\"): column 1 gives the same position",
        ),
        ("a unit", b"crank_hinge [mm]\n0\n", "[mm] is the unit of a length (m); expected an angle (rad)"),
        ("no unit", b"crank_hinge [grad]\n0\n", "\"grad\" is no unit of a position; expected an angle (rad)"),
        ("dependent", b"crank_hinge,rocker_hinge\n0,0\n", "column 2 (\"rocker_hinge\")"),
        ("semicolons", b"crank_hinge;tme\n0;0\n", "the header has no comma and 1 \";\""),
        ("too few", b"crank_hinge\n0\n0,0\n", "path.csv:3: 2 cells; the header has 1"),
        (
            "empty cell",
            b"crank_hinge\n0\n\"\"\n",
            "path.csv:3: column 1 (\"crank_hinge\"): the cell is empty",
        ),
        (
            "nan",
            b"crank_hinge\n0\n\n nan \n",
            "path.csv:4: column 1 (\"crank_hinge\"): \"nan\" is not finite",
        ),
        ("inf", b"crank_hinge\n-inf\n", "path.csv:2: column 1 (\"crank_hinge\"): \"-inf\" is not finite"),
        ("huge", b"crank_hinge\n1e999\n", "\"1e999\" is not finite"),
        ("far", b"crank_hinge\n1e200\n", "path.csv:2: joint \"crank_hinge\" is set to 1e200"),
        (
            "garbage",
            b"crank_hinge\n0\n0x10\n",
            "path.csv:3: column 1 (\"crank_hinge\"): \"0x10\" is no number",
        ),
        ("comma", b"crank_hinge\n\"0,5\"\n", "\"0,5\" is no number"),
        ("unit in a cell", b"crank_hinge\n30deg\n", "\"30deg\" is no number; expected one such as 0.5"),
        ("quote", b"crank_hinge\n\"0\n", "path.csv:2: a quote is not closed"),
        ("bytes", b"crank_hinge\n\xff\xfe\n", "path.csv:2: not UTF-8 text"),
        ("zeros", b"\0\0\0\0", "no joint is named"),
        ("long", long.as_bytes(), "path.csv:1: the line is longer than"),
    ];
    for (what, bytes, words) in cases {
        let path = scratch.path("path.csv");
        std::fs::write(&path, bytes).expect("a temporary file");
        let outcome = percuss(&format!("{COUPLER} --input {path}"));
        assert_eq!((outcome.code, outcome.stdout.as_str()), (2, ""), "{what}: {}", outcome.stderr);
        assert!(outcome.stderr.contains("error: --input: "), "{what}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(words), "{what}: {}", outcome.stderr);
    }
    for (input, words) in [
        ("/there/is/no/file.csv".to_owned(), "/there/is/no/file.csv: cannot be read"),
        (scratch.path("path.xls"), "ends in neither .csv nor .parquet"),
        ("/tmp".to_owned(), "ends in neither .csv nor .parquet"),
    ] {
        let outcome = percuss(&format!("{COUPLER} --input {input}"));
        assert_eq!(outcome.code, 2, "{}", outcome.stderr);
        assert!(outcome.stderr.contains(words), "{}", outcome.stderr);
    }
    let model =
        std::fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/four_bar.urdf")).expect("a model");
    let both =
        percuss_with_stdin(&format!("{} --input -", COUPLER.replace("models/four_bar.urdf", "-")), &model);
    assert!(
        both.code == 2 && both.stderr.contains("the model is already read from the standard input"),
        "{}",
        both.stderr
    );
}

/// Unreachable rows are marked, and the path continues.
#[test]
fn a_path_goes_on_after_rows_out_of_reach() {
    let scratch = Scratch::new("input-reach");
    let path = scratch.write("path.csv", "lower_arm_hinge,spin\n0,0\n2,0\n2.1,0\n2.1,1\n0.1,0\n");
    let outcome = percuss(&format!("sweep {STOP} --input {path}"));
    let sweep = answered(&outcome);
    let status: Vec<&str> = (0..5).map(|row| sweep.cell(row, "status")).collect();
    assert_eq!(status, ["finite", "unreachable", "unreachable", "unreachable", "finite"]);
    assert!(outcome.stderr.contains("3 of 5 rows have no result"), "{}", outcome.stderr);
}

/// The same in a study; paths are relative to the study.
#[test]
fn a_study_has_files_and_random_positions_too() {
    let scratch = Scratch::new("input-study");
    scratch.write("path.csv", "crank_hinge [deg],t\n10,0\n20,1\n");
    let model = support::root().join("models/four_bar.urdf");
    let study = |sweep: &str| {
        format!(
            "[model]\npath = {:?}\n[contact]\nlink = \"coupler\"\npoint = [0.35, 0.1, 0]\nnormal = [0, 1, 0]\n[sweep]\n{sweep}\n",
            model.display()
        )
    };
    for (sweep, flags) in [
        ("input = \"path.csv\"\nignore = \"t\"", format!("--input {} --ignore t", scratch.path("path.csv"))),
        ("random = 5\nseed = 9", "--random 5 --seed 9".to_owned()),
        ("vary = [\"crank_hinge=0:1:3\"]", "--vary crank_hinge=0:1:3".to_owned()),
    ] {
        let path = scratch.write("study.toml", &study(sweep));
        let (kept, typed) = (percuss(&format!("run {path}")), percuss(&format!("{COUPLER} {flags}")));
        assert_eq!((kept.code, kept.stdout), (0, typed.stdout), "{sweep}: {}", kept.stderr);
    }
    for (sweep, words) in [
        ("random = 5\ninput = \"path.csv\"", "sweep: give one of vary, input and random"),
        ("output = \"x.csv\"", "sweep: give one of vary, input and random"),
        ("vary = \"crank_hinge=0:1:3\"\nseed = 1", "sweep.seed: it requires random"),
        ("vary = \"crank_hinge=0:1:3\"\nignore = \"t\"", "sweep.ignore: it removes columns of input"),
        ("input = \"path.csv\"", "sweep.input: "),
        ("input = \"path.csv\"", "leave the column out (sweep.ignore)"),
    ] {
        let path = scratch.write("study.toml", &study(sweep));
        let outcome = percuss(&format!("run {path}"));
        assert_eq!(outcome.code, 2, "{sweep}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(words), "{sweep}: {}", outcome.stderr);
    }
}
