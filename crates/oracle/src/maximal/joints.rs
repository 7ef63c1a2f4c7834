//! Constraint rows and velocity rows of tree joints.

use super::row::{Row, WORLD, com, rotation, translation, velocity_row};
use super::{Question, pose};
use nalgebra::{Matrix4, Vector3};
use percuss_mechanism::{Joint, JointKind};
use percuss_spatial::plane_basis;

/// Joint in world axes.
pub(super) struct JointInWorld<'a> {
    pub(super) joint: &'a Joint,
    /// Vector from the parent's centre of mass to the child's origin.
    pub(super) arm_parent: Vector3<f64>,
    /// Vector from the child's centre of mass to the child's origin.
    pub(super) arm_child: Vector3<f64>,
    /// Unit vectors e1, e2 normal to the axis, and the axis.
    frame: [Vector3<f64>; 3],
    /// Axes of the child.
    child_axes: [Vector3<f64>; 3],
}

impl<'a> JointInWorld<'a> {
    /// Places a joint at the position `q`, with moment arms and axes in the world.
    pub(super) fn new(joint: &'a Joint, q: &[f64], question: &Question, x_wl: &[Matrix4<f64>]) -> Self {
        let (parent, child) = (joint.parent().index(), joint.child().index());
        let links = question.mechanism.links();
        let (r_wp, r_wc) = (rotation(&x_wl[parent]), rotation(&x_wl[child]));
        // Moment arms come from the relative pose, so that a distant world origin adds no rounding.
        let x_pc = pose::origin(joint) * pose::motion(joint, q);
        let r_wj = r_wp * joint.origin().rotation;
        let (e1, e2) = plane_basis(joint.axis());
        Self {
            joint,
            arm_parent: r_wp * (translation(&x_pc) - com(&links[parent])),
            arm_child: -(r_wc * com(&links[child])),
            frame: [r_wj * e1, r_wj * e2, r_wj * joint.axis()],
            child_axes: [0, 1, 2].map(|i| r_wc.column(i).into_owned()),
        }
    }

    /// n · (angular velocity of the child relative to the parent).
    pub(super) fn angular(&self, n: &Vector3<f64>) -> Row {
        let (parent, child) = (self.joint.parent().index(), self.joint.child().index());
        Row(vec![(child, *n, Vector3::zeros()), (parent, -n, Vector3::zeros())])
    }

    /// n · (velocity of the child's origin relative to the coincident point of the parent).
    pub(super) fn linear(&self, n: &Vector3<f64>) -> Row {
        let (parent, child) = (self.joint.parent().index(), self.joint.child().index());
        velocity_row(child, &self.arm_child, n).add_scaled(-1.0, &velocity_row(parent, &self.arm_parent, n))
    }

    /// Constraint rows of the joint, without lock and mimic. The rows of all joints together are independent.
    pub(super) fn constraints(&self) -> Vec<Row> {
        let world = WORLD.map(Vector3::from);
        let [e1, e2, axis] = &self.frame;
        let all_angular = || world.iter().map(|n| self.angular(n));
        let all_linear = || world.iter().map(|n| self.linear(n));
        let no_tilt = || [e1, e2].map(|n| self.angular(n));
        match self.joint.kind() {
            JointKind::Fixed => all_angular().chain(all_linear()).collect(),
            JointKind::Revolute | JointKind::Continuous => all_linear().chain(no_tilt()).collect(),
            JointKind::Prismatic => all_angular().chain([e1, e2].map(|n| self.linear(n))).collect(),
            JointKind::Planar => no_tilt().into_iter().chain([self.linear(axis)]).collect(),
            JointKind::Spherical => all_linear().collect(),
            JointKind::Floating => Vec::new(),
        }
    }

    /// Rows of the joint velocities, in the order of [`JointKind`]'s table.
    pub(super) fn rates(&self) -> Vec<Row> {
        let [e1, e2, axis] = &self.frame;
        let child_angular = || self.child_axes.iter().map(|n| self.angular(n));
        match self.joint.kind() {
            JointKind::Fixed => Vec::new(),
            JointKind::Revolute | JointKind::Continuous => vec![self.angular(axis)],
            JointKind::Prismatic => vec![self.linear(axis)],
            JointKind::Planar => vec![self.linear(e1), self.linear(e2), self.angular(axis)],
            JointKind::Spherical => child_angular().collect(),
            JointKind::Floating => {
                child_angular().chain(self.child_axes.iter().map(|n| self.linear(n))).collect()
            }
        }
    }
}
