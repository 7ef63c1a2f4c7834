//! Bodies, the frames of links on them, and coordinates.

use crate::joint_motion::JointMotion;
use percuss_mechanism::JointId;
use percuss_spatial::{SpatialInertia, Transform};
use std::ops::Range;

/// A body of the tree with the joint above it. Links held together by fixed joints are one body.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    /// The body that carries it; none: the ground.
    pub parent: Option<usize>,
    /// The joint above it; none: the floating base.
    pub joint: Option<JointId>,
    pub motion: JointMotion,
    /// X_pj: the joint frame in the parent body.
    pub origin: Transform<f64>,
    /// About the body's origin, fixed links included.
    pub inertia: SpatialInertia<f64>,
    /// Its part of the vector of positions.
    pub q: Range<usize>,
    /// Its part of the tree's velocities; empty when locked.
    pub v: Range<usize>,
    /// Armature of each velocity, kg·m² or kg.
    pub armature: Vec<f64>,
    /// The joint's position as a function of another's.
    pub mimic: Option<MimicPosition>,
}

/// q = multiplier · positions[master] + offset.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MimicPosition {
    pub master: usize,
    pub multiplier: f64,
    pub offset: f64,
}

/// The frame of a link: its body (none: the ground) and X_bl.
#[derive(Clone, Debug)]
pub(crate) struct LinkFrame {
    pub body: Option<usize>,
    pub frame: Transform<f64>,
}

/// The coordinate that a velocity of the tree follows: v = multiplier · u[index]. Mimics share their master's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Follows {
    pub index: usize,
    pub multiplier: f64,
}

/// An independent velocity of the tree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Coordinate {
    /// Its joint; none: the floating base.
    pub joint: Option<JointId>,
    /// Which velocity of the joint it is.
    pub component: usize,
    /// Whether it turns (rad/s) or slides (m/s).
    pub turns: bool,
    /// What the file declares: to drive, to depend, or nothing.
    pub independent: Option<bool>,
    /// Whether the joint looks driven: it declares limits or an effort.
    pub actuated: bool,
    /// How many bodies carry its body.
    pub depth: usize,
}
