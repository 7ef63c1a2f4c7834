//! Questions and reports of the command line.

pub(crate) mod damping;
pub(crate) mod kinematics;
pub mod question;
pub(crate) mod reports;
