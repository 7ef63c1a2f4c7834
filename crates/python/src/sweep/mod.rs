//! m̄ of one contact at many configurations, from arrays to arrays, with the interpreter released.

pub(crate) mod portions;
pub(crate) mod row_contacts;
pub(crate) mod rows;

use crate::analysis::contact::GivenContact;
use crate::analysis::model::Model;
use crate::analysis::system::{Assembly, System, position_names};
use crate::analysis::system_methods::in_root_axes;
use crate::conversion::arrays::{float64_matrix as matrix, shape};
use crate::conversion::diagnostic::Diagnostic;
use crate::conversion::errors::{self, input};
use crate::conversion::threads::Threads;
use crate::sweep::portions::{Progress, run_portions};
use crate::sweep::row_contacts::{BasePose, RowContacts};
use crate::sweep::rows::{RowQuestion, numbers_of, refused_rows, solve_rows};
use numpy::ndarray::{IntoDimension, s};
use numpy::{
    Element, PyArray, PyArray1, PyArray2, PyArray3, PyArrayMethods, PyReadonlyArray2, PyReadwriteArray1,
    PyUntypedArrayMethods,
};
use percuss::spatial::Transform;
use percuss::study::row_findings;
use percuss::{
    Assembly as Assembled, Batch, BatchAnswer, BatchContacts, BatchPositions, BatchRows, Configuration,
    Contact as Resolved, DrivenPath, GivenPositions, JointId, Pose as Posed, RemarkFlags, RowAnswer,
    RowColumns, RowHandler, RowPath,
};
use percuss_render::{Figure, Panel, Picture, Series, Style};
use pyo3::prelude::*;
use pyo3::types::PyAny;
use std::ops::Range;
use std::sync::Arc;

/// Numbers of an inverse operational inertia: 6×6.
const INERTIA_NUMBERS: usize = 36;

/// m̄ of a contact at many configurations.
#[pyclass(frozen, module = "percuss")]
#[derive(Debug)]
pub struct Sweep {
    /// m̄, kg; NaN unless finite; (N,).
    #[pyo3(get)]
    effective_mass: Py<PyArray1<f64>>,
    /// Error of m̄, kg; NaN unless m̄ is finite, and with the remark UNKNOWN_ERROR; (N,).
    #[pyo3(get)]
    error: Py<PyArray1<f64>>,
    /// 0 finite, 1 immovable, 2 massless, 3 no answer: the pose does not exist, or no route solves it; 4 massless to
    /// rounding only: error is then the largest possible m̄ of the contact; uint8, (N,).
    #[pyo3(get)]
    status: Py<PyArray1<u8>>,
    /// Findings about each row: RemarkFlags added together; uint32, (N,).
    #[pyo3(get)]
    remarks: Py<PyArray1<u32>>,
    /// Gradients, if requested.
    gradient: Option<Py<PyArray2<f64>>>,
    /// Inverse operational inertias, if requested.
    inverse_operational_inertia: Option<Py<PyArray3<f64>>>,
    /// Link name in the title of the picture.
    link: String,
    /// Reason for the first missing answer of a path.
    no_answer: Option<String>,
}

/// Arrays, link name and reason of a pickled sweep.
type PickledSweep = (
    Py<PyArray1<f64>>,
    Py<PyArray1<f64>>,
    Py<PyArray1<u8>>,
    Py<PyArray1<u32>>,
    String,
    Option<String>,
    Option<Py<PyArray2<f64>>>,
    Option<Py<PyArray3<f64>>>,
);

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
        Err(errors::argument_type(format_args!(
            "model is {} ({}); expected a Model, as percuss.load reads it from a file, a System or an Assembly",
            model_or_assembly.repr()?,
            model_or_assembly.get_type().name()?
        )))
    }
}

/// m̄ of a contact at the rows of q, on all processors. Results do not depend on the number of processors.
///
/// model: a Model, System or Assembly. q: (N, p) float64, rad, m: the positions of all joints in the order of the file,
/// with closed loops (positions of a Pose satisfy this); mimics are not read. Any strides; an F-ordered array is the fastest. Other numeric
/// types are converted. The sweep works on a copy of the values at the call.
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
///
/// gradient, inverse_operational_inertia: True also computes Sweep.gradient, Sweep.inverse_operational_inertia. threads: number of
/// threads of this call, 1 to 1024; default: those of set_threads. progress: function of the numbers of finished rows and of all
/// rows, called about 20 times a second; its exceptions stop the sweep.
#[pyfunction]
#[pyo3(signature = (model, contact, q, *, joints=None, base_pose=None, other_assembly=false, points=None, normals=None,
    gradient=false, inverse_operational_inertia=false, threads=None, progress=None))]
#[allow(clippy::too_many_arguments, reason = "the question of a sweep")]
pub fn sweep(
    py: Python<'_>,
    model: &Bound<'_, PyAny>,
    contact: GivenContact<'_>,
    q: &Bound<'_, PyAny>,
    joints: Option<&Bound<'_, PyAny>>,
    base_pose: Option<&Bound<'_, PyAny>>,
    other_assembly: bool,
    points: Option<&Bound<'_, PyAny>>,
    normals: Option<&Bound<'_, PyAny>>,
    gradient: bool,
    inverse_operational_inertia: bool,
    threads: Option<usize>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Sweep> {
    let (threads, progress) = (Threads::of(threads)?, Progress::of(progress)?);
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
    let q = match q.is_contiguous() {
        true => q,
        false => PyArray2::from_owned_array(py, q.as_array().as_standard_layout().into_owned()).readonly(),
    };
    let count = q.shape()[0];
    let base = BasePose::of(base_pose, count)?;
    let given = contact.resolve(&model.read.mechanism)?;
    let contacts = RowContacts::of(&given, points, normals, &base, count)?;
    let contacts = contacts.as_ref().map(RowContacts::all);
    let resolved = in_root_axes(given, base.one());
    let mut workspace = assembly.workspace();
    let mut zero = Configuration::zero(&model.read.mechanism);
    if base.is_given() {
        // Normals are in the axes of the root link already.
        workspace.set_base(&Transform::identity()).map_err(input)?;
        zero.set_base(Transform::identity());
    }
    let batch = workspace.batch(&resolved).map_err(errors::response)?;
    let velocities = batch.velocities();
    let question = RowQuestion { batch: &batch, threads, progress: &progress };
    let mut gradients = gradient.then(|| zeros(py, count * velocities));
    let mut inverses = inverse_operational_inertia.then(|| zeros(py, count * INERTIA_NUMBERS));
    let (effective_mass, mut masses) = zeros(py, count);
    let (error, mut errors) = zeros(py, count);
    let (status, mut codes) = zeros(py, count);
    let (remarks, mut flags) = zeros(py, count);
    let mut no_answer = None;
    let columns = RowColumns {
        masses: masses.as_slice_mut()?,
        errors: errors.as_slice_mut()?,
        statuses: codes.as_slice_mut()?,
        remarks: Some(flags.as_slice_mut()?),
        gradients: slice_of(&mut gradients)?,
        inverse_inertias: slice_of(&mut inverses)?,
    };
    let rows = BatchRows { positions: numbers_of(&q)?, given: None, contacts, finite_only: true };
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
            solve_rows(py, question, rows, columns)?;
        }
        Some(names) => {
            let drivers = drivers(&model, &names, q.shape())?;
            if assembly.groups().is_empty() {
                let others: Vec<f64> =
                    model.read.mechanism.joint_ids().flat_map(|joint| zero.get(joint).to_vec()).collect();
                let indices: Vec<usize> = drivers.iter().map(|(_, index)| *index).collect();
                let given = Some(GivenPositions { indices: &indices, others: &others });
                solve_rows(py, question, BatchRows { given, ..rows }, columns)?;
            } else {
                let path = PathColumns {
                    start: Arc::new(assembly.pose(&zero).map_err(errors::assembly)?),
                    zero,
                    contact: resolved,
                    joints: drivers.iter().map(|(joint, _)| *joint).collect(),
                    other_assembly,
                    columns,
                    first: 0,
                    no_answer: None,
                    positions: Vec::new(),
                    unreached: Vec::new(),
                };
                no_answer = path.solve(py, &q, question, contacts)?;
            }
        }
    }
    drop((masses, errors, codes, flags));
    Ok(Sweep {
        effective_mass: effective_mass.unbind(),
        error: error.unbind(),
        status: status.unbind(),
        remarks: remarks.unbind(),
        gradient: gradients.map(|array| reshaped(array, [count, velocities])).transpose()?,
        inverse_operational_inertia: inverses.map(|array| reshaped(array, [count, 6, 6])).transpose()?,
        link: model.read.mechanism.link(given.link).name().to_owned(),
        no_answer,
    })
}

/// Array of numpy with its values.
type OwnedArray<'py> = (Bound<'py, PyArray1<f64>>, PyReadwriteArray1<'py, f64>);

/// Array of zeros in numpy's memory. numpy allocates large arrays in large pages, so the first write is almost free.
/// Pages of 4 kB would cost a third of the solution time of an arm.
fn zeros<T: Element>(py: Python<'_>, count: usize) -> (Bound<'_, PyArray1<T>>, PyReadwriteArray1<'_, T>) {
    let array = PyArray1::zeros(py, count, false);
    (array.clone(), array.readwrite())
}

/// Array in its final shape.
fn reshaped<S: IntoDimension>((array, _): OwnedArray<'_>, shape: S) -> PyResult<Py<PyArray<f64, S::Dim>>> {
    Ok(array.reshape(shape)?.unbind())
}

/// Values of an optional array.
fn slice_of<'a>(array: &'a mut Option<OwnedArray<'_>>) -> PyResult<Option<&'a mut [f64]>> {
    array.as_mut().map(|(_, values)| values.as_slice_mut().map_err(PyErr::from)).transpose()
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
    let places: Vec<Range<usize>> = mechanism.position_ranges().collect();
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
        Ok((id, places[id.index()].start))
    };
    names.iter().map(find).collect()
}

/// Rows of the drivers of a linkage, with the columns of their results.
struct PathColumns<'a> {
    /// Pose at which the path starts; its positions stand for those of rows without a pose, whose results are discarded.
    start: Arc<Posed>,
    zero: Configuration,
    contact: Resolved,
    joints: Vec<JointId>,
    /// True if rows on another assembly mode are solved.
    other_assembly: bool,
    columns: RowColumns<'a, u8>,
    /// Number of the first row of the portion.
    first: usize,
    /// Reason for the first missing answer.
    no_answer: Option<String>,
    /// Positions of all joints of the rows of the portion, row by row.
    positions: Vec<f64>,
    /// Rows of the portion without a pose.
    unreached: Vec<usize>,
}

/// Findings about a pose. They do not depend on the contact.
const POSE_FINDINGS: u32 = RemarkFlags::SINGULAR_POSE.bits()
    | RemarkFlags::OTHER_ASSEMBLY.bits()
    | RemarkFlags::DRAWN_OPEN.bits()
    | RemarkFlags::INEXACT_LOOPS.bits()
    | RemarkFlags::DRIVER_OFF_ZERO.bits()
    | RemarkFlags::OFF_TARGET.bits()
    | RemarkFlags::OUTSIDE_LIMITS.bits()
    | RemarkFlags::WEAKLY_CONSTRAINED.bits()
    | RemarkFlags::UNCLEAR_MOBILITY.bits();

/// Number of rows that a thread solves at once.
const PATH_BLOCK: usize = 64;

impl PathColumns<'_> {
    /// Solves all rows; returns the reason of the first row without an answer.
    fn solve(
        mut self,
        py: Python<'_>,
        q: &PyReadonlyArray2<'_, f64>,
        question: RowQuestion<'_>,
        contacts: Option<BatchContacts<'_>>,
    ) -> PyResult<Option<String>> {
        let mut path = RowPath::new(Some(Arc::clone(&self.start)));
        let is_followed_only =
            contacts.is_none() && self.columns.gradients.is_none() && self.columns.inverse_inertias.is_none();
        let RowQuestion { batch, threads, progress } = question;
        let (view, width) = (q.as_array(), q.shape()[1]);
        let mut values = Vec::new();
        run_portions(py, view.nrows(), true, (threads, progress), |rows| {
            values.clear();
            view.slice(s![rows.clone(), ..]).rows().into_iter().for_each(|row| values.extend(row));
            let checked =
                BatchPositions::Rows { values: &values, stride: width }.refuse_not_finite(width, rows.len());
            checked.map_err(|error| refused_rows(error.in_rows_from(rows.start)))?;
            self.first = rows.start;
            self.positions.clear();
            self.unreached.clear();
            path.follow(&values, rows.len(), &mut self);
            match is_followed_only {
                true => Ok(()),
                false => self.solve_at_positions(batch, contacts.map(|all| all.part(&rows)), rows),
            }
        })?;
        Ok(self.no_answer)
    }

    /// Solves the rows of a portion at the positions that the path reached: with a contact for each row, gradients or inverse inertias.
    fn solve_at_positions(
        &mut self,
        batch: &Batch,
        contacts: Option<BatchContacts<'_>>,
        rows: Range<usize>,
    ) -> PyResult<()> {
        let mut columns = self.columns.part(rows.clone());
        let of_poses: Vec<u32> =
            columns.remarks.iter().flat_map(|bits| bits.iter()).map(|bits| bits & POSE_FINDINGS).collect();
        let stride = self.start.positions().len();
        let positions = BatchPositions::Rows { values: &self.positions, stride };
        let all = 0..rows.len();
        batch
            .run(BatchRows { contacts, ..positions.into() }, columns.part(all), PATH_BLOCK)
            .map_err(input)?;
        for (bits, of_pose) in columns.remarks.iter_mut().flat_map(|bits| bits.iter_mut()).zip(of_poses) {
            *bits |= of_pose;
        }
        for row in self.unreached.drain(..).map(|row| row - rows.start) {
            columns.part(row..row + 1).clear();
            columns.set(row, &BatchAnswer::UNREACHED);
        }
        Ok(())
    }
}

impl RowHandler for PathColumns<'_> {
    type Shared = ();
    type Error = String;

    fn pose(&mut self, _: usize, row: &[f64], last: Option<&Posed>) -> Result<Arc<Posed>, String> {
        let assembly = self.start.assembly();
        let mut configuration = self.zero.clone();
        if self.other_assembly {
            configuration.allow_other_assembly();
        }
        for (joint, value) in self.joints.iter().zip(row) {
            configuration
                .set(self.start.mechanism().joint(*joint).name(), &[*value])
                .map_err(|error| error.to_string())?;
        }
        let pose = match last {
            Some(last) => assembly.pose_from(last, &configuration),
            None => assembly.pose(&configuration),
        };
        pose.map(Arc::new).map_err(|error| error.to_string())
    }

    fn driven_path(&mut self, pose: &Posed) -> Option<(DrivenPath, ())> {
        pose.driven_path(&self.contact, &self.joints).ok().flatten().map(|path| (path, ()))
    }

    fn receive(&mut self, row: usize, _: &[f64], answer: RowAnswer<'_, (), String>) {
        let at = self.first + row;
        let answer = match answer {
            RowAnswer::Followed { mass: (mass, error), answer, positions, .. } => {
                self.positions.extend_from_slice(positions);
                Ok(BatchAnswer::finite(mass, error, answer.remarks))
            }
            RowAnswer::Posed(pose) => {
                self.positions.extend_from_slice(pose.positions());
                let response = pose.respond(&self.contact);
                response.map(|response| BatchAnswer::from(&response)).map_err(|error| error.to_string())
            }
            RowAnswer::Unreached(reason) => {
                self.positions.extend_from_slice(self.start.positions());
                self.unreached.push(at);
                Err(reason)
            }
        };
        let answer = answer.unwrap_or_else(|reason| {
            self.no_answer.get_or_insert(reason);
            BatchAnswer::UNREACHED
        });
        self.columns.set(at, &answer);
    }
}

/// Array of a sweep; `NotComputedError` if the array was not requested.
fn requested<T>(array: Option<&Py<T>>, py: Python<'_>, name: &str) -> PyResult<Py<T>> {
    array.map(|array| array.clone_ref(py)).ok_or_else(|| {
        errors::not_computed(format_args!("{name} was not requested; call percuss.sweep(…, {name}=True)"))
    })
}

/// Rebuilds a pickled sweep in another process.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "the arrays of a sweep")]
pub fn sweep_of_arrays(
    effective_mass: Py<PyArray1<f64>>,
    error: Py<PyArray1<f64>>,
    status: Py<PyArray1<u8>>,
    remarks: Py<PyArray1<u32>>,
    link: String,
    no_answer: Option<String>,
    gradient: Option<Py<PyArray2<f64>>>,
    inverse_operational_inertia: Option<Py<PyArray3<f64>>>,
) -> Sweep {
    Sweep { effective_mass, error, status, remarks, gradient, inverse_operational_inertia, link, no_answer }
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

    /// Gradient of m̄ by the velocities of all joints (Model.velocity_names), kg/rad or kg/m; NaN unless m̄ is finite with an error of at most 1e-6 m̄; (N, n). With loops,
    /// only sums over admissible motions have a meaning. Raises NotComputedError unless the sweep had gradient=True.
    #[getter]
    fn gradient(&self, py: Python<'_>) -> PyResult<Py<PyArray2<f64>>> {
        requested(self.gradient.as_ref(), py, "gradient")
    }

    /// Φ = J M_c⁻¹ Jᵀ of the contact link at the contact point, in root axes, angular part first: the inverse of the operational
    /// inertia Λ; (N, 6, 6). The block [:, 3:, 3:] is that of forces, 1/kg. Raises NotComputedError unless the sweep had
    /// inverse_operational_inertia=True.
    #[getter]
    fn inverse_operational_inertia(&self, py: Python<'_>) -> PyResult<Py<PyArray3<f64>>> {
        requested(self.inverse_operational_inertia.as_ref(), py, "inverse_operational_inertia")
    }

    /// Arrays of the sweep, for pickle.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, PickledSweep)> {
        let [effective_mass, error] = [&self.effective_mass, &self.error].map(|array| array.clone_ref(py));
        let (status, remarks) = (self.status.clone_ref(py), self.remarks.clone_ref(py));
        let gradient = self.gradient.as_ref().map(|array| array.clone_ref(py));
        let inverse = self.inverse_operational_inertia.as_ref().map(|array| array.clone_ref(py));
        let (link, no_answer) = (self.link.clone(), self.no_answer.clone());
        let parts = (effective_mass, error, status, remarks, link, no_answer, gradient, inverse);
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
