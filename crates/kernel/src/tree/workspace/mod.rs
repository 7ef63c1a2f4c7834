//! Workspace of the recursion: its layout, and the numbers that bound rounding errors.

mod energy_share;
mod layout;
mod sizes;
mod tracked_sizes;

pub(super) use energy_share::EnergyShare;
pub(super) use layout::{COSINE, Offsets, Places, SINE, SIZES, TWIST, layout, number};
pub(super) use sizes::Sizes;
pub(super) use tracked_sizes::{TrackedSizes, store_sizes, stored_sizes};
