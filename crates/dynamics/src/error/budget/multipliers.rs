//! Constraint multipliers of a group under a unit impulse.

use crate::linear::dense::solve_square;
use crate::linear::jacobian::Jacobian;
use crate::mobility::GroupMobility;
use crate::model::Group;
use crate::tolerances::DENSE_LIMIT;

/// Buffers for the multipliers of a group; refilled in place.
#[derive(Clone, Debug, Default)]
pub(super) struct MultiplierWorkspace {
    /// λ, one per pivot row.
    values: Vec<f64>,
    row_of: Vec<usize>,
    column_of: Vec<usize>,
    square: Vec<f64>,
}

impl MultiplierWorkspace {
    /// λ of a row; `None` for a row that is redundant.
    pub fn row_multiplier(&self, row: usize) -> Option<f64> {
        self.values.get(self.row_of[row]).copied()
    }

    /// Solves Kᵀ λ = force on the dependent coordinates, scaled by their lengths. One λ per pivot row.
    pub fn solve(&mut self, group: &Group, known: &GroupMobility, force: &dyn Fn(usize) -> f64) {
        let Self { values, row_of, column_of, square } = self;
        let count = known.pivots.rows.len();
        row_of.clear();
        row_of.resize(group.rows, usize::MAX);
        column_of.clear();
        column_of.resize(group.coordinates.len(), usize::MAX);
        known.pivots.rows.iter().enumerate().for_each(|(i, r)| row_of[*r] = i);
        known.pivots.columns.iter().enumerate().for_each(|(i, c)| column_of[*c] = i);
        values.clear();
        values.extend(known.pivots.columns.iter().map(|&c| force(c)));
        let entry = |r: usize, c: usize, a: f64| {
            let kept = row_of[r] != usize::MAX && column_of[c] != usize::MAX;
            kept.then(|| (column_of[c], row_of[r], a / group.lengths[c]))
        };
        if count > DENSE_LIMIT {
            let mut entries = Vec::new();
            known.rows.for_each(group, |r, c, a| entries.extend(entry(r, c, a)));
            *values = Jacobian { rows: count, columns: count, entries }.shortest(values, f64::EPSILON);
            return;
        }
        square.clear();
        square.resize(count * count, 0.0);
        known.rows.for_each(group, |r, c, a| {
            if let Some((i, k, a)) = entry(r, c, a) {
                square[i * count + k] += a;
            }
        });
        solve_square(square, values);
    }
}
