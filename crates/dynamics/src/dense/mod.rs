//! The definition solved as dense matrices, for a mechanism and for matrices of the caller.

pub(crate) mod direct;
pub(crate) mod matrices;
