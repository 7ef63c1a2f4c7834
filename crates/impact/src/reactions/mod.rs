//! Reactions in joints, closures and held contacts.

pub(crate) mod link_loads;
pub(crate) mod reaction;
pub(crate) mod unit_impulse;
