//! The damper of a model's contact: what the model knows beside the effective mass.

use crate::damping::{DampingQuestion, DampingReport, Drift, about_exports, body_alone, damper, exports};
use crate::mass::Answered;
use crate::question::{MassQuestion, StudyError};
use crate::{DiagnosticRecord, Model};
use percuss_contact::exports::Options;
use percuss_dynamics::{Conditions, Contact, EffectiveMass, RouteChoice, System};
use percuss_mechanism::{LinkId, Mechanism, Severity};

/// Half the way of the differences that give dm̄/dδ, in parts of the characteristic length.
const DIFFERENCE: f64 = 1e-5;
/// From this change of m̄ over the penetration on, one number is not good enough without a word.
const DRIFTING: f64 = 0.01;

/// The damper of a model's contact.
///
/// # Errors
/// [`StudyError`], as for [`mass`](crate::mass()) and [`damp`](crate::damp); a contact without a finite mass.
pub fn damp_contact(
    model: &Model,
    question: &MassQuestion,
    damping: &DampingQuestion,
) -> Result<DampingReport, StudyError> {
    let answered = Answered::new(model, question)?;
    damping_of(model, question, damping, &answered)
}

/// The damper of a contact that is answered.
pub(crate) fn damping_of(
    model: &Model,
    question: &MassQuestion,
    damping: &DampingQuestion,
    answered: &Answered,
) -> Result<DampingReport, StudyError> {
    let EffectiveMass::Finite(mass) = answered.strike.effective_mass else {
        return Err(StudyError::NoDamper { status: answered.report.status.name() });
    };
    let record = damper(damping, mass)?;
    let drift = drift(question, answered, mass, record.max_penetration);
    let options = options(damping.options, &model.mechanism, question, answered, mass);
    let alone = damping.options.own_mass.or(answered.system.rigid_body_mass(answered.contact.link));
    let body_alone = alone.filter(|m| *m > 0.0).map(|m| body_alone(damping, m, mass));
    let mut diagnostics = answered.report.diagnostics.clone();
    diagnostics.extend(about_exports(damping));
    if let Some(over) = drift.over_penetration.filter(|over| over.abs() > DRIFTING) {
        let message = format!(
            "the effective mass changes by {:+.1} % over the penetration: one number is no better than that here; a \
             stiffer contact or a slower blow changes it less",
            100.0 * over
        );
        diagnostics.push(DiagnosticRecord::about_answer(Severity::Warning, "mass-drifts", message));
    }
    Ok(DampingReport {
        schema: "percuss.damp/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: model.inputs.clone(),
        effective_mass: mass,
        damper: record,
        drift: Some(drift),
        body_alone,
        exports: exports(damping, mass, options)?,
        diagnostics,
    })
}

/// m̄ along the strike's own motion.
fn drift(question: &MassQuestion, answered: &Answered, mass: f64, penetration: Option<f64>) -> Drift {
    let Answered { system, pose, contact, strike, .. } = answered;
    if !strike.gives_way() {
        // The other body's mass is all there is.
        return Drift { per_metre: Some(0.0), over_penetration: penetration.map(|_| 0.0) };
    }
    let at = |distance: f64| {
        let pushed = system.pushed(pose, strike, distance)?;
        let there = system.strike(&pushed, contact, RouteChoice::Auto).ok()?;
        let there = question.against_mass.map_or(there.clone(), |other| there.against_mass(other));
        match there.effective_mass {
            EffectiveMass::Finite(m) => Some(m),
            EffectiveMass::Immovable | EffectiveMass::Massless => None,
        }
    };
    let step = DIFFERENCE * system.mechanism().characteristic_length();
    let slope = at(step).zip(at(-step)).map(|(more, less)| (more - less) / (2.0 * step * mass));
    Drift { per_metre: slope, over_penetration: penetration.and_then(at).map(|there| there / mass - 1.0) }
}

/// What simulators want to know of the model, where the question does not say.
fn options(
    given: Options,
    mechanism: &Mechanism,
    question: &MassQuestion,
    answered: &Answered,
    mass: f64,
) -> Options {
    let own = |link: LinkId| answered.system.rigid_body_mass(link).filter(|m| *m > 0.0);
    let Contact { link, against, .. } = answered.contact;
    let ratio = || {
        let ours = open_inverse_mass(mechanism, question, link)?;
        let other = against.map_or(Some(0.0), |other| open_inverse_mass(mechanism, question, other))?;
        let free = question.against_mass.map_or(0.0, |other| 1.0 / other);
        Some((ours + other + free) * mass)
    };
    // What simulators hold by constraints: mimics, couplings, locks and held contacts too.
    let follows = |joint: &percuss_mechanism::Joint| joint.mimic().is_some();
    let constrained = !mechanism.closures().is_empty()
        || !mechanism.couplings().is_empty()
        || mechanism.joints().iter().any(follows)
        || !question.lock.is_empty()
        || !question.hold.is_empty();
    Options {
        own_mass: given.own_mass.or_else(|| own(link)),
        other_own_mass: given.other_own_mass.or(question.against_mass).or_else(|| against.and_then(own)),
        diagonal_ratio: given.diagonal_ratio.or_else(ratio),
        constrained: given.constrained || constrained,
        ..given
    }
}

/// MuJoCo's `body_invweight0`: of the spanning tree alone, with all joints at zero.
fn open_inverse_mass(mechanism: &Mechanism, question: &MassQuestion, link: LinkId) -> Option<f64> {
    let tree = mechanism.to_open_tree().build().ok()?.mechanism;
    let mut conditions = Conditions::new().base(question.base);
    for (joint, values) in &question.armature {
        conditions = conditions.armature(joint.clone(), values.clone());
    }
    let link = tree.find_link(mechanism.link(link).name()).ok()?;
    let system = System::new(tree, &conditions).ok()?;
    let pose = system.pose(&system.configuration()).ok()?;
    system.mean_inverse_mass(&pose, link).ok()
}
