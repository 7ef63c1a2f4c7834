//! Conversion between Python and Rust: arrays, labels, errors, findings; work without the interpreter.

pub(crate) mod arrays;
pub(crate) mod diagnostic;
pub(crate) mod errors;
pub(crate) mod labels;
pub(crate) mod pickle;
pub(crate) mod threads;
