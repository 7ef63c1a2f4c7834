//! URDF to a [`Mechanism`](percuss_mechanism::Mechanism), with diagnostics that say where; and back.
//!
//! [`load`] works in five steps, each of which may refuse the file:
//!
//! 1. the bytes are text, not too many, and bounded in tags, nesting and entities (before any parser runs);
//! 2. roxmltree makes a tree with positions;
//! 3. [the table of the dialect](crate#the-dialect) says of every element and attribute what becomes of it;
//! 4. every number and reference is checked, and a clean extract of the standard part is given to `urdf-rs`,
//!    which turns it into values;
//! 5. the mechanism's builder checks the whole; what it finds is given its place in the file.
//!
//! # The dialect
//! Plain URDF 1.0 to 1.2. What has no bearing on the mechanics (looks, sensors, controllers, simulator settings)
//! is passed over in silence; what is not known is passed over with a warning; what would change the answer and
//! is not supported is an error. The table is `src/dialect.rs`.
//!
//! This crate knows no dynamics.

mod armature;
mod diagnostic;
mod dialect;
mod geometry;
mod joint;
mod link;
mod load;
mod numbers;
mod origin;
mod prescan;
mod references;
mod report;
mod source;
mod standard;
mod survey;
mod write;

pub use diagnostic::{Diagnostic, LoadError};
pub use load::{LoadOptions, Loaded, load};
pub use source::{DEFAULT_MAX_SIZE, Source};
pub use write::write_urdf;
