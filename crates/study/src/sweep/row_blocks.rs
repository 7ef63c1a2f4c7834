//! Numbers of the rows of a sweep, in order, one block at a time.

use crate::evaluation::random_rows::RandomRows;
use crate::question::error::{Fault, StudyError};
use crate::question::field::Field;
use crate::question::vary::Values;
use crate::sweep::continuation::Along;
use crate::tables::trajectory::Trajectory;

/// Consecutive rows with their numbers.
#[derive(Debug)]
pub(crate) struct Block {
    pub first: usize,
    pub count: usize,
    values: Vec<f64>,
    width: usize,
}

impl Block {
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
pub(crate) enum Rows {
    /// All combinations of the values of some ranges; the last range varies fastest.
    Grid(Vec<Values>),
    /// Rows of a file.
    File(Box<Trajectory>),
    /// Random rows.
    Random(RandomRows),
}

impl Rows {
    /// Number of rows.
    pub fn count(&self) -> Option<usize> {
        match self {
            Rows::Grid(ranges) => Some(ranges.iter().map(|range| range.count).product()),
            Rows::File(file) => Some(file.count()),
            Rows::Random(random) => Some(random.count),
        }
    }

    /// Number of rows in a line, that is, rows followed from a common start; `None` if all rows form one line.
    pub fn rows_per_line(&self) -> Option<usize> {
        match self {
            Rows::Grid(ranges) => ranges.last().map(|range| range.count),
            Rows::File(_) => None,
            Rows::Random(_) => Some(1),
        }
    }

    /// Number of a row that measures the distance along a line.
    pub fn along(&self) -> Along {
        match self {
            Rows::Grid(_) => Along::Last,
            Rows::File(_) | Rows::Random(_) => Along::Anything,
        }
    }

    /// Next rows, from `first` on; fewer or none at the end. `first` must follow the last block.
    pub fn block(&mut self, first: usize, count: usize) -> Result<Block, StudyError> {
        match self {
            Rows::Grid(ranges) => {
                let all: usize = ranges.iter().map(|range| range.count).product();
                let count = count.min(all.saturating_sub(first));
                let mut values = vec![0.0; count * ranges.len()];
                for (row, values) in (first..).zip(values.chunks_exact_mut(ranges.len().max(1))) {
                    let mut rest = row;
                    for (value, range) in values.iter_mut().zip(&*ranges).rev() {
                        *value = range.of_row(rest % range.count);
                        rest /= range.count;
                    }
                }
                Ok(Block { first, count, values, width: ranges.len() })
            }
            Rows::Random(random) => {
                let count = count.min(random.count.saturating_sub(first));
                let mut values = Vec::with_capacity(count * random.width);
                (first..first + count).for_each(|row| random.push_row(row, &mut values));
                Ok(Block { first, count, values, width: random.width })
            }
            Rows::File(file) => {
                let refuse = |error| StudyError::input(Field::Input, Fault::Table(Box::new(error)));
                let (values, width) = (file.read(count).map_err(refuse)?, file.width());
                Ok(Block { first, count: values.len() / width.max(1), values, width })
            }
        }
    }
}
