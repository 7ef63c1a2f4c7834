//! Why a question has no answer, and which flag or key is at fault.

use crate::quantity::QuantityError;
use crate::thresholds::{LARGEST_COORDINATE, LEAST_OTHER_MASS, SHORTEST_DIRECTION};
use percuss_contact::ContactLawError;
use percuss_contact::exports::ExportError;
use percuss_dynamics::{
    AssemblyError, ConditionsError, ConfigurationError, ContactError, ResponseError, RouteError, TravelError,
};
use percuss_mechanism::{JointKind, UnknownName};

/// A part of a question: a flag on the command line, a key in a study file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Field {
    /// The struck link.
    Link,
    /// The contact point.
    Point,
    /// The normal.
    Normal,
    /// The line that the normal lies on.
    AlongLine,
    /// The frame of point and normal.
    Frame,
    /// The other link.
    Against,
    /// Mass of a free body on the other side.
    AgainstMass,
    /// A driving joint.
    Set,
    /// Where a joint is looked for.
    Guess,
    /// A joint that is held.
    Lock,
    /// A point that is held.
    Hold,
    /// A rotor's inertia.
    Armature,
    /// The classical estimate.
    Estimate,
    /// What a sweep varies.
    Vary,
    /// A joint's stop.
    Limit,
}

impl Field {
    /// Its flag and its key.
    fn names(self) -> (&'static str, &'static str) {
        match self {
            Field::Link => ("--link", "contact.link"),
            Field::Point => ("--point", "contact.point"),
            Field::Normal => ("--normal", "contact.normal"),
            Field::AlongLine => ("--along-line", "contact.along_line"),
            Field::Frame => ("--frame", "contact.frame"),
            Field::Against => ("--against", "contact.against"),
            Field::AgainstMass => ("--against-mass", "contact.against_mass"),
            Field::Set => ("--set", "pose.set"),
            Field::Guess => ("--guess", "pose.guess"),
            Field::Lock => ("--lock", "conditions.lock"),
            Field::Hold => ("--hold", "hold"),
            Field::Armature => ("--armature", "conditions.armature"),
            Field::Estimate => ("--estimate", "contact.estimate"),
            Field::Vary => ("--vary", "sweep.vary"),
            Field::Limit => ("--limit", "damping.limit"),
        }
    }

    /// Its flag on the command line.
    pub fn flag(self) -> &'static str {
        self.names().0
    }

    /// Its key in a study file.
    pub fn key(self) -> &'static str {
        self.names().1
    }

    /// Which part of the question a contact's error is about.
    fn of_contact(error: &ContactError) -> Self {
        match error {
            ContactError::NotFinite { what: "normal", .. } | ContactError::NoNormal { .. } => Field::Normal,
            ContactError::NotFinite { what: "line", .. } | ContactError::NoLine { .. } => Field::AlongLine,
            ContactError::Itself { .. } => Field::Against,
            ContactError::OtherMass { .. } => Field::AgainstMass,
            ContactError::NotFinite { .. } => Field::Point,
            // Handles of other mechanisms, which a question by names does not have.
            _ => Field::Link,
        }
    }

    /// Which part of the question a condition's error is about, where its name was known.
    pub(crate) fn of_condition(error: &ConditionsError) -> Self {
        match error {
            ConditionsError::BadHold { .. } => Field::Hold,
            ConditionsError::Twice { what: "lock", .. } => Field::Lock,
            _ => Field::Armature,
        }
    }
}

/// What is wrong with a part of a question.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// A name that nothing bears.
    #[error(transparent)]
    UnknownName(#[from] UnknownName),
    /// A position that cannot be set.
    #[error(transparent)]
    Configuration(#[from] ConfigurationError),
    /// A lock, a held contact or an armature that does not fit.
    #[error(transparent)]
    Conditions(#[from] ConditionsError),
    /// A contact that means nothing.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// A number in the wrong unit.
    #[error("joint \"{joint}\": {source}")]
    Position {
        /// The joint.
        joint: String,
        /// What is wrong.
        source: QuantityError,
    },
    /// The other body's mass is no mass.
    #[error(
        "the other body's mass is {mass:e} kg; expected a finite number above 0 ({LEAST_OTHER_MASS:e} at least)"
    )]
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
    #[error(
        "the estimate's point has a component {value:e}; expected a finite number of at most {LARGEST_COORDINATE:e}"
    )]
    EstimatePoint {
        /// The component.
        value: f64,
    },
    /// A direction without length.
    #[error("the estimate's direction has length {length:e}; expected at least {SHORTEST_DIRECTION:e}")]
    EstimateDirection {
        /// Its length.
        length: f64,
    },
    /// A joint whose stop is not that of one number.
    #[error("joint \"{joint}\" is {}; expected a joint that turns or slides: only these have a stop", kind.name())]
    NoStop {
        /// The joint.
        joint: String,
        /// Its kind.
        kind: JointKind,
    },
    /// A joint without limits.
    #[error("joint \"{joint}\" has no <limit>; leave the end away and set where it is stopped")]
    NoLimit {
        /// The joint.
        joint: String,
    },
    /// A range in the wrong unit.
    #[error(transparent)]
    Range(QuantityError),
    /// A joint that has not one position.
    #[error("\"{joint}\": a {} joint has no single position to vary", kind.name())]
    NoSinglePosition {
        /// The joint.
        joint: String,
        /// Its kind.
        kind: JointKind,
    },
    /// A joint that follows another is varied.
    #[error("\"{joint}\": it mimics \"{master}\"; vary that")]
    VariedMimic {
        /// The joint.
        joint: String,
        /// What it follows.
        master: String,
    },
    /// A joint that is set is varied.
    #[error("\"{joint}\": it is set already (--set); give it one or the other")]
    VariedIsSet {
        /// The joint.
        joint: String,
    },
    /// A travel that means nothing, or that nothing drives.
    #[error(transparent)]
    Travel(#[from] TravelError),
    /// A point is given in a frame that is looked up at a pose out of reach.
    #[error(
        "a point in this frame is converted to the struck link where the varied joint stands at 0, and that pose cannot \
         be reached ({source}); give the point in the frame of the struck link (--frame link)"
    )]
    NoReferencePose {
        /// Why.
        source: AssemblyError,
    },
}

/// Why a question has no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// A part of the question that means nothing.
    #[error("{}: {fault}", field.flag())]
    Input {
        /// Which part.
        field: Field,
        /// What is wrong.
        fault: Box<Fault>,
    },
    /// Loops that do not close, or not there.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
    /// An impossible mass matrix.
    #[error(transparent)]
    Route(#[from] RouteError),
    /// Another reason of the dynamics.
    #[error(transparent)]
    Response(ResponseError),
    /// A restitution, a stiffness or a speed out of range, or a restitution that the law does not reach.
    #[error(transparent)]
    Damping(#[from] ContactLawError),
    /// A simulator that cannot have the contact.
    #[error(transparent)]
    Export(Box<ExportError>),
    /// A safe speed against something else than a person.
    #[error("the other side is the person: leave --against and --against-mass out")]
    PersonIsTheOther,
    /// A robot without mass at the contact.
    #[error(
        "the contact is massless: no speed is too high for it; the load, if there is one, is given by --load"
    )]
    NoMass,
    /// A contact that nothing damps.
    #[error("the contact is {status}: no damper gives it a restitution")]
    NoDamper {
        /// `immovable` or `massless`.
        status: &'static str,
    },
}

impl StudyError {
    /// A fault of a part of the question.
    pub(crate) fn input(field: Field, fault: impl Into<Fault>) -> Self {
        StudyError::Input { field, fault: Box::new(fault.into()) }
    }

    /// Whether the question was fine and yet has no answer (exit code 1, not 2).
    pub fn is_no_answer(&self) -> bool {
        match self {
            StudyError::NoDamper { .. } | StudyError::NoMass | StudyError::Route(_) => true,
            StudyError::Assembly(error) => !error.is_bad_input(),
            _ => false,
        }
    }

    /// The message with the keys of a study file in place of flags.
    pub fn in_study(&self) -> String {
        match self {
            StudyError::Input { field, fault } => format!("{}: {fault}", field.key()),
            other => other.to_string(),
        }
    }
}

impl From<ResponseError> for StudyError {
    fn from(error: ResponseError) -> Self {
        match error {
            ResponseError::Contact(error) => StudyError::input(Field::of_contact(&error), error),
            ResponseError::Route(error) => StudyError::Route(error),
            other => StudyError::Response(other),
        }
    }
}
