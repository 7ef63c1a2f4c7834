//! Mass matrix of the tree velocities (composite rigid bodies), and the elimination M = Lᵀ D L with the contact row.
//! The pivots D are those of the articulated-body recursion: 1/m̄ = Σ (sᵀp)²/D.
//!
//! Featherstone 2008, §6.2 (composite rigid bodies) and §6.5 (LᵀL factorisation, branch-induced sparsity).

use super::body_frames::Bodies;
use super::motion::InertiaExpr;
use crate::expression::graph::{Expr, Graph};

/// Symmetric matrix of expressions.
pub(crate) type SymmetricMatrix = Vec<Vec<Expr>>;

/// M over the tree velocities, with the armatures on the diagonal.
pub(crate) fn tree_mass_matrix(g: &mut Graph, bodies: &Bodies) -> SymmetricMatrix {
    let tree = &bodies.tree;
    let zero = g.zero();
    let mut matrix = vec![vec![zero; tree.velocities.len()]; tree.velocities.len()];
    let mut composite: Vec<InertiaExpr> = bodies.bodies.iter().map(|b| b.inertia).collect();
    for (i, body) in tree.bodies.iter().enumerate().rev() {
        let inertia = composite[i];
        for (k, v) in body.velocities.clone().enumerate() {
            let mut momentum = inertia.momentum(g, &bodies.bodies[i].columns[k]);
            for (other, u) in body.velocities.clone().enumerate().take(k + 1) {
                let entry = momentum.power(g, &bodies.bodies[i].columns[other]);
                (matrix[u][v], matrix[v][u]) = (entry, entry);
            }
            let armature = g.constant(body.armature[k]);
            matrix[v][v] = g.add(matrix[v][v], armature);
            let mut at = i;
            while let Some(parent) = tree.bodies[at].parent {
                for step in bodies.bodies[at].steps.iter().rev() {
                    momentum = step.wrench_to_parent(g, &momentum);
                }
                at = parent;
                for (other, u) in tree.bodies[at].velocities.clone().enumerate() {
                    let entry = momentum.power(g, &bodies.bodies[at].columns[other]);
                    (matrix[u][v], matrix[v][u]) = (entry, entry);
                }
            }
        }
        if let Some(parent) = body.parent {
            let mut moved = inertia;
            for step in bodies.bodies[i].steps.iter().rev() {
                moved = step.inertia_to_parent(g, &moved);
            }
            composite[parent] = composite[parent].plus(g, &moved);
        }
    }
    matrix
}

/// Gᵀ M G, for rates G of the tree velocities over independent coordinates.
pub(crate) fn reduced_mass_matrix(
    g: &mut Graph,
    matrix: &SymmetricMatrix,
    rates: &[Vec<Expr>],
    coordinates: usize,
) -> SymmetricMatrix {
    let momentum: Vec<Vec<Expr>> = (0..matrix.len())
        .map(|u| {
            (0..coordinates)
                .map(|y| sparse_dot(g, matrix[u].iter().zip(rates).map(|(m, r)| (*m, r[y]))))
                .collect()
        })
        .collect();
    let zero = g.zero();
    let mut reduced = vec![vec![zero; coordinates]; coordinates];
    for a in 0..coordinates {
        for b in a..coordinates {
            let entry = sparse_dot(g, rates.iter().zip(&momentum).map(|(r, p)| (r[a], p[b])));
            (reduced[a][b], reduced[b][a]) = (entry, entry);
        }
    }
    reduced
}

/// Σ a b over pairs; products with 0 vanish.
pub(crate) fn sparse_dot(g: &mut Graph, pairs: impl Iterator<Item = (Expr, Expr)>) -> Expr {
    let mut sum = g.zero();
    for (a, b) in pairs {
        let product = g.mul(a, b);
        sum = g.add(sum, product);
    }
    sum
}

/// Elimination of a symmetric positive definite matrix from the last row to the first.
pub(crate) struct Elimination {
    /// 1/D of every coordinate.
    pub inverse_pivots: Vec<Expr>,
    /// Row of L of every coordinate: entries of lower coordinates.
    pub factors: Vec<Vec<Expr>>,
    /// Pivots D.
    pub pivots: Vec<Expr>,
}

impl Elimination {
    /// Factorises the matrix.
    pub fn new(g: &mut Graph, mut matrix: SymmetricMatrix) -> Self {
        let n = matrix.len();
        let one = g.one();
        let (mut inverse_pivots, mut factors, mut pivots) = (vec![one; n], vec![Vec::new(); n], vec![one; n]);
        for k in (0..n).rev() {
            pivots[k] = matrix[k][k];
            inverse_pivots[k] = g.div(one, matrix[k][k]);
            let row: Vec<Expr> = (0..k).map(|i| g.mul(matrix[k][i], inverse_pivots[k])).collect();
            for i in 0..k {
                if g.is_zero(row[i]) {
                    continue;
                }
                for j in 0..=i {
                    let product = g.mul(row[i], matrix[k][j]);
                    matrix[i][j] = g.sub(matrix[i][j], product);
                }
            }
            factors[k] = row;
        }
        Self { inverse_pivots, factors, pivots }
    }

    /// L⁻ᵀ x: eliminates a row of forces or closing speeds.
    pub fn eliminate(&self, g: &mut Graph, row: &[Expr]) -> Vec<Expr> {
        let mut row = row.to_vec();
        for k in (0..row.len()).rev() {
            for i in 0..k {
                let product = g.mul(self.factors[k][i], row[k]);
                row[i] = g.sub(row[i], product);
            }
        }
        row
    }

    /// Σ a b / D of two eliminated rows.
    pub fn response(&self, g: &mut Graph, a: &[Expr], b: &[Expr]) -> Expr {
        let mut sum = g.zero();
        for k in (0..a.len()).rev() {
            let product = g.mul(a[k], b[k]);
            let term = g.mul(product, self.inverse_pivots[k]);
            sum = g.add(sum, term);
        }
        sum
    }

    /// M⁻¹ x of an eliminated row.
    pub fn velocities(&self, g: &mut Graph, eliminated: &[Expr]) -> Vec<Expr> {
        let mut velocities: Vec<Expr> = Vec::with_capacity(eliminated.len());
        for (k, &t) in eliminated.iter().enumerate() {
            let mut velocity = g.mul(t, self.inverse_pivots[k]);
            for (i, &lower) in velocities.iter().enumerate() {
                let product = g.mul(self.factors[k][i], lower);
                velocity = g.sub(velocity, product);
            }
            velocities.push(velocity);
        }
        velocities
    }
}
