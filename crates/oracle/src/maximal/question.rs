//! What is asked of route C, and what it answers.

use nalgebra::Vector3;
use percuss_mechanism::{JointId, LinkId, Mechanism};

/// A contact that lasts through the impact: a point of a link held to the ground.
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
    /// Whether the root link moves freely (it is at its reference pose, where the world's axes are its own);
    /// else the ground holds it.
    pub floating_base: bool,
    /// Joints that are held still.
    pub locked: Vec<JointId>,
    /// Contacts that hold.
    pub held: Vec<Held>,
    /// Armatures that replace those of the mechanism: one value for all velocities of the joint, or one each.
    pub armature: Vec<(JointId, Vec<f64>)>,
    /// One position a joint, laid out as [`JointKind`](percuss_mechanism::JointKind) says; mimics filled in, loops
    /// closed ([`close`](super::close)).
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
    /// the loops close badly, 10 δ / size with the [`residual`](super::residual) δ and the characteristic length.
    pub threshold: Option<f64>,
}

impl<'a> Question<'a> {
    /// A contact on a link of a mechanism with its base held, nothing locked, against the ground.
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

/// The outcome and what follows from the velocity response v*.
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
