//! Errors of batches.

use crate::kinematics::contact::ContactError;

/// Error of a batch run.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum BatchError {
    /// Too few numbers for the configurations.
    #[error(
        "{got} numbers are given; {configurations} configurations of {positions} positions, {stride} apart, need {needed}"
    )]
    Short {
        /// Number of given values.
        got: usize,
        /// Number of required values.
        needed: usize,
        /// Number of configurations.
        configurations: usize,
        /// Number of positions per configuration.
        positions: usize,
        /// The stride.
        stride: usize,
    },
    /// The stride is too small; configurations would overlap.
    #[error("the stride is {stride}; expected at least {least}")]
    Stride {
        /// The given stride.
        stride: usize,
        /// The smallest valid stride.
        least: usize,
    },
    /// The columns of the results have different lengths.
    #[error("columns of {masses} masses and {other} other results; expected columns of one length")]
    Columns {
        /// Length of the column of masses.
        masses: usize,
        /// Length of another column.
        other: usize,
    },
    /// Wrong number of gradients or inverse inertias.
    #[error(
        "there is room for {got} numbers; expected {width} for each of the {configurations} configurations"
    )]
    DerivativeCount {
        /// Number of places.
        got: usize,
        /// Required numbers per configuration.
        width: usize,
        /// Number of configurations.
        configurations: usize,
    },
    /// Wrong number of contact points or normals.
    #[error(
        "{points} numbers of points and {normals} of normals are given; expected three for each of the {configurations} \
         configurations, or three for all"
    )]
    ContactCount {
        /// Number of given coordinates of points.
        points: usize,
        /// Number of given coordinates of normals.
        normals: usize,
        /// Number of configurations.
        configurations: usize,
    },
    /// An invalid contact of a configuration.
    #[error("configuration {configuration}: {error}")]
    Contact {
        /// Index of the configuration.
        configuration: usize,
        /// The reason.
        error: ContactError,
    },
    /// Normals of the configurations are given for a contact whose normal is along a line.
    #[error(
        "the normal of the contact is along a line between two points; normals for each configuration need a contact with a \
         fixed normal"
    )]
    NormalAlongLine,
    /// A number that is not finite.
    #[error("configuration {configuration}: number {number} is {value}; expected finite numbers")]
    NotFinite {
        /// Index of the configuration.
        configuration: usize,
        /// Index of the number in the configuration.
        number: usize,
        /// The number.
        value: f64,
    },
    /// Given positions of another mechanism.
    #[error(
        "{got} positions of all joints are given, and position {largest} is set; expected {width} positions"
    )]
    GivenPositions {
        /// Number of positions of all joints, as given.
        got: usize,
        /// Largest index that a row gives.
        largest: usize,
        /// Number of positions of the mechanism.
        width: usize,
    },
}

impl BatchError {
    /// The error with the index of its configuration among all rows; `first`: index of the first row of the run.
    #[must_use]
    pub fn in_rows_from(self, first: usize) -> Self {
        match self {
            Self::Contact { configuration, error } => {
                Self::Contact { configuration: first + configuration, error }
            }
            Self::NotFinite { configuration, number, value } => {
                Self::NotFinite { configuration: first + configuration, number, value }
            }
            other => other,
        }
    }
}
