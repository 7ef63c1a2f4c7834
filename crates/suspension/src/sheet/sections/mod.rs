//! Sections that a sheet names itself: contacts and bushes.

pub(super) mod bushes;
pub(super) mod contacts;
