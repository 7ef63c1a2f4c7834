//! Invalid values of a study file.

/// Invalid value of a study file: key and reason.
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
