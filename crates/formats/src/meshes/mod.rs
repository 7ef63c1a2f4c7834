//! Mesh files and surfaces of shapes.

pub(crate) mod files;
pub(crate) mod surface;
