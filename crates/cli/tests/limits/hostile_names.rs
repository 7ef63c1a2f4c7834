//! Names, paths and lines of files that contain terminal commands or imitate lines of the output.

use crate::support::{Scratch, run};

/// A new line that imitates a result; the C1 control sequence introducer; reversed text; zero-width characters.
const HOSTILE: [&str; 4] =
    ["arm&#10;effective mass       0.001 kg", "arm&#x9b;2J", "arm\u{202e}gk 1", "arm\u{200b}\u{2066}x&#127;"];

fn model(name: &str) -> String {
    format!(
        "<robot name=\"r {name}\"><link name=\"base {name}\"/>\
         <link name=\"{name}\"><inertial><mass value=\"2\"/><origin xyz=\"0 0 -0.5\"/>\
         <inertia ixx=\"0.1\" iyy=\"0.1\" izz=\"0.1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial>\
         <collision><geometry><sphere radius=\"0.1\"/></geometry></collision></link>\
         <joint name=\"turn {name}\" type=\"revolute\"><parent link=\"base {name}\"/><child link=\"{name}\"/>\
         <axis xyz=\"0 1 0\"/><limit lower=\"-1\" upper=\"1\" effort=\"1\" velocity=\"1\"/></joint></robot>"
    )
}

fn plain(text: &str) -> String {
    text.replace("&#10;", "\n").replace("&#x9b;", "\u{9b}").replace("&#127;", "\u{7f}")
}

fn assert_harmless(text: &str, what: &str) {
    let is_raw = |c: char| {
        c.is_control() && c != '\n'
            || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
    };
    assert!(!text.contains(is_raw), "{what}: {text:?}");
    assert!(!text.lines().any(|line| line.starts_with("effective mass       0.001 kg")), "{what}: {text}");
}

#[test]
fn no_command_shows_a_name_raw() {
    let folder = Scratch::new("hostile");
    for (i, hostile) in HOSTILE.iter().enumerate() {
        let path = folder.write(&format!("model{i}.urdf"), &model(hostile));
        let name = plain(hostile);
        let contact = ["--link", &name, "--point", "0,0,-0.6", "--normal", "1,0,0"].map(str::to_owned);
        let with = |command: &str, more: &[&str]| {
            let mut all = vec![command.to_owned(), path.clone()];
            all.extend(contact.clone());
            all.extend(more.iter().map(|m| (*m).to_owned()));
            all
        };
        let turn = format!("turn {name}");
        let vary = format!("{turn}=0:0.5:3");
        let estimate = format!("{name}:0,0,0");
        let mass_from =
            ["damp".into(), "--mass-from".into(), path.clone()].into_iter().chain(contact.clone());
        let mut damp: Vec<String> = mass_from.collect();
        damp.extend(["--stiffness", "1e5", "--restitution", "0.5", "--for", "mujoco,ode"].map(str::to_owned));
        let study = format!(
            "[model]\npath = \"model{i}.urdf\"\n[contact]\nlink = {name:?}\npoint = [0, 0, -0.6]\nnormal = [1, 0, 0]\n"
        );
        let study = folder.write(&format!("study{i}.toml"), &study);
        let questions = [
            vec!["check".to_owned(), path.clone()],
            vec!["check".to_owned(), path.clone(), "--format".into(), "json".into()],
            with("mass", &["--estimate", &estimate, "--notes"]),
            with("mass", &["--format", "json"]),
            with("mass", &["--set", "nope=1"]),
            with("mass", &["--against", "nope"]),
            with("sweep", &["--vary", &vary, "--output", &folder.path(&format!("rows{i}.svg"))]),
            with("sweep", &["--vary", "nope=0:1:3"]),
            with("safe-speed", &["--region", "chest", "--force", "280"]),
            with("safe-speed", &["--region", &name, "--force", "280"]),
            vec!["map".to_owned(), path.clone(), "--all".into()],
            damp,
            vec!["run".to_owned(), study],
            vec![
                "mass".to_owned(),
                path.clone(),
                "--link".into(),
                format!("no {name}"),
                "--point".into(),
                name.clone(),
            ],
            vec![
                "mass".to_owned(),
                format!("missing {name}.urdf"),
                "--link".into(),
                name.clone(),
                "--point".into(),
                "0,0,0".into(),
                "--normal".into(),
                "1,0,0".into(),
            ],
            vec!["import".to_owned(), format!("missing {name}.toml"), "-o".into(), folder.path("x.urdf")],
            vec!["template".to_owned(), name.clone()],
        ];
        let mut answered = 0;
        for question in &questions {
            let outcome = run(question);
            let what = format!("{question:?}");
            assert_harmless(&outcome.stdout, &what);
            assert_harmless(&outcome.stderr, &what);
            answered += usize::from(outcome.code == 0);
            // No panic.
            assert!([0, 1, 2].contains(&outcome.code), "{what}: {}", outcome.code);
        }
        assert!(answered >= 8, "only {answered} of the questions about {name:?} were answered");
    }
}

#[test]
fn no_line_of_a_study_is_shown_raw() {
    let folder = Scratch::new("hostile-toml");
    for (i, line) in [
        "unknown\u{202e} = 1",
        "\"a\\u001b[2J\" = 1",
        "path = \"a\u{9b}2J\"\nbroken",
        "[model]\npath = \"\\u001b[2J.urdf\"\n[contact]\nlink = \"a\"\npoint = [0, 0, 0]\nnormal = [1, 0, 0]",
        "\"a\\neffective mass       0.001 kg\" = 1",
        "[model]\npath = \"x\"\naccept = [\"\\neffective mass       0.001 kg\"]\n[contact]\nlink = \"a\"\npoint = [0, 0, 0]\nnormal = [1, 0, 0]",
    ]
    .iter()
    .enumerate()
    {
        let path = folder.write(&format!("{i}.toml"), line);
        for command in ["run", "import"] {
            let more = if command == "import" { vec!["-o".to_owned(), folder.path("x.urdf")] } else { vec![] };
            let outcome = run([vec![command.to_owned(), path.clone()], more].concat());
            assert_eq!(outcome.code, 2, "{line:?}");
            assert!(!outcome.stderr.is_empty());
            assert_harmless(&outcome.stderr, line);
        }
    }
}

#[test]
fn cells_that_would_be_formulas_are_text() {
    let folder = Scratch::new("formulas");
    for name in ["=1+1", "+cmd", "-x", "@sum", "=HYPERLINK(&quot;x&quot;)"] {
        let path = folder.write("model.urdf", &model("arm").replace("turn arm", name));
        let joint = name.replace("&quot;", "\"");
        let line =
            ["mass", &path, "--link", "arm", "--point", "0,0,-0.6", "--normal", "1,0,0", "--format", "csv"];
        let outcome = run(line.map(str::to_owned));
        assert_eq!(outcome.code, 0, "{}", outcome.stderr);
        let cell = format!("\"'{}\"", joint.replace('"', "\"\""));
        assert!(outcome.stdout.contains(&cell), "{cell} is not in {}", outcome.stdout);
        let header = outcome.stdout.lines().next().expect("a header");
        assert!(!header.split(',').any(|c| c.starts_with(['=', '+', '-', '@'])), "{header}");
        // Numbers remain numbers.
        let vary =
            ["sweep", &path, "--link", "arm", "--point", "0,0,-0.6", "--normal", "1,0,0", "--random", "50"];
        let outcome = run(vary.map(str::to_owned));
        assert!(outcome.stdout.lines().skip(1).any(|row| row.contains(",-0.")), "{}", outcome.stdout);
        assert!(!outcome.stdout.contains("'-0."), "{}", outcome.stdout);
    }
}
