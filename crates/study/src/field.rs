//! The parts of a question, and what they are called where it is asked: flags, keys of a study file, fields in code.

use percuss_dynamics::{AssemblyError, ConditionOfJoint, ConditionsError, ContactError, ContactPart, Frame};

/// By what names messages call the parts of a question.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Names {
    /// As in code: where a fix needs no flag and no key, messages leave both out.
    #[default]
    Fields,
    /// The flags of the command line.
    Flags,
    /// The keys of a study file.
    Keys,
}

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
    /// A travel that drives the pose.
    Travel,
    /// A file of positions for the pose.
    Pose,
    /// The model's file.
    Model,
    /// A link's mass.
    LinkMass,
    /// A link's centre of mass.
    LinkCom,
    /// A hardpoint that is moved.
    Move,
    /// A point whose speed is asked for.
    RatioAt,
    /// How far off the parts of a model may be.
    Tolerance,
    /// How many samples are taken.
    Samples,
    /// A joint that is held.
    Lock,
    /// A point that is held.
    Hold,
    /// Whether the root link floats.
    Base,
    /// A rotor's inertia.
    Armature,
    /// The classical estimate.
    Estimate,
    /// What a sweep varies.
    Vary,
    /// The file of a sweep's positions.
    Input,
    /// A column that is left out.
    Ignore,
    /// How many random rows.
    Random,
    /// A joint's stop.
    Limit,
    /// The stiffness of a contact or a stop.
    Stiffness,
    /// Its approach speed.
    Speed,
    /// The longest edge of a facet of a map.
    Edge,
    /// How many directions of a map at a point.
    Directions,
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
            Field::Travel => ("--travel", "pose.travel"),
            Field::Pose => ("--pose", "pose.file"),
            Field::Model => ("MODEL", "model.path"),
            Field::LinkMass => ("--link-mass", "model.link_mass"),
            Field::LinkCom => ("--link-com", "model.link_com"),
            Field::Move => ("--move", "model.move"),
            Field::RatioAt => ("--ratio-at", "contact.ratio_at"),
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

    /// What it is called where the question is asked.
    pub fn named(self, names: Names) -> &'static str {
        match names {
            Names::Flags => self.flag(),
            Names::Keys => self.key(),
            Names::Fields => self.key().rsplit('.').next().unwrap_or_default(),
        }
    }

    /// ` (--flag)` or ` (key)` after what a message says of it; nothing in code.
    pub(crate) fn hint(self, names: Names) -> String {
        match names {
            Names::Fields => String::new(),
            Names::Flags | Names::Keys => format!(" ({})", self.named(names)),
        }
    }

    /// Which part of the question a contact's error is about.
    pub(crate) fn of_contact(error: &ContactError) -> Self {
        match error {
            ContactError::NotFinite { part, .. } => match part {
                ContactPart::Point => Field::Point,
                ContactPart::Normal => Field::Normal,
                ContactPart::Line => Field::AlongLine,
            },
            ContactError::NoNormal { .. } => Field::Normal,
            ContactError::NoLine { .. }
            | ContactError::LineShort { .. }
            | ContactError::LineTurned { .. } => Field::AlongLine,
            ContactError::Itself { .. } => Field::Against,
            ContactError::OtherMass { .. } => Field::AgainstMass,
            // Handles of other mechanisms, which a question by names does not have.
            _ => Field::Link,
        }
    }

    /// Which part of the question a condition's error is about, where its name was known.
    pub(crate) fn of_condition(error: &ConditionsError) -> Self {
        match error {
            ConditionsError::BadHold { .. } => Field::Hold,
            ConditionsError::Twice { condition: ConditionOfJoint::Lock, .. } => Field::Lock,
            _ => Field::Armature,
        }
    }
}

/// What is wrong with a contact; with the flags or keys of a fixed normal, where a line is none.
pub(crate) fn about_contact(error: &ContactError, names: Names) -> String {
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
        Names::Keys => {
            let turning = if turns { "; turning_normal = true: the line may turn" } else { "" };
            format!("{error}: normal = [{x}, {y}, {z}], normal_frame = \"{frame}\"{turning}")
        }
    }
}

/// Why loops do not close, with the name of what gives them another start.
pub(crate) fn about_assembly(error: &AssemblyError, names: Names) -> String {
    let given_with = match (names, error) {
        (Names::Fields, _) => String::new(),
        (Names::Flags, AssemblyError::DoesNotClose { .. }) => " with --guess JOINT=VALUE".into(),
        (Names::Flags | Names::Keys, _) => format!(" with {}", Field::Guess.named(names)),
    };
    let given_with = if error.ends_in_another_start() { given_with } else { String::new() };
    format!("{error}{given_with}")
}
