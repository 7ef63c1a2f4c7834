//! Models as trees of elements: elements of all files, and their comparison with the grammar of the format.

pub(crate) mod element_tree;
pub(crate) mod files;
pub(crate) mod grammar;
pub(crate) mod qpos;
