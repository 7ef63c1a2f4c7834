//! Python methods of systems and assemblies, and workspaces for one configuration after another.

use crate::analysis::contact::{Contact, GivenContact};
use crate::analysis::model::Model;
use crate::analysis::pose::Pose;
use crate::analysis::response::status;
use crate::analysis::system::{
    Assembly, GivenConditions, System, base_name, by_name, configuration, numbers, pose_configuration,
    position_names, root_frame, seven_numbers,
};
use crate::conversion::arrays::Numbers;
use crate::conversion::diagnostic::Diagnostic;
use crate::conversion::errors::{self, input, of_argument};
use crate::conversion::labels::Labels;
use crate::conversion::pickle::{Rebuilt, result_of};
use crate::conversion::threads::interruptible_if_large;
use numpy::PyArray1;
use percuss::spatial::Transform;
use percuss::study::response_findings;
use percuss::{
    Batch, Configuration, Contact as Resolved, DepartingAxis, Direction, DrawnGap, EffectiveMass, Frame,
    RigidLoops,
};
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{IntoPyDict, PyAny, PyDict, PyTuple};
use std::sync::Arc;

#[pymethods]
impl System {
    /// The model.
    #[getter]
    fn model(&self) -> Model {
        self.model.clone()
    }

    /// n: independent velocities of the tree, without locked joints and mimics; a floating base counts 6.
    #[getter]
    fn coordinates(&self) -> usize {
        self.system.coordinates()
    }

    /// Joint (None for the base) and velocity number of each coordinate, in the order of M, A, j.
    #[getter]
    fn coordinate_joints(&self) -> Vec<(Option<String>, usize)> {
        let name = |joint| self.model.read.mechanism.joint(joint).name().to_owned();
        self.system.coordinate_joints().into_iter().map(|(joint, number)| (joint.map(name), number)).collect()
    }

    /// Assembles the loops, from all joints at 0 or from guesses (joint to position). Raises AssemblyError.
    #[pyo3(signature = (guess=None))]
    pub fn assemble(&self, py: Python<'_>, guess: Option<&Bound<'_, PyDict>>) -> PyResult<Assembly> {
        let assembly = match guess {
            None => self.assemble_at_zero(py)?,
            Some(_) => {
                let given = configuration(&self.model.read.mechanism, None, guess)?;
                interruptible_if_large(py, self.system.coordinates(), || self.system.assemble(&given))?
                    .map_err(errors::assembly)?
            }
        };
        let guess = Arc::new(numbers(guess, "guess")?);
        Ok(Assembly { model: self.model.clone(), system: self.clone(), assembly, guess })
    }

    /// The pose at a configuration, with closed loops.
    ///
    /// q: dict of driving joints to their positions (rad, m; quaternions w, x, y, z), others at 0; or the positions of
    /// all joints, (p,): driving joints keep the given positions, dependent joints take the nearest solution; a pandas
    /// Series is matched by name (Model.position_names). guess: initial positions in the search for dependent joints.
    /// base_pose: pose of the root link in the world, x, y, z (m), w, x, y, z; contacts with normal_frame="world" and
    /// travels refer to that world. other_assembly: accepts a pose on another assembly mode, beyond the reach of the
    /// branch of the first closed pose. Raises AssemblyError.
    #[pyo3(signature = (q=None, *, guess=None, base_pose=None, other_assembly=false))]
    pub fn pose(
        &self,
        py: Python<'_>,
        q: Option<&Bound<'_, PyAny>>,
        guess: Option<&Bound<'_, PyDict>>,
        base_pose: Option<&Bound<'_, PyAny>>,
        other_assembly: bool,
    ) -> PyResult<Pose> {
        let given = pose_configuration(&self.model.read.mechanism, q, guess, base_pose, other_assembly)?;
        let pose = interruptible_if_large(py, self.system.coordinates(), || self.system.pose(&given))?
            .map_err(errors::assembly)?;
        Ok(Pose { model: self.model.clone(), system: self.clone(), guess: Arc::default(), pose })
    }

    /// Conditions as given: the arguments of Model.system.
    #[getter]
    fn _conditions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.keywords(py)?.into_py_dict(py)
    }

    /// Pickles a system as its model and the conditions as given.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Rebuilt<'py>> {
        result_of(
            self.model.clone().into_bound_py_any(py)?,
            "system",
            PyTuple::empty(py),
            &self.keywords(py)?,
        )
    }

    fn __repr__(&self) -> String {
        let root = base_name(self.system.base());
        format!(
            "<System of \"{}\": {} coordinates, {root} base>",
            self.model.read.mechanism.name(),
            self.system.coordinates()
        )
    }
}

impl System {
    /// Conditions as given: names and values of the arguments of Model.system.
    pub fn keywords<'py>(&self, py: Python<'py>) -> PyResult<[(&'static str, Bound<'py, PyAny>); 4]> {
        let GivenConditions { base, lock, armature, hold } = &*self.conditions;
        let holds =
            hold.iter().cloned().map(|hold| hold.into_bound_py_any(py)).collect::<PyResult<Vec<_>>>()?;
        Ok([
            ("base", base_name(*base).into_bound_py_any(py)?),
            ("lock", lock.into_bound_py_any(py)?),
            ("armature", by_name(py, armature)?.into_any()),
            ("hold", holds.into_bound_py_any(py)?),
        ])
    }
}

#[pymethods]
impl Assembly {
    /// The model.
    #[getter]
    fn model(&self) -> Model {
        self.model.clone()
    }

    /// Degrees of freedom at a generic pose; a floating base counts 6.
    #[getter]
    fn degrees_of_freedom(&self) -> usize {
        self.assembly.degrees_of_freedom()
    }

    /// Rows of A that are redundant at a generic pose.
    #[getter]
    fn redundant_constraints(&self) -> usize {
        self.assembly.redundant_constraints()
    }

    /// Groups of loops and couplings with redundant rows; a group cannot be separated further.
    #[getter]
    fn redundant_loops(&self) -> Vec<Vec<String>> {
        self.assembly.redundant_loops().to_vec()
    }

    /// Joints that drive the loops.
    #[getter]
    fn drivers(&self) -> Vec<String> {
        let name = |joint| self.model.read.mechanism.joint(joint).name().to_owned();
        self.assembly.drivers().into_iter().map(name).collect()
    }

    /// Loops and couplings that leave their joints no motion at a generic pose, without regard to locks and holds, as
    /// dicts: "loops" and "joints" (names), and "departing": for each loop whose other axes fit a planar motion, the
    /// axis that does not fit, with "closure", "joint" (None: the loop's own axis), "slides" (true for the axis of a
    /// slide, which should be normal to the direction), "angle" (rad) and "direction", shared by the other hinges
    /// ((3,), root link's axes).
    fn rigid_loops<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let name = |joint| self.model.read.mechanism.joint(joint).name();
        let departing = |axis: &DepartingAxis| {
            let found = PyDict::new(py);
            found.set_item("closure", &axis.closure)?;
            found.set_item("joint", axis.joint.map(name))?;
            found.set_item("slides", axis.slides)?;
            found.set_item("angle", axis.angle)?;
            found.set_item("direction", PyArray1::from_slice(py, axis.direction.as_slice()))?;
            PyResult::Ok(found)
        };
        let one = |rigid: RigidLoops| {
            let found = PyDict::new(py);
            found.set_item("loops", &rigid.loops)?;
            found.set_item("joints", rigid.joints.iter().map(|joint| name(*joint)).collect::<Vec<_>>())?;
            let departing = rigid.departing.iter().map(departing).collect::<PyResult<Vec<_>>>()?;
            found.set_item("departing", departing)?;
            Ok(found)
        };
        self.assembly.rigid_loops().into_iter().map(one).collect()
    }

    /// Loops and couplings that are open as drawn (all joints at 0, or at the guess), as dicts: "constraint", "gap"
    /// (m), "size" of its group (m), "moved" (the joint with the largest motion in closing, and this motion, rad or m;
    /// or None), "is_wide": the gap exceeds a hundredth of the size, so it is not rounding.
    fn drawn_gaps<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let one = |gap: DrawnGap| {
            let found = PyDict::new(py);
            found.set_item("constraint", gap.constraint)?;
            found.set_item("gap", gap.gap)?;
            found.set_item("size", gap.size)?;
            let name = |(joint, by)| (self.model.read.mechanism.joint(joint).name(), by);
            found.set_item("moved", gap.moved.map(name))?;
            found.set_item("is_wide", gap.is_wide)?;
            Ok(found)
        };
        self.assembly.drawn_gaps().into_iter().map(one).collect()
    }

    /// The pose at a configuration of this assembly; parameters as for System.pose.
    #[pyo3(signature = (q=None, *, guess=None, base_pose=None, other_assembly=false))]
    fn pose(
        &self,
        py: Python<'_>,
        q: Option<&Bound<'_, PyAny>>,
        guess: Option<&Bound<'_, PyDict>>,
        base_pose: Option<&Bound<'_, PyAny>>,
        other_assembly: bool,
    ) -> PyResult<Pose> {
        let given = pose_configuration(&self.model.read.mechanism, q, guess, base_pose, other_assembly)?;
        let pose =
            interruptible_if_large(py, self.system.system.coordinates(), || self.assembly.pose(&given))?
                .map_err(errors::assembly)?;
        let (system, guess) = (self.system.clone(), Arc::clone(&self.guess));
        Ok(Pose { model: self.model.clone(), system, guess, pose })
    }

    /// Workspace of a contact, for one configuration after another. base_pose: pose of the root link in the world, for
    /// normals in the world; as for pose.
    #[pyo3(signature = (contact, *, base_pose=None))]
    fn workspace(
        &self,
        contact: GivenContact<'_>,
        base_pose: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Workspace> {
        let base = base_pose.map(root_frame).transpose()?;
        let contact = contact.resolve(&self.model.read.mechanism)?;
        let batch = self.assembly.batch(&in_root_axes(contact, base.as_ref())).map_err(errors::response)?;
        Ok(Workspace { of: self.clone(), contact, base, batch, last: None, positions: Vec::new() })
    }

    /// Conditions of the system, and the guess.
    #[getter]
    fn _conditions<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let conditions = self.system.keywords(py)?.into_py_dict(py)?;
        conditions.set_item("guess", by_name(py, &self.guess)?)?;
        Ok(conditions)
    }

    /// Pickles an assembly as its system and the guess.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Rebuilt<'py>> {
        let guess = if self.guess.is_empty() { None } else { Some(by_name(py, &self.guess)?) };
        result_of(self.system.clone().into_bound_py_any(py)?, "assemble", (guess,), &[])
    }

    fn __repr__(&self) -> String {
        format!(
            "<Assembly of \"{}\": {} degrees of freedom, {} redundant constraints>",
            self.model.read.mechanism.name(),
            self.assembly.degrees_of_freedom(),
            self.assembly.redundant_constraints()
        )
    }
}

/// Contact with a world normal converted to the root link's axes: batches place the root link at the world's origin.
pub fn in_root_axes(contact: Resolved, base: Option<&Transform<f64>>) -> Resolved {
    let normal = match (contact.normal, base, contact.against) {
        (Direction::Along(normal, Frame::World), Some(base), _)
        | (Direction::Along(normal, Frame::Against), Some(base), None) => {
            Direction::Along(base.inverse_vector(&normal), Frame::World)
        }
        (Direction::About(axis, Frame::World), Some(base), _)
        | (Direction::About(axis, Frame::Against), Some(base), None) => {
            Direction::About(base.inverse_vector(&axis), Frame::World)
        }
        (normal, ..) => normal,
    };
    Resolved { normal, ..contact }
}

/// Workspace of a contact, for one configuration after another. Concurrent use by two threads raises an error.
///
///     >>> workspace = arm.assemble().workspace(tool)
///     >>> workspace.effective_mass(q[0])
#[pyclass(module = "percuss")]
#[derive(Debug)]
pub struct Workspace {
    of: Assembly,
    contact: Resolved,
    base: Option<Transform<f64>>,
    batch: Batch,
    last: Option<EffectiveMass>,
    /// Positions of the last configuration.
    positions: Vec<f64>,
}

#[pymethods]
impl Workspace {
    /// m̄ in kg at the positions of all joints, (p,), with closed loops; None unless finite, with the outcome in
    /// status. A pandas Series is matched by name. findings holds the findings about the last result; Pose.respond
    /// returns more quantities.
    fn effective_mass(&mut self, q: &Bound<'_, PyAny>) -> PyResult<Option<f64>> {
        let mut q = Numbers::of(q, "q", &[1], "one dimension: the positions of all joints")?;
        if q.labels != Labels::default() {
            let names = position_names(&self.of.model.read.mechanism);
            q = q.in_order_of("q", &names, ": the positions of all joints")?;
        }
        self.last = None;
        let answer = match q.array.as_slice() {
            Ok(positions) => self.solve_at(positions),
            Err(_) => self.solve_at(&q.array.as_array().iter().copied().collect::<Vec<f64>>()),
        }?;
        self.last = Some(answer);
        Ok(if let EffectiveMass::Finite(m) = answer { Some(m) } else { None })
    }

    /// Outcome of the last configuration: "finite", "immovable" or "massless"; None before the first configuration, and
    /// after an error.
    #[getter]
    fn status(&self) -> Option<&'static str> {
        self.last.map(status)
    }

    /// Findings about the last configuration and its result, as in reports of the command line. Reading this property
    /// computes them, by Pose.respond at that configuration. None before the first configuration, and after an error.
    #[getter]
    fn findings(&self, py: Python<'_>) -> PyResult<Option<Vec<Diagnostic>>> {
        if self.last.is_none() {
            return Ok(None);
        }
        let Assembly { model, system, assembly, .. } = &self.of;
        let mut configuration =
            Configuration::from_positions(&model.read.mechanism, &self.positions).map_err(input)?;
        if let Some(base) = self.base {
            configuration.set_base(base);
        }
        interruptible_if_large(py, self.positions.len(), || {
            let pose = assembly.pose(&configuration).map_err(errors::assembly)?;
            let response = pose.respond(&self.contact).map_err(errors::response)?;
            let found = response_findings(&system.system, &pose, &self.contact, &response);
            Ok(Some(found.into_iter().map(Diagnostic).collect()))
        })?
    }

    /// Pickles a workspace as its assembly, contact and base pose.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Rebuilt<'py>> {
        let contact = Contact::of_resolved(&self.of.model.read.mechanism, &self.contact);
        let base = self.base.map(|base| seven_numbers(&base));
        let keywords = [("base_pose", base.into_bound_py_any(py)?)];
        result_of(self.of.clone().into_bound_py_any(py)?, "workspace", (contact,), &keywords)
    }

    fn __repr__(&self) -> &'static str {
        "<Workspace>"
    }
}

impl Workspace {
    /// m̄ at the positions of all joints; keeps the positions for `findings`.
    fn solve_at(&mut self, positions: &[f64]) -> PyResult<EffectiveMass> {
        if let Some(at) = positions.iter().position(|x| !x.is_finite()) {
            return Err(input(format_args!("q[{at}] is {}; expected finite numbers", positions[at])));
        }
        let answer = self.batch.effective_mass(positions).map_err(|error| of_argument("q")(input(error)))?;
        self.positions.clear();
        self.positions.extend_from_slice(positions);
        answer
            .mass
            .ok_or_else(|| errors::no_answer("there is no answer at these positions; Pose.respond says why"))
    }
}
