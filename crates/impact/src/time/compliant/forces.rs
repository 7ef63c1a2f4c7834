//! Springs, dampers, drives and supports of an impact in time as elements of a mechanism with bushes.

use super::flow::Law;
use crate::error::ImpactError;
use crate::reactions::force_elements::{JointSpring, PointSpring, SpringAtJoint, Support};
use crate::time::conditions::{TimeConditions, spring_forces};
use percuss_contact::DamperCurve;
use percuss_dynamics::{ElementMotion, LinearElement, Pose};
use std::sync::Arc;

/// Speed at which the slope of a damper is taken for the linear part, m/s. The rest of its curve is a force of its own.
const DAMPER_SPEED: f64 = 0.1;

/// Force of an element beside its linear part.
#[derive(Clone, Debug)]
pub(super) struct ElementForce {
    /// Constant force against the motion, N or N·m.
    pub constant: f64,
    pub law: ElementLaw,
}

/// Part of the force of an element that is not linear.
#[derive(Clone, Debug)]
pub(super) enum ElementLaw {
    None,
    /// Force of the curve less the damping times the speed.
    Damper(Arc<DamperCurve>, f64),
    /// Support that never pulls.
    Support(Support),
}

impl ElementLaw {
    /// Force against the motion beside the linear part; `None` if there is none.
    pub fn force(&self) -> Option<Law<'_>> {
        match self {
            Self::None => None,
            Self::Damper(curve, damping) => Some(Box::new(move |_, v| curve.force(v) - damping * v)),
            Self::Support(support) => Some(Box::new(move |x, v| Self::pull(support, x, v))),
        }
    }

    /// Force that a support lacks because it cannot pull, at most 0.
    pub fn pull(support: &Support, x: f64, v: f64) -> f64 {
        (support.force - support.rate * x - support.damping * v).min(0.0)
    }
}

/// Linear elements of the springs, dampers, drives and supports of an impact in time at its touch, with their further forces: lines, then joints,
/// then supports.
pub(super) fn elements(
    pose: &Pose,
    conditions: &TimeConditions,
) -> Result<Vec<(LinearElement, ElementForce)>, ImpactError> {
    let forces = spring_forces(pose, conditions)?;
    let name = |link| pose.mechanism().link(link).name();
    let line = |line: &PointSpring| {
        let [a, b] = line.ends.map(|(link, point)| pose.link(link).point(&point));
        let free = line.free_length.unwrap_or_default();
        let (damping, law) = line.damper.as_ref().map_or((0.0, ElementLaw::None), damper);
        let [(a_link, _), (b_link, _)] = line.ends;
        let name = format!("{} to {}", name(a_link), name(b_link));
        let spring = LinearElement::spring(name, ElementMotion::Length(line.ends), line.rate);
        let element = LinearElement { damping, ..spring };
        (element, ElementForce { constant: line.rate * ((b - a).norm() - free) - line.drive, law })
    };
    let joint = |(given, at): (&JointSpring, &SpringAtJoint)| {
        let position = |joint| pose.joint(joint)[0];
        let twist = position(at.joint) - at.other.map_or(0.0, position);
        let name = pose.mechanism().joint(given.joint).name();
        let motion = ElementMotion::Twist(given.joint, given.other);
        let element =
            LinearElement { damping: at.damping, ..LinearElement::spring(name, motion, at.stiffness) };
        let constant = at.stiffness * (twist - at.free_position) - at.drive;
        (element, ElementForce { constant, law: ElementLaw::None })
    };
    let support = |(support, _): &(Support, f64)| {
        let direction = pose.base().inverse_vector(&support.direction);
        let motion = ElementMotion::Along(support.link, support.point, direction);
        let spring = LinearElement::spring(name(support.link), motion, support.rate);
        let element = LinearElement { damping: support.damping, ..spring };
        let constant = if support.is_balanced { 0.0 } else { -support.force };
        (element, ElementForce { constant, law: ElementLaw::Support(*support) })
    };
    let joints = conditions.springs.iter().zip(&forces.joints).map(joint);
    Ok(forces.lines.iter().map(line).chain(joints).chain(forces.supports.iter().map(support)).collect())
}

/// Damping of the linear part of a damper, and the rest.
fn damper(curve: &Arc<DamperCurve>) -> (f64, ElementLaw) {
    let slope = (curve.force(DAMPER_SPEED) - curve.force(-DAMPER_SPEED)) / (2.0 * DAMPER_SPEED);
    // A massless motion needs a damping: that of the whole curve if the damper does not act at small speeds.
    let whole = match (curve.speeds(), curve.forces()) {
        ([first, .., last], [low, .., high]) => (high - low) / (last - first),
        _ => slope,
    };
    let damping = if slope > 0.0 { slope } else { whole.max(0.0) };
    let is_linear = curve.speeds().len() <= 2
        && [-DAMPER_SPEED, 0.0]
            .iter()
            .all(|v| (curve.force(*v) - damping * v).abs() <= f64::EPSILON * damping);
    (damping, if is_linear { ElementLaw::None } else { ElementLaw::Damper(Arc::clone(curve), damping) })
}
