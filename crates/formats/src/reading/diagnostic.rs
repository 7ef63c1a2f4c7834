//! Diagnostics: findings about a file.

use percuss_mechanism::Severity;
use std::fmt;

/// Finding with its position in the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// Severity.
    pub severity: Severity,
    /// Stable short name, for scripts.
    pub code: &'static str,
    /// File name as the user gave it.
    pub path: String,
    /// Line, from 1.
    pub line: Option<u32>,
    /// Column in characters, from 1.
    pub column: Option<u32>,
    /// XML path of the element: `robot/joint[hinge]/axis`.
    pub element: Option<String>,
    /// Message: value received, value expected and the remedy, if any.
    pub message: String,
}

/// Writes `file:line: severity: element: message`.
impl fmt::Display for Diagnostic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.path)?;
        if let Some(line) = self.line {
            write!(f, ":{line}")?;
        }
        write!(f, ": {}: ", self.severity.name())?;
        if let Some(element) = &self.element {
            write!(f, "{element}: ")?;
        }
        f.write_str(&self.message)
    }
}

/// Failure to build a mechanism from a file. At least one diagnostic is an error.
#[derive(Clone, Debug, thiserror::Error)]
pub struct LoadError {
    /// All findings, including warnings and notes, in the order of the file.
    pub diagnostics: Vec<Diagnostic>,
}

impl LoadError {
    /// Creates an error about a whole file, without line or element.
    pub fn of_file(path: &str, code: &'static str, message: impl Into<String>) -> Self {
        let (path, message) = (path.to_owned(), message.into());
        let (line, column, element) = (None, None, None);
        let severity = Severity::Error;
        Self { diagnostics: vec![Diagnostic { severity, code, path, line, column, element, message }] }
    }
}

/// Writes the errors, one per line.
impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let errors = self.diagnostics.iter().filter(|d| d.severity == Severity::Error);
        for (i, error) in errors.enumerate() {
            write!(f, "{}{error}", if i == 0 { "" } else { "\n" })?;
        }
        Ok(())
    }
}
