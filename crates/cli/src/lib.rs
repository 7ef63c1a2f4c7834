//! Implementation of the `percuss` command. [`run`] is the entry point for the program and for the Python package.
//!
//! Results go to stdout, diagnostics to stderr. Exit code 0: a result (including immovable and massless); 1: no
//! result; 2: invalid input or usage.

mod args;
mod commands;
mod document;
mod files;
mod pictures;
mod terminal;
mod unread_flags;

/// Surface of a map, for other user interfaces.
pub use pictures::map_files::skin as map_skin;

use args::{Cli, Command, requested_command, short_help, usage_error};
use clap::FromArgMatches;
use clap::error::ErrorKind;
use files::output::begin_run;
use std::ffi::OsString;
use std::io::Write;
use terminal::failure::Failure;
use terminal::{console, number, report, wrap};

/// Exit code and output of a command.
#[derive(Clone, Debug)]
pub struct CapturedRun {
    /// Exit code.
    pub code: u8,
    /// Bytes of standard output.
    pub stdout: Vec<u8>,
    /// Bytes of standard error.
    pub stderr: Vec<u8>,
}

/// Runs the command like [`run`], but returns its output. The standard input is that of the process.
pub fn run_captured(arguments: impl IntoIterator<Item = OsString>) -> CapturedRun {
    let (code, [stdout, stderr]) = console::capture(|| run(arguments));
    CapturedRun { code, stdout, stderr }
}

/// Runs the command and returns the exit code. The first argument is the name of the program.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let arguments: Vec<OsString> = arguments.into_iter().collect();
    begin_run();
    console::begin_run();
    // Captured help has the same width on every terminal.
    let definition =
        if console::is_captured() { Cli::definition().term_width(wrap::WIDTH) } else { Cli::definition() };
    let matches = definition.try_get_matches_from(&arguments);
    let matches = match matches {
        Ok(matches) => matches,
        Err(error) if error.kind() == ErrorKind::DisplayHelp => return print_help(&error, &arguments),
        Err(error) if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
            let mut definition = Cli::definition();
            definition.build();
            let _ = write!(console::stderr(), "{}", short_help(&definition));
            return 2;
        }
        Err(error) => return report_usage(&error, &arguments),
    };
    let cli = match Cli::from_arg_matches(&matches) {
        Ok(cli) => cli,
        Err(error) => return report_usage(&error.format(&mut Cli::definition()), &arguments),
    };
    if let Err(failure) = unread_flags::refuse_unread(&matches, Cli::definition) {
        return failure.report();
    }
    report::show_notes(cli.notes);
    report::show_details(cli.details);
    number::use_digits(cli.digits);
    let outcome = match &cli.command {
        Command::Check(args) => commands::check::run(args),
        Command::Mass(args) => commands::mass::run(args),
        Command::Sweep(args) => commands::sweep::run(args),
        Command::Compare(args) => commands::compare::run(args),
        Command::Map(args) => commands::map::run(args),
        Command::Kinematics(args) => commands::suspension::kinematics::run(args),
        Command::Template(args) => commands::suspension::template::run(args),
        Command::Import(args) => commands::suspension::import::run(args),
        Command::Damp(args) => commands::damp::run(args),
        Command::Restitution(args) => commands::impacts::restitution::run(args),
        Command::Identify(args) => commands::impacts::identify::run(args),
        Command::Response(args) => commands::impacts::response::run(args),
        Command::SafeSpeed(args) => commands::impacts::safe_speed::run(args),
        Command::Impact(args) => commands::impacts::rigid_impact::run(args),
        Command::Extremes(args) => commands::impacts::extremes::run(args),
        Command::Explore(args) => commands::exports::explore::run(args),
        Command::Generate(args) => commands::exports::generate::run(args),
        Command::Export(args) => commands::exports::export::run(args),
        Command::Convert(args) => commands::exports::convert::run(args),
        Command::Run(args) => commands::run::run(args),
        Command::Init(args) => commands::init::run(args),
        Command::Schema { format } => commands::init::schema(*format),
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(*shell, &mut Cli::definition(), "percuss", &mut script);
            report::write_unescaped(&script)
        }
    };
    match outcome {
        Ok(()) => 0,
        Err(failure) => failure.report(),
    }
}

/// Prints the help of `-h` or `--help`.
fn print_help(error: &clap::Error, arguments: &[OsString]) -> u8 {
    let mut definition = Cli::definition();
    definition.build();
    let text = match requested_command(&definition, arguments) {
        Some(command) => short_help(command),
        None => wrap::wrap_lines(&error.render().to_string()),
    };
    match report::write_unescaped(text.as_bytes()) {
        Ok(()) => 0,
        Err(failure) => failure.report(),
    }
}

/// Prints the version, or the message about an invalid command line, and returns the exit code.
fn report_usage(error: &clap::Error, arguments: &[OsString]) -> u8 {
    if error.kind() == ErrorKind::DisplayVersion {
        let version = error.render().to_string();
        return report::write_unescaped(version.as_bytes()).map_or_else(Failure::report, |()| 0);
    }
    let mut definition = Cli::definition();
    definition.build();
    Failure::BadInput(usage_error(error, &definition, arguments)).report()
}
