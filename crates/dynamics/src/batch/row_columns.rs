//! Rows of positions with their contacts, and the columns of their results.

use crate::batch::contact_map::ContactStatus;
use crate::batch::error::BatchError;
use crate::batch::row_contacts::BatchContacts;
use crate::batch::rows::{BatchAnswer, BatchPositions};
use crate::kinematics::outcome::EffectiveMass;
use std::iter::repeat_n;
use std::ops::Range;

/// Rows of a batch: positions, and a contact for each row if they differ.
#[derive(Clone, Copy, Debug)]
pub struct BatchRows<'a> {
    /// Positions of the rows.
    pub positions: BatchPositions<'a>,
    /// Joint positions that the rows give; `None`: all.
    pub given: Option<GivenPositions<'a>>,
    /// Points and normals; `None`: those of the contact of the batch.
    pub contacts: Option<BatchContacts<'a>>,
    /// True if a number of a row that is not finite is an error; otherwise the row has no answer, if m̄ depends on the number.
    pub finite_only: bool,
}

/// Rows that give some positions only.
#[derive(Clone, Copy, Debug)]
pub struct GivenPositions<'a> {
    /// Index of the position of each number of a row.
    pub indices: &'a [usize],
    /// Positions of all joints; those that no row gives hold at every row.
    pub others: &'a [f64],
}

impl<'a> From<BatchPositions<'a>> for BatchRows<'a> {
    fn from(positions: BatchPositions<'a>) -> Self {
        Self { positions, given: None, contacts: None, finite_only: false }
    }
}

impl<'a> BatchRows<'a> {
    /// Some of the rows.
    #[must_use]
    pub fn part(&self, rows: Range<usize>) -> Self {
        let contacts = self.contacts.map(|contacts| contacts.part(&rows));
        Self { positions: self.positions.skip(rows.start), contacts, ..*self }
    }

    /// Checks the numbers of `count` rows. `width`: number of positions of all joints.
    pub(super) fn check(&self, width: usize, count: usize) -> Result<(), BatchError> {
        let numbers = self.given.map_or(width, |given| given.indices.len());
        self.positions.check(numbers, count)?;
        if let Some(GivenPositions { indices, others }) = self.given
            && (others.len() != width || indices.iter().any(|index| *index >= width))
        {
            let (got, largest) = (others.len(), indices.iter().copied().max().unwrap_or(0));
            return Err(BatchError::GivenPositions { got, largest, width });
        }
        self.contacts.map_or(Ok(()), |contacts| contacts.check_count(count))
    }

    /// Positions of all joints at the first `count` rows, which [`check`](Self::check) accepts. `width`: number of positions of all joints.
    pub(super) fn all_positions<'b>(
        &self,
        width: usize,
        count: usize,
        buffer: &'b mut Vec<f64>,
    ) -> Result<BatchPositions<'b>, BatchError>
    where
        'a: 'b,
    {
        if self.finite_only {
            let numbers = self.given.map_or(width, |given| given.indices.len());
            self.positions.refuse_not_finite(numbers, count)?;
        }
        let Some(GivenPositions { indices, others }) = self.given else { return Ok(self.positions) };
        // By columns: the fastest layout.
        buffer.clear();
        others.iter().for_each(|x| buffer.extend(repeat_n(*x, count)));
        for (number, index) in indices.iter().enumerate() {
            let to = buffer[index * count..][..count].iter_mut().enumerate();
            to.for_each(|(row, to)| *to = self.positions.at(row, number));
        }
        Ok(BatchPositions::Columns { values: buffer, stride: count })
    }
}

impl<'a> BatchPositions<'a> {
    /// Position `q` of a configuration.
    #[inline]
    pub(super) fn at(&self, configuration: usize, q: usize) -> f64 {
        match self {
            BatchPositions::Rows { values, stride } => values[configuration * stride + q],
            BatchPositions::Columns { values, stride } => values[q * stride + configuration],
        }
    }

    /// Configurations from `first` on.
    fn skip(self, first: usize) -> Self {
        let rest = |values: &'a [f64], numbers: usize| values.get(numbers..).unwrap_or_default();
        match self {
            Self::Rows { values, stride } => {
                Self::Rows { values: rest(values, first.saturating_mul(stride)), stride }
            }
            Self::Columns { values, stride } => Self::Columns { values: rest(values, first), stride },
        }
    }

    /// Checks the stride and the number of values, for `configurations` of `width` numbers.
    ///
    /// # Errors
    /// [`BatchError::Stride`], [`BatchError::Short`].
    pub fn check(&self, width: usize, configurations: usize) -> Result<(), BatchError> {
        let (got, stride, least, outer, inner) = match self {
            Self::Rows { values, stride } => (values.len(), *stride, width, configurations, width),
            Self::Columns { values, stride } => {
                (values.len(), *stride, configurations, width, configurations)
            }
        };
        if stride < least {
            return Err(BatchError::Stride { stride, least });
        }
        let needed = outer.checked_sub(1).and_then(|o| o.checked_mul(stride)?.checked_add(inner));
        match needed {
            None if outer == 0 => Ok(()),
            Some(needed) if needed <= got || inner == 0 => Ok(()),
            _ => {
                let needed = needed.unwrap_or(usize::MAX);
                Err(BatchError::Short { got, needed, configurations, positions: width, stride })
            }
        }
    }

    /// Refuses numbers that are not finite, in rows that [`check`](Self::check) accepts.
    ///
    /// # Errors
    /// [`BatchError::NotFinite`]: the first of these numbers, row by row.
    pub fn refuse_not_finite(&self, width: usize, configurations: usize) -> Result<(), BatchError> {
        // Reads all entries so that the loop vectorizes; an early exit would take as long as solving an arm.
        let is_finite = |values: &[f64]| !values.iter().fold(false, |bad, x| bad | !x.is_finite());
        let all = match *self {
            Self::Rows { values, stride } if stride == width => is_finite(&values[..configurations * width]),
            Self::Rows { values, stride } => {
                (0..configurations).all(|row| is_finite(&values[row * stride..][..width]))
            }
            Self::Columns { values, stride } => {
                (0..width).all(|number| is_finite(&values[number * stride..][..configurations]))
            }
        };
        let mut entries = (0..configurations).flat_map(|row| (0..width).map(move |number| (row, number)));
        match entries.find(|(row, number)| !all && !self.at(*row, *number).is_finite()) {
            Some((configuration, number)) => {
                let value = self.at(configuration, number);
                Err(BatchError::NotFinite { configuration, number, value })
            }
            None => Ok(()),
        }
    }
}

/// Columns of results, with an entry for each row. `S`: status, as a [`ContactStatus`] or as its number.
#[derive(Debug)]
pub struct RowColumns<'a, S> {
    /// m̄, kg; NaN unless finite.
    pub masses: &'a mut [f64],
    /// [`BatchAnswer::error`], kg; NaN if unknown.
    pub errors: &'a mut [f64],
    /// Statuses.
    pub statuses: &'a mut [S],
    /// Bits of [`BatchAnswer::remarks`].
    pub remarks: Option<&'a mut [u32]>,
    /// Gradients of m̄, row by row: one number per velocity of all joints.
    pub gradients: Option<&'a mut [f64]>,
    /// Inverse operational inertias, 36 numbers per row.
    pub inverse_inertias: Option<&'a mut [f64]>,
}

/// Splits a matrix of `count` rows before a row.
fn split_matrix(
    values: Option<&mut [f64]>,
    count: usize,
    row: usize,
) -> (Option<&mut [f64]>, Option<&mut [f64]>) {
    let width = values.as_ref().map_or(0, |values| values.len().checked_div(count).unwrap_or(0));
    values.map(|values| values.split_at_mut(row * width)).unzip()
}

impl<S> RowColumns<'_, S> {
    /// Columns of some rows.
    pub fn part(&mut self, rows: Range<usize>) -> RowColumns<'_, S> {
        let all = RowColumns {
            masses: self.masses,
            errors: self.errors,
            statuses: self.statuses,
            remarks: self.remarks.as_deref_mut(),
            gradients: self.gradients.as_deref_mut(),
            inverse_inertias: self.inverse_inertias.as_deref_mut(),
        };
        all.split_at(rows.end).0.split_at(rows.start).1
    }

    /// Columns before a row, and from it on.
    pub(super) fn split_at(self, row: usize) -> (Self, Self) {
        let count = self.masses.len();
        let (masses, masses_after) = self.masses.split_at_mut(row);
        let (errors, errors_after) = self.errors.split_at_mut(row);
        let (statuses, statuses_after) = self.statuses.split_at_mut(row);
        let (remarks, remarks_after) = self.remarks.map(|remarks| remarks.split_at_mut(row)).unzip();
        let (gradients, gradients_after) = split_matrix(self.gradients, count, row);
        let (inverse_inertias, inverses_after) = split_matrix(self.inverse_inertias, count, row);
        let after = Self {
            masses: masses_after,
            errors: errors_after,
            statuses: statuses_after,
            remarks: remarks_after,
            gradients: gradients_after,
            inverse_inertias: inverses_after,
        };
        (Self { masses, errors, statuses, remarks, gradients, inverse_inertias }, after)
    }
}

impl<S: From<ContactStatus>> RowColumns<'_, S> {
    /// Stores the result of a row, without its derivatives.
    pub fn set(&mut self, row: usize, answer: &BatchAnswer) {
        let finite = |mass| if let EffectiveMass::Finite(m) = mass { m } else { f64::NAN };
        self.masses[row] = answer.mass.map_or(f64::NAN, finite);
        self.errors[row] = answer.error.unwrap_or(f64::NAN);
        self.statuses[row] = answer.status().into();
        if let Some(remarks) = &mut self.remarks {
            remarks[row] = answer.remarks.bits();
        }
    }

    /// Stores NaN and [`BatchAnswer::NONE`] in all rows.
    pub fn clear(&mut self) {
        (0..self.masses.len()).for_each(|row| self.set(row, &BatchAnswer::NONE));
        for numbers in [&mut self.gradients, &mut self.inverse_inertias].into_iter().flatten() {
            numbers.fill(f64::NAN);
        }
    }
}
