//! How a group can move: its rank, decided once, which coordinates depend, who drives, which rows are redundant.

mod drivers;
mod elimination;
mod rank;
mod redundancy;
mod singularity;

pub(crate) use drivers::Drivers;
pub(crate) use elimination::{GroupMobility, MobilityRoom, Rates, rank_of_rows};
pub(crate) use rank::{Rank, decide, singular_values};
pub(crate) use redundancy::Redundancy;
pub use singularity::Singularity;
pub(crate) use singularity::{Generic, independent_rows};
