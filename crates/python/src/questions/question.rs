//! Questions of the study crate, from the tables of a study as JSON.

use crate::analysis::contact::GivenContact;
use crate::analysis::pose::Pose;
use crate::conversion::errors::{input, of_argument};
use percuss::study::{
    ConditionsTable, ContactTable, DampingQuestion, ExtremesQuestion, GivenPose, Hold, ImpactQuestion,
    InvalidKey, MapQuestion, MassOptions, MassQuestion, Names, PoseTable, RowSource, SafeSpeedQuestion,
    SweepQuestion, VehicleData,
};
use percuss::{DEFAULT_MAX_SIZE, Mechanism};
use pyo3::prelude::*;
use pyo3::types::PyAny;
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use std::path::Path;

/// Tables of a study that `percuss._request` writes.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Tables {
    contact: ContactTable,
    pose: PoseTable,
    conditions: ConditionsTable,
    hold: Vec<Hold>,
    damping: DampingQuestion,
    /// True if loops bind the contact link; `None` if unknown, for a mass alone.
    closed_loops: Option<bool>,
    sweep: Option<SweepQuestion>,
    pub mass: MassOptions,
    pub impact: ImpactQuestion,
    pub extremes: ExtremesQuestion,
    pub map: MapQuestion,
    pub safe_speed: SafeSpeedQuestion,
    pub vehicle: VehicleData,
}

/// Names of the arguments for keys with another name.
const ARGUMENTS: [(&str, &str); 10] = [
    ("at", "contact"),
    ("limit", "joint"),
    ("for", "tools"),
    ("file", "pose"),
    ("links", "estimate"),
    ("range", "ranges"),
    ("path", "vary or input"),
    ("direction", "directions"),
    ("package", "packages"),
    ("link", "links"),
];

/// Conversion for `map_err` that names the argument of a key.
fn of_key(key: &str) -> impl Fn(PyErr) -> PyErr {
    let name = key.rsplit('.').next().unwrap_or(key);
    of_argument(ARGUMENTS.iter().find(|(key, _)| *key == name).map_or(name, |(_, argument)| argument))
}

/// `InputError` that names the argument of an invalid key.
pub fn invalid(error: InvalidKey) -> PyErr {
    let reason = input(error.reason(Names::Fields));
    if error.key.contains('.') { of_key(error.key)(reason) } else { reason }
}

/// Reads tables from JSON. The error names the first key that is refused by itself.
fn read<T: DeserializeOwned>(text: &str) -> PyResult<T> {
    let all: Value = serde_json::from_str(text).map_err(input)?;
    let whole = match T::deserialize(&all) {
        Ok(tables) => return Ok(tables),
        Err(error) => input(error),
    };
    for (table, keys) in all.as_object().into_iter().flatten() {
        let parts: Vec<(&String, Value)> = match keys.as_object() {
            Some(keys) => keys.iter().map(|(key, value)| (key, json!({ key: value }))).collect(),
            None => vec![(table, keys.clone())],
        };
        for (key, part) in parts {
            if let Err(error) = T::deserialize(&json!({ table: part })) {
                return Err(of_key(key)(input(error)));
            }
        }
    }
    Err(whole)
}

/// Question: tables of a study as JSON; a contact, and a pose of the model, if given as objects.
pub struct Request<'py> {
    pub tables: Tables,
    contact: Option<GivenContact<'py>>,
    pose: Option<Bound<'py, Pose>>,
}

impl<'py> FromPyObject<'_, 'py> for Request<'py> {
    type Error = PyErr;
    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        let (tables, contact, pose): (String, _, _) = given.extract()?;
        Ok(Self { tables: read(&tables)?, contact, pose })
    }
}

/// Positions of all joints of a pose.
fn positions_of(pose: &Bound<'_, Pose>) -> PyResult<GivenPose> {
    let Pose { model, pose, .. } = pose.get();
    GivenPose::from_pose(pose, model.read.inputs.first().cloned()).map_err(input).map_err(of_argument("pose"))
}

impl Request<'_> {
    /// Mass question for the contact, if given, of the mechanism.
    pub fn question(&self, mechanism: &Mechanism) -> PyResult<MassQuestion> {
        let Tables { contact, pose, conditions, hold, .. } = &self.tables;
        let mut contact = contact.clone();
        if let Some(GivenContact::Named(name)) = &self.contact {
            contact.at = Some(name.clone());
        }
        let question = MassQuestion::of_tables(&contact, pose, conditions, hold, Names::Fields);
        let mut question = question.checked(Path::new(""), DEFAULT_MAX_SIZE).map_err(invalid)?;
        if let Some(pose) = &self.pose {
            question.positions = Some(positions_of(pose)?);
        }
        let Some(GivenContact::Contact(given)) = &self.contact else { return Ok(question) };
        let resolved = given.get().resolve(mechanism)?;
        if resolved.against.is_some() && question.contact.against_mass.is_some() {
            return Err(input("give one of against and against_mass"));
        }
        let contact = question.contact.with_contact(&resolved, mechanism);
        Ok(MassQuestion { contact, ..question })
    }

    /// Damper; `None` if no damper is given.
    pub fn damper(&self) -> PyResult<Option<DampingQuestion>> {
        let Some(mut question) = self.tables.damping.checked().map_err(invalid)?.cloned() else {
            return Ok(None);
        };
        let (options, closed_loops) = (&mut question.options, self.tables.closed_loops);
        options.loops_unknown = closed_loops.is_none();
        options.closed_loops = closed_loops.unwrap_or_default();
        options.constrained = options.closed_loops;
        Ok(Some(question))
    }

    /// Damper that must be given.
    pub fn damping(&self) -> PyResult<DampingQuestion> {
        self.damper()?.ok_or_else(|| input("damping: it is missing"))
    }

    /// Source of the rows of a sweep; `None` if no source is given.
    pub fn rows(&self) -> PyResult<Option<RowSource>> {
        let source =
            |sweep: &SweepQuestion| Ok(sweep.checked(Vec::new(), Path::new(""), DEFAULT_MAX_SIZE)?.rows());
        self.tables.sweep.as_ref().map(source).transpose().map_err(invalid)
    }

    /// True if the gradient of each row is requested.
    pub fn has_gradient(&self) -> bool {
        self.tables.sweep.as_ref().is_some_and(|sweep| sweep.gradient)
    }
}
