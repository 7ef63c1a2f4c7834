//! Linear equations with a symmetric positive semi-definite matrix.

use crate::tolerances::{MASSLESS_ENERGY, MASSLESS_RESPONSE, OPEN_COMPONENT, UNMOVED};
use nalgebra::{DMatrix, DVector};

/// Eigenvalue decomposition of a symmetric positive semi-definite matrix. It decides in which directions a mobility is more than rounding.
pub(crate) struct SemidefiniteSolver {
    /// Scale of each component: the decomposed matrix is S A S.
    scale: DVector<f64>,
    vectors: DMatrix<f64>,
    values: DVector<f64>,
    floor: f64,
    /// Orthonormal basis of ker A.
    kernel: DMatrix<f64>,
}

impl SemidefiniteSolver {
    /// Solver whose kernel has the eigenvalues below [`MASSLESS_RESPONSE`] times the largest.
    pub fn new(matrix: DMatrix<f64>) -> Self {
        Self::within(matrix, 0.0)
    }

    /// As [`new`](Self::new), for a block of a matrix of the size `size`: eigenvalues below [`MASSLESS_RESPONSE`] times this size are
    /// rounding too.
    pub fn within(matrix: DMatrix<f64>, size: f64) -> Self {
        let scale = DVector::from_element(matrix.nrows(), 1.0);
        Self::scaled(matrix, scale, size)
    }

    /// Solver for the mobility of contacts of which some can hardly move: the matrix is scaled to a unit diagonal, so that the kernel does
    /// not depend on the sizes of the mobilities. Immovable contacts belong to the kernel.
    pub fn of_contacts(matrix: &DMatrix<f64>) -> Self {
        let scale = contact_scale(matrix);
        let even =
            DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |r, c| scale[r] * matrix[(r, c)] * scale[c]);
        let typical = scale.iter().copied().filter(|s| *s > 0.0).fold(1.0, f64::min);
        Self::scaled(even, scale.map(|s| if s > 0.0 { s } else { typical }), 0.0)
    }

    /// `even`: the matrix S A S with the scale S.
    fn scaled(even: DMatrix<f64>, scale: DVector<f64>, size: f64) -> Self {
        let eigen = even.symmetric_eigen();
        let (values, vectors) = (eigen.eigenvalues, eigen.eigenvectors);
        let floor = MASSLESS_RESPONSE * values.amax().max(size);
        let open: Vec<usize> = (0..values.len()).filter(|k| values[*k] <= floor).collect();
        let mut kernel = vectors.select_columns(&open);
        kernel.column_iter_mut().for_each(|mut column| column.component_mul_assign(&scale));
        let kernel = if open.is_empty() { kernel } else { kernel.qr().q() };
        Self { scale, vectors, values, floor, kernel }
    }

    /// Solution of least norm, in the least-squares sense of the scaled equations.
    pub fn solve(&self, right: &DVector<f64>) -> DVector<f64> {
        let mut weights = self.vectors.transpose() * right.component_mul(&self.scale);
        for k in 0..weights.len() {
            weights[k] = if self.values[k] > self.floor { weights[k] / self.values[k] } else { 0.0 };
        }
        let solution = (&self.vectors * weights).component_mul(&self.scale);
        &solution - &self.kernel * self.kernel.tr_mul(&solution)
    }

    /// Eigenvectors with eigenvalues above rounding.
    pub fn movable_directions(&self) -> impl Iterator<Item = DVector<f64>> + '_ {
        let movable = (0..self.values.len()).filter(|k| self.values[*k] > self.floor);
        movable.map(|k| self.vectors.column(k).into_owned())
    }

    /// Orthonormal basis of the kernel of the matrix, as columns.
    pub fn kernel(&self) -> &DMatrix<f64> {
        &self.kernel
    }

    /// True if the kernel of the matrix leaves a linear function of the solution open.
    pub fn is_open(&self, function: &DVector<f64>) -> bool {
        self.kernel.tr_mul(function).norm() > OPEN_COMPONENT
    }
}

/// Factors 1/√W_ii that scale a mobility of contacts to a unit diagonal; 0 for a contact that cannot move: its entry is rounding.
pub(crate) fn contact_scale(matrix: &DMatrix<f64>) -> DVector<f64> {
    let largest = matrix.diagonal().amax();
    let is_movable = |w: f64| w > UNMOVED * UNMOVED * largest;
    matrix.diagonal().map(|w| if is_movable(w) { w.sqrt().recip() } else { 0.0 })
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
