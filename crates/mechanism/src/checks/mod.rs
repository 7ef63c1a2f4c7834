//! Checks of the parts of a mechanism, and of its whole.

pub(crate) mod bushes;
pub(crate) mod check;
pub(crate) mod closures;
pub(crate) mod contacts;
pub(crate) mod inertias;
pub(crate) mod plausibility;
pub(crate) mod relations;
