//! Motions of a mechanism at a pose: the travel of a point, accelerations under forces, the rate of m̄.

use crate::analysis::contact::GivenContact;
use crate::analysis::model::Model;
use crate::analysis::pose::Pose;
use crate::analysis::state::{attribute, is_state};
use crate::analysis::system::{configuration, numbers, velocity_names};
use crate::conversion::arrays::{list, triple};
use crate::conversion::errors::{self, input, of_argument};
use crate::conversion::threads::interruptible_if_large;
use numpy::PyArray1;
use percuss::nalgebra::{Matrix3, Vector3};
use percuss::spatial::Twist;
use percuss::{
    Accelerations as Found, Joint, JointId, MassGradient, Mechanism, PointForce, Pose as Posed,
    System as Compiled, Travel as Moved,
};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};
use std::sync::Arc;

/// Largest relative residual of A v for admissible velocities, as a fraction of the sum of the terms' sizes: the
/// rounding of single precision, in which users may have stored the velocities.
const RESIDUAL_TOLERANCE: f64 = 1e-6;

/// Travel of a point along a direction, measured from the point's position at a pose. Immutable, so that threads can
/// share it.
///
///     >>> height = percuss.suspension.Travel(model.pose(), "coupler", [0.35, 0.1, 0.0], [0.0, 1.0, 0.0])
///     >>> height.pose(model.pose(), 0.01).joints["crank_hinge"]
#[pyclass(frozen, module = "percuss.suspension")]
#[derive(Clone, Debug)]
pub struct Travel {
    model: Model,
    /// Pose from which the travel is measured.
    start: Pose,
    travel: Moved,
}

/// Pose, link, point (m) and direction of a travel.
type TravelArguments = (Pose, String, [f64; 3], [f64; 3]);

impl Travel {
    /// Refuses a pose of another model than that of the travel.
    fn check_model(&self, pose: &Pose) -> PyResult<()> {
        match Arc::ptr_eq(&pose.model.read.mechanism, &self.model.read.mechanism) {
            true => Ok(()),
            false => Err(input(format_args!(
                "the pose is of another model (\"{}\"); expected one of the model of the pose that the travel begins at (\"{}\")",
                pose.model.read.mechanism.name(),
                self.model.read.mechanism.name()
            ))),
        }
    }
}

#[pymethods]
impl Travel {
    /// pose: the starting pose. link, point: (3,) m, link's frame. direction: (3,), world axes; its length does not
    /// matter.
    #[new]
    fn new(
        pose: &Bound<'_, PyAny>,
        link: &Bound<'_, PyAny>,
        point: &Bound<'_, PyAny>,
        direction: &Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let pose: PyRef<'_, Pose> = errors::extract(pose, "pose")?;
        let link: String = errors::extract(link, "link")?;
        let on = pose.model.read.mechanism.find_link(&link).map_err(input)?;
        let (point, direction) = (triple(point, "point")?, triple(direction, "direction")?);
        let travel = Moved::new(&pose.pose, on, point.into(), direction.into()).map_err(errors::travel)?;
        Ok(Self { model: pose.model.clone(), start: pose.clone(), travel })
    }

    /// The link of the point.
    #[getter]
    fn link(&self) -> &str {
        self.model.read.mechanism.link(self.travel.link()).name()
    }

    /// The point, m, link's frame; (3,).
    #[getter]
    fn point<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.travel.point().as_slice())
    }

    /// Unit vector, world axes; (3,).
    #[getter]
    fn direction<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.travel.direction().copied().unwrap_or_default().as_slice())
    }

    /// Pickles a travel as the arguments of its constructor.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, TravelArguments)> {
        let direction = self.travel.direction().copied().unwrap_or_default();
        let (point, direction) = ((*self.travel.point()).into(), direction.into());
        let class = py.get_type::<Self>().into_any();
        Ok((class, (self.start.clone(), self.link().to_owned(), point, direction)))
    }

    /// Displacement of the point at a pose of the same model, m.
    fn displacement(&self, pose: &Pose) -> PyResult<f64> {
        self.check_model(pose)?;
        Ok(self.travel.displacement(&pose.pose))
    }

    /// ds/dq at a pose: displacement per motion of a driving joint, m/rad or m/m. The loops stay closed and other
    /// drivers are at rest. None at a change point, at a dead centre of the joint, and for a joint that cannot drive.
    fn rate(&self, pose: &Pose, joint: &str) -> PyResult<Option<f64>> {
        self.check_model(pose)?;
        let joint = self.model.read.mechanism.find_joint(joint).map_err(input)?;
        Ok(self.travel.rate(&pose.pose, joint))
    }

    /// The joint that turns furthest with the point at a pose, among the joints that can drive the point. Joints in set
    /// are excluded. Raises NoAnswerError if no joint moves the point.
    #[pyo3(signature = (pose, *, set=Vec::new()))]
    fn driver(&self, pose: &Pose, set: Vec<String>) -> PyResult<String> {
        self.check_model(pose)?;
        let mechanism = &self.model.read.mechanism;
        let taken = set.iter().map(|joint| mechanism.find_joint(joint)).collect::<Result<Vec<_>, _>>();
        let taken = taken.map_err(|error| of_argument("set")(input(error)))?;
        let driver =
            self.travel.driver(&pose.pose, &|joint| taken.contains(&joint)).map_err(errors::travel)?;
        Ok(mechanism.joint(driver).name().to_owned())
    }

    /// The pose with a given displacement of the point (m), followed from the pose start along its branch. driver: the
    /// joint that moves; None: the result of `driver`. q: positions of other driving joints, as for Model.pose; None:
    /// all at zero. Raises NoAnswerError beyond the range in which the displacement is monotonic; the message gives the
    /// nearest reachable value.
    #[pyo3(signature = (start, displacement, *, driver=None, q=None))]
    fn pose(
        &self,
        py: Python<'_>,
        start: &Pose,
        displacement: f64,
        driver: Option<&str>,
        q: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Pose> {
        self.check_model(start)?;
        let mechanism = &self.model.read.mechanism;
        let others = configuration(mechanism, q.map(|q| q.as_any()), None)?;
        let driver = match driver {
            Some(name) => name.to_owned(),
            None => {
                let set = q.map_or(Ok(Vec::new()), |q| q.keys().extract());
                self.driver(start, set.map_err(of_argument("q"))?)?
            }
        };
        let driver = mechanism.find_joint(&driver).map_err(|error| of_argument("driver")(input(error)))?;
        if !displacement.is_finite() {
            return Err(input(format_args!("displacement is {displacement}; expected a finite number, m")));
        }
        let coordinates = start.pose.positions().len();
        let pose = interruptible_if_large(py, coordinates, || {
            self.travel.pose(&start.pose, &others, driver, displacement)
        })?;
        Ok(Pose { pose: pose.map_err(errors::travel)?, ..start.clone() })
    }

    fn __repr__(&self) -> String {
        let (point, along) = (self.travel.point(), self.travel.direction().copied().unwrap_or_default());
        format!(
            "<Travel of [{}, {}, {}] of \"{}\" along [{}, {}, {}]>",
            point.x,
            point.y,
            point.z,
            self.link(),
            along.x,
            along.y,
            along.z
        )
    }
}

/// Largest relative difference between the given velocity of a mimic joint and that of its master: rounding of sums.
const MIMIC_SLACK: f64 = 1e-9;

/// Velocities of all joints, joint by joint, from a dict of some joints. Mimic joints follow; other joints are at rest.
fn velocities(mechanism: &Mechanism, given: Option<&Bound<'_, PyDict>>) -> PyResult<Vec<Vec<f64>>> {
    let mut all: Vec<Vec<f64>> =
        mechanism.joints().iter().map(|joint| vec![0.0; joint.kind().dofs()]).collect();
    let mut is_given = vec![false; all.len()];
    for (name, values) in numbers(given, "velocity")? {
        let id = mechanism.find_joint(&name).map_err(input)?;
        if values.len() != all[id.index()].len() {
            let expected = all[id.index()].len();
            return Err(input(format_args!(
                "velocity of \"{name}\" has {} numbers; expected {expected}",
                values.len()
            )));
        }
        all[id.index()] = values;
        is_given[id.index()] = true;
    }
    checked_velocities(mechanism, all, |number| is_given[number])
}

/// Velocities with mimics that follow their masters. Refuses given velocities of mimics that do not follow, and numbers that are not finite.
fn checked_velocities(
    mechanism: &Mechanism,
    mut all: Vec<Vec<f64>>,
    is_given: impl Fn(usize) -> bool,
) -> PyResult<Vec<Vec<f64>>> {
    for (number, joint) in mechanism.joints().iter().enumerate() {
        if let Some(bad) = all[number].iter().find(|x| !x.is_finite()) {
            let name = joint.name();
            return Err(input(format_args!("velocity of \"{name}\" has {bad}; expected finite numbers")));
        }
        let Some(mimic) = joint.mimic() else { continue };
        let followed: Vec<f64> =
            all[mimic.master.index()].iter().map(|rate| mimic.multiplier * rate).collect();
        let (name, master) = (joint.name(), mechanism.joint(mimic.master).name());
        let differs = |(given, follows): (&f64, &f64)| (given - follows).abs() > MIMIC_SLACK * follows.abs();
        if is_given(number) && all[number].iter().zip(&followed).any(differs) {
            return Err(input(format_args!(
                "velocity of \"{name}\" is {}: it follows \"{master}\", so that it is {}; give the velocity of \"{master}\" alone",
                all[number][0], followed[0]
            )));
        }
        all[number] = followed;
    }
    Ok(all)
}

/// Twist from six numbers: angular, then linear.
fn twist(given: Option<&Bound<'_, PyAny>>, what: &str) -> PyResult<Twist<f64>> {
    let Some(given) = given else { return Ok(Twist::zero()) };
    let values = list(given, what)?;
    let [a, b, c, x, y, z] = values[..] else {
        return Err(input(format_args!("{what} has {} numbers; expected 6", values.len())));
    };
    if let Some(bad) = values.iter().find(|x| !x.is_finite()) {
        return Err(input(format_args!("{what} has {bad}; expected finite numbers")));
    }
    Ok(Twist::new(Vector3::new(a, b, c), Vector3::new(x, y, z)))
}

/// Velocities of all joints, joint by joint: from a dict of some joints, the velocities of all, or a State.
fn given_velocities(mechanism: &Arc<Mechanism>, given: &Bound<'_, PyAny>) -> PyResult<Vec<Vec<f64>>> {
    if let Ok(by_name) = given.cast::<PyDict>() {
        return velocities(mechanism, Some(by_name));
    }
    let given = match is_state(given, mechanism)? {
        true => attribute(given, "velocities")?.ok_or_else(|| input("the State has no velocities"))?,
        false => given.clone(),
    };
    let values = list(&given, "velocities")?;
    let names = velocity_names(mechanism);
    if values.len() != names.len() {
        return Err(input(format_args!(
            "it has {} numbers; expected a dict of joints, or {} numbers in the order of Model.velocity_names",
            values.len(),
            names.len()
        )));
    }
    let mut rest = values.into_iter();
    let of_joint = |joint: &Joint| rest.by_ref().take(joint.kind().dofs()).collect();
    let all: Vec<Vec<f64>> = mechanism.joints().iter().map(of_joint).collect();
    checked_velocities(mechanism, all, |_| true)
}

/// dm̄/dt, kg/s, at joint velocities and the twist of the root link; `None` unless finite.
pub fn effective_mass_rate(
    py: Python<'_>,
    pose: &Pose,
    contact: &GivenContact<'_>,
    given: &Bound<'_, PyAny>,
    base_twist: Option<&Bound<'_, PyAny>>,
    frame: Option<&str>,
) -> PyResult<Option<f64>> {
    let mechanism = &pose.model.read.mechanism;
    let velocities = given_velocities(mechanism, given).map_err(of_argument("velocities"))?;
    let own = if is_state(given, mechanism)? { attribute(given, "base_twist")? } else { None };
    let base = match (own, base_twist) {
        (Some(_), Some(_)) => return Err(input("base_twist: the State has its own")),
        (Some(own), None) => twist(Some(&own), "base_twist")?,
        (None, given) => {
            let axes = if given.is_some() { pose.axes(frame)? } else { Matrix3::identity() };
            let found = twist(given, "base_twist")?;
            Twist::new(axes.tr_mul(&found.angular), axes.tr_mul(&found.linear))
        }
    };
    let gradient = effective_mass_gradient(py, pose, contact)?;
    if let Some(reason) = opening(&pose.system.system, &pose.pose, &velocities) {
        return Err(input(reason));
    }
    let of_base = |base_gradient: [f64; 6]| -> f64 {
        base_gradient.iter().zip(base.angular.iter().chain(base.linear.iter())).map(|(g, w)| g * w).sum()
    };
    Ok(gradient.map(|gradient| gradient.rate(&velocities) + of_base(gradient.base)))
}

/// Gradient of m̄; `None` unless m̄ is finite with an error of at most 1e-6 m̄.
pub fn effective_mass_gradient(
    py: Python<'_>,
    pose: &Pose,
    contact: &GivenContact<'_>,
) -> PyResult<Option<MassGradient>> {
    let contact = contact.resolve(&pose.model.read.mechanism)?;
    let coordinates = pose.pose.positions().len();
    interruptible_if_large(py, coordinates, || pose.pose.effective_mass_gradient(&contact))?
        .map_err(errors::response)
}

/// Reason why velocities are not admissible: a locked joint moves, or the loops open, A v ≠ 0. Held points of a floating base are not tested.
pub fn opening(system: &Compiled, pose: &Posed, velocities: &[Vec<f64>]) -> Option<String> {
    let mechanism = pose.mechanism();
    let moves = |joint: &JointId| velocities[joint.index()].iter().any(|rate| *rate != 0.0);
    if let Some(joint) = mechanism.joint_ids().find(|joint| moves(joint) && system.is_locked(*joint)) {
        return Some(format!("velocity of \"{}\": it is locked; expected 0", mechanism.joint(joint).name()));
    }
    let rows = pose.constraint_matrix();
    let order = system.coordinate_joints();
    let rate = |column: usize| match order[column] {
        (Some(joint), number) => velocities[joint.index()][number],
        (None, _) => 0.0,
    };
    for row in rows.row_iter() {
        let terms = || row.iter().enumerate().map(|(column, x)| x * rate(column));
        let (sum, size) = (terms().sum::<f64>(), terms().map(f64::abs).sum::<f64>());
        if sum.abs() > RESIDUAL_TOLERANCE * size {
            let reason = "velocities: with these the loops open (A v is not 0); give the rates of all joints of the loops, such as \
                          Response.joint_velocities";
            return Some(reason.to_owned());
        }
    }
    None
}

/// Dict from the names of movable joints to their values, one per velocity.
pub fn by_joint<'py>(
    py: Python<'py>,
    mechanism: &Mechanism,
    values: &[Vec<f64>],
) -> PyResult<Bound<'py, PyDict>> {
    let by_name = PyDict::new(py);
    for (joint, own) in mechanism.joints().iter().zip(values) {
        if !own.is_empty() {
            by_name.set_item(joint.name(), PyArray1::from_slice(py, own))?;
        }
    }
    Ok(by_name)
}

/// Accelerations of a moving mechanism.
///
///     >>> arm.pose().accelerations(gravity=[0, 0, -9.81]).joints["elbow"]
#[pyclass(frozen, module = "percuss.results")]
#[derive(Clone, Debug)]
pub struct Accelerations {
    pose: Pose,
    found: Found,
}

#[pymethods]
impl Accelerations {
    /// Rates of the velocities of each movable joint, by joint name: rad/s², m/s²; (1,), or one entry per velocity of
    /// the joint.
    #[getter]
    fn joints<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        by_joint(py, &self.pose.model.read.mechanism, &self.found.joints)
    }

    /// Acceleration of a point (m, link's frame) of a link, m/s²; (3,). Axes of the root link or of the world, as for
    /// Pose.link_frame.
    #[pyo3(signature = (link, point, *, frame=None))]
    fn point<'py>(
        &self,
        py: Python<'py>,
        link: &str,
        point: &Bound<'py, PyAny>,
        frame: Option<&str>,
    ) -> PyResult<Bound<'py, PyArray1<f64>>> {
        let link = self.pose.model.read.mechanism.find_link(link).map_err(input)?;
        let point = Vector3::from(triple(point, "point")?);
        let found = self.pose.pose.point_acceleration(&self.found, link, &point).map_err(errors::route)?;
        Ok(PyArray1::from_slice(py, (self.pose.axes(frame)? * found).as_slice()))
    }

    fn __repr__(&self) -> String {
        format!("<Accelerations of \"{}\">", self.pose.model.read.mechanism.name())
    }
}

/// Accelerations at a pose. given: joint velocities, by joint name; base: twist of the root link; gravity, m/s²; forces: (link, point,
/// force in N). axes: rotation from the root link's axes to the axes of these vectors; points are in the frames of their links.
pub fn accelerations(
    py: Python<'_>,
    pose: &Pose,
    given: Option<&Bound<'_, PyDict>>,
    base: Option<&Bound<'_, PyAny>>,
    gravity: Option<&Bound<'_, PyAny>>,
    forces: &[Bound<'_, PyAny>],
    axes: &Matrix3<f64>,
) -> PyResult<Accelerations> {
    let mechanism = &pose.model.read.mechanism;
    let velocities = velocities(mechanism, given).map_err(of_argument("velocities"))?;
    let in_root = |vector: Vector3<f64>| axes.tr_mul(&vector);
    let base = twist(base, "base")?;
    let base = Twist::new(in_root(base.angular), in_root(base.linear));
    let gravity = gravity.map(|gravity| triple(gravity, "gravity")).transpose()?.unwrap_or_default();
    let gravity = in_root(gravity.into());
    let force = |given: &Bound<'_, PyAny>| {
        let (link, point, force): (String, Bound<'_, PyAny>, Bound<'_, PyAny>) =
            given.extract().map_err(|_| input("forces: expected (link, point, force) of each"))?;
        PyResult::Ok(PointForce {
            link: mechanism.find_link(&link).map_err(input)?,
            point: triple(&point, "point of forces")?.into(),
            force: in_root(triple(&force, "force")?.into()),
        })
    };
    let forces: Vec<PointForce> = forces.iter().map(force).collect::<PyResult<_>>()?;
    let coordinates = pose.pose.positions().len();
    let found = interruptible_if_large(py, coordinates, || {
        pose.pose.accelerations(&velocities, &base, &gravity, &forces)
    })?;
    Ok(Accelerations { pose: pose.clone(), found: found.map_err(errors::route)? })
}
