//! Spanning tree of the links, and the mechanism along it.

pub(crate) mod assembly;
pub(crate) mod chain;
pub(crate) mod relations;
pub(crate) mod spanning;
