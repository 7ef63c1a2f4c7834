//! Compiled closures and couplings.

use super::body::LinkFrame;
use nalgebra::Vector3;
use percuss_mechanism::ClosureKind;

/// A compiled closure.
#[derive(Clone, Debug)]
pub(crate) struct CompiledClosure {
    pub name: String,
    pub kind: ClosureKind,
    pub predecessor: LinkFrame,
    pub successor: LinkFrame,
    /// Axis in the predecessor's loop frame.
    pub axis: Vector3<f64>,
    /// Axis in the successor's loop frame, for kinds that align axes: equal to `axis` or reversed.
    pub successor_axis: Vector3<f64>,
    /// Two unit vectors normal to the axis.
    pub normals: [Vector3<f64>; 2],
    /// Second axis of a universal closure, on the successor.
    pub axis2: Vector3<f64>,
    /// Distance of a distance closure, m.
    pub distance: f64,
    /// True if the distance was not declared, and is measured with all joints at 0.
    pub measured_distance: bool,
}

/// A compiled coupling: Σ factor q = 0.
#[derive(Clone, Debug)]
pub(crate) struct CompiledCoupling {
    pub name: String,
    /// Position index, body and factor of each joint.
    pub terms: Vec<(usize, usize, f64)>,
    /// True if the sum is an angle (rad), false for a length (m).
    pub turns: bool,
}
