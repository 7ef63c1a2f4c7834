//! The joint that drives a travel.

use percuss_dynamics::Configuration;
use percuss_mechanism::JointId;

/// A joint that is driven, and where the others are wanted.
#[derive(Debug)]
pub(crate) struct Driver {
    pub joint: JointId,
    pub base: Configuration,
}
