//! Files that percuss writes: the old one or the new one, never a part; inputs and what others wrote stay as they are.

mod support;

use rand::rngs::StdRng;
use rand::{Rng, SeedableRng};
use std::fs;
use std::process::Stdio;
use std::time::{Duration, Instant};
use support::{Scratch, command, percuss};

const SWEEP: &str = "sweep models/point_mass_pendulum.urdf --link rod --point 0,0,-0.8 --normal 1,0,0";
const RANGES: [&str; 2] = ["hinge=0:30deg:400", "hinge=0:60deg:300"];

fn sweep(range: &str, path: &str) -> String {
    format!("{SWEEP} --vary {range} -o {path}")
}

/// Seeded: the same delays in every run, whatever the machine makes of them.
#[test]
fn a_killed_run_leaves_the_old_file_or_the_new_one() {
    let folder = Scratch::new("killed");
    let mut random = StdRng::seed_from_u64(7);
    let (mut kept, mut replaced) = (0, 0);
    for ending in ["csv", "json", "jsonl", "parquet", "svg", "xlsx"] {
        let path = folder.path(&format!("rows.{ending}"));
        let mut whole = Vec::new();
        let mut longest = Duration::ZERO;
        for range in RANGES {
            let begun = Instant::now();
            let outcome = percuss(&sweep(range, &path));
            longest = longest.max(begun.elapsed());
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
            std::thread::sleep(longest.mul_f64(random.random_range(0.0..1.5)));
            run.kill().expect("it is killed, or has ended");
            run.wait().expect("it ends");
            let after = fs::read(&path).expect("there");
            let is_whole = whole.contains(&after);
            assert!(is_whole, "{ending}, run {i}: {} bytes are neither file", after.len());
            if after == before { kept += 1 } else { replaced += 1 }
        }
    }
    assert!(kept > 0 && replaced > 0, "{kept} kept, {replaced} replaced: no run was killed while it wrote");
}

#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_old_file() {
    let folder = Scratch::new("full");
    for ending in ["csv", "json", "jsonl", "parquet", "png", "svg", "pdf", "xlsx"] {
        let path = folder.path(&format!("rows.{ending}"));
        assert_eq!(percuss(&sweep(RANGES[0], &path)).code, 0);
        let before = fs::read(&path).expect("written");
        // No file of more than one block: what a full disk or a quota does.
        let script = format!(
            "trap '' XFSZ; ulimit -f 1; exec {} {}",
            env!("CARGO_BIN_EXE_percuss"),
            sweep(RANGES[1], &path)
        );
        let run =
            std::process::Command::new("sh").current_dir(support::root()).args(["-c", &script]).output();
        let run = support::Outcome::from(run.expect("sh runs"));
        assert_eq!(run.code, 2, "{ending}: {}", run.stderr);
        assert!(run.stderr.contains("cannot be written"), "{}", run.stderr);
        assert!(fs::read(&path).expect("there") == before, "{ending} was touched");
    }
    let left: Vec<_> =
        fs::read_dir(folder.path("")).expect("a folder").flatten().map(|e| e.file_name()).collect();
    assert_eq!(left.len(), 8, "files beside: {left:?}");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_said() {
    let folder = Scratch::new("device");
    std::os::unix::fs::symlink("/dev/full", folder.path("full.csv")).expect("a link");
    let outcome = percuss(&sweep(RANGES[0], &folder.path("full.csv")));
    assert!(outcome.code == 2 && outcome.stderr.contains("cannot be written"), "{}", outcome.stderr);
    let full = fs::OpenOptions::new().write(true).open("/dev/full").expect("there");
    let line = format!("{SWEEP} --vary {}", RANGES[0]);
    let run = command(line.split_whitespace()).stdout(full).stderr(Stdio::piped()).output().expect("it runs");
    assert_eq!(run.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&run.stderr).contains("cannot be written"));
}

#[cfg(unix)]
#[test]
fn an_input_is_no_output_by_any_path() {
    let folder = Scratch::new("inputs");
    let model = fs::read_to_string(support::root().join("models/point_mass_pendulum.urdf")).expect("there");
    // Names that end as outputs do.
    let model = folder.write("model.jsonl", &model);
    let [hard, soft, round] = ["hard.csv", "soft.csv", "round.csv"].map(|name| folder.path(name));
    fs::hard_link(&model, &hard).expect("a link");
    std::os::unix::fs::symlink(&model, &soft).expect("a link");
    std::os::unix::fs::symlink(folder.path("soft.csv"), &round).expect("a link");
    let dotted = folder.path("../x/model.jsonl").replace("../x", ".");
    let flags = "--link rod --point 0,0,-0.8 --normal 1,0,0 --vary hinge=0:1:3 --force";
    for output in [&model, &hard, &soft, &round, &dotted] {
        let before = fs::read(&model).expect("there");
        let outcome = percuss(&format!("sweep {model} {flags} -o {output}"));
        assert_eq!(outcome.code, 2, "{output}");
        assert!(outcome.stderr.contains("an input of the same run"), "{}", outcome.stderr);
        assert!(fs::read(&model).expect("there") == before);
    }
    // The positions, and a suspension's sheet with its table.
    let rows = folder.write("rows.csv", "hinge\n0\n0.1\n");
    let line = format!("{SWEEP} --input {rows} --force -o {rows}");
    assert!(percuss(&line).stderr.contains("an input of the same run"));
    let sheet =
        fs::read_to_string(support::root().join("models/suspensions/double-wishbone.toml")).expect("there");
    let sheet = folder.write("sheet.toml", &sheet);
    let outcome = percuss(&format!("import {sheet} --force -o {sheet}"));
    assert!(outcome.code == 2 && outcome.stderr.contains("an input of the same run"), "{}", outcome.stderr);
}

#[test]
fn what_percuss_did_not_write_is_replaced_on_demand_only() {
    let folder = Scratch::new("others");
    for ending in ["csv", "json", "jsonl", "parquet", "png", "svg", "pdf", "xlsx"] {
        let foreign = folder.write(&format!("rows.{ending}"), "not of percuss\n");
        let refused = percuss(&sweep(RANGES[0], &foreign));
        assert!(refused.code == 2 && refused.stderr.contains("--force"), "{ending}: {}", refused.stderr);
        assert_eq!(fs::read_to_string(&foreign).expect("there"), "not of percuss\n");
        let forced = percuss(&(sweep(RANGES[0], &foreign) + " --force"));
        assert_eq!(forced.code, 0, "{ending}: {}", forced.stderr);
        // Now it is of percuss.
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
    let map = "map models/scara.urdf --all";
    if support::root().join("models/scara.urdf").is_file() {
        for ending in ["ply", "glb", "gltf", "svg", "png", "csv", "json"] {
            let path = folder.path(&format!("map.{ending}"));
            for _ in 0..2 {
                let outcome = percuss(&format!("{map} -o {path}"));
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
    // A file of no bytes holds nothing.
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
        // A link that leads out.
        std::os::unix::fs::symlink(folder.path("linked.csv"), folder.path("inner/link.csv")).expect("a link");
        fs::write(folder.path("linked.csv"), "row,hinge,status,effective_mass\n").expect("written");
        let refused = percuss(&format!("run {}", study("link.csv")));
        assert!(refused.code == 2 && refused.stderr.contains("--allow-outside"), "{}", refused.stderr);
    }
    let allowed = percuss(&format!("run {} --allow-outside", study("../out.csv")));
    assert_eq!(allowed.code, 0, "{}", allowed.stderr);
}
