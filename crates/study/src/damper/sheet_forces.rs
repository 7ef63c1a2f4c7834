//! Forces of a suspension sheet at a contact: the curve of its stop, springs and dampers.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::damping::{DamperRecord, contact, contact_damper};
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::model::loading::Model;
use crate::question::errors::question_error::StudyError;
use crate::question::errors::refusal::InvalidKey;
use crate::question::field::Field;
use crate::question::tables::damping::DampingQuestion;
use crate::thresholds::SPRING_EFFECT;
use crate::values::force_curve::GivenCurve;
use percuss_contact::{DamperCurve, restitution_beside_forces};
use percuss_dynamics::PointVelocity;
use percuss_mechanism::{ContactKind, ContactNormal, LinkId};
use percuss_spatial::Vector3;
use percuss_suspension::SpringForce;
use std::sync::Arc;

/// Spring or damper of a sheet: named contact, and ends (link, and point in its axes, m).
pub(crate) struct SheetElement<'a> {
    pub name: &'a str,
    pub ends: [(LinkId, Vector3<f64>); 2],
    pub force: ElementForce,
}

/// Force of a spring or a damper.
pub(crate) enum ElementForce {
    Spring(SpringForce),
    Damper(Arc<DamperCurve>),
}

/// Section of the sheet with the name of a contact, which can end in the side.
fn section(name: &str) -> &str {
    name.strip_suffix("_left").or(name.strip_suffix("_right")).unwrap_or(name)
}

/// Springs with a rate and dampers with a curve in the suspension sheet of a model.
pub(crate) fn sheet_elements(model: &Model) -> Vec<SheetElement<'_>> {
    let Some(sheet) = model.origin.sheet.as_deref() else { return Vec::new() };
    let forces = &sheet.understood.forces;
    let mechanism = &model.mechanism;
    let element = |contact: &'_ percuss_mechanism::NamedContact| {
        let (ContactNormal::Toward(other) | ContactNormal::Away(other)) = *contact.normal() else {
            return None;
        };
        let section = section(contact.name());
        let force = match contact.kind() {
            ContactKind::Spring => {
                let (_, spring) = forces.springs.iter().find(|(name, _)| name == section)?;
                ElementForce::Spring(Some(*spring).filter(|spring| spring.rate > 0.0)?)
            }
            ContactKind::Damper => {
                let (_, damper) = forces.dampers.iter().find(|(name, _)| name == section)?;
                ElementForce::Damper(Arc::clone(damper))
            }
            _ => return None,
        };
        let against = contact.against().unwrap_or(mechanism.root());
        Some(([(contact.link(), *contact.point()), (against, other)], force))
    };
    let found = mechanism.contacts().iter().filter_map(|contact| {
        let (ends, force) = element(contact)?;
        Some(SheetElement { name: contact.name(), ends, force })
    });
    found.collect()
}

/// Warning about springs and dampers of the sheet that act during the contact, with both restitutions. To first order they act on the contact
/// as the change Σ k i² x of the spring forces since the touch and the damper forces Σ i F(i ẋ); i is the change of the length per penetration.
pub(crate) fn springs_finding(
    evaluated: &EvaluatedQuestion,
    damping: &DampingQuestion,
    mass: f64,
    record: &DamperRecord,
) -> Result<Option<Finding>, StudyError> {
    let EvaluatedQuestion { prepared, pose, result, .. } = evaluated;
    let (Some(speed), Some(duration)) = (damping.speed(), record.contact_duration) else { return Ok(None) };
    if result.response.contact.is_moment {
        return Ok(None);
    }
    let ratio = |element: &SheetElement| {
        let [a, b] = element.ends.map(|(link, point)| pose.link(link).point(&point));
        let line = pose.base().inverse_vector(&(b - a).try_normalize(0.0)?);
        let [va, vb] = element.ends.map(|(link, point)| {
            match pose.point_velocity_over_ground(result.mechanism_response(), link, &point)? {
                PointVelocity::Known(velocity) => Some(velocity),
                PointVelocity::Undetermined => None,
            }
        });
        Some(line.dot(&(vb? - va?)))
    };
    let elements = sheet_elements(prepared.model);
    let acting: Vec<(f64, &SheetElement)> = elements
        .iter()
        .filter_map(|element| Some((ratio(element)?, element)))
        .filter(|(ratio, _)| *ratio != 0.0)
        .collect();
    if acting.is_empty() {
        return Ok(None);
    }
    let beside = |x: f64, v: f64| -> f64 {
        let force = |(i, element): &(f64, &SheetElement)| match &element.force {
            ElementForce::Spring(spring) => spring.rate * i * i * x,
            ElementForce::Damper(curve) => i * curve.force(i * v),
        };
        acting.iter().map(force).sum()
    };
    let compliant = contact(damping, mass)?;
    let beside = restitution_beside_forces(contact_damper(damping, compliant)?, compliant, speed, &beside)?;
    let alone = record.achieved_restitution;
    let message = match beside {
        Some(e) if (e - alone).abs() <= SPRING_EFFECT => return Ok(None),
        Some(e) => format!("the restitution is about {e:.3} in place of {alone:.3}"),
        None => format!("the contact does not end; without them the restitution is {alone:.3}"),
    };
    let names: Vec<&str> = acting.iter().map(|(_, element)| element.name).collect();
    let message = format!(
        "the contact lasts {:.1} ms, in which springs and dampers of the sheet act ({}): {message}; an impact in time includes them",
        1e3 * duration,
        names.join(", "),
    );
    Ok(Some(Finding::about_result(FindingKind::SpringsAct, message)))
}

/// Question with the force curve of the stop in the suspension sheet, if neither a stiffness nor a curve is given; a note about the default
/// law, or about a curve that is not used.
pub(crate) fn with_sheet_curve(
    evaluated: &EvaluatedQuestion,
    damping: &DampingQuestion,
) -> Result<(DampingQuestion, Option<Finding>), StudyError> {
    let mut damping = damping.clone();
    let of_sheet = sheet_curve(evaluated)?.filter(|_| damping.options.stop.is_none());
    let finding = match of_sheet {
        Some(given) if damping.has_stiffness() => (damping.stiffness_curve.as_ref() != Some(&given)).then(|| {
            let name = given.stop.as_deref().unwrap_or_default();
            let message = format!(
                "the force curve of {name} in the sheet is not used, because a stiffness or another curve is given{}",
                Field::Stiffness.hint(evaluated.prepared.question.names)
            );
            Finding::about_result(FindingKind::CurveNotUsed, message)
        }),
        Some(given) => {
            damping.stiffness_curve = Some(given);
            // Exponent and alias with an exponent belong to a stiffness.
            if damping.exponent.is_some() {
                let why = "it is the exponent of a stiffness, but the force curve of the sheet is used; give `stiffness` too";
                return Err(InvalidKey::new("damping.exponent", why).into());
            }
            None
        }
        None => None,
    };
    let is_default =
        damping.stiffness_curve.is_some() && damping.law.is_none() && damping.separation.is_none();
    let finding = finding.or_else(|| {
        is_default.then(|| {
            let message = "law hunt-crossley, F = F_s(x)(1 + d ẋ) on the force curve F_s: a linear damper (kelvin-voigt) gives a soft stop its \
                           largest force at zero penetration";
            Finding::about_result(FindingKind::LawOfCurve, message.to_owned())
        })
    });
    Ok((damping, finding))
}

/// Force curve of the named contact in the suspension sheet of the model.
fn sheet_curve(evaluated: &EvaluatedQuestion) -> Result<Option<GivenCurve>, StudyError> {
    let model = evaluated.prepared.model;
    let Some(sheet) = model.origin.sheet.as_deref() else { return Ok(None) };
    let Some(contact) = evaluated.prepared.question.named_contact(&model.mechanism)? else { return Ok(None) };
    let name = contact.name();
    let stop = sheet.understood.forces.stops.iter().find(|(stop, _)| stop == section(name));
    Ok(stop.map(|(_, curve)| GivenCurve::of_stop(name, curve)))
}
