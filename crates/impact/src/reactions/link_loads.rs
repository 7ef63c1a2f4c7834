//! Wrenches transmitted by the joints of the tree: one sweep over the links, from the tips to the root.

use crate::motion::joint_rates::JointRates;
use nalgebra::Vector3;
use percuss_dynamics::{ContactResponse, LocatedContact, Pose};
use percuss_mechanism::{JointId, LinkId};
use percuss_spatial::{Transform, Twist, Wrench};

/// Wrenches on the links for given changes of the joint velocities.
pub(crate) struct LinkLoads {
    /// For each link: impulse of its parent joint (of the ground, for the root) on the link and its subtree, in the
    /// link's axes at its origin, without the constraints of loops and holds.
    pub transmitted: Vec<Wrench<f64>>,
    /// X_rl of each link.
    pub frames: Vec<Transform<f64>>,
}

impl LinkLoads {
    /// Wrenches for a change of the joint velocities and of the twist of the root (root axes, root origin), and a unit
    /// impulse at the contact: −n̂ on the contact link, n̂ on the other link.
    pub fn new(
        pose: &Pose,
        response: &ContactResponse,
        joint_changes: &[Vec<f64>],
        base_change: Twist<f64>,
    ) -> Self {
        let mechanism = pose.mechanism();
        let frames: Vec<Transform<f64>> = mechanism.link_ids().map(|l| pose.link_in_root(l)).collect();
        let steps: Vec<Transform<f64>> = mechanism.joint_ids().map(|j| pose.joint_transform(j)).collect();
        let mut twists = vec![Twist::zero(); frames.len()];
        let mut transmitted = vec![Wrench::zero(); frames.len()];
        for &link in mechanism.order() {
            let i = link.index();
            twists[i] = match mechanism.parent_joint(link) {
                None => base_change,
                Some(joint) => {
                    let parent = mechanism.joint(joint).parent();
                    let follows = steps[joint.index()].inverse_twist(&twists[parent.index()]);
                    let columns = pose.motion_subspace(joint);
                    let rates = &joint_changes[joint.index()];
                    columns.iter().zip(rates).fold(follows, |sum, (column, rate)| sum + *column * *rate)
                }
            };
            transmitted[i] = mechanism.link(link).inertia().momentum(&twists[i]);
        }
        Self { transmitted, frames }.with_contact(pose, &response.contact, 1.0, &steps)
    }

    /// Wrenches (N, N·m) of a motion with the rates `rates`, the accelerations `accelerations`, the gravity `gravity` (m/s², root
    /// axes) and the force `force` at the contact: −F n̂ on the contact link, F n̂ on the other link.
    ///
    /// a_i = X a_p + S q̈ + Ṡ q̇ + V × S q̇, f_i = I a + V ×* I V, with a = −g for the ground. Featherstone 2008, table 5.1.
    pub fn of_motion(
        pose: &Pose,
        contact: &LocatedContact,
        force: f64,
        rates: &JointRates,
        accelerations: &JointRates,
        gravity: &Vector3<f64>,
    ) -> Self {
        let mechanism = pose.mechanism();
        let frames: Vec<Transform<f64>> = mechanism.link_ids().map(|l| pose.link_in_root(l)).collect();
        let steps: Vec<Transform<f64>> = mechanism.joint_ids().map(|j| pose.joint_transform(j)).collect();
        let mut motions = vec![(Twist::zero(), Twist::zero()); frames.len()];
        let mut transmitted = vec![Wrench::zero(); frames.len()];
        for &link in mechanism.order() {
            let i = link.index();
            motions[i] = match mechanism.parent_joint(link) {
                None => (rates.base, accelerations.base - Twist::new(Vector3::zeros(), *gravity)),
                Some(joint) => {
                    let (v, a) = motions[mechanism.joint(joint).parent().index()];
                    let (step, own_rates) = (&steps[joint.index()], &rates.joints[joint.index()]);
                    let columns = pose.motion_subspace(joint);
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
            let inertia = mechanism.link(link).inertia();
            transmitted[i] = inertia.momentum(a) + v.cross_force(&inertia.momentum(v));
        }
        Self { transmitted, frames }.with_contact(pose, contact, force, &steps)
    }

    /// Adds the contact and sums the wrenches over the subtrees.
    fn with_contact(
        mut self,
        pose: &Pose,
        contact: &LocatedContact,
        force: f64,
        steps: &[Transform<f64>],
    ) -> Self {
        let mechanism = pose.mechanism();
        let on = contact.link.index();
        self.transmitted[on] += Wrench::of_force(contact.normal_link * force, &contact.point_link);
        if let Some(against) = contact.against {
            let (own, other) = (&self.frames[on], &self.frames[against.index()]);
            let point = other.inverse_point(&own.point(&contact.point_link));
            let normal = other.inverse_vector(&own.vector(&contact.normal_link));
            self.transmitted[against.index()] -= Wrench::of_force(normal * force, &point);
        }
        for &link in mechanism.order().iter().rev() {
            if let Some(joint) = mechanism.parent_joint(link) {
                let parent = mechanism.joint(joint).parent().index();
                let in_parent = steps[joint.index()].wrench(&self.transmitted[link.index()]);
                self.transmitted[parent] += in_parent;
            }
        }
        self
    }

    /// Converts a wrench (root axes, about `point` in the root frame) to the axes and the origin of a link.
    pub fn in_link(&self, link: LinkId, wrench: &Wrench<f64>, point: &Vector3<f64>) -> Wrench<f64> {
        let frame = &self.frames[link.index()];
        let (arm, force) = (frame.inverse_point(point), frame.inverse_vector(&wrench.force));
        Wrench::new(frame.inverse_vector(&wrench.moment) + arm.cross(&force), force)
    }
}

/// Links from `link` to the root, including both; empty for the ground.
pub(crate) fn path_to_root(pose: &Pose, link: Option<LinkId>) -> Vec<LinkId> {
    let mechanism = pose.mechanism();
    let parent = |link: &LinkId| mechanism.parent_joint(*link).map(|j: JointId| mechanism.joint(j).parent());
    std::iter::successors(link, parent).collect()
}
