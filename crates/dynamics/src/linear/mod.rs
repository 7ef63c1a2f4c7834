//! Linear algebra for groups of every size: least steps and sparse elimination. Knows no mechanism.

pub(crate) mod dense;
pub(crate) mod jacobian;
pub(crate) mod sparse;
