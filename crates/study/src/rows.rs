//! The numbers of the rows of a sweep, some at a time and in order.

use crate::error::{Fault, StudyError};
use crate::field::Field;
use crate::line::Along;
use crate::random_rows::RandomRows;
use crate::trajectory::Trajectory;
use crate::vary::Values;

/// Rows one after another, with their numbers.
#[derive(Debug)]
pub(crate) struct Block {
    pub first: usize,
    pub count: usize,
    values: Vec<f64>,
    width: usize,
}

impl Block {
    /// The numbers of the rows from one on.
    pub fn values_from(&self, row: usize, end: usize) -> &[f64] {
        &self.values[row * self.width..end * self.width]
    }

    /// The numbers of a row, counted from the first of the block.
    pub fn values(&self, row: usize) -> &[f64] {
        &self.values[row * self.width..][..self.width]
    }
}

/// Where the numbers of rows come from.
#[derive(Debug)]
pub(crate) enum Rows {
    /// Every combination of the values of some ranges, the last the fastest.
    Grid(Vec<Values>),
    /// The rows of a file.
    File(Box<Trajectory>),
    /// Random ones.
    Random(RandomRows),
}

impl Rows {
    /// How many rows there are, where that is known.
    pub fn count(&self) -> Option<usize> {
        match self {
            Rows::Grid(ranges) => Some(ranges.iter().map(|range| range.count).product()),
            Rows::File(file) => Some(file.count()),
            Rows::Random(random) => Some(random.count),
        }
    }

    /// How many rows follow one another from one start; none: all.
    pub fn line(&self) -> Option<usize> {
        match self {
            Rows::Grid(ranges) => ranges.last().map(|range| range.count),
            Rows::File(_) => None,
            Rows::Random(_) => Some(1),
        }
    }

    /// Which number tells how far out a row of a line lies.
    pub fn along(&self) -> Along {
        match self {
            Rows::Grid(_) => Along::Last,
            Rows::File(_) | Rows::Random(_) => Along::Anything,
        }
    }

    /// Some rows from `first` on, where the last ones ended; fewer, or none, at the end.
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
