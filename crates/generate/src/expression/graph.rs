//! Graph of expressions. Equal expressions are one node (hash-consing); operations with 0 and 1 and operations on
//! constants are simplified when a node is made.

use std::collections::HashMap;

/// Node of a [`Graph`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Expr(u32);

impl Expr {
    /// Index of the node; operands have lower indices.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// Operation of a node.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Node {
    /// Constant, by its bits.
    Constant(u64),
    /// Input by its index.
    Input(u32),
    Sum(Expr, Expr),
    Difference(Expr, Expr),
    Product(Expr, Expr),
    Quotient(Expr, Expr),
    Negation(Expr),
    Root(Expr),
    Sine(Expr),
    Cosine(Expr),
}

impl Node {
    /// Operands of the operation.
    pub fn operands(self) -> impl Iterator<Item = Expr> {
        let (first, second) = match self {
            Node::Constant(_) | Node::Input(_) => (None, None),
            Node::Sum(a, b) | Node::Difference(a, b) | Node::Product(a, b) | Node::Quotient(a, b) => {
                (Some(a), Some(b))
            }
            Node::Negation(a) | Node::Root(a) | Node::Sine(a) | Node::Cosine(a) => (Some(a), None),
        };
        first.into_iter().chain(second)
    }
}

/// Directed acyclic graph of expressions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Graph {
    nodes: Vec<Node>,
    known: HashMap<Node, Expr>,
}

impl Graph {
    /// Node of an expression.
    pub fn node(&self, expression: Expr) -> Node {
        self.nodes[expression.index()]
    }

    /// All expressions, operands before their nodes.
    pub fn expressions(&self) -> impl Iterator<Item = Expr> + use<> {
        (0..u32::try_from(self.nodes.len()).unwrap_or(u32::MAX)).map(Expr)
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.nodes.len()
    }

    /// Value of a constant; `None` for other expressions.
    pub fn value(&self, expression: Expr) -> Option<f64> {
        match self.node(expression) {
            Node::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// True if the expression is the constant 0.
    pub fn is_zero(&self, expression: Expr) -> bool {
        self.value(expression) == Some(0.0)
    }

    /// Operand of a negation.
    fn negated(&self, expression: Expr) -> Option<Expr> {
        match self.node(expression) {
            Node::Negation(a) => Some(a),
            _ => None,
        }
    }

    /// Constant c and further part of a sum: c + x (`false`), c − x (`true`) or x − c (−c + x).
    fn constant_part(&self, sum: Expr) -> Option<(f64, bool, Expr)> {
        match self.node(sum) {
            Node::Sum(a, b) => match (self.value(a), self.value(b)) {
                (Some(c), None) => Some((c, false, b)),
                (None, Some(c)) => Some((c, false, a)),
                _ => None,
            },
            Node::Difference(a, b) => match (self.value(a), self.value(b)) {
                (Some(c), None) => Some((c, true, b)),
                (None, Some(c)) => Some((-c, false, a)),
                _ => None,
            },
            _ => None,
        }
    }

    /// c + (d ± x) with one constant.
    fn add_constant(&mut self, c: f64, sum: Expr) -> Option<Expr> {
        let (d, is_minus, x) = self.constant_part(sum)?;
        let constant = self.constant(c + d);
        Some(if is_minus { self.sub(constant, x) } else { self.add(constant, x) })
    }

    fn add_node(&mut self, node: Node) -> Expr {
        if let Some(&known) = self.known.get(&node) {
            return known;
        }
        let expression = Expr(u32::try_from(self.nodes.len()).unwrap_or(u32::MAX));
        self.nodes.push(node);
        self.known.insert(node, expression);
        expression
    }

    /// Constant; −0 becomes 0.
    pub fn constant(&mut self, value: f64) -> Expr {
        self.add_node(Node::Constant((value + 0.0).to_bits()))
    }

    /// The constant 0.
    pub fn zero(&mut self) -> Expr {
        self.constant(0.0)
    }

    /// The constant 1.
    pub fn one(&mut self) -> Expr {
        self.constant(1.0)
    }

    /// Input by its index.
    pub fn input(&mut self, index: usize) -> Expr {
        self.add_node(Node::Input(u32::try_from(index).unwrap_or(u32::MAX)))
    }

    /// a + b.
    pub fn add(&mut self, a: Expr, b: Expr) -> Expr {
        match (self.value(a), self.value(b)) {
            (Some(a), Some(b)) => return self.constant(a + b),
            (Some(0.0), _) => return b,
            (_, Some(0.0)) => return a,
            (Some(value), _) => {
                if let Some(sum) = self.add_constant(value, b) {
                    return sum;
                }
                if value < 0.0 {
                    let positive = self.constant(-value);
                    return self.sub(b, positive);
                }
            }
            (_, Some(_)) => return self.add(b, a),
            _ => {}
        }
        match (self.negated(a), self.negated(b)) {
            (Some(a), Some(b)) => {
                let sum = self.add(a, b);
                self.neg(sum)
            }
            (Some(a), None) => self.sub(b, a),
            (None, Some(b)) => self.sub(a, b),
            (None, None) => self.add_node(Node::Sum(a.min(b), a.max(b))),
        }
    }

    /// a − b.
    pub fn sub(&mut self, a: Expr, b: Expr) -> Expr {
        if a == b {
            return self.zero();
        }
        match (self.value(a), self.value(b)) {
            (Some(a), Some(b)) => return self.constant(a - b),
            (Some(0.0), _) => return self.neg(b),
            (_, Some(0.0)) => return a,
            (Some(value), _) => {
                if let Some((d, is_minus, x)) = self.constant_part(b) {
                    let constant = self.constant(value - d);
                    return if is_minus { self.add(constant, x) } else { self.sub(constant, x) };
                }
                if value < 0.0 {
                    let positive = self.constant(-value);
                    let sum = self.add(positive, b);
                    return self.neg(sum);
                }
            }
            (_, Some(value)) => {
                if let Some(sum) = self.add_constant(-value, a) {
                    return sum;
                }
                if value < 0.0 {
                    let positive = self.constant(-value);
                    return self.add(a, positive);
                }
            }
            _ => {}
        }
        match (self.negated(a), self.negated(b)) {
            (Some(a), Some(b)) => self.sub(b, a),
            (Some(a), None) => {
                let sum = self.add(a, b);
                self.neg(sum)
            }
            (None, Some(b)) => self.add(a, b),
            (None, None) => match self.known.get(&Node::Difference(b, a)) {
                Some(&opposite) => self.neg(opposite),
                None => self.add_node(Node::Difference(a, b)),
            },
        }
    }

    /// a b.
    pub fn mul(&mut self, a: Expr, b: Expr) -> Expr {
        // A constant is the first factor.
        let (a, b) = if self.value(b).is_some() { (b, a) } else { (a, b) };
        if let Some(factor) = self.value(a) {
            if let Some(other) = self.value(b) {
                return self.constant(factor * other);
            }
            if factor == 0.0 {
                return self.zero();
            }
            if factor == 1.0 {
                return b;
            }
            if factor < 0.0 {
                let (positive, of) = (self.constant(-factor), self.negated(b));
                let product = self.mul(positive, of.unwrap_or(b));
                return if of.is_some() { product } else { self.neg(product) };
            }
            if let Node::Product(first, second) = self.node(b) {
                let constant = self.value(first).map(|inner| (inner, second));
                let constant = constant.or_else(|| self.value(second).map(|inner| (inner, first)));
                if let Some((inner, rest)) = constant {
                    let factor = self.constant(factor * inner);
                    return self.mul(factor, rest);
                }
            }
        }
        match (self.negated(a), self.negated(b)) {
            (Some(a), Some(b)) => self.mul(a, b),
            (Some(a), None) => {
                let product = self.mul(a, b);
                self.neg(product)
            }
            (None, Some(b)) => {
                let product = self.mul(a, b);
                self.neg(product)
            }
            (None, None) => self.add_node(Node::Product(a.min(b), a.max(b))),
        }
    }

    /// a / b.
    pub fn div(&mut self, a: Expr, b: Expr) -> Expr {
        if let Some(divisor) = self.value(b)
            && divisor != 0.0
        {
            let inverse = self.constant(1.0 / divisor);
            return self.mul(inverse, a);
        }
        if self.is_zero(a) {
            return a;
        }
        match (self.negated(a), self.negated(b)) {
            (Some(a), Some(b)) => self.div(a, b),
            (Some(a), None) => {
                let quotient = self.div(a, b);
                self.neg(quotient)
            }
            (None, Some(b)) => {
                let quotient = self.div(a, b);
                self.neg(quotient)
            }
            (None, None) => self.add_node(Node::Quotient(a, b)),
        }
    }

    /// −a.
    pub fn neg(&mut self, a: Expr) -> Expr {
        match self.node(a) {
            Node::Constant(bits) => self.constant(-f64::from_bits(bits)),
            Node::Negation(inner) => inner,
            _ => self.add_node(Node::Negation(a)),
        }
    }

    /// √a.
    pub fn sqrt(&mut self, a: Expr) -> Expr {
        match self.value(a) {
            Some(value) => self.constant(value.sqrt()),
            None => self.add_node(Node::Root(a)),
        }
    }

    /// sin a.
    pub fn sin(&mut self, a: Expr) -> Expr {
        match self.value(a) {
            Some(value) => self.constant(value.sin()),
            None => self.add_node(Node::Sine(a)),
        }
    }

    /// cos a.
    pub fn cos(&mut self, a: Expr) -> Expr {
        match self.value(a) {
            Some(value) => self.constant(value.cos()),
            None => self.add_node(Node::Cosine(a)),
        }
    }

    /// a².
    pub fn square(&mut self, a: Expr) -> Expr {
        self.mul(a, a)
    }

    /// Multiplies by a number.
    pub fn scale(&mut self, a: Expr, factor: f64) -> Expr {
        let factor = self.constant(factor);
        self.mul(factor, a)
    }

    /// Σ of expressions.
    pub fn sum(&mut self, terms: impl IntoIterator<Item = Expr>) -> Expr {
        let mut sum = None;
        for term in terms {
            sum = Some(match sum {
                None => term,
                Some(sum) => self.add(sum, term),
            });
        }
        sum.unwrap_or_else(|| self.zero())
    }

    /// Values of all nodes at the given inputs.
    pub fn evaluate(&self, inputs: &[f64]) -> Vec<f64> {
        let mut values = Vec::with_capacity(self.nodes.len());
        for &node in &self.nodes {
            let of = |e: Expr| -> f64 { values[e.index()] };
            let value = match node {
                Node::Constant(bits) => f64::from_bits(bits),
                Node::Input(index) => inputs[index as usize],
                Node::Sum(a, b) => of(a) + of(b),
                Node::Difference(a, b) => of(a) - of(b),
                Node::Product(a, b) => of(a) * of(b),
                Node::Quotient(a, b) => of(a) / of(b),
                Node::Negation(a) => -of(a),
                Node::Root(a) => of(a).sqrt(),
                Node::Sine(a) => of(a).sin(),
                Node::Cosine(a) => of(a).cos(),
            };
            values.push(value);
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_expressions_are_one_node_and_trivial_operations_vanish() {
        let mut g = Graph::default();
        let (x, y) = (g.input(0), g.input(1));
        let (zero, one) = (g.zero(), g.one());
        assert_eq!(g.add(x, y), g.add(y, x));
        assert_eq!(g.mul(x, y), g.mul(y, x));
        assert_eq!(g.add(x, zero), x);
        assert_eq!(g.mul(one, x), x);
        assert_eq!(g.mul(x, zero), zero);
        assert_eq!(g.sub(x, x), zero);
        let (d, e) = (g.sub(x, y), g.sub(y, x));
        assert_eq!(g.neg(d), e);
        let minus = g.neg(x);
        assert_eq!(g.sub(y, minus), g.add(x, y));
        let (product, opposite) = (g.mul(x, y), g.mul(minus, y));
        assert_eq!(g.neg(product), opposite);
        let twice = g.scale(x, 2.0);
        assert_eq!(g.scale(twice, -3.0), {
            let six = g.scale(x, 6.0);
            g.neg(six)
        });
        let values = g.evaluate(&[0.5, 2.0]);
        assert_eq!(values[opposite.index()], -1.0);
    }
}
