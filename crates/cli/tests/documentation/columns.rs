//! All output fits a terminal of 80 columns: results as text, help, lists, findings, errors; for every command and
//! every model of the repository. A wider line is a single word, such as a path: words are not broken, so that they
//! can be copied. Exceptions are sheets, models, and tables as CSV and JSON, which are files for programs, and the
//! snippets of `--for`, which follow the syntax of the simulator.

use crate::support::{Outcome, Scratch, percuss, root};
use unicode_width::UnicodeWidthStr;

const COLUMNS: usize = 80;
const SHEETS: [&str; 4] = ["double-wishbone", "pushrod-rocker", "solid-axle-watt", "multi-link"];

fn files(folder: &str, ending: &str) -> Vec<String> {
    let entries = std::fs::read_dir(root().join(folder)).expect("the folder is there");
    let names = entries.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned());
    let mut files: Vec<String> =
        names.filter(|name| name.ends_with(ending)).map(|name| format!("{folder}/{name}")).collect();
    files.sort();
    files
}

fn fits(what: &str, text: &str) -> usize {
    for line in text.lines() {
        let is_word = !line.trim().contains(' ');
        assert!(is_word || line.width() <= COLUMNS, "{what}: {} columns: {line}", line.width());
    }
    text.lines().count()
}

/// Runs a command; returns the number of output lines.
fn shows(line: &str) -> usize {
    let Outcome { stdout, shown, .. } = percuss(line);
    fits(line, &stdout) + fits(line, &shown)
}

/// Runs commands; each must print something.
fn all_show<S: AsRef<str>>(lines: impl IntoIterator<Item = S>) -> usize {
    let each = lines.into_iter().map(|line| {
        assert!(shows(line.as_ref()) > 0, "{} shows nothing", line.as_ref());
    });
    each.count()
}

#[test]
fn models_and_their_answers() {
    let mut commands = 0;
    for model in files("models", ".urdf") {
        let text = std::fs::read_to_string(root().join(&model)).expect("a model");
        commands += all_show([format!("check {model} --notes")]);
        let of_model = text.split("<?percuss ").skip(1).map(|rest| rest.split("?>").next().unwrap_or(""));
        for line in of_model {
            // The expected value is removed, so that tolerances of the parts can be requested.
            let words: Vec<&str> = line.split(' ').collect();
            let asked = words.chunk_by(|_, next| next.starts_with("--"));
            let asked: Vec<String> = asked
                .filter(|flag| !["--expect", "--tolerance"].contains(&flag[0]))
                .map(|flag| flag.join(" "))
                .collect();
            let asked = asked.join(" ");
            let damper = "--restitution 0.3 --stiffness 2e5 --speed 0.5";
            let parts = "--tolerance mass=2%,com=1mm,armature=10% --samples 3";
            commands += all_show([
                format!("{line} --notes"),
                format!("{asked} --explain {parts} --notes"),
                format!("{asked} {damper} --notes"),
            ]);
        }
    }
    // Six models contain their commands; 30 commands in total.
    assert!(commands >= 100, "{commands}");
}

#[test]
fn sheets_designs_and_studies() {
    let folder = Scratch::new("columns");
    let model = folder.path("model.urdf");
    for sheet in files("models/suspensions", ".toml") {
        all_show([format!("import {sheet} -o {model} --notes"), format!("check {model} --notes")]);
    }
    let stop = "--along-line bump_stop:0,0,0 --against chassis --point 0,0,0 --link bump_stop_pad";
    for name in SHEETS.iter().filter(|name| !name.starts_with("solid")) {
        let sheet = format!("models/suspensions/{name}.toml");
        let parts = "--tolerance mass=2%,com=1mm,point=0.5mm,armature=10% --samples 3 --seed 7";
        all_show([
            format!("mass {sheet} {stop} --explain {parts} --ratio-at wheel_centre:0,0,0"),
            format!("mass {sheet} {stop} --travel wheel_centre:0,0,0:0,0,1=20mm --lock spin"),
            format!("mass {sheet} {stop} --travel wheel_centre:0,0,0:0,0,1=3m"),
            format!("damp --mass-from {sheet} {stop} --stiffness 2e5 --restitution 0.3 --speed 0.5"),
        ]);
    }
    let sheets = "models/suspensions/double-wishbone.toml models/suspensions/double-wishbone-rods.toml";
    let vary = "--vary travel:spindle:0,0,0:0,0,1=-20mm:40mm:3";
    all_show([
        format!("compare {sheets} {stop}"),
        format!("compare {sheets} {stop} {vary}"),
        "compare models/studies/variants.toml".to_owned(),
        "run models/studies/variants.toml".to_owned(),
    ]);
    for study in files("models", ".toml") {
        all_show([format!("run {study} --format text")]);
    }
}

#[test]
fn maps_lists_and_safe_speeds() {
    let arm = "models/six_r_arm.urdf --link tool --point 0.08,0,0";
    all_show([
        "map models/shaped_arm.urdf --link forearm --edge 0.1",
        "map models/shaped_arm.urdf --all --edge 0.2",
        "map models/shaped_arm.urdf --link forearm --point 0.3,0,0 --directions 50",
        "template --list",
        "damp --list-laws",
        "damp --list-tools",
        "safe-speed --list-regions",
        &format!("safe-speed {arm} --normal 1,0,0 --region chest --force 280 --load 2kg"),
        &format!(
            "safe-speed {arm} --region chest --force 280 --worst-direction --direction 1,0,0 --direction 0,1,0"
        ),
        &format!("safe-speed {arm} --normal 1,0,0 --region skull --pressure 110 --area 1"),
        &format!("safe-speed {arm} --normal 1,0,0 --energy 10"),
        "damp --mass 12kg --stiffness 1e8 --exponent 1.5 --restitution 0.4 --speed 0.5",
        "impact models/four_bar.urdf --link coupler --point 0.35,0.1,0 --normal 0,1,0 --restitution 0.3 --speed 2",
        &format!(
            "impact {arm} --normal 0,1,0 --set elbow=40deg --restitution 0.1 --speed 1 --stiffness 2e5 --reflected elbow \
             --percussion elbow --rate-limit elbow=1"
        ),
    ]);
}

#[test]
fn exports_for_simulators_fit_a_terminal() {
    // All lines except the snippets for simulators, which are indented below their titles.
    let line = "damp --mass-from models/double_wishbone.urdf --link bump_stop_pad --point 0,0,0 \
        --along-line bump_stop:0,0,0 --against chassis --stiffness 2e5 --restitution 0.3 --speed 0.5 --for all --details";
    let outcome = percuss(line);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let mut lines = 0;
    let (mut is_snippet, mut simulators) = (false, 0);
    for text in outcome.stdout.lines() {
        is_snippet = text.starts_with("    ") && (is_snippet || !text.starts_with("     "));
        if !is_snippet {
            lines += fits(line, text);
        }
        simulators += usize::from(text.starts_with("  integrates"));
    }
    assert!(simulators >= 12 && lines > 100, "{simulators} simulators, {lines} lines");
}

#[test]
fn findings_and_errors() {
    let mut seen = 0;
    for folder in ["tests/malformed", "tests/malformed/warned"] {
        seen += all_show(files(folder, ".urdf").iter().map(|file| format!("check {file} --notes")));
    }
    let pendulum = "models/point_mass_pendulum.urdf";
    seen += all_show([
        format!("mass {pendulum} --link nope --point 0,0,0 --normal 1,0,0"),
        format!("mass {pendulum} --link rod --point 0,0 --normal 1,0,0"),
        format!("mass {pendulum} --link rod --point 0,0,-0.8 --normal 1,0,0 --expect 1"),
        format!("mass {pendulum} --link rod --point 0,0,-0.8 --normal 1,0,0 --set nope=1 --lock hinge"),
        format!("mass {pendulum} --link rod --point 0,0,-0.8 --normal 1,0,0 --tolerance 1e-3"),
        format!("mass {pendulum} --point 0,0,-0.8"),
        format!(
            "mass {pendulum} --link rod --point 0,0,-0.8 --normal 1,0,0 --along-line rod:0,0,0 --against nope"
        ),
        format!("sweep {pendulum} --link rod --point 0,0,-0.8 --normal 1,0,0"),
        format!(
            "sweep {pendulum} --link rod --point 0,0,-0.8 --normal 1,0,0 --vary hinge=0:1:3 --output a.xyz"
        ),
        format!("mass {} --link rod --point 0,0,0 --normal 1,0,0", "folder/".repeat(30)),
        "import models/suspensions/double-wishbone.toml".to_owned(),
        "import models/point_mass_pendulum.urdf -o /nowhere/at/all/model.urdf".to_owned(),
        "damp --mass 12kg --stiffness 400N/mm".to_owned(),
        "damp --mass 12kg --stiffness 400N/mm --restitution 0.4 --for nothing".to_owned(),
        "damp --limit hinge --mass 3".to_owned(),
        "safe-speed models/six_r_arm.urdf --link tool --point 0,0,0 --normal 1,0,0 --region nose --force 3"
            .to_owned(),
        "template nothing".to_owned(),
        "run models/nothing.toml".to_owned(),
        "nothing".to_owned(),
        String::new(),
    ]);
    assert!(seen > 80, "{seen}");
}

#[test]
fn help_of_every_command() {
    let commands = [
        "check",
        "mass",
        "sweep",
        "compare",
        "map",
        "template",
        "import",
        "damp",
        "safe-speed",
        "impact",
        "generate",
        "run",
        "completions",
        "",
    ];
    for command in commands {
        let short = percuss(&format!("{command} -h"));
        let long = percuss(&format!("{command} --help"));
        assert_eq!((short.code, long.code), (0, 0), "{command}");
        // One screen: at most 40 lines.
        assert!(fits(command, &short.stdout) <= 40, "{}", short.stdout);
        assert!(fits(command, &long.stdout) > 8, "{}", long.stdout);
        // Each flag of the short help occurs in the long help.
        let flags = |text: &str| {
            let words = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '-'));
            let mut flags: Vec<String> =
                words.filter(|w| w.len() > 2 && w.starts_with("--")).map(str::to_owned).collect();
            flags.sort();
            flags.dedup();
            flags
        };
        let known = flags(&long.stdout);
        for flag in flags(&short.stdout) {
            assert!(known.contains(&flag), "{command}: {flag}");
        }
    }
}
