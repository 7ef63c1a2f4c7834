//! Diagnostics in JSON form.

use percuss_formats::Diagnostic;
use percuss_mechanism::Severity;
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

/// Finding about a file or a result.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DiagnosticRecord {
    /// Severity; `error`, `warning` or `note` in JSON.
    #[serde(serialize_with = "serialize_severity")]
    #[schemars(with = "String", extend("enum" = ["error", "warning", "note"]))]
    pub severity: Severity,
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
        text += self.severity.name();
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
            severity: d.severity,
            code: d.code,
            path: Some(d.path),
            line: d.line,
            column: d.column,
            element: d.element,
            message: d.message,
        }
    }
}

/// Serializes the name of a severity.
#[allow(clippy::trivially_copy_pass_by_ref, reason = "signature required by serde")]
fn serialize_severity<S: Serializer>(severity: &Severity, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(severity.name())
}
