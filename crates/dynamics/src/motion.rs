//! What the strike does elsewhere: the speed of any point at unit closing speed, and the classical estimate.

use crate::{EffectiveMass, Pose, Strike, System};
use nalgebra::Vector3;
use percuss_mechanism::LinkId;

/// The velocity of a point while the gap closes at unit speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PointVelocity {
    /// Root link's axes, relative to the contact's other side, per unit closing speed.
    Known(Vector3<f64>),
    /// A motion that carries no mass leaves it open.
    Undetermined,
}

/// Relative size below which a massless motion does not move a point.
const UNMOVED: f64 = 1e-9;

impl System {
    /// Velocity of a point (m, link's frame) of a link in the strike, relative to the contact's other side, in the root
    /// link's axes: its length is the motion ratio |v_A|/v_n. None where the strike has no motion.
    pub fn point_velocity(
        &self,
        pose: &Pose,
        strike: &Strike,
        link: LinkId,
        point: &Vector3<f64>,
    ) -> Option<PointVelocity> {
        self.velocity_against(pose, strike, link, point, strike.contact.against)
    }

    /// The same relative to the ground, whatever the other side is.
    pub fn point_velocity_over_ground(
        &self,
        pose: &Pose,
        strike: &Strike,
        link: LinkId,
        point: &Vector3<f64>,
    ) -> Option<PointVelocity> {
        self.velocity_against(pose, strike, link, point, None)
    }

    fn velocity_against(
        &self,
        pose: &Pose,
        strike: &Strike,
        link: LinkId,
        point: &Vector3<f64>,
        against: Option<LinkId>,
    ) -> Option<PointVelocity> {
        let EffectiveMass::Finite(_) = strike.effective_mass else { return None };
        let at = pose.kinematics.link_frame(self, link).point(point);
        let mut columns = vec![Vector3::zeros(); self.follows.len()];
        let on = self.seats[link.index()].body;
        let against = against.and_then(|l| self.seats[l.index()].body);
        self.for_each_relative_twist(&pose.kinematics, on, against, &at, |v, twist| {
            columns[v] = twist.linear
        });
        let velocity = |tree: &[f64]| columns.iter().zip(tree).map(|(c, v)| c * *v).sum::<Vector3<f64>>();
        for motion in &strike.free_motions {
            let tree = self.expand(motion);
            let size: f64 = columns.iter().zip(&tree).map(|(c, v)| c.norm() * v.abs()).sum();
            let scale: f64 = tree.iter().map(|v| v.abs()).fold(0.0, f64::max);
            let length = self.mechanism.characteristic_length();
            if velocity(&tree).norm() > UNMOVED * size.max(1e-3 * scale * length.min(1.0)) {
                return Some(PointVelocity::Undetermined);
            }
        }
        Some(PointVelocity::Known(velocity(&self.tree_velocities(strike))))
    }

    /// v* over the velocities of the tree.
    fn tree_velocities(&self, strike: &Strike) -> Vec<f64> {
        let mut tree = vec![0.0; self.follows.len()];
        for body in self.bodies.iter().filter(|b| !b.v.is_empty()) {
            match body.joint {
                Some(id) => tree[body.v.clone()].copy_from_slice(&strike.joint_velocities[id.index()]),
                None => {
                    let base = &strike.base_velocity;
                    tree[body.v.start..body.v.start + 3].copy_from_slice(base.angular.as_slice());
                    tree[body.v.start + 3..body.v.end].copy_from_slice(base.linear.as_slice());
                }
            }
        }
        tree
    }
}
