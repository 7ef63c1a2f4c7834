//! Dampers for a given restitution, simulator parameters, and the available laws, simulators and body regions.

use crate::analysis::model::Model;
use crate::conversion::errors::{self, input};
use crate::conversion::threads::{abandonable, interruptible};
use crate::questions::question::Request;
use crate::questions::reports::json;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use percuss::contact::exports::Tool;
use percuss::contact::{BodyRegion, Law};
use percuss::study;
use pyo3::prelude::*;

/// Number of samples of an impact that takes some milliseconds.
const MANY_SAMPLES: usize = 10_000;

/// Damper for an effective mass, kg.
#[pyfunction]
pub fn damp_mass(mass: f64, request: Request<'_>) -> PyResult<String> {
    json(&study::damp(&request.damping()?, mass).map_err(errors::study)?)
}

/// Damper for a contact of a model, or for the stop of a joint.
#[pyfunction]
pub fn damp(py: Python<'_>, model: &Model, request: Request<'_>) -> PyResult<String> {
    let damping = request.damping()?;
    let question = request.question(&model.read.mechanism)?;
    let report = interruptible(py, || match &damping.limit {
        Some(stop) => study::damp_stop(&model.read, stop, question, &damping),
        None => study::damp_contact(&model.read, &question, &damping),
    })?;
    json(&report.map_err(errors::study)?)
}

/// Time (s), penetration (m), its rate (m/s) and force (N) during an impact; (samples, 4).
#[pyfunction]
pub fn impact_history<'py>(
    py: Python<'py>,
    mass: f64,
    request: Request<'_>,
    samples: usize,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let question = request.damping()?;
    let found =
        abandonable(py, samples >= MANY_SAMPLES, move || study::impact_history(&question, mass, samples))?
            .map_err(input)?;
    let flat: Vec<f64> = found
        .iter()
        .flat_map(|sample| [sample.time, sample.penetration, sample.rate, sample.force])
        .collect();
    PyArray1::from_vec(py, flat).reshape([found.len(), 4])
}

/// Contact laws: name, title, formula, source, exactness, need for the impact speed.
#[pyfunction]
pub fn laws() -> Vec<(&'static str, &'static str, &'static str, &'static str, bool, bool)> {
    let of =
        |law: Law| (law.name(), law.title(), law.formula(), law.source(), law.is_exact(), law.needs_speed());
    Law::ALL.into_iter().map(of).collect()
}

/// Simulators: name, title.
#[pyfunction]
pub fn tools() -> Vec<(&'static str, &'static str)> {
    Tool::ALL.into_iter().map(|tool| (tool.name(), tool.facts().title)).collect()
}

/// Body regions: name, title, mass (kg), stiffness (N/m).
#[pyfunction]
pub fn regions() -> Vec<(&'static str, &'static str, f64, f64)> {
    BodyRegion::all().iter().map(|r| (r.name, r.title, r.mass, r.stiffness)).collect()
}
