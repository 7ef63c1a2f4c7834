//! Multipliers of a group of constraints: one solution, and the combinations that redundancy leaves open.

use crate::numerics::pivoted_qr::PivotedQr;
use crate::tolerances::{INVOLVED, MOST_OPEN, OPEN_COMPONENT, OPEN_PER_FLOOR};
use faer::Mat;
use percuss_dynamics::{ConstraintGroup, Pose};

/// A group of constraints with the pivoted decomposition A P = Q R of its rows over scaled coordinates. The last columns of Q span
/// ker Aᵀ.
#[derive(Clone, Debug)]
pub(crate) struct GroupRows {
    group: ConstraintGroup,
    qr: PivotedQr,
}

impl GroupRows {
    /// Decomposes the rows of a group. Cost: O(rows² · coordinates).
    pub fn new(group: ConstraintGroup) -> Self {
        let mut rows = Self { group, qr: PivotedQr::default() };
        rows.decompose();
        rows
    }

    /// Moves the group to another pose of the same system, in which it has this number, and reuses its memory.
    pub fn update(&mut self, pose: &Pose, number: usize) {
        pose.update_constraint_group(number, &mut self.group);
        self.decompose();
    }

    fn decompose(&mut self) {
        let Self { group, qr } = self;
        let (m, n) = group.rows.shape();
        qr.decompose(m, n, |r, c| group.rows[(r, c)] / group.lengths[c]);
        if m == 0 || n == 0 || qr.r(0, 0) == 0.0 {
            group.rank = 0;
        }
    }

    /// The group.
    pub fn group(&self) -> &ConstraintGroup {
        &self.group
    }

    /// Indices of the coordinates of the group.
    pub fn coordinates(&self) -> &[usize] {
        &self.group.coordinates
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.group.rows.nrows()
    }

    /// True if some rows are linear combinations of others.
    pub fn is_redundant(&self) -> bool {
        self.group.rank < self.rows()
    }

    /// Relative error of the null spaces of the rows, from the accuracy of the rows.
    pub fn relative_error(&self) -> f64 {
        self.group.floor / self.group.least_singular_value
    }

    /// Sensitivity, relative to a unit multiplier, above which a quantity is open.
    fn open_threshold(&self) -> f64 {
        (OPEN_PER_FLOOR * self.relative_error()).clamp(OPEN_COMPONENT, MOST_OPEN)
    }

    /// Appends to `multipliers` the multipliers λ of least norm with Aᵀλ = `forces` (generalised forces on the coordinates of the model).
    /// Returns the largest residual |Aᵀλ − forces| over scaled coordinates. `y`: scratch.
    pub fn add_multipliers(&self, forces: &[f64], multipliers: &mut Vec<f64>, y: &mut Vec<f64>) -> f64 {
        let (group, rank) = (&self.group, self.group.rank);
        let scaled = |k: usize| {
            let at = self.qr.order()[k];
            forces[group.coordinates[at]] / group.lengths[at]
        };
        y.clear();
        y.resize(rank, 0.0);
        for k in 0..rank {
            let known: f64 = (0..k).map(|i| self.qr.r(i, k) * y[i]).sum();
            y[k] = (scaled(k) - known) / self.qr.r(k, k);
        }
        let rest = |k: usize| scaled(k) - (0..rank).map(|i| self.qr.r(i, k) * y[i]).sum::<f64>();
        let residual = (rank..group.coordinates.len()).map(|k| rest(k).abs()).fold(0.0, f64::max);
        let first = multipliers.len();
        multipliers.resize(first + self.rows(), 0.0);
        for (i, y) in y.iter().enumerate() {
            multipliers[first..].iter_mut().zip(self.qr.q_column(i)).for_each(|(sum, q)| *sum += q * y);
        }
        residual
    }

    /// Projection of a linear function of the multipliers on ker Aᵀ: Z Zᵀ s.
    fn open_part(&self, sensitivity: &[f64]) -> Vec<f64> {
        let open = self.group.rank..self.rows();
        let weights: Vec<f64> = open
            .clone()
            .map(|k| self.qr.q_column(k).iter().zip(sensitivity).map(|(q, x)| q * x).sum())
            .collect();
        let entry = |row: usize| open.clone().zip(&weights).map(|(k, w)| self.qr.q(row, k) * w).sum();
        (0..self.rows()).map(entry).collect()
    }

    /// Constraints, by index into the group, that leave the value of a linear function of the multipliers open; empty
    /// if the value is determinate. `unit`: size of the function at a unit multiplier.
    pub fn open_constraints(&self, sensitivity: &[f64], unit: f64) -> Vec<usize> {
        if !self.is_redundant() {
            return Vec::new();
        }
        let open = self.open_part(sensitivity);
        let norm = |values: &[f64]| values.iter().map(|x| x * x).sum::<f64>().sqrt();
        if norm(&open) <= self.open_threshold() * unit {
            return Vec::new();
        }
        let parts = self.group.constraints.iter().map(|c| norm(&open[c.first..c.first + c.count]));
        let parts: Vec<f64> = parts.collect();
        let largest = parts.iter().copied().fold(0.0, f64::max);
        (0..parts.len()).filter(|&i| parts[i] > INVOLVED * largest).collect()
    }

    /// Names of the [`open_constraints`](Self::open_constraints).
    pub fn open_names(&self, sensitivity: &[f64], unit: f64) -> Vec<String> {
        let open = self.open_constraints(sensitivity, unit);
        open.into_iter().map(|index| self.group.constraints[index].name.clone()).collect()
    }

    /// Basis of ker A as columns of (coordinate of the model, entry), orthonormal over coordinates scaled by `lengths`
    /// (one length per coordinate of the model).
    pub fn kernel(&self, lengths: &[f64]) -> Vec<Vec<(usize, f64)>> {
        let (group, rank) = (&self.group, self.group.rank);
        let n = group.coordinates.len();
        if rank == 0 {
            return group.coordinates.iter().map(|&c| vec![(c, 1.0)]).collect();
        }
        // The independent rows R₁ Pᵀ, rescaled from the lengths of the group to those of the model.
        let order = self.qr.order();
        let scale: Vec<f64> =
            order.iter().map(|&at| group.lengths[at] / lengths[group.coordinates[at]]).collect();
        let transposed = PivotedQr::new(n, rank, |k, i| self.qr.r(i, k) * scale[k]);
        let column =
            |k: usize| (0..n).map(|at| (group.coordinates[order[at]], transposed.q(at, k))).collect();
        (rank..n).map(column).collect()
    }

    /// Independent rows spanning the rows of A, over the coordinates of the group without scaling, rank × coordinates.
    pub fn independent_rows(&self) -> Mat<f64> {
        let (group, rank) = (&self.group, self.group.rank);
        let mut rows = Mat::zeros(rank, group.coordinates.len());
        for (k, &at) in self.qr.order().iter().enumerate() {
            for i in 0..rank {
                rows[(i, at)] = self.qr.r(i, k) * group.lengths[at];
            }
        }
        rows
    }
}
