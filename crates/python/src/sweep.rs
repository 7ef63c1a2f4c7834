//! m̄ of one contact at many configurations: arrays in and out, the interpreter released.

use crate::arrays::{float64, shape};
use crate::contact::Contact;
use crate::errors::{self, input};
use crate::matrices::coded;
use crate::model::Model;
use crate::system::{Assembly, System};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods};
use percuss::{
    Assembly as Assembled, Batch, BatchAnswer, BatchPositions, Configuration, Contact as Resolved,
    DrivenPath, JointId, PathAnswer, Pose as Posed, RouteChoice,
};
use percuss_render::{Figure, Panel, Series, Style};
use pyo3::prelude::*;
use pyo3::types::PyAny;
use rayon::prelude::*;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Configurations between two looks for Ctrl-C: at first, and at most.
const PORTIONS: (usize, usize) = (1024, 1 << 17);
/// A portion that takes longer is the largest.
const LOOK_AFTER: Duration = Duration::from_millis(50);
/// Answers that a thread makes columns of at once.
const AT_ONCE: usize = 1024;

/// m̄ of a contact at many configurations.
#[pyclass(frozen, module = "percuss")]
#[derive(Debug)]
pub struct Sweep {
    /// m̄, kg; NaN unless finite; (N,).
    #[pyo3(get)]
    effective_mass: Py<PyArray1<f64>>,
    /// What it may be off by, kg; NaN where that was not counted; (N,).
    #[pyo3(get)]
    error: Py<PyArray1<f64>>,
    /// 0 finite, 1 immovable, 2 massless, 3 no answer: the pose does not exist, or no route takes it; uint8, (N,).
    #[pyo3(get)]
    status: Py<PyArray1<u8>>,
    /// What the picture is headed by.
    link: String,
}

#[derive(Default)]
struct Columns {
    masses: Vec<f64>,
    errors: Vec<f64>,
    codes: Vec<u8>,
}

impl Columns {
    fn of(count: usize) -> Self {
        Self { masses: vec![f64::NAN; count], errors: vec![f64::NAN; count], codes: vec![3; count] }
    }

    fn set(&mut self, at: usize, mass: Option<percuss::EffectiveMass>, error: Option<f64>) {
        (self.masses[at], self.codes[at]) = coded(mass);
        self.errors[at] = error.unwrap_or(f64::NAN);
    }

    fn fill(&mut self, first: usize, answers: &[BatchAnswer]) {
        let rows = first..first + answers.len();
        let masses = self.masses[rows.clone()].par_chunks_mut(AT_ONCE);
        let errors = self.errors[rows.clone()].par_chunks_mut(AT_ONCE);
        let codes = self.codes[rows].par_chunks_mut(AT_ONCE);
        let of = answers.par_chunks(AT_ONCE);
        masses.zip(errors).zip(codes).zip(of).for_each(|(((masses, errors), codes), answers)| {
            for (i, answer) in answers.iter().enumerate() {
                (masses[i], codes[i]) = coded(answer.mass);
                errors[i] = answer.error.unwrap_or(f64::NAN);
            }
        });
    }
}

/// What a sweep goes over.
#[derive(FromPyObject)]
pub enum Swept<'py> {
    Assembly(Bound<'py, Assembly>),
    System(Bound<'py, System>),
    Model(Bound<'py, Model>),
}

impl Swept<'_> {
    fn assembly(&self, py: Python<'_>) -> PyResult<(Model, Arc<Assembled>)> {
        let of_system = |system: &System| PyResult::Ok((system.model.clone(), system.reference(py)?));
        match self {
            Swept::Assembly(found) => Ok((found.get().model.clone(), Arc::clone(&found.get().assembly))),
            Swept::System(found) => of_system(found.get()),
            Swept::Model(model) => of_system(&System::plain(model.get())?),
        }
    }
}

/// m̄ of a contact at the rows of q, by all processors. Answers do not depend on how many there are.
///
/// model: a Model, System or Assembly. q: (N, p) float64, rad, m: the positions of all joints in the order of the file, loops
/// closed (positions of a Pose are); mimics are not read. Any strides; a C-ordered array is read where it lies, and an F-ordered one
/// is the fastest. Other types of numbers are converted.
///
/// joints: names of driving joints of one position each, when the columns of q are theirs: (N, len(joints)). Others are at 0 or
/// follow; loops are closed, each row followed from the row before, on one branch. Rows that cannot be reached have no answer.
///
/// Points and normals in the world are taken with the root link at the world's origin. Ctrl-C stops it.
#[pyfunction]
#[pyo3(signature = (model, contact, q, *, joints=None))]
pub fn sweep(
    py: Python<'_>,
    model: Swept<'_>,
    contact: &Contact,
    q: &Bound<'_, PyAny>,
    joints: Option<Vec<String>>,
) -> PyResult<Sweep> {
    let (model, assembly) = model.assembly(py)?;
    let resolved = contact.on(&model.read.mechanism)?;
    let q = float64(q, "q", &[2], "(N, p): a row for each configuration")?;
    let batch = assembly.batch(&resolved).map_err(errors::response)?;
    let columns = match joints {
        None => {
            let (width, expected) = (q.shape()[1], model.position_count());
            if width != expected {
                return Err(input(format_args!(
                    "q has shape {}; expected {expected} columns, the positions of all joints (Model.position_names), or \
                     joints=[…] with the names of the columns",
                    shape(q.shape())
                )));
            }
            whole(py, &batch, &q)?
        }
        Some(names) => {
            let places = drivers(&model, &names, q.shape())?;
            match assembly.groups().is_empty() {
                true => of_tree(py, &batch, &model, &q, &places)?,
                false => Path::new(&model, &assembly, resolved, &places)?.follow(py, &q)?,
            }
        }
    };
    Ok(Sweep {
        effective_mass: PyArray1::from_vec(py, columns.masses).unbind(),
        error: PyArray1::from_vec(py, columns.errors).unbind(),
        status: PyArray1::from_vec(py, columns.codes).unbind(),
        link: contact.link.clone(),
    })
}

/// The joints of the columns, with the place of each among all positions.
fn drivers(model: &Model, names: &[String], given: &[usize]) -> PyResult<Vec<(JointId, usize)>> {
    if given[1] != names.len() {
        return Err(input(format_args!(
            "q has shape {}; joints names {} columns",
            shape(given),
            names.len()
        )));
    }
    let mechanism = &model.read.mechanism;
    // Unknown names, mimics and joints that are named twice are refused as where they are set.
    let mut trial = Configuration::zero(mechanism);
    let find = |name: &String| {
        let id = mechanism.find_joint(name).map_err(input)?;
        let joint = mechanism.joint(id);
        if joint.kind().positions() != 1 {
            return Err(input(format_args!(
                "joints: \"{name}\" is {} and has not one position; give the positions of all joints",
                joint.kind().name()
            )));
        }
        trial.set(name, &[0.0]).map_err(input)?;
        let before = &mechanism.joints()[..id.index()];
        Ok((id, before.iter().map(|joint| joint.kind().positions()).sum()))
    };
    names.iter().map(find).collect()
}

/// Refuses what is no number; by rows of a block.
fn refuse_nan(values: &[f64], place: impl Fn(usize) -> (usize, usize)) -> PyResult<()> {
    // NaN and infinity make NaN of zero.
    let is_bad = |part: &[f64]| part.iter().fold(0.0, |sum, x| sum + 0.0 * x) != 0.0;
    let size = 1 << 15;
    let Some(number) = values.par_chunks(size).position_first(is_bad) else { return Ok(()) };
    let at = values.iter().skip(number * size).position(|x| !x.is_finite());
    let at = number * size + at.unwrap_or_default();
    let (row, column) = place(at);
    Err(input(format_args!("q[{row}, {column}] is {}; expected finite numbers", values[at])))
}

/// Portions of configurations that grow while they are quick; looks for Ctrl-C between them.
fn portions(
    py: Python<'_>,
    count: usize,
    mut portion: impl FnMut(usize, usize) -> PyResult<()> + Send,
) -> PyResult<()> {
    let (mut first, mut size) = (0, PORTIONS.0);
    while first < count {
        let here = size.min(count - first);
        let begun = Instant::now();
        py.detach(|| portion(first, here))?;
        py.check_signals()?;
        first += here;
        if begun.elapsed() < LOOK_AFTER {
            size = (2 * size).min(PORTIONS.1);
        } else if begun.elapsed() > 4 * LOOK_AFTER {
            size = (size / 2).max(16);
        }
    }
    Ok(())
}

/// All positions of every row.
fn whole(py: Python<'_>, batch: &Batch, q: &PyReadonlyArrayDyn<'_, f64>) -> PyResult<Columns> {
    let (count, width) = (q.shape()[0], q.shape()[1]);
    let mut columns = Columns::of(count);
    let mut answers = vec![BatchAnswer::NONE; count.min(PORTIONS.1)];
    let mut run = |first: usize, here: usize, positions: BatchPositions<'_>| {
        batch.run(positions, &mut answers[..here]).map_err(input)?;
        columns.fill(first, &answers[..here]);
        Ok(())
    };
    match q.as_slice() {
        Ok(values) if q.is_c_contiguous() => portions(py, count, |first, here| {
            let part = &values[first * width..(first + here) * width];
            refuse_nan(part, |at| (first + at / width, at % width))?;
            run(first, here, BatchPositions::Rows { values: part, stride: width })
        })?,
        Ok(values) => {
            py.detach(|| refuse_nan(values, |at| (at % count, at / count)))?;
            portions(py, count, |first, here| {
                run(first, here, BatchPositions::Columns { values: &values[first..], stride: count })
            })?;
        }
        Err(_) => {
            let view = q.as_array();
            let mut part = Vec::new();
            portions(py, count, |first, here| {
                part.clear();
                (first..first + here).for_each(|row| part.extend((0..width).map(|c| view[[row, c]])));
                refuse_nan(&part, |at| (first + at / width, at % width))?;
                run(first, here, BatchPositions::Rows { values: &part, stride: width })
            })?;
        }
    }
    Ok(columns)
}

/// Some positions of every row, the others at 0, where nothing closes a loop.
fn of_tree(
    py: Python<'_>,
    batch: &Batch,
    model: &Model,
    q: &PyReadonlyArrayDyn<'_, f64>,
    places: &[(JointId, usize)],
) -> PyResult<Columns> {
    let (count, given) = (q.shape()[0], places.len());
    let zero: Vec<f64> = {
        let mechanism = &model.read.mechanism;
        let zero = Configuration::zero(mechanism);
        mechanism.joint_ids().flat_map(|joint| zero.get(joint).to_vec()).collect()
    };
    let width = zero.len();
    let mut columns = Columns::of(count);
    let mut answers = vec![BatchAnswer::NONE; count.min(PORTIONS.1)];
    // By columns, the fastest; those that are not given stay as they are.
    let size = count.min(PORTIONS.1).max(1);
    let mut part: Vec<f64> = zero.iter().flat_map(|x| std::iter::repeat_n(*x, size)).collect();
    let view = q.as_array();
    portions(py, count, |first, here| {
        for (column, (_, place)) in places.iter().enumerate() {
            let to = &mut part[place * size..place * size + here];
            to.iter_mut().enumerate().for_each(|(row, to)| *to = view[[first + row, column]]);
            refuse_nan(to, |at| (first + at, column))?;
        }
        batch
            .run(BatchPositions::Columns { values: &part, stride: size }, &mut answers[..here])
            .map_err(input)?;
        columns.fill(first, &answers[..here]);
        Ok(())
    })?;
    debug_assert_eq!((part.len(), given), (width * size, q.shape()[1]));
    Ok(columns)
}

/// Rows of the drivers of a linkage, each followed from the row before.
struct Path<'a> {
    model: &'a Model,
    assembly: &'a Arc<Assembled>,
    contact: Resolved,
    joints: Vec<JointId>,
    /// Where the last row that was reached stands.
    stands: Posed,
    driven: Option<DrivenPath>,
}

impl<'a> Path<'a> {
    fn new(
        model: &'a Model,
        assembly: &'a Arc<Assembled>,
        contact: Resolved,
        places: &[(JointId, usize)],
    ) -> PyResult<Self> {
        let joints = places.iter().map(|(joint, _)| *joint).collect();
        let zero = Configuration::zero(&model.read.mechanism);
        let stands = assembly.pose(&zero).map_err(errors::assembly)?;
        Ok(Self { model, assembly, contact, joints, stands, driven: None })
    }

    fn follow(mut self, py: Python<'_>, q: &PyReadonlyArrayDyn<'_, f64>) -> PyResult<Columns> {
        let (count, width) = (q.shape()[0], self.joints.len());
        let mut columns = Columns::of(count);
        let view = q.as_array();
        let mut rows = Vec::new();
        portions(py, count, |first, here| {
            rows.clear();
            (first..first + here).for_each(|row| rows.extend((0..width).map(|c| view[[row, c]])));
            refuse_nan(&rows, |at| (first + at / width, at % width))?;
            let mut done = 0;
            while done < here {
                done += self.in_lanes(&rows[done * width..], first + done, &mut columns);
                if done < here {
                    self.by_itself(&rows[done * width..(done + 1) * width], first + done, &mut columns);
                    done += 1;
                }
            }
            Ok(())
        })?;
        Ok(columns)
    }

    /// As many rows as the branch is beyond doubt.
    fn in_lanes(&mut self, rows: &[f64], first: usize, columns: &mut Columns) -> usize {
        let Some(driven) = &mut self.driven else { return 0 };
        let (mut answers, mut positions): (Vec<PathAnswer>, Vec<f64>) = (Vec::new(), Vec::new());
        let reached = driven.follow(rows, &mut answers, &mut positions);
        let width = positions.len() / reached.max(1);
        for (number, answer) in answers.iter().enumerate() {
            let own = &positions[number * width..(number + 1) * width];
            match answer.mass {
                Some((mass, error)) => {
                    columns.set(first + number, Some(percuss::EffectiveMass::Finite(mass)), Some(error));
                }
                None => {
                    if let Ok(pose) = driven.pose_at(own, answer.residual) {
                        respond(&pose, &self.contact, first + number, columns);
                    }
                }
            }
        }
        if reached > 0 {
            self.stands = driven.pose();
        }
        reached
    }

    /// One row; where it is not reached the path goes on from where it stands.
    fn by_itself(&mut self, row: &[f64], at: usize, columns: &mut Columns) {
        let mechanism = &self.model.read.mechanism;
        let mut there = Configuration::zero(mechanism);
        for (joint, value) in self.joints.iter().zip(row) {
            if there.set(mechanism.joint(*joint).name(), &[*value]).is_err() {
                return;
            }
        }
        let Ok(pose) = self.assembly.pose_from(&self.stands, &there) else { return };
        respond(&pose, &self.contact, at, columns);
        let goes_on = self.driven.as_mut().is_some_and(|driven| driven.restart(&pose));
        if !goes_on {
            self.driven = pose.driven_path(&self.contact, &self.joints).ok().flatten();
        }
        self.stands = pose;
    }
}

fn respond(pose: &Posed, contact: &Resolved, at: usize, columns: &mut Columns) {
    if let Ok(response) = pose.respond(contact, RouteChoice::Auto) {
        columns.set(at, Some(response.effective_mass), response.effective_mass_error());
    }
}

#[pymethods]
impl Sweep {
    fn __len__(&self, py: Python<'_>) -> usize {
        self.status.bind(py).len()
    }

    fn __repr__(&self, py: Python<'_>) -> String {
        let (masses, codes) = (self.effective_mass.bind(py).readonly(), self.status.bind(py).readonly());
        let finite: Vec<f64> = masses.as_array().iter().copied().filter(|m| m.is_finite()).collect();
        let least = finite.iter().copied().reduce(f64::min);
        let most = finite.iter().copied().reduce(f64::max);
        let range = match (least, most) {
            (Some(least), Some(most)) => format!(", {least:.6} to {most:.6} kg"),
            _ => String::new(),
        };
        format!("<Sweep: {} configurations, {} finite{range}>", codes.len(), finite.len())
    }

    /// The picture as SVG: m̄ over the number of the row.
    fn to_svg(&self, py: Python<'_>) -> String {
        let masses = self.effective_mass.bind(py).readonly();
        let points = masses.as_array();
        let points = points.iter().enumerate();
        let points = points.map(|(row, m)| (row as f64, Some(*m).filter(|m| m.is_finite()))).collect();
        let mass = Series { name: "effective mass".into(), style: Style::Line, points };
        let figure = Figure {
            title: format!("Effective mass at {}", self.link),
            x_label: "row".into(),
            panels: vec![Panel { y_label: "m̄ (kg)".into(), series: vec![mass], ..Panel::default() }],
            ..Figure::default()
        };
        figure.to_svg()
    }

    fn _repr_html_(&self, py: Python<'_>) -> String {
        let heading = self.__repr__(py).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        format!("<div><p><code>{heading}</code></p>{}</div>", self.to_svg(py))
    }
}
