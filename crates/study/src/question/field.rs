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

/// Declares the fields, each with its flag and its study key.
macro_rules! fields {
    ($($(#[$doc:meta])* $name:ident = $flag:literal, $key:literal;)*) => {
        /// Part of a question: a flag on the command line, a key in a study file.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Field {
            $($(#[$doc])* $name,)*
        }

        impl Field {
            /// Flag and study key.
            fn names(self) -> (&'static str, &'static str) {
                match self {
                    $(Field::$name => ($flag, $key),)*
                }
            }
        }
    };
}

fields! {
    /// Named contact.
    At = "--at", "contact.at";
    /// Contact link.
    Link = "--link", "contact.link";
    /// Contact point.
    Point = "--point", "contact.point";
    /// Contact normal.
    Normal = "--normal", "contact.normal";
    /// Line that defines the normal.
    AlongLine = "--along-line", "contact.along_line";
    /// Axis of a moment.
    AboutAxis = "--about-axis", "contact.about_axis";
    /// Frame of point and normal.
    Frame = "--frame", "contact.frame";
    /// Other link.
    Against = "--against", "contact.against";
    /// Mass of a free body on the other side.
    AgainstMass = "--against-mass", "contact.against_mass";
    /// A driving joint.
    Set = "--set", "pose.set";
    /// Initial guess of a joint position.
    Guess = "--guess", "pose.guess";
    /// Travel that drives the pose.
    Travel = "--travel", "pose.travel";
    /// File of positions for the pose.
    Pose = "--pose", "pose.file";
    /// Model file.
    Model = "MODEL", "model.path";
    /// Masses from the shapes.
    Masses = "--masses", "model.masses";
    /// Mass of all links.
    TotalMass = "--total-mass", "model.total_mass";
    /// Mass of a link.
    LinkMass = "--link-mass", "model.link_mass";
    /// Centre of mass of a link.
    LinkCom = "--link-com", "model.link_com";
    /// Moments of inertia of a link.
    LinkInertia = "--link-inertia", "model.link_inertia";
    /// Moved hardpoint.
    Move = "--move", "model.move";
    /// Point of a motion ratio.
    RatioAt = "--ratio-at", "contact.ratio_at";
    /// Coefficients of friction for sticking, jamming and wedging.
    FrictionThresholds = "--friction-thresholds", "mass.friction_thresholds";
    /// Tolerances of the parts of a model.
    Tolerance = "--tolerance", "mass.tolerance";
    /// Number of samples.
    Samples = "--samples", "mass.samples";
    /// Locked joint.
    Lock = "--lock", "conditions.lock";
    /// Held point.
    Hold = "--hold", "hold";
    /// Base: fixed or floating root link.
    Base = "--base", "conditions.base";
    /// Inertia of a rotor.
    Armature = "--armature", "conditions.armature";
    /// Stiffness of a gear.
    GearStiffness = "--gear-stiffness", "conditions.gear_stiffness";
    /// The classical estimate.
    Estimate = "--estimate", "contact.estimate";
    /// Range of a sweep.
    Vary = "--vary", "sweep.vary";
    /// File of positions of a sweep.
    Input = "--input", "sweep.input";
    /// Ignored column.
    Ignore = "--ignore", "sweep.ignore";
    /// Number of random rows.
    Random = "--random", "sweep.random";
    /// Stop of a joint.
    Limit = "--limit", "damping.limit";
    /// The stiffness of a contact or a stop.
    Stiffness = "--stiffness", "damping.stiffness";
    /// Approach speed of a contact or a stop.
    Speed = "--speed", "damping.speed";
    /// Files of measured impacts.
    Data = "the data", "identify.data";
    /// Longest edge of a facet of a map.
    Edge = "--edge", "map.edge";
    /// Number of directions of a map at a point.
    Directions = "--directions", "map.directions";
    /// Link of a map.
    MapLink = "--link", "map.link";
    /// Point of a map of directions.
    MapPoint = "--point", "map.point";
    /// Direction of a safe speed.
    Direction = "--direction", "safe_speed.direction";
    /// Coefficient of restitution of an impact.
    Restitution = "--restitution", "impact.restitution";
    /// Damping of the contact of an impact.
    ImpactDamping = "--damping", "impact.damping";
    /// Dissipation of the contact of an impact.
    ImpactDissipation = "--hunt-crossley", "impact.hunt_crossley";
    /// Loss factor of the contact of an impact.
    ImpactLossFactor = "--loss-factor", "impact.loss_factor";
    /// Closing speed of an impact.
    ClosingSpeed = "--speed", "impact.speed";
    /// Stiffness of the contact of an impact.
    ImpactStiffness = "--stiffness", "impact.stiffness";
    /// Coefficient of friction of an impact.
    Friction = "--friction", "impact.friction";
    /// Law of restitution of an impact with friction.
    RestitutionLaw = "--restitution-law", "impact.restitution_law";
    /// Further contacts of an impact.
    Also = "--also", "impact.also";
    /// Plastic impact with sticking points.
    Sticking = "--sticking", "impact.sticking";
    /// Stiffness ratios of several contacts.
    StiffnessRatio = "--stiffness-ratio", "impact.stiffness_ratio";
    /// Exponent of the contact forces of several contacts.
    ContactExponent = "--contact-exponent", "impact.contact_exponent";
    /// Rates of driving joints before an impact.
    Rates = "--rates", "impact.rates";
    /// Velocity of a floating base before an impact.
    BaseTwist = "--base-twist", "impact.base_twist";
    /// Largest jump of a joint rate.
    RateLimit = "--rate-limit", "impact.rate_limit";
    /// Spring of a joint during an impact in time.
    JointSpring = "--joint-spring", "impact.joint_spring";
    /// Spring between points during an impact in time.
    PointSpring = "--spring", "impact.spring";
    /// Damper between points during an impact in time.
    PointDamper = "--damper", "impact.damper";
    /// Drive during an impact in time.
    Drive = "--drive", "impact.drive";
    /// Springs of the sheet during an impact in time.
    SheetSprings = "--springs", "impact.springs";
    /// Largest impulse in a gear.
    GearLimit = "--gear-limit", "impact.gear_limit";
    /// Largest displacement of the contact point.
    PointError = "--point-error", "impact.point_error";
    /// Quantity of a search for extremes.
    Quantity = "--quantity", "extremes.quantity";
    /// Stiffness of the contact law of a peak force.
    ExtremesStiffness = "--stiffness", "extremes.stiffness";
    /// Closing speed of a peak force.
    ExtremesSpeed = "--speed", "extremes.speed";
    /// Range of a joint in a search for extremes.
    Range = "--range", "extremes.range";
    /// Link or point that stays in place in a search for extremes.
    Keep = "--keep", "extremes.keep";
    /// Path of a search for extremes.
    Path = "--path", "extremes.path";
    /// Joint of a reflected inertia.
    Reflected = "--reflected", "impact.reflected";
    /// Joint of a centre of percussion.
    Percussion = "--percussion", "impact.percussion";
}

impl Field {
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
