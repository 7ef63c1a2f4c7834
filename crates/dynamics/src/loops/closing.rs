//! Closing a group of loops: damped Gauss–Newton with least steps, and following a branch along its drivers.

use super::Group;
use crate::System;
use crate::kinematics::Kinematics;
use crate::tangent;
use faer::Mat;
use faer::linalg::solvers::SolveLstsq;
use nalgebra::DMatrix;

/// How a correction ended.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Correction {
    /// Largest residual, m.
    pub residual: f64,
    /// Length of the way from the start, in metres.
    pub moved: f64,
    pub closed: bool,
    /// Row with the largest residual.
    pub worst: usize,
}

/// Most iterations of a correction.
const ITERATIONS: usize = 60;
/// Relative size of pivots that a least step takes for zero.
const STEP_RANK: f64 = 1e-9;
/// Longest step of a branch, as a part of the characteristic length.
const LONGEST: f64 = 0.1;
/// A branch step shorter than this part of the way has met a limit.
const SHORTEST: f64 = 1e-7;

impl System {
    /// Moves the positions in `kinematics` by velocities `u` of the coordinates over unit time.
    pub(crate) fn advance(&self, kinematics: &mut Kinematics<f64>, u: &[f64]) {
        for body in self.bodies.iter().filter(|b| !b.v.is_empty()) {
            let Some(id) = body.joint else { continue };
            let joint = self.mechanism.joint(id);
            if joint.mimic().is_some() {
                continue;
            }
            let velocity: Vec<f64> =
                body.v.clone().map(|v| self.follows[v].map_or(0.0, |f| f.multiplier * u[f.index])).collect();
            if velocity.iter().any(|v| *v != 0.0) {
                let next = tangent::advanced(joint.kind(), &kinematics.q[body.q.clone()], &velocity, 1.0);
                kinematics.q[body.q.clone()].copy_from_slice(&next);
            }
        }
        kinematics.refill(self);
    }

    /// The largest residual of a group, m, and its row.
    pub(crate) fn group_residual(&self, kinematics: &Kinematics<f64>, group: &Group) -> (f64, usize) {
        largest(&self.group_rows(kinematics, group).0)
    }

    /// Closes a group by moving the coordinates `unknown` (indices into the group's) as little as can be.
    ///
    /// Gauss–Newton steps of least norm; where one does not help, Levenberg–Marquardt. Stops when nothing improves:
    /// at rounding for loops that fit, at the least squares of the residuals for those that do not quite.
    pub(crate) fn correct(
        &self,
        kinematics: &mut Kinematics<f64>,
        group: &Group,
        unknown: &[usize],
        tolerance: f64,
    ) -> Correction {
        let lengths = self.coordinate_lengths();
        let mut moved = 0.0;
        let mut damping = 0.0;
        let (mut residuals, mut rows) = self.group_rows(kinematics, group);
        for _ in 0..ITERATIONS {
            let cost = norm(&residuals);
            let at_rounding = largest(&residuals).0 <= 0.01 * tolerance;
            if cost == 0.0 || at_rounding {
                break;
            }
            let Some((step, length)) = self.step(group, &rows, &residuals, unknown, &lengths, damping) else {
                break;
            };
            let before = kinematics.q.clone();
            self.advance(kinematics, &step);
            let (next, next_rows) = self.group_rows(kinematics, group);
            if norm(&next) < cost {
                let stalled =
                    norm(&next) > 0.99 * cost && length < 1e-9 * self.mechanism.characteristic_length();
                (residuals, rows) = (next, next_rows);
                moved += length;
                damping = if damping < 1e-6 { 0.0 } else { damping / 10.0 };
                if stalled {
                    break;
                }
            } else {
                kinematics.q = before;
                kinematics.refill(self);
                if length <= 1e-15 * self.mechanism.characteristic_length() || damping > 1e3 {
                    break;
                }
                damping = if damping == 0.0 { 1e-3 } else { damping * 10.0 };
            }
        }
        let (residual, worst) = largest(&residuals);
        Correction { residual, moved, closed: residual <= tolerance, worst }
    }

    /// The step of the coordinates that takes the residuals away to first order, and its length in metres.
    fn step(
        &self,
        group: &Group,
        rows: &DMatrix<f64>,
        residuals: &[f64],
        unknown: &[usize],
        lengths: &[f64],
        damping: f64,
    ) -> Option<(Vec<f64>, f64)> {
        let scale = |k: usize| lengths[group.coordinates[unknown[k]]];
        let jacobian = Mat::from_fn(rows.nrows(), unknown.len(), |r, k| rows[(r, unknown[k])] / scale(k));
        let target = Mat::from_fn(rows.nrows(), 1, |r, _| -residuals[r]);
        let x =
            if damping > 0.0 { damped(&jacobian, &target, damping) } else { least_norm(&jacobian, &target) };
        let length = x.norm_l2();
        // A full turn at once is no step.
        let longest = 0.5 * self.mechanism.characteristic_length() * (unknown.len() as f64).sqrt();
        let shorten = if length > longest { longest / length } else { 1.0 };
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        let mut u = vec![0.0; self.coordinates];
        for k in 0..unknown.len() {
            u[group.coordinates[unknown[k]]] = shorten * x[(k, 0)] / scale(k);
        }
        Some((u, length * shorten))
    }

    /// Rates of the coordinates `unknown` that keep a group closed while its others move at `drive` (all over the
    /// group's coordinates).
    pub(crate) fn follow(
        &self,
        kinematics: &Kinematics<f64>,
        group: &Group,
        unknown: &[usize],
        drive: &[f64],
    ) -> Vec<f64> {
        let (_, rows) = self.group_rows(kinematics, group);
        let lengths = self.coordinate_lengths();
        let scale = |k: usize| lengths[group.coordinates[unknown[k]]];
        let jacobian = Mat::from_fn(rows.nrows(), unknown.len(), |r, k| rows[(r, unknown[k])] / scale(k));
        let target = Mat::from_fn(rows.nrows(), 1, |r, _| {
            -(0..drive.len()).map(|c| rows[(r, c)] * drive[c]).sum::<f64>()
        });
        let x = least_norm(&jacobian, &target);
        let mut rates = drive.to_vec();
        for (k, &c) in unknown.iter().enumerate() {
            rates[c] = x[(k, 0)] / scale(k);
        }
        rates
    }

    /// Follows the branch that a closed group stands on while its drivers move by `way` (over the group's
    /// coordinates; zero for `unknown`). Returns how much of the way was gone: 1, or less at a limit.
    ///
    /// Each step goes along the tangent, then is corrected; a correction that is not small beside the step, or a
    /// tangent that turns sharply, is a sign of another branch, and the step is halved.
    pub(crate) fn drive(
        &self,
        kinematics: &mut Kinematics<f64>,
        group: &Group,
        unknown: &[usize],
        way: &[f64],
        tolerance: f64,
    ) -> f64 {
        let lengths = self.coordinate_lengths();
        let metres = |u: &[f64]| {
            group.coordinates.iter().zip(u).map(|(&c, u)| (lengths[c] * u).powi(2)).sum::<f64>().sqrt()
        };
        let longest = LONGEST * self.mechanism.characteristic_length();
        let (mut gone, mut share) = (0.0, 1.0);
        let mut tangent = self.follow(kinematics, group, unknown, way);
        while gone < 1.0 {
            let speed = metres(&tangent);
            let step = f64::min(share, 1.0 - gone).min(longest / speed.max(1e-300));
            let before = kinematics.q.clone();
            let mut u = vec![0.0; self.coordinates];
            for (at, &c) in group.coordinates.iter().enumerate() {
                u[c] = step * tangent[at];
            }
            self.advance(kinematics, &u);
            let correction = self.correct(kinematics, group, unknown, tolerance);
            let next = self.follow(kinematics, group, unknown, way);
            let turn = dot(&tangent, &next, group, &lengths) / (speed * metres(&next)).max(1e-300);
            let small = correction.moved <= 0.25 * step * speed + tolerance;
            if correction.closed && small && turn > 0.8 {
                gone = if 1.0 - gone - step < 1e-14 { 1.0 } else { gone + step };
                share = 2.0 * step;
                tangent = next;
            } else {
                kinematics.q = before;
                kinematics.refill(self);
                share = step / 2.0;
                if share < SHORTEST {
                    return gone;
                }
            }
        }
        gone
    }
}

fn dot(a: &[f64], b: &[f64], group: &Group, lengths: &[f64]) -> f64 {
    group.coordinates.iter().zip(a.iter().zip(b)).map(|(&c, (a, b))| lengths[c] * lengths[c] * a * b).sum()
}

fn norm(residuals: &[f64]) -> f64 {
    residuals.iter().map(|r| r * r).sum::<f64>().sqrt()
}

/// The largest magnitude and where it stands; a NaN counts as infinite.
fn largest(residuals: &[f64]) -> (f64, usize) {
    let size = |r: f64| if r.is_nan() { f64::INFINITY } else { r.abs() };
    residuals
        .iter()
        .enumerate()
        .fold((0.0, 0), |(most, at), (i, r)| if size(*r) > most { (size(*r), i) } else { (most, at) })
}

/// The shortest x with least ‖Jx − b‖, by a complete orthogonal factorisation.
pub(crate) fn least_norm(jacobian: &Mat<f64>, target: &Mat<f64>) -> Mat<f64> {
    let n = jacobian.ncols();
    if n == 0 || jacobian.nrows() == 0 || jacobian.norm_max() == 0.0 {
        return Mat::zeros(n, 1);
    }
    let qr = jacobian.col_piv_qr();
    let r = qr.R();
    let size = r.nrows().min(n);
    let first = r[(0, 0)].abs();
    let rank = (0..size).take_while(|&i| r[(i, i)].abs() > STEP_RANK * first).count();
    let rotated = qr.compute_Q().transpose() * target;
    // [R₁₁ R₁₂] Pᵀx = c has a solution; the shortest is Q₂ T⁻ᵀ c with [R₁₁ R₁₂]ᵀ = Q₂ T.
    let upper = Mat::from_fn(n, rank, |c, i| if c >= i { r[(i, c)] } else { 0.0 });
    let second = upper.qr();
    let t = second.thin_R();
    let mut y = Mat::<f64>::zeros(rank, 1);
    for i in 0..rank {
        let known: f64 = (0..i).map(|k| t[(k, i)] * y[(k, 0)]).sum();
        y[(i, 0)] = (rotated[(i, 0)] - known) / t[(i, i)];
    }
    let permuted = second.compute_thin_Q() * y;
    let order = qr.P().arrays().0;
    let mut x = Mat::zeros(n, 1);
    for i in 0..n {
        x[(order[i], 0)] = permuted[(i, 0)];
    }
    x
}

/// min ‖Jx − b‖² + λ² σ² ‖x‖², σ the size of J.
fn damped(jacobian: &Mat<f64>, target: &Mat<f64>, damping: f64) -> Mat<f64> {
    let (m, n) = (jacobian.nrows(), jacobian.ncols());
    let weight = damping * jacobian.norm_max();
    let stacked = Mat::from_fn(m + n, n, |r, c| {
        if r < m {
            jacobian[(r, c)]
        } else if r - m == c {
            weight
        } else {
            0.0
        }
    });
    let right = Mat::from_fn(m + n, 1, |r, _| if r < m { target[(r, 0)] } else { 0.0 });
    stacked.qr().solve_lstsq(right).get(..n, ..).to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shortest_solution_of_a_deficient_system() {
        // Rank 1: x + 2y = 5 twice (the second times 3).
        let j = Mat::from_fn(2, 2, |r, c| [1.0, 2.0][c] * [1.0, 3.0][r]);
        let b = Mat::from_fn(2, 1, |r, _| [5.0, 15.0][r]);
        let x = least_norm(&j, &b);
        assert!((x[(0, 0)] - 1.0).abs() < 1e-14 && (x[(1, 0)] - 2.0).abs() < 1e-14);
        let wide = Mat::from_fn(1, 3, |_, c| [3.0, 0.0, 4.0][c]);
        let x = least_norm(&wide, &Mat::from_fn(1, 1, |_, _| 25.0));
        assert!(
            (x[(0, 0)] - 3.0).abs() < 1e-14 && x[(1, 0)].abs() < 1e-15 && (x[(2, 0)] - 4.0).abs() < 1e-14
        );
        assert_eq!(least_norm(&Mat::zeros(2, 2), &b).norm_l2(), 0.0);
    }
}
