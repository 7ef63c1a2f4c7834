//! Flags without influence on the result of a command: they are refused, with the command or the flag that uses them, and the help leaves
//! them out or states the condition.

use crate::terminal::failure::Failure;
use clap::builder::Resettable;
use clap::parser::ValueSource;
use clap::{Arg, ArgMatches, Command};

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

/// Declares the rules; an absent list is empty.
macro_rules! rules {
    ($($commands:literal: $flags:literal $(with $with:literal)? $(without $without:literal)? => $reason:literal;)*) => {
        &[$(Unread {
            commands: $commands,
            flags: $flags,
            with: concat!($($with)?),
            without: concat!($($without)?),
            reason: $reason,
        },)*]
    };
}

const UNREAD: &[Unread] = rules! {
    "mass": "limit" => "percuss damp and percuss export use the stop of a joint; as a contact write --at JOINT:upper";
    "map damp restitution identify response safe-speed extremes generate export": "estimate" => "percuss mass and percuss sweep show it";
    "sweep map damp restitution identify response safe-speed extremes generate export": "ratio_at" => "percuss mass shows it";
    "mass sweep damp restitution identify response safe-speed impact extremes compare generate export": "normal_frame" with "at" without "normal"
        => "the named contact has a normal of its own";
    "kinematics": "within" without "solve" => "it belongs to a search: --solve POINT.AXIS";
    "kinematics": "tyre_rate" without "sprung_mass" => "it belongs to the frequencies: --sprung-mass KG";
    "kinematics": "inboard_brakes inboard_drive" without "brake_bias drive_share cg_height wheelbase"
        => "it belongs to the support angles: --brake-bias, --drive-share, --cg-height, --wheelbase";
    "compare": "estimate" without "vary" => "percuss mass shows it";
    "damp restitution identify": "masses total_mass link_mass link_com link_inertia moves worksheet accept limit" with "mass"
        => "it belongs to a model, and --mass is given";
    "restitution": "parameter" without "tool" => "it belongs to a simulator: --tool NAME";
    "mass damp": "accuracy time_step other_own_mass diagonal_ratio" without "tools"
        => "it belongs to the parameters of a simulator: --for TOOL";
    "damp": "frame normal_frame about_axis own_mass other_own_mass" with "limit" => "--limit is the stop of a joint";
    "sweep compare": "title x_limits y_limits" without "output" => "it belongs to a picture: -o FILE.svg";
    "map": "unit decimal" without "output format" => "it belongs to a table: -o FILE.csv";
    "map": "shapes edge package" with "directions" => "a map of directions has no facets";
    "map": "at normal along_line turning_normal cable normal_frame"
        => "a map uses the outward normals of the surface, or with --directions all directions; use percuss mass for a single contact";
    "map": "about_axis" => "a map is about contact points; use percuss mass for the effective inertia about an axis";
    "export": "tools" => "the format of the file selects the simulator (--to)";
    "export": "lock" => "it is not written to a model of a simulator; replace the joint by a fixed joint in the model file";
    "export": "hold" => "it is not written to a model of a simulator; add a loop to the model file";
    "export": "armature gear_stiffness" => "it is not written to a model of a simulator; write it into the model file";
    "export": "against_mass" => "it is not written to a model of a simulator; add the body to the model file and name it by --against";
};

/// Words of a list of a rule.
fn words(list: &'static str) -> impl Iterator<Item = &'static str> {
    list.split_ascii_whitespace()
}

/// Flag of a command as it is given: `--NAME`.
fn flag_of(command: Option<&Command>, id: &str) -> String {
    let argument =
        command.and_then(|command| command.get_arguments().find(|argument| argument.get_id() == id));
    format!("--{}", argument.and_then(Arg::get_long).unwrap_or(id))
}

impl Unread {
    /// Condition under which a flag of the rule is read, for the help; `None` if it is never read.
    fn condition(&self, command: &Command) -> Option<String> {
        let list = |ids| words(ids).map(|id| flag_of(Some(command), id)).collect::<Vec<_>>().join(" or ");
        match (self.with, self.without) {
            ("", "") => None,
            ("", without) => Some(format!(" [only with {}]", list(without))),
            (with, "") => Some(format!(" [not with {}]", list(with))),
            (with, without) => Some(format!(" [not with {}, except with {}]", list(with), list(without))),
        }
    }

    /// A command with this rule in its help.
    fn mark(&self, command: Command) -> Command {
        let condition = self.condition(&command);
        command.mut_args(|argument| {
            if !words(self.flags).any(|id| argument.get_id() == id) {
                return argument;
            }
            let Some(condition) = &condition else {
                let argument = argument.hide(true);
                // A hidden flag is refused with its reason, beside any other flag; an axis also in place of the required point.
                let is_axis = argument.get_id() == "about_axis";
                return if is_axis { argument } else { argument.conflicts_with(Resettable::Reset) };
            };
            // The short help has no room for conditions.
            let help = argument.get_long_help().or_else(|| argument.get_help());
            let help = help.map(|help| format!("{help}{condition}")).unwrap_or_default();
            argument.long_help(help)
        })
    }
}

/// The program with help that lists only the flags that a command reads, with their conditions.
pub fn mark_unread(program: Command) -> Command {
    let of_rule = |program, rule: &'static Unread| {
        words(rule.commands).fold(program, |program: Command, command| {
            program.mut_subcommand(command, |command| rule.mark(command))
        })
    };
    UNREAD.iter().fold(program, of_rule)
}

/// Refuses a flag that has no influence on the result. `program`: definition of the command line.
pub fn refuse_unread(matches: &ArgMatches, program: fn() -> Command) -> Result<(), Failure> {
    let Some((command, flags)) = matches.subcommand() else { return Ok(()) };
    let is_given = |id: &&str| {
        flags.try_contains_id(id).is_ok() && flags.value_source(id) == Some(ValueSource::CommandLine)
    };
    let rules = UNREAD.iter().filter(|rule| words(rule.commands).any(|known| known == command));
    let mut rules = rules.filter(|rule| {
        (rule.with.is_empty() || words(rule.with).any(|id| is_given(&id)))
            && !words(rule.without).any(|id| is_given(&id))
    });
    match rules.find_map(|rule| Some((words(rule.flags).find(is_given)?, rule.reason))) {
        Some((flag, reason)) => Err(Failure::bad_input(format!(
            "{}: it has no influence in this call of percuss {command}: {reason}",
            flag_of(program().find_subcommand(command), flag)
        ))),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::args::Cli;
    use clap::CommandFactory;

    /// Each rule hides its flags, or states its condition, in the help of each of its commands; all other flags keep their help.
    #[test]
    fn the_help_follows_the_table() {
        let (program, plain) = (Cli::definition(), Cli::command());
        let mut used = [0; UNREAD.len()];
        for command in program.get_subcommands() {
            let name = command.get_name();
            let own = plain.find_subcommand(name).expect("a command");
            for argument in command.get_arguments() {
                let is_of = |rule: &Unread| {
                    words(rule.commands).any(|known| known == name)
                        && words(rule.flags).any(|flag| argument.get_id() == flag)
                };
                let rules: Vec<usize> = (0..UNREAD.len()).filter(|i| is_of(&UNREAD[*i])).collect();
                rules.iter().for_each(|i| used[*i] += 1);
                let conditions: Option<String> =
                    rules.iter().map(|i| UNREAD[*i].condition(command)).collect();
                let plain = own.get_arguments().find(|other| other.get_id() == argument.get_id());
                let plain = plain.expect("an argument");
                let context = format!("{name} {}", argument.get_id());
                let Some(conditions) = conditions else {
                    assert!(argument.is_hide_set(), "{context}");
                    continue;
                };
                let help = |argument: &Arg| {
                    let help = argument.get_long_help().or_else(|| argument.get_help());
                    help.map(ToString::to_string).unwrap_or_default()
                };
                assert_eq!(help(argument), help(plain) + &conditions, "{context}");
                assert_eq!(argument.is_hide_set(), plain.is_hide_set(), "{context}");
            }
        }
        for (rule, count) in UNREAD.iter().zip(used) {
            let expected = words(rule.commands).count();
            assert!(count > 0 && count <= expected * words(rule.flags).count(), "{}: {count}", rule.flags);
        }
    }
}
