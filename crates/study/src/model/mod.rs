//! Models as loaded from files, and changes of them.

pub(crate) mod changes;
pub(crate) mod conversion;
pub(crate) mod loading;
pub(crate) mod named_states;
pub(crate) mod record;
pub(crate) mod sheet;
pub(crate) mod wheel_points;
