//! Rigid impact at one contact.

pub(crate) mod impact;
pub(crate) mod workspace;
