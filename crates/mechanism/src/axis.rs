//! Normalisation of axes.

use crate::limits;
use percuss_spatial::Vector3;

/// Normalises an axis without overflow or underflow; an axis of unit length is kept unchanged.
pub(crate) fn unit(axis: &Vector3<f64>) -> Vector3<f64> {
    let exact = (axis.norm() - 1.0).abs() <= limits::UNIT_ROUNDING;
    if exact { *axis } else { (axis / axis.amax()).normalize() }
}
