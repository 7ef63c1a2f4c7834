//! What is in a model.

use crate::{DiagnosticRecord, Model};
use percuss_dynamics::{Base, Conditions, ConditionsError, System};
use percuss_mechanism::{Geometry, Mechanism};
use serde::Serialize;
use std::collections::BTreeMap;

/// `percuss check`, as JSON.
#[derive(Clone, Debug, Serialize)]
pub struct CheckReport {
    /// `percuss.check/1`.
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// The file.
    pub inputs: Vec<crate::Input>,
    /// Name of the mechanism.
    pub name: String,
    /// Name of the root link.
    pub root: String,
    /// All links, in file order.
    pub links: Vec<LinkRecord>,
    /// All joints, in file order.
    pub joints: Vec<JointRecord>,
    /// Loop closures; none are read yet.
    pub closures: Vec<()>,
    /// Degrees of freedom with the root fixed.
    pub degrees_of_freedom: usize,
    /// The same at a generic pose.
    pub generic_degrees_of_freedom: usize,
    /// Constraint rows that add nothing.
    pub redundant_constraints: usize,
    /// kg.
    pub total_mass: f64,
    /// Position of every movable joint, in the layout of `--set`.
    pub pose: BTreeMap<String, Vec<f64>>,
    /// What was found while reading.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// A link in a [`CheckReport`].
#[derive(Clone, Debug, Serialize)]
pub struct LinkRecord {
    /// Its name.
    pub name: String,
    /// kg.
    pub mass: f64,
    /// Centre of mass in the link frame, m; none without mass.
    pub com: Option<[f64; 3]>,
    /// Whether it has an `<inertial>`.
    pub has_inertial: bool,
    /// What is known of its shape: `none`, `primitives` or `mesh`.
    pub geometry: &'static str,
}

/// A joint in a [`CheckReport`].
#[derive(Clone, Debug, Serialize)]
pub struct JointRecord {
    /// Its name.
    pub name: String,
    /// Its kind.
    pub kind: &'static str,
    /// Parent link.
    pub parent: String,
    /// Child link.
    pub child: String,
    /// Axis in the joint frame; none where the kind has none.
    pub axis: Option<[f64; 3]>,
    /// Position limits, rad or m.
    pub limits: Option<[f64; 2]>,
    /// Rotor inertia reflected to the joint, one value a velocity.
    pub armature: Vec<f64>,
    /// The joint it follows.
    pub mimics: Option<String>,
}

/// Looks through a model with its root fixed.
///
/// # Errors
/// [`ConditionsError`], which default conditions never give.
pub fn check(model: &Model) -> Result<CheckReport, ConditionsError> {
    let mechanism = &model.mechanism;
    let system = System::new(std::sync::Arc::clone(mechanism), &Conditions::new().base(Base::Fixed))?;
    let pose = system.pose(&system.configuration());
    let freedom = system.degrees_of_freedom();
    Ok(CheckReport {
        schema: "percuss.check/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: vec![model.input.clone()],
        name: mechanism.name().to_owned(),
        root: mechanism.link(mechanism.root()).name().to_owned(),
        links: links(mechanism),
        joints: joints(mechanism),
        closures: Vec::new(),
        degrees_of_freedom: freedom,
        generic_degrees_of_freedom: freedom,
        redundant_constraints: system.redundant_constraints(),
        total_mass: mechanism.total_mass(),
        pose: crate::mass::pose_record(mechanism, &pose),
        diagnostics: model.diagnostics.clone(),
    })
}

fn links(mechanism: &Mechanism) -> Vec<LinkRecord> {
    let record = |link: &percuss_mechanism::Link| LinkRecord {
        name: link.name().to_owned(),
        mass: link.inertia().mass,
        com: (link.inertia().mass > 0.0).then(|| (link.inertia().first_moment / link.inertia().mass).into()),
        has_inertial: link.has_inertial(),
        geometry: match link.geometry() {
            Geometry::None => "none",
            Geometry::Within(_) => "primitives",
            Geometry::Mesh => "mesh",
        },
    };
    mechanism.links().iter().map(record).collect()
}

fn joints(mechanism: &Mechanism) -> Vec<JointRecord> {
    let record = |joint: &percuss_mechanism::Joint| JointRecord {
        name: joint.name().to_owned(),
        kind: joint.kind().name(),
        parent: mechanism.link(joint.parent()).name().to_owned(),
        child: mechanism.link(joint.child()).name().to_owned(),
        axis: joint.kind().has_axis().then(|| (*joint.axis()).into()),
        limits: joint.limits().map(|l| [l.lower, l.upper]),
        armature: joint.armature().to_vec(),
        mimics: joint.mimic().map(|m| mechanism.joint(m.master).name().to_owned()),
    };
    mechanism.joints().iter().map(record).collect()
}
