//! The formats of results.

use clap::ValueEnum;

/// Formats of `percuss check`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum CheckFormat {
    /// For people.
    Text,
    /// For programs.
    Json,
}

/// Formats of `percuss mass`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum MassFormat {
    /// For people.
    Text,
    /// For programs.
    Json,
    /// One row with a header, the columns of a sweep.
    Csv,
}
