//! The thresholds of route C and of the oracle's assembler. All are dimensionless.

/// The contact cannot close when |jZ| is at most this part of |j| (DESIGN §1).
pub(crate) const IMMOVABLE: f64 = 1e-10;
/// A column of W Z is a motion without mass when its norm is below this part of the largest row: masses span at most
/// twelve decades, their roots six, and rounding leaves 1e-15 to 1e-14.
pub(crate) const MASSLESS_COLUMN: f64 = 1e-12;
/// The minimum vanishes when |W v*| is below this part of max|Wᵢ| |v*|.
pub(crate) const MASSLESS: f64 = 1e-11;
/// The largest singular value of unit rows up to which all of them are rounding, a hundred times over.
pub(crate) const ZERO_ROWS: f64 = 1e-12;
/// A principal moment below this part of the moments about the link's origin is rounding of the parallel-axis theorem.
pub(crate) const STEINER_ROUNDING: f64 = 32.0 * f64::EPSILON;
/// The least threshold of rank, as a part of the largest singular value (DESIGN §4).
pub(crate) const RANK_THRESHOLD: f64 = 1e-10;
/// The threshold of rank over the residual of the loops: a decade above what the residual can cause.
pub(crate) const RANK_PER_RESIDUAL: f64 = 10.0;
/// The largest residual over the size of a position that counts as closed enough for a question.
pub(crate) const LARGEST_RESIDUAL: f64 = 1e-3;
/// The residual over the size at which loops are closed: some hundred roundings.
pub(crate) const CLOSED: f64 = 1e-13;
/// Step of the differences over the size: the errors h²/6 and ε/h are 1e-11 both.
pub(crate) const DIFFERENCE_STEP: f64 = 1e-5;
/// A singular value of the Jacobian below this part of the largest is an error of the differences.
pub(crate) const DIFFERENCE_NOISE: f64 = 1e-9;
/// Most accepted steps of the assembler.
pub(crate) const MOST_ROUNDS: usize = 200;
/// Most attempts at one step, each with ten times the damping: from the least damping they reach the largest singular
/// value.
pub(crate) const MOST_ATTEMPTS: usize = 12;
/// Damping of the first step, as a part of the largest singular value.
pub(crate) const FIRST_DAMPING: f64 = 1e-3;
/// Damping after a rejected step, at least.
pub(crate) const LEAST_DAMPING: f64 = 1e-12;
/// Damping below which a step is undamped: its square is lost in rounding.
pub(crate) const NO_DAMPING: f64 = 1e-16;
/// The part of a driver's range that is one step of a linkage's motion.
pub(crate) const DRIVER_STEP: f64 = 0.05;
/// Most steps of one motion of a linkage.
pub(crate) const MOST_DRIVER_STEPS: f64 = 1e4;
