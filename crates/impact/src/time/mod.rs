//! Impact in time: equations of motion with a compliant contact, and their integration.

pub(crate) mod compliant;
pub(crate) mod conditions;
pub(crate) mod equations;
pub(crate) mod history;
pub(crate) mod impact_in_time;
pub(crate) mod motion_forces;
