//! Expressions over `f64`: a graph without repeated nodes, vectors of expressions, derivatives, statements.

pub(crate) mod gradient;
pub(crate) mod graph;
pub(crate) mod statements;
pub(crate) mod vector;
