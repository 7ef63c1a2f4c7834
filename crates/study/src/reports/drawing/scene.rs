//! Scene of a model: everything that a moving picture needs once, and the frames of the links at a pose.

use crate::evaluation::prepared_question::{EvaluatedQuestion, compile, configuration};
use crate::model::loading::Model;
use crate::model::record::DiagnosticRecord;
use crate::pose::pose_solver;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::travel::moved::WheelMotion;
use crate::reports::answer_mass::build_mass_report;
use crate::reports::drawing::link_lines::{
    centre_of_mass, characteristic_points, design_point_in_link, link_lines,
};
use crate::reports::drawing::shape_reader::ShapeReader;
use crate::reports::mass_report::MassReport;
use crate::thresholds::TOUCH_TOLERANCE;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use percuss_dynamics::{PointVelocity, Pose};
use percuss_mechanism::{ContactNormal, Link, LinkId, Mechanism, NamedContact};
use percuss_spatial::{Transform, Vector3};
use schemars::JsonSchema;
use serde::Serialize;

/// Scene of a model with the root fixed. Links are numbered in file order; lengths in m.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Scene {
    /// `percuss.scene/1`.
    #[schemars(extend("const" = "percuss.scene/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Name of the mechanism.
    pub name: String,
    /// Number of the root link.
    pub root: usize,
    /// All links.
    pub links: Vec<SceneLink>,
    /// All joints.
    pub joints: Vec<SceneJoint>,
    /// All loop closures.
    pub closures: Vec<SceneClosure>,
    /// All named contacts.
    pub contacts: Vec<SceneContact>,
    /// Wheels of an imported suspension.
    pub wheels: Vec<SceneWheel>,
    /// Motions of the wheels that drive the pose: `wheel-travel`, or `heave` and `roll`; empty without wheels on loops.
    pub motions: Vec<&'static str>,
    /// Hardpoints of the sheet; `None` for a URDF or MJCF.
    pub sheet: Option<SceneSheet>,
    /// Frames with all joints at 0 and loops closed.
    pub design: Frames,
}

/// Link of a scene.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SceneLink {
    /// Name.
    pub name: String,
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass, frame of the link; `None` without mass.
    pub com: Option<[f64; 3]>,
    /// Moments of inertia about the centre of mass and the axes of the link frame, kg·m²; `None` without mass.
    pub moments: Option<[f64; 3]>,
    /// Lines between the joints, frame of the link.
    pub lines: Vec<[[f64; 3]; 2]>,
}

/// Joint of a scene.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SceneJoint {
    /// Name.
    pub name: String,
    /// Kind.
    pub kind: &'static str,
    /// Number of the parent link.
    pub parent: usize,
    /// Number of the child link; the frame of the joint is that of the child.
    pub child: usize,
    /// Axis, frame of the child; `None` if the kind has no axis.
    pub axis: Option<[f64; 3]>,
    /// Position limits, rad or m.
    pub limits: Option<[f64; 2]>,
    /// True if the position can be set: no mimic, and not determined by loops.
    pub can_be_set: bool,
}

/// Loop closure of a scene.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SceneClosure {
    /// Name.
    pub name: String,
    /// Kind.
    pub kind: &'static str,
    /// Ends: number of the link, `None` for the ground, and the point in its frame.
    pub ends: [(Option<usize>, [f64; 3]); 2],
}

/// Named contact of a scene.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SceneContact {
    /// Name.
    pub name: String,
    /// `stop`, `spring`, `damper`, `patch` or `other`.
    #[schemars(extend("enum" = ["stop", "spring", "damper", "patch", "other"]))]
    pub kind: &'static str,
    /// Number of the contact link.
    pub link: usize,
    /// Contact point, frame of the contact link.
    pub point: [f64; 3],
    /// Number of the other link; `None` for the ground.
    pub against: Option<usize>,
    /// `fixed`: `vector` is the normal in the frame of the other side; `toward`, `away`: `vector` is the seat there.
    pub normal: &'static str,
    /// Normal or seat.
    pub vector: [f64; 3],
    /// Gap with all joints at 0; `None` if the parts always touch.
    pub gap: Option<f64>,
}

/// Wheel of a scene, as a circle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SceneWheel {
    /// Number of the link with the bearing.
    pub link: usize,
    /// Centre, frame of the link.
    pub centre: [f64; 3],
    /// Spin axis, frame of the link.
    pub axis: [f64; 3],
    /// Radius.
    pub radius: f64,
}

/// Hardpoints of a suspension sheet.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SceneSheet {
    /// Unit of the lengths of the sheet.
    pub unit: &'static str,
    /// Length of the unit, m.
    pub unit_length: f64,
    /// Directions of the axes of the sheet, in words.
    pub axes: String,
    /// The points.
    pub hardpoints: Vec<SceneHardpoint>,
}

/// Hardpoint of a sheet.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SceneHardpoint {
    /// Name.
    pub name: String,
    /// Coordinates, m, in the axes of the sheet and on the side of its points.
    pub coordinates: [f64; 3],
    /// Factors of x, y and z from the axes of the sheet to those of the world; y changes its sign as well if the other side
    /// is built.
    pub to_world: [f64; 3],
    /// Number of a link that carries the point; the root link if no other does.
    pub link: usize,
    /// The point in the frame of this link.
    pub point: [f64; 3],
}

/// Frames of all links in the world: per link the rows of the rotation, then the position, m.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
#[serde(transparent)]
pub struct Frames(pub Vec<f64>);

impl Frames {
    /// Transforms from the link frames to the world at a pose, in the order of the links.
    fn at(mechanism: &Mechanism, pose: &Pose) -> Self {
        let numbers = |id: LinkId| {
            let Transform { rotation, translation } = pose.link(id);
            let rows: Vec<f64> = (0..3).flat_map(|i| (0..3).map(move |j| rotation[(i, j)])).collect();
            rows.into_iter().chain(translation.iter().copied().collect::<Vec<_>>())
        };
        Self(mechanism.link_ids().flat_map(numbers).collect())
    }
}

/// Result of a contact with the frames of the links.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct PosedMass {
    /// The result.
    pub report: MassReport,
    /// Frames at the pose of the result.
    pub frames: Frames,
    /// Velocities v* of the centres of mass per unit closing speed, by link; `None` if massless or undetermined.
    pub velocities: Vec<Option<[f64; 3]>>,
}

/// Evaluates one contact of a model, with the frames of the links at the pose.
///
/// # Errors
/// As for [`mass`](crate::mass()).
pub fn mass_with_frames(model: &Model, question: &MassQuestion) -> Result<PosedMass, StudyError> {
    let evaluated = EvaluatedQuestion::new(model, question)?;
    let EvaluatedQuestion { pose, result, .. } = &evaluated;
    let velocity = |id: LinkId| {
        let com = centre_of_mass(&model.mechanism, id)?;
        match pose.point_velocity_over_ground(&result.response, id, &com)? {
            PointVelocity::Known(v) => Some(pose.base().vector(&v).into()),
            PointVelocity::Undetermined => None,
        }
    };
    Ok(PosedMass {
        report: build_mass_report(&evaluated)?,
        frames: Frames::at(&model.mechanism, pose),
        velocities: model.mechanism.link_ids().map(velocity).collect(),
    })
}

/// Frames of the links at the pose of a question; the contact only brings its stop to the touch.
///
/// # Errors
/// [`StudyError`]: unknown names, loops that do not close, a travel that is not reachable.
pub fn link_frames(model: &Model, question: &MassQuestion) -> Result<Frames, StudyError> {
    let system = compile(&model.mechanism, question, None)?;
    let question = &*question.resolve_contact(&model.mechanism)?;
    let pose = pose_solver::pose(&system, &configuration(&model.mechanism, question)?, question)?;
    Ok(Frames::at(&model.mechanism, &pose))
}

/// Scene of a model.
///
/// # Errors
/// [`StudyError`]: loops that do not close.
pub fn scene(model: &Model) -> Result<Scene, StudyError> {
    let mechanism = &model.mechanism;
    let system = compile(mechanism, &MassQuestion::default(), None)?;
    let pose = system.pose(&system.configuration())?;
    let drivers = pose.loops().map_or(&[][..], |loops| &loops.drivers);
    let points = characteristic_points(mechanism);
    let link = |id: LinkId| {
        let is_ground = id == mechanism.root();
        let of_link = mechanism.link(id);
        let lines = link_lines(model, id, &points[id.index()]);
        SceneLink {
            name: of_link.name().to_owned(),
            mass: of_link.inertia().mass,
            com: centre_of_mass(mechanism, id).map(Into::into),
            moments: moments(of_link),
            lines: if is_ground { Vec::new() } else { lines.iter().map(|l| l.map(Into::into)).collect() },
        }
    };
    let joint = |id| {
        let joint = mechanism.joint(id);
        let is_free = joint.kind().dofs() > 0 && joint.mimic().is_none();
        SceneJoint {
            name: joint.name().to_owned(),
            kind: joint.kind().name(),
            parent: joint.parent().index(),
            child: joint.child().index(),
            axis: joint.kind().has_axis().then(|| (*joint.axis()).into()),
            limits: joint.limits().map(|limits| [limits.lower, limits.upper]),
            can_be_set: is_free && (!system.is_bound(id) || drivers.contains(&id)),
        }
    };
    let closure = |closure: &percuss_mechanism::Closure| SceneClosure {
        name: closure.name().to_owned(),
        kind: closure.kind().name(),
        ends: [closure.predecessor(), closure.successor()]
            .map(|end| (end.link.map(LinkId::index), end.frame.translation.into())),
    };
    Ok(Scene {
        schema: "percuss.scene/1",
        percuss: env!("CARGO_PKG_VERSION"),
        name: mechanism.name().to_owned(),
        root: mechanism.root().index(),
        links: mechanism.link_ids().map(link).collect(),
        joints: mechanism.joint_ids().map(joint).collect(),
        closures: mechanism.closures().iter().map(closure).collect(),
        contacts: mechanism.contacts().iter().map(contact).collect(),
        wheels: mechanism.link_ids().filter_map(|id| wheel(mechanism, &pose, id)).collect(),
        motions: motions(mechanism),
        sheet: sheet(model, &points, &pose),
        design: Frames::at(mechanism, &pose),
    })
}

/// Triangles of the shapes of the links.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SceneShapes {
    /// Per link: base64 of the corners as 32-bit floats (little endian, m, frame of the link), nine numbers per triangle; `None`
    /// without a shape.
    pub links: Vec<Option<String>>,
    /// Findings about omitted shapes.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// Reads the shapes of the links of a model.
pub fn scene_shapes(model: &Model) -> SceneShapes {
    let mut reader = ShapeReader::new(model);
    let mut encode = |id: LinkId| {
        let triangles = reader.link_triangles(id);
        let numbers = triangles.iter().flatten().flatten();
        let bytes: Vec<u8> = numbers.flat_map(|x| (*x as f32).to_le_bytes()).collect();
        (!bytes.is_empty()).then(|| STANDARD.encode(bytes))
    };
    let links = model.mechanism.link_ids().map(&mut encode).collect();
    SceneShapes { links, diagnostics: reader.diagnostics }
}

/// Moments of inertia of a link with mass about its centre of mass.
fn moments(link: &Link) -> Option<[f64; 3]> {
    let inertial = link.inertial().filter(|inertial| inertial.mass > 0.0)?;
    Some(inertial.about_com.diagonal().into())
}

/// Named contact of a scene.
fn contact(contact: &NamedContact) -> SceneContact {
    let (normal, vector) = match contact.normal() {
        ContactNormal::Fixed(direction) => ("fixed", direction),
        ContactNormal::Toward(seat) => ("toward", seat),
        ContactNormal::Away(seat) => ("away", seat),
    };
    SceneContact {
        name: contact.name().to_owned(),
        kind: contact.kind().name(),
        link: contact.link().index(),
        point: (*contact.point()).into(),
        against: contact.against().map(LinkId::index),
        normal,
        vector: (*vector).into(),
        gap: contact.gap(),
    }
}

/// Motions of the wheels that the mechanism has.
fn motions(mechanism: &Mechanism) -> Vec<&'static str> {
    if mechanism.closures().is_empty() {
        return Vec::new();
    }
    let is_wheel = |link: &&percuss_mechanism::Link| link.name().starts_with("wheel_centre");
    match mechanism.links().iter().filter(is_wheel).count() {
        0 => Vec::new(),
        1 => vec![WheelMotion::WheelTravel.name()],
        _ => vec![WheelMotion::Heave.name(), WheelMotion::Roll.name()],
    }
}

/// Circle of a wheel, if the link has the name that the suspension importer gives to wheel centres: about the bearing axis,
/// through the contact patch at the design position.
fn wheel(mechanism: &Mechanism, pose: &Pose, centre: LinkId) -> Option<SceneWheel> {
    let side = mechanism.link(centre).name().strip_prefix("wheel_centre")?;
    let patch = mechanism.find_link(&format!("contact_patch{side}")).ok()?;
    let bearing = mechanism.joint(mechanism.find_joint(&format!("spin{side}")).ok()?);
    let at = |link: LinkId| pose.link(link).translation;
    let frame = pose.link(centre);
    let axis = frame.inverse_vector(&pose.link(bearing.child()).vector(bearing.axis()));
    let spoke = frame.inverse_vector(&(at(patch) - at(centre)));
    let radius = (spoke - axis * axis.dot(&spoke)).norm();
    (radius > 0.0 && radius.is_finite()).then(|| SceneWheel {
        link: centre.index(),
        centre: [0.0; 3],
        axis: axis.into(),
        radius,
    })
}

/// Hardpoints of the sheet of a model, each with a link that carries the point; `None` if x, y, z of the sheet are not along the vehicle,
/// across it and vertical, in this order.
fn sheet(model: &Model, points: &[Vec<Vector3<f64>>], pose: &Pose) -> Option<SceneSheet> {
    let origin = model.origin.sheet.as_deref().filter(|origin| origin.understood.axes.is_in_order())?;
    let mechanism = &model.mechanism;
    let tolerance = TOUCH_TOLERANCE * mechanism.characteristic_length();
    // The links with their points of the design position: characteristic points and ends of drawn lines.
    let carriers: Vec<(LinkId, Vec<Vector3<f64>>)> = mechanism
        .link_ids()
        .filter(|id| *id != mechanism.root())
        .map(|id| {
            let lines = link_lines(model, id, &points[id.index()]);
            (id, points[id.index()].iter().copied().chain(lines.into_iter().flatten()).collect())
        })
        .collect();
    let axes: [f64; 3] = origin.understood.axes.to_iso(Vector3::repeat(1.0)).into();
    let carrier_of = |world: Vector3<f64>| {
        carriers.iter().find_map(|(id, ends)| {
            let point = design_point_in_link(mechanism, *id, world);
            ends.iter().any(|end| (end - point).norm() <= tolerance).then_some((*id, point))
        })
    };
    // If only the other side is built, its points are mirror images.
    let is_mirrored = origin.understood.coordinates.iter().all(|(_, at)| {
        let world = Vector3::from([0, 1, 2].map(|k| axes[k] * at[k]));
        at[1] == 0.0 || carrier_of(world).is_none()
    });
    let to_world = if is_mirrored { [axes[0], -axes[1], axes[2]] } else { axes };
    let hardpoint = |(name, coordinates): &(String, [f64; 3])| {
        let world = Vector3::from([0, 1, 2].map(|k| to_world[k] * coordinates[k]));
        let (link, point) = carrier_of(world)
            .unwrap_or_else(|| (mechanism.root(), pose.link(mechanism.root()).inverse_point(&world)));
        SceneHardpoint {
            name: name.clone(),
            coordinates: *coordinates,
            to_world,
            link: link.index(),
            point: point.into(),
        }
    };
    Some(SceneSheet {
        unit: origin.understood.unit.name(),
        unit_length: origin.understood.unit.to_metres(1.0),
        axes: origin.understood.axes.words(),
        hardpoints: origin.understood.coordinates.iter().map(hardpoint).collect(),
    })
}
