//! MJCF, the model format of MuJoCo.

pub(crate) mod bodies;
pub(crate) mod chain;
pub(crate) mod document;
pub(crate) mod load;
pub(crate) mod relations;
pub(crate) mod values;
pub(crate) mod write;
