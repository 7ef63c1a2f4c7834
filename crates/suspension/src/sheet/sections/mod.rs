//! Sections of bodies, and those that a sheet names itself: contacts and bushes.

mod bodies;
pub(super) mod bush_file;
pub(super) mod bushes;
pub(super) mod contacts;
pub(super) mod estimates;
pub(super) mod mirror_images;
mod other_side;
mod parts;
mod wheel;
