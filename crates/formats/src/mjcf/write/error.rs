//! Refusals of the writer.

/// Mechanism that MJCF cannot express, or that MuJoCo would refuse.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{element}: {reason}")]
pub struct MjcfError {
    /// Link, joint or loop: `link "arm"`.
    pub element: String,
    /// Reason and remedy.
    pub reason: String,
}

impl MjcfError {
    /// Creates an error about an element: its kind and its name.
    pub(super) fn new(kind: &str, name: &str, reason: impl Into<String>) -> Self {
        Self { element: format!("{kind} \"{name}\""), reason: reason.into() }
    }
}
