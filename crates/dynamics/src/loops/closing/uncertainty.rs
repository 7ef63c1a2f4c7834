//! Distance of a pose from a closed pose. Near a singular pose the residual alone gives no bound.

use super::correct::{Directions, norm};
use crate::kinematics::frames::Kinematics;
use crate::kinematics::rows::GroupRows;
use crate::linear::dense::{cholesky, cholesky_solve};
use crate::linear::jacobian::Jacobian;
use crate::model::{Group, Model};
use crate::tolerances::{FAINT_SINGULAR_VALUE, INVERSE_ITERATIONS, REGULAR_SQUARE, WEAKEST_DIRECTION_LIMIT};

impl Model {
    /// Rates over the group's coordinates that bound the distance of the pose from a closed pose.
    ///
    /// The dependent coordinates move by the first-order correction of the residuals. In addition they move by ρ/σ
    /// along the right singular vector of their Jacobian with the smallest nonzero singular value σ. ρ is the
    /// rounding of the residuals or, for an inexact file, the remaining least-squares residual. `known`: the group's
    /// rows at the pose, if available. `None` if the singular vector cannot be found.
    pub fn closing_uncertainty(
        &self,
        kinematics: &Kinematics,
        group: &Group,
        dependent: &[usize],
        inexactness: f64,
        known: Option<&GroupRows>,
    ) -> Option<Vec<f64>> {
        let residuals = self.group_residuals(kinematics, group);
        let mut own = GroupRows::default();
        let rows = known.unwrap_or_else(|| {
            own.fill(self, group, kinematics);
            &own
        });
        let directions = Directions::of(dependent);
        let jacobian = directions.jacobian(group, rows);
        if dependent.is_empty() || jacobian.entries.iter().all(|(.., a)| *a == 0.0) {
            return Some(vec![0.0; group.coordinates.len()]);
        }
        let target: Vec<f64> = residuals.iter().map(|r| -r).collect();
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
            None => sparse_weak_step(&jacobian, &target, open, floor)?,
        };
        // No pose is uncertain by more than one radian.
        let long = step.iter().map(|x| x * x).sum::<f64>().sqrt();
        let shorten = if long > group.size { group.size / long } else { 1.0 };
        step.iter_mut().for_each(|x| *x *= shorten);
        Some(directions.expand(group, |k| step[k]))
    }
}

/// Least-squares solution of J x = `target`, lengthened by `open`/σ along the right singular vector of the smallest
/// singular value σ: the step that an unknown residual of norm `open` could add at most. Method: Cholesky factor of
/// JᵀJ and inverse iteration. `None` unless all singular values are well above the square root of rounding.
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
    // Start vector with a component along every singular vector; ‖(JᵀJ)⁻¹v‖ converges to 1/σ².
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

/// Like [`weak_step`], for many coordinates: inverse iterations with sparse factors.
fn sparse_weak_step(jacobian: &Jacobian, target: &[f64], open: f64, floor: f64) -> Option<Vec<f64>> {
    let mut step = jacobian.shortest(target, floor);
    let (weakest, least) = sparse_weakest_direction(jacobian, floor)?;
    let along: f64 = step.iter().zip(&weakest).map(|(s, w)| s * w).sum();
    let size = (open / least).copysign(along);
    step.iter_mut().zip(&weakest).for_each(|(s, w)| *s += size * w);
    step.iter().all(|s| s.is_finite()).then_some(step)
}

/// Right singular vector of the smallest nonzero singular value, and the value, by repeated application of J⁺J⁺ᵀ.
fn sparse_weakest_direction(jacobian: &Jacobian, floor: f64) -> Option<(Vec<f64>, f64)> {
    let transposed = jacobian.transposed();
    let mut weakest: Vec<f64> = (0..jacobian.columns).map(|k| 1.0 + 0.1 * (k % 64) as f64).collect();
    let mut growth = norm(&weakest);
    for _ in 0..INVERSE_ITERATIONS {
        weakest.iter_mut().for_each(|x| *x /= growth);
        weakest = jacobian.shortest(&transposed.shortest(&weakest, floor), floor);
        growth = norm(&weakest);
        if !(growth.is_finite() && growth > 0.0) {
            return None;
        }
    }
    weakest.iter_mut().for_each(|x| *x /= growth);
    Some((weakest, 1.0 / growth.sqrt()))
}

/// First-order closing step plus `open`/σ along the singular vector of the smallest nonzero singular value σ.
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_weakest_direction_of_many_is_that_of_the_singular_values() {
        // A band matrix with one column almost equal to its neighbour, and some repeated rows.
        let (n, twice) = (90, 12);
        let entry = |r: usize, c: usize| match r.abs_diff(c) {
            0 => 2.0 + (r as f64).sin(),
            1 => 0.4,
            _ => 0.0,
        };
        for weak in [1e-1, 1e-3, 1e-5] {
            let column = |r: usize, c: usize| match c {
                40 => entry(r, 41) + weak * entry(r, 40),
                _ => entry(r, c),
            };
            let rows = (0..n + twice).map(|r| if r < n { r } else { 3 * (r - n) });
            let entries = rows.enumerate().flat_map(|(row, r)| (0..n).map(move |c| (row, c, column(r, c))));
            let jacobian =
                Jacobian { rows: n + twice, columns: n, entries: entries.filter(|e| e.2 != 0.0).collect() };
            let values = jacobian.dense().singular_values().expect("singular values");
            let (weakest, least) =
                sparse_weakest_direction(&jacobian, FAINT_SINGULAR_VALUE).expect("a direction");
            assert!((least / values[n - 1] - 1.0).abs() < 0.05, "{weak:e}: {least:e}, {:e}", values[n - 1]);
            assert!(norm(&jacobian.times(&weakest)) < 1.1 * values[n - 1], "{weak:e}");
        }
    }
}
