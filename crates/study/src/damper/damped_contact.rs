//! Damper of a contact of a model: effective mass, drift over the penetration, and simulator options derived
//! from the model.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::curvature::motion_curvature;
use crate::damper::damping::{
    DamperRecord, DampingReport, Drift, beyond_curve, compare_with_body_mass, contact, contact_damper,
    damper, exports, impact_over_stroke, law_mismatch_diagnostic, require_stiffness,
};
use crate::damper::penetration::{PenetrationEnd, PenetrationPath};
use crate::damper::sheet_forces::{springs_finding, with_sheet_curve};
use crate::evaluation::named_contact::{NamedContactRecord, named_contact};
use crate::evaluation::passed_stops::answer_findings;
use crate::evaluation::prepared_question::{ContactResult, EvaluatedQuestion};
use crate::evaluation::status::{Status, mass_unit};
use crate::model::loading::Model;
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::{StudyError, branch_limits_text};
use crate::question::mass_question::MassQuestion;
use crate::question::names::Names;
use crate::question::spelled_contact::JointStop;
use crate::question::tables::damping::DampingQuestion;
use crate::thresholds::{BEFORE_END, DIFFERENCE, MUJOCO_MINVAL, SAME_LIMIT, STROKES, WARNED_MASS_DRIFT};
use percuss_contact::VaryingMassImpact;
use percuss_contact::exports::{MassDrift, Options};
use percuss_dynamics::{Conditions, Contact, EffectiveMass, System};
use percuss_mechanism::{LinkId, Mechanism};
use percuss_spatial::Vector3;

/// Damper of a contact of a model. A contact in the form `JOINT:lower` or `JOINT:upper` is the stop of the joint, as in [`damp_stop`].
///
/// # Errors
/// [`StudyError`], as for `mass` and `damp`; a contact without a finite mass, or with different masses on
/// different branches.
pub fn damp_contact(
    model: &Model,
    question: &MassQuestion,
    damping: &DampingQuestion,
) -> Result<DampingReport, StudyError> {
    if let Some((stop, conditions)) = JointStop::of_question(question, &model.mechanism) {
        return damp_stop(model, &stop, conditions, damping);
    }
    let mut report = damping_report(&EvaluatedQuestion::new(model, question)?, damping)?;
    report.diagnostics.extend(always_touching(report.named_contact.as_ref()).map(DiagnosticRecord::from));
    Ok(report)
}

/// Finding about a contact whose parts always touch, such as the seat of a spring.
fn always_touching(contact: Option<&NamedContactRecord>) -> Option<Finding> {
    let NamedContactRecord { name, kind, .. } = contact.filter(|contact| contact.always_touches())?;
    let message = format!(
        "{name} is a {kind}, whose parts always touch: the result is the damper of an impact at its seat, not a damper of the suspension"
    );
    Some(Finding::about_result(FindingKind::AlwaysTouching, message))
}

/// Damper of a joint stop. `conditions` supplies the pose and the held parts; its contact is ignored.
///
/// # Errors
/// [`StudyError`], as for [`damp_contact`]; a joint without a stop.
pub fn damp_stop(
    model: &Model,
    stop: &JointStop,
    conditions: MassQuestion,
    damping: &DampingQuestion,
) -> Result<DampingReport, StudyError> {
    let (question, record) = stop.question(model, conditions)?;
    let mut damping = damping.clone();
    damping.options.stop = Some(record.motion);
    let mut report = damping_report(&EvaluatedQuestion::new(model, &question)?, &damping)?;
    report.stop = Some(record);
    // The mass of the child link alone has no meaning for a joint stop.
    report.body_alone = None;
    Ok(report)
}

/// Damper of an evaluated contact.
pub(crate) fn damping_report(
    evaluated: &EvaluatedQuestion,
    damping: &DampingQuestion,
) -> Result<DampingReport, StudyError> {
    damping.refuse_limit()?;
    damping.refuse_unread()?;
    let (damping, of_curve) = with_sheet_curve(evaluated, damping)?;
    let damping = &damping;
    require_stiffness(damping)?;
    let EvaluatedQuestion { prepared, result: answer, .. } = evaluated;
    let effective_mass = mass_for_all_branches(answer, prepared.other_mass())?;
    let EffectiveMass::Finite(mass) = effective_mass else {
        let (status, _) = Status::classify(effective_mass);
        return Err(StudyError::NoDamper(no_damper(status)));
    };
    let record = damper(damping, mass)?;
    let (drift, ended) = drift(evaluated, mass, record.max_penetration);
    let over_stroke = over_stroke(evaluated, damping, &record, ended.as_ref());
    let given = damping.export_options();
    let mut options = options(given, evaluated, mass);
    let changes = drift.over_penetration.zip(record.max_penetration.filter(|x| *x > 0.0));
    options.drift =
        options.drift.or(changes.map(|(relative, penetration)| MassDrift { relative, penetration }));
    let is_moment = answer.response.contact.is_moment;
    let alone = given.own_mass.or(prepared.system.rigid_body_mass(evaluated.contact.link));
    // The mass of the link alone is not comparable with an inertia.
    let alone = alone.filter(|mass| *mass > 0.0 && !is_moment);
    let body_alone = alone.map(|m| compare_with_body_mass(damping, m, mass));
    let mut diagnostics = prepared.model.diagnostics.clone();
    let named_contact = named_contact(evaluated)?;
    let of_answer = answer_findings(evaluated, named_contact.as_ref());
    diagnostics.extend(of_answer.into_iter().map(DiagnosticRecord::from));
    diagnostics.extend(of_curve.map(DiagnosticRecord::from));
    diagnostics.extend(law_mismatch_diagnostic(damping));
    diagnostics.extend(beyond_curve(damping.stiffness_curve.as_ref(), record.max_penetration));
    if let Some((speed, duration)) = damping.speed().zip(record.contact_duration) {
        let compliant = contact(damping, mass)?;
        let law = (compliant, contact_damper(damping, compliant)?);
        let alone = (duration, record.achieved_restitution);
        diagnostics.extend(springs_finding(evaluated, law, speed, alone)?.map(DiagnosticRecord::from));
    }
    let unit = if is_moment { "mrad" } else { "mm" };
    let reached = ended.zip(record.max_penetration);
    let consequence = match over_stroke {
        Some(_) => {
            "the damper is designed for the mass at the touch: the report also has the result with varying mass"
        }
        None => "the damper is designed for the mass at the touch: no result with varying mass is known",
    };
    diagnostics.extend(drift_diagnostic(&drift, reached, consequence, unit, prepared.question.names));
    Ok(DampingReport {
        schema: "percuss.damp/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: prepared.inputs(),
        effective_mass: mass,
        unit: mass_unit(is_moment),
        is_moment,
        named_contact,
        stop: None,
        damper: record,
        drift: Some(drift),
        over_stroke,
        body_alone,
        exports: exports(damping, mass, options, is_moment)?,
        diagnostics,
        question: damping.clone(),
    })
}

/// Message: a contact without a finite mass has no damper.
pub(crate) fn no_damper(status: Status) -> String {
    format!("the contact is {}: a damper for a restitution does not exist", status.name())
}

/// Finite effective mass that holds for every branch, kg.
///
/// # Errors
/// [`StudyError`]: a contact without a finite mass, or with different masses on different branches.
pub(crate) fn finite_mass(evaluated: &EvaluatedQuestion) -> Result<f64, StudyError> {
    match mass_for_all_branches(&evaluated.result, evaluated.prepared.other_mass())? {
        EffectiveMass::Finite(mass) => Ok(mass),
        other => Err(StudyError::NoDamper(no_damper(Status::classify(other).0))),
    }
}

/// Effective mass that holds for every branch. At a singular pose m̄ is a lower bound that no branch attains;
/// the result is then the limit along the branches, if all limits are equal within `SAME_LIMIT`. `other`: mass
/// of a free body on the other side, kg.
pub(crate) fn mass_for_all_branches(
    answer: &ContactResult,
    other: Option<f64>,
) -> Result<EffectiveMass, StudyError> {
    if !answer.response.singular_pose {
        return Ok(answer.response.effective_mass);
    }
    let limits = || answer.limits.limits.iter().map(|limit| limit.against_mass(other));
    let same = |a: EffectiveMass, b: EffectiveMass| match (a, b) {
        (EffectiveMass::Finite(a), EffectiveMass::Finite(b)) => (a / b - 1.0).abs() <= SAME_LIMIT,
        _ => a == b,
    };
    match limits().next() {
        Some(first)
            if answer.complete_branch_limits().is_some() && limits().all(|limit| same(limit, first)) =>
        {
            Ok(first)
        }
        _ => {
            let complete = answer.limits.complete && !answer.limits.continuous;
            Err(StudyError::NoDamper(format!(
                "the pose is singular: no damper gives the same restitution on every branch: {}; use a nearby pose on the required \
                 branch, or compute the damper for the mass of that branch",
                branch_limits_text(&limits().collect::<Vec<_>>(), complete)
            )))
        }
    }
}

/// Change of m̄ along the motion of the contact response up to `depth` (m or rad), and the reason if the motion
/// ends before this depth.
pub(crate) fn drift(
    evaluated: &EvaluatedQuestion,
    mass: f64,
    depth: Option<f64>,
) -> (Drift, Option<PenetrationEnd>) {
    let EvaluatedQuestion { prepared, pose, contact, result: answer } = evaluated;
    let (system, response) = (&prepared.system, &answer.response);
    if response.singular_pose {
        // At a singular pose v* is tangent to no branch.
        return (Drift { per_metre: None, over_penetration: None, ends_at: None }, None);
    }
    if !response.mechanism_moves() {
        // Only the mass of the other body counts; it does not change.
        let none = depth.map(|_| 0.0);
        return (Drift { per_metre: Some(0.0), over_penetration: none, ends_at: None }, None);
    }
    let at = |distance: f64| {
        let pushed = pose.advanced_along(response, distance)?;
        match prepared.effective_mass(&pushed, contact).ok()? {
            EffectiveMass::Finite(m) => Some(m),
            EffectiveMass::Immovable | EffectiveMass::Massless => None,
        }
    };
    let step = DIFFERENCE * system.mechanism().characteristic_length();
    let per_metre = at(step).zip(at(-step)).map(|(more, less)| (more - less) / (2.0 * step * mass));
    let masses = depth.map(|depth| PenetrationPath { prepared, contact }.masses_to(pose, depth));
    let mass_at_depth =
        masses.map(|masses| masses.map(|masses| masses.last().map_or(mass, |(_, mass)| *mass)));
    let (over_penetration, ended) = match mass_at_depth {
        None => (None, None),
        Some(Ok(mass_at_depth)) => (Some(mass_at_depth / mass - 1.0), None),
        Some(Err(ended)) => (None, Some(ended)),
    };
    let ends_at = ended.as_ref().map(|ended| ended.depth);
    (Drift { per_metre, over_penetration, ends_at }, ended)
}

/// Impact with varying m̄; `None` unless it ends well before the end of the motion.
fn impact_before(end: &PenetrationEnd, damping: &DampingQuestion) -> Option<VaryingMassImpact> {
    let is_before = |(depth, _): &&(f64, f64)| *depth <= BEFORE_END * end.depth;
    let masses: Vec<(f64, f64)> = end.values.iter().take_while(is_before).copied().collect();
    let (stroke, _) = *masses.last()?;
    let impact = impact_over_stroke(damping, &masses).ok()??;
    (impact.max_penetration <= stroke).then_some(impact)
}

/// Impact with m̄ as it changes over the penetration; `None` without a speed, or if the motion of the impact ends before
/// the largest penetration. `ended`: end of the motion before the penetration of the constant mass.
fn over_stroke(
    evaluated: &EvaluatedQuestion,
    damping: &DampingQuestion,
    record: &DamperRecord,
    ended: Option<&PenetrationEnd>,
) -> Option<VaryingMassImpact> {
    let EvaluatedQuestion { prepared, pose, contact, result } = evaluated;
    let depth = record.max_penetration.filter(|depth| *depth > 0.0)?;
    if result.response.singular_pose || !result.response.mechanism_moves() {
        return None;
    }
    if let Some(end) = ended {
        return impact_before(end, damping);
    }
    let path = PenetrationPath { prepared, contact };
    // A mass that grows over the penetration penetrates deeper than the constant mass.
    for factor in STROKES {
        let stroke = factor * depth;
        match path.masses_to(pose, stroke) {
            Ok(masses) => {
                let impact = impact_over_stroke(damping, &masses).ok()??;
                if impact.max_penetration <= stroke {
                    return Some(impact);
                }
            }
            Err(end) => return impact_before(&end, damping),
        }
    }
    None
}

/// Warning if m̄ changes strongly over the penetration, or if the penetration is not reachable: `ended` has the end of the motion
/// and the penetration that the impact needs. `varies`: true if the impact with varying mass is known. `unit`: name of 0.001 m or
/// 0.001 rad.
pub(crate) fn drift_diagnostic(
    drift: &Drift,
    ended: Option<(PenetrationEnd, f64)>,
    consequence: &str,
    unit: &str,
    names: Names,
) -> Option<DiagnosticRecord> {
    if let Some((PenetrationEnd { depth: reached, error, .. }, depth)) = ended {
        let amount = |depth: f64| format!("{:.2} {unit}", 1e3 * depth);
        let why = match error {
            Some(error) => error.message(names),
            None => "the gap closes no further on this branch (a dead centre, or loops that do not close)"
                .to_owned(),
        };
        let message = format!(
            "the contact would be compressed by {}, but the mechanism can move on by {} only: {why}. The effective mass is that \
             at the touch; a stiffer contact or a slower impact penetrates less",
            amount(depth),
            amount(reached)
        );
        return Some(Finding::about_result(FindingKind::PenetrationUnreachable, message).into());
    }
    let over = drift.over_penetration.filter(|over| over.abs() > WARNED_MASS_DRIFT)?;
    let message = format!(
        "the effective mass changes by {:+.1} % while the contact is compressed, and {consequence}; a stiffer contact or a slower impact \
         reduces the change",
        100.0 * over
    );
    Some(Finding::about_result(FindingKind::MassDrifts, message).into())
}

/// Completes the simulator options with values of the model.
fn options(given: Options, evaluated: &EvaluatedQuestion, mass: f64) -> Options {
    let question = &*evaluated.prepared.question;
    let mechanism: &Mechanism = &evaluated.prepared.model.mechanism;
    let own = |link: LinkId| evaluated.prepared.system.rigid_body_mass(link).filter(|m| *m > 0.0);
    let Contact { link, against, .. } = evaluated.contact;
    let ratio = || {
        if given.stop.is_some() {
            return Some(mass / spanning_tree_joint_inertia(mechanism, question, &evaluated.contact)?);
        }
        let ours = spanning_tree_inverse_mass(mechanism, question, link)?;
        let other =
            against.map_or(Some(0.0), |other| spanning_tree_inverse_mass(mechanism, question, other))?;
        let free = question.contact.against_mass().map_or(0.0, |other| 1.0 / other);
        Some((ours + other + free) * mass).filter(|ratio| *ratio > 0.0)
    };
    // A joint stop has an inertia instead of a mass.
    let free = || {
        let free = evaluated.pose.free_body_mass(&evaluated.contact).filter(|_| given.stop.is_none())?;
        Some(question.contact.against_mass().map_or(free, |other| free * other / (free + other)))
    };
    // Parts that simulators enforce by constraints: mimics, couplings, locks, held contacts and loop closures.
    let follows = |joint: &percuss_mechanism::Joint| joint.mimic().is_some();
    let closed_loops = !mechanism.closures().is_empty();
    let constrained = closed_loops
        || !mechanism.couplings().is_empty()
        || mechanism.joints().iter().any(follows)
        || !question.conditions.lock.is_empty()
        || !question.hold.is_empty();
    Options {
        own_mass: given.own_mass.or_else(|| own(link)),
        other_own_mass: given
            .other_own_mass
            .or(question.contact.against_mass())
            .or_else(|| against.and_then(own)),
        diagonal_ratio: given.diagonal_ratio.or_else(ratio),
        constrained: given.constrained || constrained,
        closed_loops: given.closed_loops || closed_loops,
        loops_unknown: false,
        free_mass: given.free_mass.or_else(free),
        motion_curvature: given
            .motion_curvature
            .or_else(|| motion_curvature(evaluated).filter(|_| given.stop.is_none())),
        moving_bodies: given.moving_bodies.or(Some(evaluated.prepared.system.moving_bodies())),
        ..given
    }
}

/// Inertia at a joint stop of the spanning tree without loops, all joints at zero: 1 over MuJoCo's
/// `dof_invweight0`.
fn spanning_tree_joint_inertia(
    mechanism: &Mechanism,
    question: &MassQuestion,
    contact: &Contact,
) -> Option<f64> {
    let system = spanning_tree_system(mechanism, question)?;
    let pose = system.pose(&system.configuration()).ok()?;
    let link = |id: LinkId| system.mechanism().find_link(mechanism.link(id).name()).ok();
    let contact = Contact { link: link(contact.link)?, against: Some(link(contact.against?)?), ..*contact };
    match pose.respond(&contact).ok()?.effective_mass {
        EffectiveMass::Finite(inertia) => Some(inertia),
        EffectiveMass::Immovable | EffectiveMass::Massless => None,
    }
}

/// MuJoCo's `body_invweight0[0]`: mean inverse mass of a link on the spanning tree without loops, all joints at zero. If it is below
/// `mjMINVAL`, as for a balanced wheel, MuJoCo takes the number of the mean inverse inertia (`mj_setConst`, version 3.3).
fn spanning_tree_inverse_mass(mechanism: &Mechanism, question: &MassQuestion, link: LinkId) -> Option<f64> {
    let system = spanning_tree_system(mechanism, question)?;
    let link = system.mechanism().find_link(mechanism.link(link).name()).ok()?;
    let pose = system.pose(&system.configuration()).ok()?;
    let mean = pose.mean_inverse_mass(link).ok()?;
    if mean >= MUJOCO_MINVAL {
        return Some(mean);
    }
    let moment = pose.locate(&Contact::about_axis(link, Vector3::x())).ok()?;
    let response = pose.inverse_operational_inertia(&moment).ok()?;
    Some((0..3).map(|i| response.matrix()[(i, i)]).sum::<f64>() / 3.0)
}

/// Spanning tree of the mechanism without its constraints.
fn spanning_tree_system(mechanism: &Mechanism, question: &MassQuestion) -> Option<System> {
    let tree = mechanism.to_open_tree().build().ok()?.mechanism;
    let mut conditions = Conditions::new().base(question.conditions.base());
    for (joint, values) in &question.conditions.armature {
        conditions = conditions.armature(joint.clone(), values.clone());
    }
    System::new(tree, &conditions).ok()
}
