//! Compiled form of a mechanism of few degrees of freedom: bodies with the joint axis as the z axis of their frames,
//! the rows that close the loops, and the order in which dependent coordinates are eliminated.

use super::layout::Layout;
use crate::mechanism::{BodyDirection, BodyPoint, JointPosition, Relation, RowForm};
use nalgebra::Vector3;
use percuss_spatial::Transform;

/// Motion of a body relative to its parent.
#[derive(Clone, Copy, Debug)]
pub(super) enum LoopMotion {
    /// No motion.
    Fixed,
    /// Rotation about z.
    Turn(JointPosition),
    /// Translation along z.
    Slide(JointPosition),
    /// Translations along x and y of the joint frame by two positions, and rotation about z by the third.
    Planar(usize),
    /// Rotation by the quaternion that starts at a position index.
    Ball(usize),
    /// Translation by three positions, and rotation by the quaternion that follows.
    Floating(usize),
    /// Floating base: its pose is the reference frame.
    Base,
}

impl LoopMotion {
    /// True if component `k` of the joint's velocity is a translation.
    pub fn translates(self, k: usize) -> bool {
        match self {
            Self::Slide(_) => true,
            Self::Planar(_) => k < 2,
            Self::Floating(_) | Self::Base => k >= 3,
            Self::Fixed | Self::Turn(_) | Self::Ball(_) => false,
        }
    }
}

/// One velocity of a body's joint.
#[derive(Clone, Copy, Debug)]
pub(super) struct LoopVelocity {
    /// Column of A: pivot columns in order, then the independent ones.
    pub column: usize,
    /// Joint velocity per unit rate of that coordinate. Coordinates are measured in metres.
    pub factor: f64,
    pub armature: f64,
}

/// A body and its joint.
#[derive(Clone, Debug)]
pub(super) struct LoopBody {
    pub parent: Option<usize>,
    /// Frame of the joint in the parent's frame.
    pub rotation: [[f64; 3]; 3],
    pub translation: [f64; 3],
    pub motion: LoopMotion,
    pub velocities: Vec<LoopVelocity>,
    /// Mass, first moment, moments and products of inertia (xx, xy, xz, yy, yz, zz); `None` if all are zero.
    pub inertia: Option<[f64; 10]>,
    /// For each independent coordinate: true if the coordinate can move the body.
    pub moved_by: Vec<bool>,
    /// X_bo: frame of the plan (o) in the body frame of the model.
    pub frame: Transform<f64>,
    /// Upper bound of the distance from the body's origin to the joint of any ancestor, without travels of slides, m.
    pub reach: f64,
}

/// Joint velocity that occurs in the rows of a block.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockTerm {
    pub body: usize,
    /// Index among the velocities of the body's joint.
    pub component: usize,
    pub slides: bool,
    pub column: usize,
    pub factor: f64,
    /// Factor in the argument of the curve of a relation.
    pub argument: f64,
    /// True for the first term of its column in the block.
    pub is_first: bool,
}

/// Row of A of a block.
#[derive(Clone, Debug)]
pub(super) struct BlockRow {
    /// Number of the row.
    pub row: usize,
    /// Number of the entry of A for each term of the block.
    pub entries: Vec<usize>,
}

/// Rows that bind the same joint velocities.
#[derive(Clone, Debug)]
pub(super) struct Block {
    /// Target of the successor's point; `None` without a closure.
    pub predecessor: Option<BodyPoint>,
    pub successor: BodyPoint,
    /// Forms with their rows; `None` for an unused row.
    pub forms: Vec<(RowForm, [Option<BlockRow>; 3])>,
    pub terms: Vec<BlockTerm>,
    /// Index of the relation of a coupling whose slope or residual is computed.
    pub relation: Option<usize>,
}

impl Block {
    /// Rows of A of the block.
    pub fn rows(&self) -> impl Iterator<Item = &BlockRow> {
        self.forms.iter().flat_map(|(_, rows)| rows).flatten()
    }

    /// Rows of A of the block, mutable.
    pub fn rows_mut(&mut self) -> impl Iterator<Item = &mut BlockRow> {
        self.forms.iter_mut().flat_map(|(_, rows)| rows).flatten()
    }
}

/// Pivot of A on the diagonal, with the nonzero rows below it and the nonzero columns to its right. An entry is given by its number: its
/// index among the nonzero entries of A, row by row.
#[derive(Clone, Debug, Default)]
pub(super) struct RowPivot {
    /// Entry of the pivot.
    pub entry: usize,
    /// Each row with its entry in the column of the pivot.
    pub rows: Vec<(usize, usize)>,
    /// Each column with its entry in the row of the pivot.
    pub columns: Vec<(usize, usize)>,
    /// Entries that the elimination changes: for each of `rows`, one per element of `columns`.
    pub changed: Vec<usize>,
}

/// Mechanism of few degrees of freedom.
#[derive(Clone, Debug)]
pub(super) struct LoopPlan {
    pub bodies: Vec<LoopBody>,
    pub blocks: Vec<Block>,
    pub relations: Vec<Relation>,
    pub pivots: Vec<RowPivot>,
    /// Fill-in: entries of A without a term of their own that become nonzero in the elimination.
    pub filled_in: Vec<usize>,
    /// Entries of the redundant rows of A in the independent columns: zero after the elimination.
    pub remainders: Vec<usize>,
    /// For each coordinate and each independent one: true if the rate can be nonzero.
    pub depends_on: Vec<bool>,
    /// Largest magnitude of an entry of A, in the columns that may be dependent, at the pose of compilation.
    pub scale: f64,
    /// Largest remainder of a redundant row after the elimination.
    pub redundant: f64,
    /// Smallest length of a rotational coordinate, m.
    pub length: f64,
    /// Bound of the kinetic energy (kg): twice the energy of any motion is at most `weight` times the square of the
    /// sum of all absolute rates (m/s). Sum over armatures, masses at their reach and moments of inertia.
    pub weight: f64,
    /// Per coordinate: upper bound of √(twice the kinetic energy) at a unit rate of this coordinate alone, √kg.
    pub root_weights: Vec<f64>,
    /// Largest number of coordinates between a body and the ground.
    pub chain: f64,
    /// Error of the entries of A in roundings, from the depth of the tree alone.
    pub roundings: f64,
    pub columns: usize,
    pub freedoms: usize,
    pub layout: Layout,
    /// Massless bodies from the floating base on. Contacts on them are not supported; the joints to their children have no columns.
    pub massless: Vec<usize>,
    /// Origin of positions, in the root frame (m): near the linkage, because distant positions have a larger rounding.
    pub centre: Vector3<f64>,
}

impl LoopPlan {
    /// Converts a point from the body frame of the model, or from the root frame, to the frame of the plan.
    pub fn point(&self, body: Option<usize>, at: &Vector3<f64>) -> BodyPoint {
        BodyPoint { body, at: self.frame(body).inverse_point(at).into() }
    }

    /// The plan's frame of a body, or of the root, in that of the model.
    pub fn frame(&self, body: Option<usize>) -> Transform<f64> {
        body.map_or_else(|| Transform::from_translation(self.centre), |b| self.bodies[b].frame)
    }

    /// Converts a direction from the body frame of the model, or from the root frame, to the frame of the plan.
    pub fn direction(&self, body: Option<usize>, e: &Vector3<f64>) -> BodyDirection {
        BodyDirection { body, e: self.frame(body).inverse_vector(e).into() }
    }
}
