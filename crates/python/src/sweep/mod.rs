//! m̄ of one contact at many configurations, from arrays to arrays, with the interpreter released.

pub(crate) mod impacts;
pub(crate) mod path;
pub(crate) mod portions;
pub(crate) mod result;
pub(crate) mod row_contacts;
pub(crate) mod rows;

use crate::analysis::contact::GivenContact;
use crate::analysis::model::Model;
use crate::analysis::state::positions_and_base;
use crate::analysis::system::{Assembly, System, position_names, velocity_names};
use crate::analysis::system_methods::in_root_axes;
use crate::conversion::arrays::{float64_matrix as matrix, shape};
use crate::conversion::errors::{self, input};
use crate::conversion::labels::Labels;
use crate::conversion::threads::Threads;
use crate::sweep::path::PathColumns;
use crate::sweep::portions::Progress;
use crate::sweep::result::Sweep;
use crate::sweep::row_contacts::{BasePose, RowContacts, base_gradients};
use crate::sweep::rows::{RowQuestion, numbers_of, solve_rows};
use numpy::ndarray::IntoDimension;
use numpy::{Element, PyArray, PyArray1, PyArray2, PyArrayMethods, PyReadwriteArray1, PyUntypedArrayMethods};
use percuss::spatial::Transform;
use percuss::{
    Assembly as Assembled, BatchRows, Configuration, GivenPositions, JointId, RowColumns, System as Compiled,
};
use pyo3::prelude::*;
use pyo3::types::PyAny;
use std::ops::Range;
use std::sync::Arc;

/// Numbers of an inverse operational inertia: 6×6.
const INERTIA_NUMBERS: usize = 36;

/// Model, system and assembly of a sweep.
pub fn parts_of(given: &Bound<'_, PyAny>) -> PyResult<(Model, Compiled, Arc<Assembled>)> {
    let from_system = |system: &System| {
        PyResult::Ok((system.model.clone(), system.system.clone(), system.assemble_at_zero(given.py())?))
    };
    if let Ok(found) = given.cast::<Assembly>() {
        let found = found.get();
        Ok((found.model.clone(), found.system.system.clone(), Arc::clone(&found.assembly)))
    } else if let Ok(found) = given.cast::<System>() {
        from_system(found.get())
    } else if let Ok(model) = given.cast::<Model>() {
        from_system(&System::unconstrained(model.get())?)
    } else {
        Err(errors::argument_type(format_args!(
            "model is {} ({}); expected a Model, as percuss.load reads it from a file, a System or an Assembly",
            given.repr()?,
            given.get_type().name()?
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
/// A State in place of q gives positions and base_pose. ignore: columns of a table that are no positions. nan: "refuse" raises InputError for
/// a position that is not a finite number; with "no answer" its row has the status NO_ANSWER and the remark NOT_FINITE, if m̄ depends on
/// that position.
///
/// base_pose: pose of the root link in the world, x, y, z (m), w, x, y, z, for normals in the world: (7,), or (N, 7), one
/// for each row; default: the world's origin. other_assembly: also solves rows on another assembly mode, beyond the reach of the branch of the
/// first closed pose; otherwise these rows have no answer. Ctrl-C stops the sweep.
///
/// gradient, inverse_operational_inertia: True also computes Sweep.gradient and Sweep.base_gradient, Sweep.inverse_operational_inertia. threads: number of
/// threads of this call, 1 to 1024; default: those of set_threads. progress: function of the numbers of finished rows and of all
/// rows, called about 20 times a second; its exceptions stop the sweep.
///
///     >>> percuss.sweep(arm, tool, q).effective_mass
///     >>> percuss.sweep(model, contact, [[0.1], [0.2]], joints=["crank_hinge"]).effective_mass
#[pyfunction]
#[pyo3(signature = (model, contact, q, *, joints=None, base_pose=None, other_assembly=false, points=None, normals=None,
    gradient=false, inverse_operational_inertia=false, ignore=Vec::new(), nan="refuse", threads=None, progress=None))]
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
    ignore: Vec<String>,
    nan: &str,
    threads: Option<usize>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Sweep> {
    let (threads, progress) = (Threads::of(threads)?, Progress::of(progress)?);
    let (model, _, assembly) = parts_of(model)?;
    let finite_only = match nan {
        "refuse" => true,
        "no answer" => false,
        _ => return Err(input(format_args!("nan is \"{nan}\"; expected \"refuse\" or \"no answer\""))),
    };
    let (q, base_pose) = positions_and_base(q, base_pose, &model.read.mechanism)?;
    let q = without_columns(&q, &ignore)?;
    let index = Labels::index_of(&q)?;
    let (q, base_pose) = (&q, base_pose.as_ref());
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
    let row_contacts = RowContacts::of(&given, points, normals, &base, count)?;
    let contacts = row_contacts.as_ref().map(RowContacts::all);
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
    // The gradient by the twist of the root link follows from Λ⁻¹.
    let base_needs_inverse = gradient && base_gradients::needs_inverse_inertia(&resolved);
    let mut inverses =
        (inverse_operational_inertia || base_needs_inverse).then(|| zeros(py, count * INERTIA_NUMBERS));
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
    let rows = BatchRows { positions: numbers_of(&q)?, given: None, contacts, finite_only };
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
                    finite_only,
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
    let base_gradient = match (gradient, base_gradients::is_zero(&resolved), &mut inverses) {
        (false, ..) | (true, false, None) => None,
        (true, true, _) => Some(zeros(py, count * 6)),
        (true, false, Some((_, inverses))) => {
            let (array, mut values) = zeros(py, count * 6);
            let (masses, gradients) = (masses.as_slice()?, slice_of(&mut gradients)?.unwrap_or_default());
            let normals = row_contacts.as_ref().map(|contacts| contacts.all().normals);
            base_gradients::fill(
                &resolved,
                normals,
                masses,
                gradients,
                inverses.as_slice()?,
                values.as_slice_mut()?,
            );
            Some((array, values))
        }
    };
    drop((masses, errors, codes, flags));
    let inverses = inverses.filter(|_| inverse_operational_inertia);
    Ok(Sweep {
        effective_mass: effective_mass.unbind(),
        error: error.unbind(),
        status: status.unbind(),
        remarks: remarks.unbind(),
        gradient: gradients.map(|array| reshaped(array, [count, velocities])).transpose()?,
        base_gradient: base_gradient.map(|array| reshaped(array, [count, 6])).transpose()?,
        inverse_operational_inertia: inverses.map(|array| reshaped(array, [count, 6, 6])).transpose()?,
        link: model.read.mechanism.link(given.link).name().to_owned(),
        no_answer,
        index,
        velocity_names: velocity_names(&model.read.mechanism),
    })
}

/// Table without the columns of `ignore`.
fn without_columns<'py>(q: &Bound<'py, PyAny>, ignore: &[String]) -> PyResult<Bound<'py, PyAny>> {
    if ignore.is_empty() {
        return Ok(q.clone());
    }
    let Some(columns) = Labels::of(q, "q")?.columns else {
        return Err(input("ignore: q has no named columns"));
    };
    if let Some(name) = ignore.iter().find(|name| !columns.contains(name)) {
        return Err(input(format_args!("ignore: q has no column \"{name}\"")));
    }
    q.get_item(columns.into_iter().filter(|name| !ignore.contains(name)).collect::<Vec<_>>())
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
