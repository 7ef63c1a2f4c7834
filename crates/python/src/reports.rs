//! The answers of the command line: reports as JSON text, which the package makes dicts of.

use crate::contact::Contact;
use crate::errors::{self, input};
use crate::model::Model;
use crate::question::{Conditions, Damping, rows};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use percuss::study::{
    self, Limit, MapLinks, MapQuestion, MapShapes, SafeSpeedQuestion, SkinFacets, StudyFile, Sweep,
};
use percuss::{ContactStatus, DEFAULT_MAX_SIZE};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};
use serde::Serialize;
use std::ops::ControlFlow;
use std::path::PathBuf;

/// A report as JSON.
pub fn json(report: &impl Serialize) -> PyResult<String> {
    serde_json::to_string(report).map_err(errors::no_answer)
}

/// What is in a model.
#[pyfunction]
pub fn check(py: Python<'_>, model: &Model) -> PyResult<String> {
    json(&py.detach(|| study::check(&model.read)).map_err(errors::study)?)
}

/// One contact of a model, with the damper where one is asked for.
#[pyfunction]
pub fn mass_report(
    py: Python<'_>,
    model: &Model,
    contact: &Contact,
    conditions: Conditions<'_>,
    damping: Option<Damping>,
) -> PyResult<String> {
    let question = conditions.of_contact(&model.read.mechanism, contact)?;
    let damping = damping.map(|damping| damping.question()).transpose()?;
    let report = py.detach(|| match &damping {
        Some(damping) => study::mass_with_damper(&model.read, &question, damping),
        None => study::mass(&model.read, &question),
    });
    json(&report.map_err(errors::study)?)
}

/// The same contact at many rows of positions.
#[pyfunction]
pub fn sweep_report<'py>(
    py: Python<'py>,
    model: &Model,
    contact: &Contact,
    conditions: Conditions<'py>,
    vary: Option<Vec<Bound<'py, PyAny>>>,
    input: Option<(String, Vec<String>)>,
    random: Option<(usize, u64)>,
) -> PyResult<String> {
    let question = conditions.of_contact(&model.read.mechanism, contact)?;
    let source = rows(vary, input, random)?;
    let sweep = || Sweep::new(&model.read, &question, source);
    let report = watched(py, &model.read, sweep)?;
    json(&report)
}

/// Goes through a sweep; ends it where Ctrl-C was pressed.
fn watched<'a>(
    py: Python<'_>,
    model: &study::Model,
    sweep: impl FnOnce() -> Result<Sweep<'a>, percuss::study::StudyError> + Send,
) -> PyResult<study::SweepReport> {
    let mut interrupted = None;
    let report = py.detach(|| {
        let sweep = sweep()?;
        let heading = sweep.heading().clone();
        let mut rows = Vec::new();
        let end = sweep.run(&mut |row| {
            rows.push(row);
            if rows.len() % 64 == 0 {
                interrupted = Python::attach(|py| py.check_signals()).err();
            }
            if interrupted.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        })?;
        let diagnostics = model.diagnostics.iter().cloned().chain(end.diagnostics).collect();
        Ok(study::SweepReport { heading, rows, diagnostics })
    });
    match interrupted {
        Some(interrupt) => Err(interrupt),
        None => report.map_err(errors::study),
    }
}

/// The facets of a link as arrays.
fn facets<'py>(py: Python<'py>, skin: &SkinFacets) -> PyResult<Bound<'py, PyDict>> {
    let count = skin.facets.len();
    let records: Vec<_> = skin.records().collect();
    let triples = |of: &dyn Fn(&study::FacetRecord<'_>) -> [f64; 3]| -> PyResult<Bound<'py, PyArray2<f64>>> {
        let flat: Vec<f64> = records.iter().flat_map(of).collect();
        PyArray1::from_vec(py, flat).reshape([count, 3])
    };
    let arrays = PyDict::new(py);
    arrays.set_item("points", triples(&|record| record.point_link)?)?;
    arrays.set_item("normals", triples(&|record| record.normal_link)?)?;
    arrays.set_item("points_world", triples(&|record| record.point_world)?)?;
    let numbers = |of: &dyn Fn(&study::FacetRecord<'_>) -> f64| {
        PyArray1::from_vec(py, records.iter().map(of).collect())
    };
    arrays.set_item("area", numbers(&|record| record.area))?;
    arrays.set_item("effective_mass", numbers(&|record| record.effective_mass.unwrap_or(f64::NAN)))?;
    arrays.set_item("error", numbers(&|record| record.effective_mass_error.unwrap_or(f64::NAN)))?;
    let codes = skin.statuses.iter().map(|status| match status {
        ContactStatus::Finite => 0,
        ContactStatus::Immovable => 1,
        ContactStatus::Massless => 2,
        ContactStatus::Unanswered => 3_u8,
    });
    arrays.set_item("status", PyArray1::from_vec(py, codes.collect()))?;
    Ok(arrays)
}

/// Maps of links: the report, the facets of each link as arrays, the picture as SVG.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "the question of a map")]
pub fn map_report<'py>(
    py: Python<'py>,
    model: &Model,
    conditions: Conditions<'py>,
    against: Option<String>,
    links: Option<Vec<String>>,
    shapes: &str,
    edge: Option<f64>,
    packages: Vec<(String, PathBuf)>,
) -> PyResult<(String, Bound<'py, PyDict>, String)> {
    let mut question = MapQuestion::all(conditions.question()?);
    question.conditions.against = against;
    if let Some(links) = links {
        question.links = MapLinks::Named(links);
    }
    question.shapes = match shapes {
        "auto" => MapShapes::Auto,
        "collision" => MapShapes::Collision,
        "visual" => MapShapes::Visual,
        _ => {
            return Err(input(format_args!(
                "shapes is \"{shapes}\"; expected \"auto\", \"collision\" or \"visual\""
            )));
        }
    };
    (question.edge, question.packages) = (edge, packages);
    let answer = py.detach(|| study::map(&model.read, &question)).map_err(errors::study)?;
    let by_link = PyDict::new(py);
    for skin in &answer.skins {
        by_link.set_item(&skin.link, facets(py, skin)?)?;
    }
    let picture = py.detach(|| percuss_cli::map_skin(&answer).to_svg());
    Ok((json(&answer.report)?, by_link, picture))
}

/// Directions at a point.
#[pyfunction]
pub fn map_point_report(
    py: Python<'_>,
    model: &Model,
    contact: &Contact,
    conditions: Conditions<'_>,
    directions: usize,
) -> PyResult<String> {
    let question = conditions.of_contact(&model.read.mechanism, contact)?;
    let report = py.detach(|| study::map_point(&model.read, &question, directions));
    json(&report.map_err(errors::study)?)
}

/// How fast the contact of a robot may go. limit: force, N; or pressure, Pa, with area, m².
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "the question of a safe speed")]
pub fn safe_speed(
    py: Python<'_>,
    model: &Model,
    contact: &Contact,
    conditions: Conditions<'_>,
    region: String,
    force: Option<f64>,
    pressure: Option<f64>,
    area: Option<f64>,
    load: f64,
) -> PyResult<String> {
    let question = conditions.of_contact(&model.read.mechanism, contact)?;
    let limit = match (force, pressure, area) {
        (Some(force), None, None) => Limit::Force(force),
        (None, Some(pressure), Some(area)) => Limit::Pressure(pressure, area),
        _ => return Err(input("give force (N), or pressure (Pa) with area (m²)")),
    };
    let asked = SafeSpeedQuestion { region: Some(region), limit, load };
    let report = py.detach(|| study::safe_speed(&model.read, &question, &asked));
    json(&report.map_err(errors::study)?)
}

/// Runs a study: its sweep's report where it has one, else that of its contact.
#[pyfunction]
pub fn run_study(py: Python<'_>, path: PathBuf) -> PyResult<String> {
    let path = path.to_string_lossy().into_owned();
    let study = py.detach(|| StudyFile::load(&path, DEFAULT_MAX_SIZE)).map_err(errors::study_file)?;
    errors::warn(py, &study.model.diagnostics)?;
    match (&study.question, &study.sweep) {
        (Some(question), Some(sweep)) => {
            let rows = sweep.rows.clone();
            json(&watched(py, &study.model, || Sweep::new(&study.model, question, rows))?)
        }
        (Some(question), None) => {
            let report = py.detach(|| match &study.damping {
                Some(damping) => study::mass_with_damper(&study.model, question, &damping.question),
                None => study::mass(&study.model, question),
            });
            json(&report.map_err(errors::study)?)
        }
        (None, _) => without_contact(py, &study),
    }
}

/// A study that asks for something else than a contact: a stop, a map, a safe speed.
fn without_contact(py: Python<'_>, study: &StudyFile) -> PyResult<String> {
    if let Some(study::StudyDamping { question, stop: Some((stop, conditions)), .. }) = &study.damping {
        let report = py.detach(|| study::damp_stop(&study.model, stop, conditions.clone(), question));
        return json(&report.map_err(errors::study)?);
    }
    match (study.map.as_ref().map(|map| &map.question), &study.safe_speed) {
        (Some(study::StudyMapQuestion::Surfaces(question)), _) => {
            json(&py.detach(|| study::map(&study.model, question)).map_err(errors::study)?.report)
        }
        (Some(study::StudyMapQuestion::Directions(question, count)), _) => {
            let report = py.detach(|| study::map_point(&study.model, question, *count));
            json(&report.map_err(errors::study)?)
        }
        (None, Some(asked)) => json(&py.detach(|| asked.reports(&study.model)).map_err(errors::study)?),
        (None, None) => Err(errors::input("the study asks for nothing")),
    }
}
