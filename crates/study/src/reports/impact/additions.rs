//! Additional results about an impact: reflected inertias, centres of percussion, greatest closing speed.

use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::evaluation::status::Status;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::field::Field;
use crate::reports::impact::question::{ImpactQuestion, PercussionRequest};
use crate::values::rates::GivenRates;
use percuss_impact::{
    centre_of_percussion, centre_of_percussion_in_plane, greatest_closing_speed, reflected_inertia,
};
use percuss_mechanism::{JointId, Mechanism};
use serde::Serialize;

/// Inertia reflected to a joint.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReflectedRecord {
    /// The joint.
    pub joint: String,
    /// Index of the velocity within the joint.
    pub component: usize,
    /// Unit: `kg·m²` or `kg`.
    pub unit: &'static str,
    /// Inertia with all other joints free; null if not finite.
    pub free: Option<f64>,
    /// Kind of `free`.
    pub free_status: Status,
    /// Inertia with the other drivers at rest; null if not finite, and for a joint that is no driver.
    pub held: Option<f64>,
    /// Kind of `held`; null for a joint that is no driver.
    pub held_status: Option<Status>,
}

/// Centre of percussion of a joint.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PercussionRecord {
    /// Joint with the least impulse.
    pub joint: String,
    /// Direction of the line, axes of the contact link; null for the tangent plane.
    pub direction: Option<[f64; 3]>,
    /// Best contact point, frame of the contact link, m.
    pub point_link: [f64; 3],
    /// Displacement from the given contact point, m.
    pub distance: f64,
    /// Impulse at the joint for the given point, per impulse at the contact.
    pub given_ratio: f64,
    /// Remaining impulse at the joint for the best point, per impulse at the contact.
    pub remaining_ratio: f64,
}

/// Greatest closing speed by the limits of joint rates.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GreatestSpeedRecord {
    /// Speed, m/s.
    pub speed: f64,
    /// Joint that limits it.
    pub joint: String,
}

/// Joint by name.
pub(crate) fn find_joint(mechanism: &Mechanism, field: Field, name: &str) -> Result<JointId, StudyError> {
    mechanism.find_joint(name).map_err(|error| StudyError::input(field, error))
}

/// Rates in SI units, with the joint.
pub(crate) fn rates_of(
    mechanism: &Mechanism,
    field: Field,
    (name, given): &(String, GivenRates),
) -> Result<(JointId, Vec<f64>), StudyError> {
    let joint = find_joint(mechanism, field, name)?;
    let wrong = |source| StudyError::input(field, Fault::Position { joint: name.clone(), source });
    Ok((joint, given.values_for_joint(mechanism.joint(joint).kind()).map_err(wrong)?))
}

/// Reflected inertias of the requested joints, one record for each velocity.
pub(crate) fn reflected(
    evaluated: &EvaluatedQuestion,
    question: &ImpactQuestion,
) -> Result<Vec<ReflectedRecord>, StudyError> {
    let mechanism = &evaluated.prepared.model.mechanism;
    let mut records = Vec::new();
    for name in &question.reflected {
        let joint = find_joint(mechanism, Field::Reflected, name)?;
        let columns = evaluated.pose.motion_subspace(joint);
        if columns.is_empty() {
            return Err(StudyError::input(Field::Reflected, Fault::NoMotion { joint: name.clone() }));
        }
        for (component, column) in columns.iter().enumerate() {
            let found = reflected_inertia(&evaluated.pose, joint, component)
                .map_err(|error| StudyError::input(Field::Reflected, error))?;
            let (free_status, free) = Status::classify(found.free);
            let held = found.held.map(Status::classify);
            records.push(ReflectedRecord {
                joint: name.clone(),
                component,
                unit: if column.angular.norm() > 0.0 { "kg·m²" } else { "kg" },
                free,
                free_status,
                held: held.and_then(|(_, mass)| mass),
                held_status: held.map(|(status, _)| status),
            });
        }
    }
    Ok(records)
}

/// Centres of percussion of the requested joints.
pub(crate) fn percussion(
    evaluated: &EvaluatedQuestion,
    question: &ImpactQuestion,
) -> Result<Vec<PercussionRecord>, StudyError> {
    let (pose, contact) = (&evaluated.pose, &evaluated.contact);
    let centre = |request: &PercussionRequest| {
        let joint = find_joint(&evaluated.prepared.model.mechanism, Field::Percussion, &request.joint)?;
        let found = match request.direction {
            Some(direction) => centre_of_percussion(pose, contact, joint, direction.into()),
            None => centre_of_percussion_in_plane(pose, contact, joint),
        };
        let found = found.map_err(|error| StudyError::input(Field::Percussion, error))?;
        Ok(PercussionRecord {
            joint: request.joint.clone(),
            direction: request.direction,
            point_link: found.point.into(),
            distance: found.displacement.norm(),
            given_ratio: found.given_reaction,
            remaining_ratio: found.remaining_reaction,
        })
    };
    question.percussion.iter().map(centre).collect()
}

/// Greatest closing speed by the limits of joint rates; `None` without limits, and if the impact changes no limited rate.
pub(crate) fn greatest_speed(
    evaluated: &EvaluatedQuestion,
    question: &ImpactQuestion,
) -> Result<Option<GreatestSpeedRecord>, StudyError> {
    let mechanism = &evaluated.prepared.model.mechanism;
    let mut limits = Vec::new();
    for given in &question.rate_limits {
        let (joint, values) = rates_of(mechanism, Field::RateLimit, given)?;
        let expected = mechanism.joint(joint).kind().dofs();
        if values.len() != expected {
            let fault = Fault::RateCount { joint: given.0.clone(), got: values.len(), expected };
            return Err(StudyError::input(Field::RateLimit, fault));
        }
        if let Some(&value) = values.iter().find(|value| **value <= 0.0) {
            return Err(StudyError::input(
                Field::RateLimit,
                Fault::RateLimit { joint: given.0.clone(), value },
            ));
        }
        limits.extend(values.into_iter().enumerate().map(|(k, value)| (joint, k, value)));
    }
    let found = greatest_closing_speed(&evaluated.result.response, question.restitution, &limits);
    Ok(found
        .map(|(speed, joint)| GreatestSpeedRecord { speed, joint: mechanism.joint(joint).name().to_owned() }))
}
