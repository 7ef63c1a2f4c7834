//! Rows of q in any layout, solved in blocks on all threads.

use crate::analysis::matrices::mass_and_code;
use crate::analysis::model::Model;
use crate::conversion::errors::input;
use crate::conversion::threads::Threads;
use crate::sweep::columns::{Columns, MASSLESS_TO_ROUNDING};
use crate::sweep::portions::{Progress, run_timed_portions};
use crate::sweep::row_contacts::RowContacts;
use numpy::ndarray::{ArrayView2, s};
use numpy::{PyReadonlyArray2, PyUntypedArrayMethods};
use percuss::{
    BatchAnswer, BatchContacts, BatchDerivatives, BatchError, BatchPositions, Configuration, JointId,
    RemarkFlags,
};
use pyo3::prelude::*;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::{Mutex, PoisonError};

/// Least and greatest block size of a thread, in configurations. At the greatest size, positions and results stay in
/// the cache.
const BLOCK_SIZES: (usize, usize) = (256, 1 << 11);
/// Blocks per thread and portion. Several blocks balance the load from other processes.
const BLOCKS_PER_THREAD: usize = 8;

/// Contact, threads and progress of a sweep.
#[derive(Clone, Copy)]
pub struct RowQuestion<'a> {
    pub batch: &'a BatchDerivatives,
    pub contacts: Option<&'a RowContacts>,
    pub threads: Threads,
    pub progress: &'a Progress<'a>,
}

/// True if every number is finite. The loop visits all entries so that it vectorizes; a sum or an early exit would take
/// as long as solving an arm.
pub fn is_finite(values: &[f64]) -> bool {
    !values.iter().fold(false, |bad, x| bad | !x.is_finite())
}

/// Error that names the first nonfinite entry of some rows.
pub fn nonfinite_error(q: ArrayView2<'_, f64>, rows: Range<usize>) -> PyErr {
    let entries = rows.flat_map(|row| (0..q.ncols()).map(move |column| (row, column)));
    let mut nonfinite = entries.filter(|entry| !q[*entry].is_finite());
    let (row, column) = nonfinite.next().unwrap_or_default();
    input(format_args!("q[{row}, {column}] is {}; expected finite numbers", q[(row, column)]))
}

/// Layout of the rows of q.
#[derive(Clone, Copy)]
enum Rows<'a> {
    /// All positions, row by row.
    RowMajor(&'a [f64]),
    /// All positions, column by column.
    Columns(&'a [f64]),
    /// All positions, with any strides.
    Strided,
    /// Some positions: `position_indices` maps each column to its position; `zero_positions` holds all positions of the zero
    /// configuration.
    Some { position_indices: &'a [usize], zero_positions: &'a [f64] },
}

/// Solves the rows of q in blocks, on all threads. Each number is read, checked, solved and written while it is in the
/// cache.
fn solve_rows(
    py: Python<'_>,
    question: RowQuestion<'_>,
    q: ArrayView2<'_, f64>,
    layout: Rows<'_>,
    mut columns: Columns<'_>,
) -> PyResult<()> {
    let count = q.nrows();
    let RowQuestion { batch, contacts, threads, progress } = question;
    // Pool of position buffers.
    let buffers = Mutex::new(Vec::new());
    let buffers = || buffers.lock().unwrap_or_else(PoisonError::into_inner);
    let common_remarks = columns.reported_bits(batch.batch().remarks());
    run_timed_portions(py, count, (threads, progress), |rows| {
        // Of the pool of this process.
        let threads = rayon::current_num_threads();
        let block = rows.len().div_ceil(threads * BLOCKS_PER_THREAD).clamp(BLOCK_SIZES.0, BLOCK_SIZES.1);
        let masses = columns.masses[rows.clone()].par_chunks_mut(block);
        let errors = columns.errors[rows.clone()].par_chunks_mut(block);
        let codes = columns.codes[rows.clone()].par_chunks_mut(block);
        let remarks = columns.remarks[rows.clone()].par_chunks_mut(block);
        let gradients = optional_chunks(columns.gradients.as_deref_mut(), count, &rows, block);
        let inverses = optional_chunks(columns.inverses.as_deref_mut(), count, &rows, block);
        let derivatives = gradients.into_par_iter().zip(inverses);
        let blocks = masses.zip(errors).zip(codes.zip(remarks)).zip(derivatives).enumerate();
        let done = blocks.try_for_each(|(number, (((masses, errors), (codes, remarks)), derivatives))| {
            let first = rows.start + number * block;
            let row_positions = first..first + masses.len();
            let mut buffer = buffers().pop().unwrap_or_default();
            let Some(positions) = layout.block_positions(q, row_positions.clone(), &mut buffer) else {
                return Err(BlockFailure::NotFinite);
            };
            // Without findings of all rows, `remarks` is already correct: zero.
            if common_remarks != 0 {
                remarks.fill(common_remarks);
            }
            let contacts = contacts.map(|contacts| contacts.of_rows(row_positions));
            let (gradients, inverses) = derivatives;
            let block = Block { masses, errors, codes, remarks, gradients, inverses };
            let done = block.solve(batch, positions, contacts, columns.has_base_pose);
            done.map_err(BlockFailure::Refused)?;
            buffers().push(buffer);
            Ok(())
        });
        done.map_err(|failure| match failure {
            BlockFailure::NotFinite => nonfinite_error(q, rows),
            BlockFailure::Refused(error) => input(error),
        })
    })
}

/// Result arrays of the rows that a thread solves at once. Before the solution, `codes` holds the code of finite masses and `remarks` the
/// findings that all rows have.
pub struct Block<'a> {
    pub masses: &'a mut [f64],
    pub errors: &'a mut [f64],
    pub codes: &'a mut [u8],
    pub remarks: &'a mut [u32],
    pub gradients: Option<&'a mut [f64]>,
    pub inverses: Option<&'a mut [f64]>,
}

impl Block<'_> {
    /// Solves the rows of a block. `contacts`: a contact for each row; `None`: the contact of the batch.
    ///
    /// # Errors
    /// [`BatchError`] of the batch.
    pub fn solve(
        self,
        batch: &BatchDerivatives,
        positions: BatchPositions<'_>,
        contacts: Option<BatchContacts<'_>>,
        has_base_pose: bool,
    ) -> Result<(), BatchError> {
        let Self { masses, errors, codes, remarks, gradients, inverses } = self;
        let base = if has_base_pose { RemarkFlags::BASE_NOT_GIVEN.bits() } else { 0 };
        let mut other = |at: usize, answer: BatchAnswer| {
            remarks[at] = answer.remarks.bits() & !base;
            let rounding = answer.is_massless_to_rounding();
            codes[at] = if rounding { MASSLESS_TO_ROUNDING } else { mass_and_code(answer.mass).1 };
        };
        match (gradients, inverses, contacts) {
            (None, None, None) => batch.batch().run_columns(positions, masses, errors, other),
            (None, None, Some(contacts)) => {
                batch.batch().run_contacts(positions, contacts, masses, errors, other)
            }
            (gradients, inverses, contacts) => {
                if let Some(to) = gradients {
                    let columns = (&mut *masses, &mut *errors);
                    batch.gradients(positions, contacts, columns, to, &mut other)?;
                }
                match inverses {
                    Some(to) => {
                        batch.inverse_operational_inertias(positions, contacts, (masses, errors), to, other)
                    }
                    None => Ok(()),
                }
            }
        }
    }
}

/// Reason for a failed block.
enum BlockFailure {
    NotFinite,
    Refused(BatchError),
}

impl<'a> Rows<'a> {
    /// Positions of a range of rows; `None` if a number is not finite.
    fn block_positions<'b>(
        self,
        q: ArrayView2<'_, f64>,
        rows: Range<usize>,
        buffer: &'b mut Vec<f64>,
    ) -> Option<BatchPositions<'b>>
    where
        'a: 'b,
    {
        let (count, width, row_count) = (q.nrows(), q.ncols(), rows.len());
        let (values, positions) = match self {
            Rows::RowMajor(values) => {
                let values = &values[rows.start * width..rows.end * width];
                (values, BatchPositions::Rows { values, stride: width })
            }
            Rows::Columns(values) => {
                let column = |c: usize| &values[c * count..][rows.clone()];
                let positions = BatchPositions::Columns {
                    values: values.get(rows.start..).unwrap_or_default(),
                    stride: count,
                };
                return (0..width).all(|c| is_finite(column(c))).then_some(positions);
            }
            Rows::Strided => {
                buffer.clear();
                q.slice(s![rows, ..]).rows().into_iter().for_each(|row| buffer.extend(row));
                (&buffer[..], BatchPositions::Rows { values: buffer, stride: width })
            }
            // Column by column: the fastest layout.
            Rows::Some { position_indices, zero_positions } => {
                buffer.clear();
                zero_positions.iter().for_each(|x| buffer.extend(std::iter::repeat_n(*x, row_count)));
                for (column, index) in position_indices.iter().enumerate() {
                    let to = &mut buffer[index * row_count..(index + 1) * row_count];
                    to.iter_mut().zip(q.slice(s![rows.clone(), column])).for_each(|(to, x)| *to = *x);
                }
                (&buffer[..], BatchPositions::Columns { values: buffer, stride: row_count })
            }
        };
        is_finite(values).then_some(positions)
    }
}

/// Blocks of a matrix of results for a range of its rows; `None` for each block if the matrix is not wanted.
pub fn optional_chunks<'a>(
    values: Option<&'a mut [f64]>,
    count: usize,
    rows: &Range<usize>,
    block: usize,
) -> Vec<Option<&'a mut [f64]>> {
    let blocks = rows.len().div_ceil(block);
    let width = values.as_ref().map_or(0, |values| values.len().checked_div(count).unwrap_or(0));
    match values {
        Some(values) if width > 0 => {
            let values = &mut values[rows.start * width..rows.end * width];
            values.chunks_mut(block * width).map(Some).collect()
        }
        Some(_) => (0..blocks).map(|_| Some(&mut [][..])).collect(),
        None => (0..blocks).map(|_| None).collect(),
    }
}

/// Solves rows with all positions.
pub fn solve_all_positions(
    py: Python<'_>,
    question: RowQuestion<'_>,
    q: &PyReadonlyArray2<'_, f64>,
    columns: Columns<'_>,
) -> PyResult<()> {
    let layout = match q.as_slice() {
        Ok(values) if q.is_c_contiguous() => Rows::RowMajor(values),
        Ok(values) => Rows::Columns(values),
        Err(_) => Rows::Strided,
    };
    solve_rows(py, question, q.as_array(), layout, columns)
}

/// Solves rows with some positions and the others at 0, for mechanisms without loops.
pub fn solve_tree(
    py: Python<'_>,
    question: RowQuestion<'_>,
    model: &Model,
    q: &PyReadonlyArray2<'_, f64>,
    position_indices: &[(JointId, usize)],
    columns: Columns<'_>,
) -> PyResult<()> {
    let mechanism = &model.read.mechanism;
    let zero = Configuration::zero(mechanism);
    let zero_positions: Vec<f64> = mechanism.joint_ids().flat_map(|joint| zero.get(joint).to_vec()).collect();
    let position_indices: Vec<usize> = position_indices.iter().map(|(_, index)| *index).collect();
    solve_rows(
        py,
        question,
        q.as_array(),
        Rows::Some { position_indices: &position_indices, zero_positions: &zero_positions },
        columns,
    )
}
