//! Exchange with C: arrays, texts, handles, status codes, floating-point environment.

pub(crate) mod arrays;
mod floating_point;
pub(crate) mod handle;
pub(crate) mod names;
pub(crate) mod status;
