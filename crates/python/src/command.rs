//! The `percuss` command, for the package's console script.

use pyo3::prelude::*;
use std::ffi::OsString;

/// Runs the command and ends the process with its exit code. The first argument is the program name.
#[pyfunction]
pub fn run_command(py: Python<'_>, arguments: Vec<OsString>) {
    py.detach(|| std::process::exit(percuss_cli::run(arguments).into()))
}
