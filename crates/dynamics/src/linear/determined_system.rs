//! Consistent systems of linear equations with a unique solution.

use crate::tolerances::UNDETERMINED_MOTION;
use nalgebra::{ColPivQR, DMatrix, DVector, Dyn};

/// Rows that determine a motion: matrix of full column rank, factorised by Householder QR with column pivoting. Cost: O(rows · columns²).
/// Source: Golub and Van Loan 2013, §5.4.2.
#[derive(Debug)]
pub struct DeterminedSystem {
    matrix: DMatrix<f64>,
    scale: f64,
    qr: ColPivQR<f64, Dyn, Dyn>,
    r: DMatrix<f64>,
}

impl DeterminedSystem {
    /// Factorises a matrix with at least as many rows as columns; `None` if a motion is left free.
    pub fn new(matrix: DMatrix<f64>) -> Option<Self> {
        let scale = matrix.amax();
        let qr = matrix.clone().col_piv_qr();
        let r = qr.r();
        let is_free = |k: usize| r[(k, k)].abs() <= UNDETERMINED_MOTION * scale;
        (!(0..matrix.ncols()).any(is_free)).then_some(Self { matrix, scale, qr, r })
    }

    /// Solution for a target; `None` if the rows exclude one another.
    pub fn solve(&self, target: &DVector<f64>) -> Option<DVector<f64>> {
        let x = self.nearest(target)?;
        let residual = (&self.matrix * &x - target).amax();
        (residual <= UNDETERMINED_MOTION * (target.amax() + self.scale * x.amax())).then_some(x)
    }

    /// Solution by least squares; `None` if a number is not finite.
    pub(crate) fn nearest(&self, target: &DVector<f64>) -> Option<DVector<f64>> {
        let mut projected = target.clone();
        self.qr.q_tr_mul(&mut projected);
        let mut x = projected.rows(0, self.matrix.ncols()).into_owned();
        if !self.r.solve_upper_triangular_mut(&mut x) {
            return None;
        }
        self.qr.p().inv_permute_rows(&mut x);
        x.iter().all(|x| x.is_finite()).then_some(x)
    }
}
