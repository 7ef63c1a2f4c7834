//! Numbers and positions with units as text; excerpts of texts for messages.

pub(crate) mod drives;
pub(crate) mod force_curve;
pub(crate) mod message_text;
#[cfg(feature = "flags")]
pub(crate) mod named;
pub(crate) mod point_force;
pub(crate) mod position;
pub(crate) mod quantities;
pub(crate) mod rates;
pub(crate) mod text_layout;
pub(crate) mod value;
