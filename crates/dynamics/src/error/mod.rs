//! Error budget of m̄.

pub(crate) mod budget;
pub(crate) mod stationary;
