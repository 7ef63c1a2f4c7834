//! Models: mechanisms from URDF, and their loading functions.

use crate::conversion::errors;
use crate::conversion::threads::abandonable;
use percuss::study::Model as Read;
use percuss::{Accept, DEFAULT_MAX_SIZE, JointKind, LoadOptions, Source};
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;

/// Name, parent and child; kind; limits; followed joint, multiplier and offset; range of positions.
type JointParts =
    ((String, String, String), String, Option<(f64, f64)>, Option<(String, f64, f64)>, (usize, usize));

/// Rebuilds a pickled joint.
#[pyfunction]
pub fn joint_of_parts(
    names: (String, String, String),
    kind: &str,
    limits: Option<(f64, f64)>,
    mimic: Option<(String, f64, f64)>,
    positions: (usize, usize),
) -> PyResult<Joint> {
    let kind = JointKind::ALL.into_iter().map(JointKind::name).find(|name| *name == kind);
    let kind = kind.ok_or_else(|| errors::input("an unknown kind of joint"))?;
    let (name, parent, child) = names;
    let (multiplier, offset) = mimic.as_ref().map(|mimic| (mimic.1, mimic.2)).unzip();
    let mimics = mimic.map(|mimic| mimic.0);
    Ok(Joint { name, kind, parent, child, limits, mimics, multiplier, offset, positions })
}

/// A joint of a model.
///
///     >>> [joint.limits for joint in arm.joints]
#[pyclass(frozen, get_all, module = "percuss.results")]
#[derive(Clone, Debug)]
pub struct Joint {
    /// Name of the joint.
    pub name: String,
    /// "fixed", "revolute", "continuous", "prismatic", "planar", "spherical" or "floating".
    pub kind: &'static str,
    /// Parent link.
    pub parent: String,
    /// Child link.
    pub child: String,
    /// Least and greatest position, rad or m; None without limits.
    pub limits: Option<(f64, f64)>,
    /// Name of the joint that a mimic joint follows; None for other joints.
    pub mimics: Option<String>,
    /// Multiplier of the position of the followed joint; None for other joints.
    pub multiplier: Option<f64>,
    /// Offset of a mimic joint, rad or m; None for other joints.
    pub offset: Option<f64>,
    /// Range of the joint's entries in the position vector: first index, and last index plus one.
    pub positions: (usize, usize),
}

#[pymethods]
impl Joint {
    /// Pickles a joint as its parts.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, JointParts)> {
        let ends = (self.name.clone(), self.parent.clone(), self.child.clone());
        let mimic = self.mimics.clone().zip(self.multiplier).zip(self.offset);
        let mimic = mimic.map(|((master, multiplier), offset)| (master, multiplier, offset));
        let parts = (ends, self.kind.to_owned(), self.limits, mimic, self.positions);
        Ok((py.import("percuss")?.getattr("_joint")?, parts))
    }

    fn __repr__(&self) -> String {
        format!("<Joint \"{}\": {}, \"{}\" to \"{}\">", self.name, self.kind, self.parent, self.child)
    }
}

/// Mechanism read from a file. Immutable, so that threads can share it.
///
///     >>> percuss.load("models/four_bar.urdf").position_names
#[pyclass(frozen, module = "percuss")]
#[derive(Clone, Debug)]
pub struct Model {
    pub read: Arc<Read>,
    /// Source text and accepted findings; `None` if the model does not come from URDF.
    pub source: Option<Arc<(Source, Vec<String>)>>,
}

impl Model {
    /// Wraps a model and issues its warnings.
    pub fn new(py: Python<'_>, read: Read) -> PyResult<Self> {
        errors::warn(py, &read.diagnostics)?;
        Ok(Self { read: Arc::new(read), source: None })
    }

    /// Loads a model from a source and issues its warnings.
    fn of(py: Python<'_>, source: Source, accept: Vec<String>) -> PyResult<Self> {
        let options = options(&accept)?;
        let source = Arc::new((source, accept));
        let given = Arc::clone(&source);
        let read = abandonable(py, source.0.bytes.len() >= LONG_SOURCE, move || {
            Read::from_source(&given.0, &options)
        })?;
        Ok(Self { source: Some(source), ..Self::new(py, read.map_err(errors::load)?)? })
    }
}

/// Size of a file, bytes, that takes some milliseconds to read.
const LONG_SOURCE: usize = 1 << 18;

/// Load options for the names of accepted findings.
fn options(accept: &[String]) -> PyResult<LoadOptions> {
    let mut accepted = Accept::default();
    for word in accept {
        match word.as_str() {
            "indefinite-inertia" => accepted.indefinite_inertia = true,
            "implausible-inertia" => accepted.implausible_inertia = true,
            "second-inertial" => accepted.second_inertial = true,
            _ => {
                return Err(errors::input(format_args!(
                    "accept: \"{word}\"; known are \"indefinite-inertia\", \"implausible-inertia\" and \"second-inertial\""
                )));
            }
        }
    }
    Ok(LoadOptions { accept: accepted, ..LoadOptions::default() })
}

/// Reads a URDF file, closed loops and couplings included.
///
/// accept: findings that are accepted: "indefinite-inertia", "implausible-inertia", "second-inertial". max_size: size limit in bytes;
/// larger files are refused. Warnings go through `warnings` (ModelWarning); the model's diagnostics hold warnings and
/// notes. Raises LoadError, with every error of the file.
///
///     >>> model = percuss.load("models/four_bar.urdf")
#[pyfunction]
#[pyo3(signature = (path, *, accept=Vec::new(), max_size=DEFAULT_MAX_SIZE))]
pub fn load(py: Python<'_>, path: PathBuf, accept: Vec<String>, max_size: u64) -> PyResult<Model> {
    let path = path.to_string_lossy();
    if path.trim_start().starts_with('<') {
        return Err(errors::input("path is URDF text; percuss.loads reads text"));
    }
    Model::of(py, Source::read(&path, max_size).map_err(errors::load)?, accept)
}

/// Reads URDF from text. name replaces the file name in messages. Other parameters as for load.
///
///     >>> percuss.loads('<robot name="r"><link name="a"/></robot>').links
#[pyfunction]
#[pyo3(signature = (text, *, name="<text>", accept=Vec::new()))]
pub fn loads(py: Python<'_>, text: &str, name: &str, accept: Vec<String>) -> PyResult<Model> {
    if !text.contains('<') && !text.trim().is_empty() {
        return Err(errors::input(format_args!(
            "text is {text:?}, without an element; expected URDF text: percuss.load reads files"
        )));
    }
    Model::of(py, Source::from_text(name, text), accept)
}

/// Rebuilds a pickled model in another process.
#[pyfunction]
pub fn model_of_bytes(py: Python<'_>, bytes: Vec<u8>, name: String, accept: Vec<String>) -> PyResult<Model> {
    Model::of(py, Source::new(name, bytes), accept)
}
