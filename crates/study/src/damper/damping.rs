//! Damper design from a coefficient of restitution: damper of the contact, impact at a given speed, and
//! simulator parameters.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::simulators::ExportRecord;
use crate::evaluation::named_contact::NamedContactRecord;
use crate::evaluation::status::mass_unit;
use crate::model::loading::Input;
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::StudyError;
use crate::question::spelled_contact::StopRecord;
use crate::question::tables::damping::DampingQuestion;
use crate::values::force_curve::{ForceCurveRecord, GivenCurve};
use percuss_contact::exports::{ExportError, Options, Request, StopMotion};
use percuss_contact::{
    CompliantContact, ContactLawError, Damper, Law, Sample, Separation, VaryingMassImpact,
    impact_with_varying_mass,
};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// Damper of a contact and the resulting impact. All keys are always present; a value is null if not
/// applicable.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct DamperRecord {
    /// Requested coefficient of restitution.
    pub restitution: f64,
    /// Stiffness k, N/m^p; null for a force curve.
    pub stiffness: Option<f64>,
    /// Exponent p; null for a force curve.
    pub exponent: Option<f64>,
    /// Force curve F_s of the contact; null for a stiffness.
    pub stiffness_curve: Option<ForceCurveRecord>,
    /// Approach speed, m/s.
    pub speed: Option<f64>,
    /// Damper law.
    pub law: &'static str,
    /// Alias by which the law was requested.
    pub law_alias: Option<&'static str>,
    /// True if the law gives the requested restitution exactly.
    pub law_is_exact: bool,
    /// Condition for the end of the contact: `force` or `gap`; null for laws with a force that vanishes with
    /// the gap.
    pub separation: Option<&'static str>,
    /// Damping ratio ζ; null for other laws than Kelvin–Voigt and for a force curve.
    pub damping_ratio: Option<f64>,
    /// Damping coefficient c, N·s/m^((p+1)/2), which is N·s/m for a linear spring and for a force curve; null for
    /// other laws than Kelvin–Voigt.
    pub damping: Option<f64>,
    /// Dissipation d of the force F_s(x) (1 + d ẋ), F_s = k xᵖ or the force curve, s/m. For the Kelvin–Voigt law, the value of the exact
    /// Hunt–Crossley law, null without a speed.
    pub dissipation: Option<f64>,
    /// Loss factor η of the force F_s(x) (1 + (π/2) η sgn ẋ); null for other laws.
    pub loss_factor: Option<f64>,
    /// Restitution that the damper achieves.
    pub achieved_restitution: f64,
    /// Time from first touch to separation, s; null if the duration depends on a speed that is not given, or is
    /// infinite.
    pub contact_duration: Option<f64>,
    /// Maximum penetration, m; null without a speed, as are all following values.
    pub max_penetration: Option<f64>,
    /// Time of maximum penetration, s.
    pub time_of_max_penetration: Option<f64>,
    /// Peak force, N.
    pub peak_force: Option<f64>,
    /// Time of peak force, s.
    pub time_of_peak_force: Option<f64>,
    /// Energy lost, J.
    pub energy_lost: Option<f64>,
    /// Rebound speed, m/s.
    pub rebound_speed: Option<f64>,
}

/// Change of m̄ over the penetration. A large change means that one constant mass is a poor approximation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Drift {
    /// Relative rate (dm̄/dδ)/m̄ along the direction of impact, 1/m.
    pub per_metre: Option<f64>,
    /// m̄ at maximum penetration over m̄ at first touch, minus 1; null without a speed, and if the maximum
    /// penetration is not reachable.
    pub over_penetration: Option<f64>,
    /// Penetration at which the motion of impact ends before the maximum penetration, m; null if the motion
    /// does not end early.
    pub ends_at: Option<f64>,
}

/// Mass of the contact body taken alone, a common substitute for m̄.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BodyAlone {
    /// Mass, kg.
    pub mass: f64,
    /// Restitution on the real contact of a damper designed for this mass; null for laws with a damping that does not
    /// depend on the mass (Hunt–Crossley, loss factor).
    pub restitution: Option<f64>,
}

/// Report of `percuss damp`, as JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct DampingReport {
    /// `percuss.damp/1`.
    #[schemars(extend("const" = "percuss.damp/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files; empty if the mass is given directly.
    pub inputs: Vec<Input>,
    /// m̄ in the unit of `unit`.
    pub effective_mass: f64,
    /// Unit of the effective mass: `kg`, or `kg·m²` for a moment.
    pub unit: &'static str,
    /// True for a moment about an axis, and for the stop of a revolute joint: lengths are angles (rad), forces are moments (N·m).
    pub is_moment: bool,
    /// Named contact; null for a contact given by link, point and normal, and for a joint stop.
    pub named_contact: Option<NamedContactRecord>,
    /// Joint stop; null for other contacts.
    pub stop: Option<StopRecord>,
    /// Damper and impact.
    #[serde(flatten)]
    pub damper: DamperRecord,
    /// Change of m̄ over the penetration; null if the mass is given directly.
    pub drift: Option<Drift>,
    /// The same damper in an impact with m̄ as it changes over the penetration: exact for a mechanism with one degree of
    /// freedom, otherwise along the motion of the impact. Null without a speed, if the mass is given directly, and if the
    /// motion ends before the largest penetration.
    pub over_stroke: Option<VaryingMassImpact>,
    /// Mass of the contact body alone and the resulting restitution; null if neither the model nor the options
    /// give this mass.
    pub body_alone: Option<BodyAlone>,
    /// Parameters and code snippets by simulator.
    pub exports: BTreeMap<&'static str, ExportRecord>,
    /// Findings about the file and the result.
    pub diagnostics: Vec<DiagnosticRecord>,
    /// The question, with the force curve of the sheet.
    #[serde(skip)]
    pub question: DampingQuestion,
}

/// Compliant contact of a question for a given mass, kg.
pub(crate) fn contact(
    question: &DampingQuestion,
    mass: f64,
) -> Result<CompliantContact<'_>, ContactLawError> {
    question.check_law()?;
    if let Some(given) = &question.stiffness_curve {
        return CompliantContact::on_curve(mass, &given.curve);
    }
    CompliantContact::new(mass, question.stiffness())?.with_exponent(question.exponent())
}

/// Damper of a question for a contact.
pub(crate) fn contact_damper(
    question: &DampingQuestion,
    contact: CompliantContact,
) -> Result<Damper, ContactLawError> {
    question.law().damper(contact, question.restitution(), question.speed(), question.separation())
}

/// Damper that gives a mass the requested restitution, and the impact at the given speed.
///
/// # Errors
/// [`ContactLawError`]: numbers out of range, a restitution out of the range of the law, a missing speed that
/// the law needs.
pub fn damper(question: &DampingQuestion, mass: f64) -> Result<DamperRecord, ContactLawError> {
    let contact = contact(question, mass)?;
    let damper = contact_damper(question, contact)?;
    // On a spring the restitution of Kelvin–Voigt does not depend on the speed, nor does the duration of the linear law.
    let impact = damper.impact(contact, question.speed().unwrap_or(1.0))?;
    let at_speed = question.speed().map(|_| impact);
    let exact_dissipation = || {
        let speed = question.speed()?;
        match Law::HuntCrossley.damper(contact, question.restitution(), Some(speed), question.separation()) {
            Ok(Damper::HuntCrossley { dissipation }) => Some(dissipation),
            _ => None,
        }
    };
    let (damping_ratio, damping, dissipation, separation, loss_factor) = match damper {
        Damper::KelvinVoigt { ratio, coefficient, separation } => {
            let ratio = question.stiffness_curve.is_none().then_some(ratio);
            (ratio, Some(coefficient), exact_dissipation(), Some(separation.name()), None)
        }
        Damper::HuntCrossley { dissipation } => (None, None, Some(dissipation), None, None),
        Damper::LossFactor { loss_factor } => (None, None, None, None, Some(loss_factor)),
    };
    Ok(DamperRecord {
        restitution: question.restitution(),
        stiffness: question.stiffness_curve.is_none().then(|| question.stiffness()),
        exponent: question.stiffness_curve.is_none().then(|| question.exponent()),
        stiffness_curve: question.stiffness_curve.as_ref().map(Into::into),
        speed: question.speed(),
        law: question.law().name(),
        law_alias: question.alias(),
        law_is_exact: question.law().is_exact(),
        separation,
        damping_ratio,
        damping,
        dissipation,
        loss_factor,
        achieved_restitution: impact.restitution,
        contact_duration: if question.stiffness_curve.is_none() && question.exponent() == 1.0
            || at_speed.is_some()
        {
            impact.duration
        } else {
            None
        },
        max_penetration: at_speed.map(|b| b.max_penetration),
        time_of_max_penetration: at_speed.map(|b| b.time_of_max_penetration),
        peak_force: at_speed.map(|b| b.peak_force),
        time_of_peak_force: at_speed.map(|b| b.time_of_peak_force),
        energy_lost: at_speed.map(|b| b.energy_lost),
        rebound_speed: at_speed.map(|b| b.rebound_speed),
    })
}

/// Impact of a damper, designed for the mass at the touch, with a mass that changes over the penetration.
pub(crate) fn impact_over_stroke(
    question: &DampingQuestion,
    masses: &[(f64, f64)],
) -> Result<Option<VaryingMassImpact>, ContactLawError> {
    let (Some((_, mass)), Some(speed)) = (masses.first(), question.speed()) else { return Ok(None) };
    let contact = contact(question, *mass)?;
    impact_with_varying_mass(contact_damper(question, contact)?, contact, masses, speed)
}

/// History of the impact at `samples` times: time, penetration, penetration rate and force.
///
/// # Errors
/// [`ContactLawError`], as for [`damper`]; no speed.
pub fn impact_history(
    question: &DampingQuestion,
    mass: f64,
    samples: usize,
) -> Result<Vec<Sample>, ContactLawError> {
    let contact = contact(question, mass)?;
    let speed = question.speed().ok_or(ContactLawError::SpeedNeeded { law: "the history of an impact" })?;
    contact_damper(question, contact)?.history(contact, speed, samples)
}

/// Parameters of all requested simulators. A simulator that does not support the contact gets an error record;
/// if only one simulator is requested, the result is an error. `is_moment`: the contact is a moment about an axis.
pub(crate) fn exports(
    question: &DampingQuestion,
    mass: f64,
    options: Options,
    is_moment: bool,
) -> Result<BTreeMap<&'static str, ExportRecord>, StudyError> {
    let request = Request {
        options,
        speed: question.speed(),
        ..Request::new(contact(question, mass)?, question.restitution())
    };
    request.check().map_err(|error| StudyError::Export(Box::new(error)))?;
    let mut exports = BTreeMap::new();
    let tools = question.tools();
    for tool in &tools {
        // Simulators support the stop of a joint, although it is a moment.
        let export = match is_moment && options.stop.is_none() {
            true => Err(ExportError::Moment { tool: *tool }),
            false => tool.export(&request),
        };
        let record = match export {
            Ok(export) => ExportRecord::from_export(&export),
            Err(error) if tools.len() == 1 => return Err(StudyError::Export(Box::new(error))),
            Err(error) => ExportRecord::from_error(*tool, &error),
        };
        exports.insert(tool.name(), record);
    }
    Ok(exports)
}

/// Note that the simulators integrate another law than the requested one; `None` if both laws are equal or no
/// simulator is requested.
pub(crate) fn law_mismatch_diagnostic(question: &DampingQuestion) -> Option<DiagnosticRecord> {
    let same = question.law() == Law::KelvinVoigt && question.separation() == Separation::ForceVanishes;
    (!same && !question.tools().is_empty()).then(|| {
        let message = format!(
            "the parameters of simulators are for the laws of the simulators and for the restitution {}; the \
             requested law and separation apply only to the damper above",
            question.restitution()
        );
        Finding::about_result(FindingKind::ExportsOwnLaw, message).into()
    })
}

/// Restitution on the real contact (`mass`, kg) of a damper designed for the mass of the body alone (`alone`,
/// kg).
pub(crate) fn compare_with_body_mass(question: &DampingQuestion, alone: f64, mass: f64) -> BodyAlone {
    let restitution = || {
        let made = contact_damper(question, contact(question, alone).ok()?).ok()?;
        let Damper::KelvinVoigt { coefficient, separation, .. } = made else { return None };
        let real = contact(question, mass).ok()?;
        let damper = Damper::kelvin_voigt_from_coefficient(real, coefficient, separation).ok()?;
        damper.restitution(real, question.speed().unwrap_or(1.0)).ok()
    };
    BodyAlone { mass: alone, restitution: restitution() }
}

/// Damper for a contact with a given effective mass, kg.
///
/// # Errors
/// [`StudyError`]: as for [`damper`]; a contact that the only requested simulator does not support.
pub fn damp(question: &DampingQuestion, mass: f64) -> Result<DampingReport, StudyError> {
    question.refuse_limit()?;
    question.refuse_unread()?;
    require_stiffness(question)?;
    let options = question.export_options();
    let body_alone = options.own_mass.map(|alone| compare_with_body_mass(question, alone, mass));
    let is_moment = options.stop == Some(StopMotion::Turn);
    let record = damper(question, mass)?;
    Ok(DampingReport {
        schema: "percuss.damp/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: Vec::new(),
        effective_mass: mass,
        unit: mass_unit(is_moment),
        is_moment,
        named_contact: None,
        stop: None,
        drift: None,
        over_stroke: None,
        body_alone,
        exports: exports(question, mass, options, is_moment)?,
        diagnostics: law_mismatch_diagnostic(question)
            .into_iter()
            .chain(beyond_curve(question.stiffness_curve.as_ref(), record.max_penetration))
            .collect(),
        damper: record,
        question: question.clone(),
    })
}

/// Refuses a question without a stiffness and without a force curve.
pub(crate) fn require_stiffness(question: &DampingQuestion) -> Result<(), StudyError> {
    if question.has_stiffness() {
        return Ok(());
    }
    let why = "it is missing; expected the stiffness of the contact, or a force curve (of a stop in a suspension sheet, or given)";
    Err(StudyError::input("damping.stiffness", why))
}

/// Warning about a penetration beyond the end of the force curve.
pub(crate) fn beyond_curve(
    curve: Option<&GivenCurve>,
    max_penetration: Option<f64>,
) -> Option<DiagnosticRecord> {
    let (depth, force) = curve?.curve.end();
    let reached = max_penetration.filter(|reached| *reached > depth)?;
    let message = format!(
        "the penetration of {:.2} mm is beyond the end of the force curve ({force:.0} N at {:.2} mm); the last slope is extrapolated, but a real \
         stop becomes stiffer",
        1e3 * reached,
        1e3 * depth
    );
    Some(Finding::about_result(FindingKind::ForceBeyondData, message).into())
}
