//! Written files: after any end of a run, a file is old or new, never partial. Inputs and foreign files are unchanged.

use crate::support;
use crate::support::{Scratch, command, percuss};
use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::fs;
use std::process::Stdio;

const SWEEP: &str = "sweep models/point_mass_pendulum.urdf --link rod --point 0,0,-0.8 --normal 1,0,0";
const RANGES: [&str; 2] = ["hinge=0:30deg:400", "hinge=0:60deg:300"];

fn sweep(range: &str, path: &str) -> String {
    format!("{SWEEP} --vary {range} -o {path}")
}

/// A run is killed when its unfinished file has some number of bytes, drawn with a seed; a larger number than it gets means that
/// the run ends.
#[test]
fn a_killed_run_leaves_the_old_file_or_the_new_one() {
    let folder = Scratch::new("killed");
    let mut random = StdRng::seed_from_u64(7);
    let (mut kept, mut replaced) = (0, 0);
    for ending in ["csv", "json", "jsonl", "parquet", "svg", "xlsx"] {
        let path = folder.path(&format!("rows.{ending}"));
        let mut whole = Vec::new();
        for range in RANGES {
            let outcome = percuss(&sweep(range, &path));
            assert_eq!(outcome.code, 0, "{}", outcome.stderr);
            whole.push(fs::read(&path).expect("written"));
        }
        assert_ne!(whole[0], whole[1]);
        for i in 0..34 {
            let before = fs::read(&path).expect("there");
            let line = sweep(RANGES[i % 2], &path);
            let mut run = command(line.split_whitespace())
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .spawn()
                .expect("it starts");
            let part = folder.path(&format!(".rows.{ending}.{}.percuss-part", run.id()));
            let size = random.random_range(0..before.len() * 3 / 2) as u64;
            while run.try_wait().expect("a process of ours").is_none()
                && fs::metadata(&part).map_or(true, |found| found.len() < size)
            {
                std::thread::yield_now();
            }
            run.kill().expect("it is killed, or has ended");
            run.wait().expect("it ends");
            let after = fs::read(&path).expect("there");
            let is_whole = whole.contains(&after);
            assert!(is_whole, "{ending}, run {i}: {} bytes are neither file", after.len());
            if after == before { kept += 1 } else { replaced += 1 }
        }
    }
    // The next run to the same output removes the unfinished files of killed runs, and no other files.
    let others = [
        ".rows.csv.12.part",
        ".rows.csv.x.percuss-part",
        ".other.csv.12.percuss-part",
        "rows.csv.12.percuss-part",
    ];
    others.iter().for_each(|name| drop(folder.write(name, "of somebody else")));
    fs::create_dir_all(folder.path(".rows.csv.13.percuss-part")).expect("a folder");
    for ending in ["csv", "json", "jsonl", "parquet", "svg", "xlsx"] {
        assert_eq!(percuss(&sweep(RANGES[0], &folder.path(&format!("rows.{ending}")))).code, 0);
    }
    let names = fs::read_dir(folder.path("")).expect("a folder").flatten();
    let mut names: Vec<String> = names.map(|e| e.file_name().to_string_lossy().into_owned()).collect();
    names.retain(|name| name.contains("part"));
    names.sort();
    let mut expected: Vec<String> = others.iter().map(|name| (*name).to_owned()).collect();
    expected.push(".rows.csv.13.percuss-part".into());
    expected.sort();
    assert_eq!(names, expected);
    assert!(kept > 0 && replaced > 0, "{kept} kept, {replaced} replaced: no run was killed while it wrote");
}

/// Unix only: Windows shells have no limit of the file size.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_old_file() {
    let folder = Scratch::new("full");
    for ending in ["csv", "json", "jsonl", "parquet", "png", "svg", "pdf", "xlsx"] {
        let path = folder.path(&format!("rows.{ending}"));
        assert_eq!(percuss(&sweep(RANGES[0], &path)).code, 0);
        let before = fs::read(&path).expect("written");
        // Files are limited to one block, as by a full disk or a quota.
        let script = format!(
            "trap '' XFSZ; ulimit -f 1; exec {} {}",
            env!("CARGO_BIN_EXE_percuss"),
            sweep(RANGES[1], &path)
        );
        let run =
            std::process::Command::new("sh").current_dir(support::root()).args(["-c", &script]).output();
        let run = support::Outcome::from(run.expect("sh runs"));
        assert_eq!(run.code, 1, "{ending}: {}", run.stderr);
        assert!(run.stderr.contains("cannot be written"), "{}", run.stderr);
        assert!(fs::read(&path).expect("there") == before, "{ending} was touched");
    }
    let left: Vec<_> =
        fs::read_dir(folder.path("")).expect("a folder").flatten().map(|e| e.file_name()).collect();
    assert_eq!(left.len(), 8, "files beside: {left:?}");
}

/// Linux only: other systems have no full device.
#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_said() {
    let folder = Scratch::new("device");
    std::os::unix::fs::symlink("/dev/full", folder.path("full.csv")).expect("a link");
    let outcome = percuss(&sweep(RANGES[0], &folder.path("full.csv")));
    assert!(outcome.code == 1 && outcome.stderr.contains("cannot be written"), "{}", outcome.stderr);
    let full = fs::OpenOptions::new().write(true).open("/dev/full").expect("there");
    let line = format!("{SWEEP} --vary {}", RANGES[0]);
    let run = command(line.split_whitespace()).stdout(full).stderr(Stdio::piped()).output().expect("it runs");
    assert_eq!(run.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&run.stderr).contains("cannot be written"));
}

/// A file that another run writes and has locked is not removed.
#[test]
fn files_of_a_running_run_are_kept() {
    let folder = Scratch::new("locked");
    let (open, left) = (folder.path(".rows.csv.7.percuss-part"), folder.path(".rows.csv.8.percuss-part"));
    let file = fs::File::create(&open).expect("written");
    file.try_lock().expect("nobody else has it");
    fs::write(&left, "row,").expect("written");
    #[cfg(unix)]
    std::os::unix::fs::symlink(folder.path("aim"), folder.path(".rows.csv.9.percuss-part")).expect("a link");
    fs::write(folder.path("aim"), "of somebody else").expect("written");
    assert_eq!(percuss(&sweep(RANGES[0], &folder.path("rows.csv"))).code, 0);
    assert!(fs::exists(&open).expect("looked at") && !fs::exists(&left).expect("looked at"));
    assert_eq!(fs::read_to_string(folder.path("aim")).expect("there"), "of somebody else");
    drop(file);
    assert_eq!(percuss(&sweep(RANGES[0], &folder.path("rows.csv"))).code, 0);
    assert!(!fs::exists(&open).expect("looked at"));
}

/// Many runs write the same output at the same time: no run fails, and the file is the complete result of one run.
#[test]
fn runs_to_one_output_do_not_hinder_one_another() {
    let folder = Scratch::new("together");
    let path = folder.path("rows.csv");
    let start = |i: usize| {
        let line = sweep(RANGES[i % 2], &path);
        let quiet = || Stdio::null();
        command(line.split_whitespace()).stdout(quiet()).stderr(quiet()).spawn().expect("it starts")
    };
    let runs: Vec<_> = (0..24).map(start).collect();
    let ended = runs.into_iter().map(|mut run| run.wait().expect("it ends").code());
    assert!(ended.collect::<Vec<_>>().iter().all(|code| *code == Some(0)));
    let rows = fs::read_to_string(&path).expect("written").lines().count();
    assert!(rows == 401 || rows == 301, "{rows} lines");
    assert_eq!(fs::read_dir(folder.path("")).expect("a folder").count(), 1);
}

/// Meshes and the point table of a sheet are inputs: reported with their hashes, and refused as outputs.
#[test]
fn meshes_and_tables_of_points_are_inputs() {
    let folder = Scratch::new("more-inputs");
    let models = support::root().join("models");
    fs::create_dir_all(folder.path("meshes")).expect("a folder");
    fs::copy(models.join("meshes/finger.obj"), folder.path("meshes/finger.ply")).expect("copied");
    fs::copy(models.join("meshes/finger.obj"), folder.path("meshes/finger.obj")).expect("copied");
    let model = fs::read_to_string(models.join("shaped_arm.urdf")).expect("there");
    let model = folder.write("arm.urdf", &model);
    let report = support::json(&format!("map {model} --link finger --format json"));
    let inputs: Vec<&str> =
        report["inputs"].as_array().expect("a list").iter().filter_map(|i| i["path"].as_str()).collect();
    assert!(inputs.len() == 2 && inputs[1].ends_with("finger.obj"), "{inputs:?}");
    assert_eq!(report["inputs"][1]["sha256"].as_str().map(str::len), Some(64));
    #[cfg(unix)]
    {
        // A link with the extension of an output.
        std::os::unix::fs::symlink(folder.path("meshes/finger.obj"), folder.path("skin.ply"))
            .expect("a link");
        let line = format!("map {model} --link finger --force -o {}", folder.path("skin.ply"));
        let refused = percuss(&line);
        assert!(
            refused.code == 2 && refused.stderr.contains("an input file of the same run"),
            "{}",
            refused.stderr
        );
    }
    let suspensions = models.join("suspensions");
    for name in ["double-wishbone-with-table.toml", "double-wishbone-points.xlsx"] {
        fs::copy(suspensions.join(name), folder.path(name)).expect("copied");
    }
    let sheet = folder.path("double-wishbone-with-table.toml");
    let stop = "--link bump_stop_pad --point 0,0,0 --along-line bump_stop:0,0,0 --against chassis";
    let report = support::json(&format!("mass {sheet} {stop} --format json"));
    let inputs = report["inputs"].as_array().expect("a list");
    assert!(inputs.len() == 2 && inputs[1]["path"].as_str().is_some_and(|p| p.ends_with("points.xlsx")));
    let table = folder.path("double-wishbone-points.xlsx");
    let vary = "--vary travel:wheel_centre:0,0,0:0,0,1=-5mm:5mm:3";
    let refused = percuss(&format!("sweep {sheet} {stop} {vary} --force -o {table}"));
    assert!(
        refused.code == 2 && refused.stderr.contains("an input file of the same run"),
        "{}",
        refused.stderr
    );
}

/// On Windows, symbolic links need administrator rights, and a name in other case is the same file.
#[test]
fn an_input_is_no_output_by_any_path() {
    let folder = Scratch::new("inputs");
    let model = fs::read_to_string(support::root().join("models/point_mass_pendulum.urdf")).expect("there");
    // Names with the extension of an output.
    let model = folder.write("model.jsonl", &model);
    let hard = folder.path("hard.csv");
    fs::hard_link(&model, &hard).expect("a link");
    #[cfg(unix)]
    let others = {
        let [soft, round] = ["soft.csv", "round.csv"].map(|name| folder.path(name));
        std::os::unix::fs::symlink(&model, &soft).expect("a link");
        std::os::unix::fs::symlink(&soft, &round).expect("a link");
        [soft, round]
    };
    #[cfg(not(unix))]
    let others = [folder.path("MODEL.jsonl"), model.replace('\\', "/").to_lowercase()];
    let dotted = folder.path("./model.jsonl");
    let flags = "--link rod --point 0,0,-0.8 --normal 1,0,0 --vary hinge=0:1:3 --force";
    for output in [&model, &hard, &dotted].into_iter().chain(&others) {
        let before = fs::read(&model).expect("there");
        let outcome = percuss(&format!("sweep {model} {flags} -o {output}"));
        assert_eq!(outcome.code, 2, "{output}");
        assert!(outcome.stderr.contains("an input file of the same run"), "{}", outcome.stderr);
        assert!(fs::read(&model).expect("there") == before);
    }
    // Positions, and the sheet of a suspension with its table.
    let rows = folder.write("rows.csv", "hinge\n0\n0.1\n");
    let line = format!("{SWEEP} --input {rows} --force -o {rows}");
    assert!(percuss(&line).stderr.contains("an input file of the same run"));
    let sheet =
        fs::read_to_string(support::root().join("models/suspensions/double-wishbone.toml")).expect("there");
    let sheet = folder.write("sheet.toml", &sheet);
    let outcome = percuss(&format!("import {sheet} --force -o {sheet}"));
    assert!(
        outcome.code == 2 && outcome.stderr.contains("an input file of the same run"),
        "{}",
        outcome.stderr
    );
}

#[test]
fn foreign_files_are_replaced_on_demand_only() {
    let folder = Scratch::new("others");
    for ending in ["csv", "json", "jsonl", "parquet", "png", "svg", "pdf", "xlsx"] {
        let foreign = folder.write(&format!("rows.{ending}"), "not of percuss\n");
        let refused = percuss(&sweep(RANGES[0], &foreign));
        assert!(refused.code == 2 && refused.stderr.contains("--force"), "{ending}: {}", refused.stderr);
        assert_eq!(fs::read_to_string(&foreign).expect("there"), "not of percuss\n");
        let forced = percuss(&(sweep(RANGES[0], &foreign) + " --force"));
        assert_eq!(forced.code, 0, "{ending}: {}", forced.stderr);
        // Now the file is written by percuss.
        let again = percuss(&sweep(RANGES[1], &foreign));
        assert_eq!(again.code, 0, "{ending}: {}", again.stderr);
    }
    let damp = "damp --mass 2 --stiffness 1e5 --restitution 0.5 --speed 1 -o";
    for ending in ["csv", "svg", "png", "pdf"] {
        let path = folder.path(&format!("force.{ending}"));
        for _ in 0..2 {
            let outcome = percuss(&format!("{damp} {path}"));
            assert_eq!(outcome.code, 0, "{ending}: {}", outcome.stderr);
        }
    }
    let map = "map models/shaped_arm.urdf --all --edge 50mm";
    for ending in ["ply", "glb", "gltf", "svg", "png", "pdf", "csv", "json"] {
        let path = folder.path(&format!("map.{ending}"));
        for style in ["", "--unit mm", "--unit m --decimal comma", ""] {
            let outcome = percuss(&format!("{map} {style} -o {path}"));
            assert_eq!(outcome.code, 0, "{ending}: {}", outcome.stderr);
        }
    }
    let compare = "compare models/suspensions/double-wishbone.toml models/suspensions/double-wishbone-rods.toml \
        --link bump_stop_pad --point 0,0,0 --along-line bump_stop:0,0,0 --against chassis";
    for vary in ["", "--vary travel:spindle:0,0,0:0,0,1=-20mm:20mm:3"] {
        for ending in
            if vary.is_empty() { &["csv", "json"][..] } else { &["csv", "json", "svg", "png", "pdf"] }
        {
            let path = folder.path(&format!("designs.{ending}"));
            for style in ["", "--unit mm", "--unit m --decimal comma", ""] {
                let outcome = percuss(&format!("{compare} {vary} {style} -o {path}"));
                assert_eq!(outcome.code, 0, "{ending}: {}", outcome.stderr);
            }
        }
    }
    let import = "import models/suspensions/double-wishbone.toml -o";
    let path = folder.path("car.urdf");
    for _ in 0..2 {
        let outcome = percuss(&format!("{import} {path}"));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    }
    // An empty file has no content to protect.
    let empty = folder.write("empty.csv", "");
    assert_eq!(percuss(&sweep(RANGES[0], &empty)).code, 0);
}

#[test]
fn a_study_writes_outside_its_folder_on_demand_only() {
    let folder = Scratch::new("outside");
    let inner = folder.path("inner");
    fs::create_dir_all(&inner).expect("a folder");
    let study = |output: &str| {
        let model = support::root().join("models/point_mass_pendulum.urdf");
        let text = format!(
            "[model]\npath = '{}'\n[contact]\nlink = \"rod\"\npoint = [0, 0, -0.8]\nnormal = [1, 0, 0]\n\
             [sweep]\nvary = \"hinge=0:1:3\"\noutput = '{output}'\n",
            model.display()
        );
        folder.write("inner/study.toml", &text)
    };
    let outside = [folder.path("out.csv"), "../out.csv".to_owned()];
    for output in &outside {
        let path = study(output);
        let refused = percuss(&format!("run {path}"));
        assert!(refused.code == 2 && refused.stderr.contains("--allow-outside"), "{}", refused.stderr);
        assert!(!std::path::Path::new(&folder.path("out.csv")).exists());
    }
    let path = study("out.csv");
    assert_eq!(percuss(&format!("run {path}")).code, 0);
    assert!(std::path::Path::new(&folder.path("inner/out.csv")).exists());
    #[cfg(unix)]
    {
        // A link to a file outside the folder.
        std::os::unix::fs::symlink(folder.path("linked.csv"), folder.path("inner/link.csv")).expect("a link");
        fs::write(folder.path("linked.csv"), "row,hinge,status,effective_mass\n").expect("written");
        let refused = percuss(&format!("run {}", study("link.csv")));
        assert!(refused.code == 2 && refused.stderr.contains("--allow-outside"), "{}", refused.stderr);
    }
    let allowed = percuss(&format!("run {} --allow-outside", study("../out.csv")));
    assert_eq!(allowed.code, 0, "{}", allowed.stderr);
}
