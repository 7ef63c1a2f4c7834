//! Safe speed of a robot that may hit a person, with the effective mass instead of the standard's M/2 + m_L.

use super::proved::{ProvedSpeedRecord, proved_along, proved_speed};
use super::speed::{SpeedRecord, mass_unknown, safe_speed_record};
use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::evaluation::named_contact::named_contact;
use crate::evaluation::passed_stops::answer_findings;
use crate::evaluation::prepared_question::{ContactResult, EvaluatedQuestion, PreparedQuestion};
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::pose::positions::Positions;
use crate::question::errors::question_error::{StudyError, branch_limits_text};
use crate::question::mass_question::MassQuestion;
use crate::question::row_source::RowSource;
use crate::question::tables::safe_speed::{Limit, SafeSpeedQuestion};
use crate::reports::assumptions::lacks_rotors;
use crate::sweep::sweep_rows::Sweep;
use percuss_contact::{BodyRegion, ContactLawError, LawParameter, standard_robot_mass};
use percuss_dynamics::{Base, EffectiveMass, Frame};
use percuss_impact::reachable_closing_speed;
use percuss_mechanism::{Inertial, JointDescription, JointId, JointKind, LinkDescription, LinkId, Mechanism};
use schemars::JsonSchema;
use serde::Serialize;
use std::ops::ControlFlow;

/// Report of `percuss safe-speed`, as JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct SafeSpeedReport {
    /// True for a robot arm without any rotor inertia, for text.
    #[serde(skip)]
    pub lacks_rotors: bool,
    /// `percuss.safe-speed/2`.
    #[schemars(extend("const" = "percuss.safe-speed/2"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files.
    pub inputs: Vec<Input>,
    /// Body region; null for a body that cannot move.
    pub region: Option<String>,
    /// Effective mass of the region, kg.
    pub region_mass: Option<f64>,
    /// Stiffness of the region, N/m.
    pub region_stiffness: Option<f64>,
    /// Note about uncertain values of the region.
    pub region_note: Option<String>,
    /// Limited quantity: `force`, `pressure`, `energy` or `momentum`.
    pub limited_by: &'static str,
    /// Largest force, N, at the speed for the standard's mass; null without a region.
    pub force: Option<f64>,
    /// Energy of the impact, J, at the speed for the standard's mass.
    pub energy: f64,
    /// Speed for the standard's mass M/2 + m_L; without a region for the full moving mass, M + m_L.
    pub standard: SpeedRecord,
    /// Speed for the effective mass at the contact.
    pub reflected: SpeedRecord,
    /// Greatest closing speed within the rate limits of the joints (`velocity` in URDF); null if no motion closes the gap, or if a motion
    /// without limited joints closes the gap.
    pub reachable: Option<ReachableSpeedRecord>,
    /// Contact normal, out of the robot, world axes.
    pub normal_world: [f64; 3],
    /// M: mass of all links that can move, kg.
    pub moving_mass: f64,
    /// m_L: load, kg.
    pub load: f64,
    /// Speed that is proved for all positions in the ranges; null without a proof.
    pub proved: Option<ProvedSpeedRecord>,
    /// Slowest row, if there are rows of positions.
    pub along: Option<AlongRecord>,
    /// Findings.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// Greatest closing speed within the rate limits of the joints.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ReachableSpeedRecord {
    /// Closing speed at the pose, m/s.
    pub speed: f64,
    /// Joints whose rate limits determine this speed.
    pub limited_by: Vec<String>,
}

/// Slowest row of a list of positions.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct AlongRecord {
    /// Number of rows.
    pub rows: usize,
    /// Number of rows without a speed: unreachable poses, singular poses, contacts without an upper bound of
    /// m̄.
    pub unanswered: usize,
    /// First row without a speed.
    pub first_unanswered: Option<usize>,
    /// Row with the smallest speed, from 0.
    pub row: usize,
    /// Speed in this row.
    pub slowest: SpeedRecord,
    /// Joint positions in this row.
    pub pose: Positions,
}

/// Safe speed of a contact of a robot at its pose.
fn safe_speed(
    model: &Model,
    question: &MassQuestion,
    asked: &SafeSpeedQuestion,
) -> Result<SafeSpeedReport, StudyError> {
    let region = asked.region.as_deref().map(BodyRegion::from_name).transpose()?;
    let limit = asked.only_limit()?;
    if region.is_none() && matches!(limit, Limit::Force(_) | Limit::Pressure(..)) {
        return Err(StudyError::NoRegion);
    }
    let question = &*question.resolve_contact(&model.mechanism)?;
    question.refuse_moment("safe speed")?;
    if question.contact.against.is_some() || question.contact.against_mass.is_some() {
        return Err(StudyError::PersonIsOtherSide);
    }
    let bare = EvaluatedQuestion::new(model, question)?;
    let moving_mass = moving_mass(&bare);
    let loaded = if asked.load() > 0.0 { Some(model_with_load(&bare, asked.load())?) } else { None };
    let evaluated = loaded.as_ref().map_or(Ok(bare), |model| EvaluatedQuestion::new(model, question))?;
    let speed = |robot_mass: Option<f64>| safe_speed_record(region, limit, robot_mass);
    let by_standard = standard_robot_mass(moving_mass, asked.load())?;
    // Without a region the standard has no formula; the full moving mass at the speed of the contact is used.
    let by_standard = if region.is_some() { by_standard } else { moving_mass + asked.load() };
    let (standard, safe) = speed(Some(by_standard))?;
    let mut diagnostics = model.diagnostics.clone();
    let of_answer = answer_findings(&evaluated, named_contact(&evaluated)?.as_ref());
    diagnostics.extend(of_answer.into_iter().map(DiagnosticRecord::from));
    let (reflected, _) = match largest_possible_mass(&evaluated.result)? {
        EffectiveMass::Finite(m) => speed(Some(m))?,
        EffectiveMass::Immovable => {
            let message = "the robot is immovable along this direction: only the mass of the person counts";
            diagnostics.push(Finding::about_result(FindingKind::ImmovableRobot, message).into());
            speed(None)?
        }
        EffectiveMass::Massless => return Err(StudyError::NoMass),
    };
    if reflected.speed < standard.speed {
        let message = format!(
            "the standard's mass allows {:.3} m/s, the effective mass only {:.3} m/s: the mass {} is too small here",
            standard.speed,
            reflected.speed,
            if region.is_some() { "M/2 + m_L" } else { "M + m_L" }
        );
        diagnostics.push(Finding::about_result(FindingKind::StandardTooFast, message).into());
    }
    Ok(SafeSpeedReport {
        lacks_rotors: lacks_rotors(&evaluated.prepared),
        schema: "percuss.safe-speed/2",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: evaluated.prepared.inputs(),
        region: region.map(|region| region.name.to_owned()),
        region_mass: region.map(|region| region.mass),
        region_stiffness: region.map(|region| region.stiffness),
        region_note: region.and_then(|region| region.note.map(str::to_owned)),
        limited_by: match limit {
            Limit::Force(_) => "force",
            Limit::Pressure(..) => "pressure",
            Limit::Energy(_) => "energy",
            Limit::Momentum(_) => "momentum",
        },
        force: safe.map(|safe| safe.force).filter(|force| force.is_finite()),
        energy: safe.map_or(0.0, |safe| safe.energy),
        standard,
        reflected,
        reachable: reachable(&evaluated),
        normal_world: evaluated.result.response.contact.normal_world.into(),
        moving_mass,
        load: asked.load(),
        proved: match asked.rows() {
            None if asked.certify.is_some() => Some(proved_speed(&evaluated, asked, by_standard, &speed)?),
            _ => None,
        },
        along: None,
        diagnostics,
    })
}

/// Greatest closing speed within the rate limits of the joints.
fn reachable(evaluated: &EvaluatedQuestion) -> Option<ReachableSpeedRecord> {
    let mechanism = &evaluated.prepared.model.mechanism;
    let found = reachable_closing_speed(&evaluated.pose, &evaluated.result.response.contact)?;
    let name = |joint| mechanism.joint(joint).name().to_owned();
    Some(ReachableSpeedRecord {
        speed: found.speed,
        limited_by: found.limited_by.into_iter().map(name).collect(),
    })
}

/// Safe speeds: one in each direction of the question, the worst direction last; without directions that of the contact, at its pose or
/// at the slowest row of positions.
///
/// The worst direction is the direction with the largest effective mass at the point, one of the axes with
/// stationary m̄ (docs/reference/FORMULAS.md, F36).
///
/// # Errors
/// [`StudyError`], as for `mass` and for a sweep; not exactly one limit, limits out of range, an unknown region, a massless contact, a mass
/// without an upper bound; no row with a speed.
pub fn safe_speeds(
    model: &Model,
    question: &MassQuestion,
    asked: &SafeSpeedQuestion,
) -> Result<Vec<SafeSpeedReport>, StudyError> {
    asked.check()?;
    if !asked.has_directions() {
        return Ok(vec![match asked.rows() {
            None => safe_speed(model, question, asked)?,
            Some(rows) => safe_speed_along(model, question, asked, &rows)?,
        }]);
    }
    let question = &*question.resolve_contact(&model.mechanism)?;
    question.refuse_moment("safe speed")?;
    let mut all: Vec<[f64; 3]> = asked.direction.iter().map(|direction| direction.0).collect();
    if asked.worst_direction {
        all.push(worst_direction(model, question)?);
    }
    let of_direction = |direction: &[f64; 3]| {
        let contact = question.contact.with_normal(*direction, Frame::World);
        let question = MassQuestion { contact, ..question.clone() };
        let of_field = |field| if field == "contact.normal" { "safe_speed.direction" } else { field };
        safe_speed(model, &question, asked).map_err(|error| error.with_field(of_field))
    };
    all.iter().map(of_direction).collect()
}

/// Safe speed over rows of positions: the slowest row. The rest of the report refers to the question's own
/// pose. The mass of a row is m̄ plus its error bound.
fn safe_speed_along(
    model: &Model,
    question: &MassQuestion,
    asked: &SafeSpeedQuestion,
    source: &RowSource,
) -> Result<SafeSpeedReport, StudyError> {
    let mut report = safe_speed(model, question, asked)?;
    let limit = asked.only_limit()?;
    let region = asked.region.as_deref().map(BodyRegion::from_name).transpose()?;
    let bare = EvaluatedQuestion::new(model, question)?;
    let loaded = if asked.load() > 0.0 { Some(model_with_load(&bare, asked.load())?) } else { None };
    let (mut slowest, mut failed): (Option<AlongRecord>, _) = (None, None);
    let (mut unanswered, mut first_unanswered) = (0, None);
    let loaded_model = loaded.as_ref().unwrap_or(model);
    let sweep = Sweep::new(loaded_model, question, source)?;
    let inputs = sweep.heading().inputs.clone();
    let of_column = |name: &str| loaded_model.mechanism.find_joint(name).ok();
    let columns = sweep.heading().varied.iter().filter_map(|column| of_column(column.joint.as_deref()?));
    let mut joints: Vec<JointId> = columns.collect();
    joints.dedup();
    let mut varied = sweep.heading().varied.iter();
    if asked.certify.is_some() && !varied.all(|column| column.joint.as_deref() == Some(column.name.as_str()))
    {
        let why = "a proof covers rows of joints with one position; expected no travel and no joint with several numbers";
        return Err(StudyError::input("safe_speed.input", why));
    }
    let mut rows: Vec<Vec<f64>> = Vec::new();
    let end = sweep.run(&mut |row| {
        if asked.certify.is_some() {
            let position =
                |joint: &JointId| row.pose.get(loaded_model.mechanism.joint(*joint).name())?.first().copied();
            rows.extend(joints.iter().map(position).collect::<Option<Vec<f64>>>());
        }
        let mass = match (row.status, row.effective_mass.zip(row.effective_mass_error)) {
            ("finite", Some((m, error))) if row.singular_pose == Some(false) => Some(m + error),
            ("immovable", _) if row.singular_pose == Some(false) => None,
            _ => {
                unanswered += 1;
                first_unanswered.get_or_insert(row.row);
                return ControlFlow::Continue(());
            }
        };
        match safe_speed_record(region, limit, mass) {
            Ok((speed, _)) if slowest.as_ref().is_none_or(|s| speed.speed < s.slowest.speed) => {
                let (row, pose) = (row.row, row.pose);
                let (rows, unanswered, first_unanswered) = (0, 0, None);
                slowest = Some(AlongRecord { rows, unanswered, first_unanswered, row, slowest: speed, pose });
            }
            Ok(_) => {}
            Err(error) => {
                failed = Some(error);
                return ControlFlow::Break(());
            }
        }
        ControlFlow::Continue(())
    })?;
    if let Some(error) = failed {
        return Err(error.into());
    }
    let slowest = slowest.ok_or_else(mass_unknown)?;
    if asked.certify.is_some() {
        if rows.len() < end.rows || rows.is_empty() {
            let why = "some rows have no pose, and the proof covers all rows; expected reachable rows";
            return Err(StudyError::input("safe_speed.input", why));
        }
        let question = &*question.resolve_contact(&model.mechanism)?;
        let evaluated = EvaluatedQuestion::new(loaded_model, question)?;
        let by_standard = report.standard.robot_mass.unwrap_or(f64::INFINITY);
        let speed = |mass: Option<f64>| safe_speed_record(region, limit, mass);
        report.proved = Some(proved_along(&evaluated, asked, (&joints, &rows), by_standard, &speed)?);
    }
    report.along = Some(AlongRecord { rows: end.rows, unanswered, first_unanswered, ..slowest });
    report.inputs = inputs;
    report.diagnostics.extend(end.diagnostics);
    if unanswered > 0 {
        let message = format!(
            "{unanswered} of {} rows have no speed, the first is row {}: the result does not cover them",
            end.rows,
            first_unanswered.unwrap_or_default()
        );
        report.diagnostics.push(Finding::about_result(FindingKind::RowsWithoutSpeed, message).into());
    }
    Ok(report)
}

/// Direction of the largest effective mass at the contact point, world axes.
fn worst_direction(model: &Model, question: &MassQuestion) -> Result<[f64; 3], StudyError> {
    let contact = question.contact.with_normal([1.0, 0.0, 0.0], question.contact.normal_frame());
    let any = MassQuestion { contact, ..question.clone() };
    let prepared = PreparedQuestion::new(model, &any)?;
    let pose = prepared.pose()?;
    let contact = prepared.contact_at(&pose);
    let map = pose.contact_map(contact.link, contact.against, contact.point, 0.0);
    let map = map.map_err(StudyError::about("contact.point"))?;
    let weight = |mass: &EffectiveMass| match mass {
        EffectiveMass::Finite(m) => *m,
        EffectiveMass::Immovable => f64::INFINITY,
        EffectiveMass::Massless => 0.0,
    };
    let principal = map.principal_masses(&contact.point);
    let greatest = principal.iter().flatten().max_by(|a, b| weight(&a.mass).total_cmp(&weight(&b.mass)));
    let greatest = greatest.ok_or_else(mass_unknown)?;
    Ok(pose.link(contact.link).vector(&greatest.direction).into())
}

/// Upper bound of the mass in the motions from the pose; a smaller mass would allow too high a speed. At a
/// singular pose m̄ is only a lower bound, so the result is the largest limit along the branches.
fn largest_possible_mass(answer: &ContactResult) -> Result<EffectiveMass, StudyError> {
    let response = &answer.response;
    if response.singular_pose {
        let limits = &answer.limits;
        let weight = |mass: &EffectiveMass| match mass {
            EffectiveMass::Finite(m) => *m,
            EffectiveMass::Immovable => f64::INFINITY,
            EffectiveMass::Massless => 0.0,
        };
        let greatest = answer
            .complete_branch_limits()
            .and_then(|all| all.iter().max_by(|a, b| weight(a).total_cmp(&weight(b))));
        return greatest.copied().ok_or_else(|| {
            StudyError::NoResult(format!(
                "the pose is singular and the largest effective mass of the robot is unknown: {}; the effective mass is a lower bound, \
                 which would permit too high a speed; use poses near this one",
                branch_limits_text(&limits.limits, limits.complete && !limits.continuous)
            ))
        });
    }
    match (response.effective_mass, response.effective_mass_error()) {
        (EffectiveMass::Finite(m), Some(error)) => Ok(EffectiveMass::Finite(m + error)),
        (EffectiveMass::Finite(_), None) => Err(mass_unknown()),
        (mass @ (EffectiveMass::Immovable | EffectiveMass::Massless), _) => Ok(mass),
    }
}

/// Model with the load as a point mass at the contact, fixed to the contact link.
fn model_with_load(bare: &EvaluatedQuestion, load: f64) -> Result<Model, StudyError> {
    let model = bare.prepared.model;
    let mechanism = &model.mechanism;
    let at = bare.contact.point;
    let name = (0..).map(|i| format!("load{i}")).find(|name| mechanism.find_link(name).is_err());
    let name = name.unwrap_or_default();
    let contact_link = mechanism.link(bare.contact.link).name();
    let builder =
        mechanism.to_builder().link(LinkDescription::new(&name, Inertial::point(load, at.into()))).joint(
            JointDescription::new(format!("{name} on {contact_link}"), JointKind::Fixed, contact_link, &name),
        );
    let built = builder.build().map_err(|_| ContactLawError::OutOfRange {
        what: LawParameter::Load,
        got: load,
        valid: "a finite number, 0 or above",
    })?;
    Ok(Model { mechanism: built.mechanism.into(), ..model.clone() })
}

/// Mass of the links that can move: all links with a movable, unlocked joint between the link and the root, or
/// all links with a floating base.
fn moving_mass(evaluated: &EvaluatedQuestion) -> f64 {
    let prepared = &evaluated.prepared;
    let mechanism: &Mechanism = &prepared.model.mechanism;
    let moves = |link: &LinkId| {
        let above = std::iter::successors(mechanism.parent_joint(*link), |joint| {
            mechanism.parent_joint(mechanism.joint(*joint).parent())
        });
        let floats = prepared.question.conditions.base() == Base::Floating;
        floats
            || above
                .into_iter()
                .any(|joint| mechanism.joint(joint).kind().dofs() > 0 && !prepared.system.is_locked(joint))
    };
    let mass = |link: LinkId| mechanism.link(link).inertial().map_or(0.0, |i| i.mass);
    mechanism.link_ids().filter(moves).map(mass).sum()
}
