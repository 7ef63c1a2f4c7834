//! Closing a group of loops: damped Gauss–Newton with least steps.

use super::Group;
use crate::System;
use crate::kinematics::Kinematics;
use crate::tangent;
use faer::Mat;
use faer::linalg::solvers::SolveLstsq;
use nalgebra::DMatrix;

/// The directions in which a group may be moved.
#[derive(Clone, Copy)]
pub(crate) struct Moves<'a> {
    /// Coordinates (by index into the group's), each by itself.
    pub unknown: &'a [usize],
    /// And together, along a course of the drivers: rates over the group's coordinates, 1 m/s long.
    pub course: Option<&'a [f64]>,
}

/// How a correction ended.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Correction {
    /// Largest residual, m.
    pub residual: f64,
    /// Length of the way from the start, in metres.
    pub moved: f64,
    /// Part of it along the course, m.
    pub along: f64,
    pub closed: bool,
    /// Row with the largest residual.
    pub worst: usize,
}

/// Most iterations of a correction.
const ITERATIONS: usize = 60;
/// Relative size of pivots that a least step takes for zero.
const STEP_RANK: f64 = 1e-9;

impl Moves<'_> {
    pub fn count(&self) -> usize {
        self.unknown.len() + usize::from(self.course.is_some())
    }

    /// A over the moves, each measured in metres.
    pub fn jacobian(&self, group: &Group, rows: &DMatrix<f64>) -> Mat<f64> {
        Mat::from_fn(rows.nrows(), self.count(), |r, k| match (self.unknown.get(k), self.course) {
            (Some(&at), _) => rows[(r, at)] / group.lengths[at],
            (None, Some(course)) => (0..course.len()).map(|c| rows[(r, c)] * course[c]).sum(),
            (None, None) => 0.0,
        })
    }

    /// The coordinates' share in moves of so many metres, over the group's coordinates.
    pub fn expand(&self, group: &Group, x: impl Fn(usize) -> f64) -> Vec<f64> {
        let mut u = vec![0.0; group.coordinates.len()];
        for (k, &at) in self.unknown.iter().enumerate() {
            u[at] = x(k) / group.lengths[at];
        }
        if let Some(course) = self.course {
            let along = x(self.unknown.len());
            u.iter_mut().zip(course).for_each(|(u, c)| *u += along * c);
        }
        u
    }
}

impl System {
    /// Moves the positions in `kinematics` by velocities `u` of the coordinates over unit time.
    pub(crate) fn advance(&self, kinematics: &mut Kinematics<f64>, u: &[f64]) {
        for body in 0..self.bodies.len() {
            self.advance_body(kinematics, body, |c| u[c]);
        }
        kinematics.refill(self);
    }

    /// As [`advance`](Self::advance), by velocities over a group's coordinates.
    pub(crate) fn advance_group(&self, kinematics: &mut Kinematics<f64>, group: &Group, u: &[f64]) {
        for &body in &group.bodies {
            let rate = |c: usize| group.coordinates.binary_search(&c).map_or(0.0, |at| u[at]);
            self.advance_body(kinematics, body, rate);
        }
        self.refill_group(kinematics, group);
    }

    fn advance_body(&self, kinematics: &mut Kinematics<f64>, body: usize, rate: impl Fn(usize) -> f64) {
        let body = &self.bodies[body];
        let Some(joint) = body.joint.map(|id| self.mechanism.joint(id)) else { return };
        if body.v.is_empty() || joint.mimic().is_some() {
            return;
        }
        let q = &mut kinematics.q[body.q.clone()];
        let of = |v: usize| self.follows[v].map_or(0.0, |f| f.multiplier * rate(f.index));
        if q.len() == 1 {
            q[0] += of(body.v.start);
            return;
        }
        let velocity: Vec<f64> = body.v.clone().map(of).collect();
        if velocity.iter().any(|v| *v != 0.0) {
            let next = tangent::advanced(joint.kind(), q, &velocity, 1.0);
            q.copy_from_slice(&next);
        }
    }

    /// The velocities over a group's coordinates that lead from one position to another in unit time.
    pub(crate) fn displacement(&self, group: &Group, from: &[f64], to: &[f64]) -> Vec<f64> {
        let mut u = vec![0.0; group.coordinates.len()];
        for body in group.bodies.iter().map(|&b| &self.bodies[b]) {
            let Some(joint) = body.joint.map(|id| self.mechanism.joint(id)) else { continue };
            if joint.mimic().is_some() {
                continue;
            }
            let way = tangent::displacement(joint.kind(), &from[body.q.clone()], &to[body.q.clone()]);
            for (v, rate) in body.v.clone().zip(way) {
                let at = self.follows[v].and_then(|f| group.coordinates.binary_search(&f.index).ok());
                if let Some(at) = at {
                    u[at] = rate;
                }
            }
        }
        u
    }

    /// The largest residual of a group, m, and its row.
    pub(crate) fn group_residual(&self, kinematics: &Kinematics<f64>, group: &Group) -> (f64, usize) {
        largest(&self.group_rows(kinematics, group).0)
    }

    /// Closes a group by moving it as little as can be.
    ///
    /// Gauss–Newton steps of least norm; where one does not help, Levenberg–Marquardt. Stops when nothing improves:
    /// at rounding for loops that fit, at the least squares of the residuals for those that do not quite.
    pub(crate) fn correct(
        &self,
        kinematics: &mut Kinematics<f64>,
        group: &Group,
        moves: Moves,
        tolerance: f64,
    ) -> Correction {
        let size = self.mechanism.characteristic_length();
        let (mut moved, mut along) = (0.0, 0.0);
        let mut damping = 0.0;
        let (mut residuals, mut rows) = self.group_rows(kinematics, group);
        for _ in 0..ITERATIONS {
            let cost = norm(&residuals);
            if cost == 0.0 || largest(&residuals).0 <= 1e-3 * tolerance {
                break;
            }
            let jacobian = moves.jacobian(group, &rows);
            let target = Mat::from_fn(residuals.len(), 1, |r, _| -residuals[r]);
            let x = match damping > 0.0 {
                true => damped(&jacobian, &target, damping),
                false => shortest(&jacobian, &target, tolerance / size),
            };
            let length = x.norm_l2();
            if !(length > 0.0 && length.is_finite()) {
                break;
            }
            // So long a step is no first-order matter: a third of a radian, or of the gap, is the most. A damped one goes
            // where more is won than a shortened one.
            let longest = 0.3 * size.max(largest(&residuals).0) * (moves.count() as f64).sqrt();
            if length > longest && damping < 0.1 {
                damping = f64::max(10.0 * damping, 1e-3);
                continue;
            }
            let part = (longest / length).min(1.0);
            let (x, length) = (x * faer::Scale(part), part * length);
            let promised = (jacobian * &x - &target).norm_l2();
            let before = kinematics.q.clone();
            self.advance_group(kinematics, group, &moves.expand(group, |k| x[(k, 0)]));
            let (next, next_rows) = self.group_rows(kinematics, group);
            let left = norm(&next);
            if left < cost {
                let at_rounding = largest(&next).0 <= 0.01 * tolerance;
                let stalled = left > 0.99 * cost && length < 1e-9 * size || left > 0.3 * cost && at_rounding;
                // As much as was promised: the promise may be bolder.
                let kept = (cost * cost - left * left) / (cost * cost - promised * promised);
                (residuals, rows) = (next, next_rows);
                moved += length;
                along += moves.course.map_or(0.0, |_| x[(moves.unknown.len(), 0)]);
                damping *= if kept > 0.75 {
                    0.1
                } else if kept > 0.25 {
                    0.5
                } else {
                    2.0
                };
                if damping < 1e-5 {
                    damping = 0.0;
                }
                if stalled {
                    break;
                }
            } else {
                kinematics.q = before;
                self.refill_group(kinematics, group);
                let at_rounding = largest(&residuals).0 <= 0.01 * tolerance;
                if at_rounding || length <= 1e-15 * size || damping > 1e3 {
                    break;
                }
                damping = if damping == 0.0 { 1e-3 } else { damping * 10.0 };
            }
        }
        let (residual, worst) = largest(&residuals);
        Correction { residual, moved, along, closed: residual <= tolerance, worst }
    }
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

/// The shortest x with least ‖Jx − b‖.
///
/// Pivoting is what costs most in a large system: there a damping of 1e-8 stands in for it, which shortens by 1e-4 what a
/// singular value of 1e-6 asks for and leaves out what those of rounding do.
///
/// Pivots below `floor` times the first are left out too: rows of a rounded file that repeat others but for its
/// inexactness contradict them, and following them leads far off.
pub(crate) fn shortest(jacobian: &Mat<f64>, target: &Mat<f64>, floor: f64) -> Mat<f64> {
    const LARGE: usize = 48;
    const FAINT: f64 = 1e-8;
    if jacobian.ncols() > LARGE {
        damped(jacobian, target, FAINT)
    } else {
        least_norm(jacobian, target, floor.max(STEP_RANK))
    }
}

/// The shortest x with least ‖Jx − b‖, by a complete orthogonal factorisation.
fn least_norm(jacobian: &Mat<f64>, target: &Mat<f64>, floor: f64) -> Mat<f64> {
    let n = jacobian.ncols();
    if n == 0 || jacobian.nrows() == 0 || jacobian.norm_max() == 0.0 {
        return Mat::zeros(n, 1);
    }
    let qr = jacobian.col_piv_qr();
    let r = qr.R();
    let size = r.nrows().min(n);
    let first = r[(0, 0)].abs();
    let rank = (0..size).take_while(|&i| r[(i, i)].abs() > floor * first).count();
    let rotated = qr.compute_thin_Q().transpose() * target;
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
        let x = least_norm(&j, &b, STEP_RANK);
        assert!((x[(0, 0)] - 1.0).abs() < 1e-14 && (x[(1, 0)] - 2.0).abs() < 1e-14);
        let wide = Mat::from_fn(1, 3, |_, c| [3.0, 0.0, 4.0][c]);
        let x = least_norm(&wide, &Mat::from_fn(1, 1, |_, _| 25.0), STEP_RANK);
        assert!(
            (x[(0, 0)] - 3.0).abs() < 1e-14 && x[(1, 0)].abs() < 1e-15 && (x[(2, 0)] - 4.0).abs() < 1e-14
        );
        assert_eq!(least_norm(&Mat::zeros(2, 2), &b, STEP_RANK).norm_l2(), 0.0);
    }
}
