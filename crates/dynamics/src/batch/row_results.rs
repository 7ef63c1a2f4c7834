//! Results of rows.

use crate::analysis::response::ContactResponse;
use crate::kinematics::outcome::{EffectiveMass, Remark};
use crate::kinematics::remarks::RemarkFlags;
use std::ops::Range;

/// Status of a contact of a map or of a row. The numbers are those of the Python package and of `PERCUSS_FINITE` … in C.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[repr(u8)]
pub enum ContactStatus {
    /// m̄ is finite.
    #[default]
    Finite,
    /// No admissible motion closes the gap.
    Immovable,
    /// A motion without mass closes the gap: m̄ = 0.
    Massless,
    /// No result: the contact is invalid (no normal, a number that is not finite), or [`Pose::respond`](crate::Pose::respond) returns an
    /// error.
    Unanswered,
    /// Only in rows: massless within rounding. The error is the upper limit of m̄, kg.
    MasslessToRounding,
}

impl From<ContactStatus> for u8 {
    fn from(status: ContactStatus) -> Self {
        status as u8
    }
}

impl From<ContactStatus> for i32 {
    fn from(status: ContactStatus) -> Self {
        i32::from(u8::from(status))
    }
}

/// Result for one configuration.
#[must_use]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BatchAnswer {
    /// m̄; `None` if there is no result. `remarks` contains the reason, and [`Workspace::effective_mass`](crate::Workspace::effective_mass) at the
    /// configuration returns the error.
    pub mass: Option<EffectiveMass>,
    /// Error, kg; `None` unless m̄ is finite, and if the error is above m̄ or unknown ([`RemarkFlags::UNKNOWN_ERROR`]). For a massless contact: upper limit of m̄, if the contact is
    /// massless only within rounding ([`Remark::MasslessToRounding`](crate::Remark::MasslessToRounding) of a pose).
    pub error: Option<f64>,
    /// Findings about the result, or the reason for a missing result. Limits of mimics are not checked.
    pub remarks: RemarkFlags,
}

impl BatchAnswer {
    /// Initial value: no result yet.
    pub const NONE: Self = Self { mass: None, error: None, remarks: RemarkFlags::NONE };
    /// Result of a row without a pose.
    pub const UNREACHED: Self = Self { remarks: RemarkFlags::NO_ANSWER, ..Self::NONE };

    /// Finite m̄, kg, with its error.
    pub fn finite(mass: f64, error: f64, remarks: RemarkFlags) -> Self {
        Self { mass: Some(EffectiveMass::Finite(mass)), error: Some(error), remarks }
    }

    /// Status of the contact.
    pub fn status(&self) -> ContactStatus {
        match self.mass {
            Some(EffectiveMass::Finite(_)) => ContactStatus::Finite,
            Some(EffectiveMass::Immovable) => ContactStatus::Immovable,
            Some(EffectiveMass::Massless) if self.error.is_some() => ContactStatus::MasslessToRounding,
            Some(EffectiveMass::Massless) => ContactStatus::Massless,
            None => ContactStatus::Unanswered,
        }
    }
}

impl From<&ContactResponse> for BatchAnswer {
    fn from(response: &ContactResponse) -> Self {
        let limit = response.remarks.iter().find_map(|remark| match remark {
            Remark::MasslessToRounding { up_to } => Some(*up_to),
            _ => None,
        });
        let error = match response.effective_mass {
            EffectiveMass::Finite(_) => response.effective_mass_error(),
            EffectiveMass::Immovable | EffectiveMass::Massless => limit,
        };
        Self { mass: Some(response.effective_mass), error, remarks: response.remark_flags() }
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

/// Results of rows, with their memory.
#[must_use]
#[derive(Clone, Debug)]
pub struct RowResults {
    /// m̄, kg; NaN unless finite.
    pub masses: Vec<f64>,
    /// Errors, kg; NaN if unknown.
    pub errors: Vec<f64>,
    /// Statuses.
    pub statuses: Vec<ContactStatus>,
    /// Bits of [`BatchAnswer::remarks`].
    pub remarks: Vec<u32>,
}

impl RowResults {
    /// Memory for `count` rows.
    pub fn new(count: usize) -> Self {
        let [masses, errors] = [(); 2].map(|()| vec![f64::NAN; count]);
        Self { masses, errors, statuses: vec![ContactStatus::Unanswered; count], remarks: vec![0; count] }
    }

    /// Columns of all rows, without derivatives.
    pub fn columns(&mut self) -> RowColumns<'_, ContactStatus> {
        RowColumns {
            masses: &mut self.masses,
            errors: &mut self.errors,
            statuses: &mut self.statuses,
            remarks: Some(&mut self.remarks),
            gradients: None,
            inverse_inertias: None,
        }
    }

    /// Result of a row.
    pub fn answer(&self, row: usize) -> BatchAnswer {
        let mass = match self.statuses[row] {
            ContactStatus::Finite => Some(EffectiveMass::Finite(self.masses[row])),
            ContactStatus::Immovable => Some(EffectiveMass::Immovable),
            ContactStatus::Massless | ContactStatus::MasslessToRounding => Some(EffectiveMass::Massless),
            ContactStatus::Unanswered => None,
        };
        let error = Some(self.errors[row]).filter(|error| !error.is_nan());
        BatchAnswer { mass, error, remarks: RemarkFlags::from_bits(self.remarks[row]) }
    }
}
