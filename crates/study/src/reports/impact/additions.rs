//! Additional results about an impact: reflected inertias, centres of percussion, greatest closing speed.

use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::evaluation::status::Status;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::field::Field;
use crate::question::travel::vary::Vary;
use crate::reports::impact::question::{ImpactQuestion, PercussionRequest};
use crate::thresholds::UNCHANGED_RATE;
use crate::values::rates::GivenRates;
use percuss_dynamics::EffectiveMass;
use percuss_impact::{
    Bearing, centre_of_percussion, centre_of_percussion_in_plane, greatest_closing_speed,
    greatest_closing_speed_of_gears, reflected_inertia, reflected_inertia_over, worst_reaction_within,
};
use percuss_mechanism::{JointId, JointKind, Mechanism, near_names};
use percuss_units::Dimension;
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

/// Inertia reflected to a joint over a range of its positions.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReflectedRangeRecord {
    /// The joint.
    pub joint: String,
    /// Unit: `kg·m²` or `kg`.
    pub unit: &'static str,
    /// Positions of the joint, rad or m.
    pub positions: Vec<f64>,
    /// Inertia with all other joints free at each position; null if not finite.
    pub free: Vec<Option<f64>>,
    /// Inertia with the other drivers at rest; null if not finite, and for a joint that is no driver.
    pub held: Vec<Option<f64>>,
    /// Smallest held inertia (free for a joint that is no driver); null without a finite one.
    pub least: Option<f64>,
    /// Largest held inertia.
    pub most: Option<f64>,
    /// Constant with the smallest largest relative error: the harmonic mean of both.
    pub best_constant: Option<f64>,
    /// Largest relative error of this constant.
    pub largest_error: Option<f64>,
}

/// Centre of percussion of a joint, a closure or the ground.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PercussionRecord {
    /// Bearing with the least impulse: name of a joint or of a closure, or `ground`.
    pub joint: String,
    /// Direction of the line, axes of the contact link; null for the tangent plane.
    pub direction: Option<[f64; 3]>,
    /// Best contact point, frame of the contact link, m.
    pub point_link: [f64; 3],
    /// Displacement from the given contact point, m.
    pub distance: f64,
    /// Impulse at the joint for the given point, per impulse at the contact.
    pub given_ratio: f64,
    /// Remaining impulse at the joint for the best point, per impulse at the contact. Both ratios are those of the determinate
    /// components.
    pub remaining_ratio: f64,
    /// True for each component of the impulse (two transverse directions, the axis of the joint) that redundant loops leave open.
    pub open_components: [bool; 3],
    /// Loops that leave these components open.
    pub open_by: Vec<String>,
    /// Largest impulse at the joint, per impulse at the contact, for contact points displaced by at most the given distance in the
    /// tangent plane; null without a distance.
    pub worst_ratio: Option<f64>,
    /// Contact point with this impulse, frame of the contact link, m.
    pub worst_point_link: Option<[f64; 3]>,
}

/// Greatest closing speed by the limits of joint rates and gears.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct GreatestSpeedRecord {
    /// Speed, m/s.
    pub speed: f64,
    /// Joint that limits it.
    pub joint: String,
    /// Limit that is reached: `rate` or `gear`.
    pub limit: &'static str,
}

/// Name of the ground under the root link as a bearing.
const GROUND: &str = "ground";

/// Joint by name.
pub(crate) fn find_joint(mechanism: &Mechanism, field: Field, name: &str) -> Result<JointId, StudyError> {
    mechanism.find_joint(name).map_err(|error| {
        if mechanism.closures().iter().any(|closure| closure.name() == name) {
            return StudyError::input(field, Fault::IsClosure { closure: name.to_owned() });
        }
        StudyError::input(field, error)
    })
}

/// Finds a bearing by the name of a joint or of a closure. `ground` and the name of the root link give the ground under the root link.
pub(crate) fn find_bearing(mechanism: &Mechanism, field: Field, name: &str) -> Result<Bearing, StudyError> {
    let closure = mechanism.closures().iter().position(|closure| closure.name() == name);
    let is_ground = name == GROUND || name == mechanism.link(mechanism.root()).name();
    match closure {
        _ if mechanism.find_joint(name).is_ok() => {}
        Some(closure) => return Ok(Bearing::Closure(closure)),
        None if is_ground => return Ok(Bearing::Ground),
        None => {}
    }
    mechanism.find_joint(name).map(Bearing::Joint).map_err(|_| {
        let joints = mechanism.joints().iter().map(|joint| joint.name());
        let closures = mechanism.closures().iter().map(|closure| closure.name());
        let all: Vec<&str> = joints.chain(closures).chain([GROUND]).collect();
        let near = near_names(name, all.iter().copied());
        let names =
            if near.is_empty() { all.iter().take(12).map(|name| (*name).to_owned()).collect() } else { near };
        StudyError::input(field, Fault::UnknownBearing { name: name.to_owned(), names })
    })
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
    for name in question.reflected.iter().filter(|name| range_of(evaluated, name).is_none()) {
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

/// Joint and range of a request `JOINT=FROM:TO:COUNT`; `None` for the name of a joint.
fn range_of<'t>(evaluated: &EvaluatedQuestion, text: &'t str) -> Option<(&'t str, &'t str)> {
    let mechanism = &evaluated.prepared.model.mechanism;
    if mechanism.find_joint(text).is_ok() { None } else { text.rsplit_once('=') }
}

/// Reflected inertias over the requested ranges of positions.
pub(crate) fn reflected_over(
    evaluated: &EvaluatedQuestion,
    question: &ImpactQuestion,
) -> Result<Vec<ReflectedRangeRecord>, StudyError> {
    let prepared = &evaluated.prepared;
    let mechanism = &prepared.model.mechanism;
    let mut records = Vec::new();
    for text in &question.reflected {
        let Some((name, _)) = range_of(evaluated, text) else { continue };
        let joint = find_joint(mechanism, Field::Reflected, name)?;
        let kind = mechanism.joint(joint).kind();
        let range: Vary = Vary::parse(text).map_err(|error| {
            StudyError::input(Field::Reflected, Fault::RangeText { message: error.to_string() })
        })?;
        let dimension = match kind {
            JointKind::Revolute | JointKind::Continuous => Dimension::Angle,
            JointKind::Prismatic => Dimension::Length,
            _ => {
                return Err(StudyError::input(Field::Reflected, Fault::NoMotion { joint: name.to_owned() }));
            }
        };
        let values = range
            .values(dimension)
            .map_err(|error| StudyError::input(Field::Reflected, Fault::Range(error)))?;
        let positions: Vec<f64> = (0..values.count).map(|row| values.value_at(row)).collect();
        let found = reflected_inertia_over(&prepared.system, &prepared.configuration, joint, &positions)
            .map_err(|error| StudyError::input(Field::Reflected, error))?;
        let known = |mass: EffectiveMass| mass.kilograms();
        records.push(ReflectedRangeRecord {
            joint: name.to_owned(),
            unit: if dimension == Dimension::Angle { "kg·m²" } else { "kg" },
            free: found.samples.iter().map(|s| known(s.inertia.free)).collect(),
            held: found.samples.iter().map(|s| s.inertia.held.and_then(known)).collect(),
            positions,
            least: found.least,
            most: found.most,
            best_constant: found.best_constant,
            largest_error: found.largest_error,
        });
    }
    Ok(records)
}

/// Centres of percussion of the requested bearings.
pub(crate) fn percussion(
    evaluated: &EvaluatedQuestion,
    question: &ImpactQuestion,
) -> Result<Vec<PercussionRecord>, StudyError> {
    let (pose, contact) = (&evaluated.pose, &evaluated.contact);
    let centre = |request: &PercussionRequest| {
        let mechanism = &evaluated.prepared.model.mechanism;
        let bearing = find_bearing(mechanism, Field::Percussion, &request.joint)?;
        let found = match request.direction {
            Some(direction) => centre_of_percussion(pose, contact, bearing, direction.into()),
            None => centre_of_percussion_in_plane(pose, contact, bearing),
        };
        let found = found.map_err(|error| StudyError::input(Field::Percussion, error))?;
        let worst = question.point_error.map(|radius| worst_reaction_within(pose, contact, bearing, radius));
        let worst = worst.transpose().map_err(|error| StudyError::input(Field::PointError, error))?;
        Ok(PercussionRecord {
            worst_ratio: worst.as_ref().map(|worst| worst.worst_reaction),
            worst_point_link: worst.as_ref().map(|worst| worst.point.into()),
            joint: request.joint.clone(),
            direction: request.direction,
            point_link: found.point.into(),
            distance: found.displacement.norm(),
            given_ratio: found.given_reaction,
            remaining_ratio: found.remaining_reaction,
            open_components: found.is_open,
            open_by: found.loops,
        })
    };
    question.percussion.iter().map(centre).collect()
}

/// Greatest closing speed by the limits of joint rates and gears; `None` without limits, and if the impact changes no limited rate.
pub(crate) fn greatest_speed(
    evaluated: &EvaluatedQuestion,
    question: &ImpactQuestion,
) -> Result<Option<GreatestSpeedRecord>, StudyError> {
    let mechanism = &evaluated.prepared.model.mechanism;
    let mut limits = Vec::new();
    let is_changed = |joint: JointId| !unchanged_joints(evaluated).contains(&joint);
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
        if is_changed(joint) {
            limits.extend(values.into_iter().enumerate().map(|(k, value)| (joint, k, value)));
        }
    }
    let (response, e) = (&evaluated.result.response, question.restitution);
    let by_rates = greatest_closing_speed(response, e, &limits).map(|found| (found, "rate"));
    let mut gears = gear_limits(evaluated, question)?;
    gears.retain(|(joint, _, _)| is_changed(*joint));
    let by_gears = greatest_closing_speed_of_gears(&evaluated.pose, response, e, &gears);
    let found = by_rates.into_iter().chain(by_gears.map(|found| (found, "gear")));
    let least = found.min_by(|((a, _), _), ((b, _), _)| a.total_cmp(b));
    let name = |joint: JointId| mechanism.joint(joint).name().to_owned();
    Ok(least.map(|((speed, joint), limit)| GreatestSpeedRecord { speed, joint: name(joint), limit }))
}

/// Joints with a limit of the rate or of the gear that has no effect, since the impact does not change their rates.
pub(crate) fn limits_without_effect(evaluated: &EvaluatedQuestion, question: &ImpactQuestion) -> Vec<String> {
    let mechanism = &evaluated.prepared.model.mechanism;
    let unchanged: Vec<&str> =
        unchanged_joints(evaluated).into_iter().map(|joint| mechanism.joint(joint).name()).collect();
    let rates = question.rate_limits.iter().map(|(name, _)| name);
    let gears = question.gear_limits.iter().map(|(name, _)| name);
    let mut names: Vec<String> = Vec::new();
    for name in rates.chain(gears).filter(|name| unchanged.contains(&name.as_str())) {
        if !names.contains(name) {
            names.push(name.clone());
        }
    }
    names
}

/// Joints whose rates the impact does not change.
fn unchanged_joints(evaluated: &EvaluatedQuestion) -> Vec<JointId> {
    let rates = &evaluated.result.response.joint_velocities;
    let size = |rates: &[f64]| rates.iter().fold(0.0, |most: f64, rate| most.max(rate.abs()));
    let largest = rates.iter().map(|rates| size(rates)).fold(0.0, f64::max);
    let joints = evaluated.prepared.model.mechanism.joint_ids();
    joints.filter(|joint| size(&rates[joint.index()]) <= UNCHANGED_RATE * largest).collect()
}

/// Limits of the impulses in gears: joint, velocity, impulse.
fn gear_limits(
    evaluated: &EvaluatedQuestion,
    question: &ImpactQuestion,
) -> Result<Vec<(JointId, usize, f64)>, StudyError> {
    let mechanism = &evaluated.prepared.model.mechanism;
    let mut limits = Vec::new();
    for (name, values) in &question.gear_limits {
        let refuse = |fault| StudyError::input(Field::GearLimit, fault);
        let joint = find_joint(mechanism, Field::GearLimit, name)?;
        let (got, expected) = (values.len(), mechanism.joint(joint).kind().dofs());
        if got != expected {
            return Err(refuse(Fault::LimitCount { joint: name.clone(), got, expected }));
        }
        if let Some(&value) = values.iter().find(|value| !(value.is_finite() && **value > 0.0)) {
            return Err(refuse(Fault::RateLimit { joint: name.clone(), value }));
        }
        if evaluated.pose.armature(joint).iter().all(|armature| *armature == 0.0) {
            return Err(refuse(Fault::NoGear { joint: name.clone() }));
        }
        limits.extend(values.iter().enumerate().map(|(k, value)| (joint, k, *value)));
    }
    Ok(limits)
}
