//! Least-squares solution of minimum norm: min ‖x‖ subject to minimal ‖Jx − b‖, for groups of every size.

use super::dense::{cholesky, cholesky_solve, dot, orthogonal_pivot_ratio};
use super::sparse::{SparseRows, eliminate, pivot_ratio};
use crate::tolerances::{DENSE_LIMIT, NORMAL_EQUATIONS_FILL, STEP_RANK, WELL_CONDITIONED};
use faer::linalg::solvers::{Solve, SolveLstsq};
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};

/// Matrix A over the directions of motion of a group, measured in metres.
#[derive(Clone, Debug)]
pub(crate) struct Jacobian {
    pub rows: usize,
    pub columns: usize,
    /// (row, column, value); repeated entries are summed.
    pub entries: Vec<(usize, usize, f64)>,
}

/// Factorised normal equations of a Jacobian, for any number of right-hand sides.
pub(crate) struct NormalEquations {
    wide: bool,
    /// Length of the vectors, and the vectors one after another: the columns of J, or the rows of a wide J.
    length: usize,
    vectors: Vec<f64>,
    factor: Vec<f64>,
}

impl NormalEquations {
    /// x of minimum norm with least ‖Jx − b‖.
    pub fn shortest(&self, target: &[f64]) -> Vec<f64> {
        let vectors = self.vectors.chunks_exact(self.length);
        if !self.wide {
            let mut x: Vec<f64> = vectors.map(|column| dot(column, target)).collect();
            cholesky_solve(&self.factor, &mut x);
            return x;
        }
        let mut z = target.to_vec();
        cholesky_solve(&self.factor, &mut z);
        let mut x = vec![0.0; self.length];
        for (row, z) in vectors.zip(z) {
            x.iter_mut().zip(row).for_each(|(x, a)| *x += a * z);
        }
        x
    }
}

impl Jacobian {
    /// Jᵀ.
    pub fn transposed(&self) -> Self {
        let entries = self.entries.iter().map(|&(r, c, a)| (c, r, a)).collect();
        Self { rows: self.columns, columns: self.rows, entries }
    }

    /// J x.
    pub fn times(&self, x: &[f64]) -> Vec<f64> {
        let mut product = vec![0.0; self.rows];
        self.entries.iter().for_each(|(r, c, a)| product[*r] += a * x[*c]);
        product
    }

    pub fn dense(&self) -> Mat<f64> {
        let mut dense = Mat::zeros(self.rows, self.columns);
        self.entries.iter().for_each(|(r, c, a)| dense[(*r, *c)] += a);
        dense
    }

    fn largest(&self) -> f64 {
        self.entries.iter().fold(0.0, |most, (_, _, a)| most.max(a.abs()))
    }

    /// x of minimum norm with least ‖Jx − b‖. Pivots below `floor` times the first are omitted: in a rounded file,
    /// nearly redundant rows contradict one another, and their solution lies far away.
    pub fn shortest(&self, target: &[f64], floor: f64) -> Vec<f64> {
        match self.normal_equations(floor) {
            Some(equations) => equations.shortest(target),
            None => self.shortest_by_factors(target, floor),
        }
    }

    /// x of minimum norm with least ‖Jx − b‖, without normal equations.
    pub fn shortest_by_factors(&self, target: &[f64], floor: f64) -> Vec<f64> {
        if self.columns == 0 || self.rows == 0 || self.largest() == 0.0 {
            return vec![0.0; self.columns];
        }
        if self.columns > DENSE_LIMIT && self.rows > DENSE_LIMIT {
            return self.shortest_sparse(target, floor.max(STEP_RANK));
        }
        least_norm(&self.dense(), target, floor.max(STEP_RANK))
    }

    /// Factorises JᵀJ, or JJᵀ for a wide J. `None` unless the singular values are so similar that their squares keep
    /// eight digits. The next Newton step removes the remaining error.
    pub fn normal_equations(&self, floor: f64) -> Option<NormalEquations> {
        let (m, n) = (self.rows, self.columns);
        if floor >= WELL_CONDITIONED || m == 0 || n == 0 || m.min(n) > DENSE_LIMIT {
            return None;
        }
        let wide = n > m;
        let (count, length) = if wide { (m, n) } else { (n, m) };
        let mut vectors = vec![0.0; count * length];
        for &(r, c, a) in &self.entries {
            let (vector, at) = if wide { (r, c) } else { (c, r) };
            vectors[vector * length + at] += a;
        }
        let mut factor = vec![0.0; count * count];
        for (i, own) in vectors.chunks_exact(length).enumerate() {
            for (k, other) in vectors.chunks_exact(length).take(i + 1).enumerate() {
                factor[i * count + k] = dot(own, other);
            }
        }
        cholesky(&mut factor, count, WELL_CONDITIONED * WELL_CONDITIONED).then_some(NormalEquations {
            wide,
            length,
            vectors,
            factor,
        })
    }

    /// Minimises ‖Jx − b‖² + λ² σ² ‖x‖², with σ the largest entry of J.
    pub fn damped(&self, target: &[f64], damping: f64) -> Vec<f64> {
        let (m, n) = (self.rows, self.columns);
        let weight = damping * self.largest();
        if n == 0 || m == 0 || weight == 0.0 {
            return vec![0.0; n];
        }
        if n <= DENSE_LIMIT {
            let mut stacked = Mat::zeros(m + n, n);
            self.entries.iter().for_each(|(r, c, a)| stacked[(*r, *c)] += a);
            (0..n).for_each(|c| stacked[(m + c, c)] = weight);
            let right = Mat::from_fn(m + n, 1, |r, _| if r < m { target[r] } else { 0.0 });
            let x = stacked.qr().solve_lstsq(right);
            return (0..n).map(|c| x[(c, 0)]).collect();
        }
        if m <= DENSE_LIMIT {
            return self.damped_by_rows(target, weight);
        }
        let all: Vec<usize> = (0..m).collect();
        self.by_gram(&all, target, weight).unwrap_or_else(|| vec![0.0; n])
    }

    /// x = Jᵀz with (JJᵀ + w²)z = b, by the triangular factor of [Jᵀ; w].
    fn damped_by_rows(&self, target: &[f64], weight: f64) -> Vec<f64> {
        let (m, n) = (self.rows, self.columns);
        let mut stacked = Mat::zeros(n + m, m);
        self.entries.iter().for_each(|(r, c, a)| stacked[(*c, *r)] += a);
        (0..m).for_each(|r| stacked[(n + r, r)] = weight);
        let qr = stacked.qr();
        let r = qr.thin_R();
        let mut y = vec![0.0; m];
        for i in 0..m {
            let known: f64 = (0..i).map(|k| r[(k, i)] * y[k]).sum();
            y[i] = (target[i] - known) / r[(i, i)];
        }
        let mut z = y;
        for i in (0..m).rev() {
            let known: f64 = (i + 1..m).map(|k| r[(i, k)] * z[k]).sum();
            z[i] = (z[i] - known) / r[(i, i)];
        }
        let mut x = vec![0.0; n];
        self.entries.iter().for_each(|(r, c, a)| x[*c] += a * z[*r]);
        x
    }

    /// x = Jᵣᵀ(JᵣJᵣᵀ)⁻¹bᵣ on independent rows r, by sparse Cholesky factors. Falls back to a step of the dependent
    /// columns alone if these products would fill in.
    fn shortest_sparse(&self, target: &[f64], floor: f64) -> Vec<f64> {
        let mut sparse = SparseRows::default();
        sparse.load(self.rows, self.columns, |add| self.entries.iter().for_each(|(r, c, a)| add(*r, *c, *a)));
        let found = eliminate(&mut sparse, floor);
        let mut place = vec![usize::MAX; self.rows];
        found.rows.iter().enumerate().for_each(|(i, r)| place[*r] = i);
        let right: Vec<f64> = found.rows.iter().map(|r| target[*r]).collect();
        let x = self.by_gram(&place, &right, 0.0);
        x.unwrap_or_else(|| self.dependent_step(target, &found.rows, &found.columns))
    }

    /// x = Jᵣᵀz with (JᵣJᵣᵀ + w²)z = b. `place`: index of each row among the rows r. `None` if the product would fill
    /// in, or is not positive within rounding.
    fn by_gram(&self, place: &[usize], right: &[f64], weight: f64) -> Option<Vec<f64>> {
        let mut columns: Vec<Vec<(usize, f64)>> = vec![Vec::new(); self.columns];
        for (r, c, a) in self.entries.iter().filter(|(r, ..)| place[*r] != usize::MAX) {
            columns[*c].push((place[*r], *a));
        }
        let products: usize = columns.iter().map(|c| c.len() * c.len()).sum();
        if products > NORMAL_EQUATIONS_FILL {
            return None;
        }
        let m = right.len();
        let z = if products < m * m {
            solve_sparse_gram(&columns, right, weight)?
        } else {
            solve_dense_gram(&columns, right, weight)?
        };
        let mut x = vec![0.0; self.columns];
        for (c, column) in columns.iter().enumerate() {
            x[c] = column.iter().map(|(r, a)| a * z[*r]).sum();
        }
        x.iter().all(|x| x.is_finite()).then_some(x)
    }

    /// K⁻¹b on the pivot columns; the other columns are zero.
    fn dependent_step(&self, target: &[f64], rows: &[usize], columns: &[usize]) -> Vec<f64> {
        let n = self.columns;
        let mut sparse = SparseRows::default();
        sparse.load(self.rows, n + 1, |add| {
            self.entries.iter().for_each(|(r, c, a)| add(*r, *c, *a));
            target.iter().enumerate().for_each(|(r, b)| add(r, n, -b));
        });
        let mut values = vec![0.0; n + 1];
        values[n] = 1.0;
        sparse.solve(rows, columns, &[n], &mut values);
        values.truncate(n);
        values
    }

    /// Ratio of the smallest to the largest pivot; 0 with fewer rows than columns, 1 for an empty or zero matrix.
    pub fn pivot_ratio(&self) -> f64 {
        if self.columns == 0 || self.largest() == 0.0 {
            return 1.0;
        }
        if self.rows < self.columns {
            return 0.0;
        }
        if self.columns > DENSE_LIMIT {
            return pivot_ratio(self.rows, self.columns, &self.entries);
        }
        let mut columns = vec![0.0; self.rows * self.columns];
        self.entries.iter().for_each(|(r, c, a)| columns[c * self.rows + r] += a);
        orthogonal_pivot_ratio(&mut columns, self.rows)
    }

    /// Projection of `before` on the kernel of J.
    pub fn projected(&self, before: &[f64], floor: f64) -> Vec<f64> {
        let back = self.shortest(&self.times(before), floor);
        before.iter().zip(back).map(|(b, x)| b - x).collect()
    }
}

/// z with (JJᵀ + w²)z = b. `columns`: rows and values of each column of J. `None` if the matrix is not positive to
/// rounding.
fn solve_sparse_gram(columns: &[Vec<(usize, f64)>], right: &[f64], weight: f64) -> Option<Vec<f64>> {
    let m = right.len();
    let mut triplets: Vec<Triplet<usize, usize, f64>> = Vec::new();
    for column in columns {
        for (r, a) in column {
            triplets.extend(column.iter().map(|(k, b)| Triplet::new(*r, *k, a * b)));
        }
    }
    triplets.extend((0..m).map(|r| Triplet::new(r, r, weight * weight)));
    let gram = SparseColMat::<usize, f64>::try_new_from_triplets(m, m, &triplets).ok()?;
    let factor = gram.sp_cholesky(Side::Lower).ok()?;
    let z = factor.solve(Mat::from_fn(m, 1, |r, _| right[r]));
    Some((0..m).map(|r| z[(r, 0)]).collect())
}

/// Same as [`solve_sparse_gram`] with a dense matrix, for a JJᵀ with more products than entries: sorting the products
/// would take most of the time.
fn solve_dense_gram(columns: &[Vec<(usize, f64)>], right: &[f64], weight: f64) -> Option<Vec<f64>> {
    let m = right.len();
    let mut gram = Mat::<f64>::zeros(m, m);
    for column in columns {
        for (k, b) in column {
            column.iter().for_each(|(r, a)| gram[(*r, *k)] += a * b);
        }
    }
    (0..m).for_each(|r| gram[(r, r)] += weight * weight);
    let factor = gram.llt(Side::Lower).ok()?;
    let z = factor.solve(Mat::from_fn(m, 1, |r, _| right[r]));
    Some((0..m).map(|r| z[(r, 0)]).collect())
}

/// x of minimum norm by a complete orthogonal factorisation of J, or of Jᵀ for a wide J.
fn least_norm(jacobian: &Mat<f64>, target: &[f64], floor: f64) -> Vec<f64> {
    let (m, n) = (jacobian.nrows(), jacobian.ncols());
    if n > m {
        return least_norm_wide(jacobian, target, floor);
    }
    let qr = jacobian.col_piv_qr();
    let r = qr.R();
    let size = m.min(n);
    let first = r[(0, 0)].abs();
    let rank = (0..size).take_while(|&i| r[(i, i)].abs() > floor * first).count();
    let right = Mat::from_fn(m, 1, |i, _| target[i]);
    let rotated = qr.compute_thin_Q().transpose() * right;
    let order = qr.P().arrays().0;
    let mut x = vec![0.0; n];
    if rank == n {
        for i in (0..n).rev() {
            let known: f64 = (i + 1..n).map(|k| r[(i, k)] * x[order[k]]).sum();
            x[order[i]] = (rotated[(i, 0)] - known) / r[(i, i)];
        }
        return x;
    }
    // [R₁₁ R₁₂] Pᵀx = c has a solution; the shortest is Q₂ T⁻ᵀ c with [R₁₁ R₁₂]ᵀ = Q₂ T.
    let upper = Mat::from_fn(n, rank, |c, i| if c >= i { r[(i, c)] } else { 0.0 });
    let second = upper.qr();
    let t = second.thin_R();
    let mut y = Mat::<f64>::zeros(rank, 1);
    for i in 0..rank {
        let known: f64 = (0..i).map(|k| t[(k, i)] * y[(k, 0)]).sum();
        y[(i, 0)] = (rotated[(i, 0)] - known) / t[(i, i)];
    }
    let permuted = second.compute_thin_Q() * y;
    (0..n).for_each(|i| x[order[i]] = permuted[(i, 0)]);
    x
}

/// Jᵀ P = Q [R₁ R₂; 0 0]: x = Q y with R₁ᵀ y = (Pᵀb)₁ for independent rows, in the least-squares sense otherwise.
fn least_norm_wide(jacobian: &Mat<f64>, target: &[f64], floor: f64) -> Vec<f64> {
    let m = jacobian.nrows();
    let qr = jacobian.transpose().to_owned().col_piv_qr();
    let r = qr.R();
    let first = r[(0, 0)].abs();
    let rank = (0..m).take_while(|&i| r[(i, i)].abs() > floor * first).count();
    let order = qr.P().arrays().0;
    // Pᵀ J Q = [R₁ R₂]ᵀ, m × rank.
    let lower = Mat::from_fn(m, rank, |i, k| if k <= i { r[(k, i)] } else { 0.0 });
    let right = Mat::from_fn(m, 1, |i, _| target[order[i]]);
    let y = lower.qr().solve_lstsq(right);
    let q = qr.compute_thin_Q();
    let x = q.get(.., ..rank) * y.get(..rank, ..);
    (0..jacobian.ncols()).map(|c| x[(c, 0)]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn jacobian(rows: usize, columns: usize, of: impl Fn(usize, usize) -> f64) -> Jacobian {
        let places = (0..rows).flat_map(|r| (0..columns).map(move |c| (r, c)));
        Jacobian { rows, columns, entries: places.map(|(r, c)| (r, c, of(r, c))).collect() }
    }

    #[test]
    fn the_shortest_solution_of_a_deficient_system() {
        // Rank 1: x + 2y = 5 twice (the second times 3).
        let j = jacobian(2, 2, |r, c| [1.0, 2.0][c] * [1.0, 3.0][r]);
        let x = j.shortest(&[5.0, 15.0], STEP_RANK);
        assert!((x[0] - 1.0).abs() < 1e-14 && (x[1] - 2.0).abs() < 1e-14);
        let x = jacobian(1, 3, |_, c| [3.0, 0.0, 4.0][c]).shortest(&[25.0], STEP_RANK);
        assert!((x[0] - 3.0).abs() < 1e-14 && x[1].abs() < 1e-15 && (x[2] - 4.0).abs() < 1e-14);
        assert_eq!(jacobian(2, 2, |_, _| 0.0).shortest(&[5.0, 15.0], STEP_RANK), [0.0, 0.0]);
    }

    #[test]
    fn every_shape_is_solved_alike() {
        // A banded matrix with a repeated row, for comparison of the sparse, wide and dense methods.
        let entry = |r: usize, c: usize| match c.checked_sub(r) {
            Some(0) => 2.0 + (r as f64).sin(),
            Some(1) => -1.0,
            Some(2) => 0.3,
            _ => 0.0,
        };
        for (m, n) in [(70, 72), (20, 100), (66, 80)] {
            let row = |r: usize| if r == m - 1 { m - 2 } else { r };
            let j = jacobian(m, n, |r, c| entry(row(r), c));
            let b: Vec<f64> = (0..m).map(|r| (row(r) as f64 * 0.7).cos()).collect();
            let x = j.shortest(&b, STEP_RANK);
            let exact = least_norm(&j.dense(), &b, STEP_RANK);
            let apart = x.iter().zip(&exact).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            // JJᵀ squares the condition number, about 30 here.
            assert!(apart < 1e-12, "{m} {n}: {apart}");
        }
    }
}
