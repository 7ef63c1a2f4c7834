//! One contact of a model: the question and the answer.

use crate::far_point;
use crate::model::Input;
use crate::quantity::{QuantityError, parse_list, position_dimension};
use crate::{DiagnosticRecord, Model};
use nalgebra::Vector3;
use percuss_dynamics::{
    Base, Conditions, ConditionsError, Configuration, ConfigurationError, Contact, Direction, EffectiveMass,
    Frame, Pose, Remark, Route, RouteChoice, Strike, StrikeError, System,
};
use percuss_mechanism::{JointId, LinkId, Mechanism, Severity, UnknownName};
use serde::Serialize;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Where the normal of a question points.
#[derive(Clone, Debug, PartialEq)]
pub enum Normal {
    /// Along a vector in the question's frame.
    Along([f64; 3]),
    /// From the contact point towards a point (m) of a link, in that link's frame.
    Toward(String, [f64; 3]),
}

/// A contact of a model, by names. The same words as the flags of `percuss mass`.
#[derive(Clone, Debug, PartialEq)]
pub struct MassQuestion {
    /// The struck link.
    pub link: String,
    /// The contact point, m, in `frame`.
    pub point: [f64; 3],
    /// The normal, out of the struck link.
    pub normal: Normal,
    /// In which frame `point` and a normal along a vector are given.
    pub frame: Frame,
    /// The other link; none: the ground.
    pub against: Option<String>,
    /// Mass of a free body on the other side, kg.
    pub against_mass: Option<f64>,
    /// Driving joints and what they are set to, as typed: numbers between commas, units allowed.
    pub set: Vec<(String, String)>,
    /// Joints that are held.
    pub lock: Vec<String>,
    /// Joints whose armature is replaced: one value, or one for each velocity.
    pub armature: Vec<(String, Vec<f64>)>,
    /// How the root stands.
    pub base: Base,
}

/// Why a question has no answer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// A name that nothing bears.
    #[error(transparent)]
    UnknownName(#[from] UnknownName),
    /// A position that cannot be set.
    #[error(transparent)]
    Configuration(#[from] ConfigurationError),
    /// A lock or an armature that does not fit.
    #[error(transparent)]
    Conditions(#[from] ConditionsError),
    /// A contact that means nothing, or an impossible mass matrix.
    #[error(transparent)]
    Strike(#[from] StrikeError),
    /// A number that is none.
    #[error("--set {joint}: {source}")]
    Set {
        /// The joint.
        joint: String,
        /// What is wrong.
        source: QuantityError,
    },
    /// The other body's mass is no mass.
    #[error("the other body's mass is {mass} kg; a finite number above 0 is wanted")]
    OtherMass {
        /// What was given.
        mass: f64,
    },
}

impl StudyError {
    /// Whether the question was fine and yet has no answer (exit code 1, not 2).
    pub fn is_no_answer(&self) -> bool {
        matches!(self, StudyError::Strike(StrikeError::Route(_)))
    }
}

/// Kind of answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// m̄ is a number.
    Finite,
    /// No admissible motion closes the gap.
    Immovable,
    /// A motion without energy closes the gap.
    Massless,
}

/// What part of m̄ a link carries.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BodyShare {
    /// The link.
    pub link: String,
    /// Its part; null unless the mass is finite.
    pub share: Option<f64>,
}

/// What part of m̄ a rotor carries.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RotorShare {
    /// The joint it drives.
    pub joint: String,
    /// Its part; null unless the mass is finite.
    pub share: Option<f64>,
}

/// The contact, in the world and in the struck link.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ContactRecord {
    /// The struck link.
    pub link: String,
    /// The other link; null: the ground.
    pub against: Option<String>,
    /// m.
    pub point_world: [f64; 3],
    /// Unit vector out of the struck link.
    pub normal_world: [f64; 3],
    /// m.
    pub point_link: [f64; 3],
    /// Unit vector out of the struck link.
    pub normal_link: [f64; 3],
}

/// What an answer takes for granted; for people, not in the JSON.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Assumptions {
    /// `fixed` or `floating`, and the root link.
    pub base: String,
    /// Joints that move on their own.
    pub free: Vec<String>,
    /// Joints that stand still, by a lock of their own or of what they follow.
    pub locked: Vec<String>,
    /// Joints that follow others.
    pub mimics: Vec<String>,
    /// Joints that were set.
    pub set: Vec<String>,
}

/// `percuss mass`, as JSON. Keys are always present, null where they do not apply.
#[derive(Clone, Debug, Serialize)]
pub struct MassReport {
    /// `percuss.mass/1`.
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// The files.
    pub inputs: Vec<Input>,
    /// m̄, kg; null unless finite.
    pub effective_mass: Option<f64>,
    /// Kind of answer.
    pub status: Status,
    /// Whether the pose is singular: fewer independent constraints than at a generic pose.
    pub singular_pose: bool,
    /// dim ker A at the pose, a floating base's 6 included.
    pub degrees_of_freedom: usize,
    /// The same at a generic pose.
    pub generic_degrees_of_freedom: usize,
    /// Constraint rows that add nothing.
    pub redundant_constraints: usize,
    /// Gap between the singular values of A that count and those that do not; null without loops.
    pub rank_gap: Option<f64>,
    /// `dense` or `articulated`.
    pub route: &'static str,
    /// Condition of the mass matrix scaled to unit diagonal; null where it is singular.
    pub condition: Option<f64>,
    /// First-order bound on the error of m̄, kg.
    pub effective_mass_error: Option<f64>,
    /// Shares of the links, in file order.
    pub bodies: Vec<BodyShare>,
    /// Shares of the rotors.
    pub rotors: Vec<RotorShare>,
    /// Share of the other body, where it was given as a number.
    pub other_mass_share: Option<f64>,
    /// Position of every movable joint, in the layout of `--set`.
    pub pose: BTreeMap<String, Vec<f64>>,
    /// How far loops are from closed, m; null without loops.
    pub closure_residual: Option<f64>,
    /// How inexact the file's loops are, m; null without loops.
    pub closure_inexactness: Option<f64>,
    /// The length that scales rank decisions, m.
    pub characteristic_length: f64,
    /// The contact.
    pub contact: ContactRecord,
    /// What was found, in the file and in the answer.
    pub diagnostics: Vec<DiagnosticRecord>,
    /// What the answer takes for granted.
    #[serde(skip)]
    pub assumptions: Assumptions,
}

/// Answers one contact of a model.
///
/// # Errors
/// [`StudyError`]: names that nothing bears, positions that cannot be set, a contact that means nothing.
pub fn mass(model: &Model, question: &MassQuestion) -> Result<MassReport, StudyError> {
    let mechanism = &model.mechanism;
    let mut conditions = Conditions::new().base(question.base);
    for joint in &question.lock {
        conditions = conditions.lock(joint);
    }
    for (joint, values) in &question.armature {
        conditions = conditions.armature(joint, values.clone());
    }
    if let Some(mass) = question.against_mass.filter(|m| !(m.is_finite() && *m > 0.0)) {
        return Err(StudyError::OtherMass { mass });
    }
    let system = System::new(Arc::clone(mechanism), &conditions)?;
    let pose = system.pose(&configuration(mechanism, &question.set)?);
    let contact = contact(&system, &pose, question)?;
    let mut strike = system.strike(&pose, &contact, RouteChoice::Auto)?;
    let mut diagnostics = model.diagnostics.clone();
    diagnostics.extend(far_point::doubt(mechanism, contact.link, &contact.point));
    diagnostics.extend(pose.outside_limits(&system).map(|(joint, value, limits)| {
        let message = format!(
            "joint \"{}\" stands at {value}, outside its limits {} to {}",
            mechanism.joint(joint).name(),
            limits.lower,
            limits.upper
        );
        DiagnosticRecord::about_answer(Severity::Warning, "outside-limits", message)
    }));
    diagnostics.extend(strike.remarks.iter().map(remark));
    if let Some(other) = question.against_mass {
        if strike.effective_mass == EffectiveMass::Immovable {
            let message =
                "the mechanism itself does not give way: only the other body's mass counts".to_owned();
            diagnostics.push(DiagnosticRecord::about_answer(Severity::Note, "immovable-mechanism", message));
        }
        strike = strike.against_mass(other);
    }
    Ok(report(model, &system, &pose, &strike, diagnostics, assumptions(&system, question)))
}

fn configuration(mechanism: &Arc<Mechanism>, set: &[(String, String)]) -> Result<Configuration, StudyError> {
    let mut configuration = Configuration::zero(mechanism);
    for (joint, text) in set {
        let kind = mechanism.joint(mechanism.find_joint(joint)?).kind();
        let values = parse_list(text, |i| position_dimension(kind, i))
            .map_err(|source| StudyError::Set { joint: joint.clone(), source })?;
        configuration.set(joint, &values)?;
    }
    Ok(configuration)
}

fn contact(system: &System, pose: &Pose, question: &MassQuestion) -> Result<Contact, StudyError> {
    let mechanism = system.mechanism();
    let link = mechanism.find_link(&question.link)?;
    let against = question.against.as_ref().map(|name| other_side(mechanism, name)).transpose()?.flatten();
    let point = Vector3::from(question.point);
    let normal = match &question.normal {
        Normal::Along(normal) => Direction::Along(Vector3::from(*normal), question.frame),
        Normal::Toward(name, point) => Direction::Toward(mechanism.find_link(name)?, Vector3::from(*point)),
    };
    Ok(Contact {
        link,
        against,
        point: system.point_in_link(pose, link, against, question.frame, point),
        normal,
    })
}

/// The link of this name; `world` is the ground where no link is called so.
fn other_side(mechanism: &Mechanism, name: &str) -> Result<Option<LinkId>, UnknownName> {
    match mechanism.find_link(name) {
        Ok(link) => Ok(Some(link)),
        Err(_) if name == "world" => Ok(None),
        Err(unknown) => Err(unknown),
    }
}

fn report(
    model: &Model,
    system: &System,
    pose: &Pose,
    strike: &Strike,
    diagnostics: Vec<DiagnosticRecord>,
    assumptions: Assumptions,
) -> MassReport {
    let mechanism = &model.mechanism;
    let link_name = |link: LinkId| mechanism.link(link).name().to_owned();
    let joint_name = |joint: JointId| mechanism.joint(joint).name().to_owned();
    let (effective_mass, status) = match strike.effective_mass {
        EffectiveMass::Finite(m) => (Some(m), Status::Finite),
        EffectiveMass::Immovable => (None, Status::Immovable),
        EffectiveMass::Massless => (None, Status::Massless),
    };
    let shares = strike.shares.as_ref();
    let share_of = |i: usize| shares.map(|s| s.links.get(i).copied().unwrap_or(0.0));
    let rotors = shares.map_or(&[][..], |s| &s.rotors[..]);
    let contact = &strike.contact;
    MassReport {
        schema: "percuss.mass/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: vec![model.input.clone()],
        effective_mass,
        status,
        singular_pose: false,
        degrees_of_freedom: strike.degrees_of_freedom,
        generic_degrees_of_freedom: system.degrees_of_freedom(),
        redundant_constraints: system.redundant_constraints(),
        rank_gap: None,
        route: match strike.route {
            Route::Dense => "dense",
            Route::Articulated => "articulated",
        },
        condition: strike.condition,
        effective_mass_error: strike.effective_mass_error,
        bodies: mechanism
            .link_ids()
            .map(|link| BodyShare { link: link_name(link), share: share_of(link.index()) })
            .collect(),
        rotors: rotors
            .iter()
            .map(|&(joint, share)| RotorShare { joint: joint_name(joint), share: Some(share) })
            .collect(),
        other_mass_share: shares.and_then(|s| s.other_mass),
        pose: pose_record(mechanism, pose),
        closure_residual: None,
        closure_inexactness: None,
        characteristic_length: mechanism.characteristic_length(),
        contact: ContactRecord {
            link: link_name(contact.link),
            against: contact.against.map(link_name),
            point_world: contact.point_world.into(),
            normal_world: contact.normal_world.into(),
            point_link: contact.point_link.into(),
            normal_link: contact.normal_link.into(),
        },
        diagnostics,
        assumptions,
    }
}

fn assumptions(system: &System, question: &MassQuestion) -> Assumptions {
    let mechanism = system.mechanism();
    let root = mechanism.link(mechanism.root()).name();
    let mut assumptions = Assumptions {
        base: match question.base {
            Base::Fixed => format!("fixed (root link \"{root}\" is the ground)"),
            Base::Floating => format!("floating (root link \"{root}\" moves freely)"),
        },
        set: question.set.iter().map(|(joint, _)| joint.clone()).collect(),
        ..Assumptions::default()
    };
    for id in mechanism.joint_ids() {
        let joint = mechanism.joint(id);
        let list = match joint.mimic() {
            _ if joint.kind().dofs() == 0 => continue,
            _ if system.is_locked(id) => &mut assumptions.locked,
            Some(_) => &mut assumptions.mimics,
            None => &mut assumptions.free,
        };
        list.push(joint.name().to_owned());
    }
    assumptions
}

/// Position of every movable joint.
pub(crate) fn pose_record(mechanism: &Mechanism, pose: &Pose) -> BTreeMap<String, Vec<f64>> {
    let movable = mechanism.joint_ids().filter(|id| mechanism.joint(*id).kind().dofs() > 0);
    movable.map(|id| (mechanism.joint(id).name().to_owned(), pose.joint(id).to_vec())).collect()
}

fn remark(remark: &Remark) -> DiagnosticRecord {
    let (severity, code, message) = match remark {
        Remark::NearlyImmovable { approach, uncertainty } => (
            Severity::Warning,
            "nearly-immovable",
            format!(
                "the gap hardly closes (closing speed {approach:.1e} of its terms): the mass is uncertain by \
                 {uncertainty:.1e} of itself"
            ),
        ),
        Remark::MasslessMotions { directions } => (
            Severity::Note,
            "massless-motions",
            format!("{directions} motion(s) of the mechanism carry no mass; they do not matter here"),
        ),
        Remark::UndeterminedMotion => (
            Severity::Note,
            "undetermined-motion",
            "a motion without mass leaves the velocities of the blow open; the mass and the shares are not"
                .into(),
        ),
        Remark::IndefiniteMassMatrix => (
            Severity::Warning,
            "indefinite-mass-matrix",
            "the mass matrix has negative directions: the value is stationary, not a minimum".into(),
        ),
        _ => (Severity::Note, "remark", format!("{remark:?}")),
    };
    DiagnosticRecord::about_answer(severity, code, message)
}
