//! Description of the function to generate.

use nalgebra::Vector3;
use percuss_dynamics::{Contact, LowestPoint, Pose, System};
use percuss_mechanism::{JointId, LinkId};

/// Held point of a link.
#[derive(Clone, Copy, Debug)]
pub struct HeldPoint {
    /// The link.
    pub link: LinkId,
    /// The point, m, link frame.
    pub point: Vector3<f64>,
    /// Held direction in root axes; `None` holds all three directions.
    pub normal: Option<Vector3<f64>>,
}

/// Language of the generated code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Language {
    /// C99, also valid C++.
    #[default]
    C,
    /// Rust without the standard library.
    Rust,
}

/// Additional functions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Additions {
    /// Velocities of the joints at unit closing speed.
    pub velocity: bool,
    /// Derivatives of m̄ along the independent coordinates.
    pub gradient: bool,
    /// The matrix Φ = J M⁻¹ Jᵀ of the contact link.
    pub mobility: bool,
    /// Many configurations in one call.
    pub batch: bool,
    /// Newton iteration that closes the loops.
    pub close: bool,
}

/// Function to generate.
#[derive(Clone, Debug)]
pub struct Request {
    /// The mechanism under its conditions.
    pub system: System,
    /// Design pose: configuration at which the independent rows are chosen.
    pub pose: Pose,
    /// The contact; its point is in the frame of the contact link.
    pub contact: Contact,
    /// Wheel of a contact patch: the contact point is then its lowest point at every configuration.
    pub wheel: Option<LowestPoint>,
    /// Mass of a free body on the other side, kg.
    pub other_mass: Option<f64>,
    /// Replaced armatures: one value, or one value per velocity.
    pub armatures: Vec<(JointId, Vec<f64>)>,
    /// Held points.
    pub holds: Vec<HeldPoint>,
    /// Prefix of all names in the code: a C identifier.
    pub name: String,
    /// Lines about the origin of the model, for the comment at the top.
    pub origin: Vec<String>,
    /// SHA-256 of the model file, in hexadecimal.
    pub model_hash: String,
    /// Language.
    pub language: Language,
    /// Additional functions.
    pub additions: Additions,
}

impl Request {
    /// Armature of every velocity of a joint.
    pub(crate) fn armature_of(&self, joint: JointId) -> Vec<f64> {
        let joint_data = self.system.mechanism().joint(joint);
        let dofs = joint_data.kind().dofs();
        match self.armatures.iter().find(|(id, _)| *id == joint) {
            Some((_, values)) if values.len() == 1 => vec![values[0]; dofs],
            Some((_, values)) => values.clone(),
            None => joint_data.armature().to_vec(),
        }
    }

    /// Contact at a pose.
    pub(crate) fn contact_at(&self, pose: &Pose) -> Contact {
        self.wheel.map_or(self.contact, |wheel| wheel.contact_at(pose, &self.contact))
    }

    /// Characteristic length, m.
    pub(crate) fn scale(&self) -> f64 {
        self.system.mechanism().characteristic_length()
    }
}
