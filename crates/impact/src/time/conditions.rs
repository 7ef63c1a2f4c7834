//! Conditions of an impact in time.

use crate::error::ImpactError;
use crate::reactions::force_elements::{JointSpring, PointSpring, SpringAtJoint, SpringForces, Support};
use crate::tolerances::{MOST_DOUBLINGS, WORK_INTERVALS};
use nalgebra::Vector3;
use percuss_dynamics::{ConstraintAction, ConstraintSource, Pose};

/// Conditions of an impact in time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TimeConditions {
    /// Gravity in world axes, m/s².
    pub gravity: Vector3<f64>,
    /// Mass of a free body on the other side of the contact, kg. `None`: the other side is a link or the ground.
    pub other_mass: Option<f64>,
    /// True if the contact ends when its force vanishes; false if it ends when the gap closes, with a pull before.
    pub ends_without_force: bool,
    /// True if the force jumps where the closing speed changes its sign, as that of a hysteresis. The steps of the integration end there.
    pub jumps_at_reversal: bool,
    /// Springs, dampers and drives of joints.
    pub springs: Vec<JointSpring>,
    /// Springs, dampers and drives between points.
    pub point_springs: Vec<PointSpring>,
    /// Supports of points by the ground.
    pub supports: Vec<Support>,
    /// Penetrations (m) at which the slope of the contact force jumps: points of a force curve. The steps of the integration end there.
    pub corners: Vec<f64>,
    /// Number of additional samples within each step of the integration, for smooth curves and for maxima between the steps.
    pub samples_within_steps: usize,
}

/// Largest difference of the length of a direction from 1: rounding of a given direction.
const UNIT_DIRECTION: f64 = 1e-9;

/// Springs with their free positions; refuses values out of range and joints without exactly one velocity.
pub(crate) fn spring_forces(pose: &Pose, conditions: &TimeConditions) -> Result<SpringForces, ImpactError> {
    let on_line = |spring: &PointSpring| {
        let [a, b] = spring.ends.map(|(link, point)| pose.link(link).point(&point));
        let free_length = spring.free_length.unwrap_or_else(|| (b - a).norm());
        let PointSpring { rate, drive, .. } = *spring;
        match [rate, free_length].iter().all(|x| x.is_finite() && *x >= 0.0) && drive.is_finite() {
            true => Ok(PointSpring { free_length: Some(free_length), ..spring.clone() }),
            false => Err(ImpactError::PointSpring { rate, free_length, drive }),
        }
    };
    let lines = conditions.point_springs.iter().map(on_line).collect::<Result<_, _>>()?;
    let support = |support: &Support| {
        let Support { rate, damping, force, .. } = *support;
        let start = support.direction.dot(&pose.link(support.link).point(&support.point));
        let is_valid = [rate, damping, force].iter().all(|x| x.is_finite() && *x >= 0.0);
        match is_valid && (support.direction.norm() - 1.0).abs() < UNIT_DIRECTION {
            true => Ok((*support, start)),
            false => Err(ImpactError::Support { rate, damping, force }),
        }
    };
    let supports = conditions.supports.iter().map(support).collect::<Result<_, _>>()?;
    Ok(SpringForces { joints: springs_at_joints(pose, &conditions.springs)?, lines, supports })
}

/// Springs and dampers of joints.
fn springs_at_joints(pose: &Pose, springs: &[JointSpring]) -> Result<Vec<SpringAtJoint>, ImpactError> {
    let at_joint = |spring: &JointSpring| {
        let JointSpring { joint, other, stiffness, damping, free_position, drive } = *spring;
        let declared = pose.mechanism().joint(joint);
        for declared in [Some(joint), other].into_iter().flatten().map(|id| pose.mechanism().joint(id)) {
            if declared.kind().dofs() != 1 {
                return Err(ImpactError::SpringJoint { joint: declared.name().to_owned() });
            }
        }
        let position = |joint| pose.joint(joint)[0];
        let free_position = free_position.unwrap_or_else(|| position(joint) - other.map_or(0.0, position));
        let is_valid = |x: f64| x.is_finite() && x >= 0.0;
        if !(is_valid(stiffness) && is_valid(damping) && free_position.is_finite() && drive.is_finite()) {
            let joint = declared.name().to_owned();
            return Err(ImpactError::Spring { joint, stiffness, damping, free_position, drive });
        }
        Ok(SpringAtJoint { joint, other, stiffness, damping, free_position, drive })
    };
    springs.iter().map(at_joint).collect()
}

/// Refuses constraints between a floating base and the ground: poses keep the ground at the root link.
pub(crate) fn refuse_grounded_base(pose: &Pose) -> Result<(), ImpactError> {
    let is_floating = pose.coordinate_joints().first().is_some_and(|(joint, _)| joint.is_none());
    let constraints = pose.constraint_groups().into_iter().flat_map(|group| group.constraints);
    let on_ground = |c: &ConstraintAction| {
        !matches!(c.source, ConstraintSource::Coupling(_))
            && (c.successor.is_none() || c.predecessor.is_none())
    };
    if is_floating && constraints.into_iter().any(|c| on_ground(&c)) {
        return Err(ImpactError::GroundedBase);
    }
    Ok(())
}

/// Penetration at which the force at rest has done the work `energy`.
pub(crate) fn stopping_depth(force: &dyn Fn(f64, f64) -> f64, energy: f64) -> Result<f64, ImpactError> {
    let work = |depth: f64| {
        let part = depth / f64::from(WORK_INTERVALS);
        (0..WORK_INTERVALS).map(|k| force((f64::from(k) + 0.5) * part, 0.0) * part).sum::<f64>()
    };
    let mut depth = 1.0;
    for _ in 0..MOST_DOUBLINGS {
        if work(depth) < energy {
            depth *= 2.0;
        } else if work(0.5 * depth) >= energy {
            depth *= 0.5;
        } else {
            return Ok(depth);
        }
    }
    Err(ImpactError::EndlessContact { time: f64::INFINITY })
}
