//! Assembly of loops: facts computed once, and the closed pose at a configuration.

mod closer;
mod error;
mod facts;
mod state;

pub(crate) use closer::{Closer, Start};
pub use error::AssemblyError;
pub(crate) use facts::{Facts, GroupFacts};
pub use state::LoopState;
