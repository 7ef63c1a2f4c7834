//! Impact in time: equations of motion with a compliant contact, and their integration.

pub(crate) mod compliant;
pub(crate) mod conditions;
pub(crate) mod equations;
mod events;
pub(crate) mod history;
pub(crate) mod impact_in_time;
mod motion;
pub(crate) mod motion_forces;
mod sampler;
