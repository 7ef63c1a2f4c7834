//! Small dense systems, singular values, and products of vectors.

/// aᵀb.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

use crate::tolerances::JACOBI_SWEEPS;

/// Solves A x = b in place by elimination with partial pivoting; A is n×n, row by row. A zero pivot causes
/// infinities.
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

/// Sign of the determinant of an n×n matrix, row by row, by elimination in place. The determinant itself may overflow
/// or underflow.
pub(crate) fn determinant_sign(a: &mut [f64], n: usize) -> i8 {
    let mut negative = false;
    for k in 0..n {
        let size = |r: usize| a[r * n + k].abs();
        let Some(pivot) = (k..n).max_by(|&p, &q| size(p).total_cmp(&size(q))) else { break };
        if pivot != k {
            for c in k..n {
                a.swap(k * n + c, pivot * n + c);
            }
            negative = !negative;
        }
        negative ^= a[k * n + k] < 0.0;
        for r in k + 1..n {
            let factor = a[r * n + k] / a[k * n + k];
            for c in k + 1..n {
                a[r * n + c] -= factor * a[k * n + c];
            }
        }
    }
    if negative { -1 } else { 1 }
}

/// Cholesky factorisation in place (lower, n×n, row by row). False if a pivot is below `floor` times the largest
/// diagonal entry.
pub(crate) fn cholesky(a: &mut [f64], n: usize, floor: f64) -> bool {
    let largest = (0..n).map(|k| a[k * n + k]).fold(0.0, f64::max);
    for k in 0..n {
        for c in 0..=k {
            let known: f64 = (0..c).map(|i| a[k * n + i] * a[c * n + i]).sum();
            let rest = a[k * n + c] - known;
            if c < k {
                a[k * n + c] = rest / a[c * n + c];
            } else if rest > floor * largest {
                a[k * n + k] = rest.sqrt();
            } else {
                return false;
            }
        }
    }
    true
}

/// Solves L Lᵀ x = b in place.
pub(crate) fn cholesky_solve(l: &[f64], b: &mut [f64]) {
    let n = b.len();
    for k in 0..n {
        let known: f64 = (0..k).map(|i| l[k * n + i] * b[i]).sum();
        b[k] = (b[k] - known) / l[k * n + k];
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|i| l[i * n + k] * b[i]).sum();
        b[k] = (b[k] - known) / l[k * n + k];
    }
}

/// Ratio of the smallest to the largest pivot of a Gram–Schmidt orthogonalisation that takes the longest remaining
/// column first. `columns` holds at most `length` columns of `length` entries, one after another, and is overwritten.
/// Accurate in the leading digits only, down to ratios of 1e-8.
pub(crate) fn orthogonal_pivot_ratio(columns: &mut [f64], length: usize) -> f64 {
    let count = columns.len() / length;
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let mut first = 0.0;
    let mut pivot = 0.0;
    for k in 0..count {
        let rest = &mut columns[k * length..];
        let (longest, square) = rest
            .chunks_exact(length)
            .map(|column| dot(column, column))
            .enumerate()
            .fold((0, 0.0), |best, (i, square)| if square > best.1 { (i, square) } else { best });
        pivot = square;
        if k == 0 {
            first = square;
        }
        if square == 0.0 {
            return 0.0;
        }
        if longest > 0 {
            let (head, tail) = rest.split_at_mut(longest * length);
            head[..length].swap_with_slice(&mut tail[..length]);
        }
        let (done, others) = rest.split_at_mut(length);
        for other in others.chunks_exact_mut(length) {
            let part = dot(done, other) / square;
            other.iter_mut().zip(&*done).for_each(|(x, a)| *x -= part * a);
        }
    }
    (pivot / first).sqrt()
}

/// Singular values in descending order of an m×n matrix, row by row, by one-sided Jacobi rotations. Allocates nothing
/// if `values` is large enough. The matrix is overwritten by its rotated form. Source: Hestenes 1958; Golub, Van
/// Loan, Matrix Computations, 2013, §8.6.3 (cited from memory).
pub(crate) fn singular_values(a: &mut [f64], n: usize, values: &mut Vec<f64>) {
    values.clear();
    if n == 0 {
        return;
    }
    for _ in 0..JACOBI_SWEEPS {
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
    use super::{
        cholesky, cholesky_solve, determinant_sign, orthogonal_pivot_ratio, singular_values, solve_square,
    };

    #[test]
    fn signs_of_determinants() {
        assert_eq!(determinant_sign(&mut [0.0, 1.0, 1.0, 0.0], 2), -1);
        assert_eq!(determinant_sign(&mut [1e-200, 0.0, 0.0, 1e-200], 2), 1);
        assert_eq!(determinant_sign(&mut [2.0, 1.0, 0.0, 1.0, -3.0, 1.0, 0.0, 1.0, 4.0], 3), -1);
    }

    #[test]
    fn a_positive_system() {
        let mut a = [4.0, 2.0, 2.0, 3.0];
        assert!(cholesky(&mut a, 2, 1e-10));
        let mut b = [8.0, 8.0];
        cholesky_solve(&a, &mut b);
        assert!((b[0] - 1.0).abs() < 1e-15 && (b[1] - 2.0).abs() < 1e-15, "{b:?}");
        assert!(!cholesky(&mut [1.0, 1.0, 1.0, 1.0], 2, 1e-10));
    }

    #[test]
    fn singular_values_of_a_deficient_matrix() {
        // [1 2; 3 4] with one repeated column and one zero column.
        let mut a = [1.0, 2.0, 0.0, 1.0, 3.0, 4.0, 0.0, 3.0];
        let mut values = Vec::new();
        singular_values(&mut a, 4, &mut values);
        let matrix = faer::Mat::from_fn(2, 4, |r, c| [[1.0, 2.0, 0.0, 1.0], [3.0, 4.0, 0.0, 3.0]][r][c]);
        let expected: Vec<f64> = matrix.singular_values().expect("singular values");
        assert!(values.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-14), "{values:?} {expected:?}");
        assert!(values[2] < 1e-15 && values[3] == 0.0, "{values:?}");
    }

    #[test]
    fn pivots_of_columns() {
        // Columns (3, 0, 4) and (3, 0, 4) + δ(4, 0, −3): pivots 5 and 5δ, within the rounding of the first, ε/δ.
        for delta in [0.5, 1e-3, 1e-8] {
            let ratio =
                orthogonal_pivot_ratio(&mut [3.0, 0.0, 4.0, 3.0 + 4.0 * delta, 0.0, 4.0 - 3.0 * delta], 3);
            let exact = delta / (1.0_f64 + delta * delta);
            assert!((ratio / exact - 1.0).abs() < 1e-15 / delta + 1e-14, "{ratio} {exact}");
        }
        assert_eq!(orthogonal_pivot_ratio(&mut [1.0, 2.0, 0.0, 0.0], 2), 0.0);
        // Comparison with the factorisation with column pivoting.
        let entry = |r: usize, c: usize| ((3 * r + 7 * c) as f64).sin() + f64::from(u8::from(r == c));
        let matrix = faer::Mat::from_fn(9, 6, entry);
        let qr = matrix.col_piv_qr();
        let exact = (qr.R()[(5, 5)] / qr.R()[(0, 0)]).abs();
        let mut columns: Vec<f64> = (0..54).map(|i| entry(i % 9, i / 9)).collect();
        assert!((orthogonal_pivot_ratio(&mut columns, 9) / exact - 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_system_that_needs_its_rows_exchanged() {
        let mut a = [0.0, 2.0, 1.0, 1.0, 1.0, 1.0, 4.0, -1.0, 0.5];
        let mut b = [7.0, 6.0, 3.5];
        solve_square(&mut a, &mut b);
        assert!(b.iter().zip([1.0, 2.0, 3.0]).all(|(x, e)| (x - e).abs() < 1e-14), "{b:?}");
    }
}
