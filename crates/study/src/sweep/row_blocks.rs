//! Numbers of the rows of a sweep, in order, one block at a time.

use crate::evaluation::random_rows::RandomRows;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::travel::vary::EvenlySpacedValues;
use crate::tables::trajectory::Trajectory;

/// Number of a row that measures the distance along a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum DistanceMeasure {
    /// Last number: the values of a range.
    LastNumber,
    /// No number: all numbers change from row to row.
    Undefined,
}

/// Consecutive rows with their numbers.
#[derive(Debug)]
pub(crate) struct RowBlock {
    pub first: usize,
    pub count: usize,
    values: Vec<f64>,
    width: usize,
}

impl RowBlock {
    /// Numbers of the rows from `row` to `end` (excluded), counted from the first row of the block.
    pub fn values_from(&self, row: usize, end: usize) -> &[f64] {
        &self.values[row * self.width..end * self.width]
    }

    /// Numbers of a row, counted from the first row of the block.
    pub fn values(&self, row: usize) -> &[f64] {
        &self.values[row * self.width..][..self.width]
    }
}

/// Source of the rows.
#[derive(Debug)]
pub(crate) enum RowReader {
    /// All combinations of the values of some ranges; the last range varies fastest.
    Grid(Vec<EvenlySpacedValues>),
    /// Rows of a file.
    File(Box<Trajectory>),
    /// Random rows.
    Random(RandomRows),
}

impl RowReader {
    /// Number of rows.
    pub fn count(&self) -> Option<usize> {
        match self {
            RowReader::Grid(ranges) => Some(ranges.iter().map(|range| range.count).product()),
            RowReader::File(file) => Some(file.count()),
            RowReader::Random(random) => Some(random.count),
        }
    }

    /// Number of rows in a line, that is, rows followed from a common start; `None` if all rows form one line.
    pub fn rows_per_line(&self) -> Option<usize> {
        match self {
            RowReader::Grid(ranges) => ranges.last().map(|range| range.count),
            RowReader::File(_) => None,
            RowReader::Random(_) => Some(1),
        }
    }

    /// Number of a row that measures the distance along a line.
    pub fn distance_measure(&self) -> DistanceMeasure {
        match self {
            RowReader::Grid(_) => DistanceMeasure::LastNumber,
            RowReader::File(_) | RowReader::Random(_) => DistanceMeasure::Undefined,
        }
    }

    /// Next rows, from `first` on; fewer or none at the end. `first` must follow the last block.
    pub fn block(&mut self, first: usize, count: usize) -> Result<RowBlock, StudyError> {
        match self {
            RowReader::Grid(ranges) => {
                let all: usize = ranges.iter().map(|range| range.count).product();
                let count = count.min(all.saturating_sub(first));
                let mut values = vec![0.0; count * ranges.len()];
                for (row, values) in (first..).zip(values.chunks_exact_mut(ranges.len().max(1))) {
                    let mut rest = row;
                    for (value, range) in values.iter_mut().zip(&*ranges).rev() {
                        *value = range.value_at(rest % range.count);
                        rest /= range.count;
                    }
                }
                Ok(RowBlock { first, count, values, width: ranges.len() })
            }
            RowReader::Random(random) => {
                let count = count.min(random.count.saturating_sub(first));
                let mut values = Vec::with_capacity(count * random.width);
                (first..first + count).for_each(|row| random.append_row(row, &mut values));
                Ok(RowBlock { first, count, values, width: random.width })
            }
            RowReader::File(file) => {
                let refuse = |error| StudyError::input("sweep.input", Fault::Table(Box::new(error)));
                let (values, width) = (file.read(count).map_err(refuse)?, file.width());
                Ok(RowBlock { first, count: values.len() / width.max(1), values, width })
            }
        }
    }
}
