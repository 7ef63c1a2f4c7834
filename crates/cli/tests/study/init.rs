//! `percuss init` for every model of the repository: the study runs unchanged, and with all its suggestions.

use crate::support::{Scratch, percuss, root, run};
use std::fs;

/// Files of a folder with the given ending.
fn shipped(folder: &str, ending: &str) -> Vec<String> {
    let names = fs::read_dir(root().join(folder)).expect("models are shipped").flatten();
    let names = names.map(|entry| format!("{folder}/{}", entry.file_name().to_string_lossy()));
    let mut names: Vec<String> = names.filter(|name| name.ends_with(ending)).collect();
    names.sort();
    names
}

/// Study with its suggestions enabled: lines that begin with "# " and a key or a table.
fn with_suggestions(study: &str) -> String {
    let suggested = |line: &str| {
        let rest = line.strip_prefix("# ")?;
        let is_key = rest.split_once(" = ").is_some_and(|(key, _)| {
            !key.is_empty() && key.chars().all(|c| c.is_ascii_lowercase() || c == '_')
        });
        (rest.starts_with('[') || is_key).then(|| rest.to_owned())
    };
    study.lines().map(|line| suggested(line).unwrap_or_else(|| line.to_owned()) + "\n").collect()
}

#[test]
fn every_shipped_model_has_a_study_that_runs() {
    let folder = Scratch::new("init");
    let models = [shipped("models", ".urdf"), shipped("models/suspensions", ".toml")].concat();
    let (mut finite, mut swept) = (0, 0);
    for (i, model) in models.iter().enumerate() {
        let study = folder.path(&format!("study{i}.toml"));
        let outcome = percuss(&format!("init {model} -o {study}"));
        assert_eq!(outcome.code, 0, "{model}: {}", outcome.stderr);
        let written = fs::read_to_string(&study).expect("written");
        let run = percuss(&format!("run {study} --format json"));
        assert_eq!(run.code, 0, "{model}: {}\n{written}", run.stderr);
        let answer: serde_json::Value = serde_json::from_str(&run.stdout).expect("JSON");
        finite += usize::from(answer["effective_mass"].as_f64().is_some_and(|m| m > 0.0));
        // Links and joints are named.
        let bodies = answer["bodies"].as_array().expect("a list");
        // Of a long list, only the first names are given.
        assert_eq!(written.contains(" more: percuss check"), bodies.len() > 40, "{model}");
        for body in bodies.iter().take(40) {
            assert!(written.contains(body["link"].as_str().expect("a name")), "{model}");
        }
        // All suggestions can be enabled together.
        let all = with_suggestions(&written);
        assert_ne!(all, written, "{model} suggests nothing");
        // The sweep below has all rows.
        let all = folder.write(&format!("all{i}.toml"), &all.replace(":25\"", ":3\""));
        let run = percuss(&format!("run {all}"));
        assert_eq!(run.code, 0, "{model}: {}\n{}", run.stderr, fs::read_to_string(&all).expect("there"));
        // The sweep alone, without variants, has a result in every row.
        if let Some(at) = written.find("# [sweep]") {
            let vary: Vec<&str> = written[at..].lines().skip(1).take(1).collect();
            let one = format!("{written}\n[sweep]\n{}\n", vary[0].trim_start_matches("# "));
            let run = percuss(&format!("run {}", folder.write("swept.toml", &one)));
            assert_eq!(run.code, 0, "{model}: {}", run.stderr);
            assert!(!run.stderr.contains("have no result"), "{model}: {}", run.stderr);
            swept += 1;
        }
    }
    assert!(models.len() >= 30 && finite == models.len(), "{finite} of {} are finite", models.len());
    assert!(swept > 20, "only {swept} have a sweep");
}

#[test]
fn a_study_made_is_the_users_own_and_finds_its_model() {
    let folder = Scratch::new("init-places");
    let model = fs::read_to_string(root().join("models/point_mass_pendulum.urdf")).expect("there");
    // Windows does not permit double quotes in file names.
    let (name, written) =
        if cfg!(unix) { ("a pendulum\"", "a pendulum\\\"") } else { ("a pendulum's", "a pendulum's") };
    let model = folder.write(&format!("{name}.urdf"), &model);
    fs::create_dir_all(folder.path("inner/most")).expect("a folder");
    let study = folder.path("inner/most/study.toml");
    let init = |more: &[&str]| {
        let words = ["init", &model, "-o", &study].into_iter().chain(more.iter().copied());
        run(words)
    };
    assert_eq!(init(&[]).code, 0);
    let text = fs::read_to_string(&study).expect("written");
    assert!(text.contains(&format!("path = \"../../{written}.urdf\"")), "{text}");
    assert_eq!(percuss(&format!("run {study}")).code, 0);
    // A study is edited by hand, so it is not replaced without --force.
    let again = init(&[]);
    assert!(again.code == 2 && again.stderr.contains("--force"), "{}", again.stderr);
    assert_eq!(init(&["--force"]).code, 0);
    // On stdout, the path is printed as given.
    let printed = percuss("init models/four_bar.urdf");
    assert!(printed.code == 0 && printed.stdout.contains("path = \"models/four_bar.urdf\""));
    for (line, words) in [
        ("init -", "MODEL -"),
        ("init models/none.urdf", "no such file"),
        ("init models/four_bar.toml", "this is a study"),
        ("init models/four_bar.urdf --link-mass crank=3", "model.link_mass"),
    ] {
        let refused = percuss(line);
        assert!(refused.code == 2 && refused.stderr.contains(words), "{line}: {}", refused.stderr);
    }
}

/// Names with a special meaning in TOML, in a shell or in a terminal.
#[test]
fn names_of_any_kind_are_written_so_that_they_are_read() {
    let folder = Scratch::new("init-names");
    let model = fs::read_to_string(root().join("models/double_pendulum.urdf")).expect("there");
    for (i, name) in [
        "a b",
        "it&apos;s",
        "&quot;q&quot;",
        "back\\slash",
        "= 1 #",
        "tab&#9;",
        "line&#10;[model]",
        "é.ß",
        "&#127;",
    ]
    .iter()
    .enumerate()
    {
        let named =
            model.replace("\"lower\"", &format!("\"{name}\"")).replace("\"elbow\"", &format!("\"{name}\""));
        let path = folder.write(&format!("model{i}.urdf"), &named);
        let study = folder.path(&format!("study{i}.toml"));
        let outcome = percuss(&format!("init {path} -o {study}"));
        assert_eq!(outcome.code, 0, "{name}: {}", outcome.stderr);
        let all = with_suggestions(&fs::read_to_string(&study).expect("written"));
        for study in [study, folder.write(&format!("all{i}.toml"), &all)] {
            let run = percuss(&format!("run {study}"));
            assert_eq!(run.code, 0, "{name}: {}\n{}", run.stderr, fs::read_to_string(&study).expect("there"));
        }
    }
}

/// As for other commands, - is the standard output.
#[test]
fn a_study_is_written_to_the_standard_output() {
    let [bare, dash] = ["", " -o -"].map(|flag| percuss(&format!("init models/four_bar.urdf{flag}")));
    assert_eq!((dash.code, dash.stdout), (0, bare.stdout));
    assert!(!root().join("-").exists());
}
