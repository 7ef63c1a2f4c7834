//! Reasons for a command without a result, and exit codes.

use crate::terminal::console::write_line;
use crate::terminal::diagnostics::lines;
use percuss_formats::LoadError;
use percuss_render::RenderError;
use percuss_study::{
    DesignError, DiagnosticRecord, InvalidKey, Names, StudyError, StudyFileError, StudyKeys,
};
use std::io;
use std::path::Path;

/// Failure of a command.
#[derive(Debug)]
pub enum Failure {
    /// Invalid input, with the lines of the message: exit code 2.
    BadInput(Vec<String>),
    /// Output file that cannot be written: exit code 2.
    Output {
        /// The file.
        path: String,
        /// Reason and remedy.
        why: String,
    },
    /// Valid question without a result: exit code 1.
    NoAnswer(String),
    /// Question without a result, or an invalid question: the error determines the exit code.
    Question(Box<StudyError>),
    /// The reader of the output closed the pipe: exit code 0, no message.
    ClosedPipe,
}

impl Failure {
    /// Invalid input with a message of one line.
    pub fn bad_input(message: impl Into<String>) -> Self {
        Failure::BadInput(vec![format!("error: {}", message.into())])
    }

    /// Output file that cannot be written, with the reason and the remedy.
    pub fn output(path: impl Into<String>, why: impl Into<String>) -> Self {
        Failure::Output { path: path.into(), why: why.into() }
    }

    /// Adds the file name of the study, and the line of the key at fault. `outputs`: keys and paths of the output files.
    pub fn in_study(self, path: &str, keys: &StudyKeys, outputs: &[(&'static str, String)]) -> Self {
        // A message begins with its key.
        let position = |key: &str| match keys.line_of(key) {
            Some(line) => format!("{path}:{line}"),
            None => path.to_owned(),
        };
        match self {
            Failure::BadInput(lines) => {
                let of_study = |line: String| match line.strip_prefix("error: ") {
                    Some(message) => {
                        let key = message.split(':').next().unwrap_or_default();
                        format!("{}: error: {message}", position(key))
                    }
                    None => line,
                };
                Failure::BadInput(lines.into_iter().map(of_study).collect())
            }
            Failure::Output { path: file, why } => {
                // The output of generated code is a folder.
                let is_in = |output: &str| Path::new(&file).parent() == Some(Path::new(output));
                let key = outputs.iter().find(|(_, output)| *output == file || is_in(output));
                let key = key.map_or("--output", |(key, _)| key);
                Failure::BadInput(vec![format!("{}: error: {key} {file}: {why}", position(key))])
            }
            Failure::NoAnswer(message) => Failure::NoAnswer(format!("{path}: {message}")),
            Failure::Question(error) if error.has_no_result() => {
                Failure::NoAnswer(format!("{path}: {}", error.message(Names::KEYS)))
            }
            Failure::Question(error) => {
                let message = error.message(Names::KEYS);
                let key = error.key();
                let key = key.as_deref().unwrap_or_else(|| message.split(':').next().unwrap_or_default());
                Failure::BadInput(vec![format!("{}: error: {message}", position(key))])
            }
            Failure::ClosedPipe => Failure::ClosedPipe,
        }
    }

    /// Writes the reason to stderr and returns the exit code.
    pub fn report(self) -> u8 {
        let (lines, code) = match self {
            Failure::BadInput(lines) => (lines, 2),
            Failure::Output { path, why } => (vec![format!("error: --output {path}: {why}")], 2),
            Failure::NoAnswer(message) => (vec![format!("error: {message}")], 1),
            Failure::Question(error) => {
                let code = if error.has_no_result() { 1 } else { 2 };
                (vec![format!("error: {}", error.message(Names::Flags))], code)
            }
            Failure::ClosedPipe => return 0,
        };
        lines.iter().for_each(|line| write_line(line));
        code
    }
}

impl From<InvalidKey> for Failure {
    fn from(error: InvalidKey) -> Self {
        Failure::bad_input(error.message(Names::Flags))
    }
}

impl From<RenderError> for Failure {
    fn from(error: RenderError) -> Self {
        match error {
            RenderError::NotBuilt => Failure::bad_input(error.to_string()),
            _ => Failure::NoAnswer(error.to_string()),
        }
    }
}

impl From<LoadError> for Failure {
    fn from(error: LoadError) -> Self {
        let records: Vec<DiagnosticRecord> = error.diagnostics.into_iter().map(Into::into).collect();
        // Notes are not useful in addition to an error.
        Failure::BadInput(lines(&records, false))
    }
}

impl From<DesignError> for Failure {
    fn from(error: DesignError) -> Self {
        match error {
            DesignError::Load(error) => error.into(),
            DesignError::Change(error) => error.into(),
            // Other errors keep their own message.
            other => Failure::bad_input(other.to_string()),
        }
    }
}

impl From<StudyError> for Failure {
    fn from(error: StudyError) -> Self {
        Failure::Question(Box::new(error))
    }
}

impl From<StudyFileError> for Failure {
    fn from(error: StudyFileError) -> Self {
        match error {
            StudyFileError::Load(error) => error.into(),
            // The message shows lines of the study. Further lines are indented, so that no text of the study looks
            // like a message.
            StudyFileError::Toml { .. } => {
                let text = error.to_string();
                let lines = text.lines().enumerate();
                let indented =
                    |(i, line): (usize, &str)| if i == 0 { line.to_owned() } else { format!("  {line}") };
                Failure::BadInput(lines.map(indented).collect())
            }
            StudyFileError::Keys { .. } => {
                // Keys are shown in quotes, with escaped line ends.
                Failure::BadInput(error.to_string().lines().map(str::to_owned).collect())
            }
            other => Failure::BadInput(vec![other.to_string()]),
        }
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Failure::ClosedPipe,
            // Other kinds of errors of the operating system.
            _ => Failure::NoAnswer(format!("the result cannot be written: {error}")),
        }
    }
}
