//! Closed loops: constraint rows, choice of independent rows and coordinates, rates of the dependent coordinates.

pub(crate) mod constraint_rows;
pub(crate) mod rate_elimination;
