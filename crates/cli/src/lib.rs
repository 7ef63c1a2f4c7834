//! The `percuss` command. [`run`] is all of it: the program of this name calls it, and so does that of the Python package.
//!
//! Results go to stdout, diagnostics to stderr. Exit code 0: an answer (immovable and massless are answers);
//! 1: no answer; 2: bad input or usage.

mod args;
mod check;
mod compare;
mod csv;
mod damp;
mod diagnostics;
mod explanation;
mod failure;
mod import;
mod import_text;
mod limits;
mod map;
mod map_files;
mod mass;
mod output;
mod parquet_rows;
mod report;
mod run;
mod safe_speed;
mod sweep;
mod sweep_figure;
mod sweep_rows;
mod template;
mod text;

/// The picture of a map, for the faces that show one.
pub use map_files::skin as map_skin;

use args::{Cli, Command};
use clap::FromArgMatches;
use std::ffi::OsString;

/// Runs the command with these arguments, the program's name the first of them, and gives the exit code. Help, the version and
/// bad usage end the process.
pub fn run(arguments: impl IntoIterator<Item = OsString>) -> u8 {
    let parsed = Cli::from_arg_matches(&Cli::definition().get_matches_from(arguments));
    let cli = parsed.unwrap_or_else(|error| error.format(&mut Cli::definition()).exit());
    report::show_notes(cli.notes);
    let outcome = match &cli.command {
        Command::Check(args) => check::run(args),
        Command::Mass(args) => mass::run(args),
        Command::Sweep(args) => sweep::run(args),
        Command::Compare(args) => compare::run(args),
        Command::Map(args) => map::run(args),
        Command::Template(args) => template::run(args),
        Command::Import(args) => import::run(args),
        Command::Damp(args) => damp::run(args),
        Command::SafeSpeed(args) => safe_speed::run(args),
        Command::Run(args) => run::run(args),
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(*shell, &mut Cli::definition(), "percuss", &mut script);
            report::write_out(&String::from_utf8_lossy(&script))
        }
    };
    match outcome {
        Ok(()) => 0,
        Err(failure) => failure.report(),
    }
}
