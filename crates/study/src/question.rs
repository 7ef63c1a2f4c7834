//! The question: a contact of a model, by names. The same words as the flags of `percuss mass`.

use crate::quantity::{QuantityError, parse_list, position_dimension};
use nalgebra::Vector3;
use percuss_contact::ContactError;
use percuss_contact::exports::ExportError;
use percuss_dynamics::{
    AssemblyError, Base, Conditions, ConditionsError, Configuration, ConfigurationError, Contact, Direction,
    Frame, Pose, StrikeError, System,
};
use percuss_mechanism::{LinkId, Mechanism, UnknownName};
use std::sync::Arc;

/// Where the normal of a question points.
#[derive(Clone, Debug, PartialEq)]
pub enum Normal {
    /// Along a vector in the normal's frame.
    Along([f64; 3]),
    /// From the contact point towards a point (m) of a link, in that link's frame.
    Toward(String, [f64; 3]),
}

/// A held contact: a point (m, link's frame) of a link that stays where it is, along a normal (world axes, out of the
/// link) or in all directions.
#[derive(Clone, Debug, PartialEq)]
pub struct Hold {
    /// The link.
    pub link: String,
    /// The point, m.
    pub point: [f64; 3],
    /// The normal; none holds three directions.
    pub normal: Option<[f64; 3]>,
}

/// The classical estimate asked for: the mass of some links, moved with a point of the first.
#[derive(Clone, Debug, PartialEq)]
pub struct EstimateQuestion {
    /// The links whose mass it takes.
    pub links: Vec<String>,
    /// Point A in the first link's frame, m.
    pub point: [f64; 3],
    /// Takes the component of A's velocity along this direction (world axes); none: its full speed.
    pub direction: Option<[f64; 3]>,
}

/// A contact of a model.
#[derive(Clone, Debug, PartialEq)]
pub struct MassQuestion {
    /// The struck link.
    pub link: String,
    /// The contact point, m, in `frame`.
    pub point: [f64; 3],
    /// The normal, out of the struck link.
    pub normal: Normal,
    /// In which frame `point` is given.
    pub frame: Frame,
    /// In which frame a normal along a vector is given.
    pub normal_frame: Frame,
    /// The other link; none: the ground.
    pub against: Option<String>,
    /// Mass of a free body on the other side, kg.
    pub against_mass: Option<f64>,
    /// Driving joints and what they are set to, as typed: numbers between commas, units allowed.
    pub set: Vec<(String, String)>,
    /// Where to look for joints that follow from loops, as typed.
    pub guess: Vec<(String, String)>,
    /// Joints that are held.
    pub lock: Vec<String>,
    /// Contacts that are held.
    pub hold: Vec<Hold>,
    /// Joints whose armature is replaced: one value, or one for each velocity.
    pub armature: Vec<(String, Vec<f64>)>,
    /// How the root stands.
    pub base: Base,
    /// The estimate to set beside the answer.
    pub estimate: Option<EstimateQuestion>,
}

/// Why a question has no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// A name that nothing bears.
    #[error(transparent)]
    UnknownName(#[from] UnknownName),
    /// A position that cannot be set.
    #[error(transparent)]
    Configuration(#[from] ConfigurationError),
    /// A lock, a held contact or an armature that does not fit.
    #[error(transparent)]
    Conditions(#[from] ConditionsError),
    /// Loops that do not close, or not there.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
    /// A contact that means nothing, or an impossible mass matrix.
    #[error(transparent)]
    Strike(#[from] StrikeError),
    /// A number that is none.
    #[error("--{flag} {joint}: {source}")]
    Number {
        /// `set` or `guess`.
        flag: &'static str,
        /// The joint.
        joint: String,
        /// What is wrong.
        source: QuantityError,
    },
    /// The other body's mass is no mass.
    #[error("the other body's mass is {mass:e} kg; a finite number above 0 is wanted (1e-100 at least)")]
    OtherMass {
        /// What was given.
        mass: f64,
    },
    /// A link that is named twice in the estimate.
    #[error("the estimate names link \"{link}\" twice; its mass counts once")]
    EstimateTwice {
        /// The link.
        link: String,
    },
    /// A point that is nowhere.
    #[error("the estimate's point has a component {value:e}; a finite number of at most 1e100 is wanted")]
    EstimatePoint {
        /// The component.
        value: f64,
    },
    /// A direction without length.
    #[error("the estimate's direction has length {length:e}; at least 1e-9 is wanted")]
    EstimateDirection {
        /// Its length.
        length: f64,
    },
    /// A restitution, a stiffness or a speed out of range, or a restitution that the law does not reach.
    #[error(transparent)]
    Damping(#[from] ContactError),
    /// A simulator that cannot have the contact.
    #[error(transparent)]
    Export(Box<ExportError>),
    /// A safe speed against something else than a person.
    #[error("the other side is the person: leave --against and --against-mass out")]
    PersonIsTheOther,
    /// A robot without mass where it strikes.
    #[error(
        "the contact is massless: any speed is as good as none; the load, if there is one, is given by --load"
    )]
    NoMass,
    /// A contact that nothing damps.
    #[error("the contact is {status}: no damper gives it a restitution")]
    NoDamper {
        /// `immovable` or `massless`.
        status: &'static str,
    },
    /// What is swept does not move, or is none of the things that can be swept.
    #[error("--vary {what}: {why}")]
    Vary {
        /// What was to vary.
        what: String,
        /// What is wrong.
        why: String,
    },
}

impl StudyError {
    /// Whether the question was fine and yet has no answer (exit code 1, not 2).
    pub fn is_no_answer(&self) -> bool {
        match self {
            StudyError::NoDamper { .. } | StudyError::NoMass => true,
            StudyError::Strike(error) => matches!(error, StrikeError::Route(_)),
            StudyError::Assembly(error) => !error.is_bad_input(),
            _ => false,
        }
    }
}

impl MassQuestion {
    /// The mechanism under the question's conditions.
    pub(crate) fn system(&self, mechanism: &Arc<Mechanism>) -> Result<System, StudyError> {
        let mut conditions = Conditions::new().base(self.base);
        for joint in &self.lock {
            conditions = conditions.lock(joint);
        }
        for (joint, values) in &self.armature {
            conditions = conditions.armature(joint, values.clone());
        }
        for hold in &self.hold {
            conditions = conditions.hold(&hold.link, hold.point, hold.normal.map(Vector3::from));
        }
        if let Some(mass) = self.against_mass.filter(|m| !(m.is_finite() && *m > 1e-100)) {
            return Err(StudyError::OtherMass { mass });
        }
        Ok(System::new(Arc::clone(mechanism), &conditions)?)
    }

    /// Where the joints are wanted.
    pub(crate) fn configuration(&self, mechanism: &Arc<Mechanism>) -> Result<Configuration, StudyError> {
        let mut configuration = Configuration::zero(mechanism);
        let values = |flag: &'static str, joint: &String, text: &String| {
            let kind = mechanism.joint(mechanism.find_joint(joint)?).kind();
            parse_list(text, |i| position_dimension(kind, i)).map_err(|source| StudyError::Number {
                flag,
                joint: joint.clone(),
                source,
            })
        };
        for (joint, text) in &self.set {
            configuration.set(joint, &values("set", joint, text)?)?;
        }
        for (joint, text) in &self.guess {
            configuration.guess(joint, &values("guess", joint, text)?)?;
        }
        Ok(configuration)
    }

    /// The contact: a point given in another frame is taken over into the link at this pose, and moves with it.
    pub(crate) fn contact(&self, system: &System, pose: &Pose) -> Result<Contact, StudyError> {
        let mechanism = system.mechanism();
        let link = mechanism.find_link(&self.link)?;
        let against = self.against.as_ref().map(|name| other_side(mechanism, name)).transpose()?.flatten();
        let point = Vector3::from(self.point);
        let normal = match &self.normal {
            Normal::Along(normal) => Direction::Along(Vector3::from(*normal), self.normal_frame),
            Normal::Toward(name, point) => {
                Direction::Toward(mechanism.find_link(name)?, Vector3::from(*point))
            }
        };
        let point = system.point_in_link(pose, link, against, self.frame, point);
        Ok(Contact { link, against, point, normal })
    }
}

/// The link of this name; `world` is the ground where no link is called so.
fn other_side(mechanism: &Mechanism, name: &str) -> Result<Option<LinkId>, UnknownName> {
    match mechanism.find_link(name) {
        Ok(link) => Ok(Some(link)),
        Err(_) if name == "world" => Ok(None),
        Err(unknown) => Err(unknown),
    }
}
