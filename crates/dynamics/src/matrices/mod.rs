//! m̄ of matrices that the caller has already: M, A and j of a solver of his own.

mod checks;
mod rank;
mod view;

pub use checks::{MatrixError, MatrixName};
pub use rank::ConstraintRank;
pub use view::{LayoutError, MatrixView};

use self::checks::Mass;
use self::rank::RankLimits;
use crate::careful::{LeastEnergy, Minimum, Solution};
use crate::outcome::{EffectiveMass, Remark};
use crate::tolerances::{
    FEW_DIGITS, FEW_DIGITS_TRIALS, FLOOR_ACCURACY, IMMOVABLE, MOVED_SAFETY, NEARLY_IMMOVABLE,
    NEGLIGIBLE_MASS, NOTHING_LEFT, RANK_FLOOR, RANK_ROUNDING, SUM_ROUNDINGS,
};
use faer::Mat;
use faer::linalg::solvers::SolveLstsq;
use nalgebra::{DMatrix, DVector};

/// Options for reading the caller's matrices. The default: every length 1, a rank floor of 1e-10, entries exact to a rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MatrixOptions<'a> {
    lengths: Option<&'a [f64]>,
    rank_floor: Option<f64>,
    accuracy: Accuracy,
    row_noise: Option<f64>,
}

/// Relative error of every entry, by matrix.
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

    /// The larger relative error of A and j, which both decide whether the gap closes.
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
    /// The default.
    pub fn new() -> Self {
        Self::default()
    }

    /// How coordinates are scaled where ranks are decided, and whether the gap closes at all: for each, how far a unit rate
    /// of it moves things, in one unit for all. Metres for a slide given in metres (1), a typical length for an angle in
    /// radians. Default: 1 for all, the coordinates as they are. Lengths decide only what is zero: no finite m̄ depends on
    /// them beyond rounding.
    pub fn lengths(self, lengths: &'a [f64]) -> Self {
        Self { lengths: Some(lengths), ..self }
    }

    /// Singular values of A below this part of the largest count as zero, with every row of A scaled to a largest entry
    /// of about 1; above 0, at most 0.1. Default: 1e-10, or 10 times the [accuracy](Self::accuracy) of A where that is more. With the
    /// default, a dropped singular value above rounding (3e-13, or 10 times the accuracy) makes the rank unclear.
    pub fn rank_floor(self, floor: f64) -> Self {
        Self { rank_floor: Some(floor), ..self }
    }

    /// Relative error of every entry of M, A and j, from 0 to 1e-3. The rank of A, the outcome and the stated error depend on it.
    /// Default: 2.2e-16, a rounding. Matrices that were held in single precision have 6e-8. Give it too where entries are
    /// small differences of large terms.
    pub fn accuracy(self, accuracy: f64) -> Self {
        Self { accuracy: Accuracy::all(accuracy), ..self }
    }

    /// The same of one matrix alone, after [`accuracy`](Self::accuracy).
    pub fn accuracy_of(mut self, matrix: MatrixName, accuracy: f64) -> Self {
        match matrix {
            MatrixName::Mass => self.accuracy.mass = accuracy,
            MatrixName::Constraints => self.accuracy.constraints = accuracy,
            MatrixName::ContactRow => self.accuracy.row = accuracy,
        }
        self
    }

    /// Rows of A whose entries are all at most this count as rows of zeros; in the unit of A, entries divided by lengths.
    /// Default: 1e-14 of the largest entry of the rows that bind the same coordinates. A row that only holds the rounding of
    /// larger terms that cancel (the out-of-plane rows of a plane loop in space, for example) looks like a constraint in small
    /// units: matrices do not tell the two apart. With 0 every row that is not zero counts.
    pub fn row_noise(self, noise: f64) -> Self {
        Self { row_noise: Some(noise), ..self }
    }
}

/// The answer to [`effective_mass`].
#[derive(Clone, Debug, PartialEq)]
pub struct MatrixResponse {
    /// m̄, or why it is not finite.
    pub effective_mass: EffectiveMass,
    /// Bound on the error of m̄ by the accuracy of the entries and by rounding, kg. `None` unless m̄ is finite; `None` too if m̄
    /// is not finite with entries that are off by their accuracy, and if the rank of A is unclear.
    pub error: Option<f64>,
    /// v*: the velocities at unit closing speed, in the units of the caller's coordinates; zero where immovable.
    pub velocity: Vec<f64>,
    /// How many motions A leaves: coordinates − rank.
    pub degrees_of_freedom: usize,
    /// Which rows of A count.
    pub rank: ConstraintRank,
    /// What the reader should know.
    pub remarks: Vec<Remark>,
}

/// Effective mass along a contact row of a system that is given by its matrices, in the unit of M (kg).
///
/// m̄ = min { vᵀMv : Av = 0, jv = 1 }; 1/(j M⁻¹ jᵀ) where M is regular and there is no A.
///
/// | symbol | meaning                           | shape | unit                               |
/// |--------|-----------------------------------|-------|------------------------------------|
/// | M      | mass matrix, symmetric, ≥ 0        | n×n   | kg, kg·m, kg·m²                    |
/// | j      | closing speed per rate            | 1×n   | m, 1                               |
/// | A      | Jacobian of the constraints       | m×n   | any: rows may differ by up to 1e13 |
///
/// Every matrix is read where it lies, in any layout ([`MatrixView`]). The outcomes are those of
/// [`Pose::respond`](crate::Pose::respond): a value, `Immovable` (no motion with Av = 0 closes the gap), `Massless` (one
/// without energy does). M may be singular, rows of A may be redundant. Nothing is added to M, and nothing is cut off
/// but rounding: a pivot of M scaled to unit diagonal counts as zero below 4(nε + accuracy).
///
/// Each row of A is scaled by itself before the rank is decided, so the unit of a row has no influence. A row of zeros
/// constrains nothing, and neither does a row of rounding alone, below [`MatrixOptions::row_noise`];
/// [`ConstraintRank::small_rows`] lists rows that may be rounding. Columns are scaled by
/// [`MatrixOptions::lengths`] only.
///
/// The stated error is to first order, at the response: entries of M off by their accuracy times √(M_rr M_cc), those of A and j by
/// their accuracy times themselves, and the roundings of the method, δm̄ = v*ᵀδM v* + 2λᵀδA v* − 2m̄ δj v* with M v* + Aᵀλ = m̄jᵀ.
/// M may differ from its transpose by 1e-9 of √(M_rr M_cc); the mean is taken, and the difference enters the error.
///
/// Cost: O(n³ + m n²); up to 1000 coordinates. Source: as [`Pose::respond`](crate::Pose::respond)'s.
///
/// # Errors
/// [`MatrixError`]: shapes that do not fit; numbers that are none; a mass matrix that is not symmetric or not positive
/// semi-definite; options out of range.
///
/// ```
/// use percuss_dynamics::{EffectiveMass, MatrixOptions, MatrixView, effective_mass};
///
/// // Two carts of 2 kg and 3 kg, coupled so that they move together; the first is struck.
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
    let decided = rank::decide_rows(constraints, &lengths, &limits);
    let asked = Asked {
        mass: &mass,
        row: row.as_slice(),
        rows: &decided.rows,
        least: decided.least,
        lengths: &lengths,
        accuracy,
    };
    asked.answer(decided.report)
}

/// Matrices that are in order.
struct Asked<'a> {
    mass: &'a Mass,
    row: &'a [f64],
    /// The rows of A that count.
    rows: &'a DMatrix<f64>,
    /// The least singular value that counts, as a part of the largest.
    least: f64,
    lengths: &'a [f64],
    accuracy: Accuracy,
}

impl Asked<'_> {
    fn answer(&self, rank: ConstraintRank) -> Result<MatrixResponse, MatrixError> {
        let n = self.row.len();
        let solution = self.solve();
        let closing_speed = self.closing_speed();
        // Rows that hardly differ leave so much of a closing speed open.
        let open = FLOOR_ACCURACY * self.accuracy.of_rows() / self.least;
        let mut remarks = Vec::new();
        if solution.massless_directions > 0 {
            remarks.push(Remark::MasslessMotions { directions: solution.massless_directions });
        }
        let mut effective_mass = match solution.minimum {
            _ if closing_speed <= IMMOVABLE.max(open) => EffectiveMass::Immovable,
            Minimum::Finite(m) => EffectiveMass::Finite(m),
            // Pivots see a negative energy that is too small for eigenvalues.
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
                    // The energy that is left is rounding.
                    effective_mass = EffectiveMass::Massless;
                    remarks.push(Remark::MasslessToRounding { up_to: m + off });
                } else {
                    error = self.moved_by_accuracy(m).map(|moved| off.max(MOVED_SAFETY * moved));
                }
                if !rank.is_clear {
                    // The bound holds for the rank that was decided, and the rank may be another.
                    error = None;
                }
                if solution.closing_speed < NEARLY_IMMOVABLE {
                    let uncertainty = 2.0 * self.accuracy.of_rows() / solution.closing_speed;
                    remarks
                        .push(Remark::NearlyImmovable { closing_speed: solution.closing_speed, uncertainty });
                }
                if solution.is_open {
                    remarks.push(Remark::UndeterminedMotion);
                }
            }
            EffectiveMass::Massless => {
                if !velocity.iter().all(|v| v.is_finite()) {
                    return Err(MatrixError::NotRepresentable);
                }
                // A motion that all but has no energy may miss the constraints by its own rounding: so much what meets them has.
                let missed: f64 = self.roots(&self.correction(&velocity)).iter().sum();
                let up_to = (self.energy_off(&velocity).sqrt() + missed).powi(2);
                if up_to > NEGLIGIBLE_MASS * self.mass.typical {
                    remarks.push(Remark::MasslessToRounding { up_to });
                }
            }
            EffectiveMass::Immovable => {
                velocity = vec![0.0; n];
                // Above rounding: the gap may close, far more slowly than is decided.
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

    /// Largest change of m̄ if the entries of M, A and j are off by their accuracy, in signs that follow no pattern; `None` if m̄ is no longer
    /// finite. Losses of the method beyond first order show here.
    fn moved_by_accuracy(&self, m: f64) -> Option<f64> {
        // The fewer digits the entries have, the more is lost beyond first order.
        let trials =
            if self.accuracy.mass.max(self.accuracy.of_rows()) > FEW_DIGITS { FEW_DIGITS_TRIALS } else { 1 };
        (0..trials)
            .map(|trial| self.moved_by(m, trial))
            .try_fold(0.0, |most, moved| Some(f64::max(most, moved?)))
    }

    /// The same for one pattern of signs.
    fn moved_by(&self, m: f64, trial: usize) -> Option<f64> {
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
        match (Asked { mass: &mass, rows: &rows, row: &row, ..*self }).solve().minimum {
            Minimum::Finite(other) => Some((other - m).abs()),
            Minimum::Stationary(_) | Minimum::Immovable | Minimum::Massless => None,
        }
    }

    fn solve(&self) -> Solution {
        // What a diagonal entry is off by counts as so many roundings of it.
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

    /// |j restricted to ker A| / |j|, coordinates scaled by lengths: masses have no influence.
    fn closing_speed(&self) -> f64 {
        let (rows, n) = self.rows.shape();
        let mut along = Mat::from_fn(n, 1, |k, _| self.row[k] / self.lengths[k]);
        let size = along.norm_l2();
        if size == 0.0 || rows >= n {
            return 0.0;
        }
        if rows > 0 {
            let q = Mat::from_fn(n, rows, |k, r| self.rows[(r, k)] / self.lengths[k]).qr().compute_thin_Q();
            // Twice: the first time leaves the rounding of what it takes away.
            for _ in 0..2 {
                let taken = &q * (q.transpose() * &along);
                along -= taken;
            }
        }
        along.norm_l2() / size
    }

    /// The roundings of the method, as a part of what it works with: a backward error.
    fn roundings(&self) -> f64 {
        SUM_ROUNDINGS * self.row.len().max(1) as f64 * f64::EPSILON
    }

    /// √M_kk |v_k|, coordinate by coordinate.
    fn roots(&self, v: &[f64]) -> Vec<f64> {
        v.iter().enumerate().map(|(k, v)| self.mass.matrix[(k, k)].sqrt() * v.abs()).collect()
    }

    /// The shortest change, coordinates scaled by lengths, after which a motion has Av = 0 and jv = 1.
    fn correction(&self, v: &[f64]) -> Vec<f64> {
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

    /// What vᵀMv may be off by, kg.
    fn energy_off(&self, v: &[f64]) -> f64 {
        let root: f64 = self.roots(v).iter().sum();
        let noise: f64 = self.mass.noise.iter().map(|(r, c, m)| 2.0 * (m * v[*r] * v[*c]).abs()).sum();
        (self.mass.accuracy + self.roundings()) * root * root + noise
    }

    /// What m̄ may be off by, kg, to first order.
    fn error(&self, m: f64, v: &[f64]) -> f64 {
        let scales = self.scales();
        let speed: f64 = v.iter().zip(&scales).map(|(v, s)| (v / s) * (v / s)).sum::<f64>().sqrt();
        // A row that is off: in its entries, and by the roundings of an orthogonal elimination, norm by norm.
        let off = |entry: &dyn Fn(usize) -> f64, accuracy: f64| {
            let terms: f64 = v.iter().enumerate().map(|(k, v)| (entry(k) * v).abs()).sum();
            let norm = scales.iter().enumerate().map(|(k, s)| (entry(k) * s).powi(2)).sum::<f64>().sqrt();
            accuracy * terms + self.roundings() * norm * speed
        };
        let mut sum = self.energy_off(v) + 2.0 * m * off(&|k| self.row[k], self.accuracy.row);
        for (r, multiplier) in self.multipliers(m, v, &scales).into_iter().enumerate() {
            sum += 2.0 * multiplier.abs() * off(&|k| self.rows[(r, k)], self.accuracy.constraints);
        }
        // A motion that misses the constraints by its own rounding: so much more has one that meets them.
        let missed: f64 = self.roots(&self.correction(v)).iter().sum();
        sum + 2.0 * m.sqrt() * missed + missed * missed
    }

    /// Scales in which M has a unit diagonal; coordinates without mass are scaled as the least that has one.
    fn scales(&self) -> Vec<f64> {
        let typical = if self.mass.typical > 0.0 { self.mass.typical } else { 1.0 };
        let scale = |k: usize| {
            let own = self.mass.matrix[(k, k)];
            let mass = if own > 0.0 { own } else { typical * self.lengths[k] * self.lengths[k] };
            1.0 / mass.sqrt()
        };
        (0..self.row.len()).map(scale).collect()
    }

    /// λ with M v + Aᵀλ = m̄jᵀ, one for each row that counts, in least squares over scaled coordinates.
    fn multipliers(&self, m: f64, v: &[f64], scales: &[f64]) -> Vec<f64> {
        let (rows, n) = self.rows.shape();
        if rows == 0 {
            return Vec::new();
        }
        let momentum = &self.mass.matrix * DVector::from_column_slice(v);
        let columns = Mat::from_fn(n, rows, |k, r| self.rows[(r, k)] * scales[k]);
        let target = Mat::from_fn(n, 1, |k, _| (m * self.row[k] - momentum[k]) * scales[k]);
        let found = columns.qr().solve_lstsq(&target);
        (0..rows).map(|r| found[(r, 0)]).collect()
    }
}
