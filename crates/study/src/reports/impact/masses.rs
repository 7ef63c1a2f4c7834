//! Masses of a contact by the state of rotors and joints, side by side.

use crate::evaluation::prepared_question::{EvaluatedQuestion, compile};
use crate::evaluation::status::Status;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::contact::ConditionsTable;
use percuss_dynamics::{Configuration, EffectiveMass, Pose};
use percuss_impact::{held_point_mass, locked_body_masses};
use schemars::JsonSchema;
use serde::Serialize;

/// Mass of a contact for one state of rotors and joints.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MassStateRecord {
    /// `rotors-decoupled`: all armatures are 0, as with compliant gears. `rotors-coupled`: the rotors move with the joints, as in all other
    /// results. `joints-locked`: all moving links form one free rigid body (composite rigid body). Impacts on robots with stiff
    /// joint control are often nearer to this mass. A mechanism with locked joints on a fixed base would be immovable.
    pub state: &'static str,
    /// Effective mass of a sliding contact point, 1/(nᵀΛ⁻¹n), kg; null if not finite.
    pub sliding: Option<f64>,
    /// Kind of this mass.
    pub sliding_status: Status,
    /// Mass of a contact point that cannot slide in the tangent plane, nᵀΛn, kg; null if not finite.
    pub sticking: Option<f64>,
    /// Kind of this mass.
    pub sticking_status: Status,
}

/// Masses with rotors decoupled, with rotors coupled and with locked joints. Rotors never reduce a mass, so the first is at most the
/// second. The third does not depend on the rotors.
pub(crate) fn mass_states(evaluated: &EvaluatedQuestion) -> Result<Vec<MassStateRecord>, StudyError> {
    let EvaluatedQuestion { prepared, pose, .. } = evaluated;
    let mechanism = &prepared.model.mechanism;
    let question = &*prepared.question;
    let name = |joint| mechanism.joint(joint).name().to_owned();
    let has_rotor = |joint: &_| pose.armature(*joint).iter().any(|armature| *armature != 0.0);
    let rotors = mechanism.joint_ids().filter(has_rotor);
    let armature = rotors.map(|joint| (name(joint), vec![0.0; pose.armature(joint).len()])).collect();
    let conditions = ConditionsTable { armature, ..question.conditions.clone() };
    let decoupled = MassQuestion { conditions, ..question.clone() };
    let response = |pose: &Pose| -> Result<[EffectiveMass; 2], StudyError> {
        let found = pose.respond(&evaluated.contact)?;
        let sticking = held_point_mass(pose, &found.contact);
        Ok([found.effective_mass, sticking.map_err(StudyError::about("contact.link"))?])
    };
    let located = &evaluated.result.response.contact;
    let locked = locked_body_masses(pose, located).map_err(StudyError::about("contact.link"))?;
    let decoupled = response(&changed_pose(evaluated, &decoupled)?)?;
    let all =
        [("rotors-decoupled", decoupled), ("rotors-coupled", response(pose)?), ("joints-locked", locked)];
    let record = |(state, masses): (&'static str, [EffectiveMass; 2])| {
        let [sliding, sticking] =
            masses.map(|mass| Status::classify(mass.against_mass(prepared.other_mass())));
        MassStateRecord {
            state,
            sliding: sliding.1,
            sliding_status: sliding.0,
            sticking: sticking.1,
            sticking_status: sticking.0,
        }
    };
    Ok(all.into_iter().map(record).collect())
}

/// The pose of a question with the conditions of another question.
fn changed_pose(evaluated: &EvaluatedQuestion, question: &MassQuestion) -> Result<Pose, StudyError> {
    let EvaluatedQuestion { prepared, pose, .. } = evaluated;
    let mechanism = &prepared.model.mechanism;
    let mut positions =
        Configuration::from_positions(mechanism, pose.positions()).map_err(StudyError::about("pose.set"))?;
    positions.set_base(*pose.base());
    Ok(compile(mechanism, question, None)?.pose(&positions)?)
}
