//! Diagnostics in JSON form.

use percuss_formats::Diagnostic;
use percuss_mechanism::Severity;
use serde::Serialize;

/// Finding about a file or a result.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct DiagnosticRecord {
    /// `error`, `warning` or `note`.
    pub severity: &'static str,
    /// Stable short name for scripts.
    pub code: &'static str,
    /// File; null for a finding about the result.
    pub path: Option<String>,
    /// Line, from 1.
    pub line: Option<u32>,
    /// Column, from 1.
    pub column: Option<u32>,
    /// Element, as an XML path.
    pub element: Option<String>,
    /// Message.
    pub message: String,
}

impl DiagnosticRecord {
    /// Finding about the result, without a place in a file.
    pub fn about_result(severity: Severity, code: &'static str, message: String) -> Self {
        Self { severity: severity.name(), code, path: None, line: None, column: None, element: None, message }
    }

    /// Text `file:line: severity: element: message`; missing parts are omitted.
    pub fn line(&self) -> String {
        let mut text = String::new();
        if let Some(path) = &self.path {
            text += path;
            if let Some(line) = self.line {
                text += &format!(":{line}");
            }
            text += ": ";
        }
        text += self.severity;
        text += ": ";
        if let Some(element) = &self.element {
            text += element;
            text += ": ";
        }
        text + &self.message
    }
}

impl From<Diagnostic> for DiagnosticRecord {
    fn from(d: Diagnostic) -> Self {
        Self {
            severity: d.severity.name(),
            code: d.code,
            path: Some(d.path),
            line: d.line,
            column: d.column,
            element: d.element,
            message: d.message,
        }
    }
}
