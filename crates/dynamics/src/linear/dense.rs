//! Small square systems.

/// Solves A x = b in place by elimination with partial pivoting; A n×n, row by row. A zero pivot leaves infinities.
pub(crate) fn solve_square(a: &mut [f64], b: &mut [f64]) {
    let n = b.len();
    for k in 0..n {
        let size = |r: usize| a[r * n + k].abs();
        let Some(pivot) = (k..n).max_by(|&p, &q| size(p).total_cmp(&size(q))) else { return };
        if pivot != k {
            for c in 0..n {
                a.swap(k * n + c, pivot * n + c);
            }
            b.swap(k, pivot);
        }
        for r in k + 1..n {
            let factor = a[r * n + k] / a[k * n + k];
            for c in k + 1..n {
                a[r * n + c] -= factor * a[k * n + c];
            }
            b[r] -= factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|c| a[k * n + c] * b[c]).sum();
        b[k] = (b[k] - known) / a[k * n + k];
    }
}

/// Singular values, descending, of a matrix given row by row (m×n), by one-sided Jacobi rotations; allocates nothing once
/// `values` is large enough. Leaves the matrix rotated. Source: Hestenes 1958; Golub, Van Loan, Matrix Computations, 2013,
/// §8.6.3 (cited from memory).
pub(crate) fn singular_values(a: &mut [f64], n: usize, values: &mut Vec<f64>) {
    const SWEEPS: usize = 40;
    values.clear();
    if n == 0 {
        return;
    }
    for _ in 0..SWEEPS {
        let mut rotated = false;
        for p in 0..n {
            for q in p + 1..n {
                let (mut pp, mut qq, mut pq) = (0.0, 0.0, 0.0);
                for row in a.chunks_exact(n) {
                    pp += row[p] * row[p];
                    qq += row[q] * row[q];
                    pq += row[p] * row[q];
                }
                if pq.abs() <= f64::EPSILON * (pp * qq).sqrt() {
                    continue;
                }
                rotated = true;
                let slope = (qq - pp) / (2.0 * pq);
                let tangent = slope.signum() / (slope.abs() + (1.0 + slope * slope).sqrt());
                let cosine = 1.0 / (1.0 + tangent * tangent).sqrt();
                let sine = cosine * tangent;
                for row in a.chunks_exact_mut(n) {
                    (row[p], row[q]) = (cosine * row[p] - sine * row[q], sine * row[p] + cosine * row[q]);
                }
            }
        }
        if !rotated {
            break;
        }
    }
    values.extend((0..n).map(|c| a.chunks_exact(n).map(|row| row[c] * row[c]).sum::<f64>().sqrt()));
    values.sort_unstable_by(|a, b| b.total_cmp(a));
}

#[cfg(test)]
mod tests {
    use super::{singular_values, solve_square};

    #[test]
    fn singular_values_of_a_deficient_matrix() {
        // Singular values √10 times those of [1 2; 3 4]/√10, beside a repeated column and a zero one.
        let mut a = [1.0, 2.0, 0.0, 1.0, 3.0, 4.0, 0.0, 3.0];
        let mut values = Vec::new();
        singular_values(&mut a, 4, &mut values);
        let matrix = faer::Mat::from_fn(2, 4, |r, c| [[1.0, 2.0, 0.0, 1.0], [3.0, 4.0, 0.0, 3.0]][r][c]);
        let expected: Vec<f64> = matrix.singular_values().expect("singular values");
        assert!(values.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-14), "{values:?} {expected:?}");
        assert!(values[2] < 1e-15 && values[3] == 0.0, "{values:?}");
    }

    #[test]
    fn a_system_that_needs_its_rows_exchanged() {
        let mut a = [0.0, 2.0, 1.0, 1.0, 1.0, 1.0, 4.0, -1.0, 0.5];
        let mut b = [7.0, 6.0, 3.5];
        solve_square(&mut a, &mut b);
        assert!(b.iter().zip([1.0, 2.0, 3.0]).all(|(x, e)| (x - e).abs() < 1e-14), "{b:?}");
    }
}
