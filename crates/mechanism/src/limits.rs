//! Thresholds of the builder, each with unit and reason.

/// Largest number in a description, in its SI unit. Products of up to three larger numbers could overflow at
/// 1.8e308, and no mechanism needs larger numbers.
pub(crate) const LARGEST_NUMBER: f64 = 1e100;

/// Largest |RᵀR − 1| of a given rotation matrix, dimensionless; a matrix written with nine decimals is within
/// this limit.
pub(crate) const ROTATION_DEFECT: f64 = 1e-9;

/// Largest | |axis| − 1 | without a note, dimensionless. Files with four decimals stay below; a larger
/// deviation may be a mistake.
pub(crate) const AXIS_NORM_SLACK: f64 = 1e-4;

/// Largest component of an axis that counts as zero, dimensionless: the square of a smaller component would
/// underflow.
pub(crate) const SHORTEST_AXIS: f64 = 1e-100;

/// Largest | |axis| − 1 | of an axis that is kept unchanged, dimensionless: the rounding error of a norm.
pub(crate) const UNIT_ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Number of unknown names that get suggestions. Each is compared with all names, at quadratic cost.
pub(crate) const MOST_SUGGESTIONS: usize = 20;

/// Tolerance of principal moments relative to the largest, dimensionless: files have eight or nine digits, and
/// point masses and rods are on the boundary of validity.
pub(crate) const MOMENT_SLACK: f64 = 1e-9;

/// Tolerance of principal moments relative to m·size², dimensionless: smaller moments are rounding errors of
/// the parallel-axis theorem.
pub(crate) const STEINER_SLACK: f64 = 1e-12;
