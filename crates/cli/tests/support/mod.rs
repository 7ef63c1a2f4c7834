//! Helpers that run the command from the root of the repository.
#![allow(dead_code, reason = "each suite uses its part")]

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// Root folder of the repository.
pub fn root() -> PathBuf {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the folder of the crates");
    // An absolute path with its drive; not a canonical path, because other programs on Windows do not accept its
    // form.
    std::path::absolute(crates.parent().expect("the repository")).expect("a working directory")
}

/// `percuss` with the given arguments, run from the root.
pub fn command<S: AsRef<std::ffi::OsStr>>(arguments: impl IntoIterator<Item = S>) -> Command {
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

impl From<Output> for Outcome {
    fn from(output: Output) -> Self {
        let shown = String::from_utf8(output.stderr).expect("text on stderr");
        Outcome {
            code: output.status.code().expect("an exit code, not a signal"),
            stdout: String::from_utf8(output.stdout).expect("text on stdout"),
            stderr: shown.replace("\n  ", " "),
            shown,
        }
    }
}

/// Runs the command with arguments separated by spaces.
pub fn percuss(line: &str) -> Outcome {
    command(line.split_whitespace()).output().expect("the command runs").into()
}

/// Runs the command with a text on stdin.
pub fn percuss_with_stdin(line: &str, stdin: &[u8]) -> Outcome {
    let mut command = command(line.split_whitespace());
    let mut child = command
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

/// Asserts that every line under a `$ percuss …` of a page occurs in the output of the command, in the same order.
///
/// The commands of a page run one after another in a temporary folder with a copy of `models`. A command with no line
/// under it prints nothing to stdout. Commands are in `console` blocks only, so that none is left out.
pub fn assert_page_shows_what_is_printed(page: &str, expected: usize) {
    let text = std::fs::read_to_string(root().join(page)).expect("the page");
    let folder = Scratch::new(&page.replace(['/', '.'], "-"));
    let mut blocks = Vec::new();
    let mut language = None;
    for line in text.lines() {
        match (language, line.strip_prefix("```")) {
            (None, Some(name)) => {
                language = Some(name);
                blocks.push(String::new());
            }
            (Some(_), Some(_)) => language = None,
            (Some("console"), None) => *blocks.last_mut().expect("a block") += &format!("{line}\n"),
            (Some(_), None) => {
                assert!(!line.starts_with("percuss "), "{page}: {line}: not in a console block")
            }
            (None, None) => {
                assert!(!line.starts_with("    percuss "), "{page}: {line}: not in a console block")
            }
        }
    }
    assert!(language.is_none(), "{page}: a block has no end");
    let mut commands = 0;
    for block in blocks {
        let mut parts = block.split("$ percuss ");
        assert_eq!(parts.next(), Some(""), "{page}: a block starts without a command: {block}");
        for part in parts {
            if commands == 0 {
                copy_folder(&root().join("models"), Path::new(&folder.path("models")));
            }
            commands += 1;
            let part = part.replace("\\\n", " ");
            let (line, shown) = part.split_once('\n').expect("a line");
            let outcome: Outcome = command(line.split_whitespace())
                .current_dir(folder.path(""))
                .output()
                .expect("it runs")
                .into();
            assert_eq!(outcome.code, 0, "{page}: {line}: {}", outcome.stderr);
            assert_lines_are_printed(&format!("{page}: {line}"), shown, &outcome.stdout);
        }
    }
    assert_eq!(commands, expected, "commands on {page}");
}

/// Asserts that the lines occur in the printed text, in the same order; without lines, that nothing is printed.
fn assert_lines_are_printed(at: &str, lines: &str, printed: &str) {
    let mut rest = printed;
    let mut shown = 0;
    for line in lines.lines().filter(|line| !line.is_empty()) {
        shown += 1;
        let mut end = 0;
        let found = rest.split_inclusive('\n').find(|printed| {
            end += printed.len();
            is_shown(line, printed)
        });
        assert!(found.is_some(), "{at}: {line:?} is not, or not there, in\n{printed}");
        rest = &rest[end..];
    }
    assert!(shown > 0 || printed.is_empty(), "{at}: the page shows nothing of\n{printed}");
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

/// True if a line of a page equals a printed line. Numbers may differ by 1e-12 of their value, because the
/// exponential function depends on the system.
fn is_shown(line: &str, printed: &str) -> bool {
    let is_digit = |c: char| c.is_ascii_digit() || c == '.';
    let numbers = |text: &str| -> Vec<f64> {
        text.split(|c| !is_digit(c)).filter_map(|number| number.parse().ok()).collect()
    };
    let words = |text: &str| text.split(is_digit).collect::<String>();
    let (line, printed) = (line.trim_end(), printed.trim_end());
    let (shown, found) = (numbers(line), numbers(printed));
    let agree = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-12 * b.abs();
    printed.contains(line)
        || words(line) == words(printed) && shown.len() == found.len() && shown.iter().zip(&found).all(agree)
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
    pub fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("percuss-cli-{}-{name}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a temporary folder");
        Self(folder)
    }

    /// Path of a file in the folder.
    pub fn path(&self, name: &str) -> String {
        self.0.join(name).to_string_lossy().into_owned()
    }

    /// Writes a file and returns its path.
    pub fn write(&self, name: &str, text: &str) -> String {
        std::fs::write(self.0.join(name), text).expect("a temporary file");
        self.path(name)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
