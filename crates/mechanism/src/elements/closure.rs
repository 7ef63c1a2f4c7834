//! Loop closures: joints outside the spanning tree.

use crate::LinkId;
use percuss_spatial::{Transform, Vector3};

/// Index of a closure in its mechanism, in the order the closures were given.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ClosureId(pub(crate) u32);

impl ClosureId {
    /// Position in [`Mechanism::closures`](crate::Mechanism::closures).
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// Kinds of closure. A closure constrains the loop frame of the successor relative to that of the predecessor.
/// p is the origin of the successor's frame in the predecessor's frame, a the axis (same components in both
/// frames), and b the second axis (in the successor's frame):
///
/// | kind        | imposes                                        | rows |
/// |-------------|------------------------------------------------|------|
/// | fixed       | the frames coincide                            | 6    |
/// | revolute    | p = 0, the axes a parallel, same sense                  | 5    |
/// | prismatic   | p along a, axes of the frames parallel         | 5    |
/// | cylindrical | p along a, the axes a parallel, same sense              | 4    |
/// | universal   | p = 0, a (predecessor) normal to b (successor) | 4    |
/// | planar      | p normal to a, the axes a parallel, same sense          | 3    |
/// | spherical   | p = 0                                          | 3    |
/// | distance    | the length of p                                | 1    |
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ClosureKind {
    /// The frames coincide.
    Fixed,
    /// Revolute joint about the axis; also for URDF's `continuous`.
    Revolute,
    /// Prismatic joint along the axis.
    Prismatic,
    /// Cylindrical joint: translation along and rotation about the axis.
    Cylindrical,
    /// Universal joint with pins along the two axes.
    Universal,
    /// Planar joint: translation in the plane normal to the axis, rotation about the axis.
    Planar,
    /// Spherical joint.
    Spherical,
    /// Massless rod with spherical joints at both ends.
    Distance,
}

impl ClosureKind {
    /// All kinds, for exhaustive tests.
    pub const ALL: [ClosureKind; 8] = [
        ClosureKind::Fixed,
        ClosureKind::Revolute,
        ClosureKind::Prismatic,
        ClosureKind::Cylindrical,
        ClosureKind::Universal,
        ClosureKind::Planar,
        ClosureKind::Spherical,
        ClosureKind::Distance,
    ];

    /// Number of constraint rows in A.
    pub fn rows(self) -> usize {
        match self {
            ClosureKind::Fixed => 6,
            ClosureKind::Revolute | ClosureKind::Prismatic => 5,
            ClosureKind::Cylindrical | ClosureKind::Universal => 4,
            ClosureKind::Planar | ClosureKind::Spherical => 3,
            ClosureKind::Distance => 1,
        }
    }

    /// True if the kind has an axis.
    pub fn has_axis(self) -> bool {
        match self {
            ClosureKind::Fixed | ClosureKind::Spherical | ClosureKind::Distance => false,
            ClosureKind::Revolute
            | ClosureKind::Prismatic
            | ClosureKind::Cylindrical
            | ClosureKind::Universal
            | ClosureKind::Planar => true,
        }
    }

    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            ClosureKind::Fixed => "fixed",
            ClosureKind::Revolute => "revolute",
            ClosureKind::Prismatic => "prismatic",
            ClosureKind::Cylindrical => "cylindrical",
            ClosureKind::Universal => "universal",
            ClosureKind::Planar => "planar",
            ClosureKind::Spherical => "spherical",
            ClosureKind::Distance => "distance",
        }
    }
}

/// Loop frame: attachment of a closure to a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoopFrame {
    /// Link; `None` is the world, the root link's frame at the reference pose.
    pub link: Option<LinkId>,
    /// X_lf: the loop frame in the link.
    pub frame: Transform<f64>,
}

/// Joint that closes a loop.
#[derive(Clone, Debug)]
pub struct Closure {
    pub(crate) name: String,
    pub(crate) kind: ClosureKind,
    pub(crate) predecessor: LoopFrame,
    pub(crate) successor: LoopFrame,
    pub(crate) axis: Vector3<f64>,
    pub(crate) axis2: Vector3<f64>,
    pub(crate) distance: Option<f64>,
}

impl Closure {
    /// Name, unique among closures and couplings.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Kind.
    pub fn kind(&self) -> ClosureKind {
        self.kind
    }

    /// Loop frame on the predecessor.
    pub fn predecessor(&self) -> &LoopFrame {
        &self.predecessor
    }

    /// Loop frame on the successor.
    pub fn successor(&self) -> &LoopFrame {
        &self.successor
    }

    /// Unit axis; no meaning if the kind has no axis.
    pub fn axis(&self) -> &Vector3<f64> {
        &self.axis
    }

    /// Unit axis of the successor's pin of a universal closure, in the successor's loop frame.
    pub fn axis2(&self) -> &Vector3<f64> {
        &self.axis2
    }

    /// Declared length of a distance closure, m; `None` takes the distance with all joints at 0.
    pub fn distance(&self) -> Option<f64> {
        self.distance
    }
}
