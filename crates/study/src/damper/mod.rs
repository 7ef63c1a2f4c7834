//! Damping of a contact or joint stop for a coefficient of restitution.

pub(crate) mod compliance;
pub(crate) mod curvature;
pub(crate) mod damped_contact;
pub(crate) mod damping;
pub(crate) mod joint_stop;
pub(crate) mod penetration;
pub(crate) mod response;
pub(crate) mod restitution;
pub(crate) mod sheet_forces;
pub(crate) mod simulators;
