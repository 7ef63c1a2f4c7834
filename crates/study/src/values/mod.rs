//! Numbers and positions with units as text.

pub(crate) mod position;
pub(crate) mod value;
