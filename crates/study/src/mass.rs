//! The answer to one contact of a model.

use crate::damped_contact::damping_of;
use crate::damping::{DampingQuestion, DampingReport};
use crate::estimate::{EstimateRecord, estimate};
use crate::model::Input;
use crate::question::{MassQuestion, StudyError};
use crate::{DiagnosticRecord, Model, findings};
use percuss_dynamics::{
    Base, BranchLimits, Contact, EffectiveMass, Pose, Route, RouteChoice, Strike, System,
};
use percuss_mechanism::{JointId, LinkId, Mechanism, Severity};
use serde::Serialize;
use std::collections::BTreeMap;

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

impl Status {
    /// As it stands in JSON and CSV.
    pub fn name(self) -> &'static str {
        match self {
            Status::Finite => "finite",
            Status::Immovable => "immovable",
            Status::Massless => "massless",
        }
    }
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
    /// Joints that drive loops.
    pub drivers: Vec<String>,
}

/// What an answer was asked under, so that it can be asked again.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct ConditionsRecord {
    /// `fixed` or `floating`.
    pub base: &'static str,
    /// Joints held by the question.
    pub lock: Vec<String>,
    /// Points held by the question.
    pub hold: Vec<HoldRecord>,
    /// Armatures that replace those of the model.
    pub armature: BTreeMap<String, Vec<f64>>,
    /// Mass of a free body on the other side, kg.
    pub against_mass: Option<f64>,
    /// Where joints were looked for, as typed.
    pub guess: BTreeMap<String, String>,
}

/// A held point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct HoldRecord {
    /// The link.
    pub link: String,
    /// The point in the link's frame, m.
    pub point: [f64; 3],
    /// The normal in world axes; null holds three directions.
    pub normal: Option<[f64; 3]>,
}

impl ConditionsRecord {
    fn of(question: &MassQuestion) -> Self {
        let hold = |h: &crate::Hold| HoldRecord { link: h.link.clone(), point: h.point, normal: h.normal };
        Self {
            base: match question.base {
                Base::Fixed => "fixed",
                Base::Floating => "floating",
            },
            lock: question.lock.clone(),
            hold: question.hold.iter().map(hold).collect(),
            armature: question.armature.iter().cloned().collect(),
            against_mass: question.against_mass,
            guess: question.guess.iter().cloned().collect(),
        }
    }
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
    /// What the answer was asked under.
    pub conditions: ConditionsRecord,
    /// Joints that drive the loops.
    pub drivers: Vec<String>,
    /// For each group of loops, which of the ways to put it together this is: 1, -1, or 0 at a dead centre or a change
    /// point.
    pub assembly_modes: Vec<i8>,
    /// Loops and couplings on which redundant rows lie, those that cannot be told apart together.
    pub redundant_loops: Vec<Vec<String>>,
    /// At a singular pose, the limits of m̄ along the branches that cross, kg; null for one along which the gap does not
    /// close.
    pub branch_limits: Vec<Option<f64>>,
    /// The classical estimate, where it was asked for.
    pub estimate: Option<EstimateRecord>,
    /// The damper that gives the contact a restitution, where one was asked for.
    pub damper: Option<DampingReport>,
    /// What was found, in the file and in the answer.
    pub diagnostics: Vec<DiagnosticRecord>,
    /// What the answer takes for granted.
    #[serde(skip)]
    pub assumptions: Assumptions,
}

/// A contact that is answered, with what the answer stands on.
pub(crate) struct Answered {
    pub system: System,
    pub pose: Pose,
    pub contact: Contact,
    pub strike: Strike,
    pub report: MassReport,
}

/// Answers one contact of a model.
///
/// # Errors
/// [`StudyError`]: names that nothing bears, positions that cannot be reached, a contact that means nothing.
pub fn mass(model: &Model, question: &MassQuestion) -> Result<MassReport, StudyError> {
    Ok(Answered::new(model, question)?.report)
}

/// Answers one contact of a model, with the damper that gives it a restitution; none where its mass is not finite.
///
/// # Errors
/// [`StudyError`], as for [`mass()`]; a restitution or a stiffness out of range.
pub fn mass_with_damper(
    model: &Model,
    question: &MassQuestion,
    damping: &DampingQuestion,
) -> Result<MassReport, StudyError> {
    let answered = Answered::new(model, question)?;
    match damping_of(model, question, damping, &answered) {
        Ok(mut damper) => {
            let mut report = answered.report;
            report.diagnostics = std::mem::take(&mut damper.diagnostics);
            report.damper = Some(damper);
            Ok(report)
        }
        Err(error @ StudyError::NoDamper { .. }) => {
            let mut report = answered.report;
            let note = DiagnosticRecord::about_answer(Severity::Warning, "no-damper", error.to_string());
            report.diagnostics.push(note);
            Ok(report)
        }
        Err(error) => Err(error),
    }
}

impl Answered {
    /// Answers a question.
    pub fn new(model: &Model, question: &MassQuestion) -> Result<Self, StudyError> {
        let system = question.system(&model.mechanism)?;
        let wanted = question.configuration(&model.mechanism)?;
        let pose = system.pose(&wanted)?;
        let contact = question.contact(&system, &pose)?;
        let mut strike = system.strike(&pose, &contact, RouteChoice::Auto)?;
        let beside = question.estimate.as_ref();
        let estimate = beside.map(|e| estimate(&system, &pose, &strike, e)).transpose()?;
        let mut diagnostics = model.diagnostics.clone();
        diagnostics.extend(findings::about_pose(&system, &pose));
        diagnostics.extend(findings::about_guesses(&system, &pose, &wanted));
        let limits = if strike.singular_pose {
            system.branch_limits(&pose, &contact)
        } else {
            BranchLimits::default()
        };
        diagnostics.extend(findings::about_strike(&system, &contact, &strike));
        diagnostics.extend(findings::about_branches(&system, &pose, &strike, &limits));
        diagnostics.extend(findings::about_holds(model, question, &pose, &contact)?);
        if let Some(other) = question.against_mass {
            if strike.effective_mass == EffectiveMass::Immovable {
                let message =
                    "the mechanism itself does not give way: only the other body's mass counts".to_owned();
                diagnostics.push(DiagnosticRecord::about_answer(
                    Severity::Note,
                    "immovable-mechanism",
                    message,
                ));
            }
            strike = strike.against_mass(other);
        }
        let assumptions = assumptions(&system, &pose, question);
        let mut report = report(model, &system, &pose, &strike, diagnostics, assumptions);
        report.conditions = ConditionsRecord::of(question);
        report.estimate = estimate;
        report.branch_limits = limits.limits.iter().map(|l| limit(*l, question.against_mass)).collect();
        Ok(Self { system, pose, contact, strike, report })
    }
}

/// A limit of m̄, kg; none for one along which the gap does not close.
fn limit(limit: EffectiveMass, against: Option<f64>) -> Option<f64> {
    match (limit, against) {
        (EffectiveMass::Finite(m), Some(other)) => Some(m / (1.0 + m / other)),
        (EffectiveMass::Immovable, other) => other,
        (EffectiveMass::Finite(m), None) => Some(m),
        (EffectiveMass::Massless, _) => Some(0.0),
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
        inputs: model.inputs.clone(),
        effective_mass,
        status,
        singular_pose: strike.singular_pose,
        degrees_of_freedom: strike.degrees_of_freedom,
        generic_degrees_of_freedom: system.degrees_of_freedom(),
        redundant_constraints: system.redundant_constraints(),
        rank_gap: system.rank_gap(),
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
        closure_residual: pose.loops().map(|l| l.residual),
        closure_inexactness: pose.loops().map(|l| l.inexactness),
        characteristic_length: mechanism.characteristic_length(),
        contact: ContactRecord {
            link: link_name(contact.link),
            against: contact.against.map(link_name),
            point_world: contact.point_world.into(),
            normal_world: contact.normal_world.into(),
            point_link: contact.point_link.into(),
            normal_link: contact.normal_link.into(),
        },
        conditions: ConditionsRecord::default(),
        drivers: assumptions.drivers.clone(),
        assembly_modes: pose.loops().map_or_else(Vec::new, |l| l.modes.clone()),
        redundant_loops: system.redundant_loops().to_vec(),
        branch_limits: Vec::new(),
        estimate: None,
        damper: None,
        diagnostics,
        assumptions,
    }
}

fn assumptions(system: &System, pose: &Pose, question: &MassQuestion) -> Assumptions {
    let mechanism = system.mechanism();
    let root = mechanism.link(mechanism.root()).name();
    let mut assumptions = Assumptions {
        base: match question.base {
            Base::Fixed => format!("fixed (root link \"{root}\" is the ground)"),
            Base::Floating => format!("floating (root link \"{root}\" moves freely)"),
        },
        set: question.set.iter().map(|(joint, _)| joint.clone()).collect(),
        drivers: pose.loops().map_or_else(Vec::new, |l| {
            l.drivers.iter().map(|id| mechanism.joint(*id).name().to_owned()).collect()
        }),
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
