//! Mechanics on expressions: bodies with their frames, elementary motions, the contact, the mass matrix.

pub(crate) mod body_frames;
pub(crate) mod contact;
pub(crate) mod frame_choice;
pub(crate) mod mass_matrix;
pub(crate) mod motion;
pub(crate) mod tree;
