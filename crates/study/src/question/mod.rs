//! Questions about a model: contact, conditions, damper, travel, varied values, and errors in them.

pub(crate) mod errors;
pub(crate) mod link_points;
pub(crate) mod mass_question;
pub(crate) mod names;
pub(crate) mod pose_file;
pub(crate) mod row_source;
pub(crate) mod spelled_contact;
pub(crate) mod tables;
pub(crate) mod travel;
