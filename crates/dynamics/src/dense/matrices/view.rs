//! Views of the caller's matrices, without copies.

use nalgebra::DMatrix;

/// View of a matrix of the caller: entry (r, c) is `values[first + r·row_stride + c·column_stride]`.
#[derive(Clone, Copy, Debug)]
pub struct MatrixView<'a> {
    values: &'a [f64],
    first: isize,
    rows: usize,
    columns: usize,
    row_stride: isize,
    column_stride: isize,
}

/// Error of numbers that do not contain a matrix of the given shape.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum LayoutError {
    /// An entry lies outside the numbers.
    #[error(
        "a {rows}×{columns} matrix with strides {row_stride} (rows) and {column_stride} (columns) from number {first} \
         reaches number {reached} of {got}"
    )]
    Outside {
        /// Number of given values.
        got: usize,
        /// Index of the entry farthest outside.
        reached: isize,
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
        /// Index of the first entry.
        first: usize,
        /// Distance between consecutive rows.
        row_stride: isize,
        /// Distance between consecutive columns.
        column_stride: isize,
    },
    /// The leading dimension is too small; rows or columns would overlap.
    #[error("the leading dimension is {got}; expected at least {least}, the number of {what}")]
    LeadingDimension {
        /// The given leading dimension.
        got: usize,
        /// The smallest valid leading dimension.
        least: usize,
        /// The limiting number: `columns` for row-major, `rows` for column-major matrices.
        what: &'static str,
    },
    /// The shape exceeds the address space.
    #[error("a {rows}×{columns} matrix is larger than any memory")]
    Shape {
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
    },
}

impl<'a> MatrixView<'a> {
    /// View of a row-major matrix without gaps.
    ///
    /// # Errors
    /// [`LayoutError`]: fewer than `rows`·`columns` numbers.
    pub fn row_major(values: &'a [f64], rows: usize, columns: usize) -> Result<Self, LayoutError> {
        Self::row_major_with(values, rows, columns, columns)
    }

    /// View of a row-major matrix with rows `leading_dimension` numbers apart (`lda` in BLAS).
    ///
    /// # Errors
    /// [`LayoutError`]: too few numbers; a leading dimension below `columns`.
    pub fn row_major_with(
        values: &'a [f64],
        rows: usize,
        columns: usize,
        leading_dimension: usize,
    ) -> Result<Self, LayoutError> {
        let stride = leading(leading_dimension, columns, rows, columns, "columns")?;
        Self::strided(values, 0, [rows, columns], [stride, 1])
    }

    /// View of a column-major matrix without gaps.
    ///
    /// # Errors
    /// [`LayoutError`]: fewer than `rows`·`columns` numbers.
    pub fn column_major(values: &'a [f64], rows: usize, columns: usize) -> Result<Self, LayoutError> {
        Self::column_major_with(values, rows, columns, rows)
    }

    /// View of a column-major matrix with columns `leading_dimension` numbers apart (`lda` in BLAS).
    ///
    /// # Errors
    /// [`LayoutError`]: too few numbers; a leading dimension below `rows`.
    pub fn column_major_with(
        values: &'a [f64],
        rows: usize,
        columns: usize,
        leading_dimension: usize,
    ) -> Result<Self, LayoutError> {
        let stride = leading(leading_dimension, rows, rows, columns, "rows")?;
        Self::strided(values, 0, [rows, columns], [1, stride])
    }

    /// View with arbitrary strides, in numbers: entry (r, c) has index `first + r·strides[0] + c·strides[1]`. Strides
    /// may be negative or 0.
    ///
    /// # Errors
    /// [`LayoutError`]: an entry outside the numbers.
    pub fn strided(
        values: &'a [f64],
        first: usize,
        shape: [usize; 2],
        strides: [isize; 2],
    ) -> Result<Self, LayoutError> {
        let [rows, columns] = shape;
        let [row_stride, column_stride] = strides;
        let impossible = || LayoutError::Shape { rows, columns };
        let start = isize::try_from(first).map_err(|_| impossible())?;
        rows.checked_mul(columns).ok_or_else(impossible)?;
        if rows > 0 && columns > 0 {
            let last = |count: usize, stride: isize| -> Option<isize> {
                isize::try_from(count - 1).ok()?.checked_mul(stride)
            };
            let down = last(rows, row_stride).ok_or_else(impossible)?;
            let along = last(columns, column_stride).ok_or_else(impossible)?;
            for step in [[0, 0], [down, 0], [0, along], [down, along]] {
                let reached = start.checked_add(step[0]).and_then(|at| at.checked_add(step[1]));
                let reached = reached.ok_or_else(impossible)?;
                if usize::try_from(reached).is_ok_and(|at| at < values.len()) {
                    continue;
                }
                let got = values.len();
                return Err(LayoutError::Outside {
                    got,
                    reached,
                    rows,
                    columns,
                    first,
                    row_stride,
                    column_stride,
                });
            }
        }
        Ok(Self { values, first: start, rows, columns, row_stride, column_stride })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Entry (r, c); `None` outside the matrix.
    pub fn get(&self, r: usize, c: usize) -> Option<f64> {
        (r < self.rows && c < self.columns).then(|| self.at(r, c))
    }

    /// Entry (r, c); must be inside the matrix.
    #[inline]
    pub(super) fn at(&self, r: usize, c: usize) -> f64 {
        self.values[(self.first + r as isize * self.row_stride + c as isize * self.column_stride) as usize]
    }
}

/// View of a 1×n row.
impl<'a> From<&'a [f64]> for MatrixView<'a> {
    fn from(values: &'a [f64]) -> Self {
        Self { values, first: 0, rows: 1, columns: values.len(), row_stride: 0, column_stride: 1 }
    }
}

/// View of a 1×n row.
impl<'a> From<&'a Vec<f64>> for MatrixView<'a> {
    fn from(values: &'a Vec<f64>) -> Self {
        values.as_slice().into()
    }
}

impl<'a> From<&'a DMatrix<f64>> for MatrixView<'a> {
    fn from(matrix: &'a DMatrix<f64>) -> Self {
        let (rows, columns) = matrix.shape();
        Self {
            values: matrix.as_slice(),
            first: 0,
            rows,
            columns,
            row_stride: 1,
            // The matrix fits into memory, so the number of rows is at most half the range of a pointer.
            column_stride: rows as isize,
        }
    }
}

/// Checks a leading dimension, and converts it to a stride.
fn leading(
    got: usize,
    least: usize,
    rows: usize,
    columns: usize,
    what: &'static str,
) -> Result<isize, LayoutError> {
    if got < least {
        return Err(LayoutError::LeadingDimension { got, least, what });
    }
    isize::try_from(got).map_err(|_| LayoutError::Shape { rows, columns })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Entries of a 2×3 view, row by row.
    fn entries(view: &MatrixView<'_>) -> Vec<f64> {
        (0..view.rows()).flat_map(|r| (0..view.columns()).map(move |c| view.at(r, c))).collect()
    }

    #[test]
    fn one_matrix_in_every_layout() {
        let expected = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0];
        let gaps = [1.0, 2.0, 3.0, -1.0, 4.0, 5.0, 6.0];
        let columns = [1.0, 4.0, -1.0, 2.0, 5.0, -1.0, 3.0, 6.0];
        let backwards = [6.0, 5.0, 4.0, 3.0, 2.0, 1.0];
        let views = [
            MatrixView::row_major(&expected, 2, 3),
            MatrixView::row_major_with(&gaps, 2, 3, 4),
            MatrixView::column_major(&[1.0, 4.0, 2.0, 5.0, 3.0, 6.0], 2, 3),
            MatrixView::column_major_with(&columns, 2, 3, 3),
            MatrixView::strided(&backwards, 5, [2, 3], [-3, -1]),
        ];
        for view in views {
            assert_eq!(entries(&view.unwrap()), expected);
        }
        let matrix = DMatrix::from_row_slice(2, 3, &expected);
        assert_eq!(entries(&(&matrix).into()), expected);
        assert_eq!(MatrixView::from(&expected[..]).get(0, 5), Some(6.0));
        assert_eq!(MatrixView::from(&expected[..]).get(1, 0), None);
    }

    #[test]
    fn one_number_too_few_is_an_error() {
        let numbers = [0.0; 12];
        for missing in [0, 1] {
            let some = &numbers[..12 - missing];
            let fits = missing == 0;
            assert_eq!(MatrixView::row_major(some, 3, 4).is_ok(), fits);
            assert_eq!(MatrixView::column_major(some, 3, 4).is_ok(), fits);
            assert_eq!(MatrixView::strided(some, 11, [3, 4], [-4, -1]).is_ok(), fits);
            // The last row needs no gap after its end.
            assert_eq!(MatrixView::row_major_with(some, 2, 4, 8).is_ok(), fits);
            assert_eq!(MatrixView::strided(some, 8, [3, 4], [-4, 1]).is_ok(), fits);
        }
        assert!(MatrixView::strided(&numbers, 7, [3, 4], [-4, 1]).is_err());
        assert!(matches!(
            MatrixView::row_major_with(&numbers, 2, 4, 3),
            Err(LayoutError::LeadingDimension { got: 3, least: 4, what: "columns" })
        ));
        assert!(matches!(
            MatrixView::column_major_with(&numbers, 4, 2, 3),
            Err(LayoutError::LeadingDimension { got: 3, least: 4, what: "rows" })
        ));
        for (shape, strides) in [
            ([usize::MAX, 2], [1, 1]),
            ([2, 2], [isize::MAX, isize::MAX]),
            ([usize::MAX, 1], [isize::MAX, 1]),
        ] {
            assert!(MatrixView::strided(&numbers, 0, shape, strides).is_err());
        }
        assert!(MatrixView::strided(&[], 0, [0, 3], [5, 5]).is_ok());
    }
}
