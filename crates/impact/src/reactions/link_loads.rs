//! Wrenches transmitted by the joints of the tree: one sweep over the links, from the tips to the root.

use nalgebra::Vector3;
use percuss_dynamics::{ContactResponse, Pose};
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
        let contact = &response.contact;
        let on = contact.link.index();
        transmitted[on] += Wrench::of_force(contact.normal_link, &contact.point_link);
        if let Some(against) = contact.against {
            let (own, other) = (&frames[on], &frames[against.index()]);
            let point = other.inverse_point(&own.point(&contact.point_link));
            let normal = other.inverse_vector(&own.vector(&contact.normal_link));
            transmitted[against.index()] -= Wrench::of_force(normal, &point);
        }
        for &link in mechanism.order().iter().rev() {
            if let Some(joint) = mechanism.parent_joint(link) {
                let parent = mechanism.joint(joint).parent().index();
                let in_parent = steps[joint.index()].wrench(&transmitted[link.index()]);
                transmitted[parent] += in_parent;
            }
        }
        Self { transmitted, frames }
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
