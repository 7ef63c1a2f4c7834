//! Refusals of the writer.

/// Largest number of further refused elements that a message names.
const MOST_NAMED: usize = 20;

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

    /// First of several errors; its reason also names the elements of the others. `None` without errors.
    pub(super) fn combined(errors: Vec<Self>) -> Option<Self> {
        let mut errors = errors.into_iter();
        let mut first = errors.next()?;
        let others: Vec<String> = errors.map(|error| error.element).collect();
        if !others.is_empty() {
            let shown = others[..others.len().min(MOST_NAMED)].join(", ");
            let more = match others.len().saturating_sub(MOST_NAMED) {
                0 => String::new(),
                rest => format!(" and {rest} more"),
            };
            first.reason += &format!("; also refused: {shown}{more}");
        }
        Some(first)
    }
}
