//! Numerical thresholds of this crate.

/// Sensitivity to the open multipliers, relative to a unit multiplier, above which a component of a reaction is
/// indeterminate. Sensitivities of determinate components are rounding: about 1e-15 for exact files.
pub const OPEN_COMPONENT: f64 = 1e-9;

/// Factor by which the accuracy of the constraint rows, divided by the smallest relative singular value, is multiplied
/// to give the same threshold for rounded files. The null space of the rows has errors of this size.
pub const OPEN_PER_FLOOR: f64 = 30.0;

/// Upper limit of the threshold: above it a component of order 1 would count as determinate.
pub const MOST_OPEN: f64 = 1e-2;

/// Part of an open combination of multipliers, relative to the largest part, above which the combination involves a
/// constraint. Parts of uninvolved constraints are rounding.
pub const INVOLVED: f64 = 1e-6;

/// Ratio of the pivots of the driver rows to the largest, above which a freedom is determined by the given rates.
pub const DETERMINED: f64 = 1e-9;

/// Residual of given rates, relative to the largest displacement rate, above which they are inadmissible. Values
/// typed with six digits are accepted.
pub const INADMISSIBLE: f64 = 1e-5;

/// Change of a joint's reaction over the characteristic length, relative to the reaction, below which the contact
/// point has no influence.
pub const NO_INFLUENCE: f64 = 1e-12;

/// Energy of an admissible motion, relative to the largest of a motion of the same displacement, below which the
/// motion is massless.
pub const MASSLESS_ENERGY: f64 = 1e-13;

/// Displacement of a joint in a massless motion of unit displacement, above which its rate is undetermined.
pub const UNDETERMINED: f64 = 1e-6;

/// Distance of the mobility matrix from rank one, relative to its norm, up to which a contact has one relative motion:
/// rounding of matrices of linkages, and the misfit of files with nine digits.
pub const ONE_MOTION: f64 = 1e-8;
