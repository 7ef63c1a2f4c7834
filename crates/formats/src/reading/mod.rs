//! Sources, diagnostics, and limits of input.

pub(crate) mod diagnostic;
pub(crate) mod limits;
pub(crate) mod prescan;
pub(crate) mod report;
pub(crate) mod source;
