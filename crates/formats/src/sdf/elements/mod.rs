//! Links and joints with their values.

pub(crate) mod axis;
pub(crate) mod body;
pub(crate) mod geometry;
pub(crate) mod inertia;
pub(crate) mod joint;
pub(crate) mod selection;
