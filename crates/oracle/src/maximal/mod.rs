//! Route C: the effective mass in maximal coordinates.
//!
//! Every link has six velocities of its own (world axes, the linear three at its centre of mass), every joint is
//! so many constraint rows, nothing is merged or eliminated by topology. The matrices are large and plain, and no
//! formula is shared with the recursions they judge.

mod close;
mod joints;
mod loops;
mod minimum;
mod pose;
mod residual;
mod row;
mod rows;

pub use close::{NotClosed, close, close_as_far_as_possible, moved};
use nalgebra::Vector3;
use percuss_mechanism::{JointId, LinkId, Mechanism};
pub use pose::poses;
pub use residual::{residual, residuals};

/// A contact that lasts through the blow: a point of a link held to the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// The link that is held.
    pub link: LinkId,
    /// The held point in its frame, m.
    pub point: Vector3<f64>,
    /// The direction in which it is held, in the root link's axes; none: in all three.
    pub normal: Option<Vector3<f64>>,
}

/// A contact on a mechanism in one position.
#[derive(Clone, Debug)]
pub struct Question<'a> {
    /// The mechanism.
    pub mechanism: &'a Mechanism,
    /// Whether the root link flies freely (it stands at its reference pose, where the world's axes are its own);
    /// else the ground holds it.
    pub floating_base: bool,
    /// Joints that are held still.
    pub locked: Vec<JointId>,
    /// Contacts that hold.
    pub held: Vec<Held>,
    /// Armatures that replace those of the mechanism: one value for all velocities of the joint, or one each.
    pub armature: Vec<(JointId, Vec<f64>)>,
    /// One position a joint, laid out as [`JointKind`](percuss_mechanism::JointKind) says; mimics filled in, loops
    /// closed ([`close`]).
    pub positions: Vec<Vec<f64>>,
    /// The struck link.
    pub on: LinkId,
    /// The link on the other side; `None` is the ground.
    pub against: Option<LinkId>,
    /// The struck point in the struck link's frame, m.
    pub point: Vector3<f64>,
    /// Unit normal out of the struck link, in the root link's axes.
    pub normal: Vector3<f64>,
    /// The part of the largest singular value at which a constraint counts as dependent. None: 1e-10, or more where
    /// the loops close badly, 10 δ / size with the [`residual`] δ and the characteristic length.
    pub threshold: Option<f64>,
}

impl<'a> Question<'a> {
    /// A strike on a link of a mechanism with its base held, nothing locked, against the ground.
    pub fn new(
        mechanism: &'a Mechanism,
        positions: Vec<Vec<f64>>,
        on: LinkId,
        point: Vector3<f64>,
        normal: Vector3<f64>,
    ) -> Self {
        Self {
            mechanism,
            floating_base: false,
            locked: Vec::new(),
            held: Vec::new(),
            armature: Vec::new(),
            positions,
            on,
            against: None,
            point,
            normal,
            threshold: None,
        }
    }
}

/// The effective mass, or why there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// m̄ in kg.
    Finite(f64),
    /// No admissible motion closes the gap.
    Immovable,
    /// The gap can be closed without moving any mass.
    Massless,
}

impl Outcome {
    /// m̄ in kg, where it is finite and not zero.
    pub fn finite(self) -> Option<f64> {
        match self {
            Outcome::Finite(mass) => Some(mass),
            Outcome::Immovable | Outcome::Massless => None,
        }
    }
}

/// The outcome and what the strike v* shows.
#[derive(Clone, Debug)]
pub struct Answer {
    /// The effective mass.
    pub outcome: Outcome,
    /// Dimension of the admissible motions.
    pub degrees_of_freedom: usize,
    /// Constraint rows beyond their rank: those of mimics, locks, closures, couplings and holds, which may repeat
    /// one another. (Those of the tree never do.)
    pub redundant_constraints: usize,
    /// Singular values of these rows on the motions that the tree allows, as parts of the largest, falling.
    pub singular_values: Vec<f64>,
    /// Up to which part of the largest they counted as zero.
    pub threshold: f64,
    /// vᵀ I v of every link at v*, kg: together with [`rotors`](Self::rotors) they sum to m̄. Empty unless finite.
    pub links: Vec<f64>,
    /// a q̇² of every joint at v*, kg. Empty unless finite.
    pub rotors: Vec<f64>,
}

/// The effective mass: m̄ = min { vᵀMv : Av = 0, jv = 1 } in maximal coordinates.
///
/// See [`solve`], of which this is the outcome.
pub fn effective_mass(question: &Question) -> Outcome {
    solve(question).outcome
}

/// Solves (D) by a null-space method, with M = WᵀW written down body by body and never formed.
///
/// 1. Angular velocities are multiplied by the longest arm and the rows of A made unit vectors.
/// 2. Z, an orthonormal basis of ker A, in two steps: the kernel of the joints' rows, which are independent by
///    construction, from a QR; within it the kernel of all other rows from a singular value decomposition, whose
///    small values, up to [`threshold`](Question::threshold), count as zero.
/// 3. `Immovable` where |jZ| ≤ 1e-10 |j|.
/// 4. A reflection of the columns of Z leaves the closing speed to the first; the others minimise |W Z z|² by
///    Householder QR with rows and columns pivoted, which is stable row by row: a needle on a heavy base keeps its
///    digits (Cox and Higham 1998).
/// 5. `Massless` where |W v*| is below 1e-11 of max|Wᵢ| |v*|, that is m̄ below 1e-22 of the largest mass.
///
/// Cost: O((6 links)³); 60 links take a fraction of a second in an optimised build.
///
/// # Panics
/// Where positions or armatures do not fit the joints, an id is of another mechanism, or the loops are open by more
/// than 1e-3 of the size and no threshold is given.
pub fn solve(question: &Question) -> Answer {
    minimum::minimum(&rows::assemble(question))
}
