//! Closing of a group of loops: correction, path following, and poses at crossings of branches.

mod branch;
mod chart;
mod correct;
mod crossing;
mod tolerance;
mod uncertainty;

pub(crate) use branch::DriverPath;
pub(crate) use correct::{Correction, Directions, Linearised};
