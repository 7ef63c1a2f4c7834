#![doc = include_str!("../README.md")]
//!
//! [`generate`] evaluates the elimination of the mass matrix on expressions ([`Request`] describes the mechanism and
//! the contact). Constants are folded, operations with 0 and 1 vanish, and equal expressions are computed once.

mod error;
mod expression;
mod function;
mod loops;
mod mechanics;
mod printing;
mod request;
mod samples;

pub use error::GenerateError;
pub use printing::{Generated, GeneratedFile};
pub use request::{Additions, HeldPoint, Language, Request};

/// Generates the source files of a request.
///
/// # Errors
/// [`GenerateError`]: the contact has no finite m̄, or the mechanism is not supported.
pub fn generate(request: &Request) -> Result<Generated, GenerateError> {
    let functions = function::build(request)?;
    Ok(printing::print(request, &functions))
}
