//! Dense entry: m̄ from matrices of the caller.

use crate::boundary::arrays::{
    ByteRange, expect_length, input_slice, nan_if_unknown, optional_output_slice, refuse_overlaps,
};
use crate::boundary::handle::{argument_mut, read_argument, read_optional_argument};
use crate::boundary::status::{
    Failure, PERCUSS_ERROR_ARGUMENT, PERCUSS_ERROR_LENGTH, PERCUSS_ERROR_MATRIX, guard_call, percuss_status,
};
use crate::evaluation::contact::{PERCUSS_ROUTE_DENSE, outcome_and_value, percuss_mass, remark_bits};
use crate::evaluation::pose::{PERCUSS_COLUMN_MAJOR, PERCUSS_ROW_MAJOR, percuss_layout};
use percuss::{LayoutError, MatrixError, MatrixName, MatrixOptions, MatrixView, effective_mass};

/// A matrix of the caller, read in place.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct percuss_matrix {
    /// The entries; null only for an empty matrix.
    pub values: *const f64,
    /// Number of values: at least (rows − 1) · leading_dimension + columns, row by row; (columns − 1) ·
    /// leading_dimension + rows, column by column.
    pub length: usize,
    /// Rows.
    pub rows: usize,
    /// Columns.
    pub columns: usize,
    /// Distance between rows (row by row) or columns (column by column), as in BLAS.
    pub leading_dimension: usize,
    /// PERCUSS_ROW_MAJOR or PERCUSS_COLUMN_MAJOR.
    pub layout: percuss_layout,
    /// 0.
    pub reserved: u32,
}

/// Options for reading matrices. Initialise them with percuss_matrix_options_init.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct percuss_matrix_options {
    /// Scale of each coordinate for rank decisions: displacement per unit rate, in one unit for all coordinates (1 for
    /// a slide in metres, a typical length for an angle). null: 1 for all.
    pub lengths: *const f64,
    /// Number of lengths: one per coordinate, or 0.
    pub length_count: usize,
    /// Singular values of A below this fraction of the largest count as zero; above 0, at most 0.1.
    /// PERCUSS_DEFAULT: 1e-10, or 10 times the accuracy of A if larger; a dropped singular value above rounding then
    /// makes the rank unclear.
    pub rank_floor: f64,
    /// Relative error of every entry of M, A and j, 0 to 1e-3; part of the stated error. Default 2.2e-16; matrices stored
    /// in single precision have 6e-8.
    pub accuracy: f64,
    /// Relative error of every entry of M. PERCUSS_DEFAULT: accuracy.
    pub accuracy_of_mass: f64,
    /// Relative error of every entry of A. PERCUSS_DEFAULT: accuracy.
    pub accuracy_of_constraints: f64,
    /// Relative error of every entry of j. PERCUSS_DEFAULT: accuracy.
    pub accuracy_of_contact_row: f64,
    /// Rows of A with all entries, divided by lengths, at or below this level count as zero; at least 0; 0: every
    /// nonzero row counts. PERCUSS_DEFAULT: 1e-14 of the largest entry of the rows that share coordinates.
    pub row_noise: f64,
}

/// Value of an option of percuss_matrix_options for its default.
pub const PERCUSS_DEFAULT: f64 = -1.0;

/// Rank report of A.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct percuss_rank {
    /// Number of independent rows.
    pub rank: usize,
    /// Number of redundant rows.
    pub redundant: usize,
    /// Least gap between counted singular values and those taken as zero; NaN without rows.
    pub gap: f64,
    /// 1 if no singular value is within a factor of 30 of the threshold.
    pub is_clear: i32,
    /// 0.
    pub reserved: u32,
}

/// Sets the default options.
///
/// # Safety
/// options is null or points to storage for a percuss_matrix_options.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_matrix_options_init(options: *mut percuss_matrix_options) -> percuss_status {
    guard_call(|| {
        *argument_mut(options, "options")? = percuss_matrix_options {
            lengths: std::ptr::null(),
            length_count: 0,
            rank_floor: PERCUSS_DEFAULT,
            accuracy: f64::EPSILON,
            accuracy_of_mass: PERCUSS_DEFAULT,
            accuracy_of_constraints: PERCUSS_DEFAULT,
            accuracy_of_contact_row: PERCUSS_DEFAULT,
            row_noise: PERCUSS_DEFAULT,
        };
        Ok(())
    })
}

impl percuss_matrix_options {
    /// Options without characteristic lengths. Values out of range are refused later.
    #[allow(clippy::float_cmp, reason = "the default is one certain number")]
    fn to_options_without_lengths<'a>(self) -> MatrixOptions<'a> {
        let given = |value: f64| (value != PERCUSS_DEFAULT).then_some(value);
        let mut options = MatrixOptions::new().accuracy(self.accuracy);
        if let Some(floor) = given(self.rank_floor) {
            options = options.rank_floor(floor);
        }
        let accuracies = [
            (MatrixName::Mass, self.accuracy_of_mass),
            (MatrixName::Constraints, self.accuracy_of_constraints),
            (MatrixName::ContactRow, self.accuracy_of_contact_row),
        ];
        for (matrix, accuracy) in accuracies {
            if let Some(accuracy) = given(accuracy) {
                options = options.accuracy_of(matrix, accuracy);
            }
        }
        if let Some(noise) = given(self.row_noise) {
            options = options.row_noise(noise);
        }
        options
    }
}

/// View of a matrix of the caller, without a copy; refuses a wrong shape or layout.
fn matrix_view<'a>(matrix: &percuss_matrix, name: &str) -> Result<MatrixView<'a>, Failure> {
    let values: &'a [f64] = input_slice(matrix.values, matrix.length, name)?;
    let percuss_matrix { rows, columns, leading_dimension, layout, .. } = *matrix;
    let view = match layout {
        PERCUSS_ROW_MAJOR => MatrixView::row_major_with(values, rows, columns, leading_dimension),
        PERCUSS_COLUMN_MAJOR => MatrixView::column_major_with(values, rows, columns, leading_dimension),
        _ => {
            let message = format_args!(
                "{name}: layout is {layout}; expected PERCUSS_ROW_MAJOR or PERCUSS_COLUMN_MAJOR"
            );
            return Err(Failure::new(PERCUSS_ERROR_ARGUMENT, message));
        }
    };
    view.map_err(|error: LayoutError| Failure::new(PERCUSS_ERROR_LENGTH, format_args!("{name}: {error}")))
}

/// Failure with the status for the kind of the error.
fn matrix_failure(error: MatrixError) -> Failure {
    let status = match &error {
        MatrixError::Shape { .. } | MatrixError::LengthCount { .. } => PERCUSS_ERROR_LENGTH,
        MatrixError::NotFinite { .. } | MatrixError::Option { .. } => PERCUSS_ERROR_ARGUMENT,
        _ => PERCUSS_ERROR_MATRIX,
    };
    Failure::new(status, error)
}

/// m̄ = min { vᵀMv : Av = 0, jv = 1 } of a system given by its matrices: mass is M, n×n, symmetric, positive
/// semi-definite (kg, kg·m, kg·m²); contact_row is j, count = n numbers (m, 1); constraints is A, m×n, or null. M may
/// be singular, rows of A may be redundant.
///
/// mass_result: the outcome, m̄ (kg), its error (error and error_rounding), the remarks. velocities: null, or n numbers
/// of output: v*, the velocities at unit closing speed. rank: null, or storage for the rank report of A.
/// redundant_rows: null, or m bytes of output: 1 for each redundant row of A, else 0. options: null for the defaults.
///
/// Errors: PERCUSS_ERROR_LENGTH: shapes; PERCUSS_ERROR_ARGUMENT: NaN, infinities, options; PERCUSS_ERROR_MATRIX: not
/// symmetric, not positive semi-definite, more than 1000 coordinates.
///
/// # Safety
/// Every pointer is null or points to the stated values; the arrays of the matrices have the stated lengths.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn percuss_effective_mass(
    mass: *const percuss_matrix,
    contact_row: *const f64,
    count: usize,
    constraints: *const percuss_matrix,
    options: *const percuss_matrix_options,
    mass_result: *mut percuss_mass,
    velocities: *mut f64,
    rank: *mut percuss_rank,
    redundant_rows: *mut u8,
) -> percuss_status {
    guard_call(|| {
        let mass = read_argument(mass, "mass")?;
        let constraints = read_optional_argument(constraints, "constraints")?;
        let given = read_optional_argument(options, "options")?;
        let row = input_slice(contact_row, count, "contact_row")?;
        expect_length(count, mass.rows, "contact_row")?;
        let mut parsed_options = MatrixOptions::new();
        if let Some(options) = given {
            parsed_options = options.to_options_without_lengths();
            if !options.lengths.is_null() {
                parsed_options =
                    parsed_options.lengths(input_slice(options.lengths, options.length_count, "lengths")?);
            }
        }
        let rows = constraints.as_ref().map(|a| matrix_view(a, "constraints")).transpose()?;
        let matrix = matrix_view(&mass, "mass")?;
        let redundant = constraints.map_or(0, |a| a.rows);
        let written = [
            ByteRange::of_array(mass_result, 1, "mass_result"),
            ByteRange::of_array(velocities, count, "velocities"),
            ByteRange::of_array(rank, 1, "rank"),
            ByteRange::of_array(redundant_rows, redundant, "redundant_rows"),
        ];
        let (a, lengths) = (
            constraints.map_or(ByteRange::of_array(contact_row, 0, "constraints"), |a| {
                ByteRange::of_array(a.values, a.length, "constraints")
            }),
            given.map_or(ByteRange::of_array(contact_row, 0, "lengths"), |options| {
                ByteRange::of_array(options.lengths, options.length_count, "lengths")
            }),
        );
        let read = [
            ByteRange::of_array(mass.values, mass.length, "mass"),
            ByteRange::of_array(contact_row, count, "contact_row"),
            a,
            lengths,
        ];
        refuse_overlaps(&written, &read)?;
        let found = effective_mass(matrix, row, rows, &parsed_options).map_err(matrix_failure)?;
        let (outcome, m) = outcome_and_value(found.effective_mass);
        *argument_mut(mass_result, "mass_result")? = percuss_mass {
            outcome,
            route: PERCUSS_ROUTE_DENSE,
            remarks: remark_bits(&found.remarks),
            reserved: 0,
            degrees_of_freedom: found.degrees_of_freedom,
            effective_mass: m,
            error: nan_if_unknown(found.error),
            error_rounding: nan_if_unknown(found.error),
            error_closing: f64::NAN,
            error_file: f64::NAN,
        };
        if let Some(to) = optional_output_slice(velocities, count, "velocities")? {
            to.copy_from_slice(&found.velocity);
        }
        if !rank.is_null() {
            *argument_mut(rank, "rank")? = percuss_rank {
                rank: found.rank.rank,
                redundant: found.rank.redundant_rows.len(),
                gap: nan_if_unknown(found.rank.gap),
                is_clear: i32::from(found.rank.is_clear),
                reserved: 0,
            };
        }
        let m = constraints.map_or(0, |a| a.rows);
        if let Some(to) = optional_output_slice(redundant_rows, m, "redundant_rows")? {
            to.fill(0);
            found.rank.redundant_rows.iter().for_each(|&r| to[r] = 1);
        }
        Ok(())
    })
}
