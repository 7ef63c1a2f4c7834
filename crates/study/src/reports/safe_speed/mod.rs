//! Safe speed of a robot that may hit a person: at a pose, along rows, and proved over ranges and surfaces.

pub(crate) mod patches;
pub(crate) mod proved;
pub(crate) mod report;
pub(crate) mod speed;
