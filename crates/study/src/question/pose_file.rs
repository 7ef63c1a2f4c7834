//! Joint positions from a file: the JSON of a result, or an object of joints and positions.

use crate::model::loading::{Input, Model, hexadecimal};
use crate::question::names::Names;
use crate::values::message_text::truncate_for_message;
use crate::values::position::GivenPosition;

use crate::values::value;
use percuss_dynamics::Pose;
use percuss_dynamics::input::base_pose;
use percuss_formats::Source;
use percuss_mechanism::{Joint, JointId, Mechanism};
use percuss_spatial::Transform;
use percuss_units::QuantityError;
use serde::de::{Error, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use serde_json::Value;
use sha2::{Digest, Sha256};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// Positions of joints from a file.
#[derive(Clone, Debug, PartialEq)]
pub struct GivenPose {
    /// Pose file.
    pub input: Input,
    /// Position by joint name.
    pub(crate) positions: BTreeMap<String, GivenPosition>,
    /// Model of the result in the file; `None` for an object of joints and positions.
    source_model: Option<Input>,
    /// Name of a pose of the model, until the model is known; then `positions` is empty.
    name: Option<String>,
    /// X_wr: pose of the root link in the world.
    pub(crate) base: Transform<f64>,
}

/// Error of an invalid pose file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum GivenPoseError {
    /// Unreadable file.
    #[error("{message}")]
    Unreadable {
        /// Name of the file and reason.
        message: String,
    },
    /// Text that is not valid JSON.
    #[error("{path}:{line}: not JSON ({message}); expected the output of --format json, or {EXAMPLE}")]
    NotJson {
        /// Path of the file.
        path: String,
        /// Line of the error, from 1.
        line: usize,
        /// Message of the parser.
        message: String,
    },
    /// JSON without joint positions.
    #[error("{path}: {got}; expected the output of percuss mass --format json, or {EXAMPLE}")]
    NoPositions {
        /// Path of the file.
        path: String,
        /// Content of the file.
        got: String,
    },
    /// No pose of this name, and no file.
    #[error(
        "\"{name}\" is no file, and no pose of the model, which has {known}; expected a JSON file or the name of a pose"
    )]
    UnknownName {
        /// Name as given.
        name: String,
        /// Names of the poses of the model.
        known: String,
    },
    /// Invalid position.
    #[error("{path}: {message}")]
    Position {
        /// Path of the file.
        path: String,
        /// Joint and reason.
        message: String,
    },
    /// Result for another model: the file names a joint that is missing in this model.
    #[error(
        "{path}: this pose belongs to another model ({of}): joint \"{joint}\" is not in this one, which has \
         {known}; expected a \
         pose of this model"
    )]
    OtherJoint {
        /// Path of the file.
        path: String,
        /// Model file of the result.
        of: String,
        /// Name of the joint.
        joint: String,
        /// First movable joints of this model.
        known: String,
    },
    /// Result for another model: the file has no position for a joint of this model.
    #[error(
        "{path}: this pose belongs to another model ({of}): it has no joint \"{joint}\"; expected a pose of \
         this model"
    )]
    MissingJoint {
        /// Path of the file.
        path: String,
        /// Model file of the result.
        of: String,
        /// Name of the joint.
        joint: String,
    },
}

/// Example of joints and positions for error messages.
const EXAMPLE: &str = "joints and positions such as {\"elbow\": 0.5, \"wrist\": \"30deg\"}";
/// Largest number of joints listed in an error.
const MAX_LISTED_JOINTS: usize = 6;

/// Content of a report in JSON that is read as a pose.
#[derive(Deserialize)]
struct ReportText {
    #[serde(deserialize_with = "value::positions")]
    pose: Vec<(String, GivenPosition)>,
    #[serde(default)]
    inputs: Vec<InputRecordText>,
    #[serde(default)]
    conditions: ConditionsText,
}

#[derive(Default, Deserialize)]
struct ConditionsText {
    #[serde(default)]
    base_pose: Option<[f64; 7]>,
}

#[derive(Deserialize)]
struct InputRecordText {
    path: String,
    sha256: String,
}

#[derive(Deserialize)]
struct JointPositionsText(#[serde(deserialize_with = "value::positions")] Vec<(String, GivenPosition)>);

/// Check that no JSON object repeats a key. The parser would keep the last value of a repeated key without a message.
pub(crate) struct UniqueKeys;

impl<'de> Deserialize<'de> for UniqueKeys {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_any(Self)
    }
}

impl<'de> Visitor<'de> for UniqueKeys {
    type Value = Self;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("JSON")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self, A::Error> {
        let mut keys = BTreeSet::new();
        while let Some(key) = map.next_key::<String>()? {
            let UniqueKeys = map.next_value()?;
            if let Some(key) = keys.replace(key) {
                return Err(A::Error::custom(format!(
                    "the key \"{}\" is given twice",
                    truncate_for_message(&key)
                )));
            }
        }
        Ok(self)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Self, A::Error> {
        while let Some(UniqueKeys) = list.next_element()? {}
        Ok(self)
    }

    fn visit_unit<E>(self) -> Result<Self, E> {
        Ok(self)
    }

    fn visit_bool<E>(self, _: bool) -> Result<Self, E> {
        Ok(self)
    }

    fn visit_i64<E>(self, _: i64) -> Result<Self, E> {
        Ok(self)
    }

    fn visit_u64<E>(self, _: u64) -> Result<Self, E> {
        Ok(self)
    }

    fn visit_f64<E>(self, _: f64) -> Result<Self, E> {
        Ok(self)
    }

    fn visit_str<E>(self, _: &str) -> Result<Self, E> {
        Ok(self)
    }
}

/// True for a movable joint that is no mimic.
fn is_free(joint: &Joint) -> bool {
    joint.kind().dofs() > 0 && joint.mimic().is_none()
}

impl GivenPose {
    /// Positions of a pose, without a file. `source_model`: file of the model of the pose, if known; another file than that of the question is a
    /// finding.
    ///
    /// # Errors
    /// A position that is no finite number.
    pub fn from_pose(pose: &Pose, source_model: Option<Input>) -> Result<Self, QuantityError> {
        let mechanism = pose.mechanism();
        let free = |id: &JointId| is_free(mechanism.joint(*id));
        let position = |id: JointId| {
            let position = GivenPosition::from_numbers(pose.joint(id))?;
            Ok((mechanism.joint(id).name().to_owned(), position))
        };
        let positions = mechanism.joint_ids().filter(free).map(position).collect::<Result<_, _>>()?;
        let input = Input { path: "the pose".to_owned(), sha256: String::new() };
        Ok(Self { input, positions, source_model, name: None, base: *pose.base() })
    }

    /// Reads a file of at most `max_size` bytes: the `pose` of a JSON result, or an object with a position (a number, a
    /// list, text with units) for each joint. `-` is the standard input.
    ///
    /// # Errors
    /// [`GivenPoseError`]: unreadable file, invalid JSON, no positions, or an invalid position.
    pub fn read(path: &str, max_size: u64) -> Result<Self, GivenPoseError> {
        Self::read_as(path, path, max_size)
    }

    /// Reads the file `path`, as [`read`](Self::read). If there is no such file and the text `given` has no folder and no ending .json,
    /// it is the name of a pose of the model.
    ///
    /// # Errors
    /// As for [`read`](Self::read).
    pub(crate) fn read_as(path: &str, given: &str, max_size: u64) -> Result<Self, GivenPoseError> {
        let is_name = given != "-" && !given.ends_with(".json") && !given.contains(['/', '\\']);
        if is_name && !std::path::Path::new(path).exists() {
            let input = Input { path: given.to_owned(), sha256: String::new() };
            return Ok(Self {
                input,
                positions: BTreeMap::new(),
                source_model: None,
                name: Some(given.to_owned()),
                base: Transform::identity(),
            });
        }
        let source = Source::read(path, max_size)
            .map_err(|error| GivenPoseError::Unreadable { message: error.to_string() })?;
        let path = source.name.clone();
        let bytes = source.bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(&source.bytes);
        let not_json = |error: serde_json::Error| GivenPoseError::NotJson {
            path: path.clone(),
            line: error.line(),
            message: error.to_string(),
        };
        let value: Value = serde_json::from_slice(bytes).map_err(not_json)?;
        let UniqueKeys = serde_json::from_slice(bytes).map_err(not_json)?;
        let none = |got: &str| GivenPoseError::NoPositions { path: path.clone(), got: got.to_owned() };
        let wrong = |error: serde_json::Error| GivenPoseError::Position {
            path: path.clone(),
            message: error.to_string(),
        };
        let Value::Object(object) = &value else {
            return Err(none("no JSON object"));
        };
        let mut base = Transform::identity();
        let (positions, of_model) = match object.get("pose") {
            Some(Value::Object(_)) => {
                let ReportText { pose, inputs, conditions } =
                    ReportText::deserialize(&value).map_err(wrong)?;
                if let Some([x, y, z, quaternion @ ..]) = conditions.base_pose {
                    base = base_pose([x, y, z], quaternion).map_err(|error| GivenPoseError::Position {
                        path: path.clone(),
                        message: format!("conditions.base_pose: {error}"),
                    })?;
                }
                let model = inputs.into_iter().next();
                (pose, Some(model.map_or_else(unknown, |i| Input { path: i.path, sha256: i.sha256 })))
            }
            _ if object.contains_key("rows") => {
                return Err(none("it is a sweep with many poses"));
            }
            _ if object.contains_key("schema") => return Err(none("it has no \"pose\"")),
            _ => (JointPositionsText::deserialize(&value).map_err(wrong)?.0, None),
        };
        if positions.is_empty() {
            return Err(none("it names no joint"));
        }
        let sha256 = hexadecimal(&Sha256::digest(&source.bytes));
        let positions = positions.into_iter().collect();
        Ok(Self { input: Input { path, sha256 }, positions, source_model: of_model, name: None, base })
    }

    /// The pose with the positions of a model's pose, if it is given by name.
    pub(crate) fn resolve(&self, model: &Model) -> Result<Option<Self>, GivenPoseError> {
        let Some(name) = &self.name else { return Ok(None) };
        let Some(pose) = model.poses.iter().find(|pose| pose.name == *name) else {
            let names: Vec<String> =
                model.poses.iter().take(MAX_LISTED_JOINTS).map(|pose| format!("\"{}\"", pose.name)).collect();
            let known = match (names.is_empty(), model.poses.len() > names.len()) {
                (true, _) => "none".to_owned(),
                (false, false) => names.join(", "),
                (false, true) => format!("{} and others", names.join(", ")),
            };
            return Err(GivenPoseError::UnknownName { name: truncate_for_message(name).into_owned(), known });
        };
        let position = |(joint, values): &(String, Vec<f64>)| {
            let given = GivenPosition::from_numbers(values).map_err(|error| GivenPoseError::Position {
                path: name.clone(),
                message: format!("joint \"{joint}\": {error}"),
            })?;
            Ok((joint.clone(), given))
        };
        let positions = pose.positions.iter().map(position).collect::<Result<_, GivenPoseError>>()?;
        Ok(Some(Self { positions, ..self.clone() }))
    }

    /// File of the pose; `None` for a pose of the model.
    pub(crate) fn file(&self) -> Option<&Input> {
        (!self.input.sha256.is_empty()).then_some(&self.input)
    }

    /// True if every movable joint that is no mimic has a position.
    pub(crate) fn is_complete(&self, mechanism: &Mechanism) -> bool {
        self.missing(mechanism).is_none()
    }

    /// First movable joint without a position.
    fn missing<'m>(&self, mechanism: &'m Mechanism) -> Option<&'m Joint> {
        let is_missing = |joint: &&Joint| is_free(joint) && !self.positions.contains_key(joint.name());
        mechanism.joints().iter().find(is_missing)
    }

    /// Refuses a result for another model. An object of joints and positions is not checked here.
    pub(crate) fn check(&self, mechanism: &Mechanism) -> Result<(), GivenPoseError> {
        let Some(model) = &self.source_model else { return Ok(()) };
        let (path, of) = (self.input.path.clone(), model.path.clone());
        if let Some(other) = self.positions.keys().find(|name| mechanism.find_joint(name).is_err()) {
            let movable = mechanism.joints().iter().filter(|joint| joint.kind().dofs() > 0);
            let mut known: Vec<String> = movable
                .clone()
                .take(MAX_LISTED_JOINTS)
                .map(|joint| format!("\"{}\"", joint.name()))
                .collect();
            if movable.count() > MAX_LISTED_JOINTS {
                known.push("others".to_owned());
            }
            let known = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
            return Err(GivenPoseError::OtherJoint { path, of, joint: other.clone(), known });
        }
        match self.missing(mechanism) {
            Some(joint) => Err(GivenPoseError::MissingJoint { path, of, joint: joint.name().to_owned() }),
            None => Ok(()),
        }
    }

    /// Remark on a pose file that was computed from a different version of the model file.
    pub(crate) fn model_mismatch_message(&self, model: &Model, names: Names) -> Option<String> {
        let of = self.source_model.as_ref()?;
        let own = model.inputs.first()?;
        if of.sha256 == own.sha256 {
            return None;
        }
        let given = names.hint("pose.file");
        let file =
            if self.input.sha256.is_empty() { String::new() } else { format!(" in {}", self.input.path) };
        Some(format!(
            "the pose{given}{file} was computed for {}, not for the present {}: the joints have the same names, \
             and the loops were closed again",
            of.path, own.path
        ))
    }
}

/// Input record of a pose whose file is not named.
fn unknown() -> Input {
    Input { path: "not named".to_owned(), sha256: String::new() }
}
