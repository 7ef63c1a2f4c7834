//! Running the command from the root of the repository.
#![allow(dead_code, reason = "each suite uses its part")]

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// The repository's root.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().expect("the repository is there")
}

/// `percuss` with these arguments, run from the root.
pub fn command<S: AsRef<std::ffi::OsStr>>(arguments: impl IntoIterator<Item = S>) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_percuss"));
    command.current_dir(root()).args(arguments).stdin(Stdio::null());
    command
}

/// What came of it.
pub struct Outcome {
    pub code: i32,
    pub stdout: String,
    pub stderr: String,
}

impl From<Output> for Outcome {
    fn from(output: Output) -> Self {
        Outcome {
            code: output.status.code().expect("an exit code, not a signal"),
            stdout: String::from_utf8(output.stdout).expect("text on stdout"),
            stderr: String::from_utf8(output.stderr).expect("text on stderr"),
        }
    }
}

/// Runs it on words separated by spaces.
pub fn percuss(line: &str) -> Outcome {
    command(line.split_whitespace()).output().expect("the command runs").into()
}

/// Runs it with a text on stdin.
pub fn percuss_with_stdin(line: &str, stdin: &[u8]) -> Outcome {
    let mut command = command(line.split_whitespace());
    let mut child = command
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    // The command may stop reading early: that is its right.
    let _ = child.stdin.take().expect("stdin is piped").write_all(stdin);
    child.wait_with_output().expect("it ends").into()
}

/// Runs it, asserts success, reads stdout as JSON.
pub fn json(line: &str) -> serde_json::Value {
    let outcome = percuss(line);
    assert_eq!(outcome.code, 0, "{line}\n{}", outcome.stderr);
    serde_json::from_str(&outcome.stdout).expect("JSON on stdout")
}
