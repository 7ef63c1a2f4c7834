//! Results of a proof, and reasons for none.

use crate::kinematics::contact::ContactError;
use percuss_spatial::Interval;

/// Reason for which no bounds are proved.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoCertificate {
    /// The contact is invalid at the pose.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// A held contact, a lock in a loop, or a coupling along a curve.
    #[error(
        "held contacts, locked joints of loops, and couplings along a curve are not supported by the proof"
    )]
    Unsupported,
    /// The dependent positions are not determined by the independent rows.
    #[error(
        "the loops do not determine all dependent joints at this pose: it is a change point or a dead centre, or a dependent joint is \
         spherical or floating"
    )]
    ChangePoint,
    /// No proof of the assembly.
    #[error(
        "the assembly of the loops is not proved near this pose: it is close to a change point or a dead centre"
    )]
    NotClosed,
    /// The kinetic energy is not proved positive.
    #[error("the kinetic energy of the free motions is not proved positive: a motion without mass")]
    Massless,
    /// The contact moves too little.
    #[error("no motion is proved to close the gap: the contact is immovable, or nearly so")]
    Immovable,
    /// A cone of normals or edges of points.
    #[error(
        "a cone of normals (0 to 90°) and edges of contact points are proved for trees, against the ground, along a fixed normal of the contact link or \
         the world"
    )]
    VariedContact,
    /// A joint of a range.
    #[error(
        "joint \"{joint}\" does not drive the pose by one position; give ranges of driving joints with one position"
    )]
    NoDriver {
        /// The joint.
        joint: String,
    },
    /// Too many ranges of a linkage.
    #[error("{ranges} ranges move closed loops; the proof covers 1 or 2")]
    TooManyRanges {
        /// Number of ranges.
        ranges: usize,
    },
}

/// Proved bounds of m̄ at a pose.
#[derive(Clone, Debug, PartialEq)]
pub struct MassCertificate {
    /// Lower bound of m̄, kg (kg·m² for a moment). It holds without the omitted rows too.
    pub lower: f64,
    /// Upper bound of m̄, kg (kg·m² for a moment).
    pub upper: f64,
    /// Distance from the dependent positions (rad or m, each) within which no other assembly exists; `None` for a tree.
    pub uniqueness: Option<f64>,
    /// Number of rows of the loops, and the number of those that are zero at all positions.
    pub rows: usize,
    /// Number of rows that are zero at all positions: proved to be implied.
    pub implied: usize,
    /// Rows that were omitted without a proof that the others imply them: constraint and largest residual, m or rad. `upper` then assumes
    /// that the loops have the mobility of the pose.
    pub omitted: Vec<(String, f64)>,
}

/// Parameters of a proof over ranges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RangeProof {
    /// Wanted relative distance of the bounds.
    pub tolerance: f64,
    /// Largest number of boxes of each search.
    pub budget: usize,
    /// Relative tolerance t of all masses, moments of inertia and rotor inertias, each by its own factor from 1 − t to 1 + t.
    pub mass_tolerance: f64,
    /// True for the largest m̄ alone: no bounds of the smallest one.
    pub only_largest: bool,
    /// Smallest and largest angle between the normal (for a moment: the axis) and that of the contact, rad; zero for that of the contact alone.
    pub cone: [f64; 2],
    /// Edges eᵢ of the contact points p + Σ xᵢ eᵢ, 0 ≤ xᵢ ≤ 1, in the frame of the contact link, m; zero without an edge.
    pub edges: [[f64; 3]; 2],
    /// True if the edges turn by all angles about a normal of the contact link: the points of a disc.
    pub is_disc: bool,
    /// Largest m̄ that is proved elsewhere, kg; 0 for none. Bounds below it, within the tolerance, are sufficient for the largest m̄. For trees.
    pub known: f64,
}

impl RangeProof {
    /// Accepted ratio of the upper bound of a box and the best value.
    pub(super) fn ratio(self) -> f64 {
        1.0 + self.tolerance
    }

    /// True if the proof covers several points or normals.
    pub(super) fn varies_contact(self) -> bool {
        self.cone[1] > 0.0 || self.edges != [[0.0; 3]; 2]
    }

    /// True if bounds agree within the tolerance.
    pub(super) fn is_met(self, lower: f64, upper: f64) -> bool {
        lower > 0.0 && upper <= lower * self.ratio() * (1.0 + 0.01 * self.tolerance)
    }
}

/// Proved bounds of the smallest and the largest m̄ over ranges.
#[derive(Clone, Debug)]
pub struct ExtremesCertificate {
    /// Smallest m̄; `None` if only the largest one is wanted.
    pub least: Option<ExtremeBracket>,
    /// Largest m̄.
    pub most: ExtremeBracket,
    /// Proof of the branch of the loops; `None` for a tree.
    pub branch: Option<BranchProof>,
    /// Numbers of the proof for an independent check; `None` for linkages, and for contacts or joints without a form there.
    pub tree: Option<CertifiedTree>,
}

impl ExtremesCertificate {
    /// Bounds for all masses within a relative tolerance: the bounds of the model times 1 ± tolerance.
    pub(super) fn with_masses(mut self, tolerance: f64) -> Self {
        for (bracket, factor) in [(self.least.as_mut(), -tolerance), (Some(&mut self.most), tolerance)] {
            if let Some(bracket) = bracket.filter(|_| factor != 0.0) {
                let factor = Interval::point(1.0) + Interval::point(factor);
                bracket.lower = (Interval::point(bracket.lower) * factor).lo();
                bracket.upper = (Interval::point(bracket.upper) * factor).hi();
            }
        }
        self
    }
}

/// Bodies, contact and ranges of a proof as plain numbers. An enclosure is a pair of a lower and an upper bound.
#[derive(Clone, Debug, PartialEq)]
pub struct CertifiedTree {
    /// One row per body, parents first: parent (−1: ground), motion (0 fixed, 1 hinge about z, 2 slider along z), index of the position,
    /// coordinate (−1: none), then pairs: factor and offset of the position, factor and armature of the rate, rotation (9, by rows) and
    /// translation (3) of the joint frame in the parent, mass, first moment (3), moments of inertia (9) in the body's frame.
    pub bodies: Vec<Vec<f64>>,
    /// Body, 1 for a moment, 1 for a normal fixed in the root link; then pairs: point (3), normal (3).
    pub contact: Vec<f64>,
    /// Positions of all joints, rad or m.
    pub positions: Vec<[f64; 2]>,
    /// Index of the position, lower and upper end of each range, rad or m.
    pub ranges: Vec<(usize, f64, f64)>,
}

/// Proved range of an extreme of m̄ over a box.
#[derive(Clone, Debug)]
pub struct ExtremeBracket {
    /// Lower bound of the extreme, kg (kg·m² for a moment); 0 if none was proved.
    pub lower: f64,
    /// Upper bound of the extreme, kg (kg·m² for a moment); infinite if none was proved.
    pub upper: f64,
    /// Positions of the ranges with the best value found; then those of the edges, m, and the angles ψ about the normal and θ from the normal
    /// of a cone, rad.
    pub positions: Vec<f64>,
    /// True if the bounds agree within the tolerance.
    pub is_proved: bool,
    /// Number of evaluated boxes.
    pub boxes: usize,
    /// Division of the box, in preorder: −1 for a box whose bound is within `lower` and `upper`, otherwise the index of the range that is
    /// halved at its middle, followed by its lower half and its upper half.
    pub divisions: Vec<i32>,
}

/// Proof that a linkage is on one branch over its ranges.
#[derive(Clone, Debug, PartialEq)]
pub struct BranchProof {
    /// Number of boxes with a proved assembly.
    pub pieces: usize,
    /// True if neighbouring boxes have the same assembly, and the pose of the question is one of them.
    pub is_one_branch: bool,
    /// Omitted rows without a proof that they are implied, with their largest residual, m or rad.
    pub omitted: Vec<(String, f64)>,
}
