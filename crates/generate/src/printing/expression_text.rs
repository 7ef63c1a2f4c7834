//! Text of expressions; C and Rust have the same operators.

use crate::expression::graph::{Expr, Graph, Node};
use crate::expression::statements::Statements;
use std::fmt::Write;

/// Names of inputs, sines and cosines.
pub(crate) struct Names<'a> {
    pub input: &'a dyn Fn(usize) -> String,
    pub sine: &'a dyn Fn(usize) -> String,
    pub cosine: &'a dyn Fn(usize) -> String,
    /// Text of a square root.
    pub root: &'a dyn Fn(&str) -> String,
}

/// Printer of the expressions of a list of statements.
pub(crate) struct Printer<'a> {
    pub graph: &'a Graph,
    pub statements: &'a Statements,
    pub names: Names<'a>,
}

/// Binding strength of operators.
const SUM: u8 = 1;
const PRODUCT: u8 = 2;
const SIGN: u8 = 3;
const ATOM: u8 = 4;

/// Literal of a number, the shortest that reads back as the number.
pub(crate) fn literal(value: f64) -> String {
    format!("{value:?}")
}

/// Text of an initialiser with line breaks.
pub(crate) fn wrapped_list(items: &[String], indent: usize) -> String {
    let mut out = String::new();
    let mut width = 0;
    for (k, item) in items.iter().enumerate() {
        let separator = if k + 1 < items.len() { ", " } else { "" };
        if width + item.len() > 100 {
            out.truncate(out.trim_end().len());
            let _ = write!(out, "\n{:indent$}", "");
            width = 0;
        }
        out += item;
        out += separator;
        width += item.len() + separator.len();
    }
    out
}

impl Printer<'_> {
    /// Text of an angle, from inputs and constants.
    pub fn angle(&self, expression: Expr) -> String {
        self.text(expression, 0, false)
    }

    /// Text of a result.
    pub fn result(&self, expression: Expr) -> String {
        self.text(expression, 0, true)
    }

    /// Text of the expression that defines a variable.
    pub fn definition(&self, expression: Expr) -> String {
        self.operation(expression, 0, true)
    }

    fn text(&self, expression: Expr, least: u8, with_variables: bool) -> String {
        match self.statements.names.get(expression.index()).copied().flatten() {
            Some(variable) if with_variables => format!("x{variable}"),
            _ => self.operation(expression, least, with_variables),
        }
    }

    fn operation(&self, expression: Expr, least: u8, with_variables: bool) -> String {
        let of = |e: Expr, least: u8| self.text(e, least, with_variables);
        let index = |angle: Expr| self.statements.angles.iter().position(|a| *a == angle).unwrap_or(0);
        let (text, strength) = match self.graph.node(expression) {
            Node::Constant(bits) => {
                let value = f64::from_bits(bits);
                (literal(value), if value < 0.0 { SIGN } else { ATOM })
            }
            Node::Input(i) => ((self.names.input)(i as usize), ATOM),
            Node::Sum(a, b) => (format!("{} + {}", of(a, SUM), of(b, PRODUCT)), SUM),
            Node::Difference(a, b) => (format!("{} - {}", of(a, SUM), of(b, PRODUCT)), SUM),
            Node::Product(a, b) => (format!("{}*{}", of(a, PRODUCT), of(b, SIGN)), PRODUCT),
            Node::Quotient(a, b) => (format!("{}/{}", of(a, PRODUCT), of(b, SIGN)), PRODUCT),
            Node::Negation(a) => (format!("-{}", of(a, ATOM)), SIGN),
            Node::Root(a) => ((self.names.root)(&of(a, 0)), ATOM),
            Node::Sine(angle) => ((self.names.sine)(index(angle)), ATOM),
            Node::Cosine(angle) => ((self.names.cosine)(index(angle)), ATOM),
        };
        if strength < least { format!("({text})") } else { text }
    }
}
