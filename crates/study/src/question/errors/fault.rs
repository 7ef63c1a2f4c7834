//! Faults of the parts of a question.

use crate::question::errors::fault_texts::{
    massless_base, no_limits, no_reference_pose, rounded_speed, varied_is_set,
};
use crate::question::errors::table_error::TableError;
use crate::question::field::{Names, assembly_error_message, contact_error_message};
use crate::question::pose_file::GivenPoseError;
use crate::thresholds::{
    DIRECTIONS, GRID_ROWS, LARGEST_COORDINATE, LEAST_EDGE, LEAST_OTHER_MASS, ROWS, SAMPLES,
    SHORTEST_DIRECTION,
};
use percuss_dynamics::{AssemblyError, ConditionsError, ConfigurationError, ContactError, TravelError};
use percuss_formats::{MeshError, SurfaceError};
use percuss_impact::{ExtremesError, ImpactError, PercussionError, RangeError, RatesError, ReflectedError};
use percuss_mechanism::{JointKind, UnknownName};
use percuss_units::QuantityError;

/// Fault of one part of a question.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// Unknown name.
    #[error(transparent)]
    UnknownName(#[from] UnknownName),
    /// Model without named contacts.
    #[error(
        "the model names no contact; a suspension sheet names its stops, springs and dampers, a URDF names contacts by \
         <contact> elements, an MJCF by its sites; give link, point and normal instead"
    )]
    NoNamedContacts,
    /// Normal in addition to a named stop.
    #[error(
        "the named contact is a stop, whose normal belongs to its gap; remove the normal, or give link, point and normal"
    )]
    NormalOfStop,
    /// Invalid position.
    #[error(transparent)]
    Configuration(#[from] ConfigurationError),
    /// Invalid lock, held contact or armature.
    #[error(transparent)]
    Conditions(#[from] ConditionsError),
    /// Floating root link without mass.
    #[error("{}", massless_base(link))]
    MasslessBase {
        /// Root link.
        link: String,
    },
    /// Invalid contact.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// Number in the wrong unit.
    #[error("joint \"{joint}\": {source}")]
    Position {
        /// Joint.
        joint: String,
        /// Cause.
        source: QuantityError,
    },
    /// Invalid mass of the other body.
    #[error(
        "the other body's mass is {mass:e} kg; expected a finite number above 0 ({LEAST_OTHER_MASS:e} at least)"
    )]
    OtherMass {
        /// Given mass, kg.
        mass: f64,
    },
    /// Extremes with a free body on the other side.
    #[error("extremes are those of the mechanism alone; expected no free body on the other side")]
    ExtremesOfMechanism,
    /// Rows that form no path.
    #[error("a path is a file of positions, or one range; expected neither several ranges nor random rows")]
    NoPath,
    /// Path together with ranges or kept points in a search for extremes.
    #[error("a path gives all positions of the search; expected neither ranges nor kept points with it")]
    PathAndRanges,
    /// Joint with a position and a range in a search for extremes.
    #[error("joint \"{joint}\" has a range and a given position; expected one of the two")]
    SetAndRanged {
        /// Joint.
        joint: String,
    },
    /// Several values for a joint that takes one.
    #[error("joint \"{joint}\" is given twice; give it once")]
    JointTwice {
        /// Joint.
        joint: String,
    },
    /// Restitution or closing speed of an impact out of range.
    #[error(transparent)]
    Impact(#[from] ImpactError),
    /// Rates that do not fit a joint, do not determine the motion, or are inadmissible.
    #[error(transparent)]
    Rates(#[from] RatesError),
    /// Reflected inertia that cannot be computed.
    #[error(transparent)]
    Reflected(#[from] ReflectedError),
    /// Centre of percussion that cannot be computed.
    #[error(transparent)]
    Percussion(#[from] PercussionError),
    /// Reflected inertia over a range.
    #[error(transparent)]
    ReflectedRange(#[from] RangeError),
    /// Text of a range of a reflected inertia.
    #[error("{message}")]
    RangeText {
        /// Message of the reader of ranges.
        message: String,
    },
    /// Contact as text that cannot be read, or that contradicts other fields of the question.
    #[error("{message}")]
    ContactText {
        /// Reason.
        message: String,
    },
    /// Requested result that requires a contact point.
    #[error("{contact} has no {result}: it has no contact point; give a contact by link, point and normal")]
    NoContactPoint {
        /// Kind of the contact.
        contact: &'static str,
        /// The result.
        result: &'static str,
    },
    /// Name of a closure instead of a joint.
    #[error(
        "\"{closure}\" is the closure of a loop; expected a joint of the tree. The reactions of `percuss impact` include this closure"
    )]
    IsClosure {
        /// The closure.
        closure: String,
    },
    /// Name that is not the name of a bearing.
    #[error("no joint or loop closure has the name \"{name}\"; expected one of {}", names.join(", "))]
    UnknownBearing {
        /// The name.
        name: String,
        /// Similar names; if there are none, the first twelve names of bearings.
        names: Vec<String>,
    },
    /// Peak force in a bearing without a contact law, or another quantity with one.
    #[error(
        "expected a contact law (stiffness, restitution and closing speed) for the peak force in a bearing, peak:JOINT, and for no other quantity"
    )]
    PeakAndLaw,
    /// Search for extremes.
    #[error(transparent)]
    Extremes(#[from] ExtremesError),
    /// Impact without a speed and without rates.
    #[error(
        "no motion before the impact is given; expected the closing speed, or the rates of the driving joints"
    )]
    NoClosingSpeed,
    /// Closing speed that differs from the speed of the given rates.
    #[error(
        "{speed} {unit} is given, but the given rates close the gap at {closing} {unit}; leave one of the two out"
    )]
    OtherSpeed {
        /// Given speed.
        speed: f64,
        /// Closing speed of the given rates.
        closing: f64,
        /// Unit of both: m/s or rad/s.
        unit: &'static str,
    },
    /// Rates that open the gap.
    #[error(
        "the closing speed of these rates is {} {unit}; expected a speed above zero: the rates {}", rounded_speed(*closing),
        if *closing < 0.0 { "open the gap; opposite rates close it" } else { "do not change the gap" }
    )]
    GapOpens {
        /// Closing speed of the given rates.
        closing: f64,
        /// Unit: m/s or rad/s.
        unit: &'static str,
    },
    /// Velocity of a fixed base.
    #[error("the base is fixed; a velocity requires a floating base")]
    BaseIsFixed,
    /// Wrong number of rates of a joint.
    #[error("joint \"{joint}\": {got} rates are given; expected {expected}")]
    RateCount {
        /// Joint.
        joint: String,
        /// Number of given rates.
        got: usize,
        /// Number of velocities of the joint.
        expected: usize,
    },
    /// Limit of a rate or of an impulse in a gear that is not positive.
    #[error("joint \"{joint}\": the limit is {value}; expected a number above zero")]
    RateLimit {
        /// Joint.
        joint: String,
        /// Given limit.
        value: f64,
    },
    /// Wrong number of limits of a joint.
    #[error("joint \"{joint}\": {got} limits are given; expected {expected}")]
    LimitCount {
        /// Joint.
        joint: String,
        /// Number of given limits.
        got: usize,
        /// Number of velocities of the joint.
        expected: usize,
    },
    /// Wrong number of values of a spring.
    #[error("joint \"{joint}\": {got} numbers are given; expected K, K,D or K,D,FREE")]
    SpringCount {
        /// Joint.
        joint: String,
        /// Number of given values.
        got: usize,
    },
    /// Limit of the impulse in a gear at a joint without armature.
    #[error(
        "joint \"{joint}\" has no armature, so its gear receives no impulse; give --armature {joint}=VALUE"
    )]
    NoGear {
        /// Joint.
        joint: String,
    },
    /// Limit of the torque in a gear without the stiffness of the contact.
    #[error("a limit in N·m or N requires the stiffness of the contact, which determines the peak torque")]
    NoContactStiffness,
    /// Joint without motion.
    #[error("joint \"{joint}\" is fixed; expected a joint that moves")]
    NoMotion {
        /// Joint.
        joint: String,
    },
    /// Link listed twice in the estimate.
    #[error("the estimate names link \"{link}\" twice; name it once")]
    EstimateTwice {
        /// Link.
        link: String,
    },
    /// Point of the estimate that is not finite or is too large.
    #[error(
        "the estimate's point has a component {value:e}; expected a finite number of at most {LARGEST_COORDINATE:e}"
    )]
    EstimatePoint {
        /// Component, m.
        value: f64,
    },
    /// Direction of the estimate without length.
    #[error("the estimate's direction has length {length:e}; expected at least {SHORTEST_DIRECTION:e}")]
    EstimateDirection {
        /// Length of the direction.
        length: f64,
    },
    /// Joint stop of a joint without exactly one position.
    #[error("joint \"{joint}\" is {}; expected a revolute, continuous or prismatic joint: only these have a \
        stop", kind.name())]
    NoStop {
        /// Joint.
        joint: String,
        /// Kind of the joint.
        kind: JointKind,
    },
    /// Stop of a dependent joint that several driving joints move.
    #[error(
        "the position of joint \"{joint}\" follows from loops or couplings, and several driving joints move it to its stop: {}; set all of them except one",
        drivers.join(", ")
    )]
    StopOfDrivers {
        /// Joint of the stop.
        joint: String,
        /// Driving joints that are not set.
        drivers: Vec<String>,
    },
    /// Joint without limits.
    #[error(
        "joint \"{joint}\" has no <limit>; omit the end of the range and set the joint to the position of \
        the stop"
    )]
    NoLimit {
        /// Joint.
        joint: String,
    },
    /// Range in the wrong unit.
    #[error(transparent)]
    Range(QuantityError),
    /// Number of rows out of range.
    #[error("{count} rows; {} to {} are possible", ROWS.start(), ROWS.end())]
    Rows {
        /// Given number of rows.
        count: usize,
    },
    /// Varied joint with more or fewer than one position.
    #[error("\"{joint}\": a {} joint has no single position to vary", kind.name())]
    NoSinglePosition {
        /// Joint.
        joint: String,
        /// Kind of the joint.
        kind: JointKind,
    },
    /// Link in place of a varied joint.
    #[error(
        "\"{link}\" is a link, and no joint{}; a point of a link is moved by travel:{link}:0,0,0:0,0,1=FROM:TO:COUNT, the wheels of \
         a suspension by wheel-travel=FROM:TO:COUNT",
        parent_joint.as_ref().map_or_else(String::new, |joint| format!(" (its joint to the parent is \"{joint}\")"))
    )]
    VariedLink {
        /// Link.
        link: String,
        /// Joint between the link and its parent.
        parent_joint: Option<String>,
    },
    /// Varied joint that mimics another joint.
    #[error("\"{joint}\": it mimics \"{master}\"; vary that joint")]
    VariedMimic {
        /// Joint.
        joint: String,
        /// Master joint.
        master: String,
    },
    /// Varied joint that is set as well.
    #[error("{}", varied_is_set(joint, Names::Fields))]
    VariedIsSet {
        /// Joint.
        joint: String,
    },
    /// Position of the rack of a suspension that was imported with a fixed one.
    #[error(
        "the rack is fixed in this suspension; write rack.slides = true in the sheet, or use percuss kinematics --steer"
    )]
    FixedRack,
    /// Joint with two ranges.
    #[error("\"{joint}\" is varied twice; give it one range")]
    VariedTwice {
        /// Joint.
        joint: String,
    },
    /// Travel that is not the last range, that is, not the fastest.
    #[error(
        "\"{name}\" is not the last of the ranges: only one travel may have a range, and it comes last, because each of its rows \
         starts from the joint positions of the other ranges; give another travel one length"
    )]
    TravelNotLast {
        /// Name of the travel's column.
        name: String,
    },
    /// Too many combinations of a grid.
    #[error("the ranges have {count} combinations; {} are possible at most", GRID_ROWS)]
    Combinations {
        /// Number of combinations.
        count: u128,
    },
    /// Number of random rows out of range.
    #[error("{count} random rows; 1 to {GRID_ROWS} are possible")]
    RandomRows {
        /// Given number of rows.
        count: usize,
    },
    /// No free joint to sample: all joints are set or dependent.
    #[error("no joint can be sampled: all movable joints are set, or depend on other joints")]
    NothingToSample,
    /// Joint without limits to sample between.
    #[error("{}", no_limits(joint, *kind, Names::Fields))]
    NothingToSampleBetween {
        /// Joint.
        joint: String,
        /// Kind of the joint.
        kind: JointKind,
    },
    /// Link without a surface.
    #[error("link \"{link}\" has no shape that can be used: no <collision> and no <visual> with a geometry")]
    NoShape {
        /// Link.
        link: String,
    },
    /// Mapped link that is the other side of the contact.
    #[error("link \"{link}\" is the other side")]
    OtherSide {
        /// Link.
        link: String,
    },
    /// Unreadable mesh.
    #[error("link \"{link}\": {source}")]
    Mesh {
        /// Link.
        link: String,
        /// Cause.
        source: MeshError,
    },
    /// Map without any link.
    #[error("no link has a surface that can be mapped: {reasons}")]
    NothingToMap {
        /// Reasons for the first links.
        reasons: String,
    },
    /// Longest edge out of range.
    #[error("the longest edge is {edge} m; expected a number of at least {LEAST_EDGE:e} m")]
    Edge {
        /// Given edge, m.
        edge: f64,
    },
    /// Too many facets.
    #[error("link \"{link}\": {source}")]
    Facets {
        /// Link.
        link: String,
        /// Cause.
        source: SurfaceError,
    },
    /// Number of directions out of range.
    #[error("{count} directions; {} to {} are possible", DIRECTIONS.start(), DIRECTIONS.end())]
    Directions {
        /// Given number of directions.
        count: usize,
    },
    /// Fault of a file of positions.
    #[error(transparent)]
    Table(#[from] Box<TableError>),
    /// Invalid travel, or a travel without a driving joint.
    #[error(transparent)]
    Travel(#[from] TravelError),
    /// Motion of the wheels that the model does not have.
    #[error("{motion}: {why}")]
    WheelMotion {
        /// Name of the motion.
        motion: &'static str,
        /// Reason and remedy.
        why: &'static str,
    },
    /// Fault of a pose file.
    #[error(transparent)]
    PoseFile(#[from] GivenPoseError),
    /// Invalid mass of a link.
    #[error("link \"{link}\": {mass:e} kg; expected a finite mass of 0 or more")]
    LinkMass {
        /// Link.
        link: String,
        /// Given mass, kg.
        mass: f64,
    },
    /// Centre of mass for a link without mass.
    #[error("link \"{link}\" has no mass, so that no centre of mass can be set; give it a mass first")]
    NoMassToMove {
        /// Link.
        link: String,
    },
    /// Centre of mass that is not finite.
    #[error(
        "link \"{link}\": the centre of mass has a component {value:e}; expected finite numbers of at most {LARGEST_COORDINATE:e}"
    )]
    LinkCom {
        /// Link.
        link: String,
        /// Component, m.
        value: f64,
    },
    /// Moments of inertia given for a link without mass.
    #[error("link \"{link}\" has no mass, so that no moments of inertia can be set; give it a mass first")]
    NoMassToTurn {
        /// Link.
        link: String,
    },
    /// Moments of inertia that no body can have.
    #[error(
        "link \"{link}\": moments of inertia {moments:?} kg·m² about the centre of mass; expected finite moments of 0 or more, none \
         larger than the sum of the other two"
    )]
    LinkInertia {
        /// Link.
        link: String,
        /// Given moments, kg·m².
        moments: [f64; 3],
    },
    /// Changes that give no valid mechanism.
    #[error("the changed model is invalid: {message}")]
    NoMechanism {
        /// Message of the builder.
        message: String,
    },
    /// Moved hardpoint of a model without hardpoints.
    #[error(
        "{path} is a URDF without hardpoints; give the suspension sheet (.toml, .csv, .xlsx) instead, or move \
         the joints' <origin> in the file"
    )]
    NoSheet {
        /// File of the model.
        path: String,
    },
    /// Direction of a motion ratio without length.
    #[error("the direction has no length; expected a vector such as 0,0,1")]
    NoRatioDirection,
    /// Number of samples out of range.
    #[error("{count} samples; {} to {} are possible", SAMPLES.start(), SAMPLES.end())]
    Samples {
        /// Given number of samples.
        count: usize,
    },
    /// Two motions of the wheels that are not heave and roll.
    #[error("{first} and {second} both move the wheel; give one of them, or heave and roll of an axle")]
    SameTravel {
        /// Name of the motion.
        first: String,
        /// Name of the other motion.
        second: String,
    },
    /// Travel of the pose together with rows that exclude a travel: a varied travel, a file, random positions
    /// or a second travel.
    #[error(
        "a travel of the pose can be combined with ranges of joints only, not with a varied travel, a file of \
         positions, random positions, or another travel"
    )]
    TravelExcludedByRows,
    /// Unit of a linear spring for a nonlinear spring.
    #[error(
        "its unit is that of a linear spring; with the exponent {exponent} a plain number in N/m^{exponent} is expected \
         (1 N/mm^{exponent} is {:e} N/m^{exponent})",
        1e3_f64.powf(*exponent)
    )]
    UnitOfLinearSpring {
        /// Exponent of the spring.
        exponent: f64,
    },
    /// Unit of rotation for a translation, or the reverse.
    #[error(
        "its unit is not that of {}; expected {expected}",
        if *turns { "a rotation" } else { "a translation" }
    )]
    UnitOfMotion {
        /// True for a rotation.
        turns: bool,
        /// Expected unit.
        expected: &'static str,
    },
    /// Varied joint that depends on other joints.
    #[error(transparent)]
    Dependent(Box<AssemblyError>),
    /// Point in a frame that requires a reference pose, and the reference pose is unreachable.
    #[error("{}", no_reference_pose(source, Names::Fields))]
    NoReferencePose {
        /// Cause.
        source: AssemblyError,
    },
}

impl Fault {
    /// Message with the names of `names`: flags, study keys or fields.
    pub(crate) fn message(&self, names: Names) -> String {
        match self {
            Fault::VariedIsSet { joint } => varied_is_set(joint, names),
            Fault::NoReferencePose { source } => no_reference_pose(source, names),
            Fault::Table(error) => error.message(names),
            Fault::NothingToSampleBetween { joint, kind } => no_limits(joint, *kind, names),
            Fault::Dependent(error) => assembly_error_message(error, names),
            Fault::Contact(error) => contact_error_message(error, names),
            Fault::MasslessBase { link } => massless_base(link),
            Fault::Travel(TravelError::Assembly(error)) => assembly_error_message(error, names),
            other => other.to_string(),
        }
    }
}
