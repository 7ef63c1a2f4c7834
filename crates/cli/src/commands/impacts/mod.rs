//! Commands about impacts: rigid impact, safe speed.

mod bearings;
mod compliant;
pub(crate) mod extremes;
pub(crate) mod identify;
pub(crate) mod in_time;
pub(crate) mod reflected;
pub(crate) mod response;
pub(crate) mod restitution;
pub(crate) mod rigid_impact;
pub(crate) mod safe_speed;
pub(crate) mod simultaneous;
