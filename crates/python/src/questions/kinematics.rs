//! Kinematics of suspensions.

use crate::analysis::model::Model;
use crate::conversion::errors;
use crate::conversion::threads::{abandonable, interruptible};
use crate::questions::question::{Request, invalid};
use crate::questions::reports::json;
use percuss::study::{self, KinematicVariable, KinematicsQuestion, WheelMotion};
use percuss::{DEFAULT_MAX_SIZE, LoadOptions};
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;

/// Suspension: a model, or the path of a file, whose masses may be missing.
#[derive(FromPyObject)]
pub enum Suspension<'py> {
    Read(Bound<'py, Model>),
    File(PathBuf),
}

/// Report on the kinematics of a suspension. state: values by variable, m; range: variable of the rows and its values.
#[pyfunction]
pub fn kinematics(
    py: Python<'_>,
    model: Suspension<'_>,
    request: Request<'_>,
    state: Vec<(String, f64)>,
    range: Option<(String, Vec<f64>)>,
) -> PyResult<String> {
    request.tables.vehicle.check().map_err(invalid)?;
    let variable =
        |name: &str| WheelMotion::from_name(name).map_or(KinematicVariable::Steer, KinematicVariable::Wheels);
    let question = KinematicsQuestion {
        vehicle: request.tables.vehicle,
        state: state.iter().map(|(name, value)| (variable(name), *value)).collect(),
        range: range.map(|(name, values)| (variable(&name), values)),
        ..KinematicsQuestion::default()
    };
    let read = match model {
        Suspension::Read(model) => Arc::clone(&model.get().read),
        Suspension::File(path) => {
            let path = path.to_string_lossy().into_owned();
            let options = LoadOptions::default();
            let read = move || study::Model::load_for_kinematics(&path, DEFAULT_MAX_SIZE, &options, None);
            let read = abandonable(py, true, read)?.map_err(errors::load)?;
            errors::warn(py, &read.diagnostics)?;
            Arc::new(read)
        }
    };
    let report = interruptible(py, || study::kinematics(&read, &question))?;
    json(&report.map_err(errors::kinematics)?)
}
