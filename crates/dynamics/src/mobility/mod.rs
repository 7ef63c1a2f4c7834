//! Mobility of a group of constraints: rank, dependent coordinates, driving coordinates, and redundant rows.

mod drivers;
mod elimination;
mod rank;
mod redundancy;
mod singularity;

pub(crate) use drivers::Drivers;
pub(crate) use elimination::{GroupMobility, MobilityWorkspace, Rates, rank_of_rows};
pub(crate) use rank::{Rank, decide_rank, singular_values};
pub(crate) use redundancy::Redundancy;
pub use singularity::Singularity;
pub(crate) use singularity::{Generic, independent_rows};
