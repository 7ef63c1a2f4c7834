//! A mechanism at one configuration.

use crate::kinematics::Kinematics;
use crate::loops::posing::LoopState;
use crate::{Configuration, System};
use nalgebra::DMatrix;
use percuss_mechanism::{JointId, Limits, LinkId};
use percuss_spatial::Transform;

/// Every position and every frame at one configuration. Made by [`System::pose`]; there is no setter, so its
/// frames always fit its positions.
#[derive(Clone, Debug)]
pub struct Pose {
    pub(crate) kinematics: Kinematics<f64>,
    pub(crate) joint_q: Vec<std::ops::Range<usize>>,
    pub(crate) base: Transform<f64>,
    pub(crate) loops: Option<LoopState>,
}

impl System {
    /// Every joint at zero.
    pub fn configuration(&self) -> Configuration {
        Configuration::zero(&self.mechanism)
    }

    /// Joint-space mass matrix M over the coordinates, n×n, symmetric, positive semi-definite (kg, kg·m, kg·m²).
    ///
    /// Armatures included; joints that mimic are folded into their masters, GᵀMG. Composite rigid body algorithm,
    /// Featherstone 2008 §6.2. Cost: O(n · depth).
    pub fn mass_matrix(&self, pose: &Pose) -> DMatrix<f64> {
        self.reduce(&crate::mass_matrix::over_tree(self, &pose.kinematics))
    }

    /// [`mass_matrix`](Self::mass_matrix) over another scalar: dual numbers give ∂M along a direction.
    ///
    /// `positions`: those of all joints one after another, in joint order (layouts of
    /// [`JointKind`](percuss_mechanism::JointKind)); unit quaternions; entries of mimics are not read.
    ///
    /// # Panics
    /// Where the number of positions is not that of the mechanism.
    pub fn mass_matrix_over<T: percuss_spatial::Scalar>(&self, positions: &[T]) -> DMatrix<T> {
        let mut kinematics = Kinematics::new(self);
        kinematics.q.copy_from_slice(positions);
        kinematics.refill(self);
        self.reduce(&crate::mass_matrix::over_tree(self, &kinematics))
    }
}

impl Pose {
    /// What the pose of a mechanism with loops stands on; none for a tree.
    pub fn loops(&self) -> Option<&LoopState> {
        self.loops.as_ref()
    }

    /// X_wr: the root link in the world.
    pub fn base(&self) -> &Transform<f64> {
        &self.base
    }

    /// The position of a joint (layouts of [`JointKind`](percuss_mechanism::JointKind)), mimics included.
    pub fn joint(&self, joint: JointId) -> &[f64] {
        &self.kinematics.q[self.joint_q[joint.index()].clone()]
    }

    pub(crate) fn joint_of(&self, range: &std::ops::Range<usize>) -> &[f64] {
        &self.kinematics.q[range.clone()]
    }

    /// All positions one after another, in joint order.
    pub fn positions(&self) -> &[f64] {
        &self.kinematics.q
    }

    /// X_wl: a link in the world.
    pub fn link(&self, system: &System, link: LinkId) -> Transform<f64> {
        self.base * self.kinematics.link_frame(system, link)
    }

    /// Joints that stand outside their limits.
    pub fn outside_limits<'a>(
        &'a self,
        system: &'a System,
    ) -> impl Iterator<Item = (JointId, f64, Limits)> + 'a {
        system.mechanism.joint_ids().filter_map(|id| {
            let limits = system.mechanism.joint(id).limits()?;
            let &[value] = self.joint(id) else { return None };
            // A limit typed with nine digits is no violation.
            let slack = 1e-9 * (1.0 + value.abs());
            (value < limits.lower - slack || value > limits.upper + slack).then_some((id, value, limits))
        })
    }
}
