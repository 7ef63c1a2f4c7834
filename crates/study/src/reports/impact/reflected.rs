//! Inertias reflected to joints, at a pose and over ranges of positions. They need no contact.

use crate::checks::finding::{Finding, FindingSubject};
use crate::checks::finding_kind::FindingKind;
use crate::checks::findings::{
    collect_pose_findings, condition_findings, guess_findings, point_mass_base_finding,
};
use crate::evaluation::joint_ranges::find_joint;
use crate::evaluation::prepared_question::{EvaluatedQuestion, compile, configuration};
use crate::evaluation::status::Status;
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::pose::pose_solver;
use crate::pose::positions::{PoseLayout, Positions};
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::mass_question::MassQuestion;
use crate::question::pose_file::GivenPose;
use crate::question::travel::vary::Vary;
use crate::reports::mass_report::ConditionsRecord;
use percuss_dynamics::{Configuration, EffectiveMass, Pose, System};
use percuss_impact::{
    MimicSubstitute, NoSubstitute, ReflectedRange, driving_joints_with, reflected_inertia_over_with,
    reflected_inertia_with,
};
use percuss_mechanism::{JointId, JointKind, Mechanism};
use percuss_units::Dimension;
use schemars::JsonSchema;
use serde::Serialize;

/// Inertia reflected to a joint.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ReflectedRecord {
    /// The joint.
    pub joint: String,
    /// Index of the velocity within the joint.
    pub component: usize,
    /// Label of a velocity of a joint with several velocities: `about x`, `along y`, `about the normal`; null for one velocity. x, y and z
    /// are the axes of the child link; for a planar joint, x and y are the two axes of the plane.
    pub direction: Option<&'static str>,
    /// Unit: `kg·m²` or `kg`.
    pub unit: &'static str,
    /// Inertia with all other joints free; null if not finite.
    pub free: Option<f64>,
    /// Kind of `free`.
    pub free_status: Status,
    /// Inertia with the other drivers at rest; null if not finite, and for a joint that is no driver.
    pub held: Option<f64>,
    /// Kind of `held`; null for a joint that is no driver.
    pub held_status: Option<Status>,
    /// The other drivers, which are at rest for `held`. Joints whose positions are given drive; the others are chosen automatically.
    pub other_drivers: Vec<String>,
}

/// Inertia reflected to a joint over a range of its positions.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ReflectedRangeRecord {
    /// The joint.
    pub joint: String,
    /// Unit: `kg·m²` or `kg`.
    pub unit: &'static str,
    /// Positions of the joint, rad or m.
    pub positions: Vec<f64>,
    /// Inertia with all other joints free at each position; null if not finite.
    pub free: Vec<Option<f64>>,
    /// Inertia with the other drivers at rest; null if not finite, and for a joint that is no driver.
    pub held: Vec<Option<f64>>,
    /// Smallest finite held inertia (free for a joint that is no driver); null if no inertia is finite.
    pub least: Option<f64>,
    /// Largest finite held inertia.
    pub most: Option<f64>,
    /// Constant armature that minimises the largest relative error: the harmonic mean of `least` and `most`; null unless the inertia is
    /// finite at all positions.
    pub best_constant: Option<f64>,
    /// Largest relative error of this constant; null without a constant.
    pub largest_error: Option<f64>,
    /// Substitute for simulators without loops: the open tree with mimic joints and an additional armature. Null if the joint is no driver,
    /// if an inertia is not finite, and if no other joint or a joint with several velocities moves with the joint.
    pub substitute: Option<MimicSubstituteRecord>,
    /// Joint with several velocities that moves with the joint: the reason for a missing substitute; null otherwise.
    pub substitute_refused_by: Option<String>,
}

/// Open tree of a linkage in which all dependent joints are mimic joints of the driving joint.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MimicSubstituteRecord {
    /// Mimic joints.
    pub joints: Vec<MimicJointRecord>,
    /// Inertia of this tree at the driving joint at each position, kg·m² or kg; without the additional armature.
    pub inertias: Vec<f64>,
    /// Armature in addition to the armature of the driving joint, kg·m² or kg: it minimises the largest relative error. Can be negative.
    pub armature: f64,
    /// Largest relative error of the reflected inertia over the range, with this armature.
    pub largest_error: f64,
}

/// Joint that follows the driving joint: position = multiplier · position of the driving joint + offset.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MimicJointRecord {
    /// The joint.
    pub joint: String,
    /// Ratio of the positions: least-squares fit over the range.
    pub multiplier: f64,
    /// Position at the zero of the driving joint, rad or m.
    pub offset: f64,
    /// Largest difference from the position in the linkage, rad or m.
    pub position_error: f64,
}

/// Reflected inertias without a contact, as JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ReflectedReport {
    /// `percuss.reflected/1`.
    #[schemars(extend("const" = "percuss.reflected/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files.
    pub inputs: Vec<Input>,
    /// Joint positions.
    pub pose: Positions,
    /// Conditions.
    pub conditions: ConditionsRecord,
    /// Driving joints: the drivers of the loops, and the joints outside loops.
    pub drivers: Vec<String>,
    /// Reflected inertias at the pose.
    pub reflected_inertia: Vec<ReflectedRecord>,
    /// Reflected inertias over ranges of positions.
    pub reflected_over: Vec<ReflectedRangeRecord>,
    /// Findings about the file and the result.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// Model at a pose.
pub(crate) struct PosedModel<'a> {
    model: &'a Model,
    question: &'a MassQuestion,
    system: &'a System,
    configuration: &'a Configuration,
    pose: &'a Pose,
}

impl<'a> From<&'a EvaluatedQuestion<'_>> for PosedModel<'a> {
    fn from(evaluated: &'a EvaluatedQuestion<'_>) -> Self {
        let prepared = &evaluated.prepared;
        Self {
            model: prepared.model,
            question: &prepared.question,
            system: &prepared.system,
            configuration: &prepared.configuration,
            pose: &evaluated.pose,
        }
    }
}

/// Inertias reflected to joints of a model, at the pose and under the conditions of a question. The contact of the question has no effect.
///
/// `joints`: `JOINT`, or `JOINT=FROM:TO:COUNT` for a range of positions.
///
/// # Errors
/// [`StudyError`]: unknown names, unreachable positions, invalid ranges.
pub fn reflected_inertias(
    model: &Model,
    question: &MassQuestion,
    joints: &[String],
) -> Result<ReflectedReport, StudyError> {
    let system = compile(&model.mechanism, question, None)?;
    let configuration = configuration(&model.mechanism, question)?;
    let pose = pose_solver::pose(&system, &configuration, question)?;
    let posed = PosedModel { model, question, system: &system, configuration: &configuration, pose: &pose };
    let (reflected_inertia, of_drivers) = reflected(&posed, joints)?;
    let (reflected_over, found) = reflected_over(&posed, joints)?;
    let found = of_drivers.into_iter().chain(found);
    let of_pose = collect_pose_findings(&system, &pose, question.names)
        .into_iter()
        .chain(condition_findings(&system, question))
        .chain(guess_findings(&system, &pose, &configuration, &question.pose.guess, question.names))
        .chain(point_mass_base_finding(&system))
        .chain(found);
    let mechanism = &model.mechanism;
    let name = |joint: JointId| mechanism.joint(joint).name().to_owned();
    Ok(ReflectedReport {
        schema: "percuss.reflected/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: model
            .inputs
            .iter()
            .chain(question.positions.iter().filter_map(GivenPose::file))
            .cloned()
            .collect(),
        pose: Positions::from_pose(&PoseLayout::new(mechanism), &pose),
        conditions: ConditionsRecord::of(question),
        drivers: driving_joints_with(&pose, &posed.set_joints()).into_iter().map(name).collect(),
        reflected_inertia,
        reflected_over,
        diagnostics: model.diagnostics.iter().cloned().chain(of_pose.map(DiagnosticRecord::from)).collect(),
    })
}

impl PosedModel<'_> {
    /// Joints whose positions are given: they drive.
    fn set_joints(&self) -> Vec<JointId> {
        let find = |(joint, _): &(String, _)| self.model.mechanism.find_joint(joint).ok();
        self.question.pose.set.iter().filter_map(find).collect()
    }
}

/// Reflected inertias of the requested joints, one record for each velocity, and warnings about joints that do not drive.
pub(crate) fn reflected(
    posed: &PosedModel,
    joints: &[String],
) -> Result<(Vec<ReflectedRecord>, Vec<Finding>), StudyError> {
    let mechanism = &posed.model.mechanism;
    let preferred = posed.set_joints();
    let drivers = driving_joints_with(posed.pose, &preferred);
    let (mut records, mut findings) = (Vec::new(), Vec::new());
    for name in joints.iter().filter(|name| range_of(mechanism, name).is_none()) {
        let joint = find_joint(mechanism, "impact.reflected", name)?;
        let columns = posed.pose.motion_subspace(joint);
        if columns.is_empty() {
            return Err(StudyError::input("impact.reflected", Fault::NoMotion { joint: name.clone() }));
        }
        for (component, column) in columns.iter().enumerate() {
            let found = reflected_inertia_with(posed.pose, joint, component, &preferred)
                .map_err(StudyError::about("impact.reflected"))?;
            let (free_status, free) = Status::classify(found.free);
            let held = found.held.map(Status::classify);
            records.push(ReflectedRecord {
                joint: name.clone(),
                component,
                direction: direction(mechanism.joint(joint).kind(), component),
                unit: if column.angular.norm() > 0.0 { "kg·m²" } else { "kg" },
                free,
                free_status,
                held: held.and_then(|(_, mass)| mass),
                held_status: held.map(|(status, _)| status),
                other_drivers: drivers
                    .iter()
                    .filter(|driver| **driver != joint)
                    .map(|driver| mechanism.joint(*driver).name().to_owned())
                    .collect(),
            });
        }
        let is_held = records.last().is_some_and(|record| record.held_status.is_some());
        if !is_held && !posed.pose.is_locked(joint) {
            let names: Vec<&str> = drivers.iter().map(|driver| mechanism.joint(*driver).name()).collect();
            let message = format!(
                "joint \"{name}\": no driving joint at this pose (driving joints: {}), so there is no inertia with the other drivers held; \
                 give its position{}",
                names.join(", "),
                posed.question.names.hint("pose.set")
            );
            findings.push(Finding::new(FindingKind::NoDriver, FindingSubject::Joint(joint), message));
        }
    }
    Ok((records, findings))
}

/// Label of a velocity of a joint with several velocities; `None` for one velocity.
fn direction(kind: JointKind, component: usize) -> Option<&'static str> {
    let directions: &[&str] = match kind {
        JointKind::Spherical => &["about x", "about y", "about z"],
        JointKind::Planar => &[
            "along the first direction of the plane",
            "along the second direction of the plane",
            "about the normal",
        ],
        JointKind::Floating => &["about x", "about y", "about z", "along x", "along y", "along z"],
        JointKind::Fixed | JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic => &[],
    };
    directions.get(component).copied()
}

/// Joint and range of a request `JOINT=FROM:TO:COUNT`; `None` for the name of a joint.
fn range_of<'t>(mechanism: &Mechanism, text: &'t str) -> Option<(&'t str, &'t str)> {
    if mechanism.find_joint(text).is_ok() { None } else { text.rsplit_once('=') }
}

/// Reflected inertias over the requested ranges of positions, and warnings about ranges outside the limits of their joints.
pub(crate) fn reflected_over(
    posed: &PosedModel,
    joints: &[String],
) -> Result<(Vec<ReflectedRangeRecord>, Vec<Finding>), StudyError> {
    let mechanism = &posed.model.mechanism;
    let refuse = |fault| StudyError::input("impact.reflected", fault);
    let (mut records, mut findings) = (Vec::new(), Vec::new());
    for text in joints {
        let Some((name, _)) = range_of(mechanism, text) else { continue };
        let joint = find_joint(mechanism, "impact.reflected", name)?;
        let kind = mechanism.joint(joint).kind();
        let range = Vary::parse(text);
        let range: Vary = range.map_err(|error| refuse(error.to_string().into()))?;
        let dimension = match kind {
            JointKind::Revolute | JointKind::Continuous => Dimension::Angle,
            JointKind::Prismatic => Dimension::Length,
            JointKind::Fixed => return Err(refuse(Fault::NoMotion { joint: name.to_owned() })),
            _ => return Err(refuse(Fault::NoSinglePosition { joint: name.to_owned(), kind })),
        };
        // A contact at the stop of this joint sets the position of the joint only for the impact, not for the range.
        let is_stop = posed.question.stop_of_joint(mechanism).is_some_and(|(stop, _)| stop == joint);
        if !is_stop && posed.question.pose.set.iter().any(|(set, _)| set == name) {
            return Err(refuse(Fault::VariedIsSet { joint: name.to_owned() }));
        }
        let values = range.values(dimension).map_err(|error| refuse(error.into()))?;
        let positions: Vec<f64> = (0..values.count).map(|row| values.value_at(row)).collect();
        findings.extend(outside_limits(mechanism, joint, &positions));
        let found = {
            let (system, configuration) = (posed.system, posed.configuration);
            reflected_inertia_over_with(system, configuration, joint, &positions, &posed.set_joints())
        }
        .map_err(StudyError::about("impact.reflected"))?;
        let unit = if dimension == Dimension::Angle { "kg·m²" } else { "kg" };
        records.push(range_record(mechanism, name, unit, positions, found));
    }
    Ok((records, findings))
}

/// Record of a range.
fn range_record(
    mechanism: &Mechanism,
    joint: &str,
    unit: &'static str,
    positions: Vec<f64>,
    found: ReflectedRange,
) -> ReflectedRangeRecord {
    let known = |mass: EffectiveMass| mass.kilograms();
    let name = |joint: JointId| mechanism.joint(joint).name().to_owned();
    let (substitute, refused_by) = match found.substitute {
        Ok(MimicSubstitute { joints, inertias, armature, largest_error }) => {
            let joints = joints.into_iter().map(|mimic| MimicJointRecord {
                joint: name(mimic.joint),
                multiplier: mimic.multiplier,
                offset: mimic.offset,
                position_error: mimic.position_error,
            });
            let joints = joints.collect();
            (Some(MimicSubstituteRecord { joints, inertias, armature, largest_error }), None)
        }
        Err(NoSubstitute::SeveralVelocities(joint)) => (None, Some(name(joint))),
        Err(NoSubstitute::NotHeld | NoSubstitute::NoDependentJoint) => (None, None),
    };
    ReflectedRangeRecord {
        joint: joint.to_owned(),
        unit,
        free: found.samples.iter().map(|s| known(s.inertia.free)).collect(),
        held: found.samples.iter().map(|s| s.inertia.held.and_then(known)).collect(),
        positions,
        least: found.least,
        most: found.most,
        best_constant: found.best_constant,
        largest_error: found.largest_error,
        substitute,
        substitute_refused_by: refused_by,
    }
}

/// Warning about a range outside the limits of its joint.
fn outside_limits(mechanism: &Mechanism, joint: JointId, positions: &[f64]) -> Option<Finding> {
    let declared = mechanism.joint(joint);
    let limits = declared.limits()?;
    let outside = positions.iter().filter(|position| Pose::is_outside(**position, limits)).count();
    (outside > 0).then(|| {
        let message = format!(
            "joint \"{}\": {outside} of the {} positions of the range are outside the limits {} to {} of the joint",
            declared.name(),
            positions.len(),
            limits.lower,
            limits.upper
        );
        Finding::new(FindingKind::OutsideLimits, FindingSubject::Joint(joint), message)
    })
}
