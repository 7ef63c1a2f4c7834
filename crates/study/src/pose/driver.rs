//! Joint that drives a travel.

use percuss_dynamics::Configuration;
use percuss_mechanism::JointId;

/// Driving joint and the requested configuration of the other joints.
#[derive(Clone, Debug)]
pub(crate) struct Driver {
    pub joint: JointId,
    pub configuration: Configuration,
}
