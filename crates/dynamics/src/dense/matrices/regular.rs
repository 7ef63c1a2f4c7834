//! m̄ of regular matrices: Cholesky factor of M, and orthogonal elimination of A.

use super::{MatrixOptions, MatrixView};
use crate::tolerances::{
    CLEAR_MASS, CLEAR_ROWS, LARGEST_ENTRY, LEAST_DIAGONAL, MATRIX_NOISE, MOST_REGULAR, REGULAR_ACCURACY,
    REGULAR_LOSS, SECOND_ORDER, SIMILAR_ROWS, SUM_ROUNDINGS, SYMMETRIC,
};

/// Workspace for m̄ of many small problems (M, j, A) with a regular M and clearly independent rows of A.
///
/// Allocates only if a problem is larger than all before.
#[derive(Clone, Debug, Default)]
pub struct RegularMatrices {
    /// L of S M S = L Lᵀ, n×n, row by row; S = 1/√M_kk.
    factor: Vec<f64>,
    /// L⁻¹, row by row.
    inverse: Vec<f64>,
    /// S.
    scales: Vec<f64>,
    /// Rows of A, then j.
    rows: Vec<f64>,
    /// The same rows, orthonormal.
    directions: Vec<f64>,
    /// L⁻¹ S times the rows; the first are made orthonormal.
    columns: Vec<f64>,
    /// R: components of each column along the earlier ones, and its remaining norm.
    triangle: Vec<f64>,
    /// v*, S⁻¹ v* and λ.
    velocity: Vec<f64>,
    multipliers: Vec<f64>,
}

impl RegularMatrices {
    /// m̄ and its error, in the unit of M; `None` if [`effective_mass`](super::effective_mass) must decide: M of a large condition, rows of
    /// A that are not clearly independent, a gap that hardly closes, invalid matrices, options other than the accuracy.
    ///
    /// With S M S = L Lᵀ, X = L⁻¹ S [Aᵀ jᵀ] = Q R: 1/m̄ = R_jj². The error has the terms of [`effective_mass`](super::effective_mass),
    /// at first order; terms of second order are below a hundredth of them. Cost: O(n³ + m²n).
    pub fn solve(
        &mut self,
        mass: &MatrixView<'_>,
        row: &MatrixView<'_>,
        constraints: Option<&MatrixView<'_>>,
        options: &MatrixOptions<'_>,
    ) -> Option<(f64, f64)> {
        let (n, m) = (mass.rows(), constraints.map_or(0, MatrixView::rows));
        let MatrixOptions { lengths: None, rank_floor: None, row_noise: None, accuracy } = *options else {
            return None;
        };
        let fits = mass.columns() == n
            && (row.rows(), row.columns()) == (1, n)
            && constraints.is_none_or(|rows| rows.columns() == n);
        let accuracies = [accuracy.mass, accuracy.constraints, accuracy.row];
        let is_small = (1..=MOST_REGULAR).contains(&n) && m < n;
        if !(fits && is_small && accuracies.iter().all(|own| (0.0..=REGULAR_ACCURACY).contains(own))) {
            return None;
        }
        let [of_mass, of_constraints, of_row] = accuracies.map(|own| own.max(f64::EPSILON));
        let roundings = SUM_ROUNDINGS * n as f64 * f64::EPSILON;
        let asymmetry = self.factorise(mass, n)?;
        let extremes = |(least, most): (f64, f64), scale: &f64| (scale.min(least), scale.max(most));
        let (least, most) = self.scales.iter().fold((f64::INFINITY, 0.0), extremes);
        // Coordinates whose masses are noise of others have none.
        if (least / most).powi(2) < CLEAR_MASS * MATRIX_NOISE * of_mass {
            return None;
        }
        let of_mass = of_mass + asymmetry + roundings;
        let condition = n as f64 * self.invert(n);
        self.read_rows(row, constraints, n, m)?;
        let clear = self.orthonormalise_rows(n, m)?;
        let independence = self.eliminate(n, m)?;
        let loss = of_mass.max(of_constraints).max(of_row) * condition;
        let is_first_order = loss <= REGULAR_LOSS * independence * clear;
        if !is_first_order {
            return None;
        }
        let own = &self.triangle[(m + 1) * m..];
        let effective = 1.0 / (own[m] * own[m]);
        self.find_velocity(effective, n, m);
        let terms = |row: usize| -> f64 {
            self.rows[row * n..][..n].iter().zip(&self.velocity).map(|(a, v)| (a * v).abs()).sum()
        };
        let norm =
            |row: usize| self.triangle[(m + 1) * row..][..=row].iter().map(|r| r * r).sum::<f64>().sqrt();
        let root = effective.sqrt();
        let energy: f64 = self.velocity.iter().zip(&self.scales).map(|(v, s)| (v / s).abs()).sum();
        let mut error = of_mass * energy * energy + roundings * effective;
        error += 2.0 * effective * (of_row * terms(m) + roundings * norm(m) * root);
        for (i, multiplier) in self.multipliers.iter().enumerate() {
            error += 2.0 * multiplier.abs() * (of_constraints * terms(i) + roundings * norm(i) * root);
        }
        error *= SECOND_ORDER;
        (effective.is_normal() && error.is_finite()).then_some((effective, error))
    }

    /// L, S, and the asymmetry of M relative to √(M_rr M_cc).
    fn factorise(&mut self, mass: &MatrixView<'_>, n: usize) -> Option<f64> {
        self.scales.clear();
        for k in 0..n {
            let own = mass.at(k, k);
            if !(LEAST_DIAGONAL..=LARGEST_ENTRY).contains(&own) {
                return None;
            }
            self.scales.push(1.0 / own.sqrt());
        }
        self.factor.clear();
        self.factor.resize(n * n, 0.0);
        let mut asymmetry = 0.0_f64;
        for r in 0..n {
            let (above, below) = self.factor.split_at_mut(r * n);
            let mut left = 1.0;
            for c in 0..r {
                let scale = self.scales[r] * self.scales[c];
                let (lower, upper) = (mass.at(r, c), mass.at(c, r));
                asymmetry = asymmetry.max((upper - lower).abs() * scale);
                let own = &above[c * n..][..=c];
                let known: f64 = own[..c].iter().zip(&below[..c]).map(|(a, b)| a * b).sum();
                let entry = (0.5 * (upper + lower) * scale - known) / own[c];
                below[c] = entry;
                left -= entry * entry;
            }
            // Entries that are not finite end here as well.
            if left.is_nan() || left <= 0.0 {
                return None;
            }
            below[r] = left.sqrt();
        }
        (asymmetry <= SYMMETRIC).then_some(asymmetry)
    }

    /// L⁻¹. Returns its squared norm, the trace of (S M S)⁻¹.
    fn invert(&mut self, n: usize) -> f64 {
        self.inverse.clear();
        self.inverse.resize(n * n, 0.0);
        let mut norm = 0.0;
        for r in 0..n {
            let own = &self.factor[r * n..][..=r];
            let (above, below) = self.inverse.split_at_mut(r * n);
            for (k, factor) in own[..r].iter().enumerate() {
                for (entry, known) in below[..=k].iter_mut().zip(&above[k * n..][..=k]) {
                    *entry -= factor * known;
                }
            }
            below[r] = 1.0;
            for entry in &mut below[..=r] {
                *entry /= own[r];
                norm += *entry * *entry;
            }
        }
        norm
    }

    /// Rows of A and j, and L⁻¹ S times each.
    fn read_rows(
        &mut self,
        row: &MatrixView<'_>,
        constraints: Option<&MatrixView<'_>>,
        n: usize,
        m: usize,
    ) -> Option<()> {
        self.rows.clear();
        let (mut smallest, mut largest) = (f64::INFINITY, 0.0_f64);
        for r in 0..m {
            let entry = |c| constraints.map_or(0.0, |rows| rows.at(r, c));
            self.rows.extend((0..n).map(entry));
            let size = self.rows[r * n..].iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            (smallest, largest) = (smallest.min(size), largest.max(size));
        }
        self.rows.extend((0..n).map(|c| row.at(0, c)));
        let is_number = |x: &f64| x.abs() <= LARGEST_ENTRY;
        let are_similar = m == 0 || smallest >= SIMILAR_ROWS * largest;
        if !self.rows.iter().all(is_number) || !are_similar {
            return None;
        }
        self.columns.clear();
        for row in self.rows.chunks_exact(n) {
            for r in 0..n {
                let own = &self.factor[r * n..][..=r];
                let solved = &self.columns[self.columns.len() - r..];
                let known: f64 = own[..r].iter().zip(solved).map(|(a, b)| a * b).sum();
                self.columns.push((row[r] * self.scales[r] - known) / own[r]);
            }
        }
        Some(())
    }

    /// Part of each row across the rows before it, relative to its norm: the least product. `None` if it is not clear.
    fn orthonormalise_rows(&mut self, n: usize, m: usize) -> Option<f64> {
        if m == 0 {
            return self.rows.iter().any(|j| *j != 0.0).then_some(1.0);
        }
        self.directions.clone_from(&self.rows);
        let found = orthonormalise(&mut self.directions, n, |_, _, _| {});
        (found >= CLEAR_ROWS).then_some(found)
    }

    /// Q R of the columns. Returns the product of the parts of the columns across the columns before them.
    fn eliminate(&mut self, n: usize, m: usize) -> Option<f64> {
        self.triangle.clear();
        self.triangle.resize((m + 1) * (m + 1), 0.0);
        let triangle = &mut self.triangle;
        let found = orthonormalise(&mut self.columns, n, |row, earlier, along| {
            triangle[(m + 1) * row + earlier] += along;
        });
        (found >= CLEAR_ROWS).then_some(found)
    }

    /// v* = S L⁻ᵀ m̄ r and λ of R λ = m̄ Qᵀ x_j.
    fn find_velocity(&mut self, effective: f64, n: usize, m: usize) {
        let last = &self.triangle[(m + 1) * m..];
        self.multipliers.clear();
        self.multipliers.extend(last[..m].iter().map(|along| effective * along));
        for i in (0..m).rev() {
            let sum: f64 = (i + 1..m).map(|k| self.triangle[(m + 1) * k + i] * self.multipliers[k]).sum();
            self.multipliers[i] = (self.multipliers[i] - sum) / self.triangle[(m + 1) * i + i];
        }
        self.velocity.clear();
        self.velocity.extend(self.columns[m * n..].iter().map(|unit| unit * effective * last[m]));
        for k in (0..n).rev() {
            let sum: f64 = (k + 1..n).map(|r| self.factor[r * n + k] * self.velocity[r]).sum();
            self.velocity[k] = (self.velocity[k] - sum) / self.factor[k * n + k];
        }
        for (v, scale) in self.velocity.iter_mut().zip(&self.scales) {
            *v *= scale;
        }
    }
}

/// Makes vectors of `n` numbers orthonormal, one after the other. `note` receives the number of a vector, of an earlier one (or its own), and
/// the component. Returns the product of the remaining parts, relative to the norms.
fn orthonormalise(vectors: &mut [f64], n: usize, mut note: impl FnMut(usize, usize, f64)) -> f64 {
    let mut product = 1.0;
    for i in 0..vectors.len() / n {
        let (earlier, own) = vectors.split_at_mut(i * n);
        let own = &mut own[..n];
        let norm = |own: &[f64]| own.iter().map(|x| x * x).sum::<f64>().sqrt();
        let before = norm(own);
        // The second pass removes the rounding of the first.
        for _ in 0..2 {
            for (k, unit) in earlier.chunks_exact(n).enumerate() {
                let along: f64 = unit.iter().zip(&*own).map(|(a, b)| a * b).sum();
                own.iter_mut().zip(unit).for_each(|(x, unit)| *x -= along * unit);
                note(i, k, along);
            }
        }
        let left = norm(own);
        note(i, i, left);
        product *= left / before;
        own.iter_mut().for_each(|x| *x /= left);
    }
    product
}
