//! Poses after a small step in time or along the contact: after joint velocities, or v*, have acted.

use crate::analysis::pose::Pose;
use crate::analysis::response::ContactResponse;
use crate::kinematics::frames::Kinematics;
use crate::loops::closing::{Directions, Linearised};
use crate::model::Group;
use crate::model::tangent;
use crate::model::velocities::{StateSizeError, check_velocities};
use crate::tolerances::{ADVANCE_CORRECTIONS, ADVANCE_STEP, MOST_CLOSING};
use nalgebra::Vector3;
use percuss_mechanism::JointKind;
use percuss_spatial::{Transform, Twist, rotation_from_quaternion};

impl Pose {
    /// Pose after a short time `h` (s) at joint velocities `velocities` and base twist `base` (root axes, at the root
    /// origin), to second order in `h`. Quaternions are normalised. Loops are not closed again; the residual of the
    /// new pose is the resulting gap.
    ///
    /// # Errors
    /// [`StateSizeError`]: velocities that do not fit the mechanism.
    pub fn advanced(
        &self,
        velocities: &[Vec<f64>],
        base: &Twist<f64>,
        h: f64,
    ) -> Result<Pose, StateSizeError> {
        let model = self.assembly.pose_model();
        check_velocities(&model.mechanism, velocities)?;
        let mut kinematics = Kinematics::new(model);
        for ((joint, range), v) in model.mechanism.joints().iter().zip(&model.joint_q).zip(velocities) {
            let next = tangent::advanced(joint.kind(), &self.kinematics.q[range.clone()], v, h);
            kinematics.q[range.clone()].copy_from_slice(&next);
        }
        kinematics.refill(model);
        let (w, v) = (base.angular, base.linear);
        let zero = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0];
        let q = tangent::advanced(JointKind::Floating, &zero, &[w.x, w.y, w.z, v.x, v.y, v.z], h);
        let step = Transform::new(
            rotation_from_quaternion([q[3], q[4], q[5], q[6]]),
            Vector3::new(q[0], q[1], q[2]),
        );
        let mut loops = self.loops.clone();
        if let Some(state) = &mut loops {
            let residual = |group| model.group_residual(&kinematics, group).0;
            state.residual = model.groups.iter().map(residual).fold(0.0, f64::max);
        }
        Ok(self.assembly.pose_at(kinematics, self.base * step, loops, self))
    }

    /// Pose after a motion along v* until the gap has closed by `distance` (m; negative: opened).
    ///
    /// Every joint moves at its rate of the response. Then the loops are closed by the shortest motion. The result is
    /// exact to second order in the distance. `None` if the loops do not close, or v* is zero.
    pub fn advanced_along(&self, response: &ContactResponse, distance: f64) -> Option<Pose> {
        if !response.mechanism_moves() {
            return None;
        }
        let mut pose = self.advanced(&response.joint_velocities, &response.base_velocity, distance).ok()?;
        let model = self.assembly.pose_model();
        for (number, group) in model.groups.iter().enumerate() {
            let tolerance = self.assembly.tolerance(&pose.kinematics, number);
            if !close_after_advance(&mut pose.kinematics, self, group, tolerance, distance.abs()) {
                return None;
            }
        }
        let mut kinematics = pose.kinematics;
        kinematics.refill(model);
        Some(self.assembly.pose_at(kinematics, pose.base, pose.loops, self))
    }
}

/// Closes a group by plain Gauss–Newton steps of least norm. Contradictions of a rounded file are not corrected,
/// because the damped steps of `Model::correct` would follow them.
fn close_after_advance(
    kinematics: &mut Kinematics,
    from: &Pose,
    group: &Group,
    tolerance: f64,
    distance: f64,
) -> bool {
    let model = from.assembly.pose_model();
    let all = Directions::of(&group.movable);
    let floor = tolerance / group.size;
    let mut moved = 0.0;
    for _ in 0..ADVANCE_CORRECTIONS {
        let x = Linearised::at(model, kinematics, group).step(group, all, floor);
        let length = x.iter().map(|x| x * x).sum::<f64>().sqrt();
        moved += length;
        if moved.is_nan() || moved > MOST_CLOSING * distance {
            return false;
        }
        model.advance_group(kinematics, group, &all.expand(group, |k| x[k]));
        if length <= ADVANCE_STEP * distance {
            break;
        }
    }
    model.group_residual(kinematics, group).0 <= tolerance
}
