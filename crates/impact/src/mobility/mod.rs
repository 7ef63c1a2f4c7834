//! Mobility of contact points: Delassus matrix, and linear equations with semi-definite matrices.

pub(crate) mod delassus;
pub(crate) mod semidefinite;
