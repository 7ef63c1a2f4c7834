//! m̄ of contacts given by points and normals on one link, at one pose.

use crate::evaluation::prepared_question::PreparedQuestion;
use crate::evaluation::status::Status;
use crate::map::surface_map::question_with_placeholder_contact;
use crate::model::loading::Model;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::Serialize;

/// Result of a contact; `None` for a contact without a result.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct GivenContact {
    /// Kind of the result; null without one.
    pub status: Option<Status>,
    /// m̄, kg; null unless finite.
    pub effective_mass: Option<f64>,
}

/// m̄ of contacts of a link with the other side of the question: six numbers a contact, the point (m) and the normal (any
/// nonzero length) in the frame of the link. The contact of the question is not evaluated.
///
/// # Errors
/// [`StudyError`]: unknown names, an unreachable pose.
pub fn given_contact_masses(
    model: &Model,
    question: &MassQuestion,
    link: &str,
    contacts: &[[f64; 6]],
) -> Result<Vec<GivenContact>, StudyError> {
    let id = model.mechanism.find_link(link).map_err(StudyError::about("contact.link"))?;
    let conditions = question_with_placeholder_contact(model, question);
    let prepared = PreparedQuestion::new(model, &conditions)?;
    let pose = prepared.pose()?;
    let points: Vec<Vector3<f64>> = contacts.iter().map(|c| Vector3::new(c[0], c[1], c[2])).collect();
    let centre = points.iter().sum::<Vector3<f64>>() / points.len().max(1) as f64;
    let reach = points.iter().map(|point| (point - centre).norm()).fold(0.0, f64::max);
    let map = pose
        .contact_map(id, prepared.other_link(), centre, reach)
        .map_err(StudyError::about("contact.point"))?;
    let other = prepared.other_mass();
    let of_contact = |(point, contact): (&Vector3<f64>, &[f64; 6])| {
        let normal = Vector3::new(contact[3], contact[4], contact[5]);
        let mass =
            map.effective_mass(point, &normal).mass.map(|mass| Status::classify(mass.against_mass(other)));
        let (status, effective_mass) = mass.unzip();
        GivenContact { status, effective_mass: effective_mass.flatten() }
    };
    Ok(points.iter().zip(contacts).map(of_contact).collect())
}
