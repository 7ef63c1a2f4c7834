//! Models as loaded from files, and changes of them.

pub(crate) mod changes;
pub(crate) mod loading;
pub(crate) mod record;
pub(crate) mod sheet;
