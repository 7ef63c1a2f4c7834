//! Text of the generated code.

mod c_source;
mod c_test;
mod c_text;
mod description;
mod expression_text;
mod rust_source;
mod rust_text;

pub use description::GeneratedFile;

use crate::function::Functions;
use crate::request::{Language, Request};

/// Generated code.
#[derive(Clone, Debug)]
pub struct Generated {
    /// Files: header, source and self-test, or one Rust file.
    pub files: Vec<GeneratedFile>,
    /// Number of arithmetic operations of one configuration, without sines and cosines.
    pub operations: usize,
    /// Number of pairs of sine and cosine.
    pub angles: usize,
    /// Number of positions.
    pub positions: usize,
    /// Number of reference values in the self-test.
    pub references: usize,
}

/// Prints the functions of a request.
pub(crate) fn print(request: &Request, functions: &Functions) -> Generated {
    let files = match request.language {
        Language::C => c_source::files(request, functions),
        Language::Rust => rust_source::files(request, functions),
    };
    let statements = functions.mass_statements();
    Generated {
        files,
        operations: statements.operations,
        angles: statements.angles.len(),
        positions: functions.tree.inputs,
        references: functions.references().len(),
    }
}
