//! Elements of a URDF file.

pub(crate) mod armature;
pub(crate) mod closure;
pub(crate) mod contact;
pub(crate) mod dialect;
pub(crate) mod gazebo_joint;
pub(crate) mod geometry;
pub(crate) mod joint;
pub(crate) mod link;
pub(crate) mod nodes;
pub(crate) mod numbers;
pub(crate) mod origin;
pub(crate) mod shape;
pub(crate) mod survey;
pub(crate) mod transmission;
