//! Validation of the caller's matrices, and the symmetrised mass matrix.

use super::view::MatrixView;
use crate::tolerances::{
    DENSE_ROUTE_LIMIT, LARGEST_ENTRY, LEAST_ENTRY, LENGTH_LIMIT, MATRIX_NOISE, MOST_ACCURACY, MOST_FLOOR,
    NEGATIVE_MASS, PAIR_BOUND, PAIR_ROUNDINGS, SYMMETRIC, SYMMETRIC_ROUNDINGS,
};
use faer::{Mat, Side};
use nalgebra::DMatrix;

/// Name of a matrix of m̄ = min { vᵀMv : Av = 0, jv = 1 }.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MatrixName {
    /// M.
    Mass,
    /// A.
    Constraints,
    /// j.
    ContactRow,
}

impl MatrixName {
    /// Symbol and name for messages.
    pub fn name(self) -> &'static str {
        match self {
            MatrixName::Mass => "M, the mass matrix,",
            MatrixName::Constraints => "A, the constraint matrix,",
            MatrixName::ContactRow => "j, the contact row,",
        }
    }
}

/// Error of invalid matrices.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MatrixError {
    /// A shape does not fit; the number of coordinates is taken from M.
    #[error("{} is {rows}×{columns}; expected {expected}", matrix.name())]
    Shape {
        /// The matrix.
        matrix: MatrixName,
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
        /// Expected shape.
        expected: String,
    },
    /// An entry is NaN, infinite or above 1e100 in magnitude.
    #[error("{} has {value:e} in row {row}, column {column} (from 0); expected a finite number of at most 1e100", matrix.name())]
    NotFinite {
        /// The matrix.
        matrix: MatrixName,
        /// Row of the entry, from 0.
        row: usize,
        /// Column of the entry, from 0.
        column: usize,
        /// Value of the entry.
        value: f64,
    },
    /// M is not symmetric.
    #[error(
        "M, the mass matrix, is not symmetric: {upper:e} in row {row}, column {column} (from 0) and {lower:e} across the \
         diagonal{}", if *is_triangle { "; only one triangle is filled: mirror it first" } else { "" }
    )]
    NotSymmetric {
        /// Row, from 0.
        row: usize,
        /// Column, from 0.
        column: usize,
        /// Entry of M at this row and column.
        upper: f64,
        /// Entry of M across the diagonal.
        lower: f64,
        /// True if one triangle of M is zero.
        is_triangle: bool,
    },
    /// M has a negative diagonal entry.
    #[error(
        "M, the mass matrix, has {value:e} on its diagonal, coordinate {coordinate} (from 0); expected a number ≥ 0"
    )]
    NegativeDiagonal {
        /// The coordinate, from 0.
        coordinate: usize,
        /// Value of the entry.
        value: f64,
    },
    /// A motion of two coordinates alone has a negative energy.
    #[error(
        "M, the mass matrix, is indefinite: {value:e} in row {row}, column {column} (from 0) is larger than \
         √(M_rr·M_cc) = {most:e}; expected a positive semi-definite matrix"
    )]
    IndefinitePair {
        /// Row, from 0.
        row: usize,
        /// Column, from 0.
        column: usize,
        /// Value of the entry.
        value: f64,
        /// Largest magnitude possible for a positive semi-definite matrix.
        most: f64,
    },
    /// A motion has a negative energy.
    #[error(
        "M, the mass matrix, is indefinite: scaled to unit diagonal it has the eigenvalue {eigenvalue:e}; expected none \
         below {least:e}"
    )]
    Indefinite {
        /// Smallest eigenvalue of M scaled to unit diagonal.
        eigenvalue: f64,
        /// Smallest eigenvalue that counts as rounding.
        least: f64,
    },
    /// The number of coordinates exceeds the limit for dense matrices.
    #[error(
        "M, the mass matrix, has {coordinates} coordinates; at most {limit} are taken: the cost is cubic"
    )]
    TooLarge {
        /// Number of coordinates.
        coordinates: usize,
        /// Largest accepted number.
        limit: usize,
    },
    /// The number of lengths differs from the number of coordinates.
    #[error("{got} lengths are given for {expected} coordinates; expected one each")]
    LengthCount {
        /// Number of given lengths.
        got: usize,
        /// Number of coordinates.
        expected: usize,
    },
    /// An option is out of range.
    #[error("{option}: {got:e} is out of range; expected {expected}")]
    Option {
        /// Name of the option.
        option: &'static str,
        /// The given value.
        got: f64,
        /// The accepted range, in words.
        expected: &'static str,
    },
    /// The result exceeds the range of a 64-bit float.
    #[error("the answer is too large or too small for a 64-bit float; check the units of M and j")]
    NotRepresentable,
}

/// Validated mass matrix.
pub(super) struct Mass {
    /// n×n, symmetric; exactly zero for coordinates that move no mass beyond noise.
    pub matrix: DMatrix<f64>,
    /// Error of the entries relative to √(M_rr M_cc): the stated accuracy, the asymmetry of M, and its negative
    /// energies.
    pub accuracy: f64,
    /// Entries dropped as noise: (row, column, value).
    pub noise: Vec<(usize, usize, f64)>,
    /// Largest M_kk/l_k².
    pub typical: f64,
}

/// Checks the shapes, and returns the number of coordinates.
pub(super) fn shapes(
    mass: &MatrixView<'_>,
    row: &MatrixView<'_>,
    constraints: Option<&MatrixView<'_>>,
) -> Result<usize, MatrixError> {
    let wrong = |matrix, view: &MatrixView<'_>, expected| {
        Err(MatrixError::Shape { matrix, rows: view.rows(), columns: view.columns(), expected })
    };
    let n = mass.rows();
    if mass.columns() != n {
        return wrong(MatrixName::Mass, mass, "a square matrix".into());
    }
    if n > DENSE_ROUTE_LIMIT {
        return Err(MatrixError::TooLarge { coordinates: n, limit: DENSE_ROUTE_LIMIT });
    }
    if row.columns() != n || row.rows() != 1 {
        return wrong(MatrixName::ContactRow, row, format!("1×{n}, a number for each coordinate of M"));
    }
    match constraints.filter(|a| a.columns() != n) {
        Some(a) => wrong(MatrixName::Constraints, a, format!("{n} columns, one for each coordinate of M")),
        None => Ok(n),
    }
}

/// Copies the entries, and checks that all are finite.
pub(super) fn entries(matrix: MatrixName, view: &MatrixView<'_>) -> Result<DMatrix<f64>, MatrixError> {
    let (rows, columns) = (view.rows(), view.columns());
    let mut all = DMatrix::zeros(rows, columns);
    for c in 0..columns {
        for r in 0..rows {
            let value = view.at(r, c);
            if value.is_nan() || value.abs() > LARGEST_ENTRY {
                return Err(MatrixError::NotFinite { matrix, row: r, column: c, value });
            }
            all[(r, c)] = if value.abs() < LEAST_ENTRY { 0.0 } else { value };
        }
    }
    Ok(all)
}

/// The given length of each coordinate; 1 by default.
pub(super) fn lengths(given: Option<&[f64]>, n: usize) -> Result<Vec<f64>, MatrixError> {
    let Some(given) = given else { return Ok(vec![1.0; n]) };
    if given.len() != n {
        return Err(MatrixError::LengthCount { got: given.len(), expected: n });
    }
    match given.iter().find(|l| !(1.0 / LENGTH_LIMIT..=LENGTH_LIMIT).contains(*l)) {
        Some(&got) => {
            let expected = "a number from 1e-30 to 1e30";
            Err(MatrixError::Option { option: "the length of a coordinate", got, expected })
        }
        None => Ok(given.to_vec()),
    }
}

/// Checks the ranges of the options.
pub(super) fn options(rank_floor: f64, row_noise: f64, accuracies: [f64; 3]) -> Result<(), MatrixError> {
    if !(rank_floor > 0.0 && rank_floor <= MOST_FLOOR) {
        let expected = "a number above 0, at most 0.1";
        return Err(MatrixError::Option { option: "rank_floor", got: rank_floor, expected });
    }
    if !(0.0..=LARGEST_ENTRY).contains(&row_noise) {
        let expected = "a number from 0 to 1e100";
        return Err(MatrixError::Option { option: "row_noise", got: row_noise, expected });
    }
    match accuracies.into_iter().find(|accuracy| !(0.0..=MOST_ACCURACY).contains(accuracy)) {
        Some(got) => {
            let expected = "a number from 0 to 1e-3";
            Err(MatrixError::Option { option: "accuracy", got, expected })
        }
        None => Ok(()),
    }
}

impl Mass {
    /// Checks M and makes M symmetric. `accuracy`: relative error of its entries.
    pub fn new(mut matrix: DMatrix<f64>, lengths: &[f64], accuracy: f64) -> Result<Self, MatrixError> {
        let n = matrix.nrows();
        let typical = (0..n).map(|k| matrix[(k, k)].abs() / lengths[k].powi(2)).fold(0.0, f64::max);
        // Rounding of a coordinate that moves no mass, if its entries are sums together with those of all other
        // coordinates.
        let noise = |r: usize, c: usize| MATRIX_NOISE * accuracy * typical * lengths[r] * lengths[c];
        let mut off = symmetrize(&mut matrix, accuracy, &noise)?;
        let mut is_noise = vec![false; n];
        let pair_bound = PAIR_BOUND.max(1.0 + PAIR_ROUNDINGS * accuracy);
        for k in 0..n {
            let value = matrix[(k, k)];
            if value < 0.0 {
                if -value > noise(k, k) {
                    return Err(MatrixError::NegativeDiagonal { coordinate: k, value });
                }
                is_noise[k] = true;
            }
        }
        for c in 0..n {
            for r in 0..c {
                let value = matrix[(r, c)];
                let most = matrix[(r, r)].max(0.0).sqrt() * matrix[(c, c)].max(0.0).sqrt();
                if value.abs() <= pair_bound * most || is_noise[r] || is_noise[c] {
                    continue;
                }
                if value.abs() > noise(r, c) {
                    return Err(MatrixError::IndefinitePair { row: r, column: c, value, most });
                }
                let mass = |k: usize| matrix[(k, k)] / lengths[k].powi(2);
                is_noise[if mass(r) < mass(c) { r } else { c }] = true;
            }
        }
        let mut dropped = Vec::new();
        for k in (0..n).filter(|&k| is_noise[k]) {
            for other in 0..n {
                if matrix[(k, other)] != 0.0 {
                    dropped.push((k, other, matrix[(k, other)]));
                    (matrix[(k, other)], matrix[(other, k)]) = (0.0, 0.0);
                }
            }
        }
        off += accuracy;
        let negative = negative_energy(&matrix);
        // Errors of `off` · √(M_rr M_cc) change an eigenvalue by at most n · `off`.
        let least = NEGATIVE_MASS * (n as f64 + 1.0) * f64::EPSILON + 2.0 * n as f64 * off;
        if negative > least {
            return Err(MatrixError::Indefinite { eigenvalue: -negative, least: -least });
        }
        Ok(Self { matrix, accuracy: off + negative, noise: dropped, typical })
    }
}

/// Replaces M by the mean of M and its transpose. Returns the largest half difference relative to √(M_rr M_cc).
fn symmetrize(
    matrix: &mut DMatrix<f64>,
    accuracy: f64,
    noise: &dyn Fn(usize, usize) -> f64,
) -> Result<f64, MatrixError> {
    let n = matrix.nrows();
    let symmetric = SYMMETRIC.max(SYMMETRIC_ROUNDINGS * accuracy);
    let mut off = 0.0_f64;
    for c in 0..n {
        for r in 0..c {
            let (upper, lower) = (matrix[(r, c)], matrix[(c, r)]);
            let difference = (upper - lower).abs();
            if difference == 0.0 {
                continue;
            }
            let size = matrix[(r, r)].abs().sqrt() * matrix[(c, c)].abs().sqrt();
            if difference > symmetric * size && difference > noise(r, c) {
                let zero = |upper: bool| {
                    (0..n).all(|c| (0..c).all(|r| matrix[if upper { (r, c) } else { (c, r) }] == 0.0))
                };
                let is_triangle = zero(true) || zero(false);
                return Err(MatrixError::NotSymmetric { row: r, column: c, upper, lower, is_triangle });
            }
            if difference <= symmetric * size {
                off = off.max(0.5 * difference / size);
            }
            let mean = 0.5 * (upper + lower);
            (matrix[(r, c)], matrix[(c, r)]) = (mean, mean);
        }
    }
    Ok(off)
}

/// Magnitude of the smallest eigenvalue of M scaled to unit diagonal, if negative; otherwise 0.
fn negative_energy(matrix: &DMatrix<f64>) -> f64 {
    let moved: Vec<usize> = (0..matrix.nrows()).filter(|&k| matrix[(k, k)] > 0.0).collect();
    let root = |i: usize| matrix[(moved[i], moved[i])].sqrt();
    let scaled =
        Mat::from_fn(moved.len(), moved.len(), |r, c| matrix[(moved[r], moved[c])] / root(r) / root(c));
    if moved.is_empty() || scaled.llt(Side::Lower).is_ok() {
        return 0.0;
    }
    let values = scaled.self_adjoint_eigenvalues(Side::Lower);
    // Without eigenvalues there is no proof that none is negative.
    values.map_or(1.0, |values| values.first().map_or(0.0, |least| (-least).max(0.0)))
}
