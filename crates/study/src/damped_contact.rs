//! The damper of a model's contact: what the model knows beside the effective mass.

use crate::answer::{Answer, Answered};
use crate::damping::{DampingReport, Drift, about_exports, about_gravity, body_alone, damper, exports};
use crate::damping_question::DampingQuestion;
use crate::error::StudyError;
use crate::joint_stop::JointStop;
use crate::mass_report::Status;
use crate::model::Model;
use crate::question::MassQuestion;
use crate::record::DiagnosticRecord;
use crate::thresholds::{DIFFERENCE, DRIFTING, SAME_LIMIT};
use percuss_contact::exports::{MassDrift, Options};
use percuss_dynamics::{Conditions, Contact, EffectiveMass, RouteChoice, System};
use percuss_mechanism::{LinkId, Mechanism, Severity};

/// The damper of a model's contact.
///
/// # Errors
/// [`StudyError`], as for `mass` and `damp`; a contact without a finite mass, or with
/// another on each branch.
pub fn damp_contact(
    model: &Model,
    question: &MassQuestion,
    damping: &DampingQuestion,
) -> Result<DampingReport, StudyError> {
    damping_of(&Answered::new(model, question)?, damping)
}

/// The damper of a joint's stop: the conditions of the question are taken from it, its contact is not.
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
    let mut report = damp_contact(model, &question, &damping)?;
    report.stop = Some(record);
    // What the child link would weigh by itself says nothing about a stop.
    report.body_alone = None;
    // The point is percuss's own, 1 m beside the axis.
    report.diagnostics.retain(|found| found.code != "far-point");
    Ok(report)
}

/// The damper of a contact that is answered.
pub(crate) fn damping_of(
    answered: &Answered,
    damping: &DampingQuestion,
) -> Result<DampingReport, StudyError> {
    let Answered { prepared, answer, .. } = answered;
    let effective_mass = one_mass(answer, prepared.other_mass())?;
    let EffectiveMass::Finite(mass) = effective_mass else {
        let (status, _) = Status::of(effective_mass);
        return Err(StudyError::NoDamper { status: status.name() });
    };
    let record = damper(damping, mass)?;
    let drift = drift(answered, mass, record.max_penetration);
    let mut options = options(damping.options, answered, mass);
    let changes = drift.over_penetration.zip(record.max_penetration.filter(|x| *x > 0.0));
    options.drift =
        options.drift.or(changes.map(|(relative, penetration)| MassDrift { relative, penetration }));
    let alone = damping.options.own_mass.or(prepared.system.rigid_body_mass(answered.contact.link));
    let body_alone = alone.filter(|m| *m > 0.0).map(|m| body_alone(damping, m, mass));
    let mut diagnostics = prepared.model.diagnostics.clone();
    diagnostics.extend(answer.findings.iter().cloned().map(DiagnosticRecord::from));
    diagnostics.extend(about_exports(damping));
    diagnostics.extend(about_gravity(damping, mass)?);
    if let Some(over) = drift.over_penetration.filter(|over| over.abs() > DRIFTING) {
        let message = format!(
            "the effective mass changes by {:+.1} % over the penetration: one number is no better than that here; a \
             stiffer contact or a slower impact changes it less",
            100.0 * over
        );
        diagnostics.push(DiagnosticRecord::about_answer(Severity::Warning, "mass-drifts", message));
    }
    Ok(DampingReport {
        schema: "percuss.damp/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: prepared.inputs(),
        effective_mass: mass,
        stop: None,
        damper: record,
        drift: Some(drift),
        body_alone,
        exports: exports(damping, mass, options)?,
        diagnostics,
    })
}

/// The mass that the contact has whatever the motion is. At a singular pose the value of the answer is a bound that no
/// branch attains: it is the limit along them, if that is the same for all.
fn one_mass(answer: &Answer, other: Option<f64>) -> Result<EffectiveMass, StudyError> {
    if !answer.response.singular_pose {
        return Ok(answer.response.effective_mass);
    }
    let limits = || answer.limits.limits.iter().map(|limit| limit.against_mass(other));
    let same = |a: EffectiveMass, b: EffectiveMass| match (a, b) {
        (EffectiveMass::Finite(a), EffectiveMass::Finite(b)) => (a / b - 1.0).abs() <= SAME_LIMIT,
        _ => a == b,
    };
    match limits().next() {
        Some(first) if answer.all_branches().is_some() && limits().all(|limit| same(limit, first)) => {
            Ok(first)
        }
        _ => Err(StudyError::NoDamperOfAll {
            limits: limits().collect(),
            complete: answer.limits.complete && !answer.limits.continuous,
        }),
    }
}

/// m̄ along the motion of the contact response.
fn drift(answered: &Answered, mass: f64, penetration: Option<f64>) -> Drift {
    let Answered { prepared, pose, contact, answer } = answered;
    let (system, response) = (&prepared.system, &answer.response);
    if response.singular_pose {
        // The motion of the answer is along no branch.
        return Drift { per_metre: None, over_penetration: None };
    }
    if !response.gives_way() {
        // The other body's mass is all there is.
        return Drift { per_metre: Some(0.0), over_penetration: penetration.map(|_| 0.0) };
    }
    let at = |distance: f64| {
        let pushed = pose.advanced_along(response, distance)?;
        match prepared.effective_mass(&pushed, contact).ok()? {
            EffectiveMass::Finite(m) => Some(m),
            EffectiveMass::Immovable | EffectiveMass::Massless => None,
        }
    };
    let step = DIFFERENCE * system.mechanism().characteristic_length();
    let slope = at(step).zip(at(-step)).map(|(more, less)| (more - less) / (2.0 * step * mass));
    Drift { per_metre: slope, over_penetration: penetration.and_then(at).map(|there| there / mass - 1.0) }
}

/// What simulators need of the model, where the question does not have it.
fn options(given: Options, answered: &Answered, mass: f64) -> Options {
    let question = answered.prepared.question;
    let mechanism: &Mechanism = &answered.prepared.model.mechanism;
    let own = |link: LinkId| answered.prepared.system.rigid_body_mass(link).filter(|m| *m > 0.0);
    let Contact { link, against, .. } = answered.contact;
    let ratio = || {
        if given.stop.is_some() {
            return Some(mass / open_inertia(mechanism, question, &answered.contact)?);
        }
        let ours = open_inverse_mass(mechanism, question, link)?;
        let other = against.map_or(Some(0.0), |other| open_inverse_mass(mechanism, question, other))?;
        let free = question.against_mass.map_or(0.0, |other| 1.0 / other);
        Some((ours + other + free) * mass)
    };
    // A joint's stop has an inertia in place of a mass.
    let free = || {
        let free = answered.pose.free_body_mass(&answered.contact).filter(|_| given.stop.is_none())?;
        Some(question.against_mass.map_or(free, |other| free * other / (free + other)))
    };
    // What simulators hold by constraints: mimics, couplings, locks and held contacts too.
    let follows = |joint: &percuss_mechanism::Joint| joint.mimic().is_some();
    let closed_loops = !mechanism.closures().is_empty();
    let constrained = closed_loops
        || !mechanism.couplings().is_empty()
        || mechanism.joints().iter().any(follows)
        || !question.lock.is_empty()
        || !question.hold.is_empty();
    Options {
        own_mass: given.own_mass.or_else(|| own(link)),
        other_own_mass: given.other_own_mass.or(question.against_mass).or_else(|| against.and_then(own)),
        diagonal_ratio: given.diagonal_ratio.or_else(ratio),
        constrained: given.constrained || constrained,
        closed_loops: given.closed_loops || closed_loops,
        free_mass: given.free_mass.or_else(free),
        moving_bodies: given.moving_bodies.or(Some(answered.prepared.system.moving_bodies())),
        ..given
    }
}

/// The inertia that a joint's stop feels on the spanning tree alone, with all joints at zero: 1 over MuJoCo's
/// `dof_invweight0`.
fn open_inertia(mechanism: &Mechanism, question: &MassQuestion, contact: &Contact) -> Option<f64> {
    let system = open_system(mechanism, question)?;
    let pose = system.pose(&system.configuration()).ok()?;
    let link = |id: LinkId| system.mechanism().find_link(mechanism.link(id).name()).ok();
    let contact = Contact { link: link(contact.link)?, against: Some(link(contact.against?)?), ..*contact };
    match pose.respond(&contact, RouteChoice::Auto).ok()?.effective_mass {
        EffectiveMass::Finite(inertia) => Some(inertia),
        EffectiveMass::Immovable | EffectiveMass::Massless => None,
    }
}

/// MuJoCo's `body_invweight0`: of the spanning tree alone, with all joints at zero.
fn open_inverse_mass(mechanism: &Mechanism, question: &MassQuestion, link: LinkId) -> Option<f64> {
    let system = open_system(mechanism, question)?;
    let link = system.mechanism().find_link(mechanism.link(link).name()).ok()?;
    let pose = system.pose(&system.configuration()).ok()?;
    pose.mean_inverse_mass(link).ok()
}

/// The spanning tree without its constraints.
fn open_system(mechanism: &Mechanism, question: &MassQuestion) -> Option<System> {
    let tree = mechanism.to_open_tree().build().ok()?.mechanism;
    let mut conditions = Conditions::new().base(question.base);
    for (joint, values) in &question.armature {
        conditions = conditions.armature(joint.clone(), values.clone());
    }
    System::new(tree, &conditions).ok()
}
