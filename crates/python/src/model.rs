//! Models: mechanisms read from URDF, and what was noticed in the file.

use crate::errors;
use crate::pose::Pose;
use crate::system::{Assembly, System};
use percuss::study::{DiagnosticRecord, Model as Read};
use percuss::{Accept, DEFAULT_MAX_SIZE, JointKind, LoadOptions, Source, write_urdf};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};
use std::path::PathBuf;
use std::sync::Arc;

/// Something that was noticed in a file, or about an answer.
#[pyclass(frozen, module = "percuss")]
#[derive(Clone, Debug)]
pub struct Diagnostic(pub DiagnosticRecord);

#[pymethods]
impl Diagnostic {
    /// "error", "warning" or "note".
    #[getter]
    fn severity(&self) -> &'static str {
        self.0.severity
    }

    /// A short name that programs can rely on.
    #[getter]
    fn code(&self) -> &'static str {
        self.0.code
    }

    /// The file; None for a finding about an answer.
    #[getter]
    fn path(&self) -> Option<&str> {
        self.0.path.as_deref()
    }

    /// Line, from 1.
    #[getter]
    fn line(&self) -> Option<u32> {
        self.0.line
    }

    /// Column, from 1.
    #[getter]
    fn column(&self) -> Option<u32> {
        self.0.column
    }

    /// The element, as an XML path.
    #[getter]
    fn element(&self) -> Option<&str> {
        self.0.element.as_deref()
    }

    /// What is the matter.
    #[getter]
    fn message(&self) -> &str {
        &self.0.message
    }

    fn __str__(&self) -> String {
        self.0.line()
    }

    fn __repr__(&self) -> String {
        format!("<{}>", self.0.line())
    }
}

/// A joint of a model.
#[pyclass(frozen, get_all, module = "percuss")]
#[derive(Clone, Debug)]
pub struct Joint {
    /// Its name.
    name: String,
    /// "fixed", "revolute", "continuous", "prismatic", "planar", "spherical" or "floating".
    kind: &'static str,
    /// The link that carries it.
    parent: String,
    /// The link that it carries.
    child: String,
    /// Least and greatest position, rad or m; None without limits.
    limits: Option<(f64, f64)>,
    /// The joint that it follows; None unless it mimics one.
    mimics: Option<String>,
    /// Which of a configuration's positions are its own: the first, and one past the last.
    positions: (usize, usize),
}

#[pymethods]
impl Joint {
    fn __repr__(&self) -> String {
        format!("<Joint \"{}\": {}, \"{}\" to \"{}\">", self.name, self.kind, self.parent, self.child)
    }
}

/// A mechanism that was read from a file. Cannot be changed: threads may share it.
#[pyclass(frozen, module = "percuss")]
#[derive(Clone, Debug)]
pub struct Model {
    pub read: Arc<Read>,
    /// What it was read from and what was accepted; none where it was not read from URDF.
    source: Option<Arc<(Source, Vec<String>)>>,
}

impl Model {
    /// Warns of what was found.
    pub fn new(py: Python<'_>, read: Read) -> PyResult<Self> {
        errors::warn(py, &read.diagnostics)?;
        Ok(Self { read: Arc::new(read), source: None })
    }

    fn of(py: Python<'_>, source: Source, accept: Vec<String>) -> PyResult<Self> {
        let options = options(&accept)?;
        let read = py.detach(|| Read::of(&source, &options)).map_err(errors::load)?;
        Ok(Self { source: Some(Arc::new((source, accept))), ..Self::new(py, read)? })
    }
}

/// A function, and what it is called with.
type Rebuilt<'py> = (Bound<'py, PyAny>, (Vec<u8>, String, Vec<String>));

fn options(accept: &[String]) -> PyResult<LoadOptions> {
    let mut accepted = Accept::default();
    for word in accept {
        match word.as_str() {
            "indefinite-inertia" => accepted.indefinite_inertia = true,
            _ => {
                return Err(errors::input(format_args!(
                    "accept: \"{word}\"; known is \"indefinite-inertia\""
                )));
            }
        }
    }
    Ok(LoadOptions { accept: accepted })
}

/// Reads a URDF file, closed loops and couplings included.
///
/// accept: findings that are accepted: "indefinite-inertia". max_size: larger files are refused, bytes. Warnings go through
/// `warnings` (ModelWarning); warnings and notes are the model's diagnostics. Raises LoadError, with every error of the file.
#[pyfunction]
#[pyo3(signature = (path, *, accept=Vec::new(), max_size=DEFAULT_MAX_SIZE))]
pub fn load(py: Python<'_>, path: PathBuf, accept: Vec<String>, max_size: u64) -> PyResult<Model> {
    let path = path.to_string_lossy();
    Model::of(py, Source::read(&path, max_size).map_err(errors::load)?, accept)
}

/// Reads a URDF from text. name stands for the file in messages. As load otherwise.
#[pyfunction]
#[pyo3(signature = (text, *, name="<text>", accept=Vec::new()))]
pub fn loads(py: Python<'_>, text: &str, name: &str, accept: Vec<String>) -> PyResult<Model> {
    Model::of(py, Source::from_text(name, text), accept)
}

/// The model of another process.
#[pyfunction]
pub fn model_of_bytes(py: Python<'_>, bytes: Vec<u8>, name: String, accept: Vec<String>) -> PyResult<Model> {
    Model::of(py, Source { name, bytes }, accept)
}

#[pymethods]
impl Model {
    /// The mechanism's name.
    #[getter]
    fn name(&self) -> &str {
        self.read.mechanism.name()
    }

    /// Names of the links, in the order of the file.
    #[getter]
    fn links(&self) -> Vec<&str> {
        self.read.mechanism.links().iter().map(|link| link.name()).collect()
    }

    /// The joints, in the order of the file: that of their positions.
    #[getter]
    fn joints(&self) -> Vec<Joint> {
        let mechanism = &self.read.mechanism;
        let mut first = 0;
        let link = |id| mechanism.link(id).name().to_owned();
        let of = |joint: &percuss::Joint| {
            let positions = (first, first + joint.kind().positions());
            first = positions.1;
            Joint {
                name: joint.name().to_owned(),
                kind: joint.kind().name(),
                parent: link(joint.parent()),
                child: link(joint.child()),
                limits: joint.limits().map(|limits| (limits.lower, limits.upper)),
                mimics: joint.mimic().map(|mimic| mechanism.joint(mimic.master).name().to_owned()),
                positions,
            }
        };
        mechanism.joints().iter().map(of).collect()
    }

    /// Names of the closures of loops, and of couplings.
    #[getter]
    fn closures(&self) -> Vec<&str> {
        let mechanism = &self.read.mechanism;
        let couplings = mechanism.couplings().iter().map(|coupling| coupling.name());
        mechanism.closures().iter().map(|closure| closure.name()).chain(couplings).collect()
    }

    /// How many positions a configuration has: those of all joints one after another.
    #[getter]
    pub fn position_count(&self) -> usize {
        self.read.mechanism.joints().iter().map(|joint| joint.kind().positions()).sum()
    }

    /// Names of the positions, in order: the joint's, or JOINT[0], JOINT[1], … where it has several.
    #[getter]
    fn position_names(&self) -> Vec<String> {
        let of = |joint: &percuss::Joint| -> Vec<String> {
            match joint.kind().positions() {
                1 => vec![joint.name().to_owned()],
                count => (0..count).map(|i| format!("{}[{i}]", joint.name())).collect(),
            }
        };
        self.read.mechanism.joints().iter().flat_map(of).collect()
    }

    /// kg.
    #[getter]
    fn total_mass(&self) -> f64 {
        self.read.mechanism.total_mass()
    }

    /// Warnings and notes, in the order of the file.
    #[getter]
    fn diagnostics(&self) -> Vec<Diagnostic> {
        self.read.diagnostics.iter().cloned().map(Diagnostic).collect()
    }

    /// The mechanism as URDF.
    fn to_urdf(&self) -> String {
        write_urdf(&self.read.mechanism)
    }

    /// The mechanism under conditions.
    ///
    /// base: "fixed" or "floating". lock: joints that are held. armature: joint to inertia (kg·m² or kg), one value or one for
    /// each velocity. hold: points that are held, (link, point) or (link, point, normal): point (3,) m in the link's frame,
    /// normal (3,) in the root link's axes; without one, in all directions.
    #[pyo3(signature = (*, base="fixed", lock=Vec::new(), armature=None, hold=Vec::new()))]
    fn system(
        &self,
        base: &str,
        lock: Vec<String>,
        armature: Option<&Bound<'_, PyDict>>,
        hold: Vec<Bound<'_, PyAny>>,
    ) -> PyResult<System> {
        System::new(self, base, lock, armature, hold)
    }

    /// Puts the loops together, every joint free, the base fixed: system().assemble(guess).
    #[pyo3(signature = (guess=None))]
    fn assemble(&self, py: Python<'_>, guess: Option<&Bound<'_, PyDict>>) -> PyResult<Assembly> {
        System::plain(self)?.assemble(py, guess)
    }

    /// The pose at a configuration, every joint free, the base fixed: system().pose(…).
    #[pyo3(signature = (q=None, *, guess=None))]
    fn pose(
        &self,
        py: Python<'_>,
        q: Option<&Bound<'_, PyAny>>,
        guess: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Pose> {
        System::plain(self)?.pose(py, q, guess, None)
    }

    /// A model goes to another process as the text that it was read from; one that came of hardpoints as URDF.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<Rebuilt<'py>> {
        let (bytes, accept) = match self.source.as_deref() {
            Some((source, accept)) => (source.bytes.clone(), accept.clone()),
            None => (self.to_urdf().into_bytes(), Vec::new()),
        };
        let name = self.read.inputs.first().map_or_else(|| "<text>".to_owned(), |input| input.path.clone());
        Ok((py.import("percuss")?.getattr("_model")?, (bytes, name, accept)))
    }

    fn __repr__(&self) -> String {
        let mechanism = &self.read.mechanism;
        let moving = mechanism.joints().iter().filter(|joint| joint.kind() != JointKind::Fixed).count();
        format!(
            "<Model \"{}\": {} links, {moving} movable joints, {} closures, {} kg>",
            mechanism.name(),
            mechanism.links().len(),
            self.closures().len(),
            mechanism.total_mass()
        )
    }
}
