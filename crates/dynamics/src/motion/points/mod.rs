//! Points: velocity of any point, lowest point of a wheel.

pub(crate) mod lowest_point;
pub(crate) mod point_velocity;
