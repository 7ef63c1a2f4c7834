//! Requests about a model in memory: the tables of a study as JSON.

use crate::model::loading::Model;
use crate::question::pose_file::UniqueKeys;
use crate::study_file::answer::{AskError, RequestReport};
use crate::study_file::file::{StudyFile, StudyFileError};
use crate::study_file::schema::study_keys;
use crate::thresholds::LARGEST_STUDY;
use percuss_formats::{DEFAULT_MAX_SIZE, Source};
use serde_json::Value;

/// Name of a request in messages, and of its model in a comparison without `[model] name`.
const REQUEST: &str = "request";

/// Results of a request about a model. The request is a JSON object with the tables of a study (`percuss schema`); the table `model` may
/// have changes of the model, but no path. Paths are relative to the working directory. Nothing is written to files.
///
/// # Errors
/// [`AskError`]: invalid JSON, an unknown key, an invalid value, a key without an effect on a report, or an error of a table.
///
/// # Examples
/// ```
/// # use percuss_study::{Model, ask};
/// # use percuss_formats::{DEFAULT_MAX_SIZE, LoadOptions};
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../models/point_mass_pendulum.urdf");
/// let model = Model::load(path, DEFAULT_MAX_SIZE, &LoadOptions::default())?;
/// let report = ask(&model, r#"{"contact": {"link": "rod", "point": [0, 0, -0.8], "normal": [1, 0, 0]}}"#)?;
/// let mass = report.mass.and_then(|mass| mass.effective_mass).unwrap_or_default();
/// assert!((mass / 0.78125 - 1.0).abs() < 1e-15);
/// # Ok(())
/// # }
/// ```
pub fn ask(model: &Model, request: &str) -> Result<RequestReport, AskError> {
    read_request(model, request)?.ask()
}

/// Study of a request.
fn read_request(model: &Model, request: &str) -> Result<StudyFile, StudyFileError> {
    let refuse = |key: &str, why: String| {
        Err(StudyFileError::Value { path: REQUEST.to_owned(), line: None, key: key.to_owned(), why })
    };
    if request.len() as u64 > LARGEST_STUDY {
        return refuse(REQUEST, format!("{} bytes; at most {LARGEST_STUDY} are read", request.len()));
    }
    let read =
        serde_json::from_str::<UniqueKeys>(request).and_then(|UniqueKeys| serde_json::from_str(request));
    let mut value: Value = match read {
        Ok(value) => value,
        Err(error) => return refuse(REQUEST, format!("not JSON: {error}")),
    };
    remove_nulls(&mut value, 2);
    if let Some(key) = null_in(&value) {
        return refuse(&key, "null is no value here; remove it".to_owned());
    }
    let Some(tables) = value.as_object_mut() else {
        return refuse(REQUEST, "a JSON object with the tables of a study is expected".to_owned());
    };
    let keys = study_keys();
    let outputs = keys.iter().filter(|key| key.ends_with(".output")).map(|key| (key.as_str(), NO_FILE));
    for (key, why) in NOT_IN_REQUESTS.into_iter().chain(outputs) {
        let mut steps = key.split('.');
        let table = tables.get(steps.next().unwrap_or_default());
        if table.is_some_and(|table| steps.next().is_none_or(|last| table.get(last).is_some())) {
            return refuse(key, format!("{why}; remove this key"));
        }
    }
    let changes = tables.entry("model").or_insert_with(|| Value::Object(serde_json::Map::new()));
    if let Some(changes) = changes.as_object_mut() {
        changes.insert("path".to_owned(), Value::String(String::new()));
    }
    let text = match toml::to_string(&value) {
        Ok(text) => text,
        Err(error) => return refuse(REQUEST, error.to_string()),
    };
    let source = Source::new(REQUEST, text.clone().into_bytes());
    StudyFile::from_text(REQUEST.to_owned(), &text, &source, Some(model), DEFAULT_MAX_SIZE)
        .map_err(without_lines)
}

const READ: &str = "the model of a request is already read";
const NO_FILE: &str = "a request writes no file: the result is in the report";
const NO_FORMAT: &str = "the numbers of a report are in SI units";

/// Keys and tables of a study that have no effect on a report, with the reason.
const NOT_IN_REQUESTS: [(&str, &str); 12] = [
    ("model.path", READ),
    ("model.worksheet", READ),
    ("model.accept", READ),
    ("sweep.unit", NO_FORMAT),
    ("sweep.decimal", NO_FORMAT),
    ("map.unit", NO_FORMAT),
    ("map.decimal", NO_FORMAT),
    ("sweep.title", NO_FILE),
    ("sweep.x_limits", NO_FILE),
    ("sweep.y_limits", NO_FILE),
    ("mass.expect", "a report compares no masses: compare mass.effective_mass"),
    ("report", "a request has no page"),
];

/// Removes tables and keys with the value null, which TOML does not have; `depth`: 2 for the tables.
fn remove_nulls(value: &mut Value, depth: usize) {
    match value {
        Value::Object(table) if depth > 0 => {
            table.retain(|_, value| !value.is_null());
            table.values_mut().for_each(|value| remove_nulls(value, depth - 1));
        }
        // Several tables of one name.
        Value::Array(list) if depth == 1 => list.iter_mut().for_each(|value| remove_nulls(value, depth)),
        _ => {}
    }
}

/// Key whose value contains null.
fn null_in(value: &Value) -> Option<String> {
    match value {
        Value::Null => Some(String::new()),
        Value::Array(list) => list.iter().find_map(null_in),
        Value::Object(table) => table.iter().find_map(|(key, value)| {
            let below = null_in(value)?;
            Some(if below.is_empty() { key.clone() } else { format!("{key}.{below}") })
        }),
        _ => None,
    }
}

/// Same error without lines, which a request does not have.
fn without_lines(error: StudyFileError) -> StudyFileError {
    let in_request = |key, why| StudyFileError::Value { path: REQUEST.to_owned(), line: None, key, why };
    match error {
        StudyFileError::Value { key, why, .. } => in_request(key, why),
        StudyFileError::Toml { message, .. } => {
            let message = message.lines().next().unwrap_or_default();
            match message.split_once(": ") {
                Some((key, why)) => in_request(key.to_owned(), why.to_owned()),
                None => in_request(REQUEST.to_owned(), message.to_owned()),
            }
        }
        StudyFileError::Keys { keys, more, .. } => {
            let unknown = keys.iter().map(|key| format!("unknown key {:?}; {}", key.key, key.hint));
            let more = (more > 0).then(|| format!("{more} more unknown keys"));
            let all: Vec<String> = unknown.chain(more).collect();
            in_request(REQUEST.to_owned(), all.join("; "))
        }
        other => other,
    }
}
