//! Statements of a function: the needed nodes in the order of evaluation, and the angles of its sines and cosines.

use super::graph::{Expr, Graph, Node};

/// Statements for a list of results.
#[derive(Clone, Debug, Default)]
pub(crate) struct Statements {
    /// Nodes that become variables, operands first. Other nodes are part of an expression.
    pub variables: Vec<Expr>,
    /// Angles of sines and cosines.
    pub angles: Vec<Expr>,
    /// Number of arithmetic operations, without sines and cosines.
    pub operations: usize,
    /// Index of the variable of every node.
    pub names: Vec<Option<usize>>,
}

impl Statements {
    /// Statements that compute the results.
    pub fn new(g: &Graph, results: &[Expr]) -> Self {
        let mut uses = vec![0u32; g.len()];
        let mut needed = vec![false; g.len()];
        let mut order = Vec::new();
        // Post-order from each result: variables are computed shortly before their use.
        let mut stack: Vec<(Expr, bool)> = Vec::new();
        for &result in results {
            stack.push((result, false));
            while let Some((expression, is_done)) = stack.pop() {
                if is_done {
                    order.push(expression);
                    continue;
                }
                if std::mem::replace(&mut needed[expression.index()], true) {
                    continue;
                }
                stack.push((expression, true));
                let operands: Vec<Expr> = evaluated_operands(g.node(expression)).collect();
                stack.extend(operands.into_iter().rev().map(|operand| (operand, false)));
            }
            uses[result.index()] += 2;
        }
        for &expression in &order {
            for operand in evaluated_operands(g.node(expression)) {
                uses[operand.index()] += 1;
            }
        }
        let mut statements = Self { names: vec![None; g.len()], ..Self::default() };
        let mut depth = vec![0usize; g.len()];
        for expression in order {
            let node = g.node(expression);
            match node {
                Node::Constant(_) => continue,
                Node::Input(_) => continue,
                Node::Sine(angle) | Node::Cosine(angle) => {
                    if !statements.angles.contains(&angle) {
                        statements.angles.push(angle);
                    }
                    continue;
                }
                Node::Negation(_) => {}
                _ => statements.operations += 1,
            }
            let i = expression.index();
            depth[i] = 1 + node.operands().map(|o| depth[o.index()]).sum::<usize>();
            // A quotient used once stays a variable: its latency is long.
            let is_short = depth[i] <= MOST_OPERATIONS && !matches!(node, Node::Quotient(..));
            let is_sign = matches!(node, Node::Negation(_)) && depth[i] == 1;
            if uses[i] == 1 && is_short || is_sign {
                continue;
            }
            depth[i] = 0;
            statements.names[i] = Some(statements.variables.len());
            statements.variables.push(expression);
        }
        statements
    }
}

/// Operands that are evaluated among the statements; the angles of sines and cosines are evaluated before.
fn evaluated_operands(node: Node) -> impl Iterator<Item = Expr> {
    let is_angle = matches!(node, Node::Sine(_) | Node::Cosine(_));
    node.operands().filter(move |_| !is_angle)
}

/// Largest number of operations in one expression.
const MOST_OPERATIONS: usize = 6;
