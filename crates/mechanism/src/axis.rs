//! Axes: made unit vectors.

use crate::limits;
use percuss_spatial::Vector3;

/// Normalised without overflow or underflow; left as it is where it is a unit vector already.
pub(crate) fn unit(axis: &Vector3<f64>) -> Vector3<f64> {
    let exact = (axis.norm() - 1.0).abs() <= limits::UNIT_ROUNDING;
    if exact { *axis } else { (axis / axis.amax()).normalize() }
}
