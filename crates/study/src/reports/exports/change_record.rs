//! Part of a model that has another form in a written file.

use percuss_formats::Change;
use schemars::JsonSchema;
use serde::Serialize;

/// Part of a model that has another form in the written file, or none.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ChangeRecord {
    /// `changed` or `lost`.
    pub effect: &'static str,
    /// The part: a link, joint, loop, coupling or contact with its name, or an element of the file as an XML path.
    pub element: String,
    /// File of the element; null for a part of the mechanism.
    pub path: Option<String>,
    /// Line of the element, from 1.
    pub line: Option<u32>,
    /// Form in the written file, or what is lost.
    pub what: String,
    /// Reason.
    pub reason: String,
}

impl ChangeRecord {
    /// `file:line: element: what (reason)`, without the effect.
    pub fn text(&self) -> String {
        let place = match (&self.path, self.line) {
            (Some(path), Some(line)) => format!("{path}:{line}: "),
            (Some(path), None) => format!("{path}: "),
            (None, _) => String::new(),
        };
        format!("{place}{}: {} ({})", self.element, self.what, self.reason)
    }
}

impl From<Change> for ChangeRecord {
    fn from(change: Change) -> Self {
        let Change { effect, element, what, reason } = change;
        Self { effect: effect.name(), element, path: None, line: None, what, reason }
    }
}
