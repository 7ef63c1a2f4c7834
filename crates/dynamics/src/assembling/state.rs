//! What a closed pose of a mechanism with loops rests on.

use crate::mobility::Singularity;
use percuss_mechanism::JointId;

/// What a closed pose of a mechanism with loops rests on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoopState {
    /// Largest residual of a closure or coupling, m.
    pub residual: f64,
    /// How far the file's loops are from fitting, m: rounding that least squares had to spread; else 0.
    pub inexactness: f64,
    /// The joints that drive the loops; the others of their groups depend on them.
    pub drivers: Vec<JointId>,
    /// Whether the file declared exactly these as independent.
    pub declared: bool,
    /// Drivers that were not set and could not be brought to 0, with where they are.
    pub off_zero: Vec<(JointId, f64)>,
    /// Joints with several positions that were set and have more numbers than their loops leave freedoms: how far from there
    /// they stand (rad or m, all velocities together).
    pub off_target: Vec<(JointId, f64)>,
    /// From how many seeded starts another assembly mode was found, where the branch of the first did not reach.
    pub starts_tried: Option<usize>,
    /// For each group of loops, its assembly mode: the sign of the determinant of the dependent coordinates' Jacobian. 0
    /// where it vanishes (see [`singularities`](Self::singularities)), and of groups of more than 160 coordinates.
    pub modes: Vec<i8>,
    /// For each group of loops, whether it stands at a dead centre of its drivers or at a change point.
    pub singularities: Vec<Singularity>,
    /// For each group, its coordinates (by index into it) that depend.
    pub(crate) dependent: Vec<Vec<usize>>,
    /// For each group that stands (nearly) singular, positions of a regular pose on the same branch.
    pub(crate) anchors: Vec<Option<Vec<f64>>>,
}
