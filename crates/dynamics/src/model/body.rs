//! Bodies, link frames and coordinates.

use crate::model::joint_motion::JointMotion;
use percuss_mechanism::JointId;
use percuss_spatial::{SpatialInertia, Transform};
use std::ops::Range;

/// Body of the tree with the joint to its parent. Links joined by fixed joints form one body.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    /// Parent body; `None` for the ground.
    pub parent: Option<usize>,
    /// Joint to the parent; `None` for the floating base.
    pub joint: Option<JointId>,
    pub motion: JointMotion,
    /// X_pj: joint frame in the parent body.
    pub origin: Transform<f64>,
    /// Inertia about the body's origin, including fixed links.
    pub inertia: SpatialInertia<f64>,
    /// Range in the vector of positions.
    pub q: Range<usize>,
    /// Range in the tree velocities; empty if locked.
    pub v: Range<usize>,
    /// Armature of each velocity, kg·m² or kg.
    pub armature: Vec<f64>,
    /// Position as a function of another joint's position, for mimics.
    pub mimic: Option<MimicPosition>,
}

/// q = multiplier · positions[master] + offset.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MimicPosition {
    pub master: usize,
    pub multiplier: f64,
    pub offset: f64,
}

/// Frame of a link: X_bl and the body; the body is `None` for the ground.
#[derive(Clone, Debug)]
pub(crate) struct LinkFrame {
    pub body: Option<usize>,
    pub frame: Transform<f64>,
}

/// Coordinate of a tree velocity: v = multiplier · u[index]. Mimics share the coordinate of their master.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct VelocityCoordinate {
    pub index: usize,
    pub multiplier: f64,
}

/// Independent velocity of the tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Coordinate {
    /// Joint; `None` for the floating base.
    pub joint: Option<JointId>,
    /// Index of the velocity within the joint.
    pub component: usize,
    /// True for a rotation (rad/s), false for a translation (m/s).
    pub turns: bool,
    /// Declaration in the file: independent, dependent, or none.
    pub independent: Option<bool>,
    /// True if the joint declares limits or an effort, and is therefore probably actuated.
    pub actuated: bool,
    /// Number of ancestors of the body.
    pub depth: usize,
}
