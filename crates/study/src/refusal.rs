//! A value of a study file that cannot be.

/// A value that cannot be: its key, and why.
#[derive(Debug)]
pub(crate) struct Refusal {
    pub key: &'static str,
    pub why: String,
}

impl Refusal {
    pub fn new(key: &'static str, why: impl Into<String>) -> Self {
        Self { key, why: why.into() }
    }
}
