//! Why a command has no result, and its exit code.

use crate::diagnostics::lines;
use crate::escape;
use crate::wrap;
use percuss_formats::LoadError;
use percuss_study::contact::ContactLawError;
use percuss_study::contact::exports::ExportError;
use percuss_study::{DesignError, DiagnosticRecord, Names, StudyError, StudyFileError};
use std::io::{self, Write};

/// No answer.
#[derive(Debug)]
pub enum Failure {
    /// The input is bad, with the lines that say why: exit 2.
    BadInput(Vec<String>),
    /// The question was fine and has no answer: exit 1.
    NoAnswer(String),
    /// The question has no answer, or means nothing: the exit code is the error's.
    Question(Box<StudyError>),
    /// The reader of the output has closed it: exit 0, silently.
    Unread,
}

impl Failure {
    /// Bad input with one line.
    pub fn bad_input(message: impl Into<String>) -> Self {
        Failure::BadInput(vec![format!("error: {}", message.into())])
    }

    /// The same, naming the file whose question it is.
    pub fn in_file(self, path: &str) -> Self {
        match self {
            Failure::BadInput(lines) => Failure::BadInput(
                lines
                    .into_iter()
                    .map(|line| if line.starts_with("error: ") { format!("{path}: {line}") } else { line })
                    .collect(),
            ),
            Failure::NoAnswer(message) => Failure::NoAnswer(format!("{path}: {message}")),
            Failure::Question(error) if error.is_no_answer() => {
                Failure::NoAnswer(format!("{path}: {}", error.message(Names::Keys)))
            }
            Failure::Question(error) => Failure::BadInput(vec![format!(
                "{path}: error: {}{}",
                error.message(Names::Keys),
                key_of(&error)
            )]),
            Failure::Unread => Failure::Unread,
        }
    }

    /// Writes the reason to stderr and returns the exit code.
    pub fn report(self) -> u8 {
        let (lines, code) = match self {
            Failure::BadInput(lines) => (lines, 2),
            Failure::NoAnswer(message) => (vec![format!("error: {message}")], 1),
            Failure::Question(error) => {
                let code = if error.is_no_answer() { 1 } else { 2 };
                (vec![format!("error: {}{}", error.message(Names::Flags), flag_of(&error))], code)
            }
            Failure::Unread => return 0,
        };
        let mut stderr = io::stderr().lock();
        for line in lines {
            // A closed stderr changes nothing about the exit code.
            let _ = writeln!(stderr, "{}", wrap::message(&escape::line(&line)));
        }
        code
    }
}

impl From<LoadError> for Failure {
    fn from(error: LoadError) -> Self {
        let records: Vec<DiagnosticRecord> = error.diagnostics.into_iter().map(Into::into).collect();
        // Beside an error, notes are of no use.
        Failure::BadInput(lines(&records, false))
    }
}

impl From<DesignError> for Failure {
    fn from(error: DesignError) -> Self {
        match error {
            DesignError::Load(error) => error.into(),
            DesignError::Change(error) => error.into(),
            // An open list: its own words.
            other => Failure::bad_input(other.to_string()),
        }
    }
}

impl From<StudyError> for Failure {
    fn from(error: StudyError) -> Self {
        Failure::Question(Box::new(error))
    }
}

/// The number that a law or a simulator lacks, or that is out of its range: its flag and its key.
fn lacking(error: &StudyError) -> Option<(&'static str, &'static str)> {
    match error {
        StudyError::Damping(ContactLawError::SpeedNeeded { .. }) => Some(("--speed", "damping.speed")),
        StudyError::Export(error) if matches!(**error, ExportError::Missing { .. }) => {
            Some(("--own-mass", "damping.own_mass"))
        }
        StudyError::Damping(ContactLawError::OutOfRange { what, .. }) => {
            NUMBERS.iter().find(|(number, ..)| number == what).map(|(_, flag, key)| (*flag, *key))
        }
        StudyError::Damping(ContactLawError::UnknownRegion { .. }) => Some(("--region", "region")),
        _ => None,
    }
}

/// The numbers of contact laws that a user gives: their flags and keys.
const NUMBERS: [(&str, &str, &str); 11] = [
    ("stiffness, N/m^p", "--stiffness", "damping.stiffness"),
    ("restitution", "--restitution", "damping.restitution"),
    ("exponent of the spring", "--exponent", "damping.exponent"),
    ("approach speed, m/s", "--speed", "damping.speed"),
    ("effective mass, kg", "--mass", "damping.mass"),
    ("load, kg", "--load", "load"),
    ("greatest force, N", "--force", "force"),
    ("greatest pressure, Pa", "--pressure", "pressure"),
    ("area of the contact, m^2", "--area", "area"),
    ("greatest energy, J", "--energy", "energy"),
    ("greatest momentum, N·s", "--momentum", "momentum"),
];

fn flag_of(error: &StudyError) -> String {
    lacking(error).map_or_else(String::new, |(flag, _)| format!(" ({flag})"))
}

fn key_of(error: &StudyError) -> String {
    lacking(error).map_or_else(String::new, |(_, key)| format!(" ({key})"))
}

impl From<StudyFileError> for Failure {
    fn from(error: StudyFileError) -> Self {
        match error {
            StudyFileError::Load(error) => error.into(),
            // The lines of the study that it shows; what is in them does not begin a line.
            StudyFileError::Toml { .. } => {
                let text = error.to_string();
                let lines = text.lines().enumerate();
                let indented =
                    |(i, line): (usize, &str)| if i == 0 { line.to_owned() } else { format!("  {line}") };
                Failure::BadInput(lines.map(indented).collect())
            }
            other => Failure::BadInput(vec![other.to_string()]),
        }
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Failure::Unread,
            // An open list of the operating system's.
            _ => Failure::NoAnswer(format!("the result cannot be written: {error}")),
        }
    }
}
