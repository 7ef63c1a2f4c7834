//! Counts and worst deviations of comparisons.

pub mod gauge;
pub mod tally;
