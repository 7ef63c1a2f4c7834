//! How far a pose may be from closed, and what that does to an answer: a residual alone bounds nothing near a singular
//! pose.

use super::Group;
use crate::kinematics::Kinematics;
use crate::{Pose, System};
use faer::Mat;

impl System {
    /// The pose moved by what its residuals leave open, one way and the other; none for a tree.
    ///
    /// Each group's followers move along the right singular vector of their Jacobian with the least singular value σ
    /// that counts, by ρ/σ with ρ the residual (at least its rounding).
    pub(crate) fn doubtful_poses(&self, pose: &Pose) -> Option<[Kinematics<f64>; 2]> {
        let poser = self.unlocked.as_deref().unwrap_or(self);
        let state = pose.loops.as_ref()?;
        let mut u = vec![0.0; poser.coordinates];
        for (group, following) in poser.groups.iter().zip(&state.following) {
            poser.doubt(&pose.kinematics, group, following, &mut u);
        }
        Some([1.0, -1.0].map(|sign| {
            let mut moved = pose.kinematics.clone();
            let u: Vec<f64> = u.iter().map(|u| sign * u).collect();
            poser.advance(&mut moved, &u);
            moved
        }))
    }

    fn doubt(&self, kinematics: &Kinematics<f64>, group: &Group, following: &[usize], u: &mut [f64]) {
        let (residuals, rows) = self.group_rows(kinematics, group);
        let lengths = self.lengths_of(group);
        let jacobian = Mat::from_fn(rows.nrows(), following.len(), |r, k| {
            rows[(r, following[k])] / lengths[following[k]]
        });
        if following.is_empty() || jacobian.norm_max() == 0.0 {
            return;
        }
        let Ok(svd) = jacobian.thin_svd() else { return };
        let values = svd.S().column_vector();
        let count = (0..values.nrows()).take_while(|&i| values[i] > 1e-13 * values[0]).count();
        if count == 0 {
            return;
        }
        let rounding = 8.0 * f64::EPSILON * self.mechanism.characteristic_length();
        let size = residuals.iter().map(|r| r * r).sum::<f64>().sqrt().max(rounding);
        // No pose is in doubt by more than a radian.
        let reach = (size / values[count - 1]).min(self.mechanism.characteristic_length());
        for (k, &at) in following.iter().enumerate() {
            u[group.coordinates[at]] += reach * svd.V()[(k, count - 1)] / lengths[at];
        }
    }
}
