//! URDF and URDF+ files.

pub(crate) mod closing_pairs;
pub(crate) mod consistency;
pub(crate) mod elements;
#[cfg(feature = "urdf-rs")]
pub(crate) mod from_urdf_rs;
pub(crate) mod load;
pub(crate) mod loops;
pub(crate) mod references;
pub(crate) mod texts;
pub(crate) mod write;
