//! Multipliers of a group of constraints: one solution, and the combinations that redundancy leaves open.

use crate::tolerances::{INVOLVED, MOST_OPEN, OPEN_COMPONENT, OPEN_PER_FLOOR};
use faer::Mat;
use percuss_dynamics::ConstraintGroup;

/// A group of constraints with the pivoted decomposition A P = Q R of its rows over scaled coordinates.
pub(crate) struct GroupRows {
    group: ConstraintGroup,
    /// Orthogonal, rows × rows. The last columns span ker Aᵀ.
    q: Mat<f64>,
    /// R, rows × coordinates.
    r: Mat<f64>,
    /// Order of the coordinates: column k of R belongs to coordinate `order[k]` of the group.
    order: Vec<usize>,
}

impl GroupRows {
    /// Decomposes the rows of a group. Cost: O(rows² · coordinates).
    pub fn new(group: ConstraintGroup) -> Self {
        let (m, n) = group.rows.shape();
        let scaled = Mat::from_fn(m, n, |r, c| group.rows[(r, c)] / group.lengths[c]);
        // The pivoted QR of faer returns NaN for a zero matrix.
        if m == 0 || n == 0 || group.rank == 0 || scaled.norm_max() == 0.0 {
            let group = ConstraintGroup { rank: 0, ..group };
            return Self { group, q: Mat::identity(m, m), r: Mat::zeros(m, n), order: (0..n).collect() };
        }
        let qr = scaled.col_piv_qr();
        let r = Mat::from_fn(m, n, |i, k| if i <= k && i < qr.R().nrows() { qr.R()[(i, k)] } else { 0.0 });
        let (q, order) = (qr.compute_Q(), qr.P().arrays().0.to_vec());
        Self { group, q, r, order }
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
    fn rows(&self) -> usize {
        self.q.nrows()
    }

    /// Relative error of the null spaces of the rows, from the accuracy of the rows.
    pub fn relative_error(&self) -> f64 {
        self.group.floor / self.group.least_singular_value
    }

    /// Sensitivity, relative to a unit multiplier, above which a quantity is open.
    fn open_threshold(&self) -> f64 {
        (OPEN_PER_FLOOR * self.relative_error()).clamp(OPEN_COMPONENT, MOST_OPEN)
    }

    /// Multipliers λ of least norm with Aᵀλ = `forces` (generalised forces on the coordinates of the model), and the
    /// largest residual |Aᵀλ − forces| over scaled coordinates.
    pub fn multipliers(&self, forces: &[f64]) -> (Vec<f64>, f64) {
        let (group, rank) = (&self.group, self.group.rank);
        let scaled = |k: usize| {
            let at = self.order[k];
            forces[group.coordinates[at]] / group.lengths[at]
        };
        let mut y = vec![0.0; rank];
        for k in 0..rank {
            let known: f64 = (0..k).map(|i| self.r[(i, k)] * y[i]).sum();
            y[k] = (scaled(k) - known) / self.r[(k, k)];
        }
        let rest = |k: usize| scaled(k) - (0..rank).map(|i| self.r[(i, k)] * y[i]).sum::<f64>();
        let residual = (rank..group.coordinates.len()).map(|k| rest(k).abs()).fold(0.0, f64::max);
        let multiplier = |row: usize| (0..rank).map(|i| self.q[(row, i)] * y[i]).sum();
        ((0..self.rows()).map(multiplier).collect(), residual)
    }

    /// Rates x with A x = `right`, of which as many as possible are zero: (coordinate of the model, rate).
    pub fn particular_rates(&self, right: &[f64]) -> Vec<(usize, f64)> {
        let (group, rank) = (&self.group, self.group.rank);
        let mut y: Vec<f64> =
            (0..rank).map(|k| (0..self.rows()).map(|row| self.q[(row, k)] * right[row]).sum()).collect();
        for k in (0..rank).rev() {
            let known: f64 = (k + 1..rank).map(|i| self.r[(k, i)] * y[i]).sum();
            y[k] = (y[k] - known) / self.r[(k, k)];
        }
        let rate = |(k, y): (usize, f64)| {
            let at = self.order[k];
            (group.coordinates[at], y / group.lengths[at])
        };
        y.into_iter().enumerate().map(rate).collect()
    }

    /// Projection of a linear function of the multipliers on ker Aᵀ: Z Zᵀ s.
    fn open_part(&self, sensitivity: &[f64]) -> Vec<f64> {
        let open = self.group.rank..self.rows();
        let weights: Vec<f64> =
            open.clone().map(|k| (0..self.rows()).map(|r| self.q[(r, k)] * sensitivity[r]).sum()).collect();
        let entry = |row: usize| open.clone().zip(&weights).map(|(k, w)| self.q[(row, k)] * w).sum();
        (0..self.rows()).map(entry).collect()
    }

    /// Constraints, by index into the group, that leave the value of a linear function of the multipliers open; empty
    /// if the value is determinate. `unit`: size of the function at a unit multiplier.
    pub fn open_constraints(&self, sensitivity: &[f64], unit: f64) -> Vec<usize> {
        if self.group.rank == self.rows() {
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

    /// Basis of ker A as columns of (coordinate of the model, entry), orthonormal over coordinates scaled by `lengths`
    /// (one length per coordinate of the model).
    pub fn kernel(&self, lengths: &[f64]) -> Vec<Vec<(usize, f64)>> {
        let (group, rank) = (&self.group, self.group.rank);
        let n = group.coordinates.len();
        if rank == 0 {
            return group.coordinates.iter().map(|&c| vec![(c, 1.0)]).collect();
        }
        // The independent rows R₁ Pᵀ, rescaled from the lengths of the group to those of the model.
        let mut transposed = Mat::zeros(n, rank);
        for k in 0..n {
            let at = self.order[k];
            let scale = group.lengths[at] / lengths[group.coordinates[at]];
            for i in 0..rank {
                transposed[(at, i)] = self.r[(i, k)] * scale;
            }
        }
        let q = transposed.col_piv_qr().compute_Q();
        let column = |k: usize| (0..n).map(|at| (group.coordinates[at], q[(at, k)])).collect();
        (rank..n).map(column).collect()
    }

    /// Independent rows spanning the rows of A, over the coordinates of the group without scaling, rank × coordinates.
    pub fn independent_rows(&self) -> Mat<f64> {
        let (group, rank) = (&self.group, self.group.rank);
        let mut rows = Mat::zeros(rank, group.coordinates.len());
        for (k, &at) in self.order.iter().enumerate() {
            for i in 0..rank {
                rows[(i, at)] = self.r[(i, k)] * group.lengths[at];
            }
        }
        rows
    }
}
