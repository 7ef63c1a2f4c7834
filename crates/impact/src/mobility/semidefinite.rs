//! Linear equations with a symmetric positive semi-definite matrix.

use crate::tolerances::{MASSLESS_ENERGY, MASSLESS_RESPONSE, OPEN_COMPONENT};
use nalgebra::{DMatrix, DVector};

/// Eigenvalue decomposition of a symmetric positive semi-definite matrix.
pub(crate) struct SemidefiniteSolver {
    vectors: DMatrix<f64>,
    values: DVector<f64>,
    floor: f64,
}

impl SemidefiniteSolver {
    pub fn new(matrix: DMatrix<f64>) -> Self {
        let eigen = matrix.symmetric_eigen();
        let floor = MASSLESS_RESPONSE * eigen.eigenvalues.amax();
        Self { vectors: eigen.eigenvectors, values: eigen.eigenvalues, floor }
    }

    /// Solution of least norm, in the least-squares sense.
    pub fn solve(&self, right: &DVector<f64>) -> DVector<f64> {
        let mut weights = self.vectors.transpose() * right;
        for k in 0..weights.len() {
            weights[k] = if self.values[k] > self.floor { weights[k] / self.values[k] } else { 0.0 };
        }
        &self.vectors * weights
    }

    /// Orthonormal basis of the kernel of the matrix, as columns.
    pub fn kernel(&self) -> DMatrix<f64> {
        let open: Vec<usize> = (0..self.values.len()).filter(|k| self.values[*k] <= self.floor).collect();
        self.vectors.select_columns(&open)
    }

    /// True if the kernel of the matrix leaves a linear function of the solution open.
    pub fn is_open(&self, function: &DVector<f64>) -> bool {
        let part = |k: usize| {
            if self.values[k] > self.floor { 0.0 } else { self.vectors.column(k).dot(function) }
        };
        (0..self.values.len()).map(|k| part(k) * part(k)).sum::<f64>().sqrt() > OPEN_COMPONENT
    }
}

/// Factors that scale a positive semi-definite matrix with this diagonal to a unit diagonal, which lowers the condition of mechanisms
/// with light and heavy parts. An entry that is rounding of zero (a motion without mass) has the factor of the largest entry, so that it
/// stays small.
pub(crate) fn unit_diagonal_scale(diagonal: &[f64]) -> Vec<f64> {
    let largest = diagonal.iter().copied().fold(0.0, f64::max);
    let scale = |&entry: &f64| {
        let size = if entry > MASSLESS_ENERGY * largest { entry } else { largest };
        if size > 0.0 { size.sqrt().recip() } else { 1.0 }
    };
    diagonal.iter().map(scale).collect()
}
