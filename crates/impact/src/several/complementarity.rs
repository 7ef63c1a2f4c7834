//! Linear complementarity problem with a symmetric positive semi-definite matrix.

use crate::mobility::semidefinite::{SemidefiniteSolver, contact_scale};
use crate::tolerances::{COMPLEMENTARY, SPEED_ROUNDING};
use nalgebra::{DMatrix, DVector};

/// Solution z ≥ 0, W z + q ≥ 0, z·(W z + q) = 0.
pub(crate) struct Complementary {
    pub z: DVector<f64>,
    /// True for each component that the problem leaves open; W z is unique in any case.
    pub is_open: Vec<bool>,
}

/// Solves W z + q ≥ 0 ⊥ z ≥ 0: tests all subsets of positive components.
///
/// A solution exists if q is in the range of W or not negative; for a semi-definite W, W z is unique (Cottle, Pang and Stone
/// 1992, §3.1). The conditions are compared after scaling W to a unit diagonal. `None`: no subset satisfies the conditions.
pub(crate) fn complementarity(matrix: &DMatrix<f64>, q: &DVector<f64>) -> Option<Complementary> {
    let k = q.len();
    let scale = contact_scale(matrix);
    let limit = speed_rounding(&scale, q);
    let mut best: Option<(f64, DVector<f64>)> = None;
    for mask in 0..1u32 << k {
        let rows: Vec<usize> = (0..k).filter(|i| mask & (1 << i) != 0).collect();
        let block = DMatrix::from_fn(rows.len(), rows.len(), |r, c| matrix[(rows[r], rows[c])]);
        let mut z = DVector::zeros(k);
        if !rows.is_empty() {
            let solution = SemidefiniteSolver::of_contacts(&block)
                .solve(&DVector::from_fn(rows.len(), |r, _| -q[rows[r]]));
            rows.iter().enumerate().for_each(|(r, &row)| z[row] = solution[r]);
        }
        let w = matrix * &z + q;
        let relative = |i: usize| {
            let pulling = -z[i] * matrix[(i, i)];
            let closing = if mask & (1 << i) != 0 { w[i].abs() } else { -w[i] };
            if scale[i] > 0.0 { pulling.max(closing).max(0.0) * scale[i] / limit[i] } else { 0.0 }
        };
        let violation = (0..k).map(relative).fold(0.0, f64::max);
        if best.as_ref().is_none_or(|(least, _)| violation < *least) {
            best = Some((violation, z));
        }
        if violation == 0.0 {
            break;
        }
    }
    let (violation, z) = best?;
    if violation > 1.0 {
        return None;
    }
    let z = z.map(|value| value.max(0.0));
    let w = matrix * &z + q;
    // Impulses may change along the kernel over all contacts that stay closed.
    let closed: Vec<usize> = (0..k).filter(|&i| w[i] * scale[i] <= limit[i]).collect();
    let block = DMatrix::from_fn(closed.len(), closed.len(), |r, c| matrix[(closed[r], closed[c])]);
    let mut is_open = vec![false; k];
    if !closed.is_empty() {
        let solver = SemidefiniteSolver::of_contacts(&block);
        for (r, &i) in closed.iter().enumerate() {
            let mut own = DVector::zeros(closed.len());
            own[r] = 1.0;
            is_open[i] = solver.is_open(&own);
        }
    }
    Some(Complementary { z, is_open })
}

/// Rounding of the scaled speeds of contacts, relative to the largest scaled speed. A contact that can hardly move adds the rounding of its
/// speed, relative to the largest speed. `scale`: factors of the speeds.
pub(crate) fn speed_rounding(scale: &DVector<f64>, speeds: &DVector<f64>) -> DVector<f64> {
    let size = speeds.component_mul(scale).amax();
    scale.map(|scale| COMPLEMENTARY * size + SPEED_ROUNDING * speeds.amax() * scale)
}
