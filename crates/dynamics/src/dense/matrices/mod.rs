//! m̄ from matrices of the caller: M, A and j of another solver.

mod checks;
mod rank;
mod regular;
mod view;

pub use checks::{MatrixError, MatrixName};
pub use rank::ConstraintRank;
pub use regular::RegularMatrices;
pub use view::{LayoutError, MatrixView};

use self::checks::Mass;
use self::rank::RankLimits;
use crate::dense::direct::{LeastEnergy, LeastEnergySolution, Minimum};
use crate::kinematics::outcome::{EffectiveMass, Remark};
use crate::model::interruption;
use crate::tolerances::{
    FEW_DIGITS, FEW_DIGITS_TRIALS, FLOOR_ACCURACY, IMMOVABLE, MOVED_SAFETY, NEARLY_IMMOVABLE,
    NEGLIGIBLE_MASS, NOTHING_LEFT, RANK_FLOOR, RANK_ROUNDING, SUM_ROUNDINGS,
};
use faer::Mat;
use faer::linalg::solvers::SolveLstsq;
use nalgebra::{DMatrix, DVector};

/// Options for interpreting the caller's matrices. Default: all lengths 1, a rank threshold of 1e-10, entries
/// accurate to one rounding.
#[must_use]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MatrixOptions<'a> {
    lengths: Option<&'a [f64]>,
    rank_floor: Option<f64>,
    accuracy: Accuracy,
    row_noise: Option<f64>,
}

/// Relative error of the entries of each matrix.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Accuracy {
    mass: f64,
    constraints: f64,
    row: f64,
}

impl Accuracy {
    fn all(accuracy: f64) -> Self {
        Self { mass: accuracy, constraints: accuracy, row: accuracy }
    }

    /// Larger relative error of A and j. Both matrices decide if the gap closes.
    fn of_rows(self) -> f64 {
        self.constraints.max(self.row)
    }
}

impl Default for MatrixOptions<'_> {
    fn default() -> Self {
        Self { lengths: None, rank_floor: None, accuracy: Accuracy::all(f64::EPSILON), row_noise: None }
    }
}

impl<'a> MatrixOptions<'a> {
    /// The default options.
    pub fn new() -> Self {
        Self::default()
    }

    /// Sets the lengths that scale the coordinates in decisions about ranks and about the closing of the gap. The
    /// length of a coordinate is the displacement caused by a unit rate, in a common unit for all coordinates: 1 for
    /// a translation in metres, a typical length in metres for an angle in radians. Default: 1 for all, without
    /// scaling. Lengths only decide which values count as zero; a finite m̄ does not depend on lengths beyond
    /// rounding.
    pub fn lengths(self, lengths: &'a [f64]) -> Self {
        Self { lengths: Some(lengths), ..self }
    }

    /// Sets the threshold for singular values of A relative to the largest; smaller values count as zero. Every row
    /// of A is first scaled to a largest entry of about 1. The threshold must be above 0 and at most 0.1. Default:
    /// 1e-10, or 10 times the [accuracy](Self::accuracy) of A if larger. With the default, a dropped singular value
    /// above rounding (3e-13, or 10 times the accuracy) makes the rank unclear.
    pub fn rank_floor(self, floor: f64) -> Self {
        Self { rank_floor: Some(floor), ..self }
    }

    /// Sets the relative error of every entry of M, A and j, from 0 to 1e-3. The rank of A, the outcome and the
    /// stated error depend on this value. Default: 2.2e-16, one rounding. Matrices stored in single precision have
    /// 6e-8. Entries that are small differences of large terms also need a larger value.
    pub fn accuracy(self, accuracy: f64) -> Self {
        Self { accuracy: Accuracy::all(accuracy), ..self }
    }

    /// Sets the relative error of the entries of one matrix. Must be called after [`accuracy`](Self::accuracy).
    pub fn accuracy_of(mut self, matrix: MatrixName, accuracy: f64) -> Self {
        match matrix {
            MatrixName::Mass => self.accuracy.mass = accuracy,
            MatrixName::Constraints => self.accuracy.constraints = accuracy,
            MatrixName::ContactRow => self.accuracy.row = accuracy,
        }
        self
    }

    /// Sets the noise level of rows of A: rows with all entries at or below this level count as zero. The unit is the
    /// unit of A, with entries divided by lengths. Default: 1e-14 of the largest entry of the rows that share
    /// coordinates. A row that contains only the rounding of larger cancelling terms looks like a constraint in small
    /// units, for example the out-of-plane rows of a planar loop in space. The matrices alone do not distinguish
    /// these cases. With 0, every nonzero row counts.
    pub fn row_noise(self, noise: f64) -> Self {
        Self { row_noise: Some(noise), ..self }
    }
}

/// Result of [`effective_mass`].
#[must_use]
#[derive(Clone, Debug, PartialEq)]
pub struct MatrixResponse {
    /// m̄, or the reason for m̄ not being finite.
    pub effective_mass: EffectiveMass,
    /// Error bound of m̄ from the accuracy of the entries and from rounding, kg. `None` if m̄ is not finite, if m̄ is
    /// not finite for entries perturbed by their accuracy, or if the rank of A is unclear.
    pub error: Option<f64>,
    /// v*: velocities at unit closing speed, in the units of the caller's coordinates; zero if immovable.
    pub velocity: Vec<f64>,
    /// Degrees of freedom left by A: coordinates − rank.
    pub degrees_of_freedom: usize,
    /// Rank of A, with its redundant rows.
    pub rank: ConstraintRank,
    /// Findings about the result.
    pub remarks: Vec<Remark>,
}

/// Effective mass along a contact row, for a system given by its matrices, in the unit of M (kg).
///
/// m̄ = min { vᵀMv : Av = 0, jv = 1 }; 1/(j M⁻¹ jᵀ) for a regular M without A.
///
/// | symbol | meaning                           | shape | unit                               |
/// |--------|-----------------------------------|-------|------------------------------------|
/// | M      | mass matrix, symmetric, ≥ 0        | n×n   | kg, kg·m, kg·m²                    |
/// | j      | closing speed per rate            | 1×n   | m, 1                               |
/// | A      | Jacobian of the constraints       | m×n   | any: rows may differ by up to 1e13 |
///
/// Every matrix is read in place, in any layout ([`MatrixView`]). The outcomes are those of
/// [`Pose::respond`](crate::Pose::respond): a value, `Immovable` (no motion with Av = 0 closes the gap), or
/// `Massless` (a motion without kinetic energy closes the gap). M may be singular, and rows of A may be redundant. M
/// is not regularised. Only rounding is cut off: a pivot of M scaled to unit diagonal counts as zero below 4(nε +
/// accuracy).
///
/// Each row of A is scaled separately before the rank decision, so the unit of a row has no influence. Two kinds of
/// rows impose no constraint: rows of zeros, and rows of rounding below [`MatrixOptions::row_noise`].
/// [`ConstraintRank::small_rows`] lists rows that may be rounding. Columns are scaled by [`MatrixOptions::lengths`]
/// only.
///
/// The stated error is of first order, at the response. It includes errors of the entries of M by their accuracy
/// times √(M_rr M_cc), errors of the entries of A and j by their accuracy times their magnitude, and the roundings of
/// the method: δm̄ = v*ᵀδM v* + 2λᵀδA v* − 2m̄ δj v* with M v* + Aᵀλ = m̄jᵀ. M may differ from its transpose by 1e-9
/// of √(M_rr M_cc). The mean of both is used, and the difference is included in the error.
///
/// Cost: O(n³ + m n²); up to 1000 coordinates. Source: as for [`Pose::respond`](crate::Pose::respond).
///
/// # Errors
/// [`MatrixError`]: shapes that do not fit, entries that are not valid numbers, a mass matrix that is not symmetric
/// or not positive semi-definite, options out of range.
///
/// ```
/// use percuss_dynamics::{EffectiveMass, MatrixOptions, MatrixView, effective_mass};
///
/// // Two carts of 2 kg and 3 kg, coupled to move together; the contact is on the first cart.
/// let mass = MatrixView::row_major(&[2.0, 0.0, 0.0, 3.0], 2, 2)?;
/// let coupled = MatrixView::from(&[1.0, -1.0][..]);
/// let response = effective_mass(mass, &[1.0, 0.0][..], Some(coupled), &MatrixOptions::new())?;
/// let EffectiveMass::Finite(m) = response.effective_mass else { unreachable!() };
/// assert!((m - 5.0).abs() <= response.error.unwrap());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn effective_mass<'a>(
    mass: impl Into<MatrixView<'a>>,
    row: impl Into<MatrixView<'a>>,
    constraints: Option<MatrixView<'a>>,
    options: &MatrixOptions<'_>,
) -> Result<MatrixResponse, MatrixError> {
    let (mass, row) = (mass.into(), row.into());
    let n = checks::shapes(&mass, &row, constraints.as_ref())?;
    let MatrixOptions { rank_floor, row_noise, accuracy: given, .. } = *options;
    checks::options(
        rank_floor.unwrap_or(RANK_FLOOR),
        row_noise.unwrap_or(0.0),
        [given.mass, given.constraints, given.row],
    )?;
    let lengths = checks::lengths(options.lengths, n)?;
    let least = |accuracy: f64| accuracy.max(f64::EPSILON);
    let accuracy =
        Accuracy { mass: least(given.mass), constraints: least(given.constraints), row: least(given.row) };
    let matrix = checks::entries(MatrixName::Mass, &mass)?;
    let row = checks::entries(MatrixName::ContactRow, &row)?;
    let constraints = match &constraints {
        Some(a) => checks::entries(MatrixName::Constraints, a)?,
        None => DMatrix::zeros(0, n),
    };
    let mass = Mass::new(matrix, &lengths, accuracy.mass)?;
    let rounding = FLOOR_ACCURACY * accuracy.constraints;
    let limits = RankLimits {
        floor: rank_floor.unwrap_or(RANK_FLOOR).max(rounding),
        rounding: rank_floor.unwrap_or(RANK_ROUNDING).max(rounding),
        row_noise,
    };
    interruption::check();
    let decided = rank::decide_rows(constraints, &lengths, &limits);
    interruption::check();
    let problem = MatrixProblem {
        mass: &mass,
        row: row.as_slice(),
        rows: &decided.rows,
        least: decided.least,
        lengths: &lengths,
        accuracy,
    };
    problem.respond(decided.report)
}

/// Validated matrices.
struct MatrixProblem<'a> {
    mass: &'a Mass,
    row: &'a [f64],
    /// Independent rows of A.
    rows: &'a DMatrix<f64>,
    /// Smallest nonzero singular value, relative to the largest.
    least: f64,
    lengths: &'a [f64],
    accuracy: Accuracy,
}

impl MatrixProblem<'_> {
    /// Computes m̄, its error and the findings.
    fn respond(&self, rank: ConstraintRank) -> Result<MatrixResponse, MatrixError> {
        let n = self.row.len();
        let solution = self.solve();
        let closing_speed = self.closing_speed();
        // Nearly dependent rows leave this uncertainty of the closing speed.
        let open = FLOOR_ACCURACY * self.accuracy.of_rows() / self.least;
        let mut remarks = Vec::new();
        if solution.massless_directions > 0 {
            remarks.push(Remark::MasslessMotions { directions: solution.massless_directions });
        }
        let mut effective_mass = match solution.minimum {
            _ if closing_speed <= IMMOVABLE.max(open) => EffectiveMass::Immovable,
            Minimum::Finite(m) => EffectiveMass::Finite(m),
            // The pivots reveal a negative energy that is too small for the eigenvalue check.
            Minimum::Stationary(m) if m > 0.0 => EffectiveMass::Finite(m),
            Minimum::Stationary(_) => {
                return Err(MatrixError::Indefinite { eigenvalue: -self.mass.accuracy, least: 0.0 });
            }
            Minimum::Immovable => EffectiveMass::Immovable,
            Minimum::Massless => EffectiveMass::Massless,
        };
        let mut velocity = solution.velocity.clone();
        let mut error = None;
        match effective_mass {
            EffectiveMass::Finite(m) => {
                let off = self.error(m, &velocity);
                if !(m.is_normal() && off.is_finite() && velocity.iter().all(|v| v.is_finite())) {
                    return Err(MatrixError::NotRepresentable);
                }
                if off > NOTHING_LEFT * m {
                    // The remaining energy is only rounding.
                    effective_mass = EffectiveMass::Massless;
                    remarks.push(Remark::MasslessToRounding { up_to: m + off });
                } else {
                    error = self.change_by_accuracy(m).map(|moved| off.max(MOVED_SAFETY * moved));
                }
                // The bound holds for the decided rank, and for massless motions without a mass below rounding.
                if !rank.is_clear || solution.massless_couples {
                    error = None;
                }
                if solution.closing_speed < NEARLY_IMMOVABLE {
                    let uncertainty = 2.0 * self.accuracy.of_rows() / solution.closing_speed;
                    remarks
                        .push(Remark::NearlyImmovable { closing_speed: solution.closing_speed, uncertainty });
                }
                if solution.has_massless_motion {
                    remarks.push(Remark::UndeterminedMotion);
                }
            }
            EffectiveMass::Massless => {
                if !velocity.iter().all(|v| v.is_finite()) {
                    return Err(MatrixError::NotRepresentable);
                }
                // A motion of almost zero energy may violate the constraints by its own rounding. `missed` bounds the
                // root energy of its correction.
                let missed: f64 = self.roots(&self.shortest_correction(&velocity)).iter().sum();
                let up_to = (self.energy_error(&velocity).sqrt() + missed).powi(2);
                if up_to > NEGLIGIBLE_MASS * self.mass.typical {
                    remarks.push(Remark::MasslessToRounding { up_to });
                }
            }
            EffectiveMass::Immovable => {
                velocity = vec![0.0; n];
                // Above rounding: the gap may close, at a speed far below the threshold.
                if closing_speed > RANK_ROUNDING {
                    let uncertainty = open / closing_speed;
                    remarks.push(Remark::NearlyImmovable { closing_speed, uncertainty });
                }
            }
        }
        if let Some(gap) = rank.gap.filter(|_| !rank.is_clear) {
            remarks.push(Remark::UnclearRank { gap });
        }
        Ok(MatrixResponse {
            effective_mass,
            error,
            velocity,
            degrees_of_freedom: n - rank.rank,
            rank,
            remarks,
        })
    }

    /// Largest change of m̄ if the entries of M, A and j are perturbed by their accuracy with irregular signs. `None`
    /// if m̄ becomes infinite or undefined. Reveals losses of the method beyond first order.
    fn change_by_accuracy(&self, m: f64) -> Option<f64> {
        // Entries with fewer digits cause larger losses beyond first order.
        let trials =
            if self.accuracy.mass.max(self.accuracy.of_rows()) > FEW_DIGITS { FEW_DIGITS_TRIALS } else { 1 };
        (0..trials)
            .map(|trial| self.change_by_signs(m, trial))
            .try_fold(0.0, |most, moved| Some(f64::max(most, moved?)))
    }

    /// |Change of m̄| (kg) if the entries of M, A and j change by their accuracies, with pattern number `trial` of signs. `None`
    /// if m̄ is then not a finite minimum.
    fn change_by_signs(&self, m: f64, trial: usize) -> Option<f64> {
        let factor = |r: usize, c: usize, accuracy: f64| {
            1.0 + [1.0, -1.0, 0.5, -0.5][(7 * r + 3 * c + r * c + trial * (5 * r + c + 1)) % 4] * accuracy
        };
        let mut mass =
            Mass { matrix: self.mass.matrix.clone(), noise: self.mass.noise.clone(), ..*self.mass };
        for r in 0..mass.matrix.nrows() {
            for c in 0..=r {
                mass.matrix[(r, c)] *= factor(r, c, self.mass.accuracy);
                mass.matrix[(c, r)] = mass.matrix[(r, c)];
            }
        }
        let Accuracy { constraints, row, .. } = self.accuracy;
        let rows = DMatrix::from_fn(self.rows.nrows(), self.rows.ncols(), |r, c| {
            self.rows[(r, c)] * factor(r + 1, c, constraints)
        });
        let row: Vec<f64> = self.row.iter().enumerate().map(|(c, j)| j * factor(0, c, row)).collect();
        match (MatrixProblem { mass: &mass, rows: &rows, row: &row, ..*self }).solve().minimum {
            Minimum::Finite(other) => Some((other - m).abs()),
            Minimum::Stationary(_) | Minimum::Immovable | Minimum::Massless => None,
        }
    }

    /// Solves the least-energy problem.
    fn solve(&self) -> LeastEnergySolution {
        interruption::check();
        // The error of a diagonal entry, expressed in roundings.
        let scale = self.mass.accuracy / f64::EPSILON;
        let mass_size: Vec<f64> = self.mass.matrix.diagonal().iter().map(|m| m.abs() * scale).collect();
        let row_size: Vec<f64> = self.row.iter().map(|j| j.abs()).collect();
        LeastEnergy {
            mass: &self.mass.matrix,
            mass_size: &mass_size,
            constraints: self.rows,
            row: self.row,
            row_size: &row_size,
            lengths: self.lengths,
        }
        .solve()
    }

    /// |j restricted to ker A| / |j|, with coordinates scaled by lengths. Masses have no influence.
    fn closing_speed(&self) -> f64 {
        let (rows, n) = self.rows.shape();
        let mut along = Mat::from_fn(n, 1, |k, _| self.row[k] / self.lengths[k]);
        let size = along.norm_l2();
        if size == 0.0 || rows >= n {
            return 0.0;
        }
        if rows > 0 {
            let q = Mat::from_fn(n, rows, |k, r| self.rows[(r, k)] / self.lengths[k]).qr().compute_thin_Q();
            // The second pass removes the rounding of the first.
            for _ in 0..2 {
                let taken = &q * (q.transpose() * &along);
                along -= taken;
            }
        }
        along.norm_l2() / size
    }

    /// Roundings of the method as a relative backward error.
    fn roundings(&self) -> f64 {
        SUM_ROUNDINGS * self.row.len().max(1) as f64 * f64::EPSILON
    }

    /// √M_kk |v_k| for each coordinate.
    fn roots(&self, v: &[f64]) -> Vec<f64> {
        v.iter().enumerate().map(|(k, v)| self.mass.matrix[(k, k)].sqrt() * v.abs()).collect()
    }

    /// Shortest change (coordinates scaled by lengths) after which a motion satisfies Av = 0 and jv = 1.
    fn shortest_correction(&self, v: &[f64]) -> Vec<f64> {
        interruption::check();
        let (rows, n) = self.rows.shape();
        let entry = |r: usize, k: usize| if r < rows { self.rows[(r, k)] } else { self.row[k] };
        let left = |r: usize| {
            let sum: f64 = (0..n).map(|k| entry(r, k) * v[k]).sum();
            if r < rows { -sum } else { 1.0 - sum }
        };
        let qr = Mat::from_fn(n, rows + 1, |k, r| entry(r, k) / self.lengths[k]).qr();
        let (q, r) = (qr.compute_thin_Q(), qr.thin_R());
        let mut parts: Vec<f64> = Vec::with_capacity(rows + 1);
        for i in 0..=rows {
            let known: f64 = parts.iter().enumerate().map(|(c, part)| r[(c, i)] * part).sum();
            parts.push((left(i) - known) / r[(i, i)]);
        }
        let scaled = |k: usize| (0..=rows).map(|c| q[(k, c)] * parts[c]).sum::<f64>() / self.lengths[k];
        (0..n).map(scaled).collect()
    }

    /// Error of vᵀMv, kg.
    fn energy_error(&self, v: &[f64]) -> f64 {
        let root: f64 = self.roots(v).iter().sum();
        let noise: f64 = self.mass.noise.iter().map(|(r, c, m)| 2.0 * (m * v[*r] * v[*c]).abs()).sum();
        (self.mass.accuracy + self.roundings()) * root * root + noise
    }

    /// First-order error of m̄, kg.
    fn error(&self, m: f64, v: &[f64]) -> f64 {
        interruption::check();
        let scales = self.scales();
        let speed: f64 = v.iter().zip(&scales).map(|(v, s)| (v / s) * (v / s)).sum::<f64>().sqrt();
        // Error of a row: errors of its entries, plus the roundings of an orthogonal elimination in terms of norms.
        let off = |entry: &dyn Fn(usize) -> f64, accuracy: f64| {
            let terms: f64 = v.iter().enumerate().map(|(k, v)| (entry(k) * v).abs()).sum();
            let norm = scales.iter().enumerate().map(|(k, s)| (entry(k) * s).powi(2)).sum::<f64>().sqrt();
            accuracy * terms + self.roundings() * norm * speed
        };
        let mut sum = self.energy_error(v) + 2.0 * m * off(&|k| self.row[k], self.accuracy.row);
        for (r, multiplier) in self.multipliers(m, v, &scales).into_iter().enumerate() {
            sum += 2.0 * multiplier.abs() * off(&|k| self.rows[(r, k)], self.accuracy.constraints);
        }
        // A motion that violates the constraints by its own rounding has less energy than the corrected motion;
        // `missed` bounds the root of the difference.
        let missed: f64 = self.roots(&self.shortest_correction(v)).iter().sum();
        sum + 2.0 * m.sqrt() * missed + missed * missed
    }

    /// Scales for which M has a unit diagonal. Coordinates without mass use their length and a typical mass.
    fn scales(&self) -> Vec<f64> {
        let typical = if self.mass.typical > 0.0 { self.mass.typical } else { 1.0 };
        let scale = |k: usize| {
            let own = self.mass.matrix[(k, k)];
            let mass = if own > 0.0 { own } else { typical * self.lengths[k] * self.lengths[k] };
            1.0 / mass.sqrt()
        };
        (0..self.row.len()).map(scale).collect()
    }

    /// λ with M v + Aᵀλ = m̄jᵀ for each independent row, in the least-squares sense over scaled coordinates.
    fn multipliers(&self, m: f64, v: &[f64], scales: &[f64]) -> Vec<f64> {
        let (rows, n) = self.rows.shape();
        if rows == 0 {
            return Vec::new();
        }
        interruption::check();
        let momentum = &self.mass.matrix * DVector::from_column_slice(v);
        let columns = Mat::from_fn(n, rows, |k, r| self.rows[(r, k)] * scales[k]);
        let target = Mat::from_fn(n, 1, |k, _| (m * self.row[k] - momentum[k]) * scales[k]);
        let found = columns.qr().solve_lstsq(&target);
        (0..rows).map(|r| found[(r, 0)]).collect()
    }
}
