//! Rows of a sweep: written during the computation, in bounded memory and work. Messages about the flags of a sweep.

use crate::support::{Scratch, Sweep, command, percuss, percuss_with_stdin, root};
use parquet::file::reader::{FileReader, SerializedFileReader};
use percuss_formats::DEFAULT_MAX_SIZE;
use percuss_study::{GivenPosition, Names, StudyError, StudyFile, Vary, sweep_report};
use std::io::{BufRead, BufReader};
use std::process::Stdio;

const COUPLER: &str = "sweep models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0";

/// Study of the four-bar linkage, for the library.
fn study(scratch: &Scratch) -> StudyFile {
    let model = root().join("models/four_bar.urdf");
    let text = format!(
        "[model]\npath = {:?}\n[contact]\nlink = \"coupler\"\npoint = [0.35, 0.1, 0]\nnormal = [0, 1, 0]\n",
        model.display()
    );
    StudyFile::load(&scratch.write("four_bar.toml", &text), DEFAULT_MAX_SIZE).expect("a study")
}

/// JSON written row by row is equal to the complete report, character by character.
#[test]
fn json_is_that_of_the_whole_report() {
    let scratch = Scratch::new("rows-json");
    let path = scratch.path("rows.json");
    for range in ["crank_hinge=0.1:2:5", "travel:coupler:0,0,0:1,0,0=0:2:3"] {
        let outcome = percuss(&format!("{COUPLER} --vary {range} --output {path}"));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        let written = std::fs::read_to_string(&path).expect("it was written");
        let whole: serde_json::Value = serde_json::from_str(&written).expect("JSON");
        let StudyFile { mut model, question, .. } = study(&scratch);
        let mut question = question.expect("a contact");
        question.names = Names::Flags;
        // The command has the model as its only input, with a path relative to the root.
        model.inputs.truncate(1);
        model.inputs[0].path = "models/four_bar.urdf".into();
        let vary = Vary::parse(range).expect("a range");
        let report = sweep_report(&model, &question, &vary).expect("a sweep");
        assert_eq!(written, serde_json::to_string_pretty(&report).expect("JSON"));
        assert_eq!(whole["rows"].as_array().map(Vec::len), Some(report.rows.len()));
        let keys: Vec<&String> = whole.as_object().unwrap().keys().collect();
        assert_eq!(keys.len(), 10 + usize::from(range.starts_with("travel")), "{keys:?}");
    }
}

/// A reader gets the first rows immediately and may close the pipe: a million rows would take minutes.
#[test]
fn rows_are_written_as_they_are_computed() {
    let line = format!("{COUPLER} --vary crank_hinge=0:360deg:1000000");
    let mut child = command(line.split_whitespace())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("it starts");
    let mut lines = BufReader::new(child.stdout.take().expect("stdout is piped")).lines();
    let first: Vec<String> = lines.by_ref().take(3).map(|l| l.expect("text")).collect();
    assert!(first[0].starts_with("row,crank_hinge,") && first[1].starts_with("0,0,finite,"), "{first:?}");
    drop(lines);
    let code = child.wait().expect("it ends").code();
    assert_eq!(code, Some(0), "a reader that leaves early is no error");
}

/// A hundred thousand rows in an address space 35 MB larger than the file of the program. One arena of the allocator: each thread's own
/// arena reserves 64 MB, used or not. Linux only: other systems have no such limit.
#[cfg(target_os = "linux")]
#[test]
fn rows_are_not_kept() {
    let scratch = Scratch::new("rows-memory");
    let program = env!("CARGO_BIN_EXE_percuss");
    let space = std::fs::metadata(program).expect("a program").len() / 1024 + 35_000;
    for ending in ["csv", "json", "jsonl", "parquet"] {
        let path = scratch.path(&format!("rows.{ending}"));
        let script = format!(
            "ulimit -v {space}; MALLOC_ARENA_MAX=1 exec \"$0\" sweep models/point_mass_pendulum.urdf --link rod --point 0,0,-0.8 --normal 1,0,0 \
             --vary hinge=0:1:100000 --output {path}"
        );
        let outcome = std::process::Command::new("/bin/sh")
            .args(["-c", &script, program])
            .current_dir(root())
            .output()
            .expect("a shell");
        assert!(outcome.status.success(), "{}", String::from_utf8_lossy(&outcome.stderr));
        let rows = if ending == "parquet" {
            let file = std::fs::File::open(&path).expect("it was written");
            SerializedFileReader::new(file).expect("Parquet").metadata().file_metadata().num_rows() as usize
        } else {
            let text = std::fs::read_to_string(&path).expect("it was written");
            if ending == "csv" { text.lines().count() - 1 } else { text.matches("\"row\":").count() }
        };
        assert_eq!(rows, 100_000);
    }
}

/// An invalid query does not change the file of the previous query.
#[test]
fn a_file_is_replaced_when_there_is_a_row_for_it() {
    let scratch = Scratch::new("rows-kept");
    for (name, wrong) in [
        ("rows.csv", "--normal 0,0,0"),
        ("rows.json", "--normal 0,0,0"),
        ("rows.csv", "--link copler"),
        ("rows.json", "--vary crank_hinge=0:1kg:3"),
    ] {
        let path = scratch.write(name, "of last time, and longer than what comes now: ".repeat(99).as_str());
        let line = format!("{COUPLER} --vary crank_hinge=0:1:3 --force --output {path}");
        let (flag, value) = wrong.split_once(' ').expect("a flag and its value");
        let mut words: Vec<&str> = line.split_whitespace().collect();
        let at = words.iter().position(|w| *w == flag).expect("it is there");
        words[at + 1] = value;
        let outcome = percuss(&words.join(" "));
        assert_eq!(outcome.code, 2, "{}", outcome.stderr);
        assert!(outcome.stderr.contains(flag), "{}", outcome.stderr);
        assert!(std::fs::read_to_string(&path).unwrap().starts_with("of last time"), "{wrong}");
        assert_eq!(percuss(&line).code, 0);
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(!text.contains("last time") && text.contains("finite"), "{text}");
    }
}

/// A run that fails during the computation leaves the complete previous file, and no unfinished file. Unix only: Windows shells
/// have no limit of the file size. The test of killed runs covers Windows too.
#[cfg(unix)]
#[test]
fn a_file_is_replaced_when_all_of_it_is_written() {
    let scratch = Scratch::new("rows-renamed");
    for name in ["rows.csv", "rows.json", "rows.jsonl"] {
        let path = scratch.write(name, "of last time");
        let line = format!("{COUPLER} --vary crank_hinge=0:360deg:20000 --force --output {path}");
        // The limit of the file size acts like a disk that becomes full during the run.
        let script = format!("trap '' XFSZ; ulimit -f 100; exec \"$0\" {line}");
        let outcome = std::process::Command::new("/bin/sh")
            .args(["-c", &script, env!("CARGO_BIN_EXE_percuss")])
            .current_dir(root())
            .output()
            .expect("a shell");
        assert_eq!(outcome.status.code(), Some(1), "{}", String::from_utf8_lossy(&outcome.stderr));
        assert!(String::from_utf8_lossy(&outcome.stderr).contains("cannot be written"));
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "of last time");
        // An output through a link keeps the permissions of the file.
        use std::os::unix::fs::PermissionsExt;
        let rights = || std::fs::metadata(&path).unwrap().permissions().mode() & 0o777;
        std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o640)).unwrap();
        let link = scratch.path(&format!("link-{name}"));
        std::os::unix::fs::symlink(&path, &link).expect("a link");
        let outcome = percuss(&format!("{COUPLER} --vary crank_hinge=0:1:3 --force --output {link}"));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        assert!(std::fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(rights(), 0o640);
        assert!(std::fs::read_to_string(&path).unwrap().contains("finite"));
    }
    let left = std::fs::read_dir(scratch.path(""))
        .unwrap()
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok());
    assert!(left.into_iter().all(|name| !name.contains("part")));
}

/// JSON lines are equal to the rows of the JSON report.
#[test]
fn json_lines_are_the_rows_of_the_json() {
    let scratch = Scratch::new("rows-lines");
    let [lines, whole] = ["rows.jsonl", "rows.json"].map(|name| {
        let path = scratch.path(name);
        let line = format!("{COUPLER} --vary travel:coupler:0,0,0:1,0,0=0:2:5 --output {path}");
        assert_eq!(percuss(&line).code, 0);
        std::fs::read_to_string(path).expect("it was written")
    });
    let rows: Vec<serde_json::Value> =
        lines.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let whole: serde_json::Value = serde_json::from_str(&whole).expect("JSON");
    assert_eq!(&rows, whole["rows"].as_array().expect("rows"));
    assert!(rows[4]["error"].is_string() && rows[0]["error"].is_null());
}

/// A full disk ends a sweep with a message that contains the file name. Linux only: other systems have no full device.
#[cfg(target_os = "linux")]
#[test]
fn a_file_that_cannot_take_the_rows_is_named() {
    let scratch = Scratch::new("rows-full");
    for name in ["full.csv", "full.json", "full.jsonl"] {
        let path = scratch.path(name);
        std::os::unix::fs::symlink("/dev/full", &path).expect("a link");
        let outcome = percuss(&format!("{COUPLER} --vary crank_hinge=0:1:500 --output {path}"));
        assert_eq!(outcome.code, 1, "{}", outcome.stderr);
        assert!(outcome.stderr.contains(&format!("{path} cannot be written")), "{}", outcome.stderr);
    }
}

/// A branch is followed to its end once, not again for every row; rows in reach still have results.
#[test]
fn rows_far_out_of_reach_are_not_tried_one_by_one() {
    for (range, answered) in [
        ("crank_hinge=1e12deg:0:73", vec![72]),
        ("crank_hinge=-1e12deg:1e12deg:73", vec![36]),
        ("travel:coupler:0,0,0:1,0,0=1e12:0:73", vec![72]),
        ("travel:coupler:0,0,0:1,0,0=0.8:0:1001", (625..1001).collect()),
    ] {
        let outcome = percuss(&format!("{COUPLER} --notes --vary {range}"));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        let sweep = Sweep::read(&outcome.stdout);
        let finite: Vec<usize> =
            (0..sweep.rows.len()).filter(|row| sweep.cell(*row, "status") == "finite").collect();
        assert_eq!(finite, answered, "{range}");
        let note = outcome.stderr.lines().find(|l| l.contains("were not tried")).expect("a note");
        let count = note.trim_start_matches("note: ").split(' ').next().unwrap().parse::<usize>();
        let rows = sweep.rows.len() - answered.len();
        let tried = rows - count.expect("how many");
        assert!((1..=17).contains(&tried), "{range}: {note}");
    }
}

/// Crank with a range of ±0.59 rad about 0: rows from 2 rad are out of reach, rows near 6 rad are in reach again.
#[test]
fn a_first_row_out_of_reach_says_nothing_of_the_others() {
    let link = |name: &str, joint: &str, parent: &str, x: f64| {
        format!(
            "<link name=\"{name}\"><inertial><mass value=\"1\"/>\
             <inertia ixx=\"1\" iyy=\"1\" izz=\"1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>\
             <joint name=\"{joint}\" type=\"continuous\"><parent link=\"{parent}\"/><child link=\"{name}\"/>\
             <origin xyz=\"{x} 0 0\"/><axis xyz=\"0 0 1\"/></joint>"
        )
    };
    let model = format!(
        "<robot name=\"rockers\"><link name=\"ground\"/>{}{}{}<loop name=\"pin\" type=\"revolute\"><predecessor \
         link=\"coupler\"><origin xyz=\"0.3 0 0\"/></predecessor><successor link=\"rocker\"><origin xyz=\"0.3 0 0\"/>\
         </successor><axis xyz=\"0 0 1\"/></loop></robot>",
        link("crank", "crank_hinge", "ground", 0.0),
        link("coupler", "crank_pin", "crank", 0.6),
        link("rocker", "rocker_hinge", "ground", 1.0)
    );
    // After a full turn the assembly mode may differ; the guess selects the mode.
    for (range, guess, answered) in [("2:7:11", 6.2, vec![8, 9]), ("-2:-7:11", -6.2, vec![8, 9])] {
        let line = format!(
            "sweep - --link coupler --point 0.1,0.1,0 --normal 0,1,0 --vary crank_hinge={range} --guess crank_hinge={guess}"
        );
        let outcome = percuss_with_stdin(&line, model.as_bytes());
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        let sweep = Sweep::read(&outcome.stdout);
        let finite: Vec<usize> =
            (0..sweep.rows.len()).filter(|row| sweep.cell(*row, "status") == "finite").collect();
        assert_eq!(finite, answered, "{range}: {}", outcome.stderr);
    }
}

/// A range constructed in code is checked like a typed range.
#[test]
fn a_number_of_rows_that_cannot_be_is_refused() {
    let scratch = Scratch::new("rows-count");
    let StudyFile { model, question, .. } = study(&scratch);
    let question = question.expect("a contact");
    for count in [0, usize::MAX] {
        let vary = Vary { count, ..Vary::parse("crank_hinge=0:1:2").expect("a range") };
        match sweep_report(&model, &question, &vary) {
            Err(StudyError::Input { fault, .. }) => {
                assert!(fault.to_string().starts_with(&format!("{count} rows; ")), "{fault}");
            }
            other => panic!("{other:?}"),
        }
    }
}

/// A number is parsed once, when the argument is read, and the unit is compared with the unit of the joint.
#[test]
fn numbers_are_read_once() {
    assert_eq!(GivenPosition::parse("30 deg").unwrap().text(), "30 deg");
    let masses: Vec<String> = ["30deg", "0.5235987755982988", "0.5235987755982988rad"]
        .iter()
        .map(|angle| {
            let outcome = percuss(&format!("{COUPLER} --vary crank_hinge={angle}:{angle}:1"));
            Sweep::read(&outcome.stdout).cell(0, "effective_mass").to_owned()
        })
        .collect();
    assert!(masses.iter().all(|m| *m == masses[0] && !m.is_empty()), "{masses:?}");
}
