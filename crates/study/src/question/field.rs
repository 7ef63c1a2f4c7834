//! Parts of a question and their names: command-line flags, study keys, or field names in code.

use percuss_dynamics::{AssemblyError, ConditionOfJoint, ConditionsError, ContactError, ContactPart, Frame};

/// Set of names used in messages for the parts of a question.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Names {
    /// Field names, for use in code; messages omit flags and keys.
    #[default]
    Fields,
    /// Flags of the command line.
    Flags,
    /// Keys of a study file; the keys of the table of the question, if a table determines it.
    Keys(Option<&'static TableKeys>),
}

impl Names {
    /// Keys of a study, for a question that no table determines.
    pub const KEYS: Self = Names::Keys(None);

    /// Names of the keys of a table; flags and fields do not depend on the table.
    pub(crate) fn in_table(self, table: &'static TableKeys) -> Self {
        if matches!(self, Names::Keys(_)) { Names::Keys(Some(table)) } else { self }
    }
}

/// Keys of a table of a study, such as `impact.speed`.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct TableKeys(pub(crate) Vec<String>);

impl TableKeys {
    /// Key with a last part.
    pub(crate) fn find(&self, last: &str) -> Option<&str> {
        let key = self.0.iter().find(|key| key.rsplit('.').next() == Some(last));
        key.map(String::as_str)
    }

    /// Key of the table with the same last part, otherwise `key`. Keys of the model, the contact, the pose and the conditions belong to no
    /// question.
    pub(crate) fn own<'a>(&'a self, key: &'a str) -> &'a str {
        match key.rsplit_once('.') {
            Some(("model" | "contact" | "pose" | "conditions", _)) | None => key,
            // The file of positions of a search for extremes has the key `path`.
            Some((_, "input")) => self.find("input").or_else(|| self.find("path")).unwrap_or(key),
            Some((_, last)) => self.find(last).unwrap_or(key),
        }
    }
}

/// Part of a question: a flag on the command line, a key in a study file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Field {
    /// Named contact.
    At,
    /// Contact link.
    Link,
    /// Contact point.
    Point,
    /// Contact normal.
    Normal,
    /// Line that defines the normal.
    AlongLine,
    /// Axis of a moment.
    AboutAxis,
    /// Frame of point and normal.
    Frame,
    /// Other link.
    Against,
    /// Mass of a free body on the other side.
    AgainstMass,
    /// A driving joint.
    Set,
    /// Initial guess of a joint position.
    Guess,
    /// Travel that drives the pose.
    Travel,
    /// File of positions for the pose.
    Pose,
    /// Model file.
    Model,
    /// Mass of a link.
    LinkMass,
    /// Centre of mass of a link.
    LinkCom,
    /// Moments of inertia of a link.
    LinkInertia,
    /// Moved hardpoint.
    Move,
    /// Point of a motion ratio.
    RatioAt,
    /// Coefficients of friction for sticking, jamming and wedging.
    FrictionThresholds,
    /// Tolerances of the parts of a model.
    Tolerance,
    /// Number of samples.
    Samples,
    /// Locked joint.
    Lock,
    /// Held point.
    Hold,
    /// Base: fixed or floating root link.
    Base,
    /// Inertia of a rotor.
    Armature,
    /// The classical estimate.
    Estimate,
    /// Range of a sweep.
    Vary,
    /// File of positions of a sweep.
    Input,
    /// Ignored column.
    Ignore,
    /// Number of random rows.
    Random,
    /// Stop of a joint.
    Limit,
    /// The stiffness of a contact or a stop.
    Stiffness,
    /// Approach speed of a contact or a stop.
    Speed,
    /// Longest edge of a facet of a map.
    Edge,
    /// Number of directions of a map at a point.
    Directions,
    /// Link of a map.
    MapLink,
    /// Point of a map of directions.
    MapPoint,
    /// Direction of a safe speed.
    Direction,
    /// Coefficient of restitution of an impact.
    Restitution,
    /// Closing speed of an impact.
    ClosingSpeed,
    /// Stiffness of the contact of an impact.
    ImpactStiffness,
    /// Coefficient of friction of an impact.
    Friction,
    /// Law of restitution of an impact with friction.
    RestitutionLaw,
    /// Further contacts of an impact.
    Also,
    /// Plastic impact with sticking points.
    Sticking,
    /// Stiffness ratios of several contacts.
    StiffnessRatio,
    /// Exponent of the contact forces of several contacts.
    ContactExponent,
    /// Rates of driving joints before an impact.
    Rates,
    /// Velocity of a floating base before an impact.
    BaseTwist,
    /// Largest jump of a joint rate.
    RateLimit,
    /// Spring of a joint during an impact in time.
    JointSpring,
    /// Largest impulse in a gear.
    GearLimit,
    /// Largest displacement of the contact point.
    PointError,
    /// Quantity of a search for extremes.
    Quantity,
    /// Stiffness of the contact law of a peak force.
    ExtremesStiffness,
    /// Closing speed of a peak force.
    ExtremesSpeed,
    /// Range of a joint in a search for extremes.
    Range,
    /// Link or point that stays in place in a search for extremes.
    Keep,
    /// Path of a search for extremes.
    Path,
    /// Joint of a reflected inertia.
    Reflected,
    /// Joint of a centre of percussion.
    Percussion,
}

impl Field {
    /// Flag and study key.
    fn names(self) -> (&'static str, &'static str) {
        match self {
            Field::At => ("--at", "contact.at"),
            Field::Link => ("--link", "contact.link"),
            Field::Point => ("--point", "contact.point"),
            Field::Normal => ("--normal", "contact.normal"),
            Field::AlongLine => ("--along-line", "contact.along_line"),
            Field::AboutAxis => ("--about-axis", "contact.about_axis"),
            Field::Frame => ("--frame", "contact.frame"),
            Field::Against => ("--against", "contact.against"),
            Field::AgainstMass => ("--against-mass", "contact.against_mass"),
            Field::Set => ("--set", "pose.set"),
            Field::Guess => ("--guess", "pose.guess"),
            Field::Travel => ("--travel", "pose.travel"),
            Field::Pose => ("--pose", "pose.file"),
            Field::Model => ("MODEL", "model.path"),
            Field::LinkMass => ("--link-mass", "model.link_mass"),
            Field::LinkCom => ("--link-com", "model.link_com"),
            Field::LinkInertia => ("--link-inertia", "model.link_inertia"),
            Field::Move => ("--move", "model.move"),
            Field::RatioAt => ("--ratio-at", "contact.ratio_at"),
            Field::FrictionThresholds => ("--friction-thresholds", "mass.friction_thresholds"),
            Field::Tolerance => ("--tolerance", "mass.tolerance"),
            Field::Samples => ("--samples", "mass.samples"),
            Field::Lock => ("--lock", "conditions.lock"),
            Field::Hold => ("--hold", "hold"),
            Field::Base => ("--base", "conditions.base"),
            Field::Armature => ("--armature", "conditions.armature"),
            Field::Estimate => ("--estimate", "contact.estimate"),
            Field::Vary => ("--vary", "sweep.vary"),
            Field::Input => ("--input", "sweep.input"),
            Field::Ignore => ("--ignore", "sweep.ignore"),
            Field::Random => ("--random", "sweep.random"),
            Field::Limit => ("--limit", "damping.limit"),
            Field::Stiffness => ("--stiffness", "damping.stiffness"),
            Field::Speed => ("--speed", "damping.speed"),
            Field::Edge => ("--edge", "map.edge"),
            Field::Directions => ("--directions", "map.directions"),
            Field::MapLink => ("--link", "map.link"),
            Field::MapPoint => ("--point", "map.point"),
            Field::Direction => ("--direction", "safe_speed.direction"),
            Field::Restitution => ("--restitution", "impact.restitution"),
            Field::ClosingSpeed => ("--speed", "impact.speed"),
            Field::ImpactStiffness => ("--stiffness", "impact.stiffness"),
            Field::Friction => ("--friction", "impact.friction"),
            Field::RestitutionLaw => ("--restitution-law", "impact.restitution_law"),
            Field::Also => ("--also", "impact.also"),
            Field::Sticking => ("--sticking", "impact.sticking"),
            Field::ContactExponent => ("--contact-exponent", "impact.contact_exponent"),
            Field::StiffnessRatio => ("--stiffness-ratio", "impact.stiffness_ratio"),
            Field::Rates => ("--rates", "impact.rates"),
            Field::BaseTwist => ("--base-twist", "impact.base_twist"),
            Field::RateLimit => ("--rate-limit", "impact.rate_limit"),
            Field::JointSpring => ("--joint-spring", "impact.joint_spring"),
            Field::GearLimit => ("--gear-limit", "impact.gear_limit"),
            Field::PointError => ("--point-error", "impact.point_error"),
            Field::Quantity => ("--quantity", "extremes.quantity"),
            Field::ExtremesStiffness => ("--stiffness", "extremes.stiffness"),
            Field::ExtremesSpeed => ("--speed", "extremes.speed"),
            Field::Range => ("--range", "extremes.range"),
            Field::Keep => ("--keep", "extremes.keep"),
            Field::Path => ("--path", "extremes.path"),
            Field::Reflected => ("--reflected", "impact.reflected"),
            Field::Percussion => ("--percussion", "impact.percussion"),
        }
    }

    /// Flag on the command line.
    pub fn flag(self) -> &'static str {
        self.names().0
    }

    /// Key in a study file.
    pub fn key(self) -> &'static str {
        self.names().1
    }

    /// Name in the given set of names.
    pub fn name_in(self, names: Names) -> &'static str {
        match names {
            Names::Flags => self.flag(),
            Names::Keys(table) => table.map_or(self.key(), |table| table.own(self.key())),
            Names::Fields => self.key().rsplit('.').next().unwrap_or_default(),
        }
    }

    /// Hint ` (--flag)` or ` (key)` for the end of a message; empty for field names.
    pub(crate) fn hint(self, names: Names) -> String {
        match names {
            Names::Fields => String::new(),
            Names::Flags | Names::Keys(_) => format!(" ({})", self.name_in(names)),
        }
    }

    /// Part of the question at fault for a contact error.
    pub(crate) fn from_contact_error(error: &ContactError) -> Self {
        match error {
            ContactError::NotFinite { part, .. } | ContactError::NoDirection { part, .. } => match part {
                ContactPart::Point => Field::Point,
                ContactPart::Normal => Field::Normal,
                ContactPart::Axis => Field::AboutAxis,
                ContactPart::Line => Field::AlongLine,
            },
            ContactError::NoLine { .. }
            | ContactError::LineShort { .. }
            | ContactError::LineTurned { .. } => Field::AlongLine,
            ContactError::Itself { .. } => Field::Against,
            ContactError::OtherMass { .. } | ContactError::MassOfMoment { .. } => Field::AgainstMass,
            // Other errors concern handles of other mechanisms; a question by names has none.
            _ => Field::Link,
        }
    }

    /// Part of the question at fault for an error of the conditions. Names of links and joints are valid here: an unknown
    /// name is reported when the name is resolved.
    pub(crate) fn from_conditions_error(error: &ConditionsError) -> Self {
        match error {
            ConditionsError::BadHold { .. } => Field::Hold,
            ConditionsError::Twice { condition: ConditionOfJoint::Lock, .. } => Field::Lock,
            _ => Field::Armature,
        }
    }
}

/// Message for a contact error. For a rejected line the message ends with the flags or keys of the equivalent
/// fixed normal.
pub(crate) fn contact_error_message(error: &ContactError, names: Names) -> String {
    let (ContactError::LineShort { normal, frame, .. } | ContactError::LineTurned { normal, frame, .. }) =
        error
    else {
        return error.to_string();
    };
    let [x, y, z] = [normal.x, normal.y, normal.z].map(|x| (x * 1e6).round() / 1e6 + 0.0);
    let frame = if *frame == Frame::Against { "against" } else { "world" };
    let turns = matches!(error, ContactError::LineTurned { .. });
    match names {
        Names::Fields => error.to_string(),
        Names::Flags => {
            let turning = if turns { "; --turning-normal: the line may turn" } else { "" };
            format!("{error}: --normal {x},{y},{z} --normal-frame {frame}{turning}")
        }
        Names::Keys(_) => {
            let turning = if turns { "; turning_normal = true: the line may turn" } else { "" };
            format!("{error}: normal = [{x}, {y}, {z}], normal_frame = \"{frame}\"{turning}")
        }
    }
}

/// Message for an assembly error. If another start can help, the message ends with the flag or key of a guess.
pub(crate) fn assembly_error_message(error: &AssemblyError, names: Names) -> String {
    let given_with = match (names, error) {
        (Names::Fields, _) => String::new(),
        (Names::Flags, AssemblyError::DoesNotClose { .. }) => " with --guess JOINT=VALUE".into(),
        (Names::Flags | Names::Keys(_), _) => format!(" with {}", Field::Guess.name_in(names)),
    };
    let given_with = if error.ends_in_another_start() { given_with } else { String::new() };
    format!("{error}{given_with}")
}
