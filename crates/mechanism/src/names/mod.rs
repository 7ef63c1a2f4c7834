//! Names of parts: look-up errors with suggestions, and the mark of a name in an index.

mod lookup;
pub(crate) mod name_mark;

pub(crate) use lookup::write_near;
pub use lookup::{NameKind, UnknownName, near_names};
