//! Closing a group of loops: one correction, following a branch, a pose where branches cross.

mod branch;
mod chart;
mod correct;
mod crossing;
mod tolerance;
mod uncertainty;

pub(crate) use branch::DriverPath;
pub(crate) use correct::{Correction, Directions, Linearised};
