//! XML of an MJCF model: all files as one tree, the grammar of its elements, and findings with their positions.

pub(crate) mod attach;
pub(crate) mod check;
pub(crate) mod files;
pub(crate) mod grammar;
