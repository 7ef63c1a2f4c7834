//! Shapes of links, and their extent.

pub(crate) mod geometry;
pub(crate) mod shape;
