//! Errors of the command line in the form of all errors: flag, value received, reason or value expected, remedy.

use crate::args::help::short_help::named_command;
use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Command, Error};
use std::borrow::Cow;
use std::error::Error as _;
use std::ffi::OsString;
use std::num::{ParseFloatError, ParseIntError};

/// Commands with an unknown flag that are named at most.
const NAMED_COMMANDS: usize = 3;

/// Lines of the message about an error of the argument parser. `definition`: the program, after `Command::build`.
pub fn usage_error(error: &Error, definition: &Command, arguments: &[OsString]) -> Vec<String> {
    let command = named_command(definition, arguments).unwrap_or(definition);
    let name = command.get_bin_name().unwrap_or_else(|| command.get_name());
    let argument = one_of(error, ContextKind::InvalidArg).map(shown).unwrap_or_default();
    let value = one_of(error, ContextKind::InvalidValue).unwrap_or_default();
    let flag = &*flag_as_given(first_word(&argument), command, arguments);
    // An empty value is visible in quotes.
    let given = if value.is_empty() { "\"\"" } else { value };
    let message = match error.kind() {
        ErrorKind::InvalidSubcommand => {
            let given = one_of(error, ContextKind::InvalidSubcommand).unwrap_or_default();
            let near = suggestion(error, ContextKind::SuggestedSubcommand);
            let near = near.unwrap_or_else(|| "percuss -h lists the commands".to_owned());
            format!("{given}: percuss has no such command; {near}")
        }
        ErrorKind::UnknownArgument if is_flag(flag, arguments) => {
            let remedy = commands_with(definition, flag)
                .or_else(|| suggestion(error, ContextKind::SuggestedArg))
                .unwrap_or_else(|| format!("{name} -h lists the flags"));
            format!("{flag}: {name} has no such flag; {remedy}")
        }
        ErrorKind::UnknownArgument => {
            let expected: Vec<String> =
                command.get_positionals().map(|known| shown(&known.to_string())).collect();
            let expected = if expected.is_empty() {
                "flags only".to_owned()
            } else {
                format!("{} and flags", expected.join(", "))
            };
            let model = command.get_arguments().find(|known| {
                known.get_value_names().is_some_and(|names| names.iter().any(|value| value == "MODEL"))
            });
            let remedy = match model.and_then(|model| model.get_long()) {
                Some(flag) => format!("a model is given as --{flag} {argument}"),
                None => "remove this argument".to_owned(),
            };
            format!("{argument}: {name} takes {expected}; {remedy}")
        }
        ErrorKind::InvalidValue => {
            let known = parts(error, ContextKind::ValidValue);
            let expected =
                if known.is_empty() { argument.clone() } else { format!("one of {}", known.join(", ")) };
            let near = suggestion(error, ContextKind::SuggestedValue).map(|near| format!("; {near}"));
            match value {
                "" => format!("{flag}: the value is missing; expected {expected}"),
                _ => format!("{flag} {value}: expected {expected}{}", near.unwrap_or_default()),
            }
        }
        ErrorKind::ValueValidation => {
            let reason = match error.source() {
                Some(reason) if reason.is::<ParseIntError>() => "expected a whole number of 0 or more".into(),
                Some(reason) if reason.is::<ParseFloatError>() => "expected a number".into(),
                Some(reason) => Cow::from(reason.to_string()),
                None => "invalid value".into(),
            };
            format!("{flag} {given}: {reason}")
        }
        ErrorKind::TooManyValues => format!("{flag} {value}: the flag takes no value; give {flag} alone"),
        ErrorKind::ArgumentConflict => {
            let others: Vec<String> = parts(error, ContextKind::PriorArg).into_iter().map(shown).collect();
            let others: Vec<&str> = others.iter().map(|other| first_word(other)).collect();
            match &others[..] {
                [same] if *same == flag => format!("{flag}: it is given twice; give it once"),
                _ => format!("{flag}: it cannot be used with {}; give one of them", others.join(", ")),
            }
        }
        ErrorKind::MissingRequiredArgument => {
            let missing: Vec<String> = parts(error, ContextKind::InvalidArg).into_iter().map(shown).collect();
            let usage = command.clone().render_usage().to_string();
            // The usage does not say which flag requires another flag.
            let usage =
                usage.lines().filter(|_| !missing[0].starts_with('-')).map(|line| format!("  {line}"));
            let verb = if missing.len() == 1 { "is" } else { "are" };
            return [format!("error: {} {verb} required", missing.join(", "))]
                .into_iter()
                .chain(usage)
                .collect();
        }
        ErrorKind::InvalidUtf8 => {
            let given =
                arguments.iter().find(|argument| argument.to_str().is_none()).cloned().unwrap_or_default();
            format!("{}: the argument is not UTF-8 text", given.to_string_lossy())
        }
        other => other.to_string(),
    };
    vec![format!("error: {message}")]
}

/// Name of a flag as written: an alias in place of the flag, if only the alias is among the arguments.
fn flag_as_given(flag: &str, command: &Command, arguments: &[OsString]) -> String {
    let is_given = |name: &String| {
        let given = arguments.iter().filter_map(|argument| argument.to_str());
        given.filter_map(|argument| argument.split('=').next()).any(|argument| argument == name)
    };
    let flag = flag.to_owned();
    let known = command.get_arguments().find(|known| known.get_long() == flag.strip_prefix("--"));
    let aliases = known.and_then(clap::Arg::get_all_aliases).unwrap_or_default();
    let alias = aliases.into_iter().map(|alias| format!("--{alias}")).find(is_given);
    alias.filter(|_| !is_given(&flag)).unwrap_or(flag)
}

/// Texts of a part of an error.
fn parts(error: &Error, kind: ContextKind) -> Vec<&str> {
    match error.get(kind) {
        Some(ContextValue::String(text)) => vec![text],
        Some(ContextValue::Strings(texts)) => texts.iter().map(String::as_str).collect(),
        _ => Vec::new(),
    }
}

/// First text of a part of an error.
fn one_of(error: &Error, kind: ContextKind) -> Option<&str> {
    parts(error, kind).first().copied()
}

/// Question for the names that are similar to an unknown one.
fn suggestion(error: &Error, kind: ContextKind) -> Option<String> {
    let near = parts(error, kind);
    (!near.is_empty()).then(|| format!("did you mean {}?", near.join(" or ")))
}

/// Argument as in the short help: `--set JOINT=VALUE` for `--set <JOINT=VALUE>`, `MODEL` for `[MODEL]`.
fn shown(argument: &str) -> String {
    let required = argument.trim_end_matches("...").replace(['<', '>'], "");
    let optional = required.strip_prefix('[').and_then(|inner| inner.strip_suffix(']'));
    optional.unwrap_or(&required).to_owned()
}

/// First word of an argument: its flag.
fn first_word(argument: &str) -> &str {
    argument.split(' ').next().unwrap_or_default()
}

/// True for an argument that begins with a hyphen and does not follow `--`.
fn is_flag(given: &str, arguments: &[OsString]) -> bool {
    given.starts_with('-') && !arguments.iter().any(|argument| argument == "--")
}

/// Other commands that have a flag, if they are few.
fn commands_with(definition: &Command, flag: &str) -> Option<String> {
    let long = flag.strip_prefix("--")?;
    let is_flag = |known: &clap::Arg| known.get_long() == Some(long) && !known.is_hide_set();
    let has_flag = |command: &&Command| command.get_arguments().any(is_flag);
    let commands: Vec<String> = definition
        .get_subcommands()
        .filter(has_flag)
        .map(|command| format!("percuss {}", command.get_name()))
        .collect();
    (1..=NAMED_COMMANDS).contains(&commands.len()).then(|| format!("it is a flag of {}", commands.join(", ")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::args::Cli;

    /// Message about a command line without a result.
    fn message(definition: &Command, arguments: &[&str]) -> String {
        let arguments: Vec<OsString> =
            [&["percuss"], arguments].concat().into_iter().map(OsString::from).collect();
        let error = definition.clone().try_get_matches_from(&arguments).expect_err("an invalid command line");
        usage_error(&error, definition, &arguments).join("\n")
    }

    #[test]
    fn every_flag_of_every_command_is_named_with_what_was_given_and_what_is_expected() {
        let mut definition = Cli::definition();
        definition.build();
        let (mut flags, mut lists) = (0, 0);
        for command in definition.get_subcommands().filter(|command| command.get_name() != "help") {
            let name = command.get_name();
            let unknown = message(&definition, &[name, "--no-such-flag"]);
            assert_eq!(
                unknown,
                format!(
                    "error: --no-such-flag: percuss {name} has no such flag; percuss {name} -h lists the flags"
                )
            );
            for argument in command.get_arguments() {
                let known: Vec<String> =
                    argument.get_possible_values().iter().map(|value| value.get_name().to_owned()).collect();
                let Some(long) = argument.get_long().filter(|long| !["help", "version"].contains(long))
                else {
                    continue;
                };
                flags += 1;
                let flag = format!("--{long}");
                let near = message(&definition, &[name, &format!("{flag}x")]);
                assert!(
                    near.starts_with(&format!(
                        "error: {flag}x: percuss {name} has no such flag; did you mean --"
                    )),
                    "{near}"
                );
                let is_list = matches!(argument.get_action(), clap::ArgAction::Append);
                if !argument.get_action().takes_values() {
                    let with_value = message(&definition, &[name, &format!("{flag}=3")]);
                    assert_eq!(
                        with_value,
                        format!("error: {flag} 3: the flag takes no value; give {flag} alone")
                    );
                    continue;
                }
                if argument.get_num_args().is_some_and(|count| count.min_values() == 0) {
                    continue;
                }
                let without = message(&definition, &[name, &flag]);
                assert!(
                    without.starts_with(&format!("error: {flag}: the value is missing; expected ")),
                    "{without}"
                );
                if known.is_empty() {
                    continue;
                }
                lists += 1;
                let wrong = message(&definition, &[name, &flag, "none-of-them"]);
                assert!(
                    wrong.starts_with(&format!(
                        "error: {flag} none-of-them: expected one of {}",
                        known.join(", ")
                    )),
                    "{wrong}"
                );
                if !is_list {
                    let given = format!("{flag}={}", known[0]);
                    let twice = message(&definition, &[name, &given, &given]);
                    assert_eq!(twice, format!("error: {flag}: it is given twice; give it once"));
                }
            }
        }
        assert!(flags > 400 && lists > 20, "{flags} flags, {lists} of them with a list of values");
    }
}
