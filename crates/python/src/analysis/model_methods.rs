//! Python methods of a model: names, and construction of systems, assemblies and poses.

use crate::analysis::contact::Contact;
use crate::analysis::model::{Joint, Model};
use crate::analysis::pose::Pose;
use crate::analysis::system::{Assembly, System, position_names, velocity_names};
use crate::conversion::diagnostic::Diagnostic;
use crate::conversion::errors;
use crate::conversion::threads::abandonable;
use percuss::nalgebra::{Matrix3, Vector3};
use percuss::spatial::Transform;
use percuss::study::{Changes, contact_of_text};
use percuss::{BushDescription, JointKind, write_mjcf, write_sdf, write_urdf};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Function that rebuilds a model, and its arguments.
type RebuiltModel<'py> = (Bound<'py, PyAny>, (Vec<u8>, String, Vec<String>));

/// Number of links from which changes of a model take some milliseconds.
const LARGE_MODEL: usize = 64;
/// Part of the length of a direction that is across an axis, below which the direction is along the axis.
const ALONG_AXIS: f64 = 1e-9;

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

    /// The joints, in the order of the file, which is also the order of their positions.
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
                multiplier: joint.mimic().map(|mimic| mimic.multiplier),
                offset: joint.mimic().map(|mimic| mimic.offset),
                positions,
            }
        };
        mechanism.joints().iter().map(of).collect()
    }

    /// Names of the loop closures and couplings.
    #[getter]
    fn closures(&self) -> Vec<&str> {
        let mechanism = &self.read.mechanism;
        let couplings = mechanism.couplings().iter().map(|coupling| coupling.name());
        mechanism.closures().iter().map(|closure| closure.name()).chain(couplings).collect()
    }

    /// Names of the bushes.
    #[getter]
    fn bushes(&self) -> Vec<&str> {
        self.read.mechanism.bushes().iter().map(|bush| bush.name()).collect()
    }

    /// Names of the contacts.
    #[getter]
    fn contacts(&self) -> Vec<&str> {
        self.read.mechanism.contacts().iter().map(|contact| contact.name()).collect()
    }

    /// The contact of a name (Model.contacts), or of a text as for impact(also=…), such as "JOINT:upper". Its point, normal and links are
    /// those of the model; a gap is not part of it.
    fn contact(&self, name: &str) -> PyResult<Contact> {
        let found = contact_of_text(&self.read.mechanism, name);
        let found = found.map_err(|error| errors::of_argument("name")(errors::study(error)))?;
        Ok(Contact::of_resolved(&self.read.mechanism, &found))
    }

    /// Number of positions of a configuration: the positions of all joints together.
    #[getter]
    pub fn position_count(&self) -> usize {
        self.read.mechanism.joints().iter().map(|joint| joint.kind().positions()).sum()
    }

    /// Names of the positions, in order: the joint's name, or JOINT[0], JOINT[1], … for a joint with several positions.
    #[getter]
    fn position_names(&self) -> Vec<String> {
        position_names(&self.read.mechanism)
    }

    /// Name of each velocity, in the order of Sweep.gradient: joints in the order of the file.
    #[getter]
    fn velocity_names(&self) -> Vec<String> {
        velocity_names(&self.read.mechanism)
    }

    /// Total mass, kg.
    #[getter]
    fn total_mass(&self) -> f64 {
        self.read.mechanism.total_mass()
    }

    /// Poses that the file names, keyframes of MJCF: by name, the position of every joint that moves on its own, rad or m.
    #[getter]
    fn poses(&self) -> BTreeMap<String, BTreeMap<String, Vec<f64>>> {
        let poses = self.read.poses.iter();
        poses.map(|pose| (pose.name.clone(), pose.positions.iter().cloned().collect())).collect()
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

    /// The mechanism as MJCF, for MuJoCo 3.2.3 and later. Loops become equality constraints.
    fn to_mjcf(&self) -> PyResult<String> {
        write_mjcf(&*self.read.mechanism, "").map(|written| written.text).map_err(errors::input)
    }

    /// The mechanism as SDFormat 1.7, or 1.11 if a joint follows another. Loops become joints.
    fn to_sdf(&self) -> PyResult<String> {
        write_sdf(&*self.read.mechanism, "").map(|written| written.text).map_err(errors::input)
    }

    /// Names of the hardpoints that `changed` can move; empty unless the model comes from a sheet.
    #[getter]
    fn hardpoints(&self) -> Vec<String> {
        self.read.hardpoints().to_vec()
    }

    /// Copy of the model with changes, added to earlier changes. shape_density: kg/m³ of the shapes of the links, from which masses and
    /// inertias are computed first, with a warning. total_mass: kg of all links, to which all masses are scaled last. link_mass: link to mass in kg; the moments about the
    /// centre of mass scale in proportion. link_com: link to centre of mass, (3,) m in the link's frame; the moments
    /// about the centre of mass are unchanged. link_inertia: link to moments of inertia about the centre of mass, (3,) kg·m²,
    /// about the axes of the link's frame; the products of inertia are unchanged. move: hardpoint of a sheet to displacement,
    /// (3,) m, sheet's axes.
    #[pyo3(signature = (*, link_mass=BTreeMap::new(), link_com=BTreeMap::new(), link_inertia=BTreeMap::new(), r#move=BTreeMap::new(), shape_density=None, total_mass=None))]
    #[allow(clippy::too_many_arguments, reason = "one for each kind of change")]
    fn changed(
        &self,
        py: Python<'_>,
        link_mass: BTreeMap<String, f64>,
        link_com: BTreeMap<String, [f64; 3]>,
        link_inertia: BTreeMap<String, [f64; 3]>,
        r#move: BTreeMap<String, [f64; 3]>,
        shape_density: Option<f64>,
        total_mass: Option<f64>,
    ) -> PyResult<Self> {
        let changes = Changes {
            shape_density,
            total_mass,
            link_mass: link_mass.into_iter().collect(),
            link_com: link_com.into_iter().collect(),
            link_inertia: link_inertia.into_iter().collect(),
            moves: r#move.into_iter().collect(),
        };
        let (read, is_large) = (Arc::clone(&self.read), self.read.mechanism.links().len() >= LARGE_MODEL);
        let read = abandonable(py, is_large, move || read.with_changes(&changes))?;
        Model::new(py, read.map_err(errors::design)?)
    }

    /// Copy of the model with a bush: an elastic connection of two links, with one row for each direction of the bush (BushDescription in Rust).
    ///
    /// against: link on the other side, "world" for the ground. at: (3,) m, axis: (3,) direction z of the bush, x_axis: (3,) its x, by default any
    /// direction across the axis; all in the axes of `link`. stiffness: (6,) of small rotations about x and y (conical) and z (torsional), N·m/rad, then
    /// of translations along x and y (radial) and z (axial), N/m; math.inf for a row that allows no motion. damping: (6,) N·m·s/rad and N·s/m.
    /// loss_factor, dynamic_factor: of all rows. preload: (6,) N·m and N on `link` at all poses. replaces: joints and closures in whose place the bush is.
    /// rigid: (6,) rows that the rigid mechanism holds; by default the translations if the bush replaces a joint. `mass`, `response` and
    /// impact(in_time=True, compliance=True) have its effect.
    #[pyo3(signature = (name, link, *, stiffness, against="world", at=[0.0; 3], axis=[0.0, 0.0, 1.0], x_axis=None, damping=[0.0; 6], loss_factor=0.0, dynamic_factor=1.0, preload=[0.0; 6], replaces=Vec::new(), rigid=None))]
    #[allow(clippy::too_many_arguments, reason = "one for each number of a bush")]
    fn with_bush(
        &self,
        name: String,
        link: String,
        stiffness: [f64; 6],
        against: &str,
        at: [f64; 3],
        axis: [f64; 3],
        x_axis: Option<[f64; 3]>,
        damping: [f64; 6],
        loss_factor: f64,
        dynamic_factor: f64,
        preload: [f64; 6],
        replaces: Vec<String>,
        rigid: Option<[bool; 6]>,
    ) -> PyResult<Self> {
        if against != "world" {
            let found = self.read.mechanism.find_link(against);
            found.map_err(|error| errors::of_argument("against")(errors::input(error)))?;
        }
        for (name, factor) in [("loss_factor", loss_factor), ("dynamic_factor", dynamic_factor)] {
            if !factor.is_finite() {
                let why = format!("it is {factor}; expected a finite number");
                return Err(errors::of_argument(name)(errors::input(why)));
            }
        }
        let z = Vector3::from(axis).try_normalize(0.0);
        let z = z.ok_or_else(|| {
            errors::of_argument("axis")(errors::input("the axis is zero; expected a direction"))
        })?;
        let x = match x_axis {
            Some(given) => {
                let given = Vector3::from(given);
                let across = given - z * z.dot(&given);
                let is_across = across.norm() > ALONG_AXIS * given.norm();
                across.try_normalize(0.0).filter(|_| is_across).ok_or_else(|| {
                    errors::of_argument("x_axis")(errors::input(
                        "it is zero or along the axis; expected a direction across",
                    ))
                })?
            }
            None => percuss::spatial::plane_basis(&z).0,
        };
        let rotation = Matrix3::from_columns(&[x, z.cross(&x), z]);
        let held = !replaces.is_empty();
        let bush = BushDescription {
            frame: Transform::new(rotation, at.into()),
            stiffness,
            damping,
            loss_factor,
            dynamic_factor,
            preload,
            rigid: rigid.unwrap_or([false, false, false, held, held, held]),
            replaces,
            ..BushDescription::new(name, link, against)
        };
        let read = percuss::study::Model::clone(&self.read).with_bushes(&[bush]).map_err(errors::study)?;
        Ok(Self { read: Arc::new(read), source: None })
    }

    /// The mechanism under conditions.
    ///
    /// base: "fixed" or "floating". lock: names of joints that are locked, one name, or "all". armature: joint to inertia (kg·m² or kg), one value,
    /// or one for each velocity of the joint. hold: points that are held, (link, point) or (link, point, normal): point
    /// (3,) m in the link's frame, normal (3,) in the root link's axes; without a normal, the point is held in all
    /// directions.
    #[pyo3(signature = (*, base="fixed", lock=None, armature=None, hold=Vec::new()))]
    fn system(
        &self,
        base: &str,
        lock: Option<&Bound<'_, PyAny>>,
        armature: Option<&Bound<'_, PyDict>>,
        hold: Vec<Bound<'_, PyAny>>,
    ) -> PyResult<System> {
        let names = |given: &Bound<'_, PyAny>| match given.extract::<String>() {
            Ok(name) => Ok(vec![name]),
            Err(_) => given.extract::<Vec<String>>().map_err(errors::of_argument("lock")),
        };
        let lock = lock.map(names).transpose()?.unwrap_or_default();
        System::new(self, base, lock, armature, hold)
    }

    /// Assembles the loops with every joint free and a fixed base: system().assemble(guess).
    #[pyo3(signature = (guess=None))]
    fn assemble(&self, py: Python<'_>, guess: Option<&Bound<'_, PyDict>>) -> PyResult<Assembly> {
        System::unconstrained(self)?.assemble(py, guess)
    }

    /// The pose at a configuration with every joint free and a fixed base: system().pose(…).
    #[pyo3(signature = (q=None, *, guess=None, base_pose=None, other_assembly=false))]
    fn pose(
        &self,
        py: Python<'_>,
        q: Option<&Bound<'_, PyAny>>,
        guess: Option<&Bound<'_, PyDict>>,
        base_pose: Option<&Bound<'_, PyAny>>,
        other_assembly: bool,
    ) -> PyResult<Pose> {
        System::unconstrained(self)?.pose(py, q, guess, base_pose, other_assembly)
    }

    /// Pickles a model as its source text; a model from hardpoints or from several files is pickled as URDF.
    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<RebuiltModel<'py>> {
        let source = self.source.as_deref().filter(|_| self.read.inputs.len() <= 1);
        let (bytes, accept) = match source {
            Some((source, accept)) => (source.bytes.clone(), accept.clone()),
            None => (self.to_urdf().into_bytes(), Vec::new()),
        };
        let mut name =
            self.read.inputs.first().map_or_else(|| "<text>".to_owned(), |input| input.path.clone());
        if source.is_none() {
            // The ending of a sheet or of a table would be read as such.
            name.push_str(".urdf");
        }
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
