//! Pose at which a stop touches.

use crate::model::wheel_points::SIDES;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use percuss_dynamics::{Gap, Pose};
use percuss_mechanism::{Mechanism, NamedContact};

/// Stops that touch at the pose of a question, with their gaps: the stop of the question and, on a vehicle with both
/// sides, the same stop of the other side, because both wheels move up together. Empty if the contact of the question
/// is no stop, or if the question gives the pose by a travel or a file.
pub(crate) fn touching_stops<'m>(
    mechanism: &'m Mechanism,
    question: &MassQuestion,
    start: &Pose,
) -> Result<Vec<(&'m NamedContact, Gap)>, StudyError> {
    if question.gives_pose() {
        return Ok(Vec::new());
    }
    let Some(contact) = question.named_contact(mechanism)? else { return Ok(Vec::new()) };
    let stops = [Some(contact), other_side(mechanism, contact)];
    let with_gap = |stop: &'m NamedContact| Some((stop, Gap::new(start, stop)?));
    Ok(stops.into_iter().flatten().filter_map(with_gap).collect())
}

/// Contact of the same name on the other side of the vehicle.
fn other_side<'m>(mechanism: &'m Mechanism, contact: &NamedContact) -> Option<&'m NamedContact> {
    let [left, right] = SIDES;
    let other = |own: &str, other: &str| Some(format!("{}{other}", contact.name().strip_suffix(own)?));
    mechanism.find_contact(&other(left, right).or_else(|| other(right, left))?).ok()
}
