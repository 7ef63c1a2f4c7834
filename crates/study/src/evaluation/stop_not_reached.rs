//! Warning about a joint that is not at the stop of a contact.

use crate::checks::finding::{Finding, FindingSubject};
use crate::checks::finding_kind::FindingKind;
use crate::pose::touch::StopOfJoint;
use crate::question::names::Names;
use crate::thresholds::RESTING_DISTANCE;
use percuss_dynamics::Pose;
use percuss_impact::driving_joints;
use percuss_mechanism::JointKind;

/// Warning that states the distance of a joint from its stop at a pose, and the remedy; `None` if the joint is at the stop.
pub(crate) fn stop_not_reached(pose: &Pose, stop: &StopOfJoint, names: Names) -> Option<Finding> {
    let distance = stop.distance(pose);
    if distance.abs() <= RESTING_DISTANCE {
        return None;
    }
    let mechanism = pose.mechanism();
    let joint = mechanism.joint(stop.joint);
    let drivers = driving_joints(pose);
    let (name, limit) = (joint.name(), stop.limit);
    let remedy = if drivers.contains(&stop.joint) {
        format!("set {name}={limit}{}", names.hint("pose.set"))
    } else {
        let drivers: Vec<&str> = drivers.iter().map(|driver| mechanism.joint(*driver).name()).collect();
        format!(
            "its position follows from the driving joints {}: set them to positions at which \"{name}\" is at its stop{}, or give this stop \
             as the first contact{} and leave these joints unset",
            drivers.join(", "),
            names.hint("pose.set"),
            names.hint("contact.at")
        )
    };
    let unit = if joint.kind() == JointKind::Prismatic { "m" } else { "rad" };
    let side = if distance > 0.0 { "short of" } else { "beyond" };
    let end = if stop.is_upper { "upper" } else { "lower" };
    let message = format!(
        "joint \"{name}\" is at {} {unit}, {} {unit} {side} its {end} stop at {limit} {unit}, but the result assumes contact at the stop; \
         {remedy}",
        rounded(pose.joint(stop.joint)[0]),
        rounded(distance.abs()),
    );
    Some(Finding::new(FindingKind::StopNotReached, FindingSubject::Joint(stop.joint), message))
}

/// Position rounded to nine decimals, for messages.
fn rounded(position: f64) -> f64 {
    const PER_UNIT: f64 = 1e9;
    (position * PER_UNIT).round() / PER_UNIT
}
