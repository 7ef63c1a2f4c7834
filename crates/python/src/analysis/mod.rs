//! Models, systems, poses, responses and matrices as Python objects.

pub(crate) mod contact;
pub(crate) mod maps;
pub(crate) mod matrices;
pub(crate) mod model;
pub(crate) mod model_methods;
pub(crate) mod motion;
pub(crate) mod pose;
pub(crate) mod pose_methods;
pub(crate) mod response;
pub(crate) mod state;
pub(crate) mod suspension;
pub(crate) mod system;
pub(crate) mod system_methods;
