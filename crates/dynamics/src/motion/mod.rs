//! Motion at a pose: velocities, travels, limits, inertia and accelerations.

pub(crate) mod advance;
pub(crate) mod constraint_action;
pub(crate) mod forward_dynamics;
pub(crate) mod gap;
pub(crate) mod joint_frames;
pub(crate) mod limits;
pub(crate) mod mass_gradient;
pub(crate) mod nearby_designs;
pub(crate) mod operational_inertia;
pub(crate) mod points;
pub(crate) mod rigid_body;
pub(crate) mod travel;
pub(crate) mod travel_search;
