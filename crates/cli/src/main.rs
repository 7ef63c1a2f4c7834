//! The `percuss` command.
//!
//! Results go to stdout, diagnostics to stderr. Exit code 0: an answer (immovable and massless are answers);
//! 1: no answer; 2: bad input or usage.

mod args;
mod check;
mod csv;
mod failure;
mod import;
mod mass;
mod report;
mod run;
mod sweep;
mod text;

use args::{Cli, Command};
use clap::{CommandFactory, Parser};
use std::process::ExitCode;

fn main() -> ExitCode {
    let cli = Cli::parse();
    let outcome = match &cli.command {
        Command::Check(args) => check::run(args),
        Command::Mass(args) => mass::run(args),
        Command::Sweep(args) => sweep::run(args),
        Command::Import(args) => import::run(args),
        Command::Run(args) => run::run(args),
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(*shell, &mut Cli::command(), "percuss", &mut script);
            report::write_out(&String::from_utf8_lossy(&script))
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.tell(),
    }
}
