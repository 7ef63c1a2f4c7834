//! Linear algebra for groups of every size: steps of least norm, and sparse elimination. Independent of mechanisms.

pub(crate) mod dense;
pub(crate) mod determined_system;
pub(crate) mod jacobian;
pub(crate) mod sparse;
