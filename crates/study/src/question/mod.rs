//! Questions about a model: contact, conditions, damper, travel, varied values, and errors in them.

pub(crate) mod damping_question;
pub(crate) mod error;
pub(crate) mod fault;
pub(crate) mod field;
pub(crate) mod given_travel;
pub(crate) mod map_question;
pub(crate) mod mass_question;
pub(crate) mod moved;
pub(crate) mod pose_file;
pub(crate) mod refusal;
pub(crate) mod row_source;
pub(crate) mod table_error;
pub(crate) mod varied_values;
pub(crate) mod vary;
