//! Question and answer of route C.

use nalgebra::Vector3;
use percuss_mechanism::{JointId, LinkId, Mechanism};

/// Contact that persists through the impact: a link point fixed to the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held {
    /// Link.
    pub link: LinkId,
    /// Point in the link frame, m.
    pub point: Vector3<f64>,
    /// Constrained direction in the root link's axes; `None` constrains all three.
    pub normal: Option<Vector3<f64>>,
}

/// Contact on a mechanism in one position.
#[derive(Clone, Debug)]
pub struct Question<'a> {
    /// The mechanism.
    pub mechanism: &'a Mechanism,
    /// True if the root link moves freely (at its reference pose, where its axes are those of the world); false
    /// if it is fixed to the ground.
    pub floating_base: bool,
    /// Locked joints.
    pub locked: Vec<JointId>,
    /// Held contacts.
    pub held: Vec<Held>,
    /// Armatures that replace those of the mechanism: one value per joint, or one per velocity.
    pub armature: Vec<(JointId, Vec<f64>)>,
    /// Positions of all joints, with the layout of [`JointKind`](percuss_mechanism::JointKind); mimics filled
    /// in, loops closed ([`close`](super::close)).
    pub positions: Vec<Vec<f64>>,
    /// Contact link.
    pub on: LinkId,
    /// Link on the other side; `None` is the ground.
    pub against: Option<LinkId>,
    /// Contact point in the frame of the contact link, m.
    pub point: Vector3<f64>,
    /// Unit normal pointing out of the contact link, in the root link's axes.
    pub normal: Vector3<f64>,
    /// True for a moment about the axis `normal` instead of a force at the point: j q̇ = n·(ω_on − ω_against), m̄ in kg·m².
    pub is_moment: bool,
    /// Ratio to the largest singular value up to which a constraint counts as dependent. `None`: the larger of
    /// 1e-10 and 10 δ / size, with the loop [`residual`](super::residual) δ and the characteristic length.
    pub threshold: Option<f64>,
}

impl<'a> Question<'a> {
    /// Contact on a link of a mechanism with a fixed base and no locks, against the ground.
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
            is_moment: false,
            threshold: None,
        }
    }
}

/// Effective mass, or the reason why there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// m̄ in kg.
    Finite(f64),
    /// No admissible motion closes the gap.
    Immovable,
    /// A motion without mass closes the gap.
    Massless,
}

impl Outcome {
    /// m̄ in kg if finite and not zero.
    pub fn finite(self) -> Option<f64> {
        match self {
            Outcome::Finite(mass) => Some(mass),
            Outcome::Immovable | Outcome::Massless => None,
        }
    }
}

/// Outcome, and quantities of the velocity response v*.
#[derive(Clone, Debug)]
pub struct Answer {
    /// Effective mass.
    pub outcome: Outcome,
    /// Dimension of the admissible motions.
    pub degrees_of_freedom: usize,
    /// Number of redundant rows of mimics, locks, closures, couplings and holds. (The rows of the tree are
    /// always independent.)
    pub redundant_constraints: usize,
    /// Singular values of these rows on the motions of the tree, relative to the largest, in descending order.
    pub singular_values: Vec<f64>,
    /// Relative threshold up to which singular values count as zero.
    pub threshold: f64,
    /// vᵀ I v of every link at v*, kg; the sum with [`rotors`](Self::rotors) is m̄. Empty unless finite.
    pub links: Vec<f64>,
    /// a q̇² of every joint at v*, kg. Empty unless finite.
    pub rotors: Vec<f64>,
}
