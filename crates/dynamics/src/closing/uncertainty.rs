//! How far a pose may be from closed: a residual alone bounds nothing near a singular pose.

use super::correct::{Directions, Linearised, norm};
use crate::kinematics::Kinematics;
use crate::linear::dense::{cholesky, cholesky_solve};
use crate::linear::jacobian::Jacobian;
use crate::model::{Group, Model};
use crate::tolerances::{FAINT_SINGULAR_VALUE, INVERSE_ITERATIONS, REGULAR_SQUARE, WEAKEST_DIRECTION_LIMIT};

impl Model {
    /// Rates over the group's coordinates by which its pose may be from closed.
    ///
    /// The dependent coordinates go where the residuals send them, and along the right singular vector of their Jacobian
    /// with the least singular value σ that counts by ρ/σ: ρ the rounding of the residuals, or all of them where the file
    /// is inexact and least squares leave them.
    pub fn closing_doubt(
        &self,
        kinematics: &Kinematics<f64>,
        group: &Group,
        dependent: &[usize],
        inexactness: f64,
    ) -> Vec<f64> {
        let here = Linearised::at(self, kinematics, group);
        let directions = Directions::of(dependent);
        let jacobian = directions.jacobian(group, &here.rows);
        if dependent.is_empty() || jacobian.entries.iter().all(|(.., a)| *a == 0.0) {
            return vec![0.0; group.coordinates.len()];
        }
        let target: Vec<f64> = here.residuals.iter().map(|r| -r).collect();
        let far = group.bodies.iter().map(|b| kinematics.frames[*b].translation.amax()).fold(0.0, f64::max);
        let rounding = 8.0 * f64::EPSILON * group.size.max(far);
        let size = target.iter().map(|r| r * r).sum::<f64>().sqrt();
        let open = if inexactness > 0.0 { size.max(rounding) } else { rounding };
        let floor = if inexactness > 0.0 { group.floor_for(inexactness) } else { FAINT_SINGULAR_VALUE };
        let small = dependent.len() <= WEAKEST_DIRECTION_LIMIT;
        let regular = (small && inexactness == 0.0).then(|| regular_step(&jacobian, &target, open)).flatten();
        let mut step = match regular {
            Some(step) => step,
            None if small => weak_step(&jacobian.dense(), &target, open, floor),
            None => jacobian.shortest(&target, FAINT_SINGULAR_VALUE),
        };
        // No pose is uncertain by more than a radian.
        let long = step.iter().map(|x| x * x).sum::<f64>().sqrt();
        let shorten = if long > group.size { group.size / long } else { 1.0 };
        step.iter_mut().for_each(|x| *x *= shorten);
        directions.expand(group, |k| step[k])
    }
}

/// The step that closes to first order, and `open` over the least singular value along its vector, where all are well
/// above the root of rounding: by JᵀJ and inverse iterations.
fn regular_step(jacobian: &Jacobian, target: &[f64], open: f64) -> Option<Vec<f64>> {
    let n = jacobian.columns;
    let mut dense = vec![0.0; jacobian.rows * n];
    jacobian.entries.iter().for_each(|(r, c, a)| dense[r * n + c] += a);
    let mut normal = vec![0.0; n * n];
    let mut step = vec![0.0; n];
    for (row, b) in dense.chunks_exact(n).zip(target) {
        for i in 0..n {
            step[i] += row[i] * b;
            for k in 0..=i {
                normal[i * n + k] += row[i] * row[k];
            }
        }
    }
    if !cholesky(&mut normal, n, REGULAR_SQUARE) {
        return None;
    }
    cholesky_solve(&normal, &mut step);
    // A vector with a part along every singular one; ‖(JᵀJ)⁻¹v‖ comes to 1/σ².
    let mut weakest: Vec<f64> = (0..n).map(|k| 1.0 + 0.1 * k as f64).collect();
    let mut growth = norm(&weakest);
    for _ in 0..INVERSE_ITERATIONS {
        weakest.iter_mut().for_each(|x| *x /= growth);
        cholesky_solve(&normal, &mut weakest);
        growth = norm(&weakest);
    }
    let along: f64 = step.iter().zip(&weakest).map(|(s, w)| s * w).sum();
    let size = (open / growth.sqrt()).copysign(along);
    step.iter_mut().zip(&weakest).for_each(|(s, w)| *s += size * w);
    Some(step)
}

/// The step that closes to first order, and `open` over the least singular value that counts along its vector.
fn weak_step(jacobian: &faer::Mat<f64>, target: &[f64], open: f64, floor: f64) -> Vec<f64> {
    let n = jacobian.ncols();
    let Ok(svd) = jacobian.thin_svd() else { return vec![0.0; n] };
    let values = svd.S().column_vector();
    let count = (0..values.nrows()).take_while(|&i| values[i] > floor * values[0]).count();
    let mut step = vec![0.0; count];
    for (i, step) in step.iter_mut().enumerate() {
        let along: f64 = target.iter().enumerate().map(|(r, x)| svd.U()[(r, i)] * x).sum();
        *step = along / values[i];
    }
    if let Some(last) = step.last_mut() {
        *last += (open / values[count - 1]).copysign(*last);
    }
    (0..n).map(|k| (0..count).map(|i| svd.V()[(k, i)] * step[i]).sum()).collect()
}
