//! Systems (a mechanism under conditions), assemblies (their loops put together), and m̄ at one configuration after another.

use crate::arrays::{Numbers, list, triple};
use crate::contact::Contact;
use crate::diagnostic::Diagnostic;
use crate::errors::{self, input};
use crate::labels::Labels;
use crate::model::Model;
use crate::pose::Pose;
use crate::response::status;
use numpy::PyArray1;
use percuss::nalgebra::Vector3;
use percuss::spatial::{Transform, rotation_from_quaternion};
use percuss::study::response_findings;
use percuss::{
    Assembly as Assembled, Base, Batch, Conditions, Configuration, Contact as Resolved, DepartingAxis,
    Direction, DrawnGap, EffectiveMass, Frame, Mechanism, RigidLoops, RouteChoice, System as Compiled,
};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};
use std::sync::Arc;

/// A mechanism under conditions. Cannot be changed: threads may share it.
#[pyclass(frozen, module = "percuss")]
#[derive(Clone, Debug)]
pub struct System {
    pub model: Model,
    pub system: Compiled,
}

/// A system whose loops are put together. Cannot be changed: threads may share it.
#[pyclass(frozen, module = "percuss")]
#[derive(Clone, Debug)]
pub struct Assembly {
    pub model: Model,
    pub system: Compiled,
    pub assembly: Arc<Assembled>,
}

/// Base by its name.
pub fn base(name: &str) -> PyResult<Base> {
    match name {
        "fixed" => Ok(Base::Fixed),
        "floating" => Ok(Base::Floating),
        _ => Err(input(format_args!("base is \"{name}\"; expected \"fixed\" or \"floating\""))),
    }
}

/// A held point as it is given: (link, point) or (link, point, normal).
pub type Held = (String, [f64; 3], Option<[f64; 3]>);

/// Reads what is held.
pub fn held(hold: &Bound<'_, PyAny>) -> PyResult<Held> {
    let parts: Vec<Bound<'_, PyAny>> = hold.extract()?;
    let (link, point, normal) = match &parts[..] {
        [link, point] => (link, point, None),
        [link, point, normal] => (link, point, Some(normal)),
        _ => return Err(input("hold: expected (link, point) or (link, point, normal)")),
    };
    let normal = normal.filter(|n| !n.is_none()).map(|n| triple(n, "normal of hold")).transpose()?;
    Ok((link.extract()?, triple(point, "point of hold")?, normal))
}

/// Names with numbers.
pub fn numbers(given: Option<&Bound<'_, PyDict>>, what: &str) -> PyResult<Vec<(String, Vec<f64>)>> {
    let Some(given) = given else { return Ok(Vec::new()) };
    let one = |(name, values): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name: String = name.extract()?;
        let values = list(&values, &format!("{what} of \"{name}\""))?;
        Ok((name, values))
    };
    given.iter().map(one).collect()
}

/// Names of all positions, in order: the joint's, or JOINT[0], JOINT[1], … where it has several.
pub fn position_names(mechanism: &Mechanism) -> Vec<String> {
    let of = |joint: &percuss::Joint| -> Vec<String> {
        match joint.kind().positions() {
            1 => vec![joint.name().to_owned()],
            count => (0..count).map(|i| format!("{}[{i}]", joint.name())).collect(),
        }
    };
    mechanism.joints().iter().flat_map(of).collect()
}

/// A configuration of joints by name, or of all positions.
pub fn configuration(
    mechanism: &Arc<Mechanism>,
    q: Option<&Bound<'_, PyAny>>,
    guess: Option<&Bound<'_, PyDict>>,
) -> PyResult<Configuration> {
    let mut found = match q {
        Some(q) if !q.is_instance_of::<PyDict>() => {
            let q = Numbers::of(q, "q", &[1], "one dimension, or a dict of joints")?;
            let q = q.in_order("q", &position_names(mechanism), ": the positions of all joints")?;
            let q: Vec<f64> = q.array.as_array().iter().copied().collect();
            Configuration::from_positions(mechanism, &q).map_err(input)?
        }
        _ => Configuration::zero(mechanism),
    };
    if let Some(by_name) = q.and_then(|q| q.cast::<PyDict>().ok()) {
        for (joint, values) in numbers(Some(by_name), "position")? {
            found.set(&joint, &values).map_err(input)?;
        }
    }
    for (joint, values) in numbers(guess, "guess")? {
        found.guess(&joint, &values).map_err(input)?;
    }
    Ok(found)
}

/// Pose of the root link in the world: 7 numbers, x, y, z (m), w, x, y, z (a unit quaternion).
pub fn root_frame(given: &Bound<'_, PyAny>) -> PyResult<Transform<f64>> {
    let values = list(given, "base_pose")?;
    let [x, y, z, quaternion @ ..] = &values[..] else {
        return Err(input(format_args!("base_pose has {} numbers; expected 7", values.len())));
    };
    if let Ok(axes) = given.getattr("shape").and_then(|shape| shape.extract::<Vec<usize>>())
        && axes != [7]
    {
        return Err(input(format_args!(
            "base_pose has shape {}; expected (7,): x, y, z (m), w, x, y, z (unit quaternion)",
            crate::arrays::shape(&axes)
        )));
    }
    let quaternion = <[f64; 4]>::try_from(quaternion)
        .map_err(|_| input(format_args!("base_pose has {} numbers; expected 7", values.len())))?;
    if let Some(value) = values.iter().find(|value| value.is_nan() || value.abs() > 1e100) {
        return Err(input(format_args!("base_pose has {value:e}; expected finite numbers of at most 1e100")));
    }
    let norm = quaternion.iter().fold(0.0_f64, |norm, x| norm.hypot(*x));
    if (norm - 1.0).abs() > 0.01 {
        return Err(input(format_args!(
            "base_pose: the quaternion w, x, y, z has norm {norm}; expected a unit quaternion"
        )));
    }
    Ok(Transform::new(rotation_from_quaternion(quaternion.map(|x| x / norm)), Vector3::new(*x, *y, *z)))
}

impl System {
    pub fn new(
        model: &Model,
        root: &str,
        lock: Vec<String>,
        armature: Option<&Bound<'_, PyDict>>,
        hold: Vec<Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let mut conditions = Conditions::new().base(base(root)?);
        for joint in lock {
            conditions = conditions.lock(joint);
        }
        for (joint, values) in numbers(armature, "armature")? {
            conditions = conditions.armature(joint, values);
        }
        for hold in &hold {
            let (link, point, normal) = held(hold)?;
            conditions = conditions.hold(link, point, normal.map(Vector3::from));
        }
        let system = Compiled::new(Arc::clone(&model.read.mechanism), &conditions).map_err(input)?;
        Ok(Self { model: model.clone(), system })
    }

    /// Every joint free, the base fixed.
    pub fn plain(model: &Model) -> PyResult<Self> {
        Self::new(model, "fixed", Vec::new(), None, Vec::new())
    }

    /// The loops put together from all joints at 0.
    pub fn reference(&self, py: Python<'_>) -> PyResult<Arc<Assembled>> {
        py.detach(|| self.system.reference().map(Arc::clone)).map_err(errors::assembly)
    }
}

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

    /// For each coordinate its joint, None for the base, and which of its velocities it is: the order of M, A, j.
    #[getter]
    fn coordinate_joints(&self) -> Vec<(Option<String>, usize)> {
        let name = |joint| self.model.read.mechanism.joint(joint).name().to_owned();
        self.system.coordinate_joints().into_iter().map(|(joint, number)| (joint.map(name), number)).collect()
    }

    /// Puts the loops together: from all joints at 0, else from guesses (joint to position). Raises AssemblyError.
    #[pyo3(signature = (guess=None))]
    pub fn assemble(&self, py: Python<'_>, guess: Option<&Bound<'_, PyDict>>) -> PyResult<Assembly> {
        let assembly = match guess {
            None => self.reference(py)?,
            Some(_) => {
                let given = configuration(&self.model.read.mechanism, None, guess)?;
                py.detach(|| self.system.assemble(&given)).map_err(errors::assembly)?
            }
        };
        Ok(Assembly { model: self.model.clone(), system: self.system.clone(), assembly })
    }

    /// The pose at a configuration, the loops closed.
    ///
    /// q: dict of driving joints to their positions (rad, m; quaternions w, x, y, z), others at 0; or the positions of all joints, (p,):
    /// driving joints stand where they are given, the others next to it; a pandas Series is matched by name
    /// (Model.position_names). guess: where dependent joints are looked for. base_pose: pose of the root link in the world, x, y, z (m),
    /// w, x, y, z; contacts with normal_frame="world" and travels refer to that world. other_assembly: accepts a pose on another
    /// assembly mode, where the branch of the first closed pose does not reach the driving joints. Raises AssemblyError.
    #[pyo3(signature = (q=None, *, guess=None, base_pose=None, other_assembly=false))]
    pub fn pose(
        &self,
        py: Python<'_>,
        q: Option<&Bound<'_, PyAny>>,
        guess: Option<&Bound<'_, PyDict>>,
        base_pose: Option<&Bound<'_, PyAny>>,
        other_assembly: bool,
    ) -> PyResult<Pose> {
        let mut given = configuration(&self.model.read.mechanism, q, guess)?;
        if let Some(frame) = base_pose {
            given.set_base(root_frame(frame)?);
        }
        if other_assembly {
            given.allow_other_assembly();
        }
        let pose = py.detach(|| self.system.pose(&given)).map_err(errors::assembly)?;
        Ok(Pose { model: self.model.clone(), system: self.system.clone(), pose })
    }

    fn __repr__(&self) -> String {
        let root = match self.system.base() {
            Base::Fixed => "fixed",
            Base::Floating => "floating",
        };
        format!(
            "<System of \"{}\": {} coordinates, {root} base>",
            self.model.read.mechanism.name(),
            self.system.coordinates()
        )
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

    /// Loops and couplings on which redundant rows lie, those that cannot be separated together.
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

    /// Loops and couplings that leave the joints that they bind no motion at a generic pose, whatever is locked or held, as
    /// dicts: "loops" and "joints" (names), and "departing": in each loop whose other axes fit a motion in a plane, the one that
    /// does not, with "closure", "joint" (None: the loop's own axis), "slides" (whether it is a slide's, which should be normal
    /// to the direction), "angle" (rad) and "direction" that the other hinges share ((3,), root link's axes).
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

    /// Loops and couplings that are not closed where they are drawn (all joints at 0, or as guessed), as dicts: "constraint",
    /// "gap" (m), "size" of its group (m), "moved" (the joint that moved most to close it, and by how much, rad or m; or None),
    /// "is_wide": more than a hundredth of the size, which is no rounding.
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

    /// The pose at a configuration of this assembly; as System.pose.
    #[pyo3(signature = (q=None, *, guess=None, base_pose=None, other_assembly=false))]
    fn pose(
        &self,
        py: Python<'_>,
        q: Option<&Bound<'_, PyAny>>,
        guess: Option<&Bound<'_, PyDict>>,
        base_pose: Option<&Bound<'_, PyAny>>,
        other_assembly: bool,
    ) -> PyResult<Pose> {
        let mut given = configuration(&self.model.read.mechanism, q, guess)?;
        if let Some(frame) = base_pose {
            given.set_base(root_frame(frame)?);
        }
        if other_assembly {
            given.allow_other_assembly();
        }
        let pose = py.detach(|| self.assembly.pose(&given)).map_err(errors::assembly)?;
        Ok(Pose { model: self.model.clone(), system: self.system.clone(), pose })
    }

    /// A contact, ready for one configuration after another. base_pose: pose of the root link in the world, for normals in the
    /// world; as for pose.
    #[pyo3(signature = (contact, *, base_pose=None))]
    fn workspace(&self, contact: &Contact, base_pose: Option<&Bound<'_, PyAny>>) -> PyResult<Workspace> {
        let base = base_pose.map(root_frame).transpose()?;
        let contact = contact.on(&self.model.read.mechanism)?;
        let batch = self.assembly.batch(&in_root_axes(contact, base.as_ref())).map_err(errors::response)?;
        Ok(Workspace { of: self.clone(), contact, base, batch, last: None, positions: Vec::new() })
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

/// The contact with a normal in the world turned into the root link's axes: batches take the root link at the world's origin.
pub fn in_root_axes(contact: Resolved, base: Option<&Transform<f64>>) -> Resolved {
    let normal = match (contact.normal, base, contact.against) {
        (Direction::Along(normal, Frame::World), Some(base), _)
        | (Direction::Along(normal, Frame::Against), Some(base), None) => {
            Direction::Along(base.inverse_vector(&normal), Frame::World)
        }
        (normal, ..) => normal,
    };
    Resolved { normal, ..contact }
}

/// A contact, ready for one configuration after another. Two threads that use one at once get an error.
#[pyclass(module = "percuss")]
#[derive(Debug)]
pub struct Workspace {
    of: Assembly,
    contact: Resolved,
    base: Option<Transform<f64>>,
    batch: Batch,
    last: Option<EffectiveMass>,
    /// Of the last configuration.
    positions: Vec<f64>,
}

#[pymethods]
impl Workspace {
    /// m̄ in kg at the positions of all joints, (p,), loops closed; None unless finite: then status has the outcome. A pandas
    /// Series is matched by name. findings has what is to be known about the last answer; Pose.respond gives more.
    fn effective_mass(&mut self, q: &Bound<'_, PyAny>) -> PyResult<Option<f64>> {
        let mut q = Numbers::of(q, "q", &[1], "one dimension: the positions of all joints")?;
        if q.labels != Labels::default() {
            let names = position_names(&self.of.model.read.mechanism);
            q = q.in_order("q", &names, ": the positions of all joints")?;
        }
        self.last = None;
        let answer = match q.array.as_slice() {
            Ok(positions) => self.at(positions),
            Err(_) => self.at(&q.array.as_array().iter().copied().collect::<Vec<f64>>()),
        }?;
        self.last = Some(answer);
        Ok(if let EffectiveMass::Finite(m) = answer { Some(m) } else { None })
    }

    /// Outcome of the last configuration: "finite", "immovable" or "massless"; None before the first, and after an error.
    #[getter]
    fn status(&self) -> Option<&'static str> {
        self.last.map(status)
    }

    /// Findings about the last configuration and its answer, as the command line reports them. They are found when they are read, by
    /// Pose.respond at that configuration. None before the first, and after an error.
    #[getter]
    fn findings(&self, py: Python<'_>) -> PyResult<Option<Vec<Diagnostic>>> {
        if self.last.is_none() {
            return Ok(None);
        }
        let Assembly { model, system, assembly } = &self.of;
        let mut there =
            Configuration::from_positions(&model.read.mechanism, &self.positions).map_err(input)?;
        if let Some(base) = self.base {
            there.set_base(base);
        }
        py.detach(|| {
            let pose = assembly.pose(&there).map_err(errors::assembly)?;
            let response = pose.respond(&self.contact, RouteChoice::Auto).map_err(errors::response)?;
            let found = response_findings(system, &pose, &self.contact, &response);
            Ok(Some(found.into_iter().map(Diagnostic).collect()))
        })
    }

    fn __repr__(&self) -> &'static str {
        "<Workspace>"
    }
}

impl Workspace {
    fn at(&mut self, positions: &[f64]) -> PyResult<EffectiveMass> {
        if let Some(at) = positions.iter().position(|x| !x.is_finite()) {
            return Err(input(format_args!("q[{at}] is {}; expected finite numbers", positions[at])));
        }
        let answer = self.batch.effective_mass(positions).map_err(input)?;
        self.positions.clear();
        self.positions.extend_from_slice(positions);
        answer
            .mass
            .ok_or_else(|| errors::no_answer("there is no answer at these positions; Pose.respond says why"))
    }
}
