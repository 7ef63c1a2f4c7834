//! Numbers and positions with units as text; excerpts of texts for messages.

pub(crate) mod message_text;
pub(crate) mod position;
pub(crate) mod value;
