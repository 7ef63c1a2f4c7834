//! Invalid values of a study file.

/// Invalid value of a study file: key and reason.
#[derive(Debug)]
pub(crate) struct InvalidKey {
    pub key: &'static str,
    pub reason: String,
}

impl InvalidKey {
    /// Refusal of a key with its reason.
    pub fn new(key: &'static str, why: impl Into<String>) -> Self {
        Self { key, reason: why.into() }
    }
}
