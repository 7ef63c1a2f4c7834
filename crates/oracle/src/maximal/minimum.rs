//! Minimum energy at unit closing speed, from the rows.

use super::rows::{Owner, System};
use super::{Answer, Outcome};
use crate::limits;
use faer::Mat;
use nalgebra::{DMatrix, DVector};

/// Solves the definition (D).
pub(super) fn minimum(system: &System) -> Answer {
    minimum_and_response(system).0
}

/// Solves the definition (D); the second value is v* in scaled velocities, `None` unless the outcome is finite.
pub(super) fn minimum_and_response(system: &System) -> (Answer, Option<DVector<f64>>) {
    let tree = kernel_of_independent_rows(&system.tree);
    let (within, singular_values) = kernel(&(&system.extra * &tree), system.threshold);
    let basis = tree * within;
    let degrees_of_freedom = basis.ncols();
    let rank = system.tree.ncols() - degrees_of_freedom;
    let redundant_constraints = system.tree.nrows() + system.extra.nrows() - rank;
    let answer = |outcome| Answer {
        outcome,
        degrees_of_freedom,
        redundant_constraints,
        singular_values: singular_values.clone(),
        threshold: system.threshold,
        links: Vec::new(),
        rotors: Vec::new(),
    };
    let mut closing = basis.tr_mul(&system.contact);
    let speed = closing.norm();
    if speed <= limits::IMMOVABLE * system.contact.norm() {
        return (answer(Outcome::Immovable), None);
    }
    // After the reflection only the first basis column has a closing speed.
    let mut basis = basis;
    let sign = if closing[0] < 0.0 { -1.0 } else { 1.0 };
    closing[0] += sign * speed;
    let image = &basis * &closing;
    basis -= image * closing.transpose() * (2.0 / closing.norm_squared());
    let particular = basis.column(0) * (-sign / speed);
    let free = basis.columns(1, degrees_of_freedom - 1).into_owned();

    let matrix = &system.energy * &free;
    let rhs = &system.energy * &particular;
    let heaviest = system.energy.row_iter().map(|row| row.norm()).fold(0.0, f64::max);
    let z = least_squares(&matrix, &rhs, limits::MASSLESS_COLUMN * heaviest);
    let response = particular - &free * z;
    let momenta = &system.energy * &response;
    if momenta.norm() <= limits::MASSLESS * heaviest * response.norm() {
        return (answer(Outcome::Massless), None);
    }
    let (links, joints) = system.counts;
    let mut answer = answer(Outcome::Finite(momenta.norm_squared()));
    (answer.links, answer.rotors) = (vec![0.0; links], vec![0.0; joints]);
    for (owner, value) in system.owners.iter().zip(&momenta) {
        match *owner {
            Owner::Link(i) => answer.links[i] += value * value,
            Owner::Rotor(i) => answer.rotors[i] += value * value,
        }
    }
    (answer, Some(response))
}

/// Orthonormal basis (columns) of the kernel of a matrix with independent rows.
fn kernel_of_independent_rows(rows: &DMatrix<f64>) -> DMatrix<f64> {
    let (rank, n) = rows.shape();
    if rank == 0 {
        return DMatrix::identity(n, n);
    }
    let q = Mat::from_fn(n, rank, |i, k| rows[(k, i)]).col_piv_qr().compute_Q();
    DMatrix::from_fn(n, n - rank, |i, k| q[(i, rank + k)])
}

/// Orthonormal basis (columns) of the kernel, and the singular values relative to the largest. Values up to
/// `threshold` count as zero; all count as zero if the largest is rounding (the rows are unit vectors).
fn kernel(rows: &DMatrix<f64>, threshold: f64) -> (DMatrix<f64>, Vec<f64>) {
    let (m, n) = rows.shape();
    if m == 0 || n == 0 {
        return (DMatrix::identity(n, n), Vec::new());
    }
    let svd = Mat::from_fn(m, n, |i, k| rows[(i, k)]).svd().expect("finite rows");
    let values: Vec<f64> = svd.S().column_vector().iter().copied().collect();
    let largest = values[0];
    if largest <= limits::ZERO_ROWS {
        return (DMatrix::identity(n, n), vec![0.0; values.len()]);
    }
    let relative: Vec<f64> = values.iter().map(|value| value / largest).collect();
    let rank = relative.iter().filter(|value| **value > threshold).count();
    let v = svd.V();
    (DMatrix::from_fn(n, n - rank, |i, k| v[(i, rank + k)]), relative)
}

/// Minimises |rhs − matrix z| over z by Householder QR with column pivoting and, within the column, row
/// pivoting. Columns with norms below `floor` get zero.
///
/// With both pivotings the error of every row is small relative to that row, however the rows are graded.
/// Source: Cox and Higham, Stability of Householder QR factorization for weighted least squares problems, 1998.
fn least_squares(matrix: &DMatrix<f64>, rhs: &DVector<f64>, floor: f64) -> DVector<f64> {
    let (rows, columns) = matrix.shape();
    let mut r = matrix.clone();
    let mut b = rhs.clone();
    let mut order: Vec<usize> = (0..columns).collect();
    let mut rank = 0;
    while rank < rows.min(columns) {
        let norm = |k: usize| r.view((rank, k), (rows - rank, 1)).norm();
        let (best, size) =
            (rank..columns).map(|k| (k, norm(k))).max_by(|x, y| x.1.total_cmp(&y.1)).unwrap_or((rank, 0.0));
        if size <= floor {
            break;
        }
        r.swap_columns(rank, best);
        order.swap(rank, best);
        let top = rank + r.view((rank, rank), (rows - rank, 1)).column(0).iamax();
        r.swap_rows(rank, top);
        b.swap_rows(rank, top);
        let mut v = r.view((rank, rank), (rows - rank, 1)).column(0).into_owned();
        v[0] += if v[0] < 0.0 { -size } else { size };
        let scale = 2.0 / v.norm_squared();
        for k in rank..columns {
            let mut column = r.column_mut(k);
            let mut column = column.rows_mut(rank, rows - rank);
            let factor = -scale * v.dot(&column);
            column.axpy(factor, &v, 1.0);
        }
        let mut tail = b.rows_mut(rank, rows - rank);
        let factor = -scale * v.dot(&tail);
        tail.axpy(factor, &v, 1.0);
        rank += 1;
    }
    let mut z = DVector::zeros(columns);
    for i in (0..rank).rev() {
        let known: f64 = (i + 1..rank).map(|k| r[(i, k)] * z[order[k]]).sum();
        z[order[i]] = (b[i] - known) / r[(i, i)];
    }
    z
}
