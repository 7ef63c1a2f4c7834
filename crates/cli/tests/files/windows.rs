//! Paths, files and shells on Windows. packaging/windows.sh tests the behaviour that needs a console.
#![cfg(windows)]

use crate::support::{Outcome, Scratch, command, percuss, root};
use std::fs::{self, OpenOptions};
use std::os::windows::fs::OpenOptionsExt;

const PENDULUM: &str = "--link rod --point 0,0,-0.8 --normal 1,0,0";

fn pendulum() -> String {
    fs::read_to_string(root().join("models/point_mass_pendulum.urdf")).expect("a model")
}

/// Runs `percuss mass` on the pendulum in a file, from a folder.
fn mass_of(path: &str, folder: &str) -> Outcome {
    let mut command = command(["mass", path].into_iter().chain(PENDULUM.split(' ')));
    command.current_dir(folder).output().expect("it runs").into()
}

#[test]
fn every_spelling_of_a_path_is_read() {
    let scratch = Scratch::new("windows-paths");
    let folder = scratch.path("vorne links ä");
    fs::create_dir_all(&folder).expect("a folder");
    let path = scratch.write(r"vorne links ä\Pendel ü.urdf", &pendulum());
    let (drive, rooted) = path.split_at(2);
    assert!(drive.ends_with(':') && rooted.starts_with('\\'), "{path}");
    for path in [
        path.clone(),
        path.replace('\\', "/"),
        path.to_uppercase(),
        format!(r"\\?\{path}"),
        path.replacen('\\', r"\.\", 1),
        // On the drive of the working directory: from its root, and from the directory itself.
        rooted.to_owned(),
        format!("{drive}Pendel ü.urdf"),
        r".\Pendel ü.urdf".to_owned(),
        r"..\vorne links ä/Pendel ü.urdf".to_owned(),
    ] {
        let outcome = mass_of(&path, &folder);
        assert_eq!(outcome.code, 0, "{path}: {}", outcome.stderr);
        assert!(outcome.stdout.contains("0.78125 kg"), "{path}: {}", outcome.stdout);
    }
    let missing = mass_of(r"Q:\nothing\at all.urdf", &folder);
    assert_eq!(missing.code, 2);
    assert!(missing.stderr.contains(r"Q:\nothing\at all.urdf"), "{}", missing.stderr);
}

/// Study in the temporary folder with its model in the repository, possibly on another drive.
#[test]
fn a_study_finds_its_model_on_any_drive() {
    let folder = Scratch::new("windows-drives");
    let study = folder.path("study.toml");
    let model = root().join("models").join("point_mass_pendulum.urdf").to_string_lossy().into_owned();
    let outcome = percuss(&format!("init {model} -o {study}"));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let text = fs::read_to_string(&study).expect("written");
    let path = text.lines().find(|line| line.starts_with("path = ")).expect("a path");
    let is_other = model.as_bytes()[0] != study.as_bytes()[0];
    let begin = if is_other { format!("path = \"{}:/", &model[..1]) } else { "path = \"../".to_owned() };
    assert!(path.starts_with(&begin) && !path.contains('\\'), "{path}");
    let outcome = percuss(&format!("run {study}"));
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    // Written by hand with backslashes, quoted for TOML.
    let quoted = model.replace('\\', "\\\\");
    for path in [format!("path = '{model}'"), format!("path = \"{quoted}\"")] {
        let by_hand: String = text
            .lines()
            .map(|line| if line.starts_with("path = ") { path.as_str() } else { line })
            .map(|l| l.to_owned() + "\r\n")
            .collect();
        let outcome = percuss(&format!("run {}", folder.write("by-hand.toml", &by_hand)));
        assert_eq!(outcome.code, 0, "{path}: {}", outcome.stderr);
    }
}

#[test]
fn meshes_are_found_by_any_name() {
    let folder = Scratch::new("windows-meshes");
    fs::create_dir_all(folder.path("arm/meshes")).expect("a folder");
    let mesh = folder.path("arm\\meshes\\finger.obj");
    fs::copy(root().join("models/meshes/finger.obj"), &mesh).expect("copied");
    let model = fs::read_to_string(root().join("models/shaped_arm.urdf")).expect("a model");
    let named = "filename=\"meshes/finger.obj\"";
    assert!(model.contains(named));
    let slashes = mesh.replace('\\', "/");
    for name in [
        "meshes\\finger.obj".to_owned(),
        format!("file:///{slashes}"),
        format!("file://localhost/{slashes}"),
        slashes.clone(),
        mesh.clone(),
        "package://arm/meshes/finger.obj".to_owned(),
    ] {
        let path = folder.write("arm/arm.urdf", &model.replace(named, &format!("filename=\"{name}\"")));
        let outcome = percuss(&format!("map {path} --link finger --edge 50mm"));
        assert_eq!(outcome.code, 0, "{name}: {}", outcome.stderr);
    }
    // Paths that were tried are shown in the notation of Windows.
    let path =
        folder.write("arm/arm.urdf", &model.replace(named, "filename=\"package://arm/meshes/none.obj\""));
    let outcome = percuss(&format!("map {path} --link finger"));
    assert_eq!(outcome.code, 2);
    assert!(outcome.stderr.contains("none.obj") && !outcome.stderr.contains(r"\\?\"), "{}", outcome.stderr);
}

/// A spreadsheet keeps a table open and prevents writing; a viewer permits only reading. The file remains unchanged,
/// and the message names it.
#[test]
fn a_file_that_another_program_holds_is_left_whole() {
    const SHARED_FOR_READING: u32 = 1;
    let folder = Scratch::new("windows-held");
    let path = folder.path("rows.csv");
    let line = format!("sweep models/point_mass_pendulum.urdf {PENDULUM} --vary hinge=0:1:3 -o {path}");
    assert_eq!(percuss(&line).code, 0);
    let before = fs::read(&path).expect("written");
    let line = line.replace("hinge=0:1:3", "hinge=0:1:5");
    for share in [0, SHARED_FOR_READING] {
        let held =
            OpenOptions::new().read(true).write(share == 0).share_mode(share).open(&path).expect("there");
        let outcome = percuss(&line);
        drop(held);
        assert_eq!(outcome.code, 2, "{share}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(&format!("{path} cannot be written: ")), "{}", outcome.stderr);
        assert!(fs::read(&path).expect("there") == before, "{share}");
        assert_eq!(fs::read_dir(folder.path("")).expect("a folder").count(), 1, "files beside");
    }
    assert_eq!(percuss(&line).code, 0);
    assert_eq!(fs::read_to_string(&path).expect("there").lines().count(), 6);
}

/// Line ends of the output are the same as on other systems, even if redirected: files have the same bytes.
#[test]
fn lines_end_as_on_other_systems() {
    let folder = Scratch::new("windows-lines");
    let path = folder.path("rows.csv");
    let line = format!("sweep models/point_mass_pendulum.urdf {PENDULUM} --vary hinge=0:1:3");
    let printed = percuss(&line).stdout;
    assert!(printed.lines().count() == 4 && !printed.contains('\r'), "{printed:?}");
    assert_eq!(percuss(&format!("{line} -o {path}")).code, 0);
    assert_eq!(fs::read_to_string(path).expect("written"), printed);
}
