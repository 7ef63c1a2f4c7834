//! Coefficients of friction at which a contact can stick, jam or wedge.

use crate::evaluation::contact_point::require_contact_point;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::question::errors::question_error::StudyError;
use percuss_dynamics::EffectiveMass;
use percuss_impact::FrictionThresholds;
use schemars::JsonSchema;
use serde::Serialize;

/// Coefficients of friction at which the behaviour of a contact changes. They do not depend on the velocities.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FrictionThresholdsRecord {
    /// Sliding speed per closing speed, t, of a contact with one relative motion; null for other contacts.
    pub slope: Option<f64>,
    /// Coefficient of friction from which the contact can stick; null for one relative motion, and if no friction suffices.
    pub sticking: Option<f64>,
    /// Coefficient of friction from which sliding can jam. For one relative motion: 1/t, from which the contact wedges. Null if no
    /// friction suffices.
    pub jamming: Option<f64>,
}

impl From<FrictionThresholds> for FrictionThresholdsRecord {
    fn from(found: FrictionThresholds) -> Self {
        Self { slope: found.slope, sticking: found.sticking, jamming: found.jamming }
    }
}

/// Thresholds of friction at an evaluated contact.
pub(crate) fn thresholds_of(
    evaluated: &EvaluatedQuestion,
) -> Result<Option<FrictionThresholdsRecord>, StudyError> {
    require_contact_point(evaluated, "mass.friction_thresholds", "threshold of friction")?;
    let response = &evaluated.result.response;
    if response.singular_pose || !matches!(response.effective_mass, EffectiveMass::Finite(_)) {
        return Ok(None);
    }
    let found = percuss_impact::friction_thresholds(&evaluated.pose, response);
    let refuse = StudyError::about("mass.friction_thresholds");
    Ok(Some(found.map_err(refuse)?.into()))
}
