//! Results of a sweep by columns, in arrays of numpy.

use crate::analysis::matrices::mass_and_code;
use numpy::{Element, PyArray1, PyArrayMethods, PyReadwriteArray1};
use percuss::{Contact, Pose, Remark, RemarkFlags};
use pyo3::prelude::*;

/// Status of a contact that is massless to rounding only: its mass may be hidden by the rounding of larger masses.
pub const MASSLESS_TO_ROUNDING: u8 = 4;

/// Results by columns.
pub struct Columns<'a> {
    pub masses: &'a mut [f64],
    pub errors: &'a mut [f64],
    pub codes: &'a mut [u8],
    pub remarks: &'a mut [u32],
    /// Gradients of m̄, row by row.
    pub gradients: Option<&'a mut [f64]>,
    /// Inverse operational inertias, 36 numbers per row.
    pub inverses: Option<&'a mut [f64]>,
    /// True if the base pose is given; the poses of a path do not contain it.
    pub has_base_pose: bool,
}

/// Array of zeros in numpy's memory. numpy allocates large arrays in large pages, so the first write is almost free.
/// Pages of 4 kB would cost a third of the solution time of an arm.
pub fn zeros<T: Element>(py: Python<'_>, count: usize) -> (Bound<'_, PyArray1<T>>, PyReadwriteArray1<'_, T>) {
    let array = PyArray1::zeros(py, count, false);
    (array.clone(), array.readwrite())
}

impl Columns<'_> {
    /// Writes the result of a row: NaN without a mass or an error.
    pub fn set(
        &mut self,
        at: usize,
        mass: Option<percuss::EffectiveMass>,
        error: Option<f64>,
        remarks: RemarkFlags,
    ) {
        (self.masses[at], self.codes[at]) = mass_and_code(mass);
        self.errors[at] = error.unwrap_or(f64::NAN);
        self.remarks[at] = self.reported_bits(remarks);
    }

    /// Stores the results of a row without a pose: NaN, also for its derivatives, and the remark `NO_ANSWER`.
    pub fn set_without_answer(&mut self, at: usize) {
        self.set(at, None, None, RemarkFlags::NO_ANSWER);
        let count = self.masses.len();
        for numbers in [&mut self.gradients, &mut self.inverses].into_iter().flatten() {
            let width = numbers.len() / count;
            numbers[at * width..(at + 1) * width].fill(f64::NAN);
        }
    }

    /// Bits of the findings, without that of a missing base pose if the sweep has a base pose.
    pub fn reported_bits(&self, remarks: RemarkFlags) -> u32 {
        let base = if self.has_base_pose { RemarkFlags::BASE_NOT_GIVEN.bits() } else { 0 };
        remarks.bits() & !base
    }

    /// Solves one row at its pose.
    ///
    /// # Errors
    /// The reason of a row without an answer.
    pub fn respond(&mut self, pose: &Pose, contact: &Contact, at: usize) -> Result<(), String> {
        let response = pose.respond(contact).map_err(|error| error.to_string())?;
        let mass = Some(response.effective_mass);
        self.set(at, mass, response.effective_mass_error(), response.remark_flags());
        for remark in &response.remarks {
            if let Remark::MasslessToRounding { up_to } = remark {
                (self.codes[at], self.errors[at]) = (MASSLESS_TO_ROUNDING, *up_to);
            }
        }
        Ok(())
    }
}
