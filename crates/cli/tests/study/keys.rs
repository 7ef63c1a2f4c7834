//! Keys of a study: every misspelt key is refused with the correct key and the line; the page about studies lists all
//! keys.

use crate::support::{Scratch, percuss, root};
use serde_json::Value;
use std::collections::BTreeSet;

/// Keys of a table of the schema as pairs of table path (dotted) and key, including the tables below.
fn keys(schema: &Value, path: &str, found: &mut Vec<(String, String)>) {
    let of = |word: &str| schema.get(word).and_then(Value::as_array).cloned().unwrap_or_default();
    for one in [vec![schema.clone()], of("anyOf")].concat() {
        for (key, below) in one.get("properties").and_then(Value::as_object).into_iter().flatten() {
            found.push((path.to_owned(), key.clone()));
            let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
            keys(below, &path, found);
        }
        if let Some(items) = one.get("items") {
            keys(items, path, found);
        }
    }
}

fn all_keys() -> Vec<(String, String)> {
    let outcome = percuss("schema");
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let mut found = Vec::new();
    keys(&serde_json::from_str(&outcome.stdout).expect("JSON"), "", &mut found);
    // The contact of a variant has the keys of [contact].
    found.retain(|(table, _): &(String, String)| !table.starts_with("variant.contact"));
    assert!(found.len() > 100, "only {} keys", found.len());
    found
}

/// A key with one letter missing, doubled or replaced, or with two letters exchanged; also with capitals and hyphens.
fn misspelt(key: &str) -> Vec<String> {
    let letters: Vec<char> = key.chars().collect();
    let mut found = BTreeSet::new();
    for i in 0..letters.len() {
        let mut without = letters.clone();
        without.remove(i);
        let mut doubled = letters.clone();
        doubled.insert(i, letters[i]);
        let mut other = letters.clone();
        other[i] = if letters[i] == 'x' { 'y' } else { 'x' };
        let mut swapped = letters.clone();
        swapped.swap(i, (i + 1).min(letters.len() - 1));
        for changed in [without, doubled, other, swapped] {
            found.insert(changed.into_iter().collect::<String>());
        }
    }
    found.insert(key.replace('_', "-"));
    found.insert(key[..1].to_uppercase() + &key[1..]);
    found.remove(key);
    found.remove("");
    found.into_iter().collect()
}

/// Unknown keys in one study: below the number that is reported.
const REPORTED: usize = 16;

#[test]
fn every_key_misspelt_by_a_letter_is_refused_with_the_right_one_and_its_line() {
    let folder = Scratch::new("misspelt");
    let all = all_keys();
    let (mut tried, mut at_once) = (0, 0);
    for (table, key) in &all {
        let siblings: BTreeSet<&str> =
            all.iter().filter(|(t, _)| t == table).map(|(_, k)| k.as_str()).collect();
        // A misspelling that is another valid key, such as axis for axis2, cannot be detected.
        let wrong: Vec<String> =
            misspelt(key).into_iter().filter(|w| !siblings.contains(w.as_str())).collect();
        // Many misspellings are in one study, each on its own line: the parser reports up to a limit.
        for wrong in wrong.chunks(REPORTED) {
            let mut text = String::from("# a study\n\n");
            let mut lines = Vec::new();
            for word in wrong {
                if table.is_empty() {
                    text += &format!("{word} = 1\n");
                } else {
                    let dots: Vec<&str> = table.split('.').collect();
                    // Lists of tables start a new table; other tables must not be repeated.
                    let lists = ["closure", "hold", "variant", "contact.ratio_at"];
                    match &dots[..] {
                        [one] if lists.contains(one) => text += &format!("[[{one}]]\n{word} = 1\n"),
                        [one] if lines.is_empty() => text += &format!("[{one}]\n{word} = 1\n"),
                        [_] => text += &format!("{word} = 1\n"),
                        [_, _] if lists.contains(&table.as_str()) => {
                            text += &format!("[[{table}]]\n{word} = 1\n")
                        }
                        [one, two] if lines.is_empty() => text += &format!("[{one}.{two}]\n{word} = 1\n"),
                        [_, _] => text += &format!("{word} = 1\n"),
                        other => panic!("a table of more than two names: {other:?}"),
                    }
                }
                lines.push((word, text.lines().count()));
            }
            let path = folder.write("study.toml", &text);
            let outcome = percuss(&format!("run {path}"));
            assert_eq!(outcome.code, 2, "{text}");
            let whole = |key: &str| if table.is_empty() { key.to_owned() } else { format!("{table}.{key}") };
            for (word, line) in lines {
                let begin = format!("{path}:{line}: error: unknown key \"{}\"; did you mean ", whole(word));
                let found = outcome.stderr.lines().find(|shown| shown.starts_with(&begin));
                let found = found.unwrap_or_else(|| panic!("{begin} is not in\n{}", outcome.stderr));
                assert!(found.contains(&format!("\"{}\"", whole(key))), "{found}: {key} was meant");
                tried += 1;
            }
        }
        at_once += 1;
    }
    assert!(tried > 2000 && at_once == all.len(), "{tried} keys misspelt of {at_once}");
}

/// A wrong value of any key of the second variant is named by this key and its line, for one contact and for two, by `run` and by `compare`
/// with another study before it.
#[test]
fn keys_of_variants_are_named() {
    let folder = Scratch::new("variants");
    let head = format!("[model]\npath = {:?}\n", root().join("models/four_bar.urdf").display().to_string());
    let contact = "link = 'coupler'\npoint = [0.3, 0, 0]\nnormal = [0, 1, 0]\n";
    let one = format!("[contact]\n{contact}");
    let two = format!("[[contact]]\nname = 'c'\n{contact}[[contact]]\nname = 'd'\n{contact}");
    let first = folder.write("first.toml", &format!("{head}{one}"));
    let of_point = "link = 'crank', point = [0, 0, 0]";
    let of_contact = format!("{of_point}, normal = [0, 1, 0]");
    let wrong = [
        ("model", "'none.urdf'".to_owned()),
        ("link_mass", "{ none = 1 }".into()),
        ("link_mass", "{ crank = -1 }".into()),
        ("link_com", "{ crank = [1e200, 0, 0] }".into()),
        ("link_inertia", "{ crank = [1, 1, 5] }".into()),
        ("move", "{ none = [1, 1, 1] }".into()),
        ("armature", "{ none = 1 }".into()),
        ("armature", "{ crank_pin = -1 }".into()),
        ("armature", "{ crank_pin = [1, 2] }".into()),
        ("set", "{ none = 1 }".into()),
        ("set", "{ crank_hinge = '5 kg' }".into()),
        ("set", "{ crank_hinge = [1, 2] }".into()),
        ("set", "{ rocker_hinge = 1 }".into()),
        ("contact", "{ link = 'crank' }".into()),
        ("contact", format!("{{ {of_point} }}")),
        ("contact.at", "{ at = 'none' }".into()),
        (
            "contact.ratio_at",
            format!("{{ {of_contact}, ratio_at = [{{ link = 'none', point = [0, 0, 0] }}] }}"),
        ),
        ("contact.estimate", format!("{{ {of_contact}, estimate = {{ links = ['none'] }} }}")),
        ("contact.estimate.links", format!("{{ {of_contact}, estimate = {{ links = [] }} }}")),
        ("contact.link", "{ link = 'none', point = [0, 0, 0], normal = [0, 1, 0] }".into()),
        ("contact.point", "{ link = 'crank', point = [1e200, 0, 0], normal = [0, 1, 0] }".into()),
        ("contact.normal", format!("{{ {of_point}, normal = [0, 0, 0] }}")),
        ("contact.about_axis", "{ link = 'crank', about_axis = [0, 0, 0] }".into()),
        (
            "contact.along_line",
            format!("{{ {of_point}, along_line = {{ link = 'none', point = [0, 0, 0] }} }}"),
        ),
        ("contact.turning_normal", format!("{{ {of_contact}, turning_normal = true }}")),
        ("contact.cable", format!("{{ {of_contact}, cable = true }}")),
        ("contact.frame", format!("{{ {of_contact}, frame = 'none' }}")),
        ("contact.normal_frame", format!("{{ {of_contact}, normal_frame = 'none' }}")),
        ("contact.against", format!("{{ {of_contact}, against = 'crank' }}")),
        ("contact.against_mass", format!("{{ {of_contact}, against_mass = -1 }}")),
    ];
    let missing: Vec<String> = all_keys()
        .into_iter()
        .filter(|(table, key)| match table.as_str() {
            "variant" => {
                key != "name" && !wrong.iter().any(|(tried, _)| tried.split('.').next() == Some(key))
            }
            "contact" => {
                key != "name" && !wrong.iter().any(|(tried, _)| tried.strip_prefix("contact.") == Some(key))
            }
            _ => false,
        })
        .map(|(table, key)| format!("{table}.{key}"))
        .collect();
    assert!(missing.is_empty(), "keys without a wrong value: {missing:?}");
    for contacts in [&one, &two] {
        for (key, value) in &wrong {
            let table = key.split('.').next().expect("a key");
            let text = format!(
                "{head}{contacts}[[variant]]\nname = 'a'\nset.crank_hinge = 0.1\n[[variant]]\nname = 'b'\n{table} = {value}\n"
            );
            let path = folder.write("study.toml", &text);
            let begin = format!("{path}:{}: error: variant[1].{key}", text.lines().count());
            for command in
                [format!("run {path}"), format!("compare {path}"), format!("compare {first} {path}")]
            {
                let outcome = percuss(&command);
                assert!(
                    outcome.code == 2 && outcome.stderr.starts_with(&begin),
                    "{text}{begin}\n{}",
                    outcome.stderr
                );
            }
        }
    }
}

/// Block of all keys in docs/reference/STUDIES.md.
#[test]
fn the_page_has_every_key() {
    let page = std::fs::read_to_string(root().join("docs/reference/STUDIES.md")).expect("the page");
    let block = page.split("```toml\n").nth(1).and_then(|rest| rest.split("```").next()).expect("a block");
    let folder = Scratch::new("page");
    let path = folder.write("study.toml", block);
    // The block fits no model, but its keys are known and complete.
    let outcome = percuss(&format!("run {path}"));
    assert!(outcome.code == 2 && !outcome.stderr.contains("unknown key"), "{}", outcome.stderr);
    assert!(!outcome.stderr.contains("not TOML"), "{}", outcome.stderr);
    for (table, key) in all_keys() {
        let first = table.split('.').next().unwrap_or("");
        let at = if table.is_empty() { Some(block) } else { block.split(&format!("[{first}]")).nth(1) };
        let at =
            at.unwrap_or_else(|| panic!("[{first}] is not on the page")).split("\n[").next().unwrap_or("");
        let at = if table.is_empty() { block } else { at };
        assert!(at.contains(&key), "{table}.{key} is not on the page");
    }
}

/// Parts of a study give the same output as the corresponding commands.
#[test]
fn a_study_answers_as_the_commands_do() {
    let folder = Scratch::new("as-commands");
    let model = root().join("models/shaped_arm.urdf");
    let model = model.to_string_lossy();
    let run = |text: &str| {
        let path = folder.write("study.toml", &format!("[model]\npath = {model:?}\n{text}"));
        let outcome = percuss(&format!("run {path}"));
        assert_eq!(outcome.code, 0, "{text}\n{}", outcome.stderr);
        outcome.stdout
    };
    let printed = |line: &str| {
        let outcome = percuss(line);
        assert_eq!(outcome.code, 0, "{line}\n{}", outcome.stderr);
        outcome.stdout
    };
    let contact = "[contact]\nlink = \"finger\"\npoint = [0.1, 0, 0]\nnormal = [0, 1, 0]\n";
    let flags = "--link finger --point 0.1,0,0 --normal 0,1,0";
    let mass = printed(&format!("mass {model} {flags} --explain --tolerance mass=2% --samples 20 --seed 3"));
    let of_mass = "[mass]\nexplain = true\ntolerance = \"mass=2%\"\nsamples = 20\nseed = 3\n";
    assert_eq!(run(&format!("{contact}{of_mass}")), mass);
    // Without a contact: a stop, a map, directions.
    let stop = "[damping]\nlimit = \"elbow:upper\"\nrestitution = 0.3\nstiffness = \"50 Nm/rad\"\nspeed = \"30 deg/s\"\n";
    let flags_of_stop = "--limit elbow:upper --restitution 0.3 --stiffness 50Nm/rad --speed 30deg/s";
    assert_eq!(run(stop), printed(&format!("damp --mass-from {model} {flags_of_stop}")));
    assert_eq!(
        run("[map]\nall = true\nedge = \"50 mm\"\n"),
        printed(&format!("map {model} --all --edge 50mm"))
    );
    let directions = "[map]\nlink = \"forearm\"\npoint = [0.3, 0, 0]\ndirections = 50\n";
    assert_eq!(
        run(directions),
        printed(&format!("map {model} --link forearm --point 0.3,0,0 --directions 50"))
    );
    // With a contact: the result of the contact comes first.
    let safe = printed(&format!("safe-speed {model} {flags} --region chest --force 280 --load 1kg"));
    let of_safe = "[safe_speed]\nregion = \"chest\"\nforce = 280\nload = \"1 kg\"\n";
    let both = run(&format!("{contact}{of_safe}"));
    assert!(both.contains(" kg  effective mass at ") && both.ends_with(&safe), "{both}");
    let worst = printed(&format!(
        "safe-speed {model} --link finger --point 0.1,0,0 --worst-direction --direction 1,0,0 --energy 3"
    ));
    let of_worst = "[contact]\nlink = \"finger\"\npoint = [0.1, 0, 0]\n[safe_speed]\nworst_direction = true\ndirection = [[1, 0, 0]]\nenergy = 3\n";
    assert_eq!(run(of_worst), worst);
    // Tables and figures are the same as with flags.
    let style = "--unit mm,deg --decimal comma";
    let rows = printed(&format!("sweep {model} {flags} --vary elbow=-1:1:5 {style}"));
    let of_rows = "[sweep]\nvary = \"elbow=-1:1:5\"\nunit = [\"mm\", \"deg\"]\ndecimal = \"comma\"\n";
    assert_eq!(run(&format!("{contact}{of_rows}")), rows);
    let svg = folder.path("flags.svg");
    printed(&format!(
        "sweep {model} {flags} --vary elbow=-1:1:5 --title Elbow --x-limits -50:50 --y-limits 0:9 -o {svg}"
    ));
    let of_figure = "[sweep]\nvary = \"elbow=-1:1:5\"\ntitle = \"Elbow\"\nx_limits = [-50, 50]\ny_limits = [0, 9]\noutput = \"study.svg\"\n";
    run(&format!("{contact}{of_figure}"));
    let read = |name: &str| std::fs::read_to_string(folder.path(name)).expect("written");
    assert_eq!(read("study.svg"), read("flags.svg"));
    // An expected value that is not met.
    let missed = folder.write(
        "missed.toml",
        &format!("[model]\npath = {model:?}\n{contact}[mass]\nexpect = 3\ntolerance = 0.01\n"),
    );
    assert_eq!(percuss(&format!("run {missed}")).code, 1);
}

/// Keys that a question needs beside the one with the wrong value; a key with an empty value is left out.
const BESIDE: [(&str, &str); 29] = [
    ("impact", "restitution=0.3 speed=1"),
    ("impact.exponent", "stiffness=1e5"),
    ("impact.law", "stiffness=1e5"),
    ("impact.in_time", "stiffness=1e5"),
    ("impact.gravity", "stiffness=1e5 in_time=true"),
    ("impact.joint_spring", "stiffness=1e5 in_time=true"),
    ("impact.also_restitution", "also='coupler:0.1,0,0:0,1,0'"),
    ("impact.stiffness_ratio", "also='coupler:0.1,0,0:0,1,0'"),
    ("impact.contact_exponent", "also='coupler:0.1,0,0:0,1,0'"),
    ("impact.restitution_law", "friction=0.3"),
    ("impact.point_error", "percussion='crank_hinge'"),
    ("extremes.stiffness", "quantity='peak:crank_hinge' restitution=0.3 speed=1"),
    ("extremes.restitution", "quantity='peak:crank_hinge' stiffness=1e5 speed=1"),
    ("extremes.speed", "quantity='peak:crank_hinge' restitution=0.3 stiffness=1e5"),
    ("extremes.exponent", "quantity='peak:crank_hinge' restitution=0.3 stiffness=1e5 speed=1"),
    ("extremes.law", "quantity='peak:crank_hinge' restitution=0.3 stiffness=1e5 speed=1"),
    ("sweep", "vary='crank_hinge=0:1:3'"),
    ("sweep.random", "vary="),
    ("sweep.seed", "vary= random=5"),
    ("damping", "restitution=0.3 stiffness=1e5 speed=1"),
    ("damping.own_mass", "for=['chrono']"),
    ("safe_speed", "region='chest' force=200"),
    ("safe_speed.area", "force= pressure=1e5"),
    ("safe_speed.pressure", "force= area=1e-4"),
    ("safe_speed.energy", "force="),
    ("safe_speed.momentum", "force="),
    ("map", "directions=20"),
    ("map.edge", "directions= all=true"),
    ("mass.seed", "tolerance='mass=2%' samples=10"),
];

/// Numbers that may be negative, and numbers whose error names another key or none: a different expected mass is no invalid input.
const NOT_REFUSED: [&str; 4] = ["mass.expect", "impact.gravity", "impact.base_twist", "sweep.seed"];

/// Every key of the tables of questions with a value of a wrong type, and every number with one out of its range: the message of a study
/// begins with file and line and names the key, that of a request names the key, and nothing is printed.
#[test]
fn every_wrong_value_is_named_by_its_key() {
    let folder = Scratch::new("wrong-values");
    let schema: Value = serde_json::from_str(&percuss("schema").stdout).expect("JSON");
    let model = root().join("models/four_bar.urdf");
    let model = model.to_str().expect("UTF-8");
    let loaded = percuss_study::Model::load(model, 1 << 20, &Default::default()).expect("the model");
    let contact = "[contact]\nlink='coupler'\npoint=[0.35,0.1,0]\nnormal=[0,1,0]\n";
    let mut tried = 0;
    for table in ["impact", "extremes", "sweep", "damping", "safe_speed", "map", "mass"] {
        let of_table = &schema["properties"][table];
        let variants = of_table["anyOf"].as_array().cloned().unwrap_or_else(|| vec![of_table.clone()]);
        let keys = variants.iter().find_map(|one| one.get("properties")?.as_object()).expect("keys");
        for (key, kind) in keys {
            let path = format!("{table}.{key}");
            let kind = kind.to_string();
            let is_number = kind.contains("number") || kind.contains("integer");
            let is_list = kind.contains("\"array\"");
            let mut values = vec![if kind.contains("boolean") { "'x'" } else { "[[1]]" }];
            if is_number && !NOT_REFUSED.contains(&path.as_str()) {
                values.push(if is_list { "[-1.0, -1.0]" } else { "-1" });
            }
            for value in values {
                let beside =
                    |name: &str| BESIDE.iter().find(|(of, _)| *of == name).map_or("", |(_, text)| text);
                let mut given = std::collections::BTreeMap::new();
                for word in [beside(table), beside(&path)].iter().flat_map(|text| text.split(' ')) {
                    if let Some((name, value)) = word.split_once('=') {
                        given.insert(name.to_owned(), value.to_owned());
                    }
                }
                given.insert(key.clone(), value.to_owned());
                let rows: Vec<String> = given
                    .iter()
                    .filter(|(_, value)| !value.is_empty())
                    .map(|(key, value)| format!("{key} = {value}\n"))
                    .collect();
                let tables = format!("{contact}[{table}]\n{}", rows.concat());
                let text = format!("[model]\npath='{model}'\n{tables}");
                let file = folder.write("wrong.toml", &text);
                let line = 1 + text
                    .lines()
                    .position(|row| row.starts_with(&format!("{key} = {value}")))
                    .expect("it");
                let outcome = percuss(&format!("run {file}"));
                let shown = outcome.stderr.split_whitespace().collect::<Vec<_>>().join(" ");
                assert_eq!((outcome.code, outcome.stdout.as_str()), (2, ""), "{path} = {value}: {shown}");
                assert!(shown.contains(&format!("{file}:{line}: error: ")), "{path} = {value}: {shown}");
                assert!(shown.contains(&path), "{path} = {value}: {shown}");
                let request: toml::Value = toml::from_str(&tables).expect("TOML");
                let request = serde_json::to_string(&request).expect("JSON");
                let error = percuss_study::ask(&loaded, &request).expect_err("an error").message();
                assert!(error.contains(&path), "{path} = {value}: {error}");
                tried += 1;
            }
        }
    }
    assert!(tried > 100, "{tried}");
}
