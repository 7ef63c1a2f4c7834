//! The pose of a question: driving joints, travels, reachable range, positions in reports.

pub(crate) mod driver;
pub(crate) mod joined_motion;
pub(crate) mod joined_travels;
pub(crate) mod nearest_approach;
pub(crate) mod point_travel;
pub(crate) mod pose_solver;
pub(crate) mod positions;
pub(crate) mod touch;
pub(crate) mod unreachable_range;
