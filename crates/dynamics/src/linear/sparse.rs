//! Sparse elimination with pivots of least fill-in (Markowitz 1957). Pivots must not be small within their rows
//! (threshold pivoting: Duff, Erisman, Reid, Direct Methods for Sparse Matrices, 2017, §5.2; cited from memory).

use crate::tolerances::{SPARSE_CANDIDATES, SPARSE_PIVOT, STEP_RANK};
use std::collections::BTreeSet;

/// Rows of a sparse matrix, with entries in ascending column order.
#[derive(Clone, Debug, Default)]
pub(crate) struct SparseRows {
    rows: Vec<Vec<(usize, f64)>>,
    /// For each column: rows with an entry in the column. May contain outdated or repeated rows.
    column_rows: Vec<Vec<usize>>,
}

impl SparseRows {
    /// Loads a matrix from its entries (row, column, value), visited by `each`. Repeated entries are summed.
    pub fn load(
        &mut self,
        rows: usize,
        columns: usize,
        each: impl FnOnce(&mut dyn FnMut(usize, usize, f64)),
    ) {
        self.rows.clear();
        self.rows.resize(rows, Vec::new());
        each(&mut |row, column, value| self.rows[row].push((column, value)));
        self.column_rows.clear();
        self.column_rows.resize(columns, Vec::new());
        self.merge_entries();
    }

    /// Sorts the rows, sums repeated entries, and records the rows of each column.
    fn merge_entries(&mut self) {
        for row in &mut self.rows {
            row.sort_by_key(|(column, _)| *column);
            // Mimics cause repeated entries.
            let mut sums: Vec<(usize, f64)> = Vec::with_capacity(row.len());
            for (column, value) in row.drain(..) {
                match sums.last_mut() {
                    Some(last) if last.0 == column => last.1 += value,
                    _ => sums.push((column, value)),
                }
            }
            *row = sums;
        }
        for (r, row) in self.rows.iter().enumerate() {
            row.iter().for_each(|(c, _)| self.column_rows[*c].push(r));
        }
    }

    /// Entry of a row in a column, if stored.
    pub fn entry(&self, row: usize, column: usize) -> Option<f64> {
        let entries = &self.rows[row];
        entries.binary_search_by_key(&column, |(c, _)| *c).ok().map(|at| entries[at].1)
    }

    /// row ← row − entry/pivot · pivot row; the entry of the column is removed.
    fn subtract(&mut self, row: usize, pivot_row: usize, column: usize) {
        let (Some(entry), Some(pivot)) = (self.entry(row, column), self.entry(pivot_row, column)) else {
            return;
        };
        let factor = entry / pivot;
        let mut sum = Vec::with_capacity(self.rows[row].len() + self.rows[pivot_row].len());
        let mut own = self.rows[row].iter().peekable();
        for (c, value) in &self.rows[pivot_row] {
            while let Some(before) = own.next_if(|(o, _)| o < c) {
                sum.push(*before);
            }
            let before = own.next_if(|(o, _)| o == c);
            if *c == column {
                continue;
            }
            match before {
                Some((_, a)) => sum.push((*c, *a - factor * *value)),
                None => {
                    sum.push((*c, -(factor * *value)));
                    self.column_rows[*c].push(row);
                }
            }
        }
        sum.extend(own);
        self.rows[row] = sum;
    }

    /// Eliminates in the given order, and writes −K⁻¹A[rows, independent] to `values` (coordinates × independent).
    pub fn solve(&mut self, rows: &[usize], columns: &[usize], independent: &[usize], values: &mut [f64]) {
        let mut place = vec![usize::MAX; self.rows.len()];
        rows.iter().enumerate().for_each(|(i, r)| place[*r] = i);
        for (i, (&r, &c)) in rows.iter().zip(columns).enumerate() {
            let mut holders = std::mem::take(&mut self.column_rows[c]);
            holders.sort_unstable();
            holders.dedup();
            for other in holders {
                if place[other] != usize::MAX && place[other] > i {
                    self.subtract(other, r, c);
                }
            }
        }
        let count = independent.len();
        for (&r, &c) in rows.iter().zip(columns).rev() {
            let Some(pivot) = self.entry(r, c) else { continue };
            for y in 0..count {
                let others = self.rows[r].iter().filter(|(other, _)| *other != c);
                let sum = others.fold(0.0, |sum, (o, a)| sum + *a * values[o * count + y]);
                values[c * count + y] = -(sum / pivot);
            }
        }
    }
}

/// Result of an elimination.
pub(crate) struct SparseElimination {
    /// Rows and columns of the pivots, in order.
    pub rows: Vec<usize>,
    pub columns: Vec<usize>,
    /// Largest entry at the start.
    pub scale: f64,
    /// Smallest pivot, and largest remaining entry.
    pub least: f64,
    pub left: f64,
}

/// Ratio of the smallest pivot to the largest entry of a matrix given by its entries; 0 if the columns are dependent.
pub(crate) fn pivot_ratio(rows: usize, columns: usize, entries: &[(usize, usize, f64)]) -> f64 {
    let mut sparse = SparseRows::default();
    sparse.load(rows, columns, |add| entries.iter().for_each(|(r, c, a)| add(*r, *c, *a)));
    let found = eliminate(&mut sparse, STEP_RANK);
    if found.rows.len() < columns { 0.0 } else { found.least / found.scale }
}

/// Chooses pivots above `floor` times the largest entry, and eliminates with these pivots.
pub(crate) fn eliminate(sparse: &mut SparseRows, floor: f64) -> SparseElimination {
    eliminate_by_class(sparse, floor, &vec![0; sparse.column_rows.len()])
}

/// Like [`eliminate`], with pivots in columns of the lowest class first.
pub(crate) fn eliminate_by_class(sparse: &mut SparseRows, floor: f64, class: &[u8]) -> SparseElimination {
    let scale = sparse.rows.iter().map(|row| largest(row)).fold(0.0, f64::max);
    let (mut rows, mut columns) = (Vec::new(), Vec::new());
    let (mut least, mut left) = (f64::INFINITY, 0.0_f64);
    let mut is_open = vec![true; sparse.rows.len()];
    let mut classes: Vec<u8> = class.to_vec();
    classes.sort_unstable();
    classes.dedup();
    for current in classes {
        let allowed = |c: usize| class[c] <= current;
        let mut open: BTreeSet<(usize, usize)> =
            (0..is_open.len()).filter(|r| is_open[*r]).map(|r| (sparse.rows[r].len(), r)).collect();
        left = 0.0;
        while let Some((r, c)) = next_pivot(sparse, &mut open, &allowed, floor * scale, &mut left) {
            open.remove(&(sparse.rows[r].len(), r));
            is_open[r] = false;
            least = least.min(sparse.entry(r, c).map_or(0.0, f64::abs));
            rows.push(r);
            columns.push(c);
            let mut holders = std::mem::take(&mut sparse.column_rows[c]);
            holders.sort_unstable();
            holders.dedup();
            for other in holders.into_iter().filter(|o| is_open[*o]) {
                let was_open = open.remove(&(sparse.rows[other].len(), other));
                sparse.subtract(other, r, c);
                if was_open {
                    open.insert((sparse.rows[other].len(), other));
                }
            }
        }
    }
    SparseElimination { rows, columns, scale, least, left }
}

fn largest(row: &[(usize, f64)]) -> f64 {
    row.iter().fold(0.0, |most: f64, (_, a)| most.max(a.abs()))
}

/// Pivot of least fill-in among the rows with the fewest entries. Rows with only rounding in the allowed columns are
/// removed from `open`, and their largest entry is recorded in `left`.
fn next_pivot(
    sparse: &SparseRows,
    open: &mut BTreeSet<(usize, usize)>,
    allowed: &impl Fn(usize) -> bool,
    zero: f64,
    left: &mut f64,
) -> Option<(usize, usize)> {
    loop {
        let mut best: Option<(usize, f64, usize, usize)> = None;
        let mut aside = Vec::new();
        for &(count, r) in open.iter().take(SPARSE_CANDIDATES) {
            let row = sparse.rows[r].iter().filter(|(c, _)| allowed(*c));
            let largest = row.clone().fold(0.0, |most: f64, (_, a)| most.max(a.abs()));
            if largest <= zero {
                *left = left.max(largest);
                aside.push((count, r));
                continue;
            }
            for (c, a) in row.filter(|(_, a)| a.abs() >= SPARSE_PIVOT * largest) {
                let fill = (count - 1) * (sparse.column_rows[*c].len().saturating_sub(1));
                if best.is_none_or(|(least, size, ..)| fill < least || fill == least && a.abs() > size) {
                    best = Some((fill, a.abs(), r, *c));
                }
            }
        }
        aside.iter().for_each(|known| {
            open.remove(known);
        });
        match best {
            Some((_, _, r, c)) => return Some((r, c)),
            None if aside.is_empty() => return None,
            None => {}
        }
    }
}
