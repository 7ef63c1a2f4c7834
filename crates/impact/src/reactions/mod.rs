//! Reactions in joints, closures and held contacts.

pub(crate) mod bearing;
pub(crate) mod force_elements;
pub(crate) mod joint_constraints;
pub(crate) mod reaction;
pub(crate) mod reaction_map;
pub(crate) mod tree_frames;
pub(crate) mod unit_impulse;
