//! Structure of a model: groups of coupled constraints, clusters of bodies.

pub(super) mod cluster;
mod clusters;
pub(super) mod group;
mod groups;
pub(crate) mod partition;
