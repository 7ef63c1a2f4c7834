//! State of the loops at a closed pose.

use crate::mobility::Singularity;
use percuss_mechanism::JointId;

/// State of the loops at a closed pose.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoopState {
    /// Largest residual of a closure or coupling, m.
    pub residual: f64,
    /// Misfit of the file's loops, m: rounding distributed by least squares; 0 for loops that close exactly.
    pub inexactness: f64,
    /// Joints that drive the loops; the other joints of their groups depend on these.
    pub drivers: Vec<JointId>,
    /// True if the file declared exactly these joints as independent.
    pub declared: bool,
    /// Drivers that were not set and could not be moved to 0, with their positions.
    pub off_zero: Vec<(JointId, f64)>,
    /// Joints that were set to more values than their loops leave degrees of freedom, and their distance from the set
    /// position (rad or m, all velocities together).
    pub off_target: Vec<(JointId, f64)>,
    /// Number of seeded starts until another assembly mode was found, if the first branch did not reach the
    /// positions.
    pub starts_tried: Option<usize>,
    /// Assembly mode of each group of loops: the sign of the determinant of the dependent coordinates' Jacobian. 0 if
    /// the determinant vanishes (see [`singularities`](Self::singularities)), and for groups of more than 160
    /// coordinates.
    pub modes: Vec<i8>,
    /// Singularity of each group of loops: a dead centre of its drivers, or a change point.
    pub singularities: Vec<Singularity>,
    /// Dependent coordinates of each group (by index into the group).
    pub(crate) dependent: Vec<Vec<usize>>,
    /// For each group at a (nearly) singular pose: positions of a regular pose on the same branch.
    pub(crate) anchors: Vec<Option<Vec<f64>>>,
}
