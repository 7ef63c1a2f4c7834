//! Impact in time of a mechanism with elastic bushes and gears, linear about the touch.

mod flow;
pub(crate) mod forces;
pub(crate) mod impact;
mod peaks;
