//! Conditions of an impact in time.

use crate::error::ImpactError;
use crate::reactions::force_elements::{JointSpring, PointSpring, SpringAtJoint, SpringForces};
use nalgebra::Vector3;
use percuss_dynamics::Pose;

/// Conditions of an impact in time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TimeConditions {
    /// Gravity in world axes, m/s².
    pub gravity: Vector3<f64>,
    /// Mass of a free body on the other side of the contact, kg. `None`: the other side is a link or the ground.
    pub other_mass: Option<f64>,
    /// True if the contact ends when its force vanishes; false if it ends when the gap closes, with a pull before.
    pub ends_without_force: bool,
    /// Springs, dampers and drives of joints.
    pub springs: Vec<JointSpring>,
    /// Springs, dampers and drives between points.
    pub point_springs: Vec<PointSpring>,
    /// Penetrations (m) at which the slope of the contact force jumps: points of a force curve. The steps of the integration end there.
    pub corners: Vec<f64>,
    /// Number of additional samples within each step of the integration, for smooth curves and for maxima between the steps.
    pub samples_within_steps: usize,
}

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
    Ok(SpringForces { joints: springs_at_joints(pose, &conditions.springs)?, lines })
}

/// Springs and dampers of joints.
fn springs_at_joints(pose: &Pose, springs: &[JointSpring]) -> Result<Vec<SpringAtJoint>, ImpactError> {
    let at_joint = |spring: &JointSpring| {
        let JointSpring { joint, stiffness, damping, free_position, drive } = *spring;
        let declared = pose.mechanism().joint(joint);
        if declared.kind().dofs() != 1 {
            return Err(ImpactError::SpringJoint { joint: declared.name().to_owned() });
        }
        let free_position = free_position.unwrap_or_else(|| pose.joint(joint)[0]);
        let is_valid = |x: f64| x.is_finite() && x >= 0.0;
        if !(is_valid(stiffness) && is_valid(damping) && free_position.is_finite() && drive.is_finite()) {
            let joint = declared.name().to_owned();
            return Err(ImpactError::Spring { joint, stiffness, damping, free_position, drive });
        }
        Ok(SpringAtJoint { joint, stiffness, damping, free_position, drive })
    };
    springs.iter().map(at_joint).collect()
}
