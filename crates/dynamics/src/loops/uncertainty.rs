//! How far a pose may be from closed, and what that does to an answer: a residual alone bounds nothing near a singular
//! pose.

use super::Group;
use crate::kinematics::Kinematics;
use crate::{Pose, System};
use faer::Mat;

impl System {
    /// The pose moved by what its residuals leave open, one way and the other; none for a tree.
    ///
    /// Each group's followers go where the residuals send them, and along the right singular vector of their Jacobian with
    /// the least singular value σ that counts by ρ/σ: ρ the rounding of the residuals, or all of them where the file is
    /// inexact and least squares leave them.
    pub(crate) fn doubtful_poses(&self, pose: &Pose) -> Option<[Kinematics<f64>; 2]> {
        let poser = self.unlocked.as_deref().unwrap_or(self);
        let state = pose.loops.as_ref()?;
        let mut u = vec![0.0; poser.coordinates];
        for (group, following) in poser.groups.iter().zip(&state.following) {
            poser.doubt(&pose.kinematics, group, following, state.inexactness > 0.0, &mut u);
        }
        Some([1.0, -1.0].map(|sign| {
            let mut moved = pose.kinematics.clone();
            let u: Vec<f64> = u.iter().map(|u| sign * u).collect();
            poser.advance(&mut moved, &u);
            moved
        }))
    }

    fn doubt(
        &self,
        kinematics: &Kinematics<f64>,
        group: &Group,
        following: &[usize],
        inexact: bool,
        u: &mut [f64],
    ) {
        let (residuals, rows) = self.group_rows(kinematics, group);
        let lengths = &group.lengths;
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
        let length = self.mechanism.characteristic_length();
        let size = residuals.iter().map(|r| r * r).sum::<f64>().sqrt();
        let rounding = 8.0 * f64::EPSILON * length;
        let open = if inexact { size.max(rounding) } else { rounding };
        let mut step = vec![0.0; count];
        for (i, step) in step.iter_mut().enumerate() {
            let along: f64 = residuals.iter().enumerate().map(|(r, x)| svd.U()[(r, i)] * x).sum();
            *step = -along / values[i];
        }
        step[count - 1] += (open / values[count - 1]).copysign(step[count - 1]);
        // No pose is in doubt by more than a radian.
        let far = step.iter().map(|x| x * x).sum::<f64>().sqrt();
        let shorten = (length / far).min(1.0);
        for (k, &at) in following.iter().enumerate() {
            let moved: f64 = (0..count).map(|i| svd.V()[(k, i)] * step[i]).sum();
            u[group.coordinates[at]] += shorten * moved / lengths[at];
        }
    }
}
