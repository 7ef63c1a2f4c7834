//! Poses at which branches of a group cross.

mod branches;

pub(crate) use branches::Surroundings;
