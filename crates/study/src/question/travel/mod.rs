//! Travels and varied values of a question.

pub(crate) mod given_travel;
pub(crate) mod moved;
pub(crate) mod varied_values;
pub(crate) mod vary;
