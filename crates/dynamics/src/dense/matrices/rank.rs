//! Rank decision for the rows of the caller's A.

use crate::mobility::{Rank, Redundancy, decide_rank, singular_values};
use crate::model::interruption;
use crate::model::structure::partition::Partition;
use crate::tolerances::{REDUNDANCY_LIMIT, ROW_NOISE};
use nalgebra::DMatrix;

/// Rank of A, with redundant and doubtful rows.
#[derive(Clone, Debug, PartialEq)]
pub struct ConstraintRank {
    /// Number of independent rows.
    pub rank: usize,
    /// Smallest gap (ratio) between nonzero and zero singular values; `None` without constraints.
    pub gap: Option<f64>,
    /// True if no singular value is within a factor of 30 of the threshold, and none above rounding was dropped.
    pub is_clear: bool,
    /// Redundant rows, from 0, ascending. The choice of the redundant rows of a dependent set is arbitrary.
    pub redundant_rows: Vec<usize>,
    /// Sets of dependent rows, from 0, separated as far as possible. A row of zeros is a set by itself. Not computed
    /// for rows that share more than 400 coordinates.
    pub dependent_sets: Vec<Vec<usize>>,
    /// Independent rows, from 0, with all entries below the rounding (3e-13, or 10 times the accuracy) of another row
    /// with shared coordinates. Such a row is a constraint in small units, or only rounding. See
    /// [`MatrixOptions::row_noise`](super::MatrixOptions::row_noise).
    pub small_rows: Vec<usize>,
}

/// Thresholds of the rank decision.
pub(super) struct RankLimits {
    /// Threshold for singular values, relative to the largest; smaller values count as zero.
    pub floor: f64,
    /// Dropped singular values below this fraction of the largest are rounding.
    pub rounding: f64,
    /// Rows with no entry above this value, over scaled coordinates, count as zero. `None`: [`ROW_NOISE`] times the
    /// largest entry of the rows that share coordinates.
    pub row_noise: Option<f64>,
}

/// Scaled independent rows, and the report.
pub(super) struct Decided {
    /// Independent rows, each scaled by a power of two to a largest entry from 1 to 2 over scaled coordinates.
    pub rows: DMatrix<f64>,
    /// Smallest nonzero singular value, relative to the largest.
    pub least: f64,
    pub report: ConstraintRank,
}

/// Decides the rank of A, with coordinates scaled by lengths and each row scaled separately. Rows that share
/// coordinates, directly or through other rows, are decided together, independent of all other rows.
pub(super) fn decide_rows(mut a: DMatrix<f64>, lengths: &[f64], limits: &RankLimits) -> Decided {
    let (m, n) = a.shape();
    let mut report = ConstraintRank {
        rank: 0,
        gap: None,
        is_clear: true,
        redundant_rows: Vec::new(),
        dependent_sets: Vec::new(),
        small_rows: Vec::new(),
    };
    let mut sizes: Vec<f64> =
        (0..m).map(|r| (0..n).map(|c| (a[(r, c)] / lengths[c]).abs()).fold(0.0, f64::max)).collect();
    let mut noise = vec![limits.row_noise.unwrap_or(0.0); m];
    if limits.row_noise.is_none() {
        for (rows, _) in components(&a) {
            let largest = rows.iter().map(|&r| sizes[r]).fold(0.0, f64::max);
            rows.iter().for_each(|&r| noise[r] = ROW_NOISE * largest);
        }
    }
    for r in 0..m {
        let size = sizes[r];
        let is_zero = size <= noise[r];
        // A power of two scales without rounding.
        let factor = if is_zero { 0.0 } else { (-size.log2().floor()).exp2() };
        (0..n).for_each(|c| a[(r, c)] *= factor);
        sizes[r] = if is_zero { 0.0 } else { size };
    }
    let (mut counting, mut least) = (Vec::new(), 1.0_f64);
    for (rows, columns) in components(&a) {
        let Some(&first) = rows.first() else { continue };
        if sizes[first] == 0.0 {
            report.redundant_rows.push(first);
            report.dependent_sets.push(vec![first]);
            continue;
        }
        interruption::check();
        let own: Vec<f64> = columns.iter().map(|&c| lengths[c]).collect();
        let part = DMatrix::from_fn(rows.len(), columns.len(), |r, c| a[(rows[r], columns[c])]);
        let rank: Rank =
            decide_rank(&singular_values(&part, &own), limits.floor).explained_by(limits.rounding);
        report.rank += rank.rank;
        least = least.min(rank.least);
        report.is_clear &= rank.clear;
        report.gap = Some(report.gap.map_or(rank.gap, |gap| gap.min(rank.gap)));
        let counted: Vec<usize> = if rank.rank == rows.len() {
            rows.clone()
        } else {
            let order = independent_first(&part, &own, rank.rank);
            report.redundant_rows.extend(order[rank.rank..].iter().map(|&r| rows[r]));
            if columns.len() <= REDUNDANCY_LIMIT {
                let mut redundancy = Redundancy::default();
                redundancy.look_at(&part, &own, rank.rank, &rows);
                report.dependent_sets.append(&mut redundancy.sets);
            }
            order[..rank.rank].iter().map(|&r| rows[r]).collect()
        };
        let largest = rows.iter().map(|&r| sizes[r]).fold(0.0, f64::max);
        let is_small = |r: &&usize| sizes[**r] < limits.rounding * largest;
        report.small_rows.extend(counted.iter().filter(is_small));
        counting.extend(counted);
    }
    counting.sort_unstable();
    report.redundant_rows.sort_unstable();
    report.small_rows.sort_unstable();
    let matrix = a.select_rows(&counting);
    debug_assert_eq!(counting.len() + report.redundant_rows.len(), m);
    Decided { rows: matrix, least, report }
}

/// Row indices with `rank` independent rows first; columns are divided by `lengths`. The norms of the remaining rows
/// are recomputed in each step. An elimination with updated norms, as in faer, loses norms below √ε of the row.
fn independent_first(matrix: &DMatrix<f64>, lengths: &[f64], rank: usize) -> Vec<usize> {
    let (m, n) = matrix.shape();
    let mut left = DMatrix::from_fn(n, m, |c, r| matrix[(r, c)] / lengths[c]);
    let mut order: Vec<usize> = (0..m).collect();
    for k in 0..rank.min(m) {
        interruption::check();
        let norm = |r: usize| left.column(r).norm();
        let next = (k..m).max_by(|&a, &b| norm(order[a]).total_cmp(&norm(order[b]))).unwrap_or(k);
        order.swap(k, next);
        let size = norm(order[k]);
        if size == 0.0 {
            break;
        }
        let direction = left.column(order[k]) / size;
        for &r in &order[k + 1..] {
            // The second pass removes the rounding of the first.
            for _ in 0..2 {
                let along = direction.dot(&left.column(r));
                left.column_mut(r).axpy(-along, &direction, 1.0);
            }
        }
    }
    order
}

/// Sets of rows that share columns, with their columns.
fn components(a: &DMatrix<f64>) -> Vec<(Vec<usize>, Vec<usize>)> {
    let (m, n) = a.shape();
    let mut sets = Partition::new(m + n);
    for c in 0..n {
        for r in (0..m).filter(|&r| a[(r, c)] != 0.0) {
            sets.join(r, m + c);
        }
    }
    let mut found: Vec<(Vec<usize>, Vec<usize>)> = vec![Default::default(); m];
    for r in 0..m {
        found[sets.root(r)].0.push(r);
    }
    for c in 0..n {
        let root = sets.root(m + c);
        if root < m {
            found[root].1.push(c);
        }
    }
    found
}
