//! Reports of the command line as JSON text; the Python package converts them to dicts.

use crate::analysis::contact::Contact;
use crate::analysis::model::Model;
use crate::conversion::errors::{self, input, of_argument};
use crate::conversion::threads::{abandonable, interruptible};
use crate::questions::question::{Request, invalid};
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use percuss::study::{
    self, FurtherContact, MassQuestion, Names, SafeSpeedQuestion, SkinFacets, StudyAdditions, StudyError,
    StudyFile, Sweep, WithAdditions,
};
use percuss::{DEFAULT_MAX_SIZE, interruption};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use serde::Serialize;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A report as JSON.
pub fn json(report: &impl Serialize) -> PyResult<String> {
    serde_json::to_string(report).map_err(errors::no_answer)
}

/// Evaluates `answer` for the question of a request and returns the report as JSON.
fn report_of<R: Serialize + Send>(
    py: Python<'_>,
    model: &Model,
    request: &Request<'_>,
    answer: impl FnOnce(&study::Model, &MassQuestion) -> Result<R, StudyError> + Send,
) -> PyResult<String> {
    let question = request.question(&model.read.mechanism)?;
    json(&interruptible(py, || answer(&model.read, &question))?.map_err(errors::study)?)
}

/// Summary of a model.
#[pyfunction]
pub fn check(py: Python<'_>, model: &Model) -> PyResult<String> {
    json(&interruptible(py, || study::check(&model.read))?.map_err(errors::study)?)
}

/// Report on one contact of a model, with the damper and the results of the table of the mass that are requested.
#[pyfunction]
pub fn mass_report(py: Python<'_>, model: &Model, request: Request<'_>) -> PyResult<String> {
    request.tables.mass.check().map_err(invalid)?;
    let (options, damper) = (&request.tables.mass, request.damper()?);
    report_of(py, model, &request, |model, question| {
        study::requested_mass(model, question, damper.as_ref(), options)
    })
}

/// Inertias reflected to joints. `joints`: "JOINT", or "JOINT=FROM:TO:COUNT" for a range of positions.
#[pyfunction]
pub fn reflected_inertias(
    py: Python<'_>,
    model: &Model,
    request: Request<'_>,
    joints: Vec<String>,
) -> PyResult<String> {
    report_of(py, model, &request, |model, question| study::reflected_inertias(model, question, &joints))
}

/// Report on a rigid impact at a contact of a model. also: further contacts that are no text, each in the place of its text.
#[pyfunction]
pub fn impact(
    py: Python<'_>,
    model: &Model,
    request: Request<'_>,
    also: Vec<Option<Bound<'_, Contact>>>,
) -> PyResult<String> {
    request.tables.impact.check().map_err(invalid)?;
    let mut requested = request.tables.impact.clone();
    for (further, given) in requested.also.iter_mut().zip(&also) {
        if let Some(contact) = given {
            let resolved = contact.get().resolve(&model.read.mechanism).map_err(of_argument("also"))?;
            *further = FurtherContact::Resolved(resolved);
        }
    }
    report_of(py, model, &request, |model, question| study::impact(model, question, &requested))
}

/// Smallest and largest effective mass, or another quantity, over ranges of driving joints, with kept links or points, or along a path.
#[pyfunction]
pub fn extremes(py: Python<'_>, model: &Model, request: Request<'_>) -> PyResult<String> {
    let mut requested = request.tables.extremes.clone();
    if let Some(law) = request.damper()? {
        (requested.stiffness, requested.restitution, requested.speed) =
            (law.stiffness, law.restitution, law.speed);
        (requested.exponent, requested.law, requested.separation) = (law.exponent, law.law, law.separation);
    }
    let requested = requested.checked(Vec::new(), Path::new(""), DEFAULT_MAX_SIZE).map_err(invalid)?;
    report_of(py, model, &request, |model, question| study::extremes(model, question, &requested))
}

/// Report as JSON with an empty list of rows, and its rows as JSON lists of some thousand. Python converts one list after the other,
/// and checks for Ctrl-C in between.
type RowParts = (String, Vec<String>);

/// Rows of a JSON list.
const ROWS_PER_LIST: usize = 1 << 12;

/// JSON of a report in parts; `take_rows` moves the rows out of the report. `additions`: further keys of the report.
fn row_parts<R: Serialize, Row: Serialize + Sync + Send + 'static>(
    py: Python<'_>,
    mut report: R,
    additions: &StudyAdditions,
    take_rows: impl FnOnce(&mut R) -> Vec<Row>,
) -> PyResult<RowParts> {
    let rows = Deferred(take_rows(&mut report));
    let list = |rows: &[Row]| {
        interruption::check();
        serde_json::to_string(rows)
    };
    let lists = interruptible(py, || rows.0.par_chunks(ROWS_PER_LIST).map(list).collect::<Result<_, _>>())?;
    Ok((json(&WithAdditions { report: &report, additions })?, lists.map_err(errors::no_answer)?))
}

/// Rows that are freed on a separate thread: freeing millions of rows takes some tenths of a second.
struct Deferred<T: Send + 'static>(Vec<T>);

impl<T: Send + 'static> Drop for Deferred<T> {
    fn drop(&mut self) {
        let rows = std::mem::take(&mut self.0);
        // Without a thread the rows are freed here.
        drop(std::thread::Builder::new().spawn(move || drop(rows)));
    }
}

/// Report on a contact at many rows of positions.
#[pyfunction]
pub fn sweep_report(py: Python<'_>, model: &Model, request: Request<'_>) -> PyResult<RowParts> {
    let question = request.question(&model.read.mechanism)?;
    let source = request.rows()?.ok_or_else(|| input("give one of vary, input and random"))?;
    let additions = StudyAdditions::default();
    run_sweep(py, &model.read, request.has_gradient(), &additions, || {
        Sweep::new(&model.read, &question, source)
    })
}

/// Runs a sweep; stops on Ctrl-C. `additions`: further keys of the report.
fn run_sweep<'a>(
    py: Python<'_>,
    model: &study::Model,
    has_gradient: bool,
    additions: &StudyAdditions,
    sweep: impl FnOnce() -> Result<Sweep<'a>, StudyError> + Send,
) -> PyResult<RowParts> {
    let run = || {
        let sweep = if has_gradient { sweep()?.with_gradient() } else { sweep()? };
        let heading = sweep.heading().clone();
        let mut rows = Deferred(Vec::new());
        let end = sweep.run(&mut |row| {
            rows.0.push(row);
            match interruption::is_requested() {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        })?;
        let diagnostics = model.diagnostics.iter().cloned().chain(end.diagnostics).collect();
        Ok(study::SweepReport { heading, rows: std::mem::take(&mut rows.0), diagnostics })
    };
    let report = interruptible(py, run)?.map_err(errors::study)?;
    row_parts(py, report, additions, |report| std::mem::take(&mut report.rows))
}

/// Facets of a link as arrays.
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
    let turned = skin.facets.iter().flat_map(|facet| <[f64; 3]>::from(skin.frame.vector(&facet.normal)));
    let turned = PyArray1::from_vec(py, turned.collect());
    arrays.set_item("normals_world", turned.reshape([count, 3])?)?;
    let numbers = |of: &dyn Fn(&study::FacetRecord<'_>) -> f64| {
        PyArray1::from_vec(py, records.iter().map(of).collect())
    };
    arrays.set_item("area", numbers(&|record| record.area))?;
    arrays.set_item("effective_mass", numbers(&|record| record.effective_mass.unwrap_or(f64::NAN)))?;
    arrays.set_item("error", numbers(&|record| record.effective_mass_error.unwrap_or(f64::NAN)))?;
    let codes = skin.statuses.iter().map(|status| u8::from(*status));
    arrays.set_item("status", PyArray1::from_vec(py, codes.collect()))?;
    Ok(arrays)
}

/// Maps of links: the report, the facets of each link as arrays, the picture as SVG.
#[pyfunction]
pub fn map_report<'py>(
    py: Python<'py>,
    model: &Model,
    request: Request<'py>,
) -> PyResult<(String, Bound<'py, PyDict>, String)> {
    let conditions = request.question(&model.read.mechanism)?;
    let question = request.tables.map.checked(&conditions, Path::new("")).map_err(invalid)?;
    let read = Arc::clone(&model.read);
    let work = move || {
        let answer = study::map(&read, &conditions, &question)?;
        let picture = percuss_render::Picture::to_svg(&percuss_cli::map_skin(&answer));
        Ok((answer, picture))
    };
    let (answer, picture) = abandonable(py, true, work)?.map_err(errors::study)?;
    let by_link = PyDict::new(py);
    for skin in &answer.skins {
        by_link.set_item(&skin.link, facets(py, skin)?)?;
        py.check_signals()?;
    }
    Ok((json(&answer.report)?, by_link, picture))
}

/// Report on directions at a point.
#[pyfunction]
pub fn map_point_report(
    py: Python<'_>,
    model: &Model,
    request: Request<'_>,
    directions: usize,
) -> PyResult<String> {
    report_of(py, model, &request, |model, question| study::map_point(model, question, directions))
}

/// Safe speeds of a contact of a robot, as a list: at its pose, or at the slowest row of positions; or in each of
/// several world directions, the worst direction last.
#[pyfunction]
pub fn safe_speed(py: Python<'_>, model: &Model, request: Request<'_>) -> PyResult<String> {
    request.tables.safe_speed.check().map_err(invalid)?;
    let requested = SafeSpeedQuestion { rows: request.rows()?, ..request.tables.safe_speed.clone() };
    report_of(py, model, &request, |model, question| study::safe_speeds(model, question, &requested))
}

/// Compares several designs by one question, at the same rows of positions if rows are given.
#[pyfunction]
pub fn compare(
    py: Python<'_>,
    designs: Vec<(String, Bound<'_, Model>, Request<'_>)>,
    rows: Request<'_>,
) -> PyResult<RowParts> {
    let source = rows.rows()?;
    let design = |(name, model, request): &(String, Bound<'_, Model>, Request<'_>)| {
        let model = &model.get().read;
        PyResult::Ok(study::Design {
            name: name.clone(),
            model: study::Model::clone(model),
            question: request.question(&model.mechanism)?,
            contact: None,
            rows: source.clone(),
        })
    };
    let designs: Vec<study::Design> = designs.iter().map(design).collect::<PyResult<_>>()?;
    comparison_json(py, Names::Fields, || study::compare(&designs))
}

/// Compares the designs of a study file: its model, then its variants.
#[pyfunction]
pub fn compare_study(py: Python<'_>, path: PathBuf) -> PyResult<RowParts> {
    let path = path.to_string_lossy().into_owned();
    let study =
        interruptible(py, || StudyFile::load(&path, DEFAULT_MAX_SIZE))?.map_err(errors::study_file)?;
    errors::warn(py, &study.model.diagnostics)?;
    comparison_json(py, Names::KEYS, || study.compare(&study.designs()))
}

/// Compares designs and returns the report as JSON; `names` in messages.
fn comparison_json(
    py: Python<'_>,
    names: Names,
    compare: impl FnOnce() -> Result<study::ComparisonReport, study::CompareError> + Send,
) -> PyResult<RowParts> {
    let report = interruptible(py, compare)?.map_err(|error| input(error.message(names)))?;
    row_parts(py, report, &StudyAdditions::default(), |report| std::mem::take(&mut report.rows))
}

/// JSON schema of study files.
#[pyfunction]
pub fn study_schema() -> PyResult<String> {
    json(study::study_schema())
}

/// Initial study file for a model, which the file refers to by a path.
#[pyfunction]
pub fn starting_study(py: Python<'_>, model: &Model, path: PathBuf) -> PyResult<String> {
    let path = path.to_string_lossy();
    interruptible(py, || study::starting_study(&model.read, &path))?.map_err(errors::study)
}

/// Runs a study and returns the report of its sweep, or of its contact if the study has no sweep; adds the impact and the extremes.
#[pyfunction]
pub fn run_study(py: Python<'_>, path: PathBuf) -> PyResult<RowParts> {
    let path = path.to_string_lossy().into_owned();
    let study =
        interruptible(py, || StudyFile::load(&path, DEFAULT_MAX_SIZE))?.map_err(errors::study_file)?;
    errors::warn(py, &study.model.diagnostics)?;
    match (&study.question, &study.tables.sweep) {
        (Some(question), Some(sweep)) => {
            let additions = interruptible(py, || study.additions())?.map_err(errors::ask)?;
            let question = study.question_of_rows(question);
            run_sweep(py, &study.model, false, &additions, || study.prepared_sweep(sweep, &question))
        }
        (question, _) => {
            let mass = interruptible(py, || study.mass_report())?.map_err(errors::study)?;
            let mut names = study.given_tables();
            match question {
                Some(_) => names.retain(|table| ["impact", "extremes"].contains(table)),
                None => names.truncate(1),
            }
            let report = interruptible(py, || study.results(None, mass, &names))?.map_err(errors::ask)?;
            let json = report.main_json();
            Ok((
                json.ok_or_else(|| {
                    input("the study contains no question with one report: use percuss.study.ask")
                })?,
                Vec::new(),
            ))
        }
    }
}

/// Results of the tables of a request, JSON.
#[pyfunction]
pub fn ask(py: Python<'_>, model: &Model, request: &str) -> PyResult<String> {
    let report = interruptible(py, || study::ask(&model.read, request))?;
    report.map(|report| report.to_json()).map_err(|error| match error.has_no_result() {
        true => errors::no_answer(error.message()),
        false => input(error.message()),
    })
}
