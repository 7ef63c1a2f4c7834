//! Errors in questions.

pub(crate) mod fault;
mod fault_texts;
pub(crate) mod question_error;
pub(crate) mod refusal;
pub(crate) mod table_error;
