//! Pivot rows and dependent coordinates of a group, by complete pivoting, and the resulting rates.

use super::rank::{Rank, decide_rank, singular_values};
use crate::kinematics::frames::Kinematics;
use crate::kinematics::rows::GroupRows;
use crate::linear::dense;
use crate::linear::sparse::{self, SparseRows};
use crate::model::{Group, Model};
use crate::tolerances::{DENSE_LIMIT, GAP_ROUNDING, RANK_MARGIN, SINGULAR_VALUES_LIMIT, SURE_PIVOT};

/// Eliminated rows and columns of a group's A, in order. K = A[rows, columns] is regular, and the coordinates in
/// `columns` depend on the others.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Pivots {
    pub rows: Vec<usize>,
    pub columns: Vec<usize>,
}

/// Mobility decisions for a group at a pose.
#[derive(Clone, Debug, Default)]
pub(crate) struct GroupMobility {
    pub rank: Rank,
    /// Zero threshold relative to the largest singular value: the accuracy of the rows and of the motions that
    /// satisfy the rows.
    pub floor: f64,
    pub pivots: Pivots,
    /// Independent coordinates (by index into the group), ascending.
    pub independent: Vec<usize>,
    /// |K⁻¹||A|, dependent × independent coordinates: the sum of the term magnitudes of each rate, over coordinates
    /// scaled by the group's lengths. Empty for groups decided by sparse pivots; the entries are then taken as 1.
    pub sizes: Vec<f64>,
    /// G of the group, coordinates × independent, row by row: rates over the independent coordinates. Empty for
    /// groups decided by sparse pivots.
    pub rates: Vec<f64>,
    /// Rows on which the decisions are based.
    pub rows: GroupRows,
}

impl GroupMobility {
    /// Entry of |K⁻¹||A| for a dependent and an independent coordinate, by their indices.
    pub fn size(&self, dependent: usize, independent: usize) -> f64 {
        self.sizes.get(dependent * self.independent.len() + independent).copied().unwrap_or(1.0)
    }

    /// Multipliers λ of the rows with Aᵀλ = f over the coordinates of the group, for forces f that do no work in admissible
    /// motions; 0 for rows without a pivot.
    pub fn multipliers(&self, group: &Group, forces: &[f64]) -> Vec<f64> {
        let Pivots { rows, columns } = &self.pivots;
        // −K⁻ᵀ times an additional column with the entries −f.
        let extra = group.rows;
        let mut transposed = SparseRows::default();
        transposed.load(group.coordinates.len(), extra + 1, |add| {
            self.rows.for_each(group, |row, column, value| add(column, row, value));
            forces.iter().enumerate().for_each(|(column, force)| add(column, extra, -force));
        });
        // Rows without a pivot keep the multiplier 0.
        let mut values = vec![0.0; extra + 1];
        values[extra] = 1.0;
        transposed.solve(columns, rows, &[extra], &mut values);
        values.truncate(extra);
        values
    }

    /// Recomputes rows and rates at other frames, with the same pivots.
    pub fn update_rates(&mut self, model: &Model, group: &Group, kinematics: &Kinematics) {
        self.rows.fill(model, group, kinematics);
        if !self.rates.is_empty() {
            let mut rates = Rates::default();
            rates.fill_from(&self.rows, group, self);
            self.rates = rates.values;
        }
    }
}

/// Buffers for mobility decisions; refilled in place.
#[derive(Clone, Debug, Default)]
pub(crate) struct MobilityWorkspace {
    dense: Vec<f64>,
    sizes: Vec<f64>,
    done: Vec<bool>,
    used: Vec<bool>,
    /// For each row: size and column of the largest entry among unused columns.
    largest: Vec<(f64, usize)>,
    values: Vec<f64>,
}

impl Model {
    /// Decides the rank and the dependent coordinates of a group at a pose. `floor`: zero threshold relative to the
    /// largest singular value. `expected`: the generic rank, if known.
    pub fn decide_mobility(
        &self,
        workspace: &mut MobilityWorkspace,
        kinematics: &Kinematics,
        group: &Group,
        floor: f64,
        expected: Option<usize>,
        decided: &mut GroupMobility,
    ) {
        let n = group.coordinates.len();
        decided.rows.fill(self, group, kinematics);
        if n > DENSE_LIMIT {
            decide_large(group, floor, decided);
            return;
        }
        decided.floor = floor;
        let seen = workspace.eliminate(group, floor, group.rows.min(n), decided);
        let count = decided.pivots.rows.len();
        let sure = expected == Some(count)
            && seen.last >= SURE_PIVOT * seen.first
            && seen.left <= floor / RANK_MARGIN * seen.first;
        decided.rank = if sure {
            let left = seen.left.max(GAP_ROUNDING * seen.first);
            let (gap, least) = if count > 0 {
                (seen.last / left, seen.last / seen.first)
            } else {
                (1.0 / f64::EPSILON, 1.0)
            };
            Rank { rank: count, gap, least, clear: true }
        } else {
            workspace.fill_scaled(group, &decided.rows);
            dense::singular_values(&mut workspace.dense, n, &mut workspace.values);
            decide_rank(&workspace.values, floor)
        };
        if decided.rank.rank != count {
            workspace.eliminate(group, 0.0, decided.rank.rank, decided);
        }
        let GroupMobility { pivots, independent, sizes, .. } = decided;
        sizes.clear();
        for r in &pivots.rows {
            sizes.extend(independent.iter().map(|y| workspace.sizes[r * n + y]));
        }
    }
}

/// Rank of a group's rows: by singular values, or by sparse pivots for large groups.
pub(crate) fn rank_of_rows(rows: &GroupRows, group: &Group, floor: f64) -> Rank {
    if group.coordinates.len() > SINGULAR_VALUES_LIMIT {
        return eliminate_large(rows, group, floor).1;
    }
    let mut matrix = nalgebra::DMatrix::zeros(group.rows, group.coordinates.len());
    rows.for_each(group, |row, column, value| matrix[(row, column)] += value);
    decide_rank(&singular_values(&matrix, &group.lengths), floor)
}

/// Decides rank and pivots of a large group by sparse pivots.
fn decide_large(group: &Group, floor: f64, decided: &mut GroupMobility) {
    let (pivots, rank) = eliminate_large(&decided.rows, group, floor);
    let mut depends = vec![false; group.coordinates.len()];
    pivots.columns.iter().for_each(|c| depends[*c] = true);
    let GroupMobility { independent, sizes, rates, .. } = decided;
    independent.clear();
    independent.extend((0..depends.len()).filter(|c| !depends[*c]));
    sizes.clear();
    rates.clear();
    (decided.rank, decided.floor, decided.pivots) = (rank, floor, pivots);
}

/// Eliminates the rows of a large group by sparse pivots.
fn eliminate_large(rows: &GroupRows, group: &Group, floor: f64) -> (Pivots, Rank) {
    let mut scaled = SparseRows::default();
    scaled.load(group.rows, group.coordinates.len(), |add| {
        rows.for_each(group, |r, c, a| add(r, c, a / group.lengths[c]));
    });
    let sparse::SparseElimination { rows, columns, scale, least, left } =
        sparse::eliminate(&mut scaled, floor);
    let pivots = Pivots { rows, columns };
    let rank = if pivots.rows.is_empty() {
        Rank::NONE
    } else {
        Rank {
            rank: pivots.rows.len(),
            gap: least / left.max(GAP_ROUNDING * scale),
            least: least / scale,
            clear: least > RANK_MARGIN * floor * scale && left < floor * scale / RANK_MARGIN,
        }
    };
    (pivots, rank)
}

/// Pivot sizes of a complete pivoting.
struct PivotSizes {
    first: f64,
    last: f64,
    /// Largest remaining entry.
    left: f64,
}

impl MobilityWorkspace {
    /// Fills A over coordinates scaled by lengths.
    fn fill_scaled(&mut self, group: &Group, rows: &GroupRows) {
        rows.dense_into(group, &mut self.dense);
        for row in self.dense.chunks_exact_mut(group.coordinates.len().max(1)) {
            row.iter_mut().zip(&group.lengths).for_each(|(a, length)| *a /= length);
        }
    }

    /// Gauss–Jordan elimination with complete pivoting over coordinates scaled by lengths. Stops after `limit`
    /// pivots, or at a pivot below `floor` times the first. Stores the pivots, the independent coordinates and the
    /// rates.
    fn eliminate(
        &mut self,
        group: &Group,
        floor: f64,
        limit: usize,
        decided: &mut GroupMobility,
    ) -> PivotSizes {
        let (m, n) = (group.rows, group.coordinates.len());
        let GroupMobility { pivots, independent, rates, rows, .. } = decided;
        pivots.rows.clear();
        pivots.columns.clear();
        self.fill_scaled(group, rows);
        self.sizes.clear();
        self.sizes.resize(m * n, 0.0);
        // Each entry is a sum of terms as large as the row's largest entry, even if the terms cancel.
        rows.for_each(group, |row, column, _| self.sizes[row * n + column] = 1.0);
        for (row, sizes) in self.dense.chunks_exact(n.max(1)).zip(self.sizes.chunks_exact_mut(n.max(1))) {
            let largest = row.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
            sizes.iter_mut().for_each(|s| *s *= largest);
        }
        self.done.clear();
        self.done.resize(m, false);
        self.used.clear();
        self.used.resize(n, false);
        self.largest.clear();
        self.largest.resize(m, (0.0, 0));
        (0..m).for_each(|r| self.find_largest(r, n));
        let mut seen = PivotSizes { first: 0.0, last: 0.0, left: 0.0 };
        loop {
            let mut best = (0.0, 0, 0);
            for r in (0..m).filter(|r| !self.done[*r]) {
                let (size, c) = self.largest[r];
                if size > best.0 {
                    best = (size, r, c);
                }
            }
            let (size, r, c) = best;
            if pivots.rows.is_empty() {
                seen.first = size;
            }
            seen.left = size;
            if pivots.rows.len() == limit || size <= floor * seen.first || size == 0.0 {
                break;
            }
            (self.done[r], self.used[c]) = (true, true);
            seen.last = size;
            pivots.rows.push(r);
            pivots.columns.push(c);
            self.clear_column(r, c, m, n);
        }
        if pivots.rows.len() == m.min(n) {
            seen.left = 0.0;
        }
        independent.clear();
        independent.extend((0..n).filter(|c| !self.used[*c]));
        self.fill_rates(group, pivots, independent, rates);
        seen
    }

    /// Updates the largest entry of row `r` among unused columns.
    fn find_largest(&mut self, r: usize, n: usize) {
        let mut best = (0.0, 0);
        for (c, (entry, used)) in self.dense[r * n..(r + 1) * n].iter().zip(&self.used).enumerate() {
            if !used && entry.abs() > best.0 {
                best = (entry.abs(), c);
            }
        }
        self.largest[r] = best;
    }

    /// Computes G from the eliminated matrix, over unscaled coordinates.
    fn fill_rates(&self, group: &Group, pivots: &Pivots, independent: &[usize], rates: &mut Vec<f64>) {
        let (n, count) = (group.coordinates.len(), independent.len());
        rates.clear();
        rates.resize(n * count, 0.0);
        for (y, &free) in independent.iter().enumerate() {
            rates[free * count + y] = 1.0;
            for (r, c) in pivots.rows.iter().zip(&pivots.columns) {
                rates[c * count + y] = -self.dense[r * n + free] * group.lengths[free] / group.lengths[*c];
            }
        }
    }

    /// Divides row `r` by its entry in column `c`, and clears the column in all other rows.
    fn clear_column(&mut self, r: usize, c: usize, m: usize, n: usize) {
        let over = 1.0 / self.dense[r * n + c];
        for k in 0..n {
            self.dense[r * n + k] *= over;
            self.sizes[r * n + k] *= over.abs();
        }
        for other in (0..m).filter(|other| *other != r) {
            let factor = self.dense[other * n + c];
            if factor == 0.0 {
                continue;
            }
            subtract(&mut self.dense, (other, r), n, factor);
            subtract(&mut self.sizes, (other, r), n, -factor.abs());
            self.dense[other * n + c] = 0.0;
            if !self.done[other] {
                self.find_largest(other, n);
            }
        }
    }
}

/// Subtracts a multiple of row `row` from row `from`.
fn subtract(rows: &mut [f64], (from, row): (usize, usize), n: usize, factor: f64) {
    let (start, end) = rows.split_at_mut(from.max(row) * n);
    let (from, row) = if from < row {
        (&mut start[from * n..(from + 1) * n], &end[..n])
    } else {
        (&mut end[..n], &start[row * n..(row + 1) * n])
    };
    for (x, y) in from.iter_mut().zip(row) {
        *x -= factor * *y;
    }
}

/// Rates of a group's coordinates over its independent coordinates: u = G y with G = [1; −K⁻¹ A[rows, independent]].
#[derive(Clone, Debug, Default)]
pub(crate) struct Rates {
    rows: GroupRows,
    dense: Vec<f64>,
    sparse: SparseRows,
    /// Coordinates × independent, row by row.
    pub values: Vec<f64>,
    /// Number of independent coordinates.
    pub count: usize,
}

impl Rates {
    /// Eliminates the dependent coordinates in the given order, at the frames in `kinematics`. Does not branch on
    /// values.
    pub fn fill(&mut self, model: &Model, group: &Group, kinematics: &Kinematics, known: &GroupMobility) {
        let mut rows = std::mem::take(&mut self.rows);
        rows.fill(model, group, kinematics);
        self.fill_from(&rows, group, known);
        self.rows = rows;
    }

    /// Eliminates the dependent coordinates of given rows, in the decided order.
    fn fill_from(&mut self, rows: &GroupRows, group: &Group, known: &GroupMobility) {
        let n = group.coordinates.len();
        self.count = known.independent.len();
        self.values.clear();
        self.values.resize(n * self.count, 0.0);
        for (y, &c) in known.independent.iter().enumerate() {
            self.values[c * self.count + y] = 1.0;
        }
        if n > DENSE_LIMIT {
            self.sparse.load(group.rows, n, |add| rows.for_each(group, add));
            let Pivots { rows, columns } = &known.pivots;
            self.sparse.solve(rows, columns, &known.independent, &mut self.values);
            return;
        }
        rows.dense_into(group, &mut self.dense);
        // Scaled exactly as in the decision, so that the results are bitwise equal.
        for row in self.dense.chunks_exact_mut(n.max(1)) {
            row.iter_mut().zip(&group.lengths).for_each(|(a, length)| *a /= *length);
        }
        for (&r, &c) in known.pivots.rows.iter().zip(&known.pivots.columns) {
            let over = 1.0 / self.dense[r * n + c];
            for k in 0..n {
                self.dense[r * n + k] *= over;
            }
            for &other in known.pivots.rows.iter().filter(|other| **other != r) {
                let factor = self.dense[other * n + c];
                for k in 0..n {
                    let change = factor * self.dense[r * n + k];
                    self.dense[other * n + k] -= change;
                }
            }
        }
        for (&r, &c) in known.pivots.rows.iter().zip(&known.pivots.columns) {
            for (y, &free) in known.independent.iter().enumerate() {
                let (from, to) = (group.lengths[free], group.lengths[c]);
                self.values[c * self.count + y] = -self.dense[r * n + free] * from / to;
            }
        }
    }
}
