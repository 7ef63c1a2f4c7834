//! Assembly of loops: facts computed once, and the closed pose at a configuration.

mod error;
mod facts;
mod reach;
mod state;

pub use error::AssemblyError;
pub(crate) use facts::{Facts, GroupFacts};
pub(crate) use reach::{Closer, Start};
pub use state::LoopState;
