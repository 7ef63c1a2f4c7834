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

/// Largest radius of gyration, as a part of the reach of the link and of the largest link, without a warning, dimensionless: a
/// wheel that is 4 times as large as any joint offset of its mechanism and has no shape stays below it.
pub(crate) const WIDE_GYRATION: f64 = 3.0;

/// The same for an error: kg·mm² read as kg·m² give 1000 times the radius. The greatest of 104 published files is 16, a base link
/// of 0.1 kg with 1 kg·m².
pub(crate) const FAR_GYRATION: f64 = 30.0;

/// Radius of a solid sphere over its radius of gyration, √(5/2).
pub(crate) const SPHERE_OVER_GYRATION: f64 = 1.581_138_830_084_19;

/// Density from which on no body has this mass and radius of gyration, kg/m³: some ten times that of osmium. Grams read as
/// kilograms give 1000 times the density of the body, or more where the inertia is in kg·m².
pub(crate) const DENSEST: f64 = 2e5;

/// A smaller radius of gyration, as a part of the reach, is that of a point mass, dimensionless.
pub(crate) const LEAST_GYRATION: f64 = 1e-5;
