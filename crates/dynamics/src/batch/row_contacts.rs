//! Contact points and normals that differ from configuration to configuration.

use crate::batch::error::BatchError;
use crate::batch::rows::{BLOCK, BatchPositions};
use crate::kinematics::contact::Contact;
use crate::model::Model;
use crate::tolerances::{LARGEST_NUMBER, SHORTEST_DIRECTION};
use nalgebra::Vector3;
use percuss_kernel::{ContactConversion, LaneContacts};
use percuss_spatial::Transform;
use std::ops::Range;

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

/// Contacts of a portion.
#[derive(Clone, Copy)]
pub(super) struct RowContacts<'a> {
    pub contact: &'a Contact,
    /// Points and normals of the configurations, if they differ.
    pub contacts: Option<BatchContacts<'a>>,
    /// Pose of the root link in the world, for normals given in the world.
    pub base: Option<&'a Transform<f64>>,
}

impl RowContacts<'_> {
    /// Point and normal of a configuration; a normal given in the world in the axes of the root link.
    #[inline]
    fn in_root_axes(&self, contacts: &BatchContacts<'_>, configuration: usize) -> [Vector3<f64>; 2] {
        let [point, normal] = contacts.at(configuration);
        [point, self.base.map_or(normal, |x_wr| x_wr.inverse_vector(&normal))]
    }

    /// Contact at a configuration.
    pub fn at(&self, configuration: usize) -> Contact {
        let Some((_, frame)) = self.contact.normal.vector() else { return *self.contact };
        self.contacts.map_or(*self.contact, |contacts| {
            let [point, normal] = self.in_root_axes(&contacts, configuration);
            Contact { point, normal: self.contact.normal.with_vector(normal, frame), ..*self.contact }
        })
    }

    /// Copies the positions with the indices `read` of `count` configurations, and their contacts, to `columns`, [`BLOCK`] apart: the
    /// input of a kernel. The contacts have the last columns. Lanes after the last configuration, up to `padded`, repeat it.
    pub fn fill_lanes(
        &self,
        columns: &mut [f64],
        (positions, read): (BatchPositions<'_>, &[usize]),
        conversion: Option<&ContactConversion>,
        first: usize,
        (count, padded): (usize, usize),
    ) {
        let contact_column = columns.len() - LaneContacts::COUNT * BLOCK;
        for lane in 0..padded {
            let configuration = first + lane.min(count - 1);
            positions.copy_to_columns(configuration, read, &mut columns[lane..]);
            if let (Some(contacts), Some(conversion)) = (&self.contacts, conversion) {
                let [point, normal] = self.in_root_axes(contacts, configuration);
                let [point, normal] = conversion.convert(&point, &normal);
                let numbers = point.iter().chain(&normal).enumerate();
                numbers.for_each(|(k, x)| columns[contact_column + k * BLOCK + lane] = *x);
            }
        }
    }
}
