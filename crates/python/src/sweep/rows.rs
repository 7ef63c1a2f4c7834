//! Rows of q, solved in blocks on all threads.

use crate::conversion::errors::input;
use crate::conversion::threads::Threads;
use crate::sweep::portions::{Progress, run_portions};
use numpy::{PyReadonlyArray2, PyUntypedArrayMethods};
use percuss::{Batch, BatchError, BatchPositions, BatchRows, RowColumns};
use pyo3::prelude::*;

/// Least and greatest block size of a thread, in configurations. At the greatest size, positions and results stay in
/// the cache.
const BLOCK_SIZES: (usize, usize) = (256, 1 << 11);
/// Blocks per thread and portion. Several blocks balance the load from other processes.
const BLOCKS_PER_THREAD: usize = 8;

/// Contact, threads and progress of a sweep.
#[derive(Clone, Copy)]
pub struct RowQuestion<'a> {
    pub batch: &'a Batch,
    pub threads: Threads,
    pub progress: &'a Progress<'a>,
}

/// Numbers of q, a contiguous array.
pub fn numbers_of<'a>(q: &'a PyReadonlyArray2<'_, f64>) -> PyResult<BatchPositions<'a>> {
    let values = q.as_slice()?;
    Ok(match q.is_c_contiguous() {
        true => BatchPositions::Rows { values, stride: q.shape()[1] },
        false => BatchPositions::Columns { values, stride: q.shape()[0] },
    })
}

/// Error of rows that are refused.
pub fn refused_rows(error: BatchError) -> PyErr {
    match error {
        BatchError::NotFinite { configuration, number, value } => {
            input(format_args!("q[{configuration}, {number}] is {value}; expected finite numbers"))
        }
        other => input(other),
    }
}

/// Solves rows that do not depend on each other, in blocks on all threads. Each number is read, checked, solved and written while it is in
/// the cache.
pub fn solve_rows(
    py: Python<'_>,
    question: RowQuestion<'_>,
    rows: BatchRows<'_>,
    mut columns: RowColumns<'_, u8>,
) -> PyResult<()> {
    let RowQuestion { batch, threads, progress } = question;
    run_portions(py, columns.masses.len(), false, (threads, progress), |range| {
        // Of the pool of this process.
        let threads = rayon::current_num_threads();
        let block = range.len().div_ceil(threads * BLOCKS_PER_THREAD).clamp(BLOCK_SIZES.0, BLOCK_SIZES.1);
        let done = batch.run(rows.part(range.clone()), columns.part(range.clone()), block);
        done.map_err(|error| refused_rows(error.in_rows_from(range.start)))
    })
}
