//! Velocity of any point of the mechanism at unit closing speed of a contact.

use crate::analysis::pose::Pose;
use crate::analysis::response::ContactResponse;
use crate::kinematics::outcome::{EffectiveMass, Remark};
use crate::model::input::foreign_link;
use crate::recursion::{Pivoting, Recursion};
use nalgebra::Vector3;
use percuss_mechanism::LinkId;
use percuss_spatial::Wrench;

/// Velocity of a point at unit closing speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PointVelocity {
    /// Velocity in root axes, relative to the other side of the contact, per unit closing speed.
    Known(Vector3<f64>),
    /// Not determined, because of a motion without mass.
    Undetermined,
}

impl Pose {
    /// Velocity of a point (m, link frame) of a link in the response, relative to the other side of the contact, in
    /// root axes. Its length is the motion ratio |v_A|/v_n. `None` if m̄ of the response is not finite, and for a
    /// link of another mechanism.
    pub fn point_velocity(
        &self,
        response: &ContactResponse,
        link: LinkId,
        point: &Vector3<f64>,
    ) -> Option<PointVelocity> {
        self.point_velocity_against(response, link, point, response.contact.against)
    }

    /// Like [`point_velocity`](Self::point_velocity), relative to the ground.
    pub fn point_velocity_over_ground(
        &self,
        response: &ContactResponse,
        link: LinkId,
        point: &Vector3<f64>,
    ) -> Option<PointVelocity> {
        self.point_velocity_against(response, link, point, None)
    }

    /// Like [`point_velocity`](Self::point_velocity), relative to the link `against`, or to the ground if `None`.
    pub fn point_velocity_against(
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
        let mut columns = vec![Vector3::zeros(); model.velocity_coordinates.len()];
        let against = against.and_then(|link| model.body_of(link));
        model.for_each_support(model.body_of(link), against, |i, sign| {
            for (k, v) in model.bodies[i].v.clone().enumerate() {
                columns[v] = self.kinematics.column_at(model, i, k, &at).linear * sign;
            }
        });
        let velocity = |tree: &[f64]| columns.iter().zip(tree).map(|(c, v)| c * *v).sum::<Vector3<f64>>();
        if response.remarks.contains(&Remark::UndeterminedMotion)
            && self.has_massless_motion_at(link, against, &at)
        {
            return Some(PointVelocity::Undetermined);
        }
        Some(PointVelocity::Known(velocity(&self.tree_velocities(response))))
    }

    /// True if a motion without mass moves a point (root frame) of a link relative to a body: a test force at the
    /// point has a massless response.
    fn has_massless_motion_at(&self, link: LinkId, against: Option<usize>, at: &Vector3<f64>) -> bool {
        let model = self.assembly.model();
        // The response may belong to another pose; then nothing is known.
        if model.refuse_large_clusters(&self.groups).is_err() {
            return true;
        }
        let mut recursion = Recursion::<3>::new(model);
        let mut deciding = Pivoting::<3>::new(model);
        for axis in 0..3 {
            let mut force = Vector3::zeros();
            force[axis] = 1.0;
            recursion.add_wrench(model.body_of(link), axis, Wrench::new(Vector3::zeros(), force));
            recursion.add_wrench(against, axis, Wrench::new(Vector3::zeros(), -force));
        }
        recursion.eliminate(model, &self.kinematics, &self.groups, at, &mut deciding);
        deciding.massless.contains(&true)
    }

    /// Velocities of a contact response, over the tree velocities: those of the joints and of a floating base.
    pub(in crate::motion) fn tree_velocities(&self, response: &ContactResponse) -> Vec<f64> {
        let mut tree = vec![0.0; self.assembly.model().velocity_coordinates.len()];
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
