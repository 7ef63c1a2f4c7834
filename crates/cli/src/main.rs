//! The `percuss` command.
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

use args::{Cli, Command};
use clap::FromArgMatches;
use std::process::ExitCode;

fn main() -> ExitCode {
    let parsed = Cli::from_arg_matches(&Cli::definition().get_matches());
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
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}
