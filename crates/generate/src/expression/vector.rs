//! Vectors and matrices of expressions.

use super::graph::{Expr, Graph};
use nalgebra::{Matrix3, Vector3};

/// Vector of three expressions.
pub(crate) type Vector = [Expr; 3];
/// Matrix of expressions, by rows.
pub(crate) type Matrix = [[Expr; 3]; 3];

impl Graph {
    /// Constant vector.
    pub fn vector(&mut self, v: &Vector3<f64>) -> Vector {
        [self.constant(v.x), self.constant(v.y), self.constant(v.z)]
    }

    /// Zero vector.
    pub fn zeros(&mut self) -> Vector {
        [self.zero(); 3]
    }

    /// Unit vector along axis `k`.
    pub fn unit(&mut self, k: usize) -> Vector {
        let mut unit = self.zeros();
        unit[k] = self.one();
        unit
    }

    /// Constant matrix.
    pub fn matrix(&mut self, m: &Matrix3<f64>) -> Matrix {
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| self.constant(m[(i, j)])))
    }

    /// a + b.
    pub fn add3(&mut self, a: Vector, b: Vector) -> Vector {
        [0, 1, 2].map(|k| self.add(a[k], b[k]))
    }

    /// a − b.
    pub fn sub3(&mut self, a: Vector, b: Vector) -> Vector {
        [0, 1, 2].map(|k| self.sub(a[k], b[k]))
    }

    /// s a.
    pub fn scale3(&mut self, s: Expr, a: Vector) -> Vector {
        a.map(|x| self.mul(s, x))
    }

    /// a · b.
    pub fn dot(&mut self, a: Vector, b: Vector) -> Expr {
        let products = [0, 1, 2].map(|k| self.mul(a[k], b[k]));
        self.sum(products)
    }

    /// a × b.
    pub fn cross(&mut self, a: Vector, b: Vector) -> Vector {
        [0, 1, 2].map(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            let (plus, minus) = (self.mul(a[i], b[j]), self.mul(a[j], b[i]));
            self.sub(plus, minus)
        })
    }

    /// R a.
    pub fn rotate(&mut self, r: &Matrix, a: Vector) -> Vector {
        r.map(|row| self.dot(row, a))
    }

    /// Rᵀ a.
    pub fn rotate_back(&mut self, r: &Matrix, a: Vector) -> Vector {
        [0, 1, 2].map(|j| self.dot([r[0][j], r[1][j], r[2][j]], a))
    }

    /// Column `j` of a matrix.
    pub fn column(r: &Matrix, j: usize) -> Vector {
        [r[0][j], r[1][j], r[2][j]]
    }
}
