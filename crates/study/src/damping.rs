//! From a restitution to a damper: a contact's effective mass, its spring, and what the laws and the simulators make of
//! them.

use crate::damping_question::DampingQuestion;
use crate::error::StudyError;
use crate::joint_stop::StopRecord;
use crate::model::Input;
use crate::record::DiagnosticRecord;
use crate::simulators::ExportRecord;
use percuss_contact::exports::{Options, Request};
use percuss_contact::{CompliantContact, ContactLawError, Damper, Law, Sample, Separation};
use percuss_mechanism::Severity;
use serde::Serialize;
use std::collections::BTreeMap;

/// The damper of a contact, and the impact it makes. Keys are always present, null where they do not apply.
#[derive(Clone, Debug, Serialize)]
pub struct DamperRecord {
    /// The restitution asked for.
    pub restitution: f64,
    /// k, N/m^p.
    pub stiffness: f64,
    /// p.
    pub exponent: f64,
    /// Approach speed, m/s.
    pub speed: Option<f64>,
    /// The law of the damper.
    pub law: &'static str,
    /// The other name by which it was asked for.
    pub law_alias: Option<&'static str>,
    /// Whether it gives the restitution asked for exactly.
    pub law_is_exact: bool,
    /// When the contact ends: `force` or `gap`; null for laws whose force vanishes with the gap.
    pub separation: Option<&'static str>,
    /// ζ; null for laws of the Hunt–Crossley family.
    pub damping_ratio: Option<f64>,
    /// c, N·s/m^((p+1)/2): N·s/m for a linear spring; null for laws of the Hunt–Crossley family.
    pub damping: Option<f64>,
    /// d of k xᵖ (1 + d ẋ), s/m: the law's; of the exact Hunt–Crossley law where the law is Kelvin–Voigt. Null without
    /// a speed.
    pub dissipation: Option<f64>,
    /// The restitution that the damper gives.
    pub achieved_restitution: f64,
    /// First touch to separation, s; null where it depends on a speed that was not given, or lasts for ever.
    pub contact_duration: Option<f64>,
    /// m; null without a speed, as are all below.
    pub max_penetration: Option<f64>,
    /// When it is deepest, s.
    pub time_of_max_penetration: Option<f64>,
    /// N.
    pub peak_force: Option<f64>,
    /// When the force is greatest, s.
    pub time_of_peak_force: Option<f64>,
    /// J.
    pub energy_lost: Option<f64>,
    /// m/s.
    pub rebound_speed: Option<f64>,
}

/// How good one number is: m̄ over the penetration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Drift {
    /// dm̄/dδ over m̄, along the direction of impact, 1/m.
    pub per_metre: Option<f64>,
    /// m̄ at the greatest penetration over m̄ at the touch, less 1; null without a speed.
    pub over_penetration: Option<f64>,
}

/// What people take instead of m̄: the mass of the struck rigid body.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct BodyAlone {
    /// kg.
    pub mass: f64,
    /// The restitution that a damper made for it gives on the real contact; null for laws of the Hunt–Crossley family,
    /// which do not ask for a mass.
    pub restitution: Option<f64>,
}

/// `percuss damp`, as JSON.
#[derive(Clone, Debug, Serialize)]
pub struct DampingReport {
    /// `percuss.damp/1`.
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// The files; none where the mass was given.
    pub inputs: Vec<Input>,
    /// m̄, kg.
    pub effective_mass: f64,
    /// The joint whose stop it is, which says what the units of all of this are; null for a contact between bodies.
    pub stop: Option<StopRecord>,
    /// The damper.
    #[serde(flatten)]
    pub damper: DamperRecord,
    /// m̄ over the penetration; null where the mass was given.
    pub drift: Option<Drift>,
    /// The struck body's own mass and what it would do; null where the mass was given.
    pub body_alone: Option<BodyAlone>,
    /// Parameters and snippets by simulator.
    pub exports: BTreeMap<&'static str, ExportRecord>,
    /// What was found, in the file and in the answer.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// The contact of a question on a mass.
pub(crate) fn contact(question: &DampingQuestion, mass: f64) -> Result<CompliantContact, ContactLawError> {
    CompliantContact::new(mass, question.stiffness)?.with_exponent(question.exponent)
}

/// The damper of a question, on a mass.
fn damper_of(question: &DampingQuestion, contact: CompliantContact) -> Result<Damper, ContactLawError> {
    question.law.damper(contact, question.restitution, question.speed, question.separation)
}

/// The damper that gives a mass a restitution, and the impact at the speed given.
///
/// # Errors
/// [`ContactLawError`]: numbers out of range, a restitution that the law does not reach, a speed that the law needs.
pub fn damper(question: &DampingQuestion, mass: f64) -> Result<DamperRecord, ContactLawError> {
    let contact = contact(question, mass)?;
    let damper = damper_of(question, contact)?;
    // Kelvin–Voigt rebounds alike at every speed, and a linear one takes as long.
    let impact = damper.impact(contact, question.speed.unwrap_or(1.0))?;
    let at_speed = question.speed.map(|_| impact);
    let exact_dissipation = || {
        let speed = question.speed?;
        match Law::HuntCrossley.damper(contact, question.restitution, Some(speed), question.separation) {
            Ok(Damper::HuntCrossley { dissipation }) => Some(dissipation),
            _ => None,
        }
    };
    let (damping_ratio, damping, dissipation, separation) = match damper {
        Damper::KelvinVoigt { ratio, coefficient, separation } => {
            (Some(ratio), Some(coefficient), exact_dissipation(), Some(separation.name()))
        }
        Damper::HuntCrossley { dissipation } => (None, None, Some(dissipation), None),
    };
    Ok(DamperRecord {
        restitution: question.restitution,
        stiffness: question.stiffness,
        exponent: question.exponent,
        speed: question.speed,
        law: question.law.name(),
        law_alias: question.alias,
        law_is_exact: question.law.is_exact(),
        separation,
        damping_ratio,
        damping,
        dissipation,
        achieved_restitution: impact.restitution,
        contact_duration: if question.exponent == 1.0 || at_speed.is_some() { impact.duration } else { None },
        max_penetration: at_speed.map(|b| b.max_penetration),
        time_of_max_penetration: at_speed.map(|b| b.time_of_max_penetration),
        peak_force: at_speed.map(|b| b.peak_force),
        time_of_peak_force: at_speed.map(|b| b.time_of_peak_force),
        energy_lost: at_speed.map(|b| b.energy_lost),
        rebound_speed: at_speed.map(|b| b.rebound_speed),
    })
}

/// The history of the impact in so many moments: force over time, and over penetration.
///
/// # Errors
/// [`ContactLawError`], as for [`damper`]; no speed.
pub fn impact_history(
    question: &DampingQuestion,
    mass: f64,
    samples: usize,
) -> Result<Vec<Sample>, ContactLawError> {
    let contact = contact(question, mass)?;
    let speed = question.speed.ok_or(ContactLawError::SpeedNeeded { law: "the history of an impact" })?;
    damper_of(question, contact)?.history(contact, speed, samples)
}

/// Parameters for every simulator asked for. One that cannot have this contact has the reason in its place, unless it is
/// the only one.
pub(crate) fn exports(
    question: &DampingQuestion,
    mass: f64,
    options: Options,
) -> Result<BTreeMap<&'static str, ExportRecord>, StudyError> {
    let request = Request {
        options,
        speed: question.speed,
        ..Request::new(contact(question, mass)?, question.restitution)
    };
    let mut exports = BTreeMap::new();
    for tool in &question.tools {
        let record = match tool.export(&request) {
            Ok(export) => ExportRecord::of(&export),
            Err(error) if question.tools.len() == 1 => return Err(StudyError::Export(Box::new(error))),
            Err(error) => ExportRecord::refused(*tool, &error),
        };
        exports.insert(tool.name(), record);
    }
    Ok(exports)
}

/// That simulators do not integrate the law that was asked for.
pub(crate) fn about_exports(question: &DampingQuestion) -> Option<DiagnosticRecord> {
    let same = question.law == Law::KelvinVoigt && question.separation == Separation::ForceVanishes;
    (!same && !question.tools.is_empty()).then(|| {
        let message = format!(
            "the simulators' parameters are for the laws that they integrate, and for the restitution {}; the law and \
             the separation that were asked for are those of the damper above",
            question.restitution
        );
        DiagnosticRecord::about_answer(Severity::Note, "exports-own-law", message)
    })
}

/// Warns of gravity: it takes more from the restitution than the accuracy of the simulators' parameters.
pub(crate) fn about_gravity(
    question: &DampingQuestion,
    mass: f64,
) -> Result<Option<DiagnosticRecord>, ContactLawError> {
    if question.tools.is_empty() {
        return Ok(None);
    }
    let request = Request {
        options: question.options,
        speed: question.speed,
        ..Request::new(contact(question, mass)?, question.restitution)
    };
    let loss = request.gravity_loss().filter(|loss| *loss > question.options.accuracy);
    Ok(loss.map(|loss| {
        let message = format!(
            "the simulators' parameters are for an impact without gravity: where gravity presses this contact, compliant contacts \
             rebound with up to {loss:.1e} less than {}; a stiffer contact or a faster impact changes that in proportion to \
             1/(speed·√stiffness)",
            question.restitution
        );
        DiagnosticRecord::about_answer(Severity::Warning, "gravity-acts", message)
    }))
}

/// What a damper made for the struck body's own mass does to the contact.
pub(crate) fn body_alone(question: &DampingQuestion, alone: f64, mass: f64) -> BodyAlone {
    let restitution = || {
        let made = damper_of(question, contact(question, alone).ok()?).ok()?;
        let Damper::KelvinVoigt { coefficient, separation, .. } = made else { return None };
        let real = contact(question, mass).ok()?;
        let damper = Damper::kelvin_voigt_from_coefficient(real, coefficient, separation).ok()?;
        damper.restitution(real, question.speed.unwrap_or(1.0)).ok()
    };
    BodyAlone { mass: alone, restitution: restitution() }
}

/// The damper of a mass that is given.
///
/// # Errors
/// [`StudyError`]: as for [`damper`]; a simulator that cannot have it, where it is the only one.
pub fn damp(question: &DampingQuestion, mass: f64) -> Result<DampingReport, StudyError> {
    let body_alone = question.options.own_mass.map(|alone| body_alone(question, alone, mass));
    Ok(DampingReport {
        schema: "percuss.damp/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: Vec::new(),
        effective_mass: mass,
        stop: None,
        damper: damper(question, mass)?,
        drift: None,
        body_alone,
        exports: exports(question, mass, question.options)?,
        diagnostics: about_exports(question).into_iter().chain(about_gravity(question, mass)?).collect(),
    })
}
