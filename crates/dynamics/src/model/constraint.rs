//! Closures and couplings, compiled.

use super::body::LinkFrame;
use nalgebra::Vector3;
use percuss_mechanism::ClosureKind;

/// A closure, compiled.
#[derive(Clone, Debug)]
pub(crate) struct CompiledClosure {
    pub name: String,
    pub kind: ClosureKind,
    pub predecessor: LinkFrame,
    pub successor: LinkFrame,
    /// In the predecessor's loop frame.
    pub axis: Vector3<f64>,
    /// What the kinds that compare axes bring onto it, in the successor's loop frame: the same vector, or its reverse.
    pub successor_axis: Vector3<f64>,
    /// Two unit vectors normal to the axis.
    pub normals: [Vector3<f64>; 2],
    /// The successor's pin of a universal closure.
    pub axis2: Vector3<f64>,
    /// m; of a distance closure.
    pub distance: f64,
    /// Whether the distance was measured with all joints at 0, since none is declared.
    pub measured_distance: bool,
}

/// A coupling, compiled: Σ factor q = 0.
#[derive(Clone, Debug)]
pub(crate) struct CompiledCoupling {
    pub name: String,
    /// Position, body and factor of each joint.
    pub terms: Vec<(usize, usize, f64)>,
    /// Whether its sum is an angle (rad) and not a length (m).
    pub turns: bool,
}
