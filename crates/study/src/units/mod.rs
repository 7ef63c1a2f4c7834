//! Numbers and positions with units as text.

pub(crate) mod measure;
pub(crate) mod position;
pub(crate) mod quantity;
pub(crate) mod value;
