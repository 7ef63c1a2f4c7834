//! Rank of A, and the clarity of the rank decision.

use crate::tolerances::{GAP_ROUNDING, RANK_MARGIN, RANK_ROUNDING, SINGULAR_VALUES_LIMIT};
use faer::Mat;
use nalgebra::DMatrix;

/// A rank decision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rank {
    pub rank: usize,
    /// Ratio of the smallest nonzero singular value to the largest zero one (the latter at least ε/1000 of the
    /// largest).
    pub gap: f64,
    /// Smallest nonzero singular value, relative to the largest.
    pub least: f64,
    /// True if both sides of the gap are more than [`RANK_MARGIN`] away from the threshold.
    pub clear: bool,
}

impl Default for Rank {
    fn default() -> Self {
        Self::NONE
    }
}

impl Rank {
    /// Adapts the clarity to loops with a misfit, which cause singular values of up to `misfit` of the largest.
    /// Unclear if the largest zero singular value exceeds both `misfit` and rounding.
    pub fn explained_by(self, misfit: f64) -> Self {
        let next = self.least / self.gap;
        Self { clear: self.clear && next <= RANK_ROUNDING.max(misfit), ..self }
    }

    /// Rank of an empty matrix.
    pub const NONE: Rank = Rank { rank: 0, gap: 1.0 / f64::EPSILON, least: 1.0, clear: true };
}

/// Singular values of a matrix, in descending order; columns are divided by `lengths`.
pub(crate) fn singular_values(matrix: &DMatrix<f64>, lengths: &[f64]) -> Vec<f64> {
    let (m, n) = matrix.shape();
    let scaled = Mat::from_fn(m, n, |r, c| matrix[(r, c)] / lengths[c]);
    if m == 0 || n == 0 || scaled.norm_max() == 0.0 {
        return vec![0.0; m.min(n)];
    }
    // The pivots of a rank-revealing QR are within a small factor of the singular values, at a tenth of the cost.
    let pivots = |scaled: &Mat<f64>| {
        let qr = scaled.col_piv_qr();
        (0..m.min(n)).map(|i| qr.R()[(i, i)].abs()).collect()
    };
    if m.min(n) > SINGULAR_VALUES_LIMIT {
        return pivots(&scaled);
    }
    scaled.singular_values().unwrap_or_else(|_| pivots(&scaled))
}

/// Decides the rank: the number of values above `floor` times the largest value.
pub(crate) fn decide_rank(values: &[f64], floor: f64) -> Rank {
    let largest = values.first().copied().unwrap_or(0.0);
    if largest == 0.0 {
        return Rank::NONE;
    }
    let threshold = floor * largest;
    let rank = values.iter().take_while(|v| **v > threshold).count();
    let Some(least) = rank.checked_sub(1).map(|last| values[last]) else {
        return Rank { clear: false, ..Rank::NONE };
    };
    let next = values.get(rank).copied().unwrap_or(0.0);
    Rank {
        rank,
        gap: least / next.max(GAP_ROUNDING * largest),
        least: least / largest,
        clear: least > RANK_MARGIN * threshold && next < threshold / RANK_MARGIN,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gap_is_clear_or_not() {
        let clear = decide_rank(&[2.0, 0.5, 1e-16], 1e-10);
        assert_eq!((clear.rank, clear.clear), (2, true));
        assert!(clear.gap > 1e15);
        assert!(!decide_rank(&[2.0, 1e-9, 1e-16], 1e-10).clear);
        assert_eq!(decide_rank(&[2.0, 1e-9], 1e-10).rank, 2);
        assert!(!decide_rank(&[2.0, 1e-11], 1e-10).clear);
        assert_eq!(decide_rank(&[0.0, 0.0], 1e-10).rank, 0);
        assert_eq!(decide_rank(&[], 1e-10).rank, 0);
        // A floor above all values, and NaN values.
        for (values, floor) in [([2.0, 0.5], 1.0), ([2.0, 0.5], f64::INFINITY), ([f64::NAN; 2], 1e-10)] {
            let nothing = decide_rank(&values, floor);
            assert_eq!((nothing.rank, nothing.clear), (0, false));
        }
    }
}
