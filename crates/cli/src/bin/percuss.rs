//! Program `percuss`.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(percuss_cli::run(std::env::args_os()))
}
