//! Sources, diagnostics, and limits of input, for all readers of model files.

pub(crate) mod diagnostic;
pub(crate) mod document;
pub mod encoding;
pub(crate) mod files;
pub(crate) mod findings;
pub(crate) mod limits;
pub(crate) mod plugins;
pub(crate) mod prescan;
pub(crate) mod report;
pub(crate) mod source;
pub(crate) mod tolerance;
pub(crate) mod unique_names;
pub(crate) mod xml;

pub use limits::{LONGEST_NAME, MOST_FINDINGS, OBLIQUE_PINS};
pub use report::{Place, Report, cut, quoted, shortened};
