//! Householder QR decomposition with column pivoting, for the small matrices of one group of constraints.

/// Decomposition A P = Q R. Q is orthogonal, rows × rows; R is upper triangular with diagonal entries of decreasing magnitude.
///
/// Library decompositions are blocked for large matrices and take several microseconds for matrices of a few rows. Cost: O(rows ·
/// columns · min(rows, columns)). Source: Golub and Van Loan 2013, §5.4.2.
#[derive(Clone, Debug, Default)]
pub(crate) struct PivotedQr {
    rows: usize,
    /// Q, column by column.
    q: Vec<f64>,
    /// R, column by column.
    r: Vec<f64>,
    order: Vec<usize>,
    /// Vector of the last reflection.
    reflector: Vec<f64>,
}

impl PivotedQr {
    /// Decomposes the matrix with the entries `entry(row, column)`. A zero matrix gives Q = 1 and R = 0.
    pub fn new(rows: usize, columns: usize, entry: impl Fn(usize, usize) -> f64) -> Self {
        let mut of = Self::default();
        of.decompose(rows, columns, entry);
        of
    }

    /// Decomposes another matrix in the same memory.
    pub fn decompose(&mut self, rows: usize, columns: usize, entry: impl Fn(usize, usize) -> f64) {
        self.rows = rows;
        self.r.clear();
        for c in 0..columns {
            self.r.extend((0..rows).map(|i| entry(i, c)));
        }
        self.q.clear();
        self.q.resize(rows * rows, 0.0);
        (0..rows).for_each(|i| self.q[i * (rows + 1)] = 1.0);
        self.order.clear();
        self.order.extend(0..columns);
        let mut reflector = std::mem::take(&mut self.reflector);
        reflector.resize(rows, 0.0);
        for k in 0..rows.min(columns) {
            let norm = self.pivot(k, columns);
            if norm == 0.0 {
                break;
            }
            let tail = &mut reflector[k..];
            tail.copy_from_slice(&self.r[k * rows + k..(k + 1) * rows]);
            let diagonal = if tail[0] > 0.0 { -norm } else { norm };
            tail[0] -= diagonal;
            let factor = 2.0 / tail.iter().map(|x| x * x).sum::<f64>();
            for column in self.r[k * rows..].chunks_exact_mut(rows) {
                reflect(&mut column[k..], tail, factor);
            }
            self.r[k * rows + k] = diagonal;
            self.r[k * rows + k + 1..(k + 1) * rows].fill(0.0);
            self.reflect_rows_of_q(k, tail, factor);
        }
        self.reflector = reflector;
    }

    /// Swaps the column of the largest norm below row `k` into position `k`. Returns the norm.
    fn pivot(&mut self, k: usize, columns: usize) -> f64 {
        let rows = self.rows;
        let norm = |c: usize| self.r[c * rows + k..(c + 1) * rows].iter().map(|x| x * x).sum::<f64>();
        let mut best = (k, norm(k));
        for c in k + 1..columns {
            let norm = norm(c);
            if norm > best.1 {
                best = (c, norm);
            }
        }
        if best.0 != k {
            self.order.swap(k, best.0);
            let (left, right) = self.r.split_at_mut(best.0 * rows);
            left[k * rows..(k + 1) * rows].swap_with_slice(&mut right[..rows]);
        }
        best.1.sqrt()
    }

    /// Q := Q H for the reflection H of the coordinates from `k`.
    fn reflect_rows_of_q(&mut self, k: usize, reflector: &[f64], factor: f64) {
        let rows = self.rows;
        let q = &mut self.q[k * rows..];
        for i in 0..rows {
            let sum: f64 = reflector.iter().zip(q[i..].iter().step_by(rows)).map(|(v, q)| v * q).sum();
            let change = factor * sum;
            reflector.iter().zip(q[i..].iter_mut().step_by(rows)).for_each(|(v, q)| *q -= change * v);
        }
    }

    /// Entry of Q.
    pub fn q(&self, row: usize, column: usize) -> f64 {
        self.q[column * self.rows + row]
    }

    /// Column of Q.
    pub fn q_column(&self, column: usize) -> &[f64] {
        &self.q[column * self.rows..(column + 1) * self.rows]
    }

    /// Entry of R.
    pub fn r(&self, row: usize, column: usize) -> f64 {
        self.r[column * self.rows + row]
    }

    /// Order of the columns: column k of R belongs to column `order()[k]` of A.
    pub fn order(&self) -> &[usize] {
        &self.order
    }
}

/// x := x − factor · v (vᵀx).
fn reflect(x: &mut [f64], v: &[f64], factor: f64) {
    let change = factor * v.iter().zip(&*x).map(|(v, x)| v * x).sum::<f64>();
    x.iter_mut().zip(v).for_each(|(x, v)| *x -= change * v);
}

#[cfg(test)]
mod tests {
    use super::PivotedQr;

    /// Rounding error of a sum of about ten products of numbers up to one.
    const ROUNDING: f64 = 1e-14;

    #[test]
    fn the_factors_give_the_matrix() {
        for (rows, columns, rank) in [(3, 5, 3), (5, 3, 3), (4, 4, 2), (1, 1, 1), (3, 2, 0)] {
            let entry = |i: usize, c: usize| {
                (0..rank)
                    .map(|k| ((1 + i) as f64 * (0.7 + k as f64)).sin() * ((2 + c) as f64 + k as f64).cos())
                    .sum()
            };
            let qr = PivotedQr::new(rows, columns, entry);
            for i in 0..rows {
                for j in 0..rows {
                    let dot: f64 = (0..rows).map(|k| qr.q(k, i) * qr.q(k, j)).sum();
                    assert!((dot - f64::from(u8::from(i == j))).abs() < ROUNDING, "{i} {j}: {dot}");
                }
                for c in 0..columns {
                    let product: f64 = (0..rows).map(|k| qr.q(i, k) * qr.r(k, c)).sum();
                    let expected: f64 = entry(i, qr.order()[c]);
                    assert!((product - expected).abs() < ROUNDING, "{i} {c}: {product} {expected}");
                    assert!(c >= i || qr.r(i, c) == 0.0);
                }
            }
            let pivot = |k: usize| qr.r(k, k).abs();
            assert!((1..rows.min(columns)).all(|k| pivot(k) <= pivot(k - 1) * (1.0 + ROUNDING)));
            assert!((rank..rows.min(columns)).all(|k| pivot(k) < ROUNDING));
        }
    }
}
