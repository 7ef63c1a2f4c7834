//! How many rows of A count, and how clear that is.

use faer::Mat;
use nalgebra::DMatrix;

/// A rank decision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rank {
    pub rank: usize,
    /// Least singular value that counts over the greatest that does not (taken as at least ε/1000 of the largest).
    pub gap: f64,
    /// Least singular value that counts, as a part of the largest.
    pub least: f64,
    /// Whether both sides of the gap lie more than a factor of 30 from the threshold.
    pub clear: bool,
}

/// Singular values below this part of the largest count as zero, where the file is exact.
pub(crate) const FLOOR: f64 = 1e-10;
const MARGIN: f64 = 30.0;

/// Singular values of a matrix, descending; columns divided by `lengths`.
pub(crate) fn singular_values(matrix: &DMatrix<f64>, lengths: &[f64]) -> Vec<f64> {
    let (m, n) = matrix.shape();
    let scaled = Mat::from_fn(m, n, |r, c| matrix[(r, c)] / lengths[c]);
    if m == 0 || n == 0 || scaled.norm_max() == 0.0 {
        return vec![0.0; m.min(n)];
    }
    match scaled.singular_values() {
        Ok(values) => values,
        // The pivots of a rank-revealing QR are within a small factor of them.
        Err(_) => {
            let r = scaled.col_piv_qr();
            (0..m.min(n)).map(|i| r.R()[(i, i)].abs()).collect()
        }
    }
}

/// Decides the rank: values above `floor` times the largest count.
pub(crate) fn decide(values: &[f64], floor: f64) -> Rank {
    let largest = values.first().copied().unwrap_or(0.0);
    if largest == 0.0 {
        return Rank { rank: 0, gap: 1.0 / f64::EPSILON, least: 1.0, clear: true };
    }
    let threshold = floor * largest;
    let rank = values.iter().take_while(|v| **v > threshold).count();
    let (least, next) = (values[rank - 1], values.get(rank).copied().unwrap_or(0.0));
    Rank {
        rank,
        gap: least / next.max(1e-3 * f64::EPSILON * largest),
        least: least / largest,
        clear: least > MARGIN * threshold && next < threshold / MARGIN,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gap_is_clear_or_not() {
        let clear = decide(&[2.0, 0.5, 1e-16], 1e-10);
        assert_eq!((clear.rank, clear.clear), (2, true));
        assert!(clear.gap > 1e15);
        assert!(!decide(&[2.0, 1e-9, 1e-16], 1e-10).clear);
        assert_eq!(decide(&[2.0, 1e-9], 1e-10).rank, 2);
        assert!(!decide(&[2.0, 1e-11], 1e-10).clear);
        assert_eq!(decide(&[0.0, 0.0], 1e-10).rank, 0);
        assert_eq!(decide(&[], 1e-10).rank, 0);
    }
}
