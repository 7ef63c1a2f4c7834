//! Contact points, normals and base poses that differ from row to row.

use crate::analysis::system::{root_frame, root_frame_of};
use crate::conversion::arrays::{float64, float64_matrix, shape};
use crate::conversion::errors::input;
use crate::conversion::labels::AXES;
use numpy::PyUntypedArrayMethods;
use percuss::input::{LARGEST_NUMBER, not_a_number};
use percuss::nalgebra::Vector3;
use percuss::spatial::Transform;
use percuss::{BatchContacts, Contact as Resolved, Frame};
use pyo3::prelude::*;
use pyo3::types::PyAny;

/// Shortest accepted normal, of any unit: that of a single contact.
const SHORTEST_NORMAL: f64 = 1e-9;

/// Pose of the root link in the world, as given.
pub enum BasePose {
    NotGiven,
    /// The same for all rows.
    One(Transform<f64>),
    /// One for each row.
    Rows(Vec<Transform<f64>>),
}

impl BasePose {
    /// Reads base_pose: (7,) or (N, 7).
    pub fn of(given: Option<&Bound<'_, PyAny>>, rows: usize) -> PyResult<Self> {
        let Some(given) = given else { return Ok(Self::NotGiven) };
        let expected = "(7,) or (N, 7): x, y, z (m), w, x, y, z (unit quaternion)";
        let found = float64(given, "base_pose", &[0, 1, 2], expected)?;
        if found.ndim() < 2 {
            return root_frame(given).map(Self::One);
        }
        if found.shape() != [rows, 7] {
            return Err(input(format_args!(
                "base_pose has shape {}; expected (7,), or ({rows}, 7): one for each row of q",
                shape(found.shape())
            )));
        }
        let numbers: Vec<f64> = found.as_array().iter().copied().collect();
        numbers.chunks(7).map(root_frame_of).collect::<PyResult<_>>().map(Self::Rows)
    }

    /// Pose common to all rows, if it is given.
    pub fn one(&self) -> Option<&Transform<f64>> {
        match self {
            Self::One(base) => Some(base),
            Self::NotGiven | Self::Rows(_) => None,
        }
    }

    /// Pose at a row, if it is given.
    pub fn at(&self, row: usize) -> Option<&Transform<f64>> {
        match self {
            Self::Rows(bases) => bases.get(row),
            Self::NotGiven | Self::One(_) => self.one(),
        }
    }

    pub fn is_given(&self) -> bool {
        !matches!(self, Self::NotGiven)
    }
}

/// Point and normal of each row, or of all rows.
pub struct RowContacts {
    points: Vec<f64>,
    normals: Vec<f64>,
}

impl RowContacts {
    /// Reads points and normals: (N, 3). `contact`: the contact as given, whose point and normal hold where none are given.
    /// `None` if all rows have the same contact.
    pub fn of(
        contact: &Resolved,
        points: Option<&Bound<'_, PyAny>>,
        normals: Option<&Bound<'_, PyAny>>,
        base: &BasePose,
        rows: usize,
    ) -> PyResult<Option<Self>> {
        let is_given = points.is_some() || normals.is_some();
        let vector = contact.normal.vector().filter(|_| !(is_given && contact.normal.is_moment()));
        let Some((normal, frame)) = vector else {
            return match is_given {
                true => Err(input(
                    "points and normals need a contact with a normal; this contact has toward, or is a moment",
                )),
                false => Ok(None),
            };
        };
        let in_world = frame == Frame::World || (frame == Frame::Against && contact.against.is_none());
        let has_bases = in_world && matches!(base, BasePose::Rows(_));
        if !is_given && !has_bases {
            return Ok(None);
        }
        let read = |given: Option<&Bound<'_, PyAny>>, what: &str, constant: &Vector3<f64>| match given {
            Some(given) => three_per_row(given, what, rows),
            None => Ok(constant.as_slice().to_vec()),
        };
        let points = read(points, "points", &contact.point)?;
        let normals = read(normals, "normals", &normal)?;
        check_normals(&normals)?;
        let in_root_axes = |row: usize| {
            let first = if normals.len() == 3 { 0 } else { 3 * row };
            let normal = Vector3::from_column_slice(&normals[first..first + 3]);
            let base = base.at(row).filter(|_| in_world);
            base.map_or(normal, |base| base.inverse_vector(&normal)).data.0[0]
        };
        let count = if has_bases { rows } else { normals.len() / 3 };
        let normals = (0..count).flat_map(in_root_axes).collect();
        Ok(Some(Self { points, normals }))
    }

    /// Contacts of all rows.
    pub fn all(&self) -> BatchContacts<'_> {
        BatchContacts { points: &self.points, normals: &self.normals }
    }
}

/// Three numbers for each row; columns x, y, z in any order if they have names.
fn three_per_row(given: &Bound<'_, PyAny>, what: &str, rows: usize) -> PyResult<Vec<f64>> {
    let found = float64_matrix(given, what, "(N, 3): x, y, z for each row of q", &AXES, "")?;
    if found.shape() != [rows, 3] {
        return Err(input(format_args!(
            "{what} has shape {}; expected ({rows}, 3): x, y, z for each row of q",
            shape(found.shape())
        )));
    }
    let numbers: Vec<f64> = found.as_array().iter().copied().collect();
    if let Some((at, value)) = not_a_number(&numbers) {
        return Err(input(format_args!(
            "{what}[{}, {}] is {value:e}; expected finite numbers of at most {LARGEST_NUMBER:e}",
            at / 3,
            at % 3
        )));
    }
    Ok(numbers)
}

/// Refuses normals without a length.
fn check_normals(normals: &[f64]) -> PyResult<()> {
    let length = |normal: &[f64]| Vector3::from_column_slice(normal).norm();
    match normals.chunks(3).position(|normal| length(normal) < SHORTEST_NORMAL) {
        Some(row) => Err(input(format_args!("normals[{row}] has no length; expected a direction"))),
        None => Ok(()),
    }
}

/// Gradient of m̄ by the twist of the root link, as [`MassGradient::base`](percuss::MassGradient::base), from Λ⁻¹ of the rows.
pub mod base_gradients {
    use percuss::nalgebra::{Matrix3, Vector3};
    use percuss::{Contact, Frame};

    /// True if the gradient is zero: the normal moves with the root link.
    pub fn is_zero(contact: &Contact) -> bool {
        match contact.normal.vector() {
            Some((_, Frame::World)) => false,
            Some((_, Frame::Against)) => contact.against.is_some(),
            Some((_, Frame::Link)) | None => true,
        }
    }

    /// True if the gradient is computed from Λ⁻¹ of the contact link: the other side is the ground.
    pub fn needs_inverse_inertia(contact: &Contact) -> bool {
        !is_zero(contact) && contact.against.is_none()
    }

    /// Writes 2 m̄² n̂ × Φ n̂ and 0 of all rows; NaN where a gradient has no digits. `contact`, `normals`: in root axes, the normals three
    /// for each row or three for all. `gradients`: as many per row as there are velocities.
    pub fn fill(
        contact: &Contact,
        normals: Option<&[f64]>,
        masses: &[f64],
        gradients: &[f64],
        inverses: &[f64],
        to: &mut [f64],
    ) {
        let Some((one, _)) = contact.normal.vector() else { return };
        let (first, width) =
            (if contact.normal.is_moment() { 0 } else { 3 }, gradients.len() / masses.len().max(1));
        for (row, to) in to.chunks_exact_mut(6).enumerate() {
            let normal = match normals {
                None => one,
                Some(all) => {
                    let from = if all.len() == 3 { 0 } else { 3 * row };
                    Vector3::from_column_slice(&all[from..from + 3])
                }
            }
            .normalize();
            let phi = Matrix3::from_fn(|r, c| inverses[36 * row + 6 * (first + r) + first + c]);
            let is_known = gradients[width * row..][..width].iter().all(|x| x.is_finite());
            let factor = if is_known { 2.0 * masses[row] * masses[row] } else { f64::NAN };
            to[..3].copy_from_slice((factor * normal.cross(&(phi * normal))).as_slice());
            to[3..].fill(0.0 * factor);
        }
    }
}
