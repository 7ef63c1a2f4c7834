//! XML of a model: the main file with its included files as one tree, and the table of elements.

pub(crate) mod check;
pub(crate) mod files;
pub(crate) mod grammar;
pub(crate) mod uri;
pub(crate) mod version;
