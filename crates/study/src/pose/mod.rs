//! The pose of a question: driving joints, travels, reachable range, positions in reports.

pub(crate) mod driver;
pub(crate) mod positions;
pub(crate) mod travel;
pub(crate) mod travels;
pub(crate) mod unreachable_range;
