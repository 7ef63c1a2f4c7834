//! Which rows of a group's A count and which coordinates depend on which, by complete pivoting; and the rates that follow.

use super::rank::{Rank, decide, singular_values};
use crate::kinematics::Kinematics;
use crate::linear::dense;
use crate::linear::sparse::{self, SparseRows};
use crate::model::{Group, Model};
use crate::rows::GroupRows;
use crate::tolerances::{DENSE_LIMIT, RANK_MARGIN, SINGULAR_VALUES_LIMIT, SURE_PIVOT};
use percuss_spatial::Scalar;

/// Which rows and columns of a group's A are eliminated, in this order: K = A[rows, columns] is regular, and the
/// coordinates in `columns` depend on the others.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Pivots {
    pub rows: Vec<usize>,
    pub columns: Vec<usize>,
}

/// What is decided about a group at a pose.
#[derive(Clone, Debug, Default)]
pub(crate) struct GroupMobility {
    pub rank: Rank,
    /// What counts as zero here, as a part of the largest: rows, and a motion that they leave, are not known better.
    pub floor: f64,
    pub pivots: Pivots,
    /// Coordinates (by index into the group's) that do not depend, ascending.
    pub independent: Vec<usize>,
    /// |K⁻¹||A|: for each dependent coordinate, for each independent one, the size of the terms that its rate is the
    /// sum of; over coordinates scaled by the group's lengths. Empty of a group that is decided by sparse pivots: not known,
    /// and taken as 1.
    pub sizes: Vec<f64>,
}

impl GroupMobility {
    /// The entry of |K⁻¹||A| for a dependent and an independent coordinate, by their numbers.
    pub fn size(&self, dependent: usize, independent: usize) -> f64 {
        self.sizes.get(dependent * self.independent.len() + independent).copied().unwrap_or(1.0)
    }
}

/// Room to decide about groups; refilled in place.
#[derive(Clone, Debug, Default)]
pub(crate) struct MobilityRoom {
    rows: GroupRows<f64>,
    dense: Vec<f64>,
    sizes: Vec<f64>,
    done: Vec<bool>,
    used: Vec<bool>,
    values: Vec<f64>,
}

impl Model {
    /// Decides the rank of a group at a pose and which coordinates depend. `floor`: singular values below this part of
    /// the largest count as zero; `expected`: its generic rank, if it is known.
    pub fn decide_mobility(
        &self,
        room: &mut MobilityRoom,
        kinematics: &Kinematics<f64>,
        group: &Group,
        floor: f64,
        expected: Option<usize>,
        decided: &mut GroupMobility,
    ) {
        let n = group.coordinates.len();
        room.rows.fill(self, group, kinematics);
        if n > DENSE_LIMIT {
            *decided = decide_large(&room.rows, group, floor);
            return;
        }
        decided.floor = floor;
        let seen = room.eliminate(group, floor, group.rows.min(n), &mut decided.pivots);
        let count = decided.pivots.rows.len();
        let sure = expected == Some(count)
            && seen.last >= SURE_PIVOT * seen.first
            && seen.left <= floor / RANK_MARGIN * seen.first;
        decided.rank = if sure {
            let left = seen.left.max(1e-3 * f64::EPSILON * seen.first);
            let (gap, least) = if count > 0 {
                (seen.last / left, seen.last / seen.first)
            } else {
                (1.0 / f64::EPSILON, 1.0)
            };
            Rank { rank: count, gap, least, clear: true }
        } else {
            room.fill_scaled(group);
            dense::singular_values(&mut room.dense, n, &mut room.values);
            decide(&room.values, floor)
        };
        if decided.rank.rank != count {
            room.eliminate(group, 0.0, decided.rank.rank, &mut decided.pivots);
        }
        decided.independent.clear();
        decided.independent.extend((0..n).filter(|c| !room.used[*c]));
        decided.sizes.clear();
        for r in &decided.pivots.rows {
            decided.sizes.extend(decided.independent.iter().map(|y| room.sizes[r * n + y]));
        }
    }
}

/// The rank of a group's rows: by singular values, or by sparse pivots where it is large.
pub(crate) fn rank_of_rows(rows: &GroupRows<f64>, group: &Group, floor: f64) -> Rank {
    if group.coordinates.len() > SINGULAR_VALUES_LIMIT {
        return decide_large(rows, group, floor).rank;
    }
    let mut matrix = nalgebra::DMatrix::zeros(group.rows, group.coordinates.len());
    rows.for_each(group, |row, column, value| matrix[(row, column)] += value);
    decide(&singular_values(&matrix, &group.lengths), floor)
}

/// Decides rank and pivots of a large group, by sparse pivots.
fn decide_large(rows: &GroupRows<f64>, group: &Group, floor: f64) -> GroupMobility {
    let mut scaled = SparseRows::default();
    scaled.load(group.rows, group.coordinates.len(), |add| {
        rows.for_each(group, |r, c, a| add(r, c, a / group.lengths[c]));
    });
    let sparse::Eliminated { rows, columns, scale, least, left } = sparse::eliminate(&mut scaled, floor);
    let pivots = Pivots { rows, columns };
    let mut depends = vec![false; group.coordinates.len()];
    pivots.columns.iter().for_each(|c| depends[*c] = true);
    let independent: Vec<usize> = (0..depends.len()).filter(|c| !depends[*c]).collect();
    let rank = if pivots.rows.is_empty() {
        Rank::NONE
    } else {
        Rank {
            rank: pivots.rows.len(),
            gap: least / left.max(1e-3 * f64::EPSILON * scale),
            least: least / scale,
            clear: least > RANK_MARGIN * floor * scale && left < floor * scale / RANK_MARGIN,
        }
    };
    GroupMobility { rank, floor, pivots, independent, sizes: Vec::new() }
}

/// What complete pivoting met.
struct Seen {
    first: f64,
    last: f64,
    /// The largest entry that is left.
    left: f64,
}

impl MobilityRoom {
    /// A over coordinates scaled by lengths.
    fn fill_scaled(&mut self, group: &Group) {
        self.rows.dense_into(group, &mut self.dense);
        for row in self.dense.chunks_exact_mut(group.coordinates.len().max(1)) {
            row.iter_mut().zip(&group.lengths).for_each(|(a, length)| *a /= length);
        }
    }

    /// Gauss–Jordan elimination with complete pivoting over coordinates scaled by lengths, of at most `limit` pivots above
    /// `floor` times the first.
    fn eliminate(&mut self, group: &Group, floor: f64, limit: usize, pivots: &mut Pivots) -> Seen {
        let (m, n) = (group.rows, group.coordinates.len());
        pivots.rows.clear();
        pivots.columns.clear();
        self.fill_scaled(group);
        self.sizes.clear();
        self.sizes.resize(m * n, 0.0);
        // An entry is the sum of terms as large as the row's largest, also where they cancel.
        self.rows.for_each(group, |row, column, _| self.sizes[row * n + column] = 1.0);
        for (row, sizes) in self.dense.chunks_exact(n.max(1)).zip(self.sizes.chunks_exact_mut(n.max(1))) {
            let largest = row.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
            sizes.iter_mut().for_each(|s| *s *= largest);
        }
        self.done.clear();
        self.done.resize(m, false);
        self.used.clear();
        self.used.resize(n, false);
        let mut seen = Seen { first: 0.0, last: 0.0, left: 0.0 };
        loop {
            let mut best = (0.0, 0, 0);
            for r in (0..m).filter(|r| !self.done[*r]) {
                for c in (0..n).filter(|c| !self.used[*c]) {
                    let size = self.dense[r * n + c].abs();
                    if size > best.0 {
                        best = (size, r, c);
                    }
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
        seen
    }

    /// Divides row `r` by its entry in column `c` and clears the column from all other rows.
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
            for k in 0..n {
                self.dense[other * n + k] -= factor * self.dense[r * n + k];
                self.sizes[other * n + k] += factor.abs() * self.sizes[r * n + k];
            }
            self.dense[other * n + c] = 0.0;
        }
    }
}

/// Rates of a group's coordinates over its independent ones: u = G y with G = [1; −K⁻¹ A[rows, independent]].
#[derive(Clone, Debug)]
pub(crate) struct Rates<T: Scalar> {
    rows: GroupRows<T>,
    dense: Vec<T>,
    sparse: SparseRows<T>,
    /// coordinates × independent, row by row.
    pub values: Vec<T>,
    /// How many are independent.
    pub count: usize,
    /// The pivots in their order, where they are eliminated densely.
    pivots: Vec<T>,
}

impl<T: Scalar> Default for Rates<T> {
    fn default() -> Self {
        Self {
            rows: GroupRows::default(),
            dense: Vec::new(),
            sparse: SparseRows::default(),
            values: Vec::new(),
            count: 0,
            pivots: Vec::new(),
        }
    }
}

impl<T: Scalar> Rates<T> {
    /// Eliminates the dependent coordinates in the order given, at the frames in `kinematics`. Branches on no value.
    pub fn fill(&mut self, model: &Model, group: &Group, kinematics: &Kinematics<T>, known: &GroupMobility) {
        let n = group.coordinates.len();
        self.count = known.independent.len();
        self.values.clear();
        self.values.resize(n * self.count, T::zero());
        for (y, &c) in known.independent.iter().enumerate() {
            self.values[c * self.count + y] = T::one();
        }
        self.rows.fill(model, group, kinematics);
        self.pivots.clear();
        if n > DENSE_LIMIT {
            self.sparse.load(group.rows, n, |add| self.rows.for_each(group, add));
            let Pivots { rows, columns } = &known.pivots;
            self.sparse.solve(rows, columns, &known.independent, &mut self.values);
            return;
        }
        self.rows.dense_into(group, &mut self.dense);
        for (&r, &c) in known.pivots.rows.iter().zip(&known.pivots.columns) {
            self.pivots.push(self.dense[r * n + c]);
            let over = T::one() / self.dense[r * n + c];
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
                self.values[c * self.count + y] = -self.dense[r * n + free];
            }
        }
    }

    /// The sum of (zero/pivot)² over the pivots that were last eliminated, over coordinates scaled by lengths; zero is the
    /// group's floor of the size of A.
    pub fn pivot_loss(&self, group: &Group, known: &GroupMobility) -> T {
        let over = |c: usize| T::from_f64(1.0 / group.lengths[c]);
        let mut square = T::zero();
        self.rows.for_each(group, |_, c, a| square += a * a * over(c) * over(c));
        let zero = T::from_f64(known.floor * known.floor) * square;
        let mut loss = T::zero();
        for (i, (&r, &c)) in known.pivots.rows.iter().zip(&known.pivots.columns).enumerate() {
            let dense = || self.pivots.get(i).copied();
            let pivot = dense().or_else(|| self.sparse.entry(r, c)).unwrap_or_else(T::zero) * over(c);
            loss += zero / (pivot * pivot);
        }
        loss
    }
}
