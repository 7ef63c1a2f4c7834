//! SDFormat, the model format of Gazebo.

pub(crate) mod document;
pub(crate) mod elements;
pub(crate) mod frames;
pub(crate) mod load;
pub(crate) mod tree;
pub(crate) mod values;
pub(crate) mod write;
