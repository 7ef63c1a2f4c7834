//! Mechanism from which the kernels are compiled.

use nalgebra::{Matrix3, Vector3};
use percuss_spatial::{SpatialInertia, Transform};

/// Motion that a joint allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointMotion {
    /// None.
    Fixed,
    /// Rotation about the axis.
    Revolute,
    /// Translation along the axis.
    Prismatic,
    /// Translations in the plane across the axis, and rotation about the axis.
    Planar,
    /// Rotation by a unit quaternion.
    Spherical,
    /// Translation by three positions, then rotation by a unit quaternion.
    Floating,
    /// Floating base: its pose is the reference frame.
    Base,
}

impl JointMotion {
    /// True if component `k` of the joint's velocity is a translation.
    pub fn translates(self, k: usize) -> bool {
        match self {
            Self::Prismatic => true,
            Self::Planar => k < 2,
            Self::Floating | Self::Base => k >= 3,
            Self::Fixed | Self::Revolute | Self::Spherical => false,
        }
    }

    /// Number of positions.
    pub fn positions(self) -> usize {
        match self {
            Self::Fixed | Self::Base => 0,
            Self::Revolute | Self::Prismatic => 1,
            Self::Planar => 3,
            Self::Spherical => 4,
            Self::Floating => 7,
        }
    }
}

/// A position that moves a joint: `multiplier · positions[q] + offset`.
#[derive(Clone, Copy, Debug)]
pub struct JointPosition {
    /// Index of the position.
    pub q: usize,
    /// Factor.
    pub multiplier: f64,
    /// Position of the joint if `positions[q]` is zero, rad or m.
    pub offset: f64,
}

/// One velocity of a joint: `multiplier` times the rate of a coordinate.
#[derive(Clone, Copy, Debug)]
pub struct Velocity {
    /// Index of the coordinate; `None` for a velocity that is always zero.
    pub coordinate: Option<usize>,
    /// Velocity per unit rate of the coordinate.
    pub multiplier: f64,
    /// Armature, kg·m² or kg.
    pub armature: f64,
}

/// A body and the joint to its parent.
#[derive(Clone, Debug)]
pub struct Body {
    /// Parent body, with a smaller index; `None` for the ground.
    pub parent: Option<usize>,
    /// Motion of the joint.
    pub motion: JointMotion,
    /// Unit vector of the axis in the joint frame, for motions with an axis.
    pub axis: Vector3<f64>,
    /// X_pj: joint frame in the parent body.
    pub origin: Transform<f64>,
    /// Inertia about the body's origin.
    pub inertia: SpatialInertia<f64>,
    /// Index of the joint's first position.
    pub q: usize,
    /// Position of the master and the coefficients, for a mimic joint.
    pub mimic: Option<JointPosition>,
    /// Velocities of the joint; none if the joint is locked.
    pub velocities: Vec<Velocity>,
    /// Index of the first velocity among those of all joints of the mechanism; `None` for the floating base.
    pub output: Option<usize>,
    /// True if the parent has no inertia and follows this body freely, so that this body moves as if it floated.
    pub floats: bool,
}

/// One velocity in a cluster.
#[derive(Clone, Copy, Debug)]
pub struct ClusterVelocity {
    /// Index of the body within the cluster.
    pub body: usize,
    /// Index of the coordinate within the cluster.
    pub coordinate: usize,
    /// Velocity per unit rate of the coordinate.
    pub multiplier: f64,
    /// Armature, kg·m² or kg.
    pub armature: f64,
}

/// Coupled bodies, including all bodies between them, with one parent body or the ground.
#[derive(Clone, Debug)]
pub struct Cluster {
    /// Bodies, parents first.
    pub bodies: Vec<usize>,
    /// For each body: index of its parent within the cluster; `None` for a parent outside the cluster.
    pub parents: Vec<Option<usize>>,
    /// Parent body of the cluster; `None` for the ground.
    pub parent: Option<usize>,
    /// Number of coordinates.
    pub coordinates: usize,
    /// Velocities, body by body.
    pub velocities: Vec<ClusterVelocity>,
}

/// Bodies of a mechanism.
#[derive(Clone, Debug)]
pub struct Mechanism {
    /// Bodies, parents before children.
    pub bodies: Vec<Body>,
    /// Number of coordinates.
    pub coordinates: usize,
    /// Clusters of joints that mimic one another.
    pub clusters: Vec<Cluster>,
    /// Characteristic length of the mechanism, m.
    pub characteristic_length: f64,
}

impl Mechanism {
    /// True if no motion of any body has a negative kinetic energy.
    pub fn is_positive(&self) -> bool {
        self.bodies.iter().all(|body| is_positive(&body.inertia))
    }

    /// Indices of the positions that move the bodies.
    pub fn read_positions(&self) -> Vec<usize> {
        let first = |body: &Body| body.mimic.map_or(body.q, |mimic| mimic.q);
        self.bodies.iter().flat_map(|body| first(body)..first(body) + body.motion.positions()).collect()
    }

    /// True for a body without inertia from which a floating subtree begins: contacts on this body have another effective mass.
    pub fn is_massless_root(&self, body: usize) -> bool {
        self.bodies.iter().any(|child| child.floats && child.parent == Some(body))
    }
}

/// Point fixed in a body, or in the root link.
#[derive(Clone, Copy, Debug)]
pub struct BodyPoint {
    /// The body; `None` for the root link.
    pub body: Option<usize>,
    /// Position, m.
    pub at: [f64; 3],
}

/// Direction fixed in a body, or in the root link.
#[derive(Clone, Copy, Debug)]
pub struct BodyDirection {
    /// The body; `None` for the root link.
    pub body: Option<usize>,
    /// Unit vector.
    pub e: [f64; 3],
}

/// Kind of one row or of three rows of A: the component of the relative motion of successor and predecessor that is zero.
#[derive(Clone, Copy, Debug)]
pub enum RowForm {
    /// Velocity of the successor's point, root axes: three rows.
    Point,
    /// Velocity of the successor's point along a direction.
    Along(BodyDirection),
    /// Rate of the cosine between a direction of the predecessor and a direction of the successor, times a length
    /// (m).
    Cosine(BodyDirection, BodyDirection, f64),
    /// Relative angular velocity along the three axes of the predecessor's loop frame, times a length (m): three rows. The axes
    /// of both loop frames.
    Orientation([BodyDirection; 3], [BodyDirection; 3], f64),
    /// Rate of the distance between the two points; the value is the required distance (m).
    Distance(f64),
    /// Row of a relation: factor − slope · argument of each term, with the slope of the curve.
    Relation,
}

/// One entry of the rows of a block: a velocity of a joint of the loop.
#[derive(Clone, Copy, Debug)]
pub struct RowTerm {
    /// Body of the joint.
    pub body: usize,
    /// Index among the velocities of the joint.
    pub component: usize,
    /// +1 or −1 by the side of the loop; for a coupling the coefficient.
    pub factor: f64,
    /// Factor in the argument of the curve of a relation; otherwise 0.
    pub argument: f64,
}

/// Rows of one constraint, in the frames of the bodies.
#[derive(Clone, Debug)]
pub struct RowBlock {
    /// Point of the predecessor; `None` for couplings and held points.
    pub predecessor: Option<BodyPoint>,
    /// Point of the successor.
    pub successor: BodyPoint,
    /// Forms of the rows.
    pub forms: Vec<RowForm>,
    /// Joint velocities in the rows.
    pub terms: Vec<RowTerm>,
    /// Relation of a coupling.
    pub relation: Option<Relation>,
}

/// Relation of joint positions: Σ factor · q = constant + Σ cₖ sᵏ for k = 2, 3, 4, with s = offset + Σ argument · q.
#[derive(Clone, Debug)]
pub struct Relation {
    /// Joints of the relation.
    pub joints: Vec<RelationJoint>,
    /// Constant, rad or m.
    pub constant: f64,
    /// Argument s of the curve if all positions are zero.
    pub offset: f64,
    /// Coefficients c₂, c₃, c₄; zero for a linear relation.
    pub curve: [f64; 3],
    /// Length that converts the residual to metres: 1 for a sum of lengths.
    pub length: f64,
}

/// Joint of a relation.
#[derive(Clone, Copy, Debug)]
pub struct RelationJoint {
    /// Index of the position.
    pub q: usize,
    /// Factor in the sum.
    pub factor: f64,
    /// Factor in the argument of the curve.
    pub argument: f64,
}

/// Mechanism with closed loops or other constraints.
#[derive(Clone, Debug)]
pub struct Linkage {
    /// The bodies.
    pub mechanism: Mechanism,
    /// Rows of the constraints.
    pub blocks: Vec<RowBlock>,
    /// Rank of the rows at a generic configuration.
    pub rank: usize,
    /// Length that scales each coordinate, m: a rate of 1 rad/s counts as this length per second; 1 for translations.
    pub lengths: Vec<f64>,
    /// Smallest length of a rotational coordinate, m.
    pub shortest_length: f64,
    /// Largest number of joints between the ground and a body.
    pub depth: usize,
    /// Threshold of redundancy: a row with a smaller remainder after the elimination, relative to the largest pivot, is redundant.
    pub redundancy_threshold: f64,
    /// Smallest size of a loop, m.
    pub smallest_loop_size: f64,
}

/// True if no motion has a negative kinetic energy, within rounding.
pub(crate) fn is_positive(inertia: &SpatialInertia<f64>) -> bool {
    let h = inertia.first_moment;
    if inertia.mass < 0.0 || (inertia.mass == 0.0 && h.norm() != 0.0) {
        return false;
    }
    // A body without mass may have moments of inertia: a rotor.
    let mass = if inertia.mass > 0.0 { inertia.mass } else { 1.0 };
    let steiner = (Matrix3::identity() * h.norm_squared() - h * h.transpose()) / mass;
    let least = (inertia.rotational - steiner).symmetric_eigenvalues().min();
    least >= -f64::EPSILON * 16.0 * inertia.rotational.norm()
}
