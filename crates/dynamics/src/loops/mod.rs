//! Closing of loops: first assembly, path following, singular poses.

pub(crate) mod assembling;
pub(crate) mod closing;
pub(crate) mod singular;
