//! What closes a loop: a joint that the tree leaves out, or a ratio between rates.

use crate::{JointId, LinkId};
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

/// The kinds of closure. Each imposes exactly what its row states between two loop frames, the predecessor's and the
/// successor's: with p the successor's origin in the predecessor's frame, a the axis (the same components in both
/// frames) and b the second axis (in the successor's frame),
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
    /// A hinge about the axis. URDF's `continuous` is one.
    Revolute,
    /// A slider along the axis.
    Prismatic,
    /// A slider along the axis that turns about it.
    Cylindrical,
    /// Hooke's joint: pins along the two axes.
    Universal,
    /// Sliding in the plane normal to the axis, turning about it.
    Planar,
    /// A ball joint.
    Spherical,
    /// A massless rod between ball joints.
    Distance,
}

impl ClosureKind {
    /// Every kind, for tests that must skip none.
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

    /// How many rows of A it takes.
    pub fn rows(self) -> usize {
        match self {
            ClosureKind::Fixed => 6,
            ClosureKind::Revolute | ClosureKind::Prismatic => 5,
            ClosureKind::Cylindrical | ClosureKind::Universal => 4,
            ClosureKind::Planar | ClosureKind::Spherical => 3,
            ClosureKind::Distance => 1,
        }
    }

    /// Whether it has an axis.
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

    /// Its name in a file.
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

/// A loop frame: where a closure is attached to a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoopFrame {
    /// The link; none is the world, which is the root link's frame at its reference pose.
    pub link: Option<LinkId>,
    /// X_lf: the loop frame in the link.
    pub frame: Transform<f64>,
}

/// A joint that closes a loop.
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
    /// Its name, unique among closures and couplings.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its kind.
    pub fn kind(&self) -> ClosureKind {
        self.kind
    }

    /// Where it holds the predecessor.
    pub fn predecessor(&self) -> &LoopFrame {
        &self.predecessor
    }

    /// Where it holds the successor.
    pub fn successor(&self) -> &LoopFrame {
        &self.successor
    }

    /// The unit axis; meaningless where the kind has none.
    pub fn axis(&self) -> &Vector3<f64> {
        &self.axis
    }

    /// The successor's unit pin of a universal closure, in its loop frame.
    pub fn axis2(&self) -> &Vector3<f64> {
        &self.axis2
    }

    /// The declared length of a distance closure, m; none: the distance with all joints at 0.
    pub fn distance(&self) -> Option<f64> {
        self.distance
    }
}

/// A ratio between rates: the successor's rate is `ratio` times the predecessor's, each summed over the joints from
/// the nearest common ancestor; so are their positions, with no offset.
#[derive(Clone, Debug)]
pub struct Coupling {
    pub(crate) name: String,
    pub(crate) predecessor: LinkId,
    pub(crate) successor: LinkId,
    pub(crate) ratio: f64,
    pub(crate) terms: Vec<(JointId, f64)>,
}

impl Coupling {
    /// Its name, unique among closures and couplings.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The link whose rate is given.
    pub fn predecessor(&self) -> LinkId {
        self.predecessor
    }

    /// The link whose rate follows.
    pub fn successor(&self) -> LinkId {
        self.successor
    }

    /// Successor's rate over predecessor's.
    pub fn ratio(&self) -> f64 {
        self.ratio
    }

    /// The row it imposes: Σ factor · q = 0 over these joints, +1 on the successor's path and −ratio on the other.
    pub fn terms(&self) -> &[(JointId, f64)] {
        &self.terms
    }
}
