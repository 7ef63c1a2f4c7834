//! Text of the generated code.

mod c_source;
mod c_test;
mod c_text;
mod description;
mod expression_text;
mod rust_source;
mod rust_text;

use crate::expression::graph::{Expr, Node};
use crate::expression::statements::Statements;
use crate::function::{Functions, PositionStep};
use crate::request::{Language, Request};
use percuss_mechanism::JointKind;

/// Generated file.
#[derive(Clone, Debug)]
pub struct GeneratedFile {
    /// File name.
    pub name: String,
    /// Content.
    pub text: String,
}

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

/// Inputs that the function of m̄ reads.
fn used_inputs(functions: &Functions, statements: &Statements) -> Vec<usize> {
    let graph = &functions.graph;
    let mut used = Vec::new();
    let mut seen = vec![false; graph.len()];
    let mut stack: Vec<Expr> = functions.mass_results();
    stack.extend(&statements.angles);
    while let Some(expression) = stack.pop() {
        if std::mem::replace(&mut seen[expression.index()], true) {
            continue;
        }
        if let Node::Input(i) = graph.node(expression) {
            used.push(i as usize);
        }
        stack.extend(graph.node(expression).operands());
    }
    used.sort_unstable();
    used
}

/// First input and kind of every joint with a quaternion among Newton steps.
fn quaternion_joints(steps: &[PositionStep]) -> Vec<(usize, JointKind)> {
    let with_quaternion = |step: &&PositionStep| matches!(step.kind, JointKind::Spherical | JointKind::Floating);
    let mut joints: Vec<(usize, JointKind)> =
        steps.iter().filter(with_quaternion).map(|step| (step.first, step.kind)).collect();
    joints.sort_by_key(|(first, _)| *first);
    joints.dedup();
    joints
}
