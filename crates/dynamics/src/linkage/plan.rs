//! What a mechanism of few freedoms compiles to: bodies whose frames have the joint's axis as z, the rows that close its loops,
//! and the order in which what depends is eliminated.

use super::room::Layout;
use nalgebra::Vector3;
use percuss_spatial::Transform;

/// A position that moves a joint: `multiplier · positions[q] + offset`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Position {
    pub q: usize,
    pub multiplier: f64,
    pub offset: f64,
}

/// Motion of a body relative to its parent.
#[derive(Clone, Copy, Debug)]
pub(super) enum Motion {
    /// It does not.
    Fixed,
    /// It turns about z.
    Turn(Position),
    /// It slides along z.
    Slide(Position),
    /// Rotation by the quaternion that starts at a position index.
    Ball(usize),
    /// It is a free base, seen from itself.
    Free,
}

/// One velocity of a body's joint.
#[derive(Clone, Copy, Debug)]
pub(super) struct Velocity {
    /// Column of A: pivot columns in order, then the independent ones.
    pub column: usize,
    /// The velocity at a unit of that coordinate, which is measured in metres.
    pub factor: f64,
    pub armature: f64,
}

/// A body and its joint.
#[derive(Clone, Debug)]
pub(super) struct Moving {
    pub parent: Option<usize>,
    /// Frame of the joint in the parent's frame.
    pub rotation: [[f64; 3]; 3],
    pub translation: [f64; 3],
    pub motion: Motion,
    pub velocities: Vec<Velocity>,
    /// Mass, first moment, moments and products of inertia (xx, xy, xz, yy, yz, zz); none where all are zero.
    pub inertia: Option<[f64; 10]>,
    /// For each independent coordinate: whether it moves the body.
    pub moved: Vec<bool>,
    /// X_bo: the frame taken here (o) in the body's own.
    pub frame: Transform<f64>,
    /// How far its origin is from the farthest joint that carries it, at most, travels of slides left out, m.
    pub reach: f64,
}

/// A point fixed in a body, or in the root.
#[derive(Clone, Copy, Debug)]
pub(super) struct BodyPoint {
    pub body: Option<usize>,
    pub at: [f64; 3],
}

/// A direction fixed in a body, or in the root.
#[derive(Clone, Copy, Debug)]
pub(super) struct BodyDirection {
    pub body: Option<usize>,
    pub e: [f64; 3],
}

/// One row or three rows, by the power on the relative motion.
#[derive(Clone, Copy, Debug)]
pub(super) enum Form {
    /// The velocity of the successor's point, root axes: three rows.
    Point,
    /// That velocity along a direction.
    Along(BodyDirection),
    /// The rate of the cosine between a direction of the predecessor and one of the successor, times a length (m).
    Cosine(BodyDirection, BodyDirection, f64),
    /// The rate of the distance between the two points, which is to be so many metres.
    Distance(f64),
    /// The factors of the terms alone.
    Constant,
}

/// A velocity that rows bind.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term {
    pub body: usize,
    /// Which velocity of the body's joint.
    pub component: usize,
    pub slides: bool,
    pub column: usize,
    pub factor: f64,
    /// True for the first term of its column in the block.
    pub is_first: bool,
}

/// Rows that bind the same velocities.
#[derive(Clone, Debug)]
pub(super) struct Block {
    /// Target of the successor's point; `None` without a closure.
    pub predecessor: Option<BodyPoint>,
    pub successor: BodyPoint,
    /// The forms, with the first row that each fills; none where it adds nothing.
    pub forms: Vec<(Form, [Option<usize>; 3])>,
    pub terms: Vec<Term>,
}

/// Pivot of A on the diagonal, with the nonzero rows below it and the nonzero columns to its right.
#[derive(Clone, Debug, Default)]
pub(super) struct Pivot {
    pub rows: Vec<usize>,
    pub columns: Vec<usize>,
}

/// A mechanism of few freedoms.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    pub bodies: Vec<Moving>,
    pub blocks: Vec<Block>,
    pub pivots: Vec<Pivot>,
    /// Entries of A, row by row, that have no term, but are filled in when it is eliminated.
    pub filled_in: Vec<usize>,
    /// For each coordinate and each independent one: true if the rate can be nonzero.
    pub follows: Vec<bool>,
    /// Largest pivot at the pose of compilation.
    pub scale: f64,
    /// The least length of a turn, m.
    pub length: f64,
    /// Twice the energy (kg) of any motion is below it, times the square of all its rates added up (m/s): armatures, masses at
    /// their reach, moments of inertia.
    pub weight: f64,
    /// By how many roundings the entries of A are off, by the depth of the tree alone.
    pub roundings: f64,
    pub columns: usize,
    pub freedoms: usize,
    pub layout: Layout,
    /// Origin of positions, in the root frame (m): near the linkage, because distant positions have a larger rounding.
    pub centre: Vector3<f64>,
}

impl Plan {
    /// A point of a body's own frame, or of the root's.
    pub fn point(&self, body: Option<usize>, at: &Vector3<f64>) -> BodyPoint {
        let at = body.map_or_else(|| at - self.centre, |b| self.bodies[b].frame.inverse_point(at));
        BodyPoint { body, at: at.into() }
    }

    /// A direction of a body's own frame, or of the root's.
    pub fn direction(&self, body: Option<usize>, e: &Vector3<f64>) -> BodyDirection {
        let e = body.map_or(*e, |b| self.bodies[b].frame.inverse_vector(e));
        BodyDirection { body, e: e.into() }
    }
}
