//! The thresholds of the builder, each with its unit and its reason.

/// The largest number of a description, in its own SI unit. Larger ones are not a mechanism, and their products, up to
/// the third power, would overflow at 1.8e308.
pub(crate) const LARGEST_NUMBER: f64 = 1e100;

/// The largest |RᵀR − 1| of a rotation matrix given from outside, dimensionless: a matrix written with nine decimals is
/// within it.
pub(crate) const ROTATION_DEFECT: f64 = 1e-9;

/// The largest | |axis| − 1 | without a note, dimensionless. Files with four decimals stay below it; beyond, the axis
/// may be a mistake.
pub(crate) const AXIS_NORM_SLACK: f64 = 1e-4;

/// The largest component of an axis that counts as zero, dimensionless: below it the axis is not a direction but an
/// underflow, and its square would be zero.
pub(crate) const SHORTEST_AXIS: f64 = 1e-100;

/// The largest | |axis| − 1 | of an axis that is kept to the last bit, dimensionless: the rounding of a norm.
pub(crate) const UNIT_ROUNDING: f64 = 4.0 * f64::EPSILON;

/// How many unknown names get suggestions: each is compared with all known names, so that the cost is quadratic.
pub(crate) const MOST_SUGGESTIONS: usize = 20;

/// Slack of principal moments as a part of the largest, dimensionless: real files carry eight or nine digits, and
/// point masses and rods lie on the boundary.
pub(crate) const MOMENT_SLACK: f64 = 1e-9;

/// Slack of principal moments as a part of m·size², dimensionless: a smaller moment is rounding of the parallel-axis
/// theorem.
pub(crate) const STEINER_SLACK: f64 = 1e-12;
