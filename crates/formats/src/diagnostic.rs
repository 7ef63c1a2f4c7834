//! Diagnostics: what was found in a file.

use percuss_mechanism::Severity;
use std::fmt;

/// One finding, with its place in the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// How grave it is.
    pub severity: Severity,
    /// A short name that scripts can rely on.
    pub code: &'static str,
    /// The file, as the user named it.
    pub path: String,
    /// Line, from 1.
    pub line: Option<u32>,
    /// Column in characters, from 1.
    pub column: Option<u32>,
    /// The element, as an XML path: `robot/joint[hinge]/axis`.
    pub element: Option<String>,
    /// The finding: what was got, what is expected and, where there is one, the remedy.
    pub message: String,
}

/// `file:line: severity: element: message`.
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

/// No mechanism came of the file: at least one diagnostic is an error.
#[derive(Clone, Debug, thiserror::Error)]
pub struct LoadError {
    /// Everything that was found, warnings and notes among it, in the order of the file.
    pub diagnostics: Vec<Diagnostic>,
}

impl LoadError {
    /// One error about a whole file.
    pub fn of_file(path: &str, code: &'static str, message: impl Into<String>) -> Self {
        let (path, message) = (path.to_owned(), message.into());
        let (line, column, element) = (None, None, None);
        let severity = Severity::Error;
        Self { diagnostics: vec![Diagnostic { severity, code, path, line, column, element, message }] }
    }
}

/// The errors, one a line.
impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let errors = self.diagnostics.iter().filter(|d| d.severity == Severity::Error);
        for (i, error) in errors.enumerate() {
            write!(f, "{}{error}", if i == 0 { "" } else { "\n" })?;
        }
        Ok(())
    }
}
