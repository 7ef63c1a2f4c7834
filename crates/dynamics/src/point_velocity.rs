//! What the contact response does elsewhere: the velocity of any point at unit closing speed.

use crate::input::foreign_link;
use crate::outcome::{EffectiveMass, Remark};
use crate::pose::Pose;
use crate::recursion::{Deciding, Recursion};
use crate::response::ContactResponse;
use nalgebra::Vector3;
use percuss_mechanism::LinkId;
use percuss_spatial::Wrench;

/// The velocity of a point while the gap closes at unit speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PointVelocity {
    /// Root link's axes, relative to the contact's other side, per unit closing speed.
    Known(Vector3<f64>),
    /// A motion without mass leaves it open.
    Undetermined,
}

impl Pose {
    /// Velocity of a point (m, link's frame) of a link in the response, relative to the contact's other side, in the root
    /// link's axes: its length is the motion ratio |v_A|/v_n. None where the response has no motion, and for a link of
    /// another mechanism.
    pub fn point_velocity(
        &self,
        response: &ContactResponse,
        link: LinkId,
        point: &Vector3<f64>,
    ) -> Option<PointVelocity> {
        self.velocity_against(response, link, point, response.contact.against)
    }

    /// The same relative to the ground, whatever the other side is.
    pub fn point_velocity_over_ground(
        &self,
        response: &ContactResponse,
        link: LinkId,
        point: &Vector3<f64>,
    ) -> Option<PointVelocity> {
        self.velocity_against(response, link, point, None)
    }

    fn velocity_against(
        &self,
        response: &ContactResponse,
        link: LinkId,
        point: &Vector3<f64>,
        against: Option<LinkId>,
    ) -> Option<PointVelocity> {
        let EffectiveMass::Finite(_) = response.effective_mass else { return None };
        let model = self.assembly.model();
        if foreign_link(&model.mechanism, [Some(link), against].into_iter().flatten()).is_some() {
            return None;
        }
        let at = self.kinematics.link_frame(model, link).point(point);
        let mut columns = vec![Vector3::zeros(); model.follows.len()];
        let against = against.and_then(|link| model.body_of(link));
        model.for_each_support(model.body_of(link), against, |i, sign| {
            for (k, v) in model.bodies[i].v.clone().enumerate() {
                columns[v] = self.kinematics.column_at(model, i, k, &at).linear * sign;
            }
        });
        let velocity = |tree: &[f64]| columns.iter().zip(tree).map(|(c, v)| c * *v).sum::<Vector3<f64>>();
        if response.remarks.contains(&Remark::UndeterminedMotion) && self.is_open(link, against, &at) {
            return Some(PointVelocity::Undetermined);
        }
        Some(PointVelocity::Known(velocity(&self.tree_velocities(response))))
    }

    /// Whether a motion without mass moves a point (root frame) of a link against a body: whether it answers a test force
    /// there.
    fn is_open(&self, link: LinkId, against: Option<usize>, at: &Vector3<f64>) -> bool {
        let model = self.assembly.model();
        // An answer of another pose may come here: nothing is known.
        if model.refuse_large_clusters::<f64>(&self.groups).is_err() {
            return true;
        }
        let mut recursion = Recursion::<f64, 3>::new(model);
        let mut deciding = Deciding::<3>::new(model);
        for axis in 0..3 {
            let mut force = Vector3::zeros();
            force[axis] = 1.0;
            recursion.add_wrench(model.body_of(link), axis, Wrench::new(Vector3::zeros(), force));
            recursion.add_wrench(against, axis, Wrench::new(Vector3::zeros(), -force));
        }
        recursion.eliminate(model, &self.kinematics, &self.groups, at, &mut deciding);
        deciding.massless.contains(&true)
    }

    /// v* over the velocities of the tree.
    fn tree_velocities(&self, response: &ContactResponse) -> Vec<f64> {
        let mut tree = vec![0.0; self.assembly.model().follows.len()];
        for body in self.assembly.model().bodies.iter().filter(|b| !b.v.is_empty()) {
            match body.joint {
                Some(id) => tree[body.v.clone()].copy_from_slice(&response.joint_velocities[id.index()]),
                None => {
                    let base = &response.base_velocity;
                    tree[body.v.start..body.v.start + 3].copy_from_slice(base.angular.as_slice());
                    tree[body.v.start + 3..body.v.end].copy_from_slice(base.linear.as_slice());
                }
            }
        }
        tree
    }
}
