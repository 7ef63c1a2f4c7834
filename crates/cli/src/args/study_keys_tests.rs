//! Correspondence of flags and keys of studies: every flag has a key and every key has a flag, with listed exceptions.

use super::Cli;
use std::collections::BTreeSet;

/// Flags that need no key, and why.
const WITHOUT_KEY: [(&str, &str); 12] = [
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
    ("version", "of the command line"),
];

/// Keys that have no flag, and why.
const WITHOUT_FLAG: [(&str, &str); 2] = [
    ("closure.", "a flag for a loop would be a file"),
    ("variant.", "percuss compare uses files in place of variants"),
];

/// The keys of flags that all commands share.
const SHARED: [(&str, &str); 55] = [
    ("model", "model.path"),
    ("mass_from", "model.path"),
    ("accept", "model.accept"),
    ("link_mass", "model.link_mass"),
    ("link_com", "model.link_com"),
    ("moves", "model.move"),
    ("at", "contact.at"),
    ("wheel_travel", "pose.travel"),
    ("heave", "pose.travel"),
    ("roll", "pose.travel"),
    ("steer", "pose.set"),
    ("link", "contact.link"),
    ("point", "contact.point"),
    ("normal", "contact.normal"),
    ("along_line", "contact.along_line.link"),
    ("along_line", "contact.along_line.point"),
    ("turning_normal", "contact.turning_normal"),
    ("frame", "contact.frame"),
    ("normal_frame", "contact.normal_frame"),
    ("against", "contact.against"),
    ("against_mass", "contact.against_mass"),
    ("estimate", "contact.estimate.links"),
    ("estimate", "contact.estimate.point"),
    ("estimate", "contact.estimate.direction"),
    ("ratio_at", "contact.ratio_at.link"),
    ("ratio_at", "contact.ratio_at.point"),
    ("ratio_at", "contact.ratio_at.direction"),
    ("set", "pose.set"),
    ("guess", "pose.guess"),
    ("pose", "pose.file"),
    ("travel", "pose.travel"),
    ("lock", "conditions.lock"),
    ("base", "conditions.base"),
    ("armature", "conditions.armature"),
    ("hold", "hold.link"),
    ("hold", "hold.point"),
    ("hold", "hold.normal"),
    ("restitution", "damping.restitution"),
    ("stiffness", "damping.stiffness"),
    ("exponent", "damping.exponent"),
    ("speed", "damping.speed"),
    ("law", "damping.law"),
    ("separation", "damping.separation"),
    ("tools", "damping.for"),
    ("accuracy", "damping.accuracy"),
    ("time_step", "damping.time_step"),
    ("own_mass", "damping.own_mass"),
    ("other_own_mass", "damping.other_own_mass"),
    ("diagonal_ratio", "damping.diagonal_ratio"),
    ("designs", "variant.model"),
    ("vary", "sweep.vary"),
    ("random", "sweep.random"),
    ("title", "sweep.title"),
    ("x_limits", "sweep.x_limits"),
    ("y_limits", "sweep.y_limits"),
];

/// The keys of flags of a command, which go before the shared ones.
const OWN: [(&str, &str, &str); 38] = [
    ("mass", "expect", "mass.expect"),
    ("mass", "tolerance", "mass.tolerance"),
    ("mass", "samples", "mass.samples"),
    ("mass", "seed", "mass.seed"),
    ("mass", "explain", "mass.explain"),
    ("damp", "limit", "damping.limit"),
    ("damp", "output", "damping.output"),
    ("sweep", "input", "sweep.input"),
    ("sweep", "ignore", "sweep.ignore"),
    ("sweep", "seed", "sweep.seed"),
    ("sweep", "output", "sweep.output"),
    ("sweep", "unit", "sweep.unit"),
    ("sweep", "decimal", "sweep.decimal"),
    ("compare", "output", "sweep.output"),
    ("compare", "unit", "sweep.unit"),
    ("compare", "decimal", "sweep.decimal"),
    ("map", "link", "map.link"),
    ("map", "point", "map.point"),
    ("map", "all", "map.all"),
    ("map", "directions", "map.directions"),
    ("map", "shapes", "map.shapes"),
    ("map", "edge", "map.edge"),
    ("map", "package", "map.package"),
    ("map", "max_mesh_size", "map.max_mesh_size"),
    ("map", "output", "map.output"),
    ("map", "unit", "map.unit"),
    ("map", "decimal", "map.decimal"),
    ("safe-speed", "region", "safe_speed.region"),
    ("safe-speed", "force", "safe_speed.force"),
    ("safe-speed", "pressure", "safe_speed.pressure"),
    ("safe-speed", "area", "safe_speed.area"),
    ("safe-speed", "energy", "safe_speed.energy"),
    ("safe-speed", "momentum", "safe_speed.momentum"),
    ("safe-speed", "direction", "safe_speed.direction"),
    ("safe-speed", "worst_direction", "safe_speed.worst_direction"),
    ("safe-speed", "input", "safe_speed.input"),
    ("safe-speed", "ignore", "safe_speed.ignore"),
    ("safe-speed", "load", "safe_speed.load"),
];

/// The commands whose flags a study keeps.
const KEPT: [&str; 6] = ["mass", "damp", "sweep", "map", "safe-speed", "compare"];

fn keys_of(command: &str, flag: &str) -> Vec<&'static str> {
    let own: Vec<&str> =
        OWN.iter().filter(|(of, name, _)| *of == command && *name == flag).map(|(_, _, key)| *key).collect();
    if !own.is_empty() {
        return own;
    }
    SHARED.iter().filter(|(name, _)| *name == flag).map(|(_, key)| *key).collect()
}

#[test]
fn every_flag_has_a_key_and_every_key_a_flag() {
    let known: BTreeSet<String> = percuss_study::study_keys().into_iter().collect();
    let mut reached: BTreeSet<&str> = BTreeSet::new();
    let (mut excused, mut flags) = (BTreeSet::new(), 0);
    let mut definition = Cli::definition();
    definition.build();
    for name in KEPT {
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
            let keys = keys_of(name, flag);
            assert!(!keys.is_empty(), "percuss {name}: --{flag} has no key in studies (or say here why)");
            for key in keys {
                assert!(
                    known.contains(key),
                    "percuss {name}: --{flag} is said to have the key {key}: there is none"
                );
                reached.insert(key);
            }
        }
    }
    assert!(flags > 150, "only {flags} flags");
    for key in &known {
        // A table, whose keys are looked at.
        let is_table = known.iter().any(|other| other.starts_with(&format!("{key}.")));
        let excuse = WITHOUT_FLAG.iter().any(|(begin, _)| key.starts_with(begin));
        assert!(
            is_table || excuse || reached.contains(key.as_str()),
            "the key {key} has no flag (or say here why)"
        );
    }
    for (excuse, _) in WITHOUT_KEY.iter().filter(|(one, _)| !["help", "version"].contains(one)) {
        assert!(excused.contains(excuse), "{excuse} is excused and is no flag");
    }
}
