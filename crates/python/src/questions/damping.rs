//! Dampers for a given restitution, simulator parameters, and the available laws, simulators and body regions.

use crate::analysis::model::Model;
use crate::conversion::errors::{self, input};
use crate::conversion::threads::{abandonable, interruptible};
use crate::questions::question::Request;
use crate::questions::reports::json;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyUntypedArrayMethods};
use percuss::contact::exports::Tool;
use percuss::contact::{BodyRegion, Law, TransientContact};
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

/// Safe speeds (m/s) of masses (kg; infinite for an immovable robot): a region of the body, and one limit of force (N), pressure (Pa) with
/// area (m²), energy (J) or momentum (N·s). NaN for a mass that is NaN.
#[pyfunction]
pub fn safe_speeds<'py>(
    masses: PyReadonlyArray1<'py, f64>,
    region: Option<&str>,
    limits: [Option<f64>; 5],
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let region = region.map(BodyRegion::from_name).transpose().map_err(input)?;
    let [force, pressure, area, energy, momentum] = limits;
    if region.is_none() && (force.is_some() || pressure.is_some()) {
        return Err(input(
            "force, pressure: without a region there is no spring; expected a limit of energy or momentum",
        ));
    }
    let contact = |mass: f64| match region {
        Some(region) if mass == f64::INFINITY => Ok(Some(TransientContact::immovable(region))),
        Some(region) => TransientContact::new(region, mass).map(Some),
        None if mass == f64::INFINITY => Ok(None),
        None => TransientContact::against_fixed_body(mass).map(Some),
    };
    let speed = |contact: TransientContact| match (force, pressure, area, energy, momentum) {
        (Some(force), ..) => contact.speed_for_force(force),
        (_, Some(pressure), Some(area), ..) => contact.speed_for_pressure(pressure, area),
        (_, _, _, Some(energy), _) => contact.speed_for_energy(energy),
        _ => contact.speed_for_momentum(momentum.unwrap_or(f64::NAN)),
    };
    let mut found = Vec::with_capacity(masses.len());
    for (number, mass) in masses.as_array().iter().copied().enumerate() {
        found.push(match mass.is_nan() {
            true => f64::NAN,
            // A rigid obstacle against an immovable robot permits no speed.
            false => contact(mass)
                .and_then(|contact| contact.map_or(Ok(0.0), |contact| Ok(speed(contact)?.speed)))
                .map_err(|error| input(format_args!("mass number {number}: {error}")))?,
        });
    }
    Ok(PyArray1::from_vec(masses.py(), found))
}

/// Contact laws: name, title, formula, source, exactness, need for the impact speed.
///
///     >>> [law[0] for law in percuss.contact_law.laws()]
#[pyfunction]
pub fn laws() -> Vec<(&'static str, &'static str, &'static str, &'static str, bool, bool)> {
    let of =
        |law: Law| (law.name(), law.title(), law.formula(), law.source(), law.is_exact(), law.needs_speed());
    Law::ALL.into_iter().map(of).collect()
}

/// Simulators: name, title.
///
///     >>> [name for name, title in percuss.contact_law.tools()]
#[pyfunction]
pub fn tools() -> Vec<(&'static str, &'static str)> {
    Tool::ALL.into_iter().map(|tool| (tool.name(), tool.facts().title)).collect()
}

/// Body regions: name, title, mass (kg), stiffness (N/m).
///
///     >>> [name for name, title, mass, stiffness in percuss.reports.regions()]
#[pyfunction]
pub fn regions() -> Vec<(&'static str, &'static str, f64, f64)> {
    BodyRegion::all().iter().map(|r| (r.name, r.title, r.mass, r.stiffness)).collect()
}
