//! Flags without influence on the result of a command: they are refused, with the command or the flag that uses them.

use crate::terminal::failure::Failure;
use clap::ArgMatches;
use clap::parser::ValueSource;

/// Flags of some commands without influence. Lists are separated by blanks.
struct Unread {
    commands: &'static str,
    flags: &'static str,
    /// The rule holds if one of these flags is given; empty: always.
    with: &'static str,
    /// The rule does not hold if one of these flags is given.
    without: &'static str,
    reason: &'static str,
}

const UNREAD: [Unread; 14] = [
    Unread {
        commands: "map damp restitution identify response safe-speed extremes",
        flags: "estimate",
        with: "",
        without: "",
        reason: "percuss mass and percuss sweep show it",
    },
    Unread {
        commands: "sweep map damp restitution identify response safe-speed extremes",
        flags: "ratio_at",
        with: "",
        without: "",
        reason: "percuss mass shows it",
    },
    Unread {
        commands: "mass sweep damp restitution identify response safe-speed impact extremes compare generate export",
        flags: "normal_frame",
        with: "at",
        without: "normal",
        reason: "the named contact has a normal of its own",
    },
    Unread {
        commands: "kinematics",
        flags: "within",
        with: "",
        without: "solve",
        reason: "it belongs to a search: --solve POINT.AXIS",
    },
    Unread {
        commands: "kinematics",
        flags: "tyre_rate",
        with: "",
        without: "sprung_mass",
        reason: "it belongs to the frequencies: --sprung-mass KG",
    },
    Unread {
        commands: "kinematics",
        flags: "inboard_brakes inboard_drive",
        with: "",
        without: "brake_bias drive_share cg_height wheelbase",
        reason: "it belongs to the support angles: --brake-bias, --drive-share, --cg-height, --wheelbase",
    },
    Unread {
        commands: "compare",
        flags: "estimate",
        with: "",
        without: "vary",
        reason: "percuss mass shows it",
    },
    Unread {
        commands: "damp restitution identify",
        flags: "masses total_mass link_mass link_com link_inertia moves worksheet accept limit",
        with: "mass",
        without: "",
        reason: "it belongs to a model, and --mass is given",
    },
    Unread {
        commands: "restitution",
        flags: "parameter",
        with: "",
        without: "tool",
        reason: "it belongs to a simulator: --tool NAME",
    },
    Unread {
        commands: "mass",
        flags: "accuracy time_step other_own_mass diagonal_ratio",
        with: "",
        without: "tools",
        reason: "it belongs to the parameters of a simulator: --for TOOL",
    },
    Unread {
        commands: "damp",
        flags: "frame normal_frame about_axis own_mass other_own_mass",
        with: "limit",
        without: "",
        reason: "--limit is the stop of a joint",
    },
    Unread {
        commands: "sweep compare",
        flags: "title x_limits y_limits",
        with: "",
        without: "output",
        reason: "it belongs to a picture: -o FILE.svg",
    },
    Unread {
        commands: "map",
        flags: "unit decimal",
        with: "",
        without: "output format",
        reason: "it belongs to a table: -o FILE.csv",
    },
    Unread {
        commands: "map",
        flags: "normal_frame shapes edge package",
        with: "directions",
        without: "",
        reason: "a map of directions has neither normals nor facets",
    },
];

/// Refuses a flag that has no influence on the result.
pub fn refuse_unread(matches: &ArgMatches) -> Result<(), Failure> {
    let Some((command, flags)) = matches.subcommand() else { return Ok(()) };
    let is_given = |id: &&str| {
        flags.try_contains_id(id).is_ok() && flags.value_source(id) == Some(ValueSource::CommandLine)
    };
    let words = |list: &'static str| list.split_ascii_whitespace();
    let rules = UNREAD.iter().filter(|rule| words(rule.commands).any(|known| known == command));
    let mut rules = rules.filter(|rule| {
        (rule.with.is_empty() || words(rule.with).any(|id| is_given(&id)))
            && !words(rule.without).any(|id| is_given(&id))
    });
    match rules.find_map(|rule| Some((words(rule.flags).find(is_given)?, rule.reason))) {
        Some((flag, reason)) => Err(Failure::bad_input(format!(
            "--{}: it has no influence in this call of percuss {command}: {reason}",
            if flag == "moves" { "move".to_owned() } else { flag.replace('_', "-") }
        ))),
        None => Ok(()),
    }
}
