//! Rust code without the standard library.
use super::GeneratedFile;
use crate::function::Functions;
use crate::request::Request;

/// Files of the Rust code.
pub(super) fn files(_request: &Request, _functions: &Functions) -> Vec<GeneratedFile> {
    Vec::new()
}
