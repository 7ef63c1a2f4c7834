//! Helpers that run the command.
#![allow(dead_code, reason = "each suite uses its part")]

pub mod blocks;

use percuss_cli::CapturedRun;
use std::ffi::{OsStr, OsString};
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::LazyLock;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Pseudo-random numbers from −1 to 1.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as f64 / (1u64 << 30) as f64 - 1.0
    }
}

/// Root folder of the repository.
pub fn root() -> PathBuf {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the folder of the crates");
    // An absolute path with its drive; not a canonical path, because other programs on Windows do not accept its
    // form.
    std::path::absolute(crates.parent().expect("the repository")).expect("a working directory")
}

/// Folder with copies of `models` and `tests/malformed`, in which the commands of this process run: its current folder.
pub fn workshop() -> &'static Path {
    static FOLDER: LazyLock<PathBuf> = LazyLock::new(|| {
        // Not in the temporary folder of the system, because no test runs last and could remove it. A second process waits.
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("percuss-cli");
        let lock = File::create(folder.with_extension("lock")).expect("a file");
        lock.lock().expect("a lock");
        std::mem::forget(lock);
        let _ = std::fs::remove_dir_all(&folder);
        for part in ["models", "tests/malformed"] {
            copy_folder(&root().join(part), &folder.join(part));
        }
        std::env::set_current_dir(&folder).expect("a folder");
        folder
    });
    &FOLDER
}

/// Runs the command in this process. Each run has its own thread, with the stack of a main thread.
pub fn run<S: Into<OsString>>(words: impl IntoIterator<Item = S>) -> Outcome {
    workshop();
    let words: Vec<OsString> =
        std::iter::once("percuss".into()).chain(words.into_iter().map(Into::into)).collect();
    let thread = std::thread::Builder::new().stack_size(8 << 20);
    let run = thread.spawn(|| percuss_cli::run_captured(words)).expect("a thread").join();
    let CapturedRun { code, stdout, stderr } = run.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
    Outcome::new(code.into(), stdout, stderr)
}

/// `percuss` as a process with the given arguments, run from the root.
pub fn command<S: AsRef<OsStr>>(arguments: impl IntoIterator<Item = S>) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_percuss"));
    command.current_dir(root()).args(arguments).stdin(Stdio::null());
    command
}

/// Outcome of a command.
pub struct Outcome {
    pub code: i32,
    pub stdout: String,
    /// Standard error with each message on one line.
    pub stderr: String,
    /// Standard error as shown: continuation lines of messages are indented.
    pub shown: String,
}

impl Outcome {
    fn new(code: i32, stdout: Vec<u8>, stderr: Vec<u8>) -> Self {
        let shown = String::from_utf8(stderr).expect("text on stderr");
        let stdout = String::from_utf8(stdout).expect("text on stdout");
        Outcome { code, stdout, stderr: shown.replace("\n  ", " "), shown }
    }
}

impl From<Output> for Outcome {
    fn from(output: Output) -> Self {
        Self::new(output.status.code().expect("an exit code, not a signal"), output.stdout, output.stderr)
    }
}

/// Runs the command; words that are file names without a folder are files of `folder`.
pub fn run_in(folder: &Scratch, words: &[&str]) -> Outcome {
    let kinds = [
        "toml", "urdf", "json", "jsonl", "csv", "xlsx", "xlsm", "parquet", "svg", "png", "pdf", "html",
        "yaml", "pm", "sub",
    ];
    let is_file = |word: &str| {
        let kind = Path::new(word).extension().and_then(OsStr::to_str);
        !word.contains('/') && kind.is_some_and(|kind| kinds.contains(&kind))
    };
    run(words.iter().map(|word| if is_file(word) { folder.path(word) } else { (*word).to_owned() }))
}

/// Standard output of a command that succeeds, as [`run_in`].
pub fn done(folder: &Scratch, words: &[&str]) -> String {
    let outcome = run_in(folder, words);
    assert_eq!(outcome.code, 0, "{words:?}: {}", outcome.stderr);
    outcome.stdout
}

/// Runs the command with arguments separated by spaces.
pub fn percuss(line: &str) -> Outcome {
    run(line.split_whitespace())
}

/// Runs the command as a process with a text on stdin.
pub fn percuss_with_stdin(line: &str, stdin: &[u8]) -> Outcome {
    let mut command = command(line.split_whitespace());
    let mut child = command
        .current_dir(workshop())
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it starts");
    // The command may stop reading early.
    let _ = child.stdin.take().expect("stdin is piped").write_all(stdin);
    child.wait_with_output().expect("it ends").into()
}

/// Runs the command, asserts success and reads stdout as JSON.
pub fn json(line: &str) -> serde_json::Value {
    let outcome = percuss(line);
    assert_eq!(outcome.code, 0, "{line}\n{}", outcome.stderr);
    serde_json::from_str(&outcome.stdout).expect("JSON on stdout")
}

/// Asserts that a command is refused as invalid input, with the given words in the message.
pub fn refused(line: &str, words: &[&str]) {
    let outcome = percuss(line);
    assert_eq!(outcome.code, 2, "{line}: {}", outcome.stderr);
    for word in words {
        assert!(outcome.stderr.contains(word), "{line}: {word} is not in {}", outcome.stderr);
    }
}

/// Copies a folder with all files below it.
fn copy_folder(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).expect("a folder");
    for entry in std::fs::read_dir(from).expect("a readable folder").flatten() {
        let target = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy_folder(&entry.path(), &target);
        } else {
            std::fs::copy(entry.path(), target).expect("a copy");
        }
    }
}

/// Rows of a sweep's CSV, by column.
pub struct Sweep {
    pub header: Vec<String>,
    pub rows: Vec<Vec<String>>,
}

impl Sweep {
    /// Parses the CSV; every row has the length of the header. Names must not contain commas.
    pub fn read(csv: &str) -> Self {
        let mut lines = csv.lines().map(|l| l.split(',').map(str::to_owned).collect::<Vec<_>>());
        let header = lines.next().expect("a header");
        let rows: Vec<_> = lines.collect();
        assert!(rows.iter().all(|row| row.len() == header.len()), "rows and header differ in length");
        Self { header, rows }
    }

    /// Text of a cell.
    pub fn cell(&self, row: usize, column: &str) -> &str {
        let at = self.header.iter().position(|h| h == column);
        &self.rows[row][at.unwrap_or_else(|| panic!("no column {column} in {:?}", self.header))]
    }

    /// Number of a cell; `None` if empty.
    pub fn number(&self, row: usize, column: &str) -> Option<f64> {
        let cell = self.cell(row, column);
        if cell.is_empty() { None } else { Some(cell.parse().expect("a number")) }
    }
}

/// Temporary folder, removed when the value is dropped.
pub struct Scratch(PathBuf);

impl Scratch {
    /// New temporary folder; tests with the same name have different folders.
    pub fn new(name: &str) -> Self {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        let (process, count) = (std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed));
        let folder = std::env::temp_dir().join(format!("percuss-cli-{process}-{count}-{name}"));
        std::fs::create_dir_all(&folder).expect("a temporary folder");
        Self(folder)
    }

    /// Folder in the current folder of the commands, with a short relative path: the lengths of paths change line breaks.
    pub fn in_workshop() -> Self {
        static COUNT: AtomicUsize = AtomicUsize::new(0);
        workshop();
        let folder = PathBuf::from(format!("_{}", COUNT.fetch_add(1, Ordering::Relaxed)));
        std::fs::create_dir_all(&folder).expect("a folder");
        Self(folder)
    }

    /// Path of a file in the folder.
    pub fn path(&self, name: &str) -> String {
        self.0.join(name).to_string_lossy().into_owned()
    }

    /// Writes a file and returns its path.
    pub fn write(&self, name: &str, text: &str) -> String {
        let path = self.0.join(name);
        std::fs::create_dir_all(path.parent().expect("a folder")).expect("a folder");
        std::fs::write(path, text).expect("a temporary file");
        self.path(name)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
