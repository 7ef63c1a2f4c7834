//! Output of `-h` on one screen. Common flags are explained, the others are only listed by heading; `--help` explains
//! all.

use crate::terminal::wrap::{width, wrap_hanging, wrap_lines};
use clap::{Arg, Command};
use std::ffi::OsString;

/// Column at which explanations begin.
const COLUMN: usize = 30;

/// Explained flags of each command, separated by blanks. Other flags are only listed.
const EXPLAINED: [(&str, &str); 24] = [
    ("percuss", ""),
    ("check", "format strict"),
    (
        "mass",
        "at link point normal against set wheel_travel link_mass restitution stiffness speed explain tolerance format",
    ),
    ("sweep", "vary input random at link point normal along_line against set output unit estimate"),
    ("compare", "at link point normal along_line against vary set moves output format"),
    ("map", "link all point directions set against shapes edge package output format"),
    (
        "kinematics",
        "wheel_travel heave roll steer axle brake_bias cg_height wheelbase sprung_mass solve required within format",
    ),
    ("template", "list unit axes output force"),
    ("import", "output unit axes side template moves picture wheel_mass"),
    (
        "damp",
        "mass mass_from limit stiffness restitution speed law tools at link set output list_laws list_tools",
    ),
    ("restitution", "mass stiffness damping hunt_crossley tool parameter speed load at link set"),
    ("identify", "mass_from speed drop exponent damper output at"),
    ("response", "frequency output at link set"),
    (
        "safe-speed",
        "region force pressure area energy momentum at link set direction worst_direction input load list_regions",
    ),
    ("impact", "at link point normal set restitution speed rates format"),
    ("convert", "output to"),
    ("export", "at link point normal against set restitution stiffness speed output to"),
    ("extremes", "at link point normal along_line against set range keep path format"),
    ("explore", "at link point normal against set wheel_travel moves output open"),
    (
        "generate",
        "at link point normal against set output language name velocity gradient mobility batch close",
    ),
    ("run", "report format threads allow_outside"),
    ("init", "output force"),
    ("schema", ""),
    ("completions", ""),
];

/// Short help of a command, after `Command::build`.
pub fn short_help(command: &Command) -> String {
    let name = command.get_name();
    let explained = EXPLAINED.iter().find(|(known, _)| *known == name).map_or("", |(_, ids)| ids);
    let explained: Vec<&str> = explained.split(' ').collect();
    let mut out = String::new();
    if let Some(about) = command.get_about() {
        out += &(wrap_hanging(&about.to_string(), 0) + "\n\n");
    }
    let usage = command.clone().render_usage().to_string();
    out += &(wrap_lines(&usage) + "\n");
    let arguments: Vec<&Arg> = command.get_positionals().filter(|a| !a.is_hide_set()).collect();
    if !arguments.is_empty() {
        out.push('\n');
    }
    for argument in arguments {
        out += &help_row(argument);
    }
    let subcommands: Vec<&Command> = command.get_subcommands().filter(|c| c.get_name() != "help").collect();
    if !subcommands.is_empty() {
        out += "\nCommands\n";
    }
    for subcommand in &subcommands {
        let about = subcommand.get_about().map_or_else(String::new, ToString::to_string);
        out += &row(subcommand.get_name(), &about, 14);
    }
    out.push('\n');
    for heading in headings(command) {
        let of_heading = |a: &&Arg| a.get_help_heading().unwrap_or("Options") == heading;
        let flags: Vec<&Arg> =
            command.get_opts().chain(flags_without_value(command)).filter(of_heading).collect();
        let (main, rest): (Vec<&Arg>, Vec<&Arg>) =
            flags.into_iter().partition(|a| explained.contains(&a.get_id().as_str()));
        let names: Vec<String> = rest.into_iter().filter_map(flag_name).collect();
        out += &match (names.is_empty(), main.is_empty()) {
            (true, _) => format!("{heading}\n"),
            (false, false) => wrap_hanging(&format!("{heading}, also {}", names.join(" ")), 4) + "\n",
            (false, true) => wrap_hanging(&format!("{heading}: {}", names.join(" ")), 4) + "\n",
        };
        // The table has the order in which the flags are usually given.
        for id in &explained {
            out += &main.iter().find(|a| a.get_id() == id).map_or_else(String::new, |a| help_row(a));
        }
    }
    if let Some(example) = first_example(command) {
        out += &format!("\nExample\n{example}");
    }
    out + &format!(
        "{} --help explains all, with examples.\n",
        command.get_bin_name().unwrap_or_else(|| command.get_name())
    )
}

/// Flags without a value.
fn flags_without_value(command: &Command) -> impl Iterator<Item = &Arg> {
    command.get_arguments().filter(|a| !a.is_positional() && !a.get_action().takes_values())
}

/// Headings in the order of their first flags; "Options", common to all commands, is last.
fn headings(command: &Command) -> Vec<&str> {
    let mut headings = Vec::new();
    for argument in command.get_arguments().filter(|a| !a.is_positional() && !a.is_hide_set()) {
        let heading = argument.get_help_heading().unwrap_or("Options");
        if !headings.contains(&heading) {
            headings.push(heading);
        }
    }
    headings.sort_by_key(|heading| *heading == "Options");
    headings
}

/// `--NAME` of a flag; `None` for arguments without a name and hidden flags.
fn flag_name(argument: &Arg) -> Option<String> {
    match (argument.get_long(), argument.is_hide_set()) {
        (Some(long), false) => Some(format!("--{long}")),
        _ => None,
    }
}

/// Help row of a flag or argument: name, value and effect.
fn help_row(argument: &Arg) -> String {
    let values = argument.get_value_names().unwrap_or_default();
    let value = values.first().map_or_else(String::new, ToString::to_string);
    let mut name = match flag_name(argument) {
        Some(flag) if argument.get_action().takes_values() => format!("{flag} {value}"),
        Some(flag) => flag,
        None => value,
    };
    if let Some(short) = argument.get_short() {
        name = format!("-{short}, {name}");
    }
    let help = argument.get_help().map_or_else(String::new, ToString::to_string);
    row(&name, &help, COLUMN)
}

/// Row of the help: name, and explanation from a column on.
fn row(name: &str, help: &str, column: usize) -> String {
    let name = format!("  {name}");
    if width(&name) + 2 > column {
        return format!("{name}\n{}\n", wrap_hanging(&(" ".repeat(column) + help), column));
    }
    let padding = " ".repeat(column - width(&name));
    wrap_hanging(&format!("{name}{padding}{help}"), column) + "\n"
}

/// First command of the examples, with its continuation lines.
fn first_example(command: &Command) -> Option<String> {
    let text = command.get_after_help()?.to_string();
    let mut example = String::new();
    for line in text.lines().skip_while(|line| !line.trim_start().starts_with("percuss ")) {
        example += &format!("{line}\n");
        if !line.ends_with('\\') {
            return Some(example);
        }
    }
    None
}

/// Command of a command line: the first argument that is the name of a command; `None` without one.
pub fn named_command<'c>(definition: &'c Command, arguments: &[OsString]) -> Option<&'c Command> {
    arguments.iter().skip(1).find_map(|word| definition.find_subcommand(word))
}

/// Command whose short help is shown; percuss itself without a command. `None` if `--help` or `help` comes before `-h`.
pub fn requested_command<'c>(definition: &'c Command, arguments: &[OsString]) -> Option<&'c Command> {
    let mut words = arguments.iter().skip(1).filter_map(|a| a.to_str());
    let is_short = words.find(|word| ["-h", "--help", "help"].contains(word)).is_none_or(|word| word == "-h");
    is_short.then(|| named_command(definition, arguments).unwrap_or(definition))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::args::Cli;
    use crate::terminal::wrap::WIDTH;

    #[test]
    fn every_command_fits_one_screen_and_names_every_flag() {
        let mut definition = Cli::definition();
        definition.build();
        let subcommands: Vec<&Command> =
            definition.get_subcommands().filter(|c| c.get_name() != "help").collect();
        assert_eq!(subcommands.len() + 1, EXPLAINED.len());
        for command in subcommands.into_iter().chain([&definition]) {
            let text = short_help(command);
            let count = text.lines().count();
            assert!(count <= 40, "{} lines:\n{text}", count);
            for line in text.lines() {
                assert!(width(line) <= WIDTH, "{line}");
            }
            for flag in command.get_arguments().filter_map(flag_name) {
                let named = text.split_whitespace().any(|word| word == flag);
                assert!(named, "{}: {flag} is not in\n{text}", command.get_name());
            }
            let (_, explained) = EXPLAINED
                .iter()
                .find(|(name, _)| *name == command.get_name())
                .unwrap_or_else(|| panic!("{} is not in the table", command.get_name()));
            for id in explained.split_ascii_whitespace() {
                assert!(command.get_arguments().any(|a| a.get_id() == id), "{}: {id}", command.get_name());
            }
        }
    }
}
