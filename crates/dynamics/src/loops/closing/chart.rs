//! Neighbourhood of a point of the curve without a second branch.
//!
//! With J the Jacobian over the directions and t the unit tangent, X = [J; tᵀ] has full column rank at a regular
//! point. Closed poses around a point 0 form one curve as long as ‖X₀⁺(X − X₀)‖ < 1 (Newton and Kantorovich). Another
//! branch lies beyond a pose at which this norm reaches 1, because det X₀⁺X changes its sign there. Redundant rows
//! have no influence. Source: Allgower and Georg, Introduction to Numerical Continuation Methods, 2003, ch. 2
//! (orientation); Deuflhard, Newton Methods for Nonlinear Problems, 2011, §2.1 (affine covariant norm).

use crate::linear::dense::{determinant_sign, dot};
use crate::linear::jacobian::Jacobian;
use crate::tolerances::{CHART_DRIFT, DENSE_LIMIT, DRIFT_ITERATIONS, FAINT_SINGULAR_VALUE, TURNING_DRIFT};

/// Linearisation of the curve at a regular point.
pub(super) struct Chart<'a> {
    jacobian: &'a Jacobian,
    tangent: &'a [f64],
    /// Householder factors of X; `None` for a large group, with norms estimated by sparse solutions.
    factors: Option<HouseholderFactors>,
    /// Threshold of singular values, relative to the largest.
    floor: f64,
}

impl<'a> Chart<'a> {
    /// Chart at a point; `None` if X does not have full column rank, because branches cross at the point.
    pub fn of(jacobian: &'a Jacobian, tangent: &'a [f64], floor: f64) -> Option<Self> {
        let factors = match jacobian.columns <= DENSE_LIMIT {
            true => Some(HouseholderFactors::of(stacked(jacobian, tangent), jacobian.columns)?),
            false => None,
        };
        Some(Self { jacobian, tangent, factors, floor })
    }

    /// True if no other branch lies between this point and another point at distance `step` (m), in a group of size
    /// `size` (m).
    ///
    /// The norm is evaluated at the other point. In between, the norm grows with the distance, up to second-order
    /// terms: (step/size)² divided by the smallest singular value of X.
    pub fn excludes_branch_between(&self, other: &Jacobian, tangent: &[f64], step: f64, size: f64) -> bool {
        let Some(factors) = &self.factors else {
            return self.sparse_drift(other) <= CHART_DRIFT;
        };
        let bend = (step / size).powi(2);
        if bend > TURNING_DRIFT * factors.least_singular_value() {
            return false;
        }
        let n = self.jacobian.columns;
        let mut drift = factors.solve(stacked(other, tangent));
        let mut relative = drift.clone();
        (0..n).for_each(|k| drift[k * n + k] -= 1.0);
        spectral_norm(&drift, n) <= CHART_DRIFT && determinant_sign(&mut relative, n) > 0
    }

    /// Spectral radius of J₀⁺(J − J₀), by power iterations from the tangent.
    fn sparse_drift(&self, other: &Jacobian) -> f64 {
        let mut v: Vec<f64> =
            self.tangent.iter().enumerate().map(|(k, t)| t + 0.1 + 0.01 * (k % 7) as f64).collect();
        let mut norm = 0.0;
        for _ in 0..DRIFT_ITERATIONS {
            let length = dot(&v, &v).sqrt();
            if length == 0.0 {
                return 0.0;
            }
            v.iter_mut().for_each(|v| *v /= length);
            let (there, here) = (other.times(&v), self.jacobian.times(&v));
            let change: Vec<f64> = there.iter().zip(&here).map(|(a, b)| a - b).collect();
            v = self.jacobian.shortest(&change, self.floor);
            norm = dot(&v, &v).sqrt();
        }
        norm
    }
}

/// X: the Jacobian with the tangent as its last row. Columns one after another.
fn stacked(jacobian: &Jacobian, tangent: &[f64]) -> Vec<f64> {
    let rows = jacobian.rows + 1;
    let mut columns = vec![0.0; rows * jacobian.columns];
    jacobian.entries.iter().for_each(|(r, c, a)| columns[c * rows + r] += a);
    tangent.iter().enumerate().for_each(|(c, t)| columns[c * rows + rows - 1] = *t);
    columns
}

/// X = Q R by Householder reflections.
struct HouseholderFactors {
    /// For each column: the reflection vector from the diagonal down, and R above the diagonal.
    columns: Vec<f64>,
    rows: usize,
    /// Diagonal of R.
    diagonal: Vec<f64>,
}

impl HouseholderFactors {
    /// Factorisation; `None` if a column depends on the columns before it.
    fn of(mut columns: Vec<f64>, count: usize) -> Option<Self> {
        let rows = columns.len() / count;
        if rows < count {
            return None;
        }
        let largest = columns.chunks_exact(rows).map(|c| dot(c, c)).fold(0.0, f64::max).sqrt();
        let mut diagonal = vec![0.0; count];
        for k in 0..count {
            let (done, rest) = columns.split_at_mut((k + 1) * rows);
            let own = &mut done[k * rows + k..];
            let length = dot(own, own).sqrt();
            // The comparison also rejects NaN.
            if length.is_nan() || length <= FAINT_SINGULAR_VALUE * largest {
                return None;
            }
            let pivot = if own[0] > 0.0 { -length } else { length };
            own[0] -= pivot;
            let over = 1.0 / (length * own[0].abs());
            for other in rest.chunks_exact_mut(rows) {
                let part = dot(own, &other[k..]) * over;
                other[k..].iter_mut().zip(&*own).for_each(|(x, v)| *x -= part * v);
            }
            diagonal[k] = pivot;
        }
        Some(Self { columns, rows, diagonal })
    }

    /// X⁺B, row by row, for B given by columns.
    fn solve(&self, mut others: Vec<f64>) -> Vec<f64> {
        let (n, rows) = (self.diagonal.len(), self.rows);
        let mut solution = vec![0.0; n * n];
        for (c, b) in others.chunks_exact_mut(rows).enumerate() {
            for (k, own) in self.columns.chunks_exact(rows).enumerate() {
                let own = &own[k..];
                let over = 1.0 / (self.diagonal[k].abs() * own[0].abs());
                let part = dot(own, &b[k..]) * over;
                b[k..].iter_mut().zip(own).for_each(|(x, v)| *x -= part * v);
            }
            for k in (0..n).rev() {
                let known: f64 = (k + 1..n).map(|i| self.columns[i * rows + k] * solution[i * n + c]).sum();
                solution[k * n + c] = (b[k] - known) / self.diagonal[k];
            }
        }
        solution
    }

    /// Estimate of the smallest singular value, by inverse iterations with R.
    fn least_singular_value(&self) -> f64 {
        let (n, rows) = (self.diagonal.len(), self.rows);
        let mut v: Vec<f64> = (0..n).map(|k| 1.0 + 0.1 * k as f64).collect();
        let mut growth = 1.0;
        for _ in 0..DRIFT_ITERATIONS {
            let length = dot(&v, &v).sqrt();
            v.iter_mut().for_each(|v| *v /= length);
            for k in 0..n {
                let known: f64 = (0..k).map(|i| self.columns[k * rows + i] * v[i]).sum();
                v[k] = (v[k] - known) / self.diagonal[k];
            }
            for k in (0..n).rev() {
                let known: f64 = (k + 1..n).map(|i| self.columns[i * rows + k] * v[i]).sum();
                v[k] = (v[k] - known) / self.diagonal[k];
            }
            growth = dot(&v, &v).sqrt();
        }
        1.0 / growth.sqrt()
    }
}

/// Largest singular value of an n×n matrix, given row by row, by power iterations.
fn spectral_norm(matrix: &[f64], n: usize) -> f64 {
    let total = dot(matrix, matrix).sqrt();
    // The Frobenius norm is an upper bound.
    if total <= CHART_DRIFT || !total.is_finite() {
        return total;
    }
    let mut v: Vec<f64> = (0..n).map(|k| 1.0 + 0.1 * k as f64).collect();
    let mut norm = total;
    for _ in 0..DRIFT_ITERATIONS {
        let length = dot(&v, &v).sqrt();
        if length == 0.0 {
            return total;
        }
        let image: Vec<f64> = matrix.chunks_exact(n).map(|row| dot(row, &v) / length).collect();
        norm = dot(&image, &image).sqrt();
        v.iter_mut().for_each(|v| *v = 0.0);
        for (row, x) in matrix.chunks_exact(n).zip(&image) {
            v.iter_mut().zip(row).for_each(|(v, a)| *v += a * x);
        }
    }
    norm
}

#[cfg(test)]
mod tests {
    use super::*;

    fn jacobian(rows: &[&[f64]]) -> Jacobian {
        let entries = rows.iter().enumerate();
        let entries = entries.flat_map(|(r, row)| row.iter().enumerate().map(move |(c, a)| (r, c, *a)));
        Jacobian { rows: rows.len(), columns: rows[0].len(), entries: entries.collect() }
    }

    /// y² − x² = δ²: J = (−2x, 2y). One step along a branch, and one step to the other branch.
    #[test]
    fn a_jump_between_near_branches_is_seen() {
        let delta = 1e-4_f64;
        let at = |x: f64, side: f64| {
            let y = side * (x * x + delta * delta).sqrt();
            let j = jacobian(&[&[-2.0 * x, 2.0 * y], &[-6.0 * x, 6.0 * y]]);
            let length = x.hypot(y);
            (j, [y / length, x / length], y)
        };
        for x in [-0.1, -1e-2, -1e-3] {
            let (here, mut t, _) = at(x, 1.0);
            if t[0] < 0.0 {
                t = t.map(|t| -t);
            }
            let chart = Chart::of(&here, &t, 0.0).expect("regular");
            let (near, tn, _) = at(0.7 * x, 1.0);
            assert!(chart.excludes_branch_between(&near, &tn, 0.3 * x.abs() * 1.4, 100.0), "{x}");
            // The other branch continues straight.
            let (other, to, _) = at(-x, -1.0);
            let to = if to[0] < 0.0 { to.map(|t| -t) } else { to };
            assert!(!chart.excludes_branch_between(&other, &to, 2.8 * x.abs(), 100.0), "{x}");
        }
    }

    #[test]
    fn crossings_have_no_chart() {
        assert!(Chart::of(&jacobian(&[&[0.0, 0.0]]), &[0.6, 0.8], 0.0).is_none());
        assert!(Chart::of(&jacobian(&[&[0.8, -0.6]]), &[0.6, 0.8], 0.0).is_some());
    }

    #[test]
    fn least_singular_values_are_estimated() {
        let (a, b) = (0.3_f64, 1.1_f64);
        // A rotation times diag(3, 1e-3), stacked on its tangent row.
        let j = jacobian(&[&[3.0 * a.cos(), 3.0 * a.sin(), 0.0], &[-1e-3 * a.sin(), 1e-3 * a.cos(), 0.0]]);
        let chart = Chart::of(&j, &[0.0, 0.0, 1.0], 0.0).expect("regular");
        let least = chart.factors.as_ref().map(HouseholderFactors::least_singular_value).unwrap_or_default();
        assert!((least / 1e-3 - 1.0).abs() < 0.05, "{least} {b}");
    }
}
