//! Requests about a model in memory: the tables of a study as JSON.

use crate::model::loading::Model;
use crate::study_file::answer::{AskError, RequestReport};
use crate::study_file::file::{StudyFile, StudyFileError};
use crate::thresholds::LARGEST_STUDY;
use percuss_formats::Source;
use serde_json::Value;

/// Name of a request in messages, and of its model in a comparison.
const REQUEST: &str = "request";

/// Results of a request about a model. The request is a JSON object with the tables of a study (`percuss schema`); the table `model` may
/// have changes of the model, but no path. Paths are relative to the working directory. Nothing is written to files.
///
/// # Errors
/// [`AskError`]: invalid JSON, an unknown key, an invalid value, a key that names a file of the result, or an error of a table.
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
    read_request(model, request)?.ask(REQUEST)
}

/// Study of a request.
fn read_request(model: &Model, request: &str) -> Result<StudyFile, StudyFileError> {
    let refuse = |key: &str, why: String| {
        Err(StudyFileError::Value { path: REQUEST.to_owned(), line: None, key: key.to_owned(), why })
    };
    if request.len() as u64 > LARGEST_STUDY {
        return refuse(REQUEST, format!("{} bytes; at most {LARGEST_STUDY} are read", request.len()));
    }
    let mut value: Value = match serde_json::from_str(request) {
        Ok(value) => value,
        Err(error) => return refuse(REQUEST, format!("not JSON: {error}")),
    };
    let Some(tables) = value.as_object_mut() else {
        return refuse(REQUEST, "a JSON object with the tables of a study is expected".to_owned());
    };
    let changes = tables.entry("model").or_insert_with(|| Value::Object(serde_json::Map::new()));
    if let Some(changes) = changes.as_object_mut() {
        for key in ["path", "worksheet", "accept"] {
            if changes.contains_key(key) {
                let why =
                    format!("`{key}` belongs to the reading of a file; the model of a request is given");
                return refuse("model", why);
            }
        }
        changes.insert("path".to_owned(), Value::String(String::new()));
    }
    for (key, table) in [
        ("sweep.output", "sweep"),
        ("damping.output", "damping"),
        ("map.output", "map"),
        ("kinematics.output", "kinematics"),
    ] {
        if tables.get(table).and_then(|table| table.get("output")).is_some_and(|output| !output.is_null()) {
            return refuse(key, "a request writes no file: the result is in the report".to_owned());
        }
    }
    remove_nulls(&mut value);
    let text = match toml::to_string(&value) {
        Ok(text) => text,
        Err(error) => return refuse(REQUEST, error.to_string()),
    };
    let source = Source::new(REQUEST, text.clone().into_bytes());
    let read = StudyFile::from_text(REQUEST.to_owned(), &text, &source, Some(model), LARGEST_STUDY);
    read.map_err(without_lines)
}

/// Removes the keys with the value null, which TOML does not have.
fn remove_nulls(value: &mut Value) {
    match value {
        Value::Object(table) => {
            table.retain(|_, value| !value.is_null());
            table.values_mut().for_each(remove_nulls);
        }
        Value::Array(list) => list.iter_mut().for_each(remove_nulls),
        _ => {}
    }
}

/// Same error without lines, which a request does not have.
fn without_lines(error: StudyFileError) -> StudyFileError {
    let in_request = |key, why| StudyFileError::Value { path: REQUEST.to_owned(), line: None, key, why };
    match error {
        StudyFileError::Value { key, why, .. } => in_request(key, why),
        StudyFileError::Toml { message, .. } => {
            in_request(REQUEST.to_owned(), message.lines().next().unwrap_or_default().to_owned())
        }
        StudyFileError::Keys { keys, .. } => {
            let all: Vec<String> = keys
                .iter()
                .map(|unknown| format!("unknown key {:?}; {}", unknown.key, unknown.hint))
                .collect();
            in_request(REQUEST.to_owned(), all.join("; "))
        }
        other => other,
    }
}
