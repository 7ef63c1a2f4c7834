//! Systems (a mechanism under conditions) and assemblies (systems with closed loops), and what a caller gives for them. Their
//! Python methods are in `system_methods.rs`.

use crate::analysis::model::Model;
use crate::analysis::state::positions_and_base;
use crate::conversion::arrays::{Numbers, list, triple};
use crate::conversion::errors::{self, input, of_argument};
use crate::conversion::threads::interruptible_if_large;
use percuss::nalgebra::{Rotation3, UnitQuaternion, Vector3};
use percuss::spatial::{Transform, rotation_from_quaternion};
use percuss::{Assembly as Assembled, Base, Conditions, Configuration, Mechanism, System as Compiled};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};
use std::sync::Arc;

/// Mechanism under conditions. Immutable, so that threads can share it.
///
///     >>> arm.system(base="floating", lock=["elbow"]).coordinates
#[pyclass(frozen, module = "percuss")]
#[derive(Clone, Debug)]
pub struct System {
    pub model: Model,
    pub system: Compiled,
    pub conditions: Arc<GivenConditions>,
}

/// Conditions as given, for pickle.
#[derive(Debug)]
pub struct GivenConditions {
    pub base: Base,
    pub lock: Vec<String>,
    pub armature: Vec<(String, Vec<f64>)>,
    pub hold: Vec<LinkPointVector>,
}

/// System with assembled loops. Immutable, so that threads can share it.
///
///     >>> model.assemble().drivers
#[pyclass(frozen, module = "percuss")]
#[derive(Clone, Debug)]
pub struct Assembly {
    pub model: Model,
    pub system: System,
    pub assembly: Arc<Assembled>,
    /// Positions from which the loops were assembled.
    pub guess: Arc<Vec<(String, Vec<f64>)>>,
}

/// Base from its name, "fixed" or "floating".
pub fn base(name: &str) -> PyResult<Base> {
    match name {
        "fixed" => Ok(Base::Fixed),
        "floating" => Ok(Base::Floating),
        _ => Err(input(format_args!("base is \"{name}\"; expected \"fixed\" or \"floating\""))),
    }
}

/// Name of a base.
pub fn base_name(base: Base) -> &'static str {
    match base {
        Base::Fixed => "fixed",
        Base::Floating => "floating",
    }
}

/// Dict of numbers by name.
pub fn by_name<'py>(py: Python<'py>, given: &[(String, Vec<f64>)]) -> PyResult<Bound<'py, PyDict>> {
    let found = PyDict::new(py);
    given.iter().try_for_each(|(name, values)| found.set_item(name, values))?;
    Ok(found)
}

/// Link, point and vector, if given.
pub type LinkPointVector = (String, [f64; 3], Option<[f64; 3]>);

/// Reads (link, point) or (link, point, vector). `what` and `vector` name the tuple and its last part in messages.
pub fn link_point_vector(given: &Bound<'_, PyAny>, what: &str, vector: &str) -> PyResult<LinkPointVector> {
    let parts: Vec<Bound<'_, PyAny>> = given.extract()?;
    let (link, point, last) = match &parts[..] {
        [link, point] => (link, point, None),
        [link, point, last] => (link, point, Some(last)),
        _ => {
            return Err(input(format_args!("{what}: expected (link, point) or (link, point, {vector})")));
        }
    };
    let last =
        last.filter(|l| !l.is_none()).map(|l| triple(l, &format!("{vector} of {what}"))).transpose()?;
    Ok((link.extract()?, triple(point, &format!("point of {what}"))?, last))
}

/// Numbers by name, from a dict.
pub fn numbers(given: Option<&Bound<'_, PyDict>>, what: &str) -> PyResult<Vec<(String, Vec<f64>)>> {
    let Some(given) = given else { return Ok(Vec::new()) };
    let one = |(name, values): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let name: String = name.extract()?;
        let values = list(&values, &format!("{what} of \"{name}\""))?;
        Ok((name, values))
    };
    given.iter().map(one).collect()
}

/// Names of all positions, in order: the joint's name, or JOINT[0], JOINT[1], … for a joint with several positions.
pub fn position_names(mechanism: &Mechanism) -> Vec<String> {
    let of = |joint: &percuss::Joint| -> Vec<String> {
        match joint.kind().positions() {
            1 => vec![joint.name().to_owned()],
            count => (0..count).map(|i| format!("{}[{i}]", joint.name())).collect(),
        }
    };
    mechanism.joints().iter().flat_map(of).collect()
}

/// Name of every velocity; a joint with several has its name with indices. The layout of the gradient of a sweep.
pub fn velocity_names(mechanism: &Mechanism) -> Vec<String> {
    let of = |joint: &percuss::Joint| -> Vec<String> {
        match joint.kind().dofs() {
            1 => vec![joint.name().to_owned()],
            count => (0..count).map(|i| format!("{}[{i}]", joint.name())).collect(),
        }
    };
    mechanism.joints().iter().flat_map(of).collect()
}

/// Configuration from a dict of joints or from the vector of all positions.
pub fn configuration(
    mechanism: &Arc<Mechanism>,
    q: Option<&Bound<'_, PyAny>>,
    guess: Option<&Bound<'_, PyDict>>,
) -> PyResult<Configuration> {
    let mut found = match q {
        Some(q) if !q.is_instance_of::<PyDict>() => {
            let q = Numbers::of(q, "q", &[1], "one dimension, or a dict of joints")?;
            let q = q.in_order_of("q", &position_names(mechanism), ": the positions of all joints")?;
            let q: Vec<f64> = q.array.as_array().iter().copied().collect();
            Configuration::from_positions(mechanism, &q).map_err(|error| of_argument("q")(input(error)))?
        }
        _ => Configuration::zero(mechanism),
    };
    if let Some(by_name) = q.and_then(|q| q.cast::<PyDict>().ok()) {
        for (joint, values) in numbers(Some(by_name), "position").map_err(of_argument("q"))? {
            found.set(&joint, &values).map_err(|error| of_argument("q")(input(error)))?;
        }
    }
    for (joint, values) in numbers(guess, "guess").map_err(of_argument("guess"))? {
        found.guess(&joint, &values).map_err(|error| of_argument("guess")(input(error)))?;
    }
    Ok(found)
}

/// Configuration of a pose, with its base pose and the permission of another assembly mode.
pub fn pose_configuration(
    mechanism: &Arc<Mechanism>,
    q: Option<&Bound<'_, PyAny>>,
    guess: Option<&Bound<'_, PyDict>>,
    base_pose: Option<&Bound<'_, PyAny>>,
    other_assembly: bool,
) -> PyResult<Configuration> {
    let (q, base_pose) = match q {
        Some(q) => positions_and_base(q, base_pose, mechanism).map(|(q, base)| (Some(q), base))?,
        None => (None, base_pose.cloned()),
    };
    let mut given = configuration(mechanism, q.as_ref(), guess)?;
    if let Some(frame) = base_pose {
        given.set_base(root_frame(&frame)?);
    }
    if other_assembly {
        given.allow_other_assembly();
    }
    Ok(given)
}

/// Pose of the root link in the world: 7 numbers, x, y, z (m), w, x, y, z (a unit quaternion).
pub fn root_frame(given: &Bound<'_, PyAny>) -> PyResult<Transform<f64>> {
    let values = list(given, "base_pose")?;
    if let Ok(axes) = given.getattr("shape").and_then(|shape| shape.extract::<Vec<usize>>())
        && axes != [7]
    {
        return Err(input(format_args!(
            "base_pose has shape {}; expected (7,): x, y, z (m), w, x, y, z (unit quaternion)",
            crate::conversion::arrays::shape(&axes)
        )));
    }
    root_frame_of(&values)
}

/// Pose of the root link in the world from x, y, z (m) and a unit quaternion w, x, y, z.
pub fn root_frame_of(values: &[f64]) -> PyResult<Transform<f64>> {
    let [x, y, z, quaternion @ ..] = values else {
        return Err(input(format_args!("base_pose has {} numbers; expected 7", values.len())));
    };
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

/// Numbers of a base pose: x, y, z (m), w, x, y, z.
pub fn seven_numbers(base: &Transform<f64>) -> [f64; 7] {
    let turn = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(base.rotation));
    let [x, y, z] = base.translation.into();
    [x, y, z, turn.w, turn.i, turn.j, turn.k]
}

impl System {
    pub fn new(
        model: &Model,
        root: &str,
        lock: Vec<String>,
        armature: Option<&Bound<'_, PyDict>>,
        hold: Vec<Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let hold = hold.iter().map(|hold| link_point_vector(hold, "hold", "normal"));
        let hold = hold.collect::<PyResult<_>>().map_err(of_argument("hold"))?;
        let armature = numbers(armature, "armature").map_err(of_argument("armature"))?;
        let lock = match &lock[..] {
            // Every joint that moves on its own, unless a joint has this name.
            [all] if all == "all" && model.read.mechanism.find_joint(all).is_err() => {
                let joints = model.read.mechanism.joints().iter();
                let free = joints.filter(|joint| joint.kind().dofs() > 0 && joint.mimic().is_none());
                free.map(|joint| joint.name().to_owned()).collect()
            }
            _ => lock,
        };
        let find = |joint: &String| model.read.mechanism.find_joint(joint).map(drop).map_err(input);
        lock.iter().try_for_each(find).map_err(of_argument("lock"))?;
        armature.iter().try_for_each(|(joint, _)| find(joint)).map_err(of_argument("armature"))?;
        let given = GivenConditions { base: base(root)?, lock, armature, hold };
        let mut conditions = Conditions::new().base(given.base);
        for joint in &given.lock {
            conditions = conditions.lock(joint);
        }
        for (joint, values) in &given.armature {
            conditions = conditions.armature(joint, values.clone());
        }
        for (link, point, normal) in &given.hold {
            conditions = conditions.hold(link, *point, normal.map(Vector3::from));
        }
        let system = Compiled::new(Arc::clone(&model.read.mechanism), &conditions).map_err(input)?;
        Ok(Self { model: model.clone(), system, conditions: Arc::new(given) })
    }

    /// System with every joint free and a fixed base.
    pub fn unconstrained(model: &Model) -> PyResult<Self> {
        Self::new(model, "fixed", Vec::new(), None, Vec::new())
    }

    /// Assembly of the loops from all joints at 0.
    pub fn assemble_at_zero(&self, py: Python<'_>) -> PyResult<Arc<Assembled>> {
        interruptible_if_large(py, self.system.coordinates(), || self.system.reference().map(Arc::clone))?
            .map_err(errors::assembly)
    }
}
