//! Null space and row space of a set of rows.

use faer::Mat;
use nalgebra::DMatrix;

/// Orthonormal bases of the two subspaces, one vector per column.
#[derive(Debug)]
pub(super) struct Subspaces {
    /// Motions on which all rows vanish.
    pub null: DMatrix<f64>,
    /// Orthogonal complement: the space of the rows.
    pub range: DMatrix<f64>,
}

/// Splits the space of `n` coordinates by the rows. Every row is scaled to unit length; a zero row has no effect. Singular values below `floor`
/// times the largest count as zero. `None` if the decomposition does not converge.
pub(super) fn split(rows: &DMatrix<f64>, n: usize, floor: f64) -> Option<Subspaces> {
    let norms: Vec<f64> = rows.row_iter().map(|row| row.norm()).collect();
    let kept: Vec<usize> = (0..rows.nrows()).filter(|&r| norms[r] > 0.0).collect();
    if kept.is_empty() {
        return Some(Subspaces { null: DMatrix::identity(n, n), range: DMatrix::zeros(n, 0) });
    }
    let scaled = Mat::from_fn(kept.len(), n, |r, c| rows[(kept[r], c)] / norms[kept[r]]);
    let svd = scaled.svd().ok()?;
    let values = svd.S().column_vector();
    let rank = (0..kept.len().min(n)).take_while(|&i| values[i] > floor * values[0]).count();
    let v = svd.V();
    let basis = |first: usize, count: usize| DMatrix::from_fn(n, count, |r, c| v[(r, first + c)]);
    Some(Subspaces { null: basis(rank, n - rank), range: basis(0, rank) })
}
