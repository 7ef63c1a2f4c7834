//! Additional results about an impact: centres of percussion, greatest closing speed.

use crate::damper::damping::damper;
use crate::evaluation::joint_ranges::find_joint;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::tables::impact::{ImpactQuestion, PercussionRequest};
use crate::thresholds::{CONVERGED_SPEED, SPEED_ITERATIONS, UNCHANGED_RATE};
use crate::values::drives::GearLimit;
use crate::values::rates::GivenRates;
use percuss_impact::{
    Bearing, centre_of_percussion, centre_of_percussion_in_plane, greatest_closing_speed,
    greatest_closing_speed_of_gears, worst_reaction_within,
};
use percuss_mechanism::{JointId, Mechanism, near_names};
use schemars::JsonSchema;
use serde::Serialize;

/// Centre of percussion of a joint, a closure or the ground.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct PercussionRecord {
    /// Bearing with the least impulse: name of a joint or of a closure, or `ground`.
    pub joint: String,
    /// Direction of the line, axes of the contact link; null for the tangent plane.
    pub direction: Option<[f64; 3]>,
    /// Best contact point, frame of the contact link, m.
    pub point_link: [f64; 3],
    /// The same point in the world, m.
    pub point_world: [f64; 3],
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
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct GreatestSpeedRecord {
    /// Speed, m/s.
    pub speed: f64,
    /// Joint that limits it.
    pub joint: String,
    /// Limit that is reached: `rate`, `gear` (impulse in the gear) or `gear-torque`.
    pub limit: &'static str,
}

/// Name of the ground under the root link as a bearing.
const GROUND: &str = "ground";

/// Finds a bearing by the name of a joint or of a closure. `ground` and the name of the root link give the ground under the root link.
pub(crate) fn find_bearing(
    mechanism: &Mechanism,
    field: &'static str,
    name: &str,
) -> Result<Bearing, StudyError> {
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
        // Without similar names, the first twelve bearings.
        let names = if near.is_empty() { all[..all.len().min(12)].join(", ") } else { near.join(", ") };
        StudyError::input(
            field,
            format!("no joint or loop closure has the name \"{name}\"; expected one of {names}"),
        )
    })
}

/// Rates in SI units, with the joint.
pub(crate) fn rates_of(
    mechanism: &Mechanism,
    field: &'static str,
    (name, given): &(String, GivenRates),
) -> Result<(JointId, Vec<f64>), StudyError> {
    let joint = find_joint(mechanism, field, name)?;
    let wrong = |source| StudyError::input(field, Fault::Position { joint: name.clone(), source });
    Ok((joint, given.values_for_joint(mechanism.joint(joint).kind()).map_err(wrong)?))
}

/// Centres of percussion of the requested bearings.
pub(crate) fn percussion(
    evaluated: &EvaluatedQuestion,
    question: &ImpactQuestion,
) -> Result<Vec<PercussionRecord>, StudyError> {
    let (pose, contact) = (&evaluated.pose, &evaluated.contact);
    let centre = |request: &PercussionRequest| {
        let mechanism = &evaluated.prepared.model.mechanism;
        let bearing = find_bearing(mechanism, "impact.percussion", &request.joint)?;
        let found = match request.direction {
            Some(direction) => centre_of_percussion(pose, contact, bearing, direction.into()),
            None => centre_of_percussion_in_plane(pose, contact, bearing),
        };
        let found = found.map_err(StudyError::about("impact.percussion"))?;
        let worst =
            question.point_error.map(|radius| worst_reaction_within(pose, contact, bearing, radius.0));
        let worst = worst.transpose().map_err(StudyError::about("impact.point_error"))?;
        Ok(PercussionRecord {
            worst_ratio: worst.as_ref().map(|worst| worst.worst_reaction),
            worst_point_link: worst.as_ref().map(|worst| worst.point.into()),
            joint: request.joint.clone(),
            direction: request.direction,
            point_link: found.point.into(),
            point_world: pose.link(contact.link).point(&found.point).into(),
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
    for given in &question.rate_limit {
        let (joint, values) = rates_of(mechanism, "impact.rate_limit", given)?;
        let expected = mechanism.joint(joint).kind().dofs();
        if values.len() != expected {
            let (joint, got) = (&given.0, values.len());
            let why = format!("joint \"{joint}\": {got} rates are given; expected {expected}");
            return Err(StudyError::input("impact.rate_limit", why));
        }
        if let Some(&value) = values.iter().find(|value| **value <= 0.0) {
            return Err(StudyError::input("impact.rate_limit", limit_text(&given.0, value)));
        }
        if is_changed(joint) {
            limits.extend(values.into_iter().enumerate().map(|(k, value)| (joint, k, value)));
        }
    }
    let (response, e) = (&evaluated.result.response, question.restitution());
    let by_rates = greatest_closing_speed(response, e, &limits).map(|found| (found, "rate"));
    let (mut impulses, mut torques) = gear_limits(evaluated, question)?;
    impulses.retain(|(joint, _, _)| is_changed(*joint));
    torques.retain(|(joint, _, _)| is_changed(*joint));
    let by_impulses = greatest_closing_speed_of_gears(&evaluated.pose, response, e, &impulses);
    let by_torques = greatest_speed_of_torques(evaluated, question, &torques)?;
    let by_gears = by_impulses.map(|found| (found, "gear")).into_iter();
    let by_gears = by_gears.chain(by_torques.map(|found| (found, "gear-torque")));
    let found = by_rates.into_iter().chain(by_gears);
    let least = found.min_by(|((a, _), _), ((b, _), _)| a.total_cmp(b));
    let name = |joint: JointId| mechanism.joint(joint).name().to_owned();
    Ok(least.map(|((speed, joint), limit)| GreatestSpeedRecord { speed, joint: name(joint), limit }))
}

/// Message: a limit that is not positive.
fn limit_text(joint: &str, value: f64) -> String {
    format!("joint \"{joint}\": the limit is {value}; expected a number above zero")
}

/// Joints with a limit of the rate or of the gear that has no effect, since the impact does not change their rates.
pub(crate) fn limits_without_effect(evaluated: &EvaluatedQuestion, question: &ImpactQuestion) -> Vec<String> {
    let mechanism = &evaluated.prepared.model.mechanism;
    let unchanged: Vec<&str> =
        unchanged_joints(evaluated).into_iter().map(|joint| mechanism.joint(joint).name()).collect();
    let rates = question.rate_limit.iter().map(|(name, _)| name);
    let gears = question.gear_limit.iter().map(|(name, _)| name);
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

/// Limit of a gear: joint, velocity, and largest impulse or torque.
type JointLimit = (JointId, usize, f64);

/// Limits of gears: impulses, and torques or forces.
fn gear_limits(
    evaluated: &EvaluatedQuestion,
    question: &ImpactQuestion,
) -> Result<(Vec<JointLimit>, Vec<JointLimit>), StudyError> {
    let mechanism = &evaluated.prepared.model.mechanism;
    let (mut impulses, mut torques) = (Vec::new(), Vec::new());
    for (name, given) in &question.gear_limit {
        let refuse = |fault: Fault| StudyError::input("impact.gear_limit", fault);
        let joint = find_joint(mechanism, "impact.gear_limit", name)?;
        let kind = mechanism.joint(joint).kind();
        let wrong = |source| refuse(Fault::Position { joint: name.clone(), source });
        let limits = given.limits_for_joint(kind).map_err(wrong)?;
        let (got, expected) = (limits.len(), kind.dofs());
        if got != expected {
            let why = format!("joint \"{name}\": {got} limits are given; expected {expected}");
            return Err(refuse(why.into()));
        }
        if evaluated.pose.armature(joint).iter().all(|armature| *armature == 0.0) {
            let why = format!(
                "joint \"{name}\" has no armature, so its gear receives no impulse; give --armature {name}=VALUE"
            );
            return Err(refuse(why.into()));
        }
        for (k, limit) in limits.into_iter().enumerate() {
            let (value, list) = match limit {
                GearLimit::Impulse(value) => (value, &mut impulses),
                GearLimit::Torque(value) => (value, &mut torques),
            };
            if value <= 0.0 {
                return Err(refuse(limit_text(name, value).into()));
            }
            list.push((joint, k, value));
        }
    }
    Ok((impulses, torques))
}

/// Greatest closing speed at which no peak torque of a gear exceeds its limit, and the joint that determines this speed. `None` if the
/// impact changes no rate of a rotor with a limit.
///
/// The impulse of a gear per impulse of the contact is armature · |v*|/m̄. The peak torque is this ratio times the peak force F of the
/// contact. F grows as v^(2p/(p+1)) with the closing speed v, with p the exponent of the spring.
fn greatest_speed_of_torques(
    evaluated: &EvaluatedQuestion,
    question: &ImpactQuestion,
    limits: &[JointLimit],
) -> Result<Option<(f64, JointId)>, StudyError> {
    if limits.is_empty() {
        return Ok(None);
    }
    let refuse = || {
        let why =
            "a limit in N·m or N requires the stiffness of the contact, which determines the peak torque";
        StudyError::input("impact.gear_limit", why)
    };
    // For a force curve, the steps are those of a linear spring.
    let exponent = question.contact_law(1.0).ok_or_else(refuse)?.exponent();
    let response = &evaluated.result.response;
    let Some(mass) = response.effective_mass.kilograms() else { return Ok(None) };
    let force = |&(joint, k, limit): &JointLimit| {
        let armature = evaluated.pose.armature(joint).get(k)?.abs();
        let ratio = armature * response.joint_velocities.get(joint.index())?.get(k)?.abs() / mass;
        (ratio > 0.0).then_some((limit / ratio, joint))
    };
    let least = limits.iter().filter_map(force).min_by(|(a, _), (b, _)| a.total_cmp(b));
    let Some((largest_force, joint)) = least else { return Ok(None) };
    let peak_at = |speed: f64| -> Result<Option<f64>, StudyError> {
        let law = question.contact_law(speed).ok_or_else(refuse)?;
        Ok(damper(&law, mass)?.peak_force)
    };
    let mut speed = 1.0;
    for _ in 0..SPEED_ITERATIONS {
        let Some(peak) = peak_at(speed)?.filter(|peak| peak.is_finite() && *peak > 0.0) else {
            return Ok(None);
        };
        let factor = (largest_force / peak).powf((exponent + 1.0) / (2.0 * exponent));
        speed *= factor;
        if (factor - 1.0).abs() < CONVERGED_SPEED {
            break;
        }
    }
    Ok(Some((speed, joint)))
}
