//! Commands about impacts: rigid impact, safe speed.

pub(crate) mod rigid_impact;
pub(crate) mod safe_speed;
