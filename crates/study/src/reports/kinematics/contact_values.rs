//! Quantities of named contacts as targets of a search: effective mass, and peak force and compression of an impact.

use crate::model::loading::Model;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::damping::DampingQuestion;
use crate::reports::answer_mass::{mass, mass_with_damper};
use percuss_suspension::kinematics::{KinematicUnit, KinematicValue};

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
pub(super) const CONTACT_IMPACT: [&str; 2] = ["peak_force_", "compression_"];

/// Peak force (N) and largest compression (m) of an impact at a named contact.
pub(super) fn impact_values(
    model: &Model,
    contact: &str,
    impact: Option<&DampingQuestion>,
) -> [KinematicValue; 2] {
    // A stop at its touch.
    let question = MassQuestion::without_contact().at_contact(contact);
    let found = missing_masses(model).and_then(|()| impact.ok_or_else(|| "missing: --speed".to_owned()));
    let found = found.and_then(|impact| {
        let report = mass_with_damper(model, &question, impact).map_err(|error| error.to_string())?;
        let damper = report.damper.ok_or("the contact has no finite mass")?.damper;
        damper.peak_force.zip(damper.max_penetration).ok_or_else(|| "the contact does not end".to_owned())
    });
    let value = |start: &str, unit, value| KinematicValue {
        name: format!("{start}{contact}"),
        side: "",
        unit,
        value,
    };
    let [force, depth] = CONTACT_IMPACT;
    [
        value(force, KinematicUnit::Force, found.clone().map(|(force, _)| force)),
        value(depth, KinematicUnit::Length, found.map(|(_, depth)| depth)),
    ]
}
