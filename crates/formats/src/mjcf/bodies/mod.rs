//! Bodies with their joints, geoms, sites and inertias.

pub(crate) mod body;
pub(crate) mod geom;
pub(crate) mod inertia;
pub(crate) mod mesh;
pub(crate) mod mesh_inertia;
pub(crate) mod solids;
pub(crate) mod walk;
