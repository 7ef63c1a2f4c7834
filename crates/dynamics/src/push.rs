//! A little further into the contact: the pose once the strike's own motion has closed the gap by some distance.

use crate::kinematics::Kinematics;
use crate::loops::Group;
use crate::loops::closing::{Moves, shortest};
use crate::{Pose, Strike, System};
use faer::Mat;

/// Most steps that close a group again.
const STEPS: usize = 8;

impl System {
    /// The pose after the mechanism has gone along v* until the gap has closed by `distance` (m; negative: opened).
    ///
    /// Every joint goes at its rate of the strike, then the loops are closed by the shortest way: exact to second
    /// order in the distance. None where they do not close there, or where nothing moves.
    pub fn pushed(&self, pose: &Pose, strike: &Strike, distance: f64) -> Option<Pose> {
        if !strike.gives_way() {
            return None;
        }
        let mut pushed = self.advanced(pose, &strike.joint_velocities, &strike.base_velocity, distance);
        for group in &self.groups {
            let inexactness = pose.loops().map_or(0.0, |loops| loops.inexactness);
            let tolerance = self.rounded_tolerance(&pushed.kinematics, inexactness);
            if !self.closed_again(&mut pushed.kinematics, group, tolerance, distance.abs()) {
                return None;
            }
        }
        pushed.kinematics.refill(self);
        Some(pushed)
    }

    /// Closes a group by plain Gauss–Newton steps of least norm, as long as they help. What contradicts itself in a rounded
    /// file is left as it is: the damped steps that settle a group would follow it.
    fn closed_again(
        &self,
        kinematics: &mut Kinematics<f64>,
        group: &Group,
        tolerance: f64,
        distance: f64,
    ) -> bool {
        let all = Moves { unknown: &group.movable, course: None };
        let floor = tolerance / self.mechanism.characteristic_length();
        let mut moved = 0.0;
        for _ in 0..STEPS {
            let (residuals, rows) = self.group_rows(kinematics, group);
            let target = Mat::from_fn(residuals.len(), 1, |r, _| -residuals[r]);
            let x = shortest(&all.jacobian(group, &rows), &target, floor);
            moved += x.norm_l2();
            if moved.is_nan() || moved > distance {
                return false;
            }
            self.advance_group(kinematics, group, &all.expand(group, |k| x[(k, 0)]));
            if x.norm_l2() <= 1e-9 * distance {
                break;
            }
        }
        self.group_residual(kinematics, group).0 <= tolerance
    }
}
