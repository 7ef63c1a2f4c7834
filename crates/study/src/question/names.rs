//! Names of the keys of a study in messages: command-line flags, keys, or field names in code.

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

/// Flag of a key.
pub(crate) fn flag(key: &str) -> String {
    match key {
        "pose.file" => "--pose".to_owned(),
        "model.path" => "MODEL".to_owned(),
        "identify.data" => "the data".to_owned(),
        _ => format!("--{}", last_part(key).replace('_', "-")),
    }
}

/// Key without its table.
pub(crate) fn last_part(key: &str) -> &str {
    key.rsplit('.').next().unwrap_or_default()
}

impl Names {
    /// Name of a key of a study.
    pub(crate) fn name_of(self, key: &str) -> String {
        match self {
            Names::Flags => flag(key),
            Names::Keys(table) => table.map_or(key, |table| table.own(key)).to_owned(),
            Names::Fields => last_part(key).to_owned(),
        }
    }

    /// Hint ` (--flag)` or ` (key)` for the end of a message; empty for field names.
    pub(crate) fn hint(self, key: &str) -> String {
        match self {
            Names::Fields => String::new(),
            Names::Flags | Names::Keys(_) => format!(" ({})", self.name_of(key)),
        }
    }
}

/// Key at fault for a contact error.
pub(crate) fn contact_error_key(error: &ContactError) -> &'static str {
    match error {
        ContactError::NotFinite { part, .. } | ContactError::NoDirection { part, .. } => match part {
            ContactPart::Point => "contact.point",
            ContactPart::Normal => "contact.normal",
            ContactPart::Axis => "contact.about_axis",
            ContactPart::Line => "contact.along_line",
        },
        ContactError::NoLine { .. } | ContactError::LineShort { .. } | ContactError::LineTurned { .. } => {
            "contact.along_line"
        }
        ContactError::Itself { .. } => "contact.against",
        ContactError::OtherMass { .. } | ContactError::MassOfMoment { .. } => "contact.against_mass",
        // Other errors concern handles of other mechanisms; a question by names has none.
        _ => "contact.link",
    }
}

/// Key at fault for an error of the conditions. Names of links and joints are valid here: an unknown name is reported when the name is
/// resolved.
pub(crate) fn conditions_error_key(error: &ConditionsError) -> &'static str {
    match error {
        ConditionsError::BadHold { .. } => "hold",
        ConditionsError::Twice { condition: ConditionOfJoint::Lock, .. } => "conditions.lock",
        _ => "conditions.armature",
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
        (Names::Flags | Names::Keys(_), _) => format!(" with {}", names.name_of("pose.guess")),
    };
    let given_with = if error.ends_in_another_start() { given_with } else { String::new() };
    format!("{error}{given_with}")
}
