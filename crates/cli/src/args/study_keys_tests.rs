//! Correspondence of flags and keys of studies: the tables define both; these are the exceptions.

use super::Cli;
use std::collections::BTreeSet;

/// Flags that need no key, and why.
const WITHOUT_KEY: [(&str, &str); 18] = [
    ("help", "of the command line"),
    ("notes", "how much is shown on a terminal: a flag of run too"),
    ("max_size", "a limit of the reader: a flag of run too"),
    ("strict", "what exit code a warning has: a flag of run too"),
    ("force_overwrite", "what may be replaced: a flag of run too"),
    ("threads", "of the machine: a flag of run too"),
    ("format", "what is printed: a flag of run too"),
    ("list_laws", "a list, no question"),
    ("list_tools", "a list, no question"),
    ("list_regions", "a list, no question"),
    ("damp mass", "a study has a model, whose mass it takes"),
    ("restitution mass", "a study has a model, whose mass it takes"),
    ("identify mass", "a study has a model, whose mass it takes"),
    ("digits", "what is printed: a flag of run too"),
    ("details", "what is printed: a flag of run too"),
    ("impact all", "what is printed"),
    ("components", "what is printed"),
    ("version", "of the command line"),
];

/// Keys that have no flag, and why.
const WITHOUT_FLAG: [(&str, &str); 8] = [
    ("check", "a table without keys: the command check"),
    ("closure.", "a flag for a loop would be a file"),
    ("variant.", "percuss compare uses files in place of variants"),
    ("contact.name", "the command evaluates one contact, or lists those of the model by their names"),
    ("kinematics.", "flags of the command kinematics, which also has the data of the vehicle"),
    ("model.name", "percuss compare uses the name of the file"),
    ("targets.", "flags of the command kinematics: --solve with --for"),
    ("report.", "text of the report, which only a study has"),
];

/// Flags whose key has another name.
const OTHER_NAMES: [(&str, &str); 11] = [
    ("model", "model.path"),
    ("mass_from", "model.path"),
    ("moves", "model.move"),
    ("wheel_travel", "pose.travel"),
    ("heave", "pose.travel"),
    ("roll", "pose.travel"),
    ("steer", "pose.set"),
    ("pose", "pose.file"),
    ("hold", "hold"),
    ("tools", "damping.for"),
    ("designs", "variant.model"),
];

/// Commands whose flags a study keeps, each with its own table, whose keys go before those of the others.
const KEPT: [(&str, &str); 14] = [
    ("mass", "mass"),
    ("damp", "damping"),
    ("restitution", "restitution"),
    ("identify", "identify"),
    ("response", "response"),
    ("sweep", "sweep"),
    ("map", "map"),
    ("safe-speed", "safe_speed"),
    ("impact", "impact"),
    ("extremes", "extremes"),
    ("compare", "sweep"),
    ("generate", "generate"),
    ("convert", "convert"),
    ("export", "export"),
];
/// Tables that several commands share.
const SHARED: [&str; 5] = ["contact", "pose", "conditions", "model", "damping"];

#[test]
fn every_flag_has_a_key_and_every_key_a_flag() {
    let known: BTreeSet<String> = percuss_study::study_keys().into_iter().collect();
    let (mut reached, mut excused, mut flags) = (BTreeSet::new(), BTreeSet::new(), 0);
    let mut definition = Cli::definition();
    definition.build();
    for (name, table) in KEPT {
        let command = definition.find_subcommand(name).expect("a command");
        for argument in command.get_arguments() {
            let flag = argument.get_id().as_str();
            // The limit of safe-speed is another force than that of writing.
            let flag = if flag == "force" && name != "safe-speed" { "force_overwrite" } else { flag };
            flags += 1;
            let own = format!("{name} {flag}");
            if let Some((excuse, _)) = WITHOUT_KEY.iter().find(|(one, _)| *one == flag || *one == own) {
                excused.insert(*excuse);
                continue;
            }
            let other_name =
                OTHER_NAMES.iter().filter(|(one, _)| *one == flag).map(|(_, key)| key.to_string());
            let of_tables = [table].into_iter().chain(SHARED).map(|table| format!("{table}.{flag}"));
            let key = other_name.chain(of_tables).find(|key| {
                known.contains(key) || known.iter().any(|one| one.starts_with(&format!("{key}.")))
            });
            let key = key.unwrap_or_else(|| panic!("percuss {name}: --{flag} has no key in studies"));
            reached.insert(key);
            // The command takes the link and the point of a map from its contact.
            if name == "map" && ["link", "point"].contains(&flag) {
                reached.insert(format!("contact.{flag}"));
            }
        }
    }
    assert!(flags > 150, "only {flags} flags");
    for key in &known {
        let excuse = WITHOUT_FLAG.iter().any(|(begin, _)| key.starts_with(begin));
        // The keys of a table that one flag gives as text, such as `contact.estimate.links`.
        let is_part = reached.iter().any(|flag| key.starts_with(&format!("{flag}.")));
        let is_table = known.iter().any(|other| other.starts_with(&format!("{key}.")));
        assert!(
            is_table || excuse || is_part || reached.contains(key),
            "the key {key} has no flag (or say here why)"
        );
    }
    for (excuse, _) in WITHOUT_KEY.iter().filter(|(one, _)| !["help", "version"].contains(one)) {
        assert!(excused.contains(excuse), "{excuse} is excused and is no flag");
    }
}
