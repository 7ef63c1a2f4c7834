//! Positions and velocities of a mechanism.

use crate::writing::structure::loop_frame;
use percuss_mechanism::LoopFrame;
use percuss_spatial::{Transform, Twist, Vector3};

/// Positions and velocities of a mechanism. The root link is at rest at the world's origin.
#[derive(Clone, Debug)]
pub struct MechanismState {
    /// Position of each joint, in joint order (layouts of [`JointKind`](percuss_mechanism::JointKind)).
    pub positions: Vec<Vec<f64>>,
    /// Velocity of each joint, in joint order (layouts of [`JointKind`](percuss_mechanism::JointKind)).
    pub velocities: Vec<Vec<f64>>,
    /// X_wl: pose of each link in the world, in link order.
    pub link_poses: Vec<Transform<f64>>,
    /// Twist of each link in world axes at the origin of the link, in link order.
    pub link_twists: Vec<Twist<f64>>,
}

impl MechanismState {
    /// Pose of a loop frame in the world.
    pub(crate) fn frame(&self, end: &LoopFrame) -> Transform<f64> {
        loop_frame(&self.link_poses, end)
    }

    /// Angular velocity of the link of a loop frame, and velocity of a point (m, world) that moves with this link; world axes.
    pub(crate) fn velocity(&self, end: &LoopFrame, point: &Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
        let Some(link) = end.link else { return (Vector3::zeros(), Vector3::zeros()) };
        let twist = &self.link_twists[link.index()];
        let arm = point - self.link_poses[link.index()].translation;
        (twist.angular, twist.linear + twist.angular.cross(&arm))
    }
}
