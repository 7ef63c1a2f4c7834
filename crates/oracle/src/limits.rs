//! Thresholds of route C and of the assembler for tests; all dimensionless.

/// Ratio |jZ| / |j| up to which the contact is immovable (DESIGN §1).
pub(crate) const IMMOVABLE: f64 = 1e-10;
/// Norm of a column of W Z relative to the largest row, below which the motion has no mass: masses span at most
/// twelve decades, their square roots six, and rounding errors are 1e-15 to 1e-14.
pub(crate) const MASSLESS_COLUMN: f64 = 1e-12;
/// Ratio |W v*| / (max|Wᵢ| |v*|) below which the minimum is zero.
pub(crate) const MASSLESS: f64 = 1e-11;
/// Largest singular value of unit rows that consist of rounding errors, with a factor of 100.
pub(crate) const ZERO_ROWS: f64 = 1e-12;
/// Ratio of a principal moment to the moments about the link's origin, below which the moment is rounding error
/// of the parallel-axis theorem.
pub(crate) const STEINER_ROUNDING: f64 = 32.0 * f64::EPSILON;
/// Smallest rank threshold relative to the largest singular value (DESIGN §4).
pub(crate) const RANK_THRESHOLD: f64 = 1e-10;
/// Ratio of the rank threshold to the loop residual: a decade above the effect of the residual.
pub(crate) const RANK_PER_RESIDUAL: f64 = 10.0;
/// Largest admissible ratio of residual to size of the mechanism for a question.
pub(crate) const LARGEST_RESIDUAL: f64 = 1e-3;
/// Ratio of residual to size at which loops count as closed: some hundred roundings.
pub(crate) const CLOSED: f64 = 1e-13;
/// Step of finite differences relative to the size: the errors h²/6 and ε/h are both 1e-11.
pub(crate) const DIFFERENCE_STEP: f64 = 1e-5;
/// Ratio of singular values of the Jacobian below which the smaller one is an error of the finite differences.
pub(crate) const DIFFERENCE_NOISE: f64 = 1e-9;
/// Limit of accepted steps of the assembler.
pub(crate) const MAX_STEPS: usize = 200;
/// Limit of attempts at one step, each with ten times the damping: enough to increase the damping from the
/// minimum to the largest singular value.
pub(crate) const MAX_ATTEMPTS: usize = 12;
/// Damping of the first step relative to the largest singular value.
pub(crate) const FIRST_DAMPING: f64 = 1e-3;
/// Minimum damping after a rejected step.
pub(crate) const MIN_DAMPING: f64 = 1e-12;
/// Damping below which a step is undamped: the square is below rounding.
pub(crate) const NO_DAMPING: f64 = 1e-16;
/// Step of a driver relative to its range.
pub(crate) const DRIVER_STEP: f64 = 0.05;
/// Limit of the steps of one motion of a linkage.
pub(crate) const MAX_DRIVER_STEPS: f64 = 1e4;
