//! Ordinary differential equations, and the decomposition of small matrices.

pub(crate) mod extrapolation;
pub(crate) mod multistep;
pub(crate) mod pivoted_qr;
