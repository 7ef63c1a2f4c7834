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

/// Largest size of a link that is the rounding of a coordinate, m.
pub(crate) const LEAST_SIZE: f64 = 1e-6;

/// Smallest number of moving links with equal inertias that may be placeholders: a car has four equal wheels.
pub(crate) const LEAST_EQUAL_LINKS: usize = 4;

/// Smallest part of the moving links with mass that have the same inertia if it is a placeholder, dimensionless.
pub(crate) const EQUAL_SHARE: f64 = 0.7;

/// Ratio of the largest to the smallest size of links from which on they are no equal bodies, dimensionless.
pub(crate) const DIFFERENT_SIZES: f64 = 1.2;
