//! Reasons for a command without a result, and exit codes.

use crate::terminal::console;
use crate::terminal::diagnostics::lines;
use crate::terminal::escape;
use crate::terminal::wrap;
use percuss_formats::LoadError;
use percuss_render::RenderError;
use percuss_study::contact::ContactLawError;
use percuss_study::contact::exports::ExportError;
use percuss_study::{
    DesignError, DiagnosticRecord, InvalidKey, Names, StudyError, StudyFileError, StudyKeys,
};
use std::io::{self, Write};

/// Failure of a command.
#[derive(Debug)]
pub enum Failure {
    /// Invalid input, with the lines of the message: exit code 2.
    BadInput(Vec<String>),
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

    /// Adds the file name of the study, and the line of the key at fault.
    pub fn in_study(self, path: &str, keys: &StudyKeys) -> Self {
        // A message begins with its key.
        let position = |key: &str| match keys.line_of(key) {
            Some(line) => format!("{path}:{line}"),
            None => path.to_owned(),
        };
        match self {
            Failure::BadInput(lines) => {
                let of_study = |line: String| match line.strip_prefix("error: ") {
                    Some(message) => {
                        // The message of a design begins with the design's name.
                        let named = message.strip_prefix('"').and_then(|rest| rest.split_once("\": "));
                        let key =
                            named.map_or(message, |(_, rest)| rest).split(':').next().unwrap_or_default();
                        format!("{}: error: {message}", position(key))
                    }
                    None => line,
                };
                Failure::BadInput(lines.into_iter().map(of_study).collect())
            }
            Failure::NoAnswer(message) => Failure::NoAnswer(format!("{path}: {message}")),
            Failure::Question(error) if error.has_no_result() => {
                Failure::NoAnswer(format!("{path}: {}", error.message(Names::Keys)))
            }
            Failure::Question(error) => {
                let key =
                    error.field().map(|field| field.key()).or(missing_number(&error).map(|(_, key)| key));
                let message = error.message(Names::Keys);
                let key = key.unwrap_or_else(|| message.split(':').next().unwrap_or_default());
                Failure::BadInput(vec![format!("{}: error: {message}{}", position(key), key_of(&error))])
            }
            Failure::ClosedPipe => Failure::ClosedPipe,
        }
    }

    /// Writes the reason to stderr and returns the exit code.
    pub fn report(self) -> u8 {
        let (lines, code) = match self {
            Failure::BadInput(lines) => (lines, 2),
            Failure::NoAnswer(message) => (vec![format!("error: {message}")], 1),
            Failure::Question(error) => {
                let code = if error.has_no_result() { 1 } else { 2 };
                (vec![format!("error: {}{}", error.message(Names::Flags), flag_of(&error))], code)
            }
            Failure::ClosedPipe => return 0,
        };
        let mut stderr = console::stderr();
        for line in lines {
            // A closed stderr does not affect the exit code.
            let _ = writeln!(stderr, "{}", wrap::wrap_message(&escape::line(&line)));
        }
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

/// Flag and key of the number that a contact law or a simulator needs, or that is out of range.
fn missing_number(error: &StudyError) -> Option<(&'static str, &'static str)> {
    match error {
        StudyError::Damping(ContactLawError::SpeedNeeded { .. }) => Some(("--speed", "damping.speed")),
        StudyError::Export(error) if matches!(**error, ExportError::Missing { .. }) => {
            Some(("--own-mass", "damping.own_mass"))
        }
        StudyError::Export(error) => match &**error {
            ExportError::Contact(ContactLawError::OutOfRange { what, .. }) => flag_and_key_of(what),
            ExportError::StepTooLong { .. } => Some(("--time-step", "damping.time_step")),
            ExportError::Exponent { .. } => Some(("--exponent", "damping.exponent")),
            _ => None,
        },
        StudyError::Damping(ContactLawError::OutOfRange { what, .. }) => flag_and_key_of(what),
        StudyError::Damping(ContactLawError::UnknownRegion { .. }) => Some(("--region", "safe_speed.region")),
        _ => None,
    }
}

/// Flag and key of a number by its description in an error.
fn flag_and_key_of(what: &str) -> Option<(&'static str, &'static str)> {
    NUMBERS.iter().find(|(number, ..)| *number == what).map(|(_, flag, key)| (*flag, *key))
}

/// Numbers of contact laws given by the user: description, flag, key.
const NUMBERS: [(&str, &str, &str); 16] = [
    ("time step, s", "--time-step", "damping.time_step"),
    ("mass of the contact link alone, kg", "--own-mass", "damping.own_mass"),
    ("mass of the other body alone, kg", "--other-own-mass", "damping.other_own_mass"),
    ("MuJoCo's diagonal ratio", "--diagonal-ratio", "damping.diagonal_ratio"),
    ("accuracy of the restitution", "--accuracy", "damping.accuracy"),
    ("stiffness, N/m^p", "--stiffness", "damping.stiffness"),
    ("restitution", "--restitution", "damping.restitution"),
    ("exponent of the spring", "--exponent", "damping.exponent"),
    ("approach speed, m/s", "--speed", "damping.speed"),
    ("effective mass, kg", "--mass", "damping.mass"),
    ("load, kg", "--load", "safe_speed.load"),
    ("greatest force, N", "--force", "safe_speed.force"),
    ("greatest pressure, Pa", "--pressure", "safe_speed.pressure"),
    ("area of the contact, m^2", "--area", "safe_speed.area"),
    ("greatest energy, J", "--energy", "safe_speed.energy"),
    ("greatest momentum, N·s", "--momentum", "safe_speed.momentum"),
];

/// Suffix ` (--FLAG)` of a message: flag of the missing or invalid number; empty if unknown.
fn flag_of(error: &StudyError) -> String {
    missing_number(error).map_or_else(String::new, |(flag, _)| format!(" ({flag})"))
}

/// Suffix ` (KEY)` of a message: study key of the missing or invalid number; empty if unknown.
fn key_of(error: &StudyError) -> String {
    missing_number(error).map_or_else(String::new, |(_, key)| format!(" ({key})"))
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
