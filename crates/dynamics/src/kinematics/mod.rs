//! Frames, constraint rows, contact rows and outcomes at a pose.

pub(crate) mod contact;
pub(crate) mod contact_row;
pub(crate) mod displacement;
pub(crate) mod frames;
pub(crate) mod gap;
pub(crate) mod outcome;
pub(crate) mod remarks;
pub(crate) mod rows;
