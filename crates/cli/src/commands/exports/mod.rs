//! Commands that write a mechanism in another form.

pub(crate) mod convert;
pub(crate) mod explore;
pub(crate) mod export;
pub(crate) mod generate;
