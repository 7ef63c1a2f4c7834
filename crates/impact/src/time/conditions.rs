//! Conditions of an impact in time.

use crate::error::ImpactError;
use crate::reactions::tree_frames::{SpringAtJoint, SpringForces, SpringOnLine};
use nalgebra::Vector3;
use percuss_dynamics::Pose;
use percuss_mechanism::{JointId, LinkId};

/// Spring and damper of a joint with one velocity during an impact in time: the force or moment −k (q − q₀) − d q̇ on the joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointSpring {
    /// The joint.
    pub joint: JointId,
    /// Stiffness k, N·m/rad or N/m.
    pub stiffness: f64,
    /// Damping d, N·m·s/rad or N·s/m.
    pub damping: f64,
    /// Position without force q₀, rad or m; `None`: the position at the touch, so that only the change of the spring force acts.
    pub free_position: Option<f64>,
}

/// Spring between two points during an impact in time: the force k (L₀ − L) along the line of the points, which pushes them apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointSpring {
    /// Link and point (m, axes of the link) of each end.
    pub ends: [(LinkId, Vector3<f64>); 2],
    /// Rate k, N/m.
    pub rate: f64,
    /// Length without force L₀, m; `None`: the length at the touch, so that only the change of the spring force acts.
    pub free_length: Option<f64>,
}

/// Conditions of an impact in time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TimeConditions {
    /// Gravity in world axes, m/s².
    pub gravity: Vector3<f64>,
    /// Mass of a free body on the other side of the contact, kg. `None`: the other side is a link or the ground.
    pub other_mass: Option<f64>,
    /// True if the contact ends when its force vanishes; false if it ends when the gap closes, with a pull before.
    pub ends_without_force: bool,
    /// Springs and dampers of joints.
    pub springs: Vec<JointSpring>,
    /// Springs between points.
    pub point_springs: Vec<PointSpring>,
    /// Penetrations (m) at which the slope of the contact force jumps: points of a force curve. The steps of the integration end there.
    pub corners: Vec<f64>,
    /// Number of additional samples within each step of the integration, for smooth curves and for maxima between the steps.
    pub samples_within_steps: usize,
}

/// Springs with their free positions; refuses values out of range and joints without exactly one velocity.
pub(crate) fn spring_forces(pose: &Pose, conditions: &TimeConditions) -> Result<SpringForces, ImpactError> {
    let on_line = |spring: &PointSpring| {
        let PointSpring { ends, rate, free_length } = *spring;
        let [a, b] = ends.map(|(link, point)| pose.link(link).point(&point));
        let free_length = free_length.unwrap_or((b - a).norm());
        match [rate, free_length].iter().all(|x| x.is_finite() && *x >= 0.0) {
            true => Ok(SpringOnLine { ends, rate, free_length }),
            false => Err(ImpactError::PointSpring { rate, free_length }),
        }
    };
    let lines = conditions.point_springs.iter().map(on_line).collect::<Result<_, _>>()?;
    Ok(SpringForces { joints: springs_at_joints(pose, &conditions.springs)?, lines })
}

/// Springs and dampers of joints.
fn springs_at_joints(pose: &Pose, springs: &[JointSpring]) -> Result<Vec<SpringAtJoint>, ImpactError> {
    let at_joint = |spring: &JointSpring| {
        let JointSpring { joint, stiffness, damping, free_position } = *spring;
        let declared = pose.mechanism().joint(joint);
        if declared.kind().dofs() != 1 {
            return Err(ImpactError::SpringJoint { joint: declared.name().to_owned() });
        }
        let free_position = free_position.unwrap_or_else(|| pose.joint(joint)[0]);
        let is_valid = |x: f64| x.is_finite() && x >= 0.0;
        if !(is_valid(stiffness) && is_valid(damping) && free_position.is_finite()) {
            let joint = declared.name().to_owned();
            return Err(ImpactError::Spring { joint, stiffness, damping, free_position });
        }
        Ok(SpringAtJoint { joint, stiffness, damping, free_position })
    };
    springs.iter().map(at_joint).collect()
}
