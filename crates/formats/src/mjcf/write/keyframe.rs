//! Pose and velocity of a mechanism as a keyframe.

use super::body_tree::{BodyTree, Coordinates};
use super::closures::{Half, half_of};
use super::error::MjcfError;
use crate::writing::state::MechanismState;
use crate::writing::xml_text::format_numbers;
use nalgebra::{Rotation3, UnitQuaternion};
use percuss_mechanism::JointKind;
use percuss_spatial::{Matrix3, Vector3, plane_basis};

/// Values of `qpos` and `qvel`.
#[derive(Debug, Default)]
pub(super) struct Keyframe {
    qpos: Vec<f64>,
    qvel: Vec<f64>,
}

impl Keyframe {
    /// Keyframe of a state. `coordinates`: joints of the file in the order of `qpos`.
    pub fn new(
        tree: &BodyTree<'_>,
        coordinates: &[Coordinates],
        state: &MechanismState,
    ) -> Result<Self, MjcfError> {
        let mut key = Self::default();
        for entry in coordinates {
            match entry {
                Coordinates::Joint { joint, in_body } => {
                    let kind = tree.mechanism.joint(*joint).kind();
                    let (q, v) = (&state.positions[joint.index()], &state.velocities[joint.index()]);
                    key.add_joint(kind, in_body, q, v);
                }
                Coordinates::Free(link) => {
                    let (pose, twist) = (&state.link_poses[link.index()], &state.link_twists[link.index()]);
                    let r = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(
                        pose.rotation,
                    ));
                    key.qpos.extend(pose.translation.iter().chain(&[r.w, r.i, r.j, r.k]));
                    key.qvel.extend(twist.linear.iter().chain(&pose.inverse_vector(&twist.angular)));
                }
                Coordinates::Half(number) => {
                    key.add_half(&half_of(tree, &tree.mechanism.closures()[*number])?, state);
                }
            }
        }
        Ok(key)
    }

    /// Adds the joints of MuJoCo for one joint. MuJoCo's angular velocities of balls have the axes of the body.
    fn add_joint(&mut self, kind: JointKind, in_body: &Matrix3<f64>, q: &[f64], v: &[f64]) {
        let turned = |x: &[f64]| in_body * Vector3::new(x[0], x[1], x[2]);
        match kind {
            JointKind::Fixed
            | JointKind::Revolute
            | JointKind::Continuous
            | JointKind::Prismatic
            | JointKind::Planar => {
                self.qpos.extend(q);
                self.qvel.extend(v);
            }
            JointKind::Spherical => {
                self.qpos.push(q[0]);
                self.qpos.extend(&turned(&q[1..]));
                self.qvel.extend(&turned(v));
            }
            JointKind::Floating => {
                let rotation =
                    UnitQuaternion::from_quaternion(nalgebra::Quaternion::new(q[3], q[4], q[5], q[6]));
                self.qpos.extend(&q[..4]);
                self.qpos.extend(&turned(&q[4..]));
                self.qvel.extend(&(rotation * Vector3::new(v[3], v[4], v[5])));
                self.qvel.extend(&turned(v));
            }
        }
    }

    /// Adds the joints of the second half of a link: slides first, then hinges about axes through the origin of the half.
    fn add_half(&mut self, half: &Half<'_>, state: &MechanismState) {
        let (base, own) = (state.frame(half.base), state.frame(half.own));
        // Motion from the half as drawn.
        let motion = (base * half.drawn).inverse() * own;
        let (base_turn, base_velocity) = state.velocity(half.base, &own.translation);
        let (own_turn, own_velocity) = state.velocity(half.own, &own.translation);
        // In the axes of the half as drawn, at the base's pose.
        let drawn = base * half.drawn;
        let velocity = drawn.inverse_vector(&(own_velocity - base_velocity));
        let turn = drawn.inverse_vector(&(own_turn - base_turn));
        for slide in half.joints.iter().filter(|joint| joint.slides) {
            self.qpos.push(slide.axis.dot(&motion.translation));
            self.qvel.push(slide.axis.dot(&velocity));
        }
        let axes: Vec<Vector3<f64>> =
            half.joints.iter().filter(|joint| !joint.slides).map(|joint| joint.axis).collect();
        match axes[..] {
            [axis] => {
                self.qpos.push(angle_about(&axis, &motion.rotation));
                self.qvel.push(axis.dot(&turn));
            }
            [first, second] => {
                // The rotation is R(first, q₁) R(second, q₂): only q₁ moves the second axis.
                let moved = motion.rotation * second;
                let across = |v: &Vector3<f64>| v - first * first.dot(v);
                let (from, to) = (across(&second), across(&moved));
                let angle = first.dot(&from.cross(&to)).atan2(from.dot(&to));
                let back = Rotation3::from_axis_angle(&nalgebra::Unit::new_normalize(first), -angle);
                self.qpos.extend([angle, angle_about(&second, &(back.matrix() * motion.rotation))]);
                let cosine = first.dot(&moved);
                let (along, along_moved) = (first.dot(&turn), moved.dot(&turn));
                let scale = 1.0 - cosine * cosine;
                self.qvel
                    .extend([(along - cosine * along_moved) / scale, (along_moved - cosine * along) / scale]);
            }
            _ => {}
        }
    }

    /// Element `<key>`.
    pub fn element(&self, name: &str) -> String {
        let [qpos, qvel] = [&self.qpos, &self.qvel].map(|values| format_numbers(values));
        format!("<key name=\"{name}\" qpos=\"{qpos}\" qvel=\"{qvel}\"/>")
    }
}

/// Angle of a rotation about a known axis, rad.
fn angle_about(axis: &Vector3<f64>, rotation: &Matrix3<f64>) -> f64 {
    let (e1, e2) = plane_basis(axis);
    let moved = rotation * e1;
    e2.dot(&moved).atan2(e1.dot(&moved))
}
