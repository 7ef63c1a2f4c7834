//! Rows of positions, with a contact for each row if they differ.

use crate::batch::error::BatchError;
use crate::kinematics::contact::Contact;
use crate::model::Model;
use crate::tolerances::{LARGEST_NUMBER, SHORTEST_DIRECTION};
use nalgebra::Vector3;
use percuss_kernel::{ContactConversion, LaneContacts};
use percuss_spatial::Transform;
use std::iter::repeat_n;
use std::ops::Range;

/// Number of configurations per call of the SIMD kernel: a multiple of the lane count of every instruction set.
pub(super) const BLOCK: usize = 64;

/// Positions of many configurations. Each configuration holds the positions of all joints one after another, in joint
/// order.
#[derive(Clone, Copy, Debug)]
pub enum BatchPositions<'a> {
    /// Configuration `c` begins at index `c · stride`.
    Rows {
        /// The positions.
        values: &'a [f64],
        /// Distance between consecutive configurations.
        stride: usize,
    },
    /// Position `q` of configuration `c` has index `q · stride + c`. The fastest layout.
    Columns {
        /// The positions.
        values: &'a [f64],
        /// Distance between consecutive positions.
        stride: usize,
    },
}

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
            Self::Rows { values, stride } => values[configuration * stride + q],
            Self::Columns { values, stride } => values[q * stride + configuration],
        }
    }

    /// Writes the positions with indices `read` of a configuration to `to`, [`BLOCK`] apart.
    fn copy_to_columns(&self, configuration: usize, read: &[usize], to: &mut [f64]) {
        match self {
            Self::Rows { values, stride } => {
                let row = &values[configuration * stride..];
                read.iter().for_each(|&q| to[q * BLOCK] = row[q]);
            }
            Self::Columns { .. } => {
                read.iter().for_each(|&q| to[q * BLOCK] = self.at(configuration, q));
            }
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

/// Contact points and normals that differ from configuration to configuration, on the link of one contact.
#[derive(Clone, Copy, Debug)]
pub struct BatchContacts<'a> {
    /// Points in the frame of the contact link, m: three numbers for each configuration, or three for all.
    pub points: &'a [f64],
    /// Normals of any length, in the frame of the contact's normal: three numbers for each configuration, or three for all.
    pub normals: &'a [f64],
}

impl<'a> BatchContacts<'a> {
    /// Contacts of some configurations.
    #[must_use]
    pub fn part(&self, rows: &Range<usize>) -> Self {
        let part = |numbers: &'a [f64]| match numbers.len() {
            3 => numbers,
            _ => numbers.get(3 * rows.start..3 * rows.end).unwrap_or_default(),
        };
        Self { points: part(self.points), normals: part(self.normals) }
    }

    /// Point (m) and normal of a configuration, as given.
    #[inline]
    pub(super) fn at(&self, configuration: usize) -> [Vector3<f64>; 2] {
        [self.points, self.normals].map(|numbers| {
            let first = if numbers.len() == 3 { 0 } else { 3 * configuration };
            Vector3::new(numbers[first], numbers[first + 1], numbers[first + 2])
        })
    }

    /// Checks the number of points and normals.
    pub(super) fn check_count(&self, configurations: usize) -> Result<(), BatchError> {
        let (points, normals) = (self.points.len(), self.normals.len());
        match [points, normals].iter().any(|n| *n != 3 && configurations.checked_mul(3) != Some(*n)) {
            true => Err(BatchError::ContactCount { points, normals, configurations }),
            false => Ok(()),
        }
    }

    /// Checks the number of points and normals, and each contact.
    pub(super) fn check(
        &self,
        model: &Model,
        contact: &Contact,
        configurations: usize,
    ) -> Result<(), BatchError> {
        let Some((_, frame)) = contact.normal.vector() else { return Err(BatchError::NormalAlongLine) };
        self.check_count(configurations)?;
        for configuration in 0..configurations {
            let [point, normal] = self.at(configuration);
            let square = normal.norm_squared();
            // True for ordinary numbers only; all others are checked one by one.
            if square > SHORTEST_DIRECTION && square + point.norm_squared() < LARGEST_NUMBER {
                continue;
            }
            let contact = Contact { point, normal: contact.normal.with_vector(normal, frame), ..*contact };
            model.check_contact(&contact).map_err(|error| BatchError::Contact { configuration, error })?;
        }
        Ok(())
    }
}

/// Positions and contacts of a block of rows.
#[derive(Clone, Copy)]
pub(super) struct RowBlock<'a> {
    /// Positions of all joints.
    pub positions: BatchPositions<'a>,
    pub contact: &'a Contact,
    /// Points and normals of the rows, if they differ.
    pub contacts: Option<BatchContacts<'a>>,
    /// Pose of the root link in the world, for normals given in the world.
    pub base: Option<&'a Transform<f64>>,
}

impl RowBlock<'_> {
    /// Point and normal of a row; a normal given in the world in the axes of the root link.
    #[inline]
    fn in_root_axes(&self, contacts: &BatchContacts<'_>, row: usize) -> [Vector3<f64>; 2] {
        let [point, normal] = contacts.at(row);
        [point, self.base.map_or(normal, |x_wr| x_wr.inverse_vector(&normal))]
    }

    /// Contact at a row.
    pub fn contact_at(&self, row: usize) -> Contact {
        let Some((_, frame)) = self.contact.normal.vector() else { return *self.contact };
        self.contacts.map_or(*self.contact, |contacts| {
            let [point, normal] = self.in_root_axes(&contacts, row);
            Contact { point, normal: self.contact.normal.with_vector(normal, frame), ..*self.contact }
        })
    }

    /// Copies the positions with the indices `read` of `count` rows, and their contacts, to `columns`, [`BLOCK`] apart: the input of
    /// a kernel. The contacts have the last columns. Lanes after the last row, up to `padded`, repeat it.
    pub fn fill_lanes(
        &self,
        columns: &mut [f64],
        read: &[usize],
        conversion: Option<&ContactConversion>,
        first: usize,
        (count, padded): (usize, usize),
    ) {
        let contact_column = columns.len() - LaneContacts::COUNT * BLOCK;
        for lane in 0..padded {
            let row = first + lane.min(count - 1);
            self.positions.copy_to_columns(row, read, &mut columns[lane..]);
            if let (Some(contacts), Some(conversion)) = (&self.contacts, conversion) {
                let [point, normal] = self.in_root_axes(contacts, row);
                let [point, normal] = conversion.convert(&point, &normal);
                let numbers = point.iter().chain(&normal).enumerate();
                numbers.for_each(|(k, x)| columns[contact_column + k * BLOCK + lane] = *x);
            }
        }
    }
}
