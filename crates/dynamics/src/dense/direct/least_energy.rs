//! Solver of the dense route: the least kinetic energy at unit closing speed, for any positive semi-definite M.

use crate::model::interruption;
use crate::tolerances::{IMMOVABLE, INDEFINITE_PIVOT, ROOT_ENERGY, ROUTE_ROUNDINGS};
use faer::linalg::solvers::SolveLstsq;
use faer::{Mat, MatRef, Side};
use nalgebra::DMatrix;

/// The problem m̄ = min { vᵀMv : Av = 0, jv = 1 }.
pub(crate) struct LeastEnergy<'a> {
    /// M, n×n.
    pub mass: &'a DMatrix<f64>,
    /// For each coordinate: sum of the term magnitudes of the diagonal entry of M.
    pub mass_size: &'a [f64],
    /// Independent rows of A, as decided for each group; m×n, of rank m.
    pub constraints: &'a DMatrix<f64>,
    /// j.
    pub row: &'a [f64],
    /// For each coordinate: sum of the term magnitudes of the entry of j.
    pub row_size: &'a [f64],
    /// For each coordinate: displacement of a point at the characteristic length L at unit rate: L for rotations, 1
    /// for translations.
    pub lengths: &'a [f64],
}

/// The minimum, or the reason for its absence.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Minimum {
    Finite(f64),
    /// j vanishes on every admissible motion.
    Immovable,
    /// The minimum is zero.
    Massless,
    /// M has a negative direction, so no minimum exists. Contains the stationary value.
    Stationary(f64),
}

/// Solution of [`LeastEnergy`].
#[derive(Clone, Debug)]
pub(crate) struct LeastEnergySolution {
    pub minimum: Minimum,
    /// v* (zero if immovable).
    pub velocity: Vec<f64>,
    /// True if a massless motion that does not close the gap makes v* ambiguous.
    pub has_massless_motion: bool,
    /// |j on ker A| relative to the size of its terms.
    pub closing_speed: f64,
    /// Number of massless directions.
    pub massless_directions: usize,
    /// Sensitivity of m̄ to the rounding of A and j, relative to m̄ and in units of ε: 2‖v‖(‖j‖ + Σ |λᵢ|‖Aᵢ‖), with the multipliers λ of a
    /// unit impulse. Orthogonal transformations perturb each row relative to its norm in the scaled coordinates (Higham, Accuracy and
    /// Stability of Numerical Algorithms, 2002, theorem 19.4), so that entries of heavy coordinates lose digits.
    pub row_sensitivity: f64,
    /// True if a direction with an energy below rounding couples to the solution. Such a direction, if not dropped,
    /// may reduce m̄ to zero.
    pub massless_couples: bool,
}

/// Factorisation M = L Lᵀ with pivoting, up to the first zero pivot.
struct MassFactor {
    /// Lᵀ, rank×n.
    transpose: Mat<f64>,
    negative: bool,
}

impl LeastEnergy<'_> {
    /// Solves v = v₀ + Z z by least squares with M = L Lᵀ, without pseudo-inverse or regularisation.
    pub fn solve(&self) -> LeastEnergySolution {
        let n = self.row.len();
        let scales = self.scales();
        let kernel = self.constraint_kernel(&scales);
        let mass = Mat::from_fn(n, n, |r, c| {
            if self.has_mass(r) && self.has_mass(c) { self.mass[(r, c)] * scales[r] * scales[c] } else { 0.0 }
        });
        interruption::check();
        let factor = self.factor(&mass);
        let rank = factor.transpose.nrows();
        let mut solution = LeastEnergySolution {
            minimum: Minimum::Immovable,
            velocity: vec![0.0; n],
            has_massless_motion: false,
            closing_speed: self.closing_speed(&kernel, &scales),
            massless_directions: n - rank,
            massless_couples: false,
            row_sensitivity: 0.0,
        };
        if solution.closing_speed <= IMMOVABLE {
            return solution;
        }
        let row = Mat::from_fn(1, n, |_, c| self.row[c] * scales[c]);
        let (minimum, scaled) = if factor.negative {
            stationary_minimum(&mass, &kernel, &row)
        } else if self.constraints.nrows() == 0 && rank == n {
            formula(&mass, &row)
        } else {
            let found = least_squares(&factor.transpose, &kernel, &row);
            solution.has_massless_motion =
                found.has_massless_motion && matches!(found.minimum, Minimum::Finite(_));
            solution.massless_couples =
                solution.has_massless_motion && self.massless_couples(&scales, &found);
            (found.minimum, found.velocity)
        };
        if let Minimum::Finite(m) | Minimum::Stationary(m) = minimum {
            solution.row_sensitivity = self.row_sensitivity(&mass, &row, &scaled, &scales, m);
        }
        solution.minimum = minimum;
        solution.velocity = (0..n).map(|k| scaled[(k, 0)] * scales[k]).collect();
        solution
    }

    /// [`LeastEnergySolution::row_sensitivity`] of the velocities `scaled` at unit closing speed, in scaled coordinates.
    fn row_sensitivity(
        &self,
        mass: &Mat<f64>,
        row: &Mat<f64>,
        scaled: &Mat<f64>,
        scales: &[f64],
        m: f64,
    ) -> f64 {
        let mut size = row.norm_l2();
        let (rows, n) = self.constraints.shape();
        if rows > 0 && self.constraints.amax() > 0.0 {
            // Mu + Aᵀλ = jᵀ for a unit impulse, with u = v/m̄.
            let momentum = mass * scaled * faer::Scale(1.0 / m);
            let forces = row.transpose() - &momentum;
            let transposed = self.transposed_constraints(scales);
            let multipliers = transposed.col_piv_qr().solve_lstsq(&forces);
            let norm = |i: usize| (0..n).map(|k| transposed[(k, i)].powi(2)).sum::<f64>().sqrt();
            size += (0..rows).map(|i| multipliers[(i, 0)].abs() * norm(i)).sum::<f64>();
        }
        2.0 * scaled.norm_l2() * size
    }

    /// Aᵀ in scaled coordinates.
    fn transposed_constraints(&self, scales: &[f64]) -> Mat<f64> {
        let (m, n) = self.constraints.shape();
        Mat::from_fn(n, m, |r, c| self.constraints[(c, r)] * scales[r])
    }

    /// True if the energy changes along a direction classified as massless: its gradient zᵀMv exceeds the rounding of
    /// the entries of M, including entries omitted from the factor.
    fn massless_couples(&self, scales: &[f64], found: &LeastSquaresResult) -> bool {
        let n = self.row.len();
        let momentum: Vec<f64> = (0..n)
            .map(|r| (0..n).map(|c| self.mass[(r, c)] * scales[r] * scales[c] * found.velocity[(c, 0)]).sum())
            .collect();
        let roots: Vec<f64> = (0..n).map(|k| scales[k] * self.mass_size[k].abs().sqrt()).collect();
        let moving: f64 = (0..n).map(|k| roots[k] * found.velocity[(k, 0)].abs()).sum();
        (0..found.massless_motions.ncols()).any(|i| {
            let z = found.massless_motions.col(i);
            let gradient: f64 = (0..n).map(|k| z[k] * momentum[k]).sum();
            // Every component of z is rounded relative to the largest.
            let size: f64 = roots.iter().sum::<f64>() * z.iter().fold(0.0, |most: f64, z| most.max(z.abs()));
            gradient.abs() > ROUTE_ROUNDINGS * f64::EPSILON * n as f64 * size * moving
        })
    }

    /// True if coordinate `k` moves mass, beyond the rounding of its diagonal entry.
    fn has_mass(&self, k: usize) -> bool {
        self.mass[(k, k)].abs() > 4.0 * f64::EPSILON * self.mass_size[k]
    }

    /// Scales with v_k = scale_k w_k, such that M has a unit diagonal. Massless coordinates are scaled by their
    /// lengths and a typical mass.
    fn scales(&self) -> Vec<f64> {
        let typical = (0..self.row.len())
            .filter(|&k| self.has_mass(k))
            .map(|k| self.mass[(k, k)].abs() / (self.lengths[k] * self.lengths[k]))
            .fold(0.0, f64::max);
        let typical = if typical > 0.0 { typical.sqrt() } else { 1.0 };
        let scale = |k: usize| {
            if self.has_mass(k) {
                1.0 / self.mass[(k, k)].abs().sqrt()
            } else {
                1.0 / (self.lengths[k] * typical)
            }
        };
        (0..self.row.len()).map(scale).collect()
    }

    /// Orthonormal basis of ker A in the scaled coordinates.
    fn constraint_kernel(&self, scales: &[f64]) -> Mat<f64> {
        let (m, n) = self.constraints.shape();
        // The pivoted QR of faer returns NaN for a zero matrix.
        if m == 0 || self.constraints.amax() == 0.0 {
            return Mat::identity(n, n);
        }
        let q = self.transposed_constraints(scales).col_piv_qr().compute_Q();
        q.get(.., m.min(n)..).to_owned()
    }

    /// |j N| / |size of the terms of j|, with coordinates scaled by lengths.
    fn closing_speed(&self, kernel: &Mat<f64>, scales: &[f64]) -> f64 {
        let n = self.row.len();
        let size: f64 = (0..n).map(|k| (self.row_size[k] / self.lengths[k]).powi(2)).sum::<f64>().sqrt();
        if kernel.ncols() == 0 || size == 0.0 {
            return 0.0;
        }
        if self.constraints.nrows() == 0 {
            return (0..n).map(|k| (self.row[k] / self.lengths[k]).powi(2)).sum::<f64>().sqrt() / size;
        }
        interruption::check();
        // The same space scaled by lengths: the columns of the kernel are made orthonormal in this scaling.
        let stretched = Mat::from_fn(n, kernel.ncols(), |r, c| kernel[(r, c)] * scales[r] * self.lengths[r]);
        let q = stretched.qr().compute_thin_Q();
        let row = Mat::from_fn(1, n, |_, c| self.row[c] / self.lengths[c]);
        (&row * &q).norm_l2() / size
    }

    /// Cholesky factorisation with diagonal pivoting. A pivot counts as zero below the rounding of its own diagonal
    /// entry: n ε, or more if the entry is a small difference of large terms.
    fn factor(&self, mass: &Mat<f64>) -> MassFactor {
        let n = mass.nrows();
        let tolerance = |k: usize| {
            let cancelled = if self.has_mass(k) { self.mass_size[k] / self.mass[(k, k)].abs() } else { 1.0 };
            f64::EPSILON * 4.0 * (n as f64 + cancelled)
        };
        let mut remaining: Vec<f64> = (0..n).map(|k| mass[(k, k)]).collect();
        let mut rows: Vec<Vec<f64>> = Vec::with_capacity(n);
        let mut done = vec![false; n];
        loop {
            let open = (0..n).filter(|&k| !done[k] && remaining[k] > tolerance(k));
            let Some(pivot) = open.max_by(|&a, &b| remaining[a].total_cmp(&remaining[b])) else { break };
            interruption::check();
            let root = remaining[pivot].sqrt();
            let mut row = vec![0.0; n];
            for k in (0..n).filter(|&k| !done[k]) {
                let known: f64 = rows.iter().map(|r| r[pivot] * r[k]).sum();
                row[k] = (mass[(pivot, k)] - known) / root;
            }
            row[pivot] = root;
            done[pivot] = true;
            for k in (0..n).filter(|&k| !done[k]) {
                remaining[k] -= row[k] * row[k];
            }
            rows.push(row);
        }
        let negative = (0..n).any(|k| !done[k] && remaining[k] < -INDEFINITE_PIVOT * tolerance(k));
        MassFactor { transpose: Mat::from_fn(rows.len(), n, |r, c| rows[r][c]), negative }
    }
}

/// m̄ = 1/(j M⁻¹ jᵀ) by Cholesky, and the velocities of least energy at unit closing speed. `mass`: M; `row`: j, both without
/// constraints.
fn formula(mass: &Mat<f64>, row: &Mat<f64>) -> (Minimum, Mat<f64>) {
    use faer::linalg::solvers::Solve;
    match mass.llt(Side::Lower) {
        Ok(llt) => {
            let mut response = llt.solve(row.transpose());
            let inverse = (row * &response)[(0, 0)];
            response *= faer::Scale(1.0 / inverse);
            (Minimum::Finite(1.0 / inverse), response)
        }
        // The pivoted factorisation was complete, so only the last bits differ.
        Err(_) => stationary_minimum(mass, &Mat::identity(mass.nrows(), mass.nrows()), row),
    }
}

/// Stationary value 1/(j_N (NᵀMN)⁻¹ j_Nᵀ) for an indefinite M.
fn stationary_minimum(mass: &Mat<f64>, kernel: &Mat<f64>, row: &Mat<f64>) -> (Minimum, Mat<f64>) {
    use faer::linalg::solvers::Solve;
    let reduced = kernel.transpose() * mass * kernel;
    let reduced_row = row * kernel;
    let mut response = reduced.lblt(Side::Lower).solve(reduced_row.transpose());
    let inverse = (&reduced_row * &response)[(0, 0)];
    response *= faer::Scale(1.0 / inverse);
    (Minimum::Stationary(1.0 / inverse), kernel * response)
}

/// Result of the least-squares problem, in scaled coordinates.
struct LeastSquaresResult {
    minimum: Minimum,
    velocity: Mat<f64>,
    /// True if some motion has zero energy.
    has_massless_motion: bool,
    /// Motions with zero energy, in scaled coordinates.
    massless_motions: Mat<f64>,
}

/// min ‖Lᵀ(v₀ + Z z)‖² with v₀ along j, and Z the admissible motions that do not close the gap.
fn least_squares(factor: &Mat<f64>, kernel: &Mat<f64>, row: &Mat<f64>) -> LeastSquaresResult {
    let along = (row * kernel).transpose().to_owned();
    let norm = along.norm_l2();
    let particular = kernel * &along * faer::Scale(1.0 / (norm * norm));
    let motions = kernel * along.qr().compute_Q().get(.., 1..);
    interruption::check();
    let rows = factor.nrows();
    let target = factor * &particular;
    let energies = factor * &motions;
    // No free motions, or only massless ones (the pivoted QR of faer returns NaN for a zero matrix).
    if energies.norm_max() == 0.0 {
        let minimum = minimum(target.squared_norm_l2(), norm, rows);
        return LeastSquaresResult {
            minimum,
            velocity: particular,
            has_massless_motion: motions.ncols() > 0,
            massless_motions: motions,
        };
    }
    let qr = energies.col_piv_qr();
    let r = qr.R();
    let size = rows.min(motions.ncols());
    let rank = (0..size).take_while(|&i| r[(i, i)].abs() > ROOT_ENERGY).count();
    interruption::check();
    let rotated = qr.compute_Q().transpose() * &target;
    let energy: f64 = (rank..rows).map(|i| rotated[(i, 0)].powi(2)).sum();
    let order = qr.P().arrays().0;
    let mut weights: Mat<f64> = Mat::zeros(motions.ncols(), 1);
    for i in (0..rank).rev() {
        let known: f64 = (i + 1..rank).map(|c| r[(i, c)] * weights[(order[c], 0)]).sum();
        weights[(order[i], 0)] = (-rotated[(i, 0)] - known) / r[(i, i)];
    }
    let velocity = particular + &motions * weights;
    // Each remaining motion, combined with the motions of nonzero pivot such that its energy is zero.
    let mut follow: Mat<f64> = Mat::zeros(motions.ncols(), motions.ncols() - rank);
    for (k, column) in (rank..motions.ncols()).enumerate() {
        interruption::check();
        follow[(order[column], k)] = 1.0;
        for i in (0..rank).rev() {
            let known: f64 = (i + 1..rank).map(|c| r[(i, c)] * follow[(order[c], k)]).sum();
            follow[(order[i], k)] = (-r[(i, column)] - known) / r[(i, i)];
        }
    }
    let open = motions * follow;
    LeastSquaresResult {
        minimum: minimum(energy, norm, rows),
        velocity,
        has_massless_motion: open.ncols() > 0,
        massless_motions: open,
    }
}

/// Classifies `energy` at unit closing speed; `norm` is the closing speed of a unit motion along j.
fn minimum(energy: f64, norm: f64, rows: usize) -> Minimum {
    let relative = energy * norm * norm;
    if relative <= f64::EPSILON * rows.max(1) as f64 { Minimum::Massless } else { Minimum::Finite(energy) }
}

/// Condition number of a mass matrix scaled to unit diagonal; `None` if singular.
pub(crate) fn condition_of(mass: &DMatrix<f64>) -> Option<f64> {
    let n = mass.nrows();
    if n == 0 || (0..n).any(|k| mass[(k, k)] <= 0.0) {
        return None;
    }
    let scale: Vec<f64> = (0..n).map(|k| 1.0 / mass[(k, k)].sqrt()).collect();
    condition(Mat::from_fn(n, n, |r, c| mass[(r, c)] * scale[r] * scale[c]).as_ref())
}

/// λ_max/λ_min of a symmetric matrix with unit diagonal.
fn condition(mass: MatRef<'_, f64>) -> Option<f64> {
    let values = mass.self_adjoint_eigenvalues(Side::Lower).ok()?;
    let (least, most) = (values.first()?, values.last()?);
    // Beyond this limit the smallest eigenvalue is rounding.
    (*least > f64::EPSILON * mass.nrows() as f64 * most).then_some(most / least)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn solve(mass: DMatrix<f64>, constraints: DMatrix<f64>, row: &[f64]) -> LeastEnergySolution {
        let constraints = independent(&constraints);
        let mass_size: Vec<f64> = (0..row.len()).map(|k| mass[(k, k)].abs().max(1e-3)).collect();
        let row_size: Vec<f64> = row.iter().map(|x: &f64| x.abs().max(1e-3)).collect();
        let lengths = vec![1.0; row.len()];
        LeastEnergy {
            mass: &mass,
            mass_size: &mass_size,
            constraints: &constraints,
            row,
            row_size: &row_size,
            lengths: &lengths,
        }
        .solve()
    }

    /// Independent rows of `constraints`; a zero matrix is returned unchanged.
    fn independent(constraints: &DMatrix<f64>) -> DMatrix<f64> {
        let (m, n) = constraints.shape();
        if m == 0 || constraints.amax() == 0.0 {
            return constraints.clone();
        }
        let qr = Mat::from_fn(n, m, |r, c| constraints[(c, r)]).col_piv_qr();
        let rank = (0..m.min(n)).take_while(|&i| qr.R()[(i, i)].abs() > 1e-10).count();
        constraints.select_rows(&qr.P().arrays().0[..rank])
    }

    fn none(n: usize) -> DMatrix<f64> {
        DMatrix::zeros(0, n)
    }

    /// A general 3×3 mass matrix.
    fn general() -> DMatrix<f64> {
        DMatrix::from_row_slice(3, 3, &[4.0, 1.0, -0.5, 1.0, 3.0, 0.7, -0.5, 0.7, 2.0])
    }

    fn finite(solution: &LeastEnergySolution) -> f64 {
        match solution.minimum {
            Minimum::Finite(m) => m,
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn a_constraint_row_is_a_dropped_coordinate() {
        let row = [1.0, -2.0, 0.5];
        let locked = solve(general(), DMatrix::from_row_slice(1, 3, &[0.0, 0.0, 3.0]), &row);
        let dropped = solve(general().view((0, 0), (2, 2)).into(), none(2), &row[..2]);
        assert!((finite(&locked) / finite(&dropped) - 1.0).abs() < 1e-14);
        // A repeated row is redundant and changes nothing.
        let twice = DMatrix::from_row_slice(2, 3, &[0.0, 0.0, 3.0, 0.0, 0.0, -1.0]);
        let twice = solve(general(), twice, &row);
        assert!((finite(&twice) / finite(&dropped) - 1.0).abs() < 1e-14);
    }

    #[test]
    fn least_squares_and_the_formula_agree() {
        let row = [1.0, -2.0, 0.5];
        let by_formula = solve(general(), none(3), &row);
        // A row of zeros imposes no constraint, but selects the general path.
        let general_way = solve(general(), DMatrix::zeros(1, 3), &row);
        assert!((finite(&general_way) / finite(&by_formula) - 1.0).abs() < 1e-14);
        for (a, b) in general_way.velocity.iter().zip(&by_formula.velocity) {
            assert!((a - b).abs() < 1e-14);
        }
        assert!(!general_way.has_massless_motion);
    }

    #[test]
    fn outcomes_are_told_apart() {
        let point = DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, 0.0]);
        assert_eq!(solve(point.clone(), none(2), &[0.0, 1.0]).minimum, Minimum::Massless);
        let beside = solve(point.clone(), none(2), &[2.0, 0.0]);
        assert!((finite(&beside) - 0.25).abs() < 1e-16 && beside.has_massless_motion);
        assert_eq!(solve(point, none(2), &[0.0, 0.0]).minimum, Minimum::Immovable);
        assert_eq!(solve(DMatrix::zeros(0, 0), none(0), &[]).minimum, Minimum::Immovable);
        let held = solve(general(), DMatrix::identity(3, 3), &[1.0, 2.0, 3.0]);
        assert_eq!(held.minimum, Minimum::Immovable);
        assert_eq!(solve(DMatrix::zeros(2, 2), none(2), &[1.0, 0.0]).minimum, Minimum::Massless);
    }

    #[test]
    fn a_massless_link_between_two_masses_is_exact() {
        // Two collinear prismatic joints: the first moves no mass of its own, the second 3 kg. M = 3 [1 1; 1 1].
        let mass = DMatrix::from_element(2, 2, 3.0);
        let tip = solve(mass.clone(), none(2), &[1.0, 1.0]);
        assert!((finite(&tip) - 3.0).abs() < 1e-14 && tip.has_massless_motion);
        assert_eq!(solve(mass, none(2), &[1.0, 0.0]).minimum, Minimum::Massless);
    }

    #[test]
    fn an_indefinite_mass_matrix_is_said_to_be_one() {
        let mass = DMatrix::from_row_slice(2, 2, &[1.0, 2.0, 2.0, 1.0]);
        let Minimum::Stationary(m) = solve(mass, none(2), &[1.0, 0.0]).minimum else { panic!() };
        assert!((m - -3.0).abs() < 1e-13); // 1/(M⁻¹)₁₁ = det/M₂₂
    }
}
