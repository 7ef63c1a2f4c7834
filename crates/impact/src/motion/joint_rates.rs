//! Rates of all joints and of the base.

use crate::reactions::tree_frames::TreeFrames;
use percuss_dynamics::Pose;
use percuss_mechanism::{JointId, Mechanism};
use percuss_spatial::Twist;

/// Velocities of all joints and of the root link.
#[derive(Clone, Debug, PartialEq)]
pub struct JointRates {
    /// Velocities of every joint, in joint order (layouts of [`JointKind`](percuss_mechanism::JointKind)).
    pub joints: Vec<Vec<f64>>,
    /// Twist of the root link, in root axes at the root origin; zero if the root link is the ground.
    pub base: Twist<f64>,
}

impl JointRates {
    /// All joints at rest.
    pub fn at_rest(mechanism: &Mechanism) -> Self {
        let joints = mechanism.joints().iter().map(|j| vec![0.0; j.kind().dofs()]).collect();
        Self { joints, base: Twist::zero() }
    }

    /// Rates `self` + `factor` · `other`.
    pub fn plus_scaled(&self, other: &Self, factor: f64) -> Self {
        self.plus_scaled_motion(&other.joints, other.base, factor)
    }

    /// Rates `self` + `factor` · (`joints`, `base`).
    pub(crate) fn plus_scaled_motion(&self, joints: &[Vec<f64>], base: Twist<f64>, factor: f64) -> Self {
        let joint = |(a, b): (&Vec<f64>, &Vec<f64>)| a.iter().zip(b).map(|(a, b)| a + factor * b).collect();
        Self { joints: self.joints.iter().zip(joints).map(joint).collect(), base: self.base + base * factor }
    }

    /// Rates `factor` · (`joints`, `base`).
    pub(crate) fn scaled(joints: &[Vec<f64>], base: Twist<f64>, factor: f64) -> Self {
        let joint = |rates: &Vec<f64>| rates.iter().map(|rate| factor * rate).collect();
        Self { joints: joints.iter().map(joint).collect(), base: base * factor }
    }

    /// Sets the rates to `factor` times `velocities` (of all joints, concatenated) and `base`. Reuses the memory.
    pub(crate) fn set_scaled(
        &mut self,
        tree: &TreeFrames,
        velocities: &[f64],
        base: Twist<f64>,
        factor: f64,
    ) {
        self.joints.resize_with(tree.mechanism.joints().len(), Vec::new);
        for (joint, rates) in tree.mechanism.joint_ids().zip(&mut self.joints) {
            rates.clear();
            rates.extend(tree.of_joint(joint, velocities).iter().map(|rate| factor * rate));
        }
        self.base = base * factor;
    }

    /// Velocities of a joint.
    ///
    /// # Panics
    /// If the joint belongs to another mechanism with more joints.
    pub fn joint(&self, joint: JointId) -> &[f64] {
        &self.joints[joint.index()]
    }

    /// Rates of the coordinates of a pose: of the floating base and of every joint that is neither locked nor a mimic.
    pub(crate) fn coordinates(&self, pose: &Pose) -> Vec<f64> {
        let base: Vec<f64> = self.base.angular.iter().chain(self.base.linear.iter()).copied().collect();
        let rate =
            |(joint, k): (Option<JointId>, usize)| joint.map_or(base[k], |j| self.joints[j.index()][k]);
        pose.coordinate_joints().into_iter().map(rate).collect()
    }
}
