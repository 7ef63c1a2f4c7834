//! Shared parts of the test suites: cases, motions, velocities from differences of poses, and a gauge of the worst
//! deviation. For tests only: invalid cases panic.

pub mod answer;
pub mod bench;
pub mod cases;
pub mod coverage;
pub mod differences;
pub mod imposed;
pub mod judge;
mod measures;
pub mod motion;
pub mod readers;
pub mod rig;
pub mod routes;
pub mod subjects;

pub use measures::{gauge, tally};
