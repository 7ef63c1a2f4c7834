//! Which rows of the caller's A count.

use crate::mobility::{Rank, Redundancy, decide, singular_values};
use crate::tolerances::REDUNDANCY_LIMIT;
use crate::union::Partition;
use faer::Mat;
use nalgebra::DMatrix;

/// What was decided about the rows of A.
#[derive(Clone, Debug, PartialEq)]
pub struct ConstraintRank {
    /// How many rows are independent.
    pub rank: usize,
    /// Least gap between singular values that count and those that do not; none without constraints.
    pub gap: Option<f64>,
    /// Whether no singular value is within a factor of 30 of the threshold.
    pub is_clear: bool,
    /// Rows, from 0, that follow from those that count; ascending. Which rows of a dependent set count is a choice.
    pub redundant_rows: Vec<usize>,
    /// Sets of rows, from 0, that depend on one another, each as small as it can be separated from the others; a row of
    /// zeros is a set by itself. Not looked for among rows that bind more than 400 coordinates.
    pub dependent_sets: Vec<Vec<usize>>,
}

/// The rows that count, scaled, and the report.
pub(super) struct Decided {
    /// Each scaled to an entry of at most 1 over scaled coordinates.
    pub rows: DMatrix<f64>,
    /// The least singular value that counts, as a part of the largest.
    pub least: f64,
    pub report: ConstraintRank,
}

/// Decides the rank of A, coordinates scaled by lengths. Rows that share coordinates, directly or through one another, are
/// decided together, scaled to an entry of at most 1; others have no influence on them.
pub(super) fn decide_rows(a: &DMatrix<f64>, lengths: &[f64], floor: f64) -> Decided {
    let (m, n) = a.shape();
    let mut report = ConstraintRank {
        rank: 0,
        gap: None,
        is_clear: true,
        redundant_rows: Vec::new(),
        dependent_sets: Vec::new(),
    };
    let (mut counting, mut least) = (Vec::new(), 1.0_f64);
    for (rows, columns) in components(a) {
        let Some(&first) = rows.first() else { continue };
        let own: Vec<f64> = columns.iter().map(|&c| lengths[c]).collect();
        let scaled = |r: usize, c: usize| a[(rows[r], columns[c])] / own[c];
        let largest = (0..rows.len())
            .flat_map(|r| (0..columns.len()).map(move |c| scaled(r, c).abs()))
            .fold(0.0, f64::max);
        if largest == 0.0 {
            report.redundant_rows.push(first);
            report.dependent_sets.push(vec![first]);
            continue;
        }
        let part = DMatrix::from_fn(rows.len(), columns.len(), |r, c| a[(rows[r], columns[c])] / largest);
        let rank: Rank = decide(&singular_values(&part, &own), floor);
        report.rank += rank.rank;
        least = least.min(rank.least);
        report.is_clear &= rank.clear;
        report.gap = Some(report.gap.map_or(rank.gap, |gap| gap.min(rank.gap)));
        if rank.rank == rows.len() {
            counting.extend(&rows);
            continue;
        }
        let transposed = Mat::from_fn(columns.len(), rows.len(), |c, r| scaled(r, c) / largest);
        let qr = transposed.col_piv_qr();
        let order = qr.P().arrays().0;
        counting.extend(order[..rank.rank].iter().map(|&r| rows[r]));
        report.redundant_rows.extend(order[rank.rank..].iter().map(|&r| rows[r]));
        if columns.len() <= REDUNDANCY_LIMIT {
            let mut redundancy = Redundancy::default();
            redundancy.look_at(&part, &own, rank.rank, &rows);
            report.dependent_sets.append(&mut redundancy.sets);
        }
    }
    counting.sort_unstable();
    report.redundant_rows.sort_unstable();
    let mut matrix = DMatrix::zeros(counting.len(), n);
    for (to, &r) in counting.iter().enumerate() {
        let largest = (0..n).map(|c| (a[(r, c)] / lengths[c]).abs()).fold(0.0, f64::max);
        (0..n).for_each(|c| matrix[(to, c)] = a[(r, c)] / largest);
    }
    debug_assert_eq!(counting.len() + report.redundant_rows.len(), m);
    Decided { rows: matrix, least, report }
}

/// Rows that share columns, with these.
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
