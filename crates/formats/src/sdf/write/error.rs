//! Refusals of the writer.

/// Mechanism that SDFormat cannot express.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{element}: {reason}")]
pub struct SdfError {
    /// Link, joint, loop or coupling: `joint "arm"`.
    pub element: String,
    /// Reason and remedy.
    pub reason: String,
}

impl SdfError {
    /// Creates an error about an element: its kind and its name.
    pub(super) fn new(kind: &str, name: &str, reason: impl Into<String>) -> Self {
        Self { element: format!("{kind} \"{name}\""), reason: reason.into() }
    }
}
