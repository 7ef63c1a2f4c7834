//! m̄ of one contact at many configurations, from arrays to arrays, with the interpreter released.

pub(crate) mod columns;
pub(crate) mod portions;
pub(crate) mod row_contacts;

use crate::analysis::contact::Contact;
use crate::analysis::matrices::mass_and_code;
use crate::analysis::model::Model;
use crate::analysis::system::{Assembly, System, position_names};
use crate::analysis::system_methods::in_root_axes;
use crate::conversion::arrays::{float64_matrix as matrix, shape};
use crate::conversion::diagnostic::Diagnostic;
use crate::conversion::errors::{self, input};
use crate::sweep::columns::{Columns, MASSLESS_TO_ROUNDING, zeros};
use crate::sweep::portions::{run_fixed_portions, run_timed_portions};
use crate::sweep::row_contacts::{BasePose, RowContacts};
use numpy::ndarray::{ArrayView2, s};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use percuss::study::row_findings;
use percuss::{
    Assembly as Assembled, Batch, BatchAnswer, BatchError, BatchPositions, Configuration,
    Contact as Resolved, DrivenPath, JointId, Pose as Posed, RemarkFlags, RowAnswer, RowHandler, RowPath,
};
use percuss_render::{Figure, Panel, Series, Style};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyAny;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};

/// Least and greatest block size of a thread, in configurations. At the greatest size, positions and results stay in
/// the cache.
const BLOCK_SIZES: (usize, usize) = (256, 1 << 11);
/// Blocks per thread and portion. Several blocks balance the load from other processes.
const BLOCKS_PER_THREAD: usize = 8;

/// m̄ of a contact at many configurations.
#[pyclass(frozen, module = "percuss")]
#[derive(Debug)]
pub struct Sweep {
    /// m̄, kg; NaN unless finite; (N,).
    #[pyo3(get)]
    effective_mass: Py<PyArray1<f64>>,
    /// Error of m̄, kg; NaN if not computed; (N,).
    #[pyo3(get)]
    error: Py<PyArray1<f64>>,
    /// 0 finite, 1 immovable, 2 massless, 3 no answer: the pose does not exist, or no route solves it; 4 massless to
    /// rounding only: error is then the largest possible m̄ of the contact; uint8, (N,).
    #[pyo3(get)]
    status: Py<PyArray1<u8>>,
    /// Findings about each row: RemarkFlags added together; uint32, (N,). Joint limits are checked with joints only.
    #[pyo3(get)]
    remarks: Py<PyArray1<u32>>,
    /// Link name in the title of the picture.
    link: String,
    /// Reason of the first row of a path without an answer.
    no_answer: Option<String>,
}

/// Arrays, link name and reason of a pickled sweep.
type PickledSweep =
    (Py<PyArray1<f64>>, Py<PyArray1<f64>>, Py<PyArray1<u8>>, Py<PyArray1<u32>>, String, Option<String>);

/// Model and assembly of a sweep.
fn model_and_assembly(model_or_assembly: &Bound<'_, PyAny>) -> PyResult<(Model, Arc<Assembled>)> {
    let from_system = |system: &System| {
        PyResult::Ok((system.model.clone(), system.assemble_at_zero(model_or_assembly.py())?))
    };
    if let Ok(found) = model_or_assembly.cast::<Assembly>() {
        Ok((found.get().model.clone(), Arc::clone(&found.get().assembly)))
    } else if let Ok(found) = model_or_assembly.cast::<System>() {
        from_system(found.get())
    } else if let Ok(model) = model_or_assembly.cast::<Model>() {
        from_system(&System::unconstrained(model.get())?)
    } else {
        Err(PyTypeError::new_err(format!(
            "model is {} ({}); expected a Model, as percuss.load reads it from a file, a System or an Assembly",
            model_or_assembly.repr()?,
            model_or_assembly.get_type().name()?
        )))
    }
}

/// m̄ of a contact at the rows of q, on all processors. Results do not depend on the number of processors.
///
/// model: a Model, System or Assembly. q: (N, p) float64, rad, m: the positions of all joints in the order of the file,
/// with closed loops (positions of a Pose satisfy this); mimics are not read. Any strides: a C-ordered array is read in
/// place, and an F-ordered array is the fastest. Other numeric types are converted.
///
/// joints: names of the driving joints in the columns of q, with one position each: (N, len(joints)). Other joints are
/// at 0 or follow; loops are closed, and each row continues from the row before, on one branch. Unreachable rows have
/// no answer.
///
/// A DataFrame is matched by its column names, which are those of joints or of Model.position_names, in any order.
///
/// points, normals: (N, 3), a contact point (m, in the contact link's frame) and a normal (in the frame of the contact's
/// normal, of any length) for each row, instead of those of the contact. A DataFrame has the columns x, y, z.
///
/// base_pose: pose of the root link in the world, x, y, z (m), w, x, y, z, for normals in the world: (7,), or (N, 7), one
/// for each row; default: the world's origin. other_assembly: also solves rows on another assembly mode, beyond the reach of the branch of the
/// first closed pose; otherwise these rows have no answer. Ctrl-C stops the sweep.
#[pyfunction]
#[pyo3(signature = (model, contact, q, *, joints=None, base_pose=None, other_assembly=false, points=None, normals=None))]
#[allow(clippy::too_many_arguments, reason = "the question of a sweep")]
pub fn sweep(
    py: Python<'_>,
    model: &Bound<'_, PyAny>,
    contact: &Contact,
    q: &Bound<'_, PyAny>,
    joints: Option<&Bound<'_, PyAny>>,
    base_pose: Option<&Bound<'_, PyAny>>,
    other_assembly: bool,
    points: Option<&Bound<'_, PyAny>>,
    normals: Option<&Bound<'_, PyAny>>,
) -> PyResult<Sweep> {
    let (model, assembly) = model_and_assembly(model)?;
    let joints = joints.map(column_names).transpose()?;
    let (names, hint) = match &joints {
        Some(names) => (names.clone(), ": those of joints"),
        None => {
            let hint = ": the positions of all joints (Model.position_names); or joints=[…] with the names of the columns";
            (position_names(&model.read.mechanism), hint)
        }
    };
    let q = matrix(q, "q", "(N, p): a row for each configuration", &names, hint)?;
    let count = q.shape()[0];
    let base = BasePose::of(base_pose, count)?;
    let given = contact.resolve(&model.read.mechanism)?;
    let contacts = RowContacts::of(&given, points, normals, &base, count)?;
    let resolved = in_root_axes(given, base.one());
    let batch = assembly.batch(&resolved).map_err(errors::response)?;
    let (effective_mass, mut masses) = zeros(py, count);
    let (error, mut errors) = zeros(py, count);
    let (status, mut codes) = zeros(py, count);
    let (remarks, mut flags) = zeros(py, count);
    let mut no_answer = None;
    let columns = Columns {
        masses: masses.as_slice_mut()?,
        errors: errors.as_slice_mut()?,
        codes: codes.as_slice_mut()?,
        remarks: flags.as_slice_mut()?,
        has_base_pose: base.is_given(),
    };
    match joints {
        None => {
            let (width, expected) = (q.shape()[1], model.position_count());
            if width != expected {
                return Err(input(format_args!(
                    "q has shape {}; expected {expected} columns, the positions of all joints (Model.position_names), or \
                     joints=[…] with the names of the columns{}",
                    shape(q.shape()),
                    if count == expected { "; of its transpose, q.T, there are as many" } else { "" }
                )));
            }
            solve_all_positions(py, (&batch, contacts.as_ref()), &q, columns)?;
        }
        Some(names) => {
            let position_indices = drivers(&model, &names, q.shape())?;
            match assembly.groups().is_empty() {
                true => solve_tree(py, (&batch, contacts.as_ref()), &model, &q, &position_indices, columns)?,
                false if contacts.is_some() => {
                    return Err(input(
                        "points, normals and a base_pose for each row need the positions of all joints if the model has loops: \
                         give q without joints, with the positions of a Pose in each row",
                    ));
                }
                false => {
                    let path = PathColumns {
                        model: &model,
                        assembly: &assembly,
                        contact: resolved,
                        joints: position_indices.iter().map(|(joint, _)| *joint).collect(),
                        other_assembly,
                        columns,
                        first: 0,
                        no_answer: None,
                    };
                    no_answer = path.solve(py, &q)?;
                }
            }
        }
    }
    drop((masses, errors, codes, flags));
    Ok(Sweep {
        effective_mass: effective_mass.unbind(),
        error: error.unbind(),
        status: status.unbind(),
        remarks: remarks.unbind(),
        link: contact.link.clone(),
        no_answer,
    })
}

/// Names from a list or another sequence of strings; a single string is refused.
fn column_names(names: &Bound<'_, PyAny>) -> PyResult<Vec<String>> {
    names.extract().map_err(|_| {
        let given = names.repr().map_or_else(|_| "no text".to_owned(), |text| text.to_string());
        input(format_args!("joints is {given}; expected a list of names, one for each column"))
    })
}

/// Driving joint of each column of q, with its index in the position vector. `given`: the shape of q.
fn drivers(model: &Model, names: &[String], given: &[usize]) -> PyResult<Vec<(JointId, usize)>> {
    if given[1] != names.len() {
        return Err(input(format_args!(
            "q has shape {}; joints names {} columns",
            shape(given),
            names.len()
        )));
    }
    let mechanism = &model.read.mechanism;
    // `set` refuses unknown names, mimics and repeated joints.
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

/// True if every number is finite. The loop visits all entries so that it vectorizes; a sum or an early exit would take
/// as long as solving an arm.
fn is_finite(values: &[f64]) -> bool {
    !values.iter().fold(false, |bad, x| bad | !x.is_finite())
}

/// Error that names the first nonfinite entry of some rows.
fn nonfinite_error(q: ArrayView2<'_, f64>, rows: Range<usize>) -> PyErr {
    let entries = rows.flat_map(|row| (0..q.ncols()).map(move |column| (row, column)));
    let mut nonfinite = entries.filter(|entry| !q[*entry].is_finite());
    let (row, column) = nonfinite.next().unwrap_or_default();
    input(format_args!("q[{row}, {column}] is {}; expected finite numbers", q[(row, column)]))
}

/// Layout of the rows of q.
#[derive(Clone, Copy)]
enum Rows<'a> {
    /// All positions, row by row.
    RowMajor(&'a [f64]),
    /// All positions, column by column.
    Columns(&'a [f64]),
    /// All positions, with any strides.
    Strided,
    /// Some positions: `position_indices` maps each column to its position; `zero_positions` holds all positions of the zero
    /// configuration.
    Some { position_indices: &'a [usize], zero_positions: &'a [f64] },
}

/// Solves the rows of q in blocks, on all threads. Each number is read, checked, solved and written while it is in the
/// cache.
fn solve_rows(
    py: Python<'_>,
    (batch, contacts): (&Batch, Option<&RowContacts>),
    q: ArrayView2<'_, f64>,
    layout: Rows<'_>,
    columns: Columns<'_>,
) -> PyResult<()> {
    let count = q.nrows();
    // Pool of position buffers.
    let buffers = Mutex::new(Vec::new());
    let buffers = || buffers.lock().unwrap_or_else(PoisonError::into_inner);
    let common_remarks = columns.reported_bits(batch.remarks());
    run_timed_portions(py, count, |rows| {
        // Of the pool of this process.
        let threads = rayon::current_num_threads();
        let block = rows.len().div_ceil(threads * BLOCKS_PER_THREAD).clamp(BLOCK_SIZES.0, BLOCK_SIZES.1);
        let masses = columns.masses[rows.clone()].par_chunks_mut(block);
        let errors = columns.errors[rows.clone()].par_chunks_mut(block);
        let codes = columns.codes[rows.clone()].par_chunks_mut(block);
        let remarks = columns.remarks[rows.clone()].par_chunks_mut(block);
        let base = if columns.has_base_pose { RemarkFlags::BASE_NOT_GIVEN.bits() } else { 0 };
        let blocks = masses.zip(errors).zip(codes.zip(remarks)).enumerate();
        let done = blocks.try_for_each(|(number, ((masses, errors), (codes, remarks)))| {
            let first = rows.start + number * block;
            let row_positions = first..first + masses.len();
            let mut buffer = buffers().pop().unwrap_or_default();
            let Some(positions) = layout.block_positions(q, row_positions.clone(), &mut buffer) else {
                return Err(BlockFailure::NotFinite);
            };
            // `codes` already holds the code of finite masses, and `remarks` no finding.
            if common_remarks != 0 {
                remarks.fill(common_remarks);
            }
            let other = |at: usize, answer: BatchAnswer| {
                remarks[at] = answer.remarks.bits() & !base;
                let rounding = answer.is_massless_to_rounding();
                codes[at] = if rounding { MASSLESS_TO_ROUNDING } else { mass_and_code(answer.mass).1 };
            };
            let done = match contacts {
                None => batch.run_columns(positions, masses, errors, other),
                Some(contacts) => {
                    let contacts = contacts.of_rows(row_positions);
                    batch.run_contacts(positions, contacts, masses, errors, other)
                }
            };
            done.map_err(BlockFailure::Refused)?;
            buffers().push(buffer);
            Ok(())
        });
        done.map_err(|failure| match failure {
            BlockFailure::NotFinite => nonfinite_error(q, rows),
            BlockFailure::Refused(error) => input(error),
        })
    })
}

/// Reason for a failed block.
enum BlockFailure {
    NotFinite,
    Refused(BatchError),
}

impl<'a> Rows<'a> {
    /// Positions of a range of rows; `None` if a number is not finite.
    fn block_positions<'b>(
        self,
        q: ArrayView2<'_, f64>,
        rows: Range<usize>,
        buffer: &'b mut Vec<f64>,
    ) -> Option<BatchPositions<'b>>
    where
        'a: 'b,
    {
        let (count, width, row_count) = (q.nrows(), q.ncols(), rows.len());
        let (values, positions) = match self {
            Rows::RowMajor(values) => {
                let values = &values[rows.start * width..rows.end * width];
                (values, BatchPositions::Rows { values, stride: width })
            }
            Rows::Columns(values) => {
                let column = |c: usize| &values[c * count..][rows.clone()];
                let positions = BatchPositions::Columns {
                    values: values.get(rows.start..).unwrap_or_default(),
                    stride: count,
                };
                return (0..width).all(|c| is_finite(column(c))).then_some(positions);
            }
            Rows::Strided => {
                buffer.clear();
                q.slice(s![rows, ..]).rows().into_iter().for_each(|row| buffer.extend(row));
                (&buffer[..], BatchPositions::Rows { values: buffer, stride: width })
            }
            // Column by column: the fastest layout.
            Rows::Some { position_indices, zero_positions } => {
                buffer.clear();
                zero_positions.iter().for_each(|x| buffer.extend(std::iter::repeat_n(*x, row_count)));
                for (column, index) in position_indices.iter().enumerate() {
                    let to = &mut buffer[index * row_count..(index + 1) * row_count];
                    to.iter_mut().zip(q.slice(s![rows.clone(), column])).for_each(|(to, x)| *to = *x);
                }
                (&buffer[..], BatchPositions::Columns { values: buffer, stride: row_count })
            }
        };
        is_finite(values).then_some(positions)
    }
}

/// Solves rows with all positions.
fn solve_all_positions(
    py: Python<'_>,
    batch: (&Batch, Option<&RowContacts>),
    q: &PyReadonlyArray2<'_, f64>,
    columns: Columns<'_>,
) -> PyResult<()> {
    let layout = match q.as_slice() {
        Ok(values) if q.is_c_contiguous() => Rows::RowMajor(values),
        Ok(values) => Rows::Columns(values),
        Err(_) => Rows::Strided,
    };
    solve_rows(py, batch, q.as_array(), layout, columns)
}

/// Solves rows with some positions and the others at 0, for mechanisms without loops.
fn solve_tree(
    py: Python<'_>,
    batch: (&Batch, Option<&RowContacts>),
    model: &Model,
    q: &PyReadonlyArray2<'_, f64>,
    position_indices: &[(JointId, usize)],
    columns: Columns<'_>,
) -> PyResult<()> {
    let mechanism = &model.read.mechanism;
    let zero = Configuration::zero(mechanism);
    let zero_positions: Vec<f64> = mechanism.joint_ids().flat_map(|joint| zero.get(joint).to_vec()).collect();
    let position_indices: Vec<usize> = position_indices.iter().map(|(_, index)| *index).collect();
    solve_rows(
        py,
        batch,
        q.as_array(),
        Rows::Some { position_indices: &position_indices, zero_positions: &zero_positions },
        columns,
    )
}

/// Rows of the drivers of a linkage, with the columns of their results.
struct PathColumns<'a> {
    model: &'a Model,
    assembly: &'a Arc<Assembled>,
    contact: Resolved,
    joints: Vec<JointId>,
    /// True if rows on another assembly mode are solved.
    other_assembly: bool,
    columns: Columns<'a>,
    /// Number of the first row of the portion.
    first: usize,
    /// Reason of the first row without an answer.
    no_answer: Option<String>,
}

impl PathColumns<'_> {
    /// Solves all rows; returns the reason of the first row without an answer.
    fn solve(mut self, py: Python<'_>, q: &PyReadonlyArray2<'_, f64>) -> PyResult<Option<String>> {
        let zero = Configuration::zero(&self.model.read.mechanism);
        let start = self.assembly.pose(&zero).map_err(errors::assembly)?;
        let mut path = RowPath::new(Some(Arc::new(start)));
        let view = q.as_array();
        let mut values = Vec::new();
        run_fixed_portions(py, view.nrows(), |rows| {
            values.clear();
            view.slice(s![rows.clone(), ..]).rows().into_iter().for_each(|row| values.extend(row));
            if !is_finite(&values) {
                return Err(nonfinite_error(view, rows));
            }
            self.first = rows.start;
            path.follow(&values, rows.len(), &mut self);
            Ok(())
        })?;
        Ok(self.no_answer)
    }
}

impl RowHandler for PathColumns<'_> {
    type Shared = ();
    type Error = String;

    fn pose(&mut self, _: usize, row: &[f64], last: Option<&Posed>) -> Result<Arc<Posed>, String> {
        let mechanism = &self.model.read.mechanism;
        let mut configuration = Configuration::zero(mechanism);
        if self.other_assembly {
            configuration.allow_other_assembly();
        }
        for (joint, value) in self.joints.iter().zip(row) {
            configuration
                .set(mechanism.joint(*joint).name(), &[*value])
                .map_err(|error| error.to_string())?;
        }
        let pose = match last {
            Some(last) => self.assembly.pose_from(last, &configuration),
            None => self.assembly.pose(&configuration),
        };
        pose.map(Arc::new).map_err(|error| error.to_string())
    }

    fn driven_path(&mut self, pose: &Posed) -> Option<(DrivenPath, ())> {
        pose.driven_path(&self.contact, &self.joints).ok().flatten().map(|path| (path, ()))
    }

    fn receive(&mut self, row: usize, _: &[f64], answer: RowAnswer<'_, (), String>) {
        let at = self.first + row;
        let done = match answer {
            RowAnswer::Followed { mass: (mass, error), answer, .. } => {
                let mass = Some(percuss::EffectiveMass::Finite(mass));
                self.columns.set(at, mass, Some(error), answer.remarks);
                Ok(())
            }
            RowAnswer::Posed(pose) => self.columns.respond(&pose, &self.contact, at),
            RowAnswer::Unreached(reason) => Err(reason),
        };
        if let Err(reason) = done {
            self.columns.set(at, None, None, RemarkFlags::NO_ANSWER);
            self.no_answer.get_or_insert(reason);
        }
    }
}

/// Rebuilds a pickled sweep in another process.
#[pyfunction]
pub fn sweep_of_arrays(
    effective_mass: Py<PyArray1<f64>>,
    error: Py<PyArray1<f64>>,
    status: Py<PyArray1<u8>>,
    remarks: Py<PyArray1<u32>>,
    link: String,
    no_answer: Option<String>,
) -> Sweep {
    Sweep { effective_mass, error, status, remarks, link, no_answer }
}

#[pymethods]
impl Sweep {
    fn __len__(&self, py: Python<'_>) -> usize {
        self.status.bind(py).len()
    }

    /// Findings about the rows: one per kind of remark, with the first row and the number of further rows. Pose.respond
    /// at a row has the numbers.
    #[getter]
    fn findings(&self, py: Python<'_>) -> Vec<Diagnostic> {
        let flags = self.remarks.bind(py).readonly();
        let rows = flags.as_array();
        let rows = rows.iter().map(|bits| RemarkFlags::from_bits(*bits));
        row_findings(rows, self.no_answer.as_deref()).into_iter().map(Diagnostic).collect()
    }

    /// Arrays of the sweep, for pickle.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, PickledSweep)> {
        let [effective_mass, error] = [&self.effective_mass, &self.error].map(|array| array.clone_ref(py));
        let (status, remarks) = (self.status.clone_ref(py), self.remarks.clone_ref(py));
        let parts = (effective_mass, error, status, remarks, self.link.clone(), self.no_answer.clone());
        Ok((py.import("percuss")?.getattr("_sweep")?, parts))
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

    /// The picture as SVG: m̄ over the row number.
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

    /// Description and plot of the sweep, for notebooks.
    fn _repr_html_(&self, py: Python<'_>) -> String {
        let heading = self.__repr__(py).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        format!("<div><p><code>{heading}</code></p>{}</div>", self.to_svg(py))
    }
}
