//! Why a question has no answer, and which flag or key is at fault.

use crate::field::{Field, Names, about_assembly, about_contact};
use crate::given_pose::GivenPoseError;
use crate::quantity::QuantityError;
use crate::table_error::TableError;
use crate::thresholds::{
    DIRECTIONS, GRID_ROWS, LARGEST_COORDINATE, LEAST_EDGE, LEAST_OTHER_MASS, ROWS, SAMPLES,
    SHORTEST_DIRECTION,
};
use percuss_contact::ContactLawError;
use percuss_contact::exports::ExportError;
use percuss_dynamics::{
    AssemblyError, ConditionsError, ConfigurationError, ContactError, EffectiveMass, ResponseError,
    RouteError, TravelError,
};
use percuss_formats::{MeshError, SurfaceError};
use percuss_mechanism::{JointKind, UnknownName};

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
    /// A root link that floats and has no mass.
    #[error("{}", massless_base(link, Names::Fields))]
    MasslessBase {
        /// The root link.
        link: String,
    },
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
    /// Too few rows, or too many.
    #[error("{count} rows; {} to {} are possible", ROWS.start(), ROWS.end())]
    Rows {
        /// What was given.
        count: usize,
    },
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
    #[error("{}", varied_is_set(joint, Names::Fields))]
    VariedIsSet {
        /// The joint.
        joint: String,
    },
    /// A joint that is varied twice.
    #[error("\"{joint}\" is varied twice; give it one range")]
    VariedTwice {
        /// The joint.
        joint: String,
    },
    /// A travel that is not what varies fastest.
    #[error(
        "\"{name}\" is not the last of the ranges; a travel starts where the joints stand, so it is varied fastest: give it \
         last, and once"
    )]
    TravelNotLast {
        /// As its column is headed.
        name: String,
    },
    /// Too many combinations.
    #[error("the ranges have {count} combinations; {} are possible at most", GRID_ROWS)]
    Combinations {
        /// How many there are.
        count: u128,
    },
    /// No random rows, or too many.
    #[error("{count} random rows; 1 to {GRID_ROWS} are possible")]
    RandomRows {
        /// What was given.
        count: usize,
    },
    /// Every joint is set.
    #[error("no joint is left to sample: all that can move are set, or follow from others")]
    NothingToSample,
    /// A joint that has no limits to sample between.
    #[error("{}", no_limits(joint, *kind, Names::Fields))]
    NothingToSampleBetween {
        /// The joint.
        joint: String,
        /// Its kind.
        kind: JointKind,
    },
    /// A link without a surface.
    #[error("link \"{link}\" has no shape that can be used: no <collision> and no <visual> with a geometry")]
    NoShape {
        /// The link.
        link: String,
    },
    /// A link that is the other side of the contact.
    #[error("link \"{link}\" is the other side")]
    OtherSide {
        /// The link.
        link: String,
    },
    /// A mesh that cannot be read.
    #[error("link \"{link}\": {source}")]
    Mesh {
        /// The link.
        link: String,
        /// Why.
        source: MeshError,
    },
    /// No link has a map.
    #[error("no link has a surface that can be mapped: {reasons}")]
    NothingToMap {
        /// Why the first of them have none.
        reasons: String,
    },
    /// An edge that is none.
    #[error("the longest edge is {edge} m; expected a number of at least {LEAST_EDGE:e} m")]
    Edge {
        /// What was given, m.
        edge: f64,
    },
    /// Too many facets.
    #[error("link \"{link}\": {source}")]
    Facets {
        /// The link.
        link: String,
        /// How many.
        source: SurfaceError,
    },
    /// No directions, or too many.
    #[error("{count} directions; {} to {} are possible", DIRECTIONS.start(), DIRECTIONS.end())]
    Directions {
        /// What was given.
        count: usize,
    },
    /// A file of positions.
    #[error(transparent)]
    Table(#[from] Box<TableError>),
    /// A travel that means nothing, or that nothing drives.
    #[error(transparent)]
    Travel(#[from] TravelError),
    /// A file of a pose.
    #[error(transparent)]
    PoseFile(#[from] GivenPoseError),
    /// A link's mass that is none.
    #[error("link \"{link}\": {mass:e} kg; expected a finite mass of 0 or more")]
    LinkMass {
        /// The link.
        link: String,
        /// What was given, kg.
        mass: f64,
    },
    /// A centre of mass of nothing.
    #[error("link \"{link}\" has no mass, so that no centre of mass can be set; give it a mass first")]
    NoMassToMove {
        /// The link.
        link: String,
    },
    /// A centre of mass that is nowhere.
    #[error("link \"{link}\": the centre of mass has a component {value:e}; expected finite numbers")]
    LinkCom {
        /// The link.
        link: String,
        /// The component, m.
        value: f64,
    },
    /// Changes that leave no mechanism.
    #[error("with what was changed there is no mechanism: {message}")]
    NoMechanism {
        /// What the builder found.
        message: String,
    },
    /// A hardpoint of a model that has none.
    #[error(
        "{path} is a URDF, which has no hardpoints; give the suspension's sheet (.toml, .csv, .xlsx) in its place, or move \
         the joints' <origin> in the file"
    )]
    NoSheet {
        /// The model's file.
        path: String,
    },
    /// A direction without length.
    #[error("the direction has no length; expected a vector such as 0,0,1")]
    NoRatioDirection,
    /// No samples, or too many.
    #[error("{count} samples; {} to {} are possible", SAMPLES.start(), SAMPLES.end())]
    Samples {
        /// What was given.
        count: usize,
    },
    /// A travel of the pose beside rows that leave it no place.
    #[error(
        "a travel of the pose goes with ranges of joints, once; it does not go with a varied travel, a file of positions, \
         random positions, or another travel"
    )]
    TravelOfRows,
    /// A unit of a linear spring for one that is not.
    #[error(
        "its unit is that of a linear spring; with the exponent {exponent} a plain number in N/m^{exponent} is expected \
         (1 N/mm^{exponent} is {:e} N/m^{exponent})",
        1e3_f64.powf(*exponent)
    )]
    UnitOfLinearSpring {
        /// The exponent of the spring.
        exponent: f64,
    },
    /// A unit of a turn for what does not turn, or the other way round.
    #[error(
        "its unit is not that of {}; expected {expected}",
        if *turns { "a joint that turns" } else { "what does not turn" }
    )]
    UnitOfMotion {
        /// Whether it turns.
        turns: bool,
        /// The unit it should have.
        expected: &'static str,
    },
    /// A joint that is varied and follows from others.
    #[error(transparent)]
    Dependent(Box<AssemblyError>),
    /// A point is given in a frame that is looked up at a pose out of reach.
    #[error("{}", no_reference_pose(source, Names::Fields))]
    NoReferencePose {
        /// Why.
        source: AssemblyError,
    },
}

impl Fault {
    /// The message, with the names of where the question was asked.
    fn message(&self, names: Names) -> String {
        match self {
            Fault::VariedIsSet { joint } => varied_is_set(joint, names),
            Fault::NoReferencePose { source } => no_reference_pose(source, names),
            Fault::Table(error) => error.message(names),
            Fault::NothingToSampleBetween { joint, kind } => no_limits(joint, *kind, names),
            Fault::Dependent(error) => about_assembly(error, names),
            Fault::Contact(error) => about_contact(error, names),
            Fault::MasslessBase { link } => massless_base(link, names),
            Fault::Travel(TravelError::Assembly(error)) => about_assembly(error, names),
            other => other.to_string(),
        }
    }
}

fn massless_base(link: &str, names: Names) -> String {
    let given = match names {
        Names::Fields => String::new(),
        Names::Flags => format!(" (--link-mass {link}=KG)"),
        Names::Keys => format!(" (model.link_mass: {link} = KG)"),
    };
    format!(
        "the root link \"{link}\" has no mass; a body that floats needs one: give it its mass{given}, or leave the base fixed"
    )
}

fn varied_is_set(joint: &str, names: Names) -> String {
    format!("\"{joint}\": it is set already{}; give it one or the other", Field::Set.hint(names))
}

fn no_limits(joint: &str, kind: JointKind, names: Names) -> String {
    let (set, vary) = (Field::Set.hint(names), Field::Vary.hint(names));
    let what = match kind {
        JointKind::Planar | JointKind::Floating => "has no limits",
        JointKind::Fixed
        | JointKind::Revolute
        | JointKind::Continuous
        | JointKind::Prismatic
        | JointKind::Spherical => "has no <limit>",
    };
    let remedy = if kind.positions() == 1 {
        format!("give it a <limit>, set it{set}, or vary ranges instead of random positions{vary}")
    } else {
        format!("set it{set}")
    };
    format!("joint \"{joint}\" is {} and {what} to sample between; {remedy}", kind.name())
}

fn no_reference_pose(source: &AssemblyError, names: Names) -> String {
    let how = match names {
        Names::Fields => "",
        Names::Flags => " (--frame link)",
        Names::Keys => " (contact.frame = \"link\")",
    };
    let why = about_assembly(source, names);
    format!(
        "a point in this frame is converted to the struck link where the varied joint stands at 0, and that pose cannot \
         be reached ({why}); give the point in the frame of the struck link{how}"
    )
}

/// Why a question has no answer. Where it came from flags or from a study file, [`message`](Self::message) has their names.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// A part of the question that means nothing.
    #[error("{}: {fault}", field.named(Names::Fields))]
    Input {
        /// Which part.
        field: Field,
        /// What is wrong.
        fault: Box<Fault>,
    },
    /// Loops that do not close, or not there.
    #[error(transparent)]
    Assembly(#[from] AssemblyError),
    /// A travel that ends before.
    #[error("{}: {why}", Field::Travel.named(Names::Fields))]
    TravelNotReached {
        /// Why, and how far it goes.
        why: String,
    },
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
    #[error("{}", person_is_the_other(Names::Fields))]
    PersonIsTheOther,
    /// A force or a pressure on nothing that gives way.
    #[error("{}", no_region(Names::Fields))]
    NoRegion,
    /// A robot without mass at the contact.
    #[error("{}", no_mass(Names::Fields))]
    NoMass,
    /// A safe speed where the robot's mass may be any.
    #[error(
        "what the effective mass may be off by is not known: beside this pose the contact is not finite; no speed can be \
         called safe there"
    )]
    MassUnknown,
    /// A safe speed at a singular pose, where not every branch is known.
    #[error(
        "the pose is singular and no greatest mass of the robot is known there: {}; the effective mass is a lower bound, which \
         allows too high a speed; ask for poses beside it",
        of_branches(limits, *complete)
    )]
    NoGreatestMass {
        /// The limits of m̄ along the branches that were found.
        limits: Vec<EffectiveMass>,
        /// Whether no sign of more branches was found.
        complete: bool,
    },
    /// A damper at a singular pose, where the mass depends on the branch.
    #[error(
        "the pose is singular: no damper gives the contact a restitution on every branch: {}; ask for a pose a little beside it, \
         on the branch that is meant, or for the damper of its mass",
        of_branches(limits, *complete)
    )]
    NoDamperOfAll {
        /// The limits of m̄ along the branches that were found, with the other body.
        limits: Vec<EffectiveMass>,
        /// Whether no sign of more branches was found.
        complete: bool,
    },
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

    /// The part of the question that means nothing, where it is one.
    pub fn field(&self) -> Option<Field> {
        match self {
            StudyError::Input { field, .. } => Some(*field),
            _ => None,
        }
    }

    /// The same where the joint that follows from others is not set but varied.
    pub(crate) fn of_varied(self, is_varied: impl Fn(&str) -> bool) -> Self {
        match self {
            StudyError::Assembly(error @ AssemblyError::Dependent { .. }) => match &error {
                AssemblyError::Dependent { joint, .. } if is_varied(joint) => {
                    StudyError::input(Field::Vary, Fault::Dependent(Box::new(error)))
                }
                _ => StudyError::Assembly(error),
            },
            other => other,
        }
    }

    /// Whether the question was fine and yet has no answer (exit code 1, not 2).
    pub fn is_no_answer(&self) -> bool {
        match self {
            StudyError::NoDamper { .. }
            | StudyError::NoDamperOfAll { .. }
            | StudyError::NoGreatestMass { .. }
            | StudyError::MassUnknown
            | StudyError::NoMass
            | StudyError::TravelNotReached { .. }
            | StudyError::Route(_) => true,
            StudyError::Assembly(error) => !error.is_bad_input(),
            _ => false,
        }
    }

    /// The message, with the names of where the question was asked.
    pub fn message(&self, names: Names) -> String {
        match self {
            StudyError::Input { field, fault } => format!("{}: {}", field.named(names), fault.message(names)),
            StudyError::Assembly(error @ AssemblyError::Dependent { .. }) if names != Names::Fields => {
                format!("{}: {}", Field::Set.named(names), about_assembly(error, names))
            }
            StudyError::Assembly(error) => about_assembly(error, names),
            StudyError::TravelNotReached { why } => format!("{}: {why}", Field::Travel.named(names)),
            StudyError::PersonIsTheOther => person_is_the_other(names),
            StudyError::NoMass => no_mass(names),
            StudyError::NoRegion => no_region(names),
            other => other.to_string(),
        }
    }
}

fn person_is_the_other(names: Names) -> String {
    let [against, mass] = [Field::Against, Field::AgainstMass].map(|field| field.named(names));
    format!("the other side is the person: leave {against} and {mass} out")
}

fn no_region(names: Names) -> String {
    let region = match names {
        Names::Flags => "--region",
        Names::Fields | Names::Keys => "region",
    };
    format!(
        "a force or a pressure belongs to a region of the body: give {region}; without one, an energy or a momentum"
    )
}

fn no_mass(names: Names) -> String {
    let load = match names {
        Names::Flags => "--load",
        Names::Fields | Names::Keys => "load",
    };
    format!(
        "the contact is massless: no speed is too high for it; the load, if there is one, is given by {load}"
    )
}

/// The limits of m̄ along branches, in words.
fn of_branches(limits: &[EffectiveMass], complete: bool) -> String {
    let limit = |limit: &EffectiveMass| match limit {
        EffectiveMass::Finite(m) => format!("{m} kg"),
        EffectiveMass::Immovable => "immovable".into(),
        EffectiveMass::Massless => "massless".into(),
    };
    if limits.is_empty() {
        return "no branch with a mass was found".into();
    }
    let all = limits.iter().map(limit).collect::<Vec<_>>().join(", ");
    let more = if complete { "" } else { ", and there may be more" };
    format!("along its branches it is {all}{more}")
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
