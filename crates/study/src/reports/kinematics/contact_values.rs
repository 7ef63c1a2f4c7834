//! Quantities of named contacts as targets of a search: effective mass, and peak force, compression and restitution of an impact.

use crate::damper::damped_contact::finite_mass;
use crate::damper::damping::{contact, contact_damper, require_stiffness};
use crate::damper::sheet_forces::{parallel_forces, with_sheet_curve};
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::model::loading::Model;
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::damping::DampingQuestion;
use crate::reports::answer_mass::mass;
use crate::reports::kinematics::target_question::TargetSearch;
use crate::values::force_curve::GivenCurve;
use percuss_contact::{Damper, restitution_with_parallel_forces};
use percuss_mechanism::NamedContact;
use percuss_suspension::kinematics::{KinematicUnit, KinematicValue};
use std::sync::Arc;

/// Beginning of the quantity `CONTACT.mass`, the effective mass at a named contact.
pub(super) const CONTACT_MASS: &str = "mass_";

/// Effective mass of a question as a quantity, kg.
pub(super) fn mass_value(model: &Model, name: String, question: &MassQuestion) -> KinematicValue {
    let value = missing_masses(model).and_then(|()| {
        let report = mass(model, question).map_err(|error| error.to_string())?;
        report.effective_mass.ok_or_else(|| format!("the contact is {}", report.status.name()))
    });
    KinematicValue { name, side: "", unit: KinematicUnit::Mass, value }
}

/// Error that lists the masses that the sheet does not state.
fn missing_masses(model: &Model) -> Result<(), String> {
    let sheet = model.origin.sheet.as_deref();
    let missing = sheet.map_or(&[][..], |origin| &origin.understood.missing_masses);
    if missing.is_empty() {
        return Ok(());
    }
    Err(format!(
        "masses are missing in the sheet: {}; give them, or write masses = \"estimate\" in its head",
        missing.join(", ")
    ))
}

/// Beginnings of the quantities of an impact at a named contact.
pub(super) const CONTACT_IMPACT: [&str; 3] = ["peak_force_", "compression_", "restitution_"];

/// Factors of a search on the forces of the curve of a contact, or on its stiffness, and on its damping.
#[derive(Clone, Copy, Debug)]
pub(super) struct ContactFactors {
    pub curve: f64,
    pub damping: f64,
}

/// Impact at a named contact.
pub(super) struct ContactImpact {
    pub damper: Damper,
    /// N.
    peak_force: f64,
    /// Largest compression, m.
    compression: f64,
    /// Restitution with the springs, dampers, tyres and the anti-roll bar of the sheet, to first order, or the reason for its absence.
    restitution: Result<f64, String>,
}

/// Impact at a named contact, a stop at its touch. The damper is that for the restitution of the question, times its factor.
pub(super) fn contact_impact(
    model: &Model,
    name: &str,
    impact: &DampingQuestion,
    factors: ContactFactors,
) -> Result<ContactImpact, StudyError> {
    let at_contact = MassQuestion::default().at_contact(name);
    let evaluated = EvaluatedQuestion::new(model, &at_contact)?;
    let (mut question, _) = with_sheet_curve(&evaluated, impact)?;
    require_stiffness(&question)?;
    if question.stiffness.is_some() {
        question.stiffness = Some((question.stiffness() * factors.curve).into());
    }
    if let Some(given) = &mut question.stiffness_curve {
        let curve = Arc::new(given.curve.scaled(factors.curve)?);
        *given = GivenCurve { curve, stop: given.stop.take() };
    }
    let compliant = contact(&question, finite_mass(&evaluated)?)?;
    let damper = contact_damper(&question, compliant)?.scaled(factors.damping)?;
    let speed = question.speed().unwrap_or(f64::NAN);
    let alone = damper.impact(compliant, speed)?;
    let restitution = match parallel_forces(&evaluated) {
        Some(beside) if !beside.unknown.is_empty() => Err(beside.unknown.join(", ")),
        Some(beside) => restitution_with_parallel_forces(damper, compliant, speed, &beside.force)?
            .ok_or_else(|| "the contact does not end".to_owned()),
        None => Ok(alone.restitution),
    };
    Ok(ContactImpact {
        damper,
        peak_force: alone.peak_force,
        compression: alone.max_penetration,
        restitution,
    })
}

/// Peak force (N), largest compression (m) and restitution of an impact at a named contact.
pub(super) fn impact_values(
    model: &Model,
    contact: &str,
    impact: Option<&DampingQuestion>,
    factors: ContactFactors,
) -> [KinematicValue; 3] {
    let found = missing_masses(model).and_then(|()| impact.ok_or_else(|| "missing: --speed".to_owned()));
    let found = found.and_then(|impact| {
        contact_impact(model, contact, impact, factors).map_err(|error| error.to_string())
    });
    let value = |start: &str, unit, value: fn(&ContactImpact) -> Result<f64, String>| KinematicValue {
        name: format!("{start}{contact}"),
        side: "",
        unit,
        value: found.as_ref().map_err(Clone::clone).and_then(value),
    };
    let [force, depth, restitution] = CONTACT_IMPACT;
    [
        value(force, KinematicUnit::Force, |found| Ok(found.peak_force)),
        value(depth, KinematicUnit::Length, |found| Ok(found.compression)),
        value(restitution, KinematicUnit::Ratio, |found| found.restitution.clone()),
    ]
}

/// True if a quantity or an unknown names a contact, with or without its side.
pub(super) fn is_named(contact: &str, name: &str) -> bool {
    contact.strip_prefix(name).is_some_and(|side| ["", "_left", "_right"].contains(&side))
}

/// True if a search requires a quantity of a contact; `start`: beginning of the name of the quantity.
pub(super) fn is_required(search: &TargetSearch, start: &str, contact: &str) -> bool {
    let name = format!("{start}{contact}");
    // A name without a side is that of the first side.
    search.targets.iter().any(|target| is_named(&name, &target.quantity))
}

/// Findings of the contacts of which a search requires masses or impacts, without those of the file.
pub(super) fn contact_findings(model: &Model, search: &TargetSearch) -> Vec<DiagnosticRecord> {
    let is_listed = |contact: &str| {
        CONTACT_IMPACT.into_iter().chain([CONTACT_MASS]).any(|start| is_required(search, start, contact))
    };
    let names = model.mechanism.contacts().iter().map(NamedContact::name).filter(|name| is_listed(name));
    let questions = names.map(|name| MassQuestion::default().at_contact(name));
    let mut found: Vec<DiagnosticRecord> = Vec::new();
    for report in questions.chain(search.mass.clone()).filter_map(|question| mass(model, &question).ok()) {
        for finding in report.diagnostics {
            if !model.diagnostics.contains(&finding) && !found.contains(&finding) {
                found.push(finding);
            }
        }
    }
    found
}
