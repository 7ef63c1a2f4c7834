//! The `percuss` command.
//!
//! Results go to stdout, diagnostics to stderr. Exit code 0: an answer (immovable and massless are answers);
//! 1: no answer; 2: bad input or usage.

mod args;
mod check;
mod csv;
mod damp;
mod diagnostics;
mod escape;
mod failure;
mod html;
mod import;
mod import_picture;
mod import_text;
mod limits;
mod map;
mod map_files;
mod mass;
mod output;
mod own_files;
mod parquet_rows;
mod picture;
mod report;
mod report_page;
mod run;
mod safe_speed;
mod sweep;
mod sweep_figure;
mod sweep_rows;
mod table_style;
mod template;
mod text;
mod xlsx_rows;

use args::{Cli, Command};
use clap::FromArgMatches;
use std::process::ExitCode;

fn main() -> ExitCode {
    let matches = Cli::definition().try_get_matches().unwrap_or_else(|error| refuse(&error));
    let parsed = Cli::from_arg_matches(&matches);
    let cli = parsed.unwrap_or_else(|error| refuse(&error.format(&mut Cli::definition())));
    report::show_notes(cli.notes);
    let outcome = match &cli.command {
        Command::Check(args) => check::run(args),
        Command::Mass(args) => mass::run(args),
        Command::Sweep(args) => sweep::run(args),
        Command::Map(args) => map::run(args),
        Command::Template(args) => template::run(args),
        Command::Import(args) => import::run(args),
        Command::Damp(args) => damp::run(args),
        Command::SafeSpeed(args) => safe_speed::run(args),
        Command::Run(args) => run::run(args),
        Command::Completions { shell } => {
            let mut script = Vec::new();
            clap_complete::generate(*shell, &mut Cli::definition(), "percuss", &mut script);
            report::write_as_is(&script)
        }
    };
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => failure.report(),
    }
}

/// Says what is wrong with the arguments, and ends. Names of files among them may hold what a terminal obeys.
fn refuse(error: &clap::Error) -> ! {
    let is_plain = std::env::args_os().all(|a| !a.to_string_lossy().contains(escape::is_unsafe));
    if is_plain {
        error.exit();
    }
    let mut text = error.render().to_string();
    for argument in std::env::args_os().skip(1) {
        let argument = argument.to_string_lossy();
        // Of --flag=value, the value too.
        let value = argument.split_once('=').map_or("", |(_, value)| value);
        for part in [&*argument, value].into_iter().filter(|part| part.contains(escape::is_unsafe)) {
            text = text.replace(part, &escape::line(part));
        }
    }
    eprint!("{}", escape::lines(&text));
    std::process::exit(error.exit_code())
}
