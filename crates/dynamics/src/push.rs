//! A little further into the contact: the pose once the strike's own motion has closed the gap by some distance.

use crate::loops::closing::Moves;
use crate::{Pose, Strike, System};

/// Loops of a rounded file close to within this many times their inexactness at other poses.
const ROUNDED: f64 = 10.0;

impl System {
    /// The pose after the mechanism has gone along v* until the gap has closed by `distance` (m; negative: opened).
    ///
    /// Every joint goes at its rate of the strike, then the loops are closed by the shortest way: exact to second
    /// order in the distance. None where they do not close there, or where nothing moves.
    pub fn pushed(&self, pose: &Pose, strike: &Strike, distance: f64) -> Option<Pose> {
        if strike.joint_velocities.iter().flatten().all(|v| *v == 0.0)
            && strike.base_velocity.linear.norm() == 0.0
        {
            return None;
        }
        let mut pushed = self.advanced(pose, &strike.joint_velocities, &strike.base_velocity, distance);
        for group in &self.groups {
            let inexactness = pose.loops().map_or(0.0, |loops| loops.inexactness);
            let tolerance = self.closing_tolerance(&pushed.kinematics).max(ROUNDED * inexactness);
            let all = Moves { unknown: &group.movable, course: None };
            let correction = self.correct(&mut pushed.kinematics, group, all, tolerance);
            if !correction.closed || correction.moved > distance.abs() {
                return None;
            }
        }
        pushed.kinematics.refill(self);
        Some(pushed)
    }
}
