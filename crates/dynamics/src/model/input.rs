//! Validation rules for all inputs, at every entry point. Poses, workspaces, batches, paths, maps, matrices and the
//! interfaces to other languages share this implementation.
//!
//! | rule | accepted | refused with |
//! |---|---|---|
//! | length | as many numbers as are needed | the numbers given and needed |
//! | finite | numbers of at most [`LARGEST_NUMBER`]; positions of mimics are not read | the number and its index |
//! | unit quaternion | a norm within [`QUATERNION_TOLERANCE`] of 1; the quaternion is normalised | the norm |
//! | closed loops | a row of positions whose loops are open by at most [`OPEN_ROW`] of their size | the gap and the tolerance, m |
//! | direction | vectors of at least 1e-9; vectors are normalised | the length |
//! | own link | indices of this mechanism, or of one with the same links and joints | the index |
//! | base pose | a finite position, and a rotation matrix to within [`ROTATION_TOLERANCE`]; its rounding is removed | the number, or the departure |

use nalgebra::{Matrix3, Vector3};
use percuss_mechanism::{JointKind, LinkId, Mechanism};
use percuss_spatial::{Transform, rotation_from_quaternion};

use crate::tolerances::UNIT_ROUNDING;
pub use crate::tolerances::{LARGEST_NUMBER, OPEN_ROW, QUATERNION_TOLERANCE, ROTATION_TOLERANCE};

/// Invalid input that no other error attributes to a joint or a contact.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InputError {
    /// A number is NaN, infinite or above 1e100 in magnitude.
    #[error("{what}: number {index} (from 0) is {value:e}; expected a finite number of at most 1e100")]
    NotFinite {
        /// Name of the input.
        what: &'static str,
        /// Index of the number, from 0.
        index: usize,
        /// The number.
        value: f64,
    },
    /// A quaternion is not of unit length.
    #[error(
        "{what}: the quaternion w,x,y,z has norm {norm}; expected 1 ± {QUATERNION_TOLERANCE}: divide it by its norm"
    )]
    Quaternion {
        /// Name of the input.
        what: &'static str,
        /// Norm of the quaternion.
        norm: f64,
    },
    /// The matrix of a frame is not a rotation.
    #[error(
        "the pose of the base: its matrix departs from a rotation by {departure:.1e}; expected a rotation matrix, RᵀR = 1 to \
         within {ROTATION_TOLERANCE:e}, det R = 1"
    )]
    Rotation {
        /// Largest entry of RᵀR − 1; infinite for a reflection.
        departure: f64,
    },
}

/// Returns the index and the value of the first number that is NaN, infinite or above [`LARGEST_NUMBER`].
pub fn not_a_number(values: &[f64]) -> Option<(usize, f64)> {
    values.iter().copied().enumerate().find(|(_, x)| !is_number(*x))
}

/// True if a number is finite and at most [`LARGEST_NUMBER`].
pub(crate) fn is_number(x: f64) -> bool {
    x.abs() <= LARGEST_NUMBER
}

/// Refuses numbers that are NaN, infinite or above [`LARGEST_NUMBER`].
///
/// # Errors
/// [`InputError::NotFinite`].
pub fn check_numbers(what: &'static str, values: &[f64]) -> Result<(), InputError> {
    not_a_number(values).map_or(Ok(()), |(index, value)| Err(InputError::NotFinite { what, index, value }))
}

/// Scales a quaternion w, x, y, z to unit norm. A quaternion of norm 1 within rounding is left unchanged, bit for
/// bit.
///
/// # Errors
/// The norm, if further than [`QUATERNION_TOLERANCE`] from 1 or NaN.
pub fn normalise_quaternion(quaternion: &mut [f64]) -> Result<(), f64> {
    let norm = quaternion.iter().fold(0.0, |norm: f64, x| norm.hypot(*x));
    if norm.is_nan() || (norm - 1.0).abs() > QUATERNION_TOLERANCE {
        return Err(norm);
    }
    if (norm - 1.0).abs() > UNIT_ROUNDING {
        quaternion.iter_mut().for_each(|x| *x /= norm);
    }
    Ok(())
}

/// Range of the quaternion among the positions of a joint; `None` for joints without a quaternion.
pub(crate) fn quaternion_of(kind: JointKind) -> Option<std::ops::Range<usize>> {
    match kind {
        JointKind::Spherical => Some(0..4),
        JointKind::Floating => Some(3..7),
        JointKind::Fixed
        | JointKind::Revolute
        | JointKind::Continuous
        | JointKind::Prismatic
        | JointKind::Planar => None,
    }
}

/// Pose X_wr of the root link in the world, from its origin (m) and its orientation, a quaternion w, x, y, z.
///
/// # Errors
/// [`InputError`]: a number that is not finite; a quaternion that is not of unit length.
pub fn base_pose(position: [f64; 3], mut quaternion: [f64; 4]) -> Result<Transform<f64>, InputError> {
    check_numbers("the position of the base", &position)?;
    check_numbers("the orientation of the base", &quaternion)?;
    normalise_quaternion(&mut quaternion)
        .map_err(|norm| InputError::Quaternion { what: "the orientation of the base", norm })?;
    Ok(Transform::new(rotation_from_quaternion(quaternion), Vector3::from(position)))
}

/// Removes the rounding of the matrix of a base pose. The result satisfies RᵀR = 1 to within two roundings.
///
/// # Errors
/// [`InputError`]: a number that is not finite; a matrix that departs from a rotation by more than
/// [`ROTATION_TOLERANCE`].
pub fn rigid_base_pose(x_wr: &Transform<f64>) -> Result<Transform<f64>, InputError> {
    check_numbers("the position of the base", x_wr.translation.as_slice())?;
    check_numbers("the orientation of the base", x_wr.rotation.as_slice())?;
    let mut rotation = x_wr.rotation;
    let departure = |r: &Matrix3<f64>| (r.transpose() * r - Matrix3::identity()).amax();
    let given = if rotation.determinant() < 0.0 { f64::INFINITY } else { departure(&rotation) };
    if given.is_nan() || given > ROTATION_TOLERANCE {
        return Err(InputError::Rotation { departure: given });
    }
    // Each step of Newton's method for the polar factor squares the departure.
    for _ in 0..2 {
        if departure(&rotation) > 8.0 * f64::EPSILON {
            rotation = rotation * (Matrix3::identity() * 3.0 - rotation.transpose() * rotation) * 0.5;
        }
    }
    Ok(Transform::new(rotation, x_wr.translation))
}

/// Index of the first link that does not belong to the mechanism.
pub(crate) fn foreign_link(mechanism: &Mechanism, links: impl IntoIterator<Item = LinkId>) -> Option<usize> {
    links.into_iter().find(|link| !mechanism.has_link(*link)).map(LinkId::index)
}
