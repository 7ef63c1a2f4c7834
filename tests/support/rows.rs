//! Results of a batch as a list.

use percuss_dynamics::{Batch, BatchAnswer, BatchError, BatchRows, RowResults};

/// Results of `count` rows, computed in blocks.
///
/// # Errors
/// [`BatchError`] of the batch.
pub fn answers<'a>(
    batch: &Batch,
    rows: impl Into<BatchRows<'a>>,
    count: usize,
    block: usize,
) -> Result<Vec<BatchAnswer>, BatchError> {
    let mut results = RowResults::new(count);
    batch.run(rows, results.columns(), block)?;
    Ok((0..count).map(|row| results.answer(row)).collect())
}
