//! Route C: the effective mass in maximal coordinates.
//!
//! Every link has six velocities of its own (world axes, the linear three at its centre of mass), every joint is
//! so many constraint rows, nothing is merged or eliminated by topology. The matrices are large and plain, and no
//! formula is shared with the recursions they judge.

mod minimum;
mod pose;
mod rows;

use nalgebra::Vector3;
use percuss_mechanism::{JointId, LinkId, Mechanism};
pub use pose::poses;

/// A contact on a mechanism in one position.
#[derive(Clone, Debug)]
pub struct Question<'a> {
    /// The mechanism.
    pub mechanism: &'a Mechanism,
    /// Whether the root link flies freely; else the ground holds it.
    pub floating_base: bool,
    /// Joints that are held still.
    pub locked: Vec<JointId>,
    /// Armatures that replace those of the mechanism: one value for all velocities of the joint, or one each.
    pub armature: Vec<(JointId, Vec<f64>)>,
    /// One position a joint, laid out as [`JointKind`](percuss_mechanism::JointKind) says; mimics filled in.
    pub positions: Vec<Vec<f64>>,
    /// The struck link.
    pub on: LinkId,
    /// The link on the other side; `None` is the ground.
    pub against: Option<LinkId>,
    /// The struck point in the struck link's frame, m.
    pub point: Vector3<f64>,
    /// Unit normal out of the struck link, in the root link's axes.
    pub normal: Vector3<f64>,
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
            armature: Vec::new(),
            positions,
            on,
            against: None,
            point,
            normal,
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
    /// Constraint rows beyond their rank.
    pub redundant_constraints: usize,
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
/// 2. Z, an orthonormal basis of ker A, from a column-pivoted QR of Aᵀ.
/// 3. `Immovable` where |jZ| ≤ 1e-10 |j|.
/// 4. A reflection of the columns of Z leaves the closing speed to the first; the others minimise |W Z z|² by
///    Householder QR with rows and columns pivoted, which is stable row by row: a needle on a heavy base keeps its
///    digits (Cox and Higham 1998).
/// 5. `Massless` where |W v*| is below 1e-11 of max|Wᵢ| |v*|, that is m̄ below 1e-22 of the largest mass.
///
/// Cost: O((6 links)³); 60 links take a fraction of a second in an optimised build.
///
/// # Panics
/// Where positions or armatures do not fit the joints, or an id is of another mechanism.
pub fn solve(question: &Question) -> Answer {
    minimum::minimum(&rows::assemble(question))
}
