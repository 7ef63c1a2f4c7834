//! Text on the terminal: results, diagnostics, failures.

pub(crate) mod console;
pub(crate) mod design_changes;
pub(crate) mod diagnostics;
pub(crate) mod escape;
pub(crate) mod explanation;
pub(crate) mod failure;
pub(crate) mod import_text;
pub(crate) mod limits;
pub(crate) mod number;
pub(crate) mod report;
pub(crate) mod text;
pub(crate) mod units;
pub(crate) mod wrap;
