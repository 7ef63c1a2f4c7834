//! Bounds of 1/m̄ over a box of positions, by energy.
//!
//! 1/m̄ = w = max { 2 j·u − uᵀM u : A u = 0 }. With multipliers λ, G = 2 (j + Aᵀλ)·u − uᵀM u and r = j + Aᵀλ − M u, any u and λ give
//!
//! | bound | valid for |
//! |---|---|
//! | w ≥ G + 2 r·δ − δᵀM δ | δ with A (u + δ) = 0 |
//! | w ≤ G − σ\|A u\|² + ρᵀ(M + σAᵀA)⁻¹ρ, ρ = r − σAᵀA u | M + σAᵀA positive definite |
//!
//! The first bound is the energy of an admissible motion, the second one maximises over all motions. u and λ are those of the middle of the
//! box, as exact numbers: there both bounds agree, and their distance grows with the square of the box. The second bound needs no rank
//! of A, and holds without the rows that are left out.

use super::load::Load;
use super::loops::{Loops, Rows, middle, times};
use super::plan::Plan;
use nalgebra::{DMatrix, DVector};
use percuss_spatial::Interval;

/// Bounds of 1/m̄.
#[derive(Clone, Copy, Debug)]
pub(super) struct InverseMass {
    /// Smallest value, for the independent rows.
    pub least: f64,
    /// Largest value.
    pub most: f64,
    /// Value at the middle, not proved.
    pub middle: f64,
}

/// Solution at the middle of a box: rates and multipliers, as exact numbers.
struct Solution {
    u: Vec<f64>,
    lambda: Vec<f64>,
    /// σ: weight of the rows in the metric.
    weight: f64,
    /// C with C (M + σAᵀA) Cᵀ ≈ 1.
    whitening: DMatrix<f64>,
}

impl InverseMass {
    /// Bounds of m̄: 0 and infinite without a proof.
    pub fn mass(self) -> [f64; 2] {
        let quotient = |w: f64| Interval::point(1.0) / Interval::point(w);
        let lower = if self.most > 0.0 && self.most.is_finite() { quotient(self.most).lo() } else { 0.0 };
        [lower.max(0.0), if self.least > 0.0 { quotient(self.least).hi() } else { f64::INFINITY }]
    }
}

impl Solution {
    /// KKT equations over the rows; `None` if the metric is not positive definite or the rows are singular.
    fn new(mass: &DMatrix<f64>, rows: &DMatrix<f64>, j: &[f64]) -> Option<Self> {
        let (n, m) = (mass.nrows(), rows.nrows());
        let weight = if m == 0 { 0.0 } else { mass.amax() / rows.amax().powi(2) };
        let metric = mass + rows.transpose() * rows * weight;
        let mut all = DMatrix::zeros(n + m, n + m);
        all.view_mut((0, 0), (n, n)).copy_from(&metric);
        all.view_mut((n, 0), (m, n)).copy_from(rows);
        all.view_mut((0, n), (n, m)).copy_from(&rows.transpose());
        let mut right = DVector::zeros(n + m);
        right.rows_mut(0, n).copy_from_slice(j);
        let solved = all.lu().solve(&right)?;
        let whitening = metric.cholesky()?.l().try_inverse()?;
        let (u, multipliers) = (solved.rows(0, n), solved.rows(n, m));
        solved.iter().all(|x| x.is_finite()).then(|| Self {
            u: u.iter().copied().collect(),
            lambda: multipliers.iter().map(|x| -x).collect(),
            weight,
            whitening,
        })
    }
}

fn points(values: &[f64]) -> Vec<Interval> {
    values.iter().copied().map(Interval::point).collect()
}

fn dot(a: &[Interval], b: &[Interval]) -> Interval {
    a.iter().zip(b).fold(Interval::point(0.0), |sum, (x, y)| sum + *x * *y)
}

/// Upper bound of ρᵀM⁻¹ρ for a symmetric M in intervals and `white` = Cρ: |Cρ|²/λ with λ ≥ 1 − ‖C M Cᵀ − 1‖∞ the smallest eigenvalue of C M Cᵀ.
/// Infinite if M is not proved positive definite.
pub(super) fn quadratic_bound(matrix: &[Vec<Interval>], whitening: &DMatrix<f64>, white: &[Interval]) -> f64 {
    let n = white.len();
    let half: Vec<Vec<Interval>> = matrix.iter().map(|column| times(whitening, column)).collect();
    let mut deviation = 0.0_f64;
    for r in 0..n {
        let row: Vec<Interval> = half.iter().map(|column| column[r]).collect();
        let product = times(whitening, &row);
        let sum = product.iter().enumerate().fold(Interval::point(0.0), |sum, (c, x)| {
            sum + Interval::point((*x - Interval::point(if c == r { 1.0 } else { 0.0 })).magnitude())
        });
        deviation = deviation.max(sum.hi());
    }
    let least = Interval::point(1.0) - Interval::point(deviation);
    if least.lo() <= 0.0 {
        return f64::INFINITY;
    }
    let square = white.iter().fold(Interval::point(0.0), |sum, x| sum + x.square());
    (square / least).hi()
}

/// Bounds of 1/m̄ at the positions `q`; `None` if the metric is singular. `closed`: independent rows and dependent coordinates.
pub(super) fn inverse_mass(
    plan: &Plan<Interval>,
    load: &Load<Interval>,
    loops: &Loops,
    q: &[Interval],
    closed: (&[usize], &[usize]),
) -> Option<InverseMass> {
    let (used, dependent) = closed;
    let placements = plan.placements(q);
    let loads = load.wrenches(plan, &placements).wrenches;
    let columns = plan.mass_columns(&placements, &plan.unit_motions(&placements));
    let rows = match loops.is_empty() {
        true => Rows { residuals: Vec::new(), matrix: Vec::new() },
        false => loops.rows(plan, q, &placements),
    };
    let a: Vec<&Vec<Interval>> = used.iter().map(|r| &rows.matrix[*r]).collect();
    let n = plan.coordinates;
    let a_middle = DMatrix::from_fn(used.len(), n, |r, c| a[r][c].mid());
    let still = vec![Interval::point(0.0); n];
    let j = plan.residual(&placements, &plan.motion(&placements, still.clone(), &loads).balances, &still);
    let mass = middle(&columns);
    let mass = (&mass + mass.transpose()) * 0.5;
    let solution = Solution::new(&mass, &a_middle, &j.iter().map(|x| x.mid()).collect::<Vec<_>>())?;
    let (u, weight) = (points(&solution.u), Interval::point(solution.weight));

    let motion = plan.motion(&placements, u.clone(), &loads);
    let mut r = plan.residual(&placements, &motion.balances, &u);
    let mut g = plan.energy_bound(&motion.twists, &loads, &u);
    // A u of each row: zero within the rounding of the solution, and within the box.
    let speeds: Vec<Interval> = a.iter().map(|row| dot(row, &u)).collect();
    for ((row, lambda), speed) in a.iter().zip(&solution.lambda).zip(&speeds) {
        let lambda = Interval::point(*lambda);
        g += Interval::point(2.0) * lambda * *speed;
        for (r, entry) in r.iter_mut().zip(row.iter()) {
            *r += lambda * *entry;
        }
    }
    // Lower bound: δ over the dependent coordinates from A δ = −A u, |δ|∞ ≤ |C A u|∞ / (1 − ‖1 − C A‖).
    let mut least = g.lo();
    if !used.is_empty() {
        let square = DMatrix::from_fn(used.len(), used.len(), |r, c| a_middle[(r, dependent[c])]);
        let c = square.try_inverse()?;
        let mut deviation = 0.0_f64;
        for row in 0..used.len() {
            let sum = dependent.iter().enumerate().fold(Interval::point(0.0), |sum, (k, coordinate)| {
                let column: Vec<Interval> = a.iter().map(|row| row[*coordinate]).collect();
                let entry = dot(&points(&c.row(row).iter().copied().collect::<Vec<_>>()), &column);
                sum + Interval::point((entry - Interval::point(if k == row { 1.0 } else { 0.0 })).magnitude())
            });
            deviation = deviation.max(sum.hi());
        }
        let room = Interval::point(1.0) - Interval::point(deviation);
        let steps = times(&c, &speeds);
        let largest = steps.iter().fold(0.0_f64, |most, x| most.max(x.magnitude()));
        least = match room.lo() > 0.0 {
            true => {
                let delta = (Interval::point(largest) / room).hi();
                let loss = dependent.iter().fold(Interval::point(0.0), |sum, c| {
                    let first = Interval::point(2.0 * r[*c].magnitude());
                    let second = dependent.iter().fold(Interval::point(0.0), |sum, d| {
                        sum + Interval::point(columns[*c][*d].magnitude()) * Interval::point(delta)
                    });
                    sum + (first + second) * Interval::point(delta)
                });
                (g - loss).lo()
            }
            false => f64::NEG_INFINITY,
        };
    }
    let mut metric = columns;
    let mut rho = r;
    let mut upper = g;
    for (row, speed) in a.iter().zip(&speeds) {
        upper -= weight * speed.square();
        for (c, entry) in row.iter().enumerate() {
            rho[c] -= weight * *entry * *speed;
            for (d, other) in row.iter().enumerate() {
                metric[c][d] += weight * *entry * *other;
            }
        }
    }
    let gap = quadratic_bound(&metric, &solution.whitening, &times(&solution.whitening, &rho));
    let middle = j.iter().zip(&solution.u).map(|(j, u)| j.mid() * u).sum();
    Some(InverseMass { least, most: (upper + Interval::point(gap)).hi(), middle })
}
