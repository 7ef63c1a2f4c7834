//! Pipes, devices, links, long names and terminals: every run ends, and only the named files are replaced.

#![cfg(unix)]

use crate::support::{Outcome, Scratch, command, percuss, percuss_with_stdin, root};
use std::fs;
use std::os::unix::fs::symlink;
use std::process::{Child, Command, Stdio};

const CONTACT: &str = "--link rod --point 0,0,-0.8 --normal 1,0,0";
const MODEL: &str = "models/point_mass_pendulum.urdf";

fn fifo(folder: &Scratch, name: &str) -> String {
    let path = folder.path(name);
    assert!(Command::new("mkfifo").arg(&path).status().expect("mkfifo runs").success());
    path
}

/// Waits for the end of a run.
fn ended(run: Child) -> Outcome {
    run.wait_with_output().expect("it ended").into()
}

fn started(line: &str) -> Child {
    let mut command = command(line.split_whitespace());
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts")
}

#[test]
fn an_output_may_be_a_pipe() {
    let folder = Scratch::new("fifo-out");
    let line = format!("sweep {MODEL} {CONTACT} --vary hinge=0:1:50");
    let expected = percuss(&line).stdout;
    for name in ["rows.csv", "rows.jsonl"] {
        let path = fifo(&folder, name);
        let run = started(&format!("{line} -o {path}"));
        let reader = std::thread::spawn(move || fs::read_to_string(path).expect("text"));
        let outcome = ended(run);
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        let read = reader.join().expect("read");
        assert!(name != "rows.csv" || read == expected, "{read}");
    }
}

#[test]
fn models_and_rows_may_come_from_pipes() {
    let folder = Scratch::new("fifo-in");
    let out = folder.write("out.csv", "");
    let model = fifo(&folder, "model.urdf");
    let line = format!("{CONTACT} --vary hinge=0:1:3 -o {out} --force");
    let run = started(&format!("sweep {model} {line}"));
    let text = fs::read(root().join(MODEL)).expect("a model");
    let writer = std::thread::spawn(move || fs::write(&model, text));
    // The comparison of an existing output with the input does not open the input again.
    let outcome = ended(run);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    writer.join().expect("no panic").expect("the run reads it");
    assert_eq!(fs::read_to_string(&out).expect("written").lines().count(), 4);
    let rows = fifo(&folder, "rows.csv");
    let run = started(&format!("sweep {MODEL} {CONTACT} --input {rows}"));
    let writer = std::thread::spawn(move || fs::write(&rows, "hinge\n0\n0.5\n"));
    let outcome = ended(run);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    writer.join().expect("no panic").expect("the run reads it");
    let file = folder.write("file.csv", "hinge\n0\n0.5\n");
    assert_eq!(outcome.stdout, percuss(&format!("sweep {MODEL} {CONTACT} --input {file}")).stdout);
    let endless = folder.path("endless.csv");
    symlink("/dev/zero", &endless).expect("a link");
    let outcome = ended(started(&format!("sweep {MODEL} {CONTACT} --input {endless} --max-size 1000000")));
    assert!(outcome.code == 2 && outcome.stderr.contains("1000000"), "{}", outcome.stderr);
}

/// Files that another file names are regular files: a pipe would wait for its other end.
#[test]
fn named_files_are_no_pipes() {
    let folder = Scratch::new("fifo-named");
    fifo(&folder, "m.obj");
    fifo(&folder, "r.urdf");
    fs::create_dir(folder.path("library")).expect("a folder");
    fifo(&folder, "library/model.config");
    let mesh = "<mujoco><asset><mesh name=\"m\" file=\"m.obj\"/></asset><worldbody><body><joint/><geom type=\"mesh\" mesh=\"m\"/>\
                </body></worldbody></mujoco>";
    let include =
        "<sdf version=\"1.9\"><model name=\"m\"><include><uri>library</uri></include></model></sdf>";
    let study =
        "[model]\npath = \"r.urdf\"\n[contact]\nlink = \"a\"\npoint = [0, 0, 0]\nnormal = [1, 0, 0]\n";
    let whole = format!(
        "[model]\npath = \"{}\"\n[contact]\nlink = \"rod\"\npoint = [0, 0, 0]\nnormal = [1, 0, 0]\n",
        root().join(MODEL).display()
    );
    let rows = format!("{whole}[sweep]\ninput = \"m.obj\"\n");
    let positions = format!("{whole}[pose]\nfile = \"m.obj\"\n");
    for (command, name, text, words) in [
        ("run", "rows.toml", rows.as_str(), "sweep.input"),
        ("run", "pose.toml", &positions, "pose"),
        ("check", "mesh.xml", mesh, "this is no file"),
        ("check", "include.sdf", include, "has no model.config"),
        ("run", "study.toml", study, "this is no file"),
    ] {
        let outcome = ended(started(&format!("{command} {}", folder.write(name, text))));
        let message = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(outcome.code == 2 && message.contains(words), "{name}: {message}");
    }
    // A study from a stream that is open is read; a named pipe is refused, whether or not somebody writes to it.
    let named = fifo(&folder, "pipe.toml");
    for command in ["run", "compare"] {
        let outcome = ended(started(&format!("{command} {named}")));
        assert!(outcome.code == 2, "{command}: {}", outcome.stderr);
    }
    for stream in ["-", "/dev/stdin"] {
        let outcome = percuss_with_stdin(&format!("run {stream}"), whole.as_bytes());
        assert_eq!(outcome.code, 0, "{stream}: {}", outcome.stderr);
    }
}

#[test]
fn links_and_long_names_are_kept() {
    let folder = Scratch::new("links");
    let (link, target) = (folder.path("link.csv"), folder.path("target.csv"));
    symlink("middle.csv", &link).expect("a link");
    symlink("target.csv", folder.path("middle.csv")).expect("a link");
    let line = format!("sweep {MODEL} {CONTACT} --vary hinge=0:1:5 -o");
    for _ in 0..2 {
        let outcome = percuss(&format!("{line} {link}"));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        assert!(fs::symlink_metadata(&link).expect("there").is_symlink(), "the link was replaced");
        assert!(fs::symlink_metadata(&target).expect("written").is_file());
    }
    symlink("round.csv", folder.path("round.csv")).expect("a link");
    let outcome = percuss(&format!("{line} {}", folder.path("round.csv")));
    assert!(outcome.code == 2 && outcome.stderr.contains("cannot be written"), "{}", outcome.stderr);
    for length in [199, 200, 201, 240, 255] {
        for letter in ["n", "ä"] {
            let name = letter.repeat((length - 4) / letter.len()) + ".csv";
            let outcome = percuss(&format!("{line} {}", folder.path(&name)));
            assert_eq!(outcome.code, 0, "{length}: {}", outcome.stderr);
            assert!(fs::metadata(folder.path(&name)).is_ok_and(|found| found.len() > 0), "{length}");
        }
    }
}

/// Names with control characters and marks of direction, on a terminal provided by `script` (util-linux).
#[cfg(target_os = "linux")]
#[test]
fn a_terminal_gets_escapes() {
    let folder = Scratch::new("terminal");
    let text = fs::read_to_string(root().join(MODEL)).expect("a model");
    let model = folder.write("model.urdf", &text.replace("\"rod\"", "\"r\u{9b}o\u{202e}d\""));
    let shown = |line: &str| {
        let inner = format!("{} {line}", env!("CARGO_BIN_EXE_percuss"));
        let run = Command::new("script").args(["-qec", &inner, "/dev/null"]).current_dir(root()).output();
        String::from_utf8_lossy(&run.expect("the command \"script\" of util-linux").stdout).into_owned()
    };
    let text = shown(&format!("init {model}"));
    assert!(text.contains("\\u{9b}") && text.contains("\\u{202e}"), "{text}");
    assert!(!text.contains(['\u{9b}', '\u{202e}']), "{text}");
    // In a file or a pipe, names are unchanged.
    assert!(percuss(&format!("init {model}")).stdout.contains(['\u{9b}']));
}

#[test]
fn a_model_that_was_edited_is_kept() {
    let folder = Scratch::new("edited");
    let model = folder.path("my.urdf");
    let line = format!("import models/suspensions/double-wishbone.toml -o {model}");
    for _ in 0..2 {
        let outcome = percuss(&line);
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    }
    assert_eq!(percuss(&format!("check {model}")).code, 0);
    let text = fs::read_to_string(&model).expect("written");
    let piped = percuss("import models/suspensions/double-wishbone.toml -o -");
    assert_eq!(piped.stdout, text);
    fs::write(&model, text.replace('\n', "\r\n")).expect("written");
    assert_eq!(percuss(&line).code, 0, "ends of lines are no change");
    let edited = text.replacen("mass value=\"", "mass value=\"1", 1);
    assert_ne!(edited, text);
    fs::write(&model, &edited).expect("written");
    let outcome = percuss(&line);
    assert!(outcome.code == 2 && outcome.stderr.contains("--force"), "{}", outcome.stderr);
    assert_eq!(fs::read_to_string(&model).expect("there"), edited);
    assert_eq!(percuss(&format!("{line} --force")).code, 0);
}

#[test]
fn a_table_of_points_is_in_the_folder_of_its_sheet() {
    let folder = Scratch::new("outside");
    fs::create_dir_all(folder.path("sheets")).expect("made");
    let sheet = fs::read_to_string(root().join("models/suspensions/double-wishbone-with-table.toml"))
        .expect("a sheet");
    let table = root().join("models/suspensions/double-wishbone-points.xlsx");
    fs::copy(&table, folder.path("double-wishbone-points.xlsx")).expect("copied");
    fs::copy(&table, folder.path("sheets/double-wishbone-points.xlsx")).expect("copied");
    symlink("../double-wishbone-points.xlsx", folder.path("sheets/link.xlsx")).expect("a link");
    let names = ["double-wishbone-points.xlsx", "./double-wishbone-points.xlsx"];
    let outside = ["../double-wishbone-points.xlsx", "link.xlsx", "/etc/passwd"];
    // The standard input is a pipe.
    let import = |name: &str, flags: &str| {
        let path = folder.write("sheets/my.toml", &sheet.replace("double-wishbone-points.xlsx", name));
        percuss_with_stdin(&format!("import {path} -o - {flags}"), b"")
    };
    for name in names {
        let outcome = import(name, "");
        assert_eq!(outcome.code, 0, "{name}: {}", outcome.stderr);
    }
    for name in outside {
        let outcome = import(name, "");
        assert!(
            outcome.code == 2 && outcome.stderr.contains("--allow-outside"),
            "{name}: {}",
            outcome.stderr
        );
        assert!(!outcome.stderr.contains("root:"), "{name}: {}", outcome.stderr);
    }
    for name in &outside[..2] {
        let outcome = import(name, "--allow-outside");
        assert_eq!(outcome.code, 0, "{name}: {}", outcome.stderr);
    }
    for name in ["/dev/zero", "/dev/stdin"] {
        let outcome = import(name, "--allow-outside");
        assert!(outcome.code == 2 && outcome.stderr.contains("is no file"), "{name}: {}", outcome.stderr);
    }
}

#[test]
fn names_that_look_like_formulas_read_back() {
    let folder = Scratch::new("formulas");
    let text = fs::read_to_string(root().join(MODEL)).expect("a model");
    for name in ["-hinge", "+hinge", "=hinge", "@hinge", "'hinge"] {
        let model = folder.write("model.urdf", &text.replace("\"hinge\"", &format!("\"{name}\"")));
        let line = format!("sweep {model} {CONTACT}");
        let (rows, deg) = (folder.path("rows.csv"), folder.path("deg.csv"));
        let _ = (fs::remove_file(&rows), fs::remove_file(&deg));
        for (path, unit) in [(&rows, ""), (&deg, "--unit deg,mm")] {
            let outcome = percuss(&format!("{line} --vary={name}=0:1:3 -o {path} {unit}"));
            assert_eq!(outcome.code, 0, "{name}: {}", outcome.stderr);
            let ignore = "row,status,effective_mass,closure_residual,singular_pose,motion_ratio,estimate,estimate_error_percent,\
                          effective_mass_kg,closure_residual_mm,estimate_kg";
            let header = fs::read_to_string(path).expect("written");
            let columns: Vec<&str> = header.lines().next().unwrap_or("").split(',').collect();
            let ignore: Vec<&str> = ignore.split(',').filter(|name| columns.contains(name)).collect();
            let flags: String = ignore.iter().map(|name| format!(" --ignore={name}")).collect();
            let outcome = percuss(&format!("{line} --input {path}{flags}"));
            assert_eq!(outcome.code, 0, "{name}: {}", outcome.stderr);
        }
    }
}

#[test]
fn meshes_name_the_line_of_a_fault() {
    let folder = Scratch::new("mesh-lines");
    for (name, text, words) in [
        ("a.obj", "v 0 0 0\nv 1 0\n", "line 2: three numbers are expected after \"v\""),
        ("b.obj", "v 0 0 0\n# x\nf 1 2 9\n", "line 3: a face names vertex 2 of 1"),
        ("c.obj", "v 0 0 0\nf 1 x 3\n", "line 2: \"x\" is no vertex of a face"),
        ("d.stl", "solid x\n\nfacet normal 0 0 1\n outer loop\n vertex 0 0\n", "line 5, facet 1: \"vertex\""),
        ("e.stl", "solid x\nfacet normal 0 0 1\n", "the file ends where \"outer loop\" is expected"),
    ] {
        folder.write(name, text);
        let urdf = fs::read_to_string(root().join(MODEL)).expect("a model").replacen(
            "<link name=\"rod\"/>",
            &format!("<link name=\"rod\"><collision><geometry><mesh filename=\"{name}\"/></geometry></collision></link>"),
            1,
        );
        assert!(urdf.contains(name), "the model has a link \"rod\" without content");
        let model = folder.write("model.urdf", &urdf);
        let outcome = percuss(&format!("map {model} --link rod"));
        assert!(outcome.code == 2 && outcome.stderr.contains(words), "{name}: {}", outcome.stderr);
    }
}
