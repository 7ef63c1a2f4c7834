//! URDF and URDF+ files.

pub(crate) mod closing_pairs;
pub(crate) mod consistency;
pub(crate) mod elements;
pub(crate) mod load;
pub(crate) mod loops;
pub(crate) mod references;
pub(crate) mod texts;
pub(crate) mod write;
