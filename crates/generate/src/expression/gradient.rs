//! Derivatives of an expression over the inputs, in reverse mode.

use super::graph::{Expr, Graph, Node};

impl Graph {
    /// ∂f/∂x of all inputs x.
    pub fn gradient(&mut self, f: Expr, inputs: usize) -> Vec<Expr> {
        let zero = self.zero();
        let mut adjoints: Vec<Option<Expr>> = vec![None; f.index() + 1];
        adjoints[f.index()] = Some(self.one());
        let mut gradient = vec![zero; inputs];
        // Operands precede their nodes in the graph.
        let nodes: Vec<(Expr, Node)> = self.nodes_up_to(f);
        for (expression, node) in nodes.into_iter().rev() {
            let Some(adjoint) = adjoints[expression.index()] else { continue };
            let mut add = |g: &mut Self, to: Expr, term: Expr| {
                let known = adjoints[to.index()];
                adjoints[to.index()] = Some(known.map_or(term, |known| g.add(known, term)));
            };
            match node {
                Node::Constant(_) => {}
                Node::Input(index) => gradient[index as usize] = adjoint,
                Node::Sum(a, b) => {
                    add(self, a, adjoint);
                    add(self, b, adjoint);
                }
                Node::Difference(a, b) => {
                    add(self, a, adjoint);
                    let minus = self.neg(adjoint);
                    add(self, b, minus);
                }
                Node::Product(a, b) => {
                    let (to_a, to_b) = (self.mul(adjoint, b), self.mul(adjoint, a));
                    add(self, a, to_a);
                    add(self, b, to_b);
                }
                Node::Quotient(a, b) => {
                    let to_a = self.div(adjoint, b);
                    let product = self.mul(to_a, expression);
                    let to_b = self.neg(product);
                    add(self, a, to_a);
                    add(self, b, to_b);
                }
                Node::Negation(a) => {
                    let minus = self.neg(adjoint);
                    add(self, a, minus);
                }
                Node::Root(a) => {
                    let half = self.scale(adjoint, 0.5);
                    let term = self.div(half, expression);
                    add(self, a, term);
                }
                Node::Sine(a) => {
                    let cosine = self.cos(a);
                    let term = self.mul(adjoint, cosine);
                    add(self, a, term);
                }
                Node::Cosine(a) => {
                    let sine = self.sin(a);
                    let product = self.mul(adjoint, sine);
                    let term = self.neg(product);
                    add(self, a, term);
                }
            }
        }
        gradient
    }

    /// All nodes up to an expression.
    fn nodes_up_to(&self, last: Expr) -> Vec<(Expr, Node)> {
        self.expressions().take(last.index() + 1).map(|e| (e, self.node(e))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gradients_are_difference_quotients() {
        let mut g = Graph::default();
        let (x, y) = (g.input(0), g.input(1));
        let (s, c) = (g.sin(x), g.cos(y));
        let (one, xx) = (g.one(), g.mul(x, x));
        let below = g.add(one, xx);
        let quotient = g.div(s, below);
        let product = g.mul(c, y);
        let root = g.sqrt(below);
        let sum = g.add(quotient, product);
        let f = g.sub(sum, root);
        let gradient = g.gradient(f, 2);
        let at = [0.7, -1.3];
        let values = g.evaluate(&at);
        for k in 0..2 {
            let h = 1e-5;
            let of = |d: f64| {
                let mut q = at;
                q[k] += d;
                g.evaluate(&q)[f.index()]
            };
            // Truncation h², rounding ε/h.
            let expected = (of(h) - of(-h)) / (2.0 * h);
            assert!((values[gradient[k].index()] - expected).abs() < 1e-9);
        }
    }
}
