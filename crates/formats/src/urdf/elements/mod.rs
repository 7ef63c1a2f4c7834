//! Elements of a URDF file.

pub(crate) mod bushing;
pub(crate) mod closure;
pub(crate) mod contact;
pub(crate) mod dialect;
pub(crate) mod joints;
pub(crate) mod link;
pub(crate) mod nodes;
pub(crate) mod numbers;
pub(crate) mod origin;
pub(crate) mod relation;
pub(crate) mod sdf_values;
pub(crate) mod shapes;
pub(crate) mod survey;
