//! Contents of a model.

use crate::checks::findings::collect_pose_findings;
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::pose::positions::{PoseLayout, Positions};
use crate::question::errors::question_error::StudyError;
use crate::question::names::{Names, conditions_error_key};
use crate::thresholds::CHECKED_MESHES;
use percuss_dynamics::{Base, Conditions, System};
use percuss_formats::inertias_beyond_meshes;
use percuss_mechanism::{Geometry, Mechanism, Subject};
use schemars::JsonSchema;
use serde::Serialize;

/// Report of `percuss check`, as JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct CheckReport {
    /// `percuss.check/1`.
    #[schemars(extend("const" = "percuss.check/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files.
    pub inputs: Vec<Input>,
    /// Name of the mechanism.
    pub name: String,
    /// Name of the root link.
    pub root: String,
    /// All links, in file order.
    pub links: Vec<LinkRecord>,
    /// All joints, in file order.
    pub joints: Vec<JointRecord>,
    /// Loop closures and couplings, in file order.
    pub closures: Vec<ClosureRecord>,
    /// Degrees of freedom with the root fixed, at the pose shown.
    pub degrees_of_freedom: usize,
    /// Degrees of freedom with the root fixed, at a generic pose.
    pub generic_degrees_of_freedom: usize,
    /// Number of linearly dependent constraint rows.
    pub redundant_constraints: usize,
    /// Loops and couplings with redundant rows; entries that cannot be separated form one group.
    pub redundant_loops: Vec<Vec<String>>,
    /// Gap between the singular values of A above and below the rank; null without loops.
    pub rank_gap: Option<f64>,
    /// Joints that drive the loops.
    pub drivers: Vec<String>,
    /// Closure residual of the loops, m; null without loops.
    pub closure_residual: Option<f64>,
    /// Total mass, kg.
    pub total_mass: f64,
    /// Position of every movable joint, in the layout of `--set`.
    pub pose: Positions,
    /// Names of the poses of the file, for `--pose`: keyframes of MJCF.
    pub poses: Vec<String>,
    /// Findings of the reader and of the assembly.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// A link in a [`CheckReport`].
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct LinkRecord {
    /// Name of the link.
    pub name: String,
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass in the link frame, m; null without mass.
    pub com: Option<[f64; 3]>,
    /// True if the link has an `<inertial>`.
    pub has_inertial: bool,
    /// Kind of the shape: `none`, `primitives` or `mesh`.
    pub geometry: &'static str,
}

/// A joint in a [`CheckReport`].
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct JointRecord {
    /// Name of the joint.
    pub name: String,
    /// Kind of the joint.
    pub kind: &'static str,
    /// Parent link.
    pub parent: String,
    /// Child link.
    pub child: String,
    /// Axis in the joint frame; null if the kind has no axis.
    pub axis: Option<[f64; 3]>,
    /// Position limits, rad or m.
    pub limits: Option<[f64; 2]>,
    /// Rotor inertia reflected to the joint, one value per velocity.
    pub armature: Vec<f64>,
    /// Stiffness (N·m/rad or N/m), damping (N·m·s/rad or N·s/m) and position without force (rad or m) of the spring of the joint.
    pub spring: Option<[f64; 3]>,
    /// Stiffness (N·m/rad or N/m) and damping (N·m·s/rad or N·s/m) of the elastic gear of the joint.
    pub gear: Option<[f64; 2]>,
    /// Master joint of a mimic.
    pub mimics: Option<String>,
}

/// A loop closure or coupling in a [`CheckReport`].
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ClosureRecord {
    /// Name of the closure or coupling.
    pub name: String,
    /// Kind of the closure; `coupling` for a ratio of two links, `relation` for a relation of joints.
    pub kind: &'static str,
    /// Predecessor link; null for a relation of joints.
    pub predecessor: Option<String>,
    /// Successor link; null for a relation of joints.
    pub successor: Option<String>,
    /// Number of constraint rows.
    pub rows: usize,
    /// Ratio of the successor's rate to the predecessor's rate; null unless a coupling of two links.
    pub ratio: Option<f64>,
    /// Joints of a relation Σ fᵢ qᵢ = c (or c plus a polynomial) with their coefficients fᵢ; empty for other closures.
    pub joints: Vec<RelationTermRecord>,
}

/// Joint of a relation in a [`ClosureRecord`].
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct RelationTermRecord {
    /// Joint.
    pub joint: String,
    /// Coefficient of its position.
    pub coefficient: f64,
}

/// Lists the contents of a model with the root fixed.
///
/// # Errors
/// [`StudyError`]: loops that do not close.
pub fn check(model: &Model) -> Result<CheckReport, StudyError> {
    let mechanism = &model.mechanism;
    let conditions = Conditions::new().base(Base::Fixed);
    let system = System::new(std::sync::Arc::clone(mechanism), &conditions)
        .map_err(|error| StudyError::input(conditions_error_key(&error), error))?;
    let pose = system.pose(&system.configuration())?;
    let assembly = pose.assembly();
    let mut diagnostics = model.diagnostics.clone();
    diagnostics.extend(mesh_diagnostics(model));
    diagnostics
        .extend(collect_pose_findings(&system, &pose, Names::Fields).into_iter().map(DiagnosticRecord::from));
    Ok(CheckReport {
        schema: "percuss.check/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: model.inputs.clone(),
        name: mechanism.name().to_owned(),
        root: mechanism.link(mechanism.root()).name().to_owned(),
        links: links(mechanism),
        joints: joints(mechanism),
        closures: closure_records(mechanism),
        degrees_of_freedom: pose.degrees_of_freedom(),
        generic_degrees_of_freedom: assembly.degrees_of_freedom(),
        redundant_constraints: assembly.redundant_constraints(),
        redundant_loops: assembly.redundant_loops().to_vec(),
        rank_gap: assembly.rank_gap(),
        drivers: pose.loops().map_or_else(Vec::new, |l| {
            l.drivers.iter().map(|id| mechanism.joint(*id).name().to_owned()).collect()
        }),
        closure_residual: pose.loops().map(|l| l.residual),
        total_mass: mechanism.total_mass(),
        pose: Positions::from_pose(&PoseLayout::new(mechanism), &pose),
        poses: model.poses.iter().map(|pose| pose.name.clone()).collect(),
        diagnostics,
    })
}

/// Warnings about inertias that no mass inside the meshes of a link has; the readers do not open meshes.
fn mesh_diagnostics(model: &Model) -> impl Iterator<Item = DiagnosticRecord> {
    let folders = model.mesh_folders(Vec::new());
    let found = inertias_beyond_meshes(&model.mechanism, &model.shapes, &folders, CHECKED_MESHES);
    let path = model.inputs.first().map(|input| input.path.clone());
    found.into_iter().map(move |(subject, problem)| DiagnosticRecord {
        severity: problem.severity(),
        code: problem.code(),
        path: path.clone(),
        line: None,
        column: None,
        element: match subject {
            Subject::Link { name, .. } => Some(format!("link[{name}]")),
            _ => None,
        },
        message: problem.to_string(),
    })
}

/// Records of closures and couplings.
fn closure_records(mechanism: &Mechanism) -> Vec<ClosureRecord> {
    let end = |link: Option<percuss_mechanism::LinkId>| {
        link.map_or_else(|| "world".to_owned(), |l| mechanism.link(l).name().to_owned())
    };
    let closure = |c: &percuss_mechanism::Closure| ClosureRecord {
        name: c.name().to_owned(),
        kind: c.kind().name(),
        predecessor: Some(end(c.predecessor().link)),
        successor: Some(end(c.successor().link)),
        rows: c.kind().rows(),
        ratio: None,
        joints: Vec::new(),
    };
    let coupling = |c: &percuss_mechanism::Coupling| {
        let ratio = c.ratio();
        let joints = match ratio {
            Some(_) => Vec::new(),
            None => c
                .terms()
                .iter()
                .map(|&(joint, coefficient)| RelationTermRecord {
                    joint: mechanism.joint(joint).name().to_owned(),
                    coefficient,
                })
                .collect(),
        };
        ClosureRecord {
            name: c.name().to_owned(),
            kind: if ratio.is_some() { "coupling" } else { "relation" },
            predecessor: ratio.map(|links| end(Some(links.predecessor))),
            successor: ratio.map(|links| end(Some(links.successor))),
            rows: 1,
            ratio: ratio.map(|links| links.ratio),
            joints,
        }
    };
    mechanism.closures().iter().map(closure).chain(mechanism.couplings().iter().map(coupling)).collect()
}

/// Records of the links.
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

/// Records of the joints.
fn joints(mechanism: &Mechanism) -> Vec<JointRecord> {
    let record = |joint: &percuss_mechanism::Joint| JointRecord {
        name: joint.name().to_owned(),
        kind: joint.kind().name(),
        parent: mechanism.link(joint.parent()).name().to_owned(),
        child: mechanism.link(joint.child()).name().to_owned(),
        axis: joint.kind().has_axis().then(|| (*joint.axis()).into()),
        limits: joint.limits().map(|l| [l.lower, l.upper]),
        armature: joint.armature().to_vec(),
        spring: joint.spring().map(|spring| [spring.stiffness, spring.damping, spring.reference]),
        gear: joint.gear().map(|gear| [gear.stiffness, gear.damping]),
        mimics: joint.mimic().map(|m| mechanism.joint(m.master).name().to_owned()),
    };
    mechanism.joints().iter().map(record).collect()
}
