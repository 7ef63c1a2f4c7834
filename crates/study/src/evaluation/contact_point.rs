//! Contacts without a contact point.

use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::question::errors::question_error::{Fault, StudyError};
use percuss_dynamics::Direction;

/// Kind of a contact without a contact point: a moment about an axis, the stop of a joint, a cable, a spring or a rod. `None` for a contact
/// at a point.
pub(crate) fn contact_without_point(evaluated: &EvaluatedQuestion) -> Option<&'static str> {
    let prepared = &evaluated.prepared;
    let is_line =
        matches!(evaluated.contact.normal, Direction::TurningToward(..) | Direction::TurningAwayFrom(..));
    if prepared.question.stop_of_joint(&prepared.model.mechanism).is_some() {
        Some("the stop of a joint")
    } else if is_line {
        Some("a cable, a spring or a rod")
    } else {
        evaluated.result.response.contact.is_moment.then_some("a moment about an axis")
    }
}

/// Refuses a result that requires a contact point, for a contact without one.
pub(crate) fn require_contact_point(
    evaluated: &EvaluatedQuestion,
    field: &'static str,
    result: &'static str,
) -> Result<(), StudyError> {
    match contact_without_point(evaluated) {
        Some(contact) => Err(StudyError::input(field, Fault::NoContactPoint { contact, result })),
        None => Ok(()),
    }
}
