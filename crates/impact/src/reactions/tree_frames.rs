//! Wrenches transmitted by the joints of the tree: one sweep over the links, from the tips to the root.

use crate::motion::joint_rates::JointRates;
use nalgebra::Vector3;
use percuss_dynamics::{LocatedContact, Pose};
use percuss_mechanism::{JointId, LinkId, Mechanism};
use percuss_spatial::{Transform, Twist, Wrench};
use std::sync::Arc;

/// Frames and motion subspaces of the tree at a pose.
#[derive(Clone, Debug)]
pub(crate) struct TreeFrames {
    pub mechanism: Arc<Mechanism>,
    /// X_rl of each link.
    pub frames: Vec<Transform<f64>>,
    /// X_pc of each joint: child link in the parent link.
    steps: Vec<Transform<f64>>,
    /// Motion subspaces of all joints one after another, in the axes of the children.
    columns: Vec<Twist<f64>>,
    /// Index of the first column of each joint, and the number of all columns.
    first_column: Vec<usize>,
}

impl TreeFrames {
    pub fn new(pose: &Pose) -> Self {
        let mechanism = pose.mechanism();
        let mut columns = Vec::with_capacity(mechanism.joints().len() + 1);
        let mut first_column = Vec::with_capacity(mechanism.joints().len() + 1);
        for joint in mechanism.joint_ids() {
            first_column.push(columns.len());
            columns.extend(pose.motion_subspace(joint));
        }
        first_column.push(columns.len());
        Self {
            mechanism: Arc::clone(mechanism),
            frames: mechanism.link_ids().map(|l| pose.link_in_root(l)).collect(),
            steps: mechanism.joint_ids().map(|j| pose.joint_transform(j)).collect(),
            columns,
            first_column,
        }
    }

    /// Motion subspace of a joint, in the axes of the child.
    pub fn columns(&self, joint: JointId) -> &[Twist<f64>] {
        &self.columns[self.first_column(joint)..self.first_column[joint.index() + 1]]
    }

    /// Index of the first velocity of a joint among the velocities of all joints.
    pub fn first_column(&self, joint: JointId) -> usize {
        self.first_column[joint.index()]
    }

    /// Number of velocities of all joints.
    pub fn column_count(&self) -> usize {
        self.columns.len()
    }

    /// Wrench on each link from its parent joint (from the ground, for the root), in the link's axes at its origin, without the
    /// constraints of loops and holds: for the changes `factor` · `joints` of the joint velocities and `factor` · `base` of the twist
    /// of the root (root axes, root origin), and a unit impulse at the contact: −n̂ on the contact link, n̂ on the other link.
    pub fn impulse_loads(
        &self,
        contact: &LocatedContact,
        joints: &[Vec<f64>],
        base: Twist<f64>,
        factor: f64,
    ) -> Vec<Wrench<f64>> {
        let mut twists = vec![Twist::zero(); self.frames.len()];
        let mut loads = vec![Wrench::zero(); self.frames.len()];
        for &link in self.mechanism.order() {
            let i = link.index();
            twists[i] = match self.mechanism.parent_joint(link) {
                None => base * factor,
                Some(joint) => {
                    let parent = self.mechanism.joint(joint).parent();
                    let mut twist = self.steps[joint.index()].inverse_twist(&twists[parent.index()]);
                    for (column, rate) in self.columns(joint).iter().zip(&joints[joint.index()]) {
                        twist += *column * (factor * rate);
                    }
                    twist
                }
            };
            loads[i] = self.mechanism.link(link).inertia().momentum(&twists[i]);
        }
        self.add_contact(contact, 1.0, &mut loads);
        loads
    }

    /// Wrenches (N, N·m) as by [`impulse_loads`](Self::impulse_loads) of a motion with the rates `rates`, the accelerations
    /// `accelerations`, the gravity `gravity` (m/s², root axes) and the force `force` at the contact: −F n̂ on the contact link, F n̂ on
    /// the other link.
    ///
    /// a_i = X a_p + S q̈ + Ṡ q̇ + V × S q̇, f_i = I a + V ×* I V, with a = −g for the ground. Featherstone 2008, table 5.1.
    pub fn motion_loads(
        &self,
        pose: &Pose,
        contact: &LocatedContact,
        force: f64,
        rates: &JointRates,
        accelerations: &JointRates,
        gravity: &Vector3<f64>,
    ) -> Vec<Wrench<f64>> {
        let mut motions = vec![(Twist::zero(), Twist::zero()); self.frames.len()];
        let mut loads = vec![Wrench::zero(); self.frames.len()];
        for &link in self.mechanism.order() {
            let i = link.index();
            motions[i] = match self.mechanism.parent_joint(link) {
                None => (rates.base, accelerations.base - Twist::new(Vector3::zeros(), *gravity)),
                Some(joint) => {
                    let (v, a) = motions[self.mechanism.joint(joint).parent().index()];
                    let (step, own_rates) = (&self.steps[joint.index()], &rates.joints[joint.index()]);
                    let columns = self.columns(joint);
                    let sum = |values: &[f64]| {
                        columns.iter().zip(values).fold(Twist::zero(), |sum, (s, x)| sum + *s * *x)
                    };
                    let own = sum(own_rates);
                    let v = step.inverse_twist(&v) + own;
                    let bias = v.cross_motion(&own) + pose.motion_subspace_rate(joint, own_rates);
                    (v, step.inverse_twist(&a) + sum(&accelerations.joints[joint.index()]) + bias)
                }
            };
            let (v, a) = &motions[i];
            let inertia = self.mechanism.link(link).inertia();
            loads[i] = inertia.momentum(a) + v.cross_force(&inertia.momentum(v));
        }
        self.add_contact(contact, force, &mut loads);
        loads
    }

    /// Adds the contact and sums the wrenches over the subtrees.
    fn add_contact(&self, contact: &LocatedContact, force: f64, loads: &mut [Wrench<f64>]) {
        let on = contact.link.index();
        loads[on] += Wrench::of_force(contact.normal_link * force, &contact.point_link);
        if let Some(against) = contact.against {
            let (own, other) = (&self.frames[on], &self.frames[against.index()]);
            let point = other.inverse_point(&own.point(&contact.point_link));
            let normal = other.inverse_vector(&own.vector(&contact.normal_link));
            loads[against.index()] -= Wrench::of_force(normal * force, &point);
        }
        for &link in self.mechanism.order().iter().rev() {
            if let Some(joint) = self.mechanism.parent_joint(link) {
                let parent = self.mechanism.joint(joint).parent().index();
                let in_parent = self.steps[joint.index()].wrench(&loads[link.index()]);
                loads[parent] += in_parent;
            }
        }
    }

    /// Converts a wrench (root axes, about `point` in the root frame) to the axes and the origin of a link.
    pub fn in_link(&self, link: LinkId, wrench: &Wrench<f64>, point: &Vector3<f64>) -> Wrench<f64> {
        let frame = &self.frames[link.index()];
        let (arm, force) = (frame.inverse_point(point), frame.inverse_vector(&wrench.force));
        Wrench::new(frame.inverse_vector(&wrench.moment) + arm.cross(&force), force)
    }

    /// Links from `link` to the root, including both; empty for the ground.
    pub fn path_to_root(&self, link: Option<LinkId>) -> impl Iterator<Item = LinkId> {
        let parent = |link: &LinkId| {
            let joint = self.mechanism.parent_joint(*link);
            joint.map(|j| self.mechanism.joint(j).parent())
        };
        std::iter::successors(link, parent)
    }
}
