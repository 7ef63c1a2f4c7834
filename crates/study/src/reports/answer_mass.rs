//! Effective mass at one contact of a model, optionally with the damper for a restitution.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::compliance::{compliance, has_elastic_joints};
use crate::damper::damped_contact::damping_report;
use crate::damper::simulators::ExportRecord;
use crate::evaluation::certificate::mass_certificate;
use crate::evaluation::friction_thresholds::thresholds_of;
use crate::evaluation::named_contact::{NamedContactRecord, named_contact};
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::evaluation::status::Status;
use crate::model::loading::Model;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::damping::DampingQuestion;
use crate::question::tables::mass::MassOptions;
use crate::reports::drawing::drawn_mechanism::{DrawnMechanism, draw_evaluated};
use crate::reports::explain::explain_parts;
use crate::reports::mass_report::{MassReport, OtherBaseRecord, base_name};
use crate::reports::motion_ratio::{MotionRatioRecord, motion_ratios};
use crate::reports::tolerance::tolerances_of;
use crate::thresholds::{FAR_TOUCH, STOP_ALIGNMENT, TOUCH_WRONG_WAY};
use percuss_contact::ContactLawError;
use percuss_contact::exports::ExportError;
use percuss_dynamics::{Base, PointVelocity};
use percuss_suspension::kinematics::wheel_centres;

/// Evaluates one contact of a model.
///
/// # Errors
/// [`StudyError`]: unknown names, unreachable positions, an invalid contact.
pub fn mass(model: &Model, question: &MassQuestion) -> Result<MassReport, StudyError> {
    let evaluated = EvaluatedQuestion::new(model, question)?;
    with_compliance(build_mass_report(&evaluated)?, &evaluated, None)
}

/// Report with the compliance of bushes. `damping`: contact whose stiffness is judged.
fn with_compliance(
    mut report: MassReport,
    evaluated: &EvaluatedQuestion,
    damping: Option<&DampingQuestion>,
) -> Result<MassReport, StudyError> {
    let (compliance, finding) = compliance(evaluated, damping)?;
    if compliance.is_some() || finding.is_some() {
        report.diagnostics.retain(|found| !FindingKind::ELASTIC.iter().any(|kind| kind.code() == found.code));
    }
    report.diagnostics.extend(finding.map(Into::into));
    Ok(MassReport { compliance, ..report })
}

/// Report without a damper, with the requested motion ratios.
pub(crate) fn build_mass_report(evaluated: &EvaluatedQuestion) -> Result<MassReport, StudyError> {
    let motion_ratios = motion_ratios(evaluated, &evaluated.prepared.question.ratio_at)?;
    let named_contact = named_contact(evaluated)?;
    let mut report = MassReport::of(evaluated);
    let found = named_contact.iter().flat_map(|contact| stop_findings(evaluated, contact, &motion_ratios));
    // At another pose a rocker may have passed its dead centre.
    let drawn = named_contact.iter().filter(|_| !evaluated.prepared.question.gives_pose());
    let found = found.chain(drawn.filter_map(|contact| extension_finding(contact, &motion_ratios)));
    report.diagnostics.extend(found.map(Into::into));
    Ok(MassReport { motion_ratios, named_contact, other_base: other_base(evaluated)?, ..report })
}

/// m̄ of a suspension with the other kind of base, at the same pose; `None` for other models, and for a chassis without mass.
fn other_base(evaluated: &EvaluatedQuestion) -> Result<Option<OtherBaseRecord>, StudyError> {
    let question = &evaluated.prepared.question;
    let mechanism = &evaluated.prepared.model.mechanism;
    let root = mechanism.link(mechanism.root());
    let has_mass = root.inertial().is_some_and(|inertial| inertial.mass > 0.0);
    if !has_mass || wheel_centres(mechanism, "").is_empty() {
        return Ok(None);
    }
    let base = match question.base {
        Base::Fixed => Base::Floating,
        Base::Floating => Base::Fixed,
    };
    let other = MassQuestion { base, ..question.clone().into_owned() };
    let result = EvaluatedQuestion::new(evaluated.prepared.model, &other)?.result;
    let (status, effective_mass) = Status::classify(result.response.effective_mass);
    Ok(Some(OtherBaseRecord {
        base: base_name(base),
        link: root.name().to_owned(),
        effective_mass,
        effective_mass_error: result.response.effective_mass_error(),
        status,
    }))
}

/// Evaluates one contact of a model and the damper for a restitution. The report has no damper, and a warning,
/// if m̄ is not finite or depends on the branch.
///
/// # Errors
/// [`StudyError`], as for [`mass()`]; a restitution or a stiffness out of range.
pub fn mass_with_damper(
    model: &Model,
    question: &MassQuestion,
    damping: &DampingQuestion,
) -> Result<MassReport, StudyError> {
    let evaluated = EvaluatedQuestion::new(model, question)?;
    with_compliance(with_damper(&evaluated, damping)?, &evaluated, Some(damping))
}

/// Effective mass with all results that a study requests for its contact: the damper, the sensitivities, the thresholds of friction and the
/// effects of tolerances. The contact is evaluated once.
///
/// # Errors
/// As for [`mass_with_damper`] and [`tolerance_report`](crate::tolerance_report); thresholds of friction for a moment.
pub fn requested_mass(
    model: &Model,
    question: &MassQuestion,
    damping: Option<&DampingQuestion>,
    requested: &MassOptions,
) -> Result<MassReport, StudyError> {
    requested_report(&EvaluatedQuestion::new(model, question)?, question, damping, requested)
}

/// Same as [`requested_mass`], with the drawing of the mechanism at the pose.
///
/// # Errors
/// As for [`requested_mass`].
pub fn mass_with_drawing(
    model: &Model,
    question: &MassQuestion,
    damping: Option<&DampingQuestion>,
    requested: &MassOptions,
) -> Result<(MassReport, DrawnMechanism), StudyError> {
    let evaluated = EvaluatedQuestion::new(model, question)?;
    let report = requested_report(&evaluated, question, damping, requested)?;
    Ok((report, draw_evaluated(&evaluated)))
}

/// Report with all requested results at the evaluated contact of `question`.
fn requested_report(
    evaluated: &EvaluatedQuestion,
    question: &MassQuestion,
    damping: Option<&DampingQuestion>,
    requested: &MassOptions,
) -> Result<MassReport, StudyError> {
    requested.check()?;
    let mut report = match damping {
        Some(damping) if damping.restitution.is_some() => with_damper(evaluated, damping)?,
        Some(damping) if !has_elastic_joints(evaluated) => return Err(damping.restitution_missing().into()),
        _ => build_mass_report(evaluated)?,
    };
    report = with_compliance(report, evaluated, damping)?;
    if requested.certify {
        report.certificate = Some(mass_certificate(evaluated));
    }
    if requested.explain {
        report.explanation = explain_parts(evaluated, question, true);
    }
    if requested.friction_thresholds {
        report.friction_thresholds = thresholds_of(evaluated)?;
    }
    if let Some(tolerance) = requested.tolerance() {
        report.tolerance = tolerances_of(evaluated, question, tolerance, requested.sampling())?;
    }
    Ok(report)
}

/// Report with a damper, or with the reason for a missing one.
fn with_damper(evaluated: &EvaluatedQuestion, damping: &DampingQuestion) -> Result<MassReport, StudyError> {
    let mut report = build_mass_report(evaluated)?;
    let mut answer = damping_report(evaluated, damping);
    // The only requested simulator does not support this contact: the report keeps the mass and the damper.
    if let (Err(StudyError::Export(error)), [tool]) = (&answer, &damping.tools()[..])
        && !matches!(**error, ExportError::Contact(ContactLawError::OutOfRange { .. }))
    {
        let (name, record) = (tool.name(), ExportRecord::from_error(*tool, error));
        let finding = Finding::about_result(FindingKind::NoDamper, error.to_string());
        report.diagnostics.push(finding.into());
        let without_tools = DampingQuestion { tools: Vec::new(), ..damping.clone() };
        answer = damping_report(evaluated, &without_tools).map(|mut damper| {
            damper.exports.insert(name, record);
            damper
        });
    }
    match answer {
        Ok(mut damper) => {
            let found = std::mem::take(&mut damper.diagnostics);
            report.diagnostics.retain(|own| !found.contains(own));
            report.diagnostics.extend(found);
            report.damper = Some(damper);
        }
        Err(error @ StudyError::NoDamper(_)) => {
            report.diagnostics.push(Finding::about_result(FindingKind::NoDamper, error.to_string()).into());
        }
        Err(error) => return Err(error),
    }
    Ok(report)
}

/// Finding about a spring or damper that extends while the wheel moves up.
fn extension_finding(contact: &NamedContactRecord, ratios: &[MotionRatioRecord]) -> Option<Finding> {
    let wheel = contact.wheel_travel.first().filter(|_| contact.always_touches())?;
    let ratio = ratios.iter().find(|ratio| ratio.link == wheel.link)?.contact_per_wheel?;
    let message = format!(
        "the {} {} extends while the wheel moves up (motion ratio {ratio:.3}): are its two points exchanged?",
        contact.kind, contact.name
    );
    (ratio < 0.0).then(|| Finding::about_result(FindingKind::ExtendingElement, message))
}

/// Findings about the path to the touch: a bump stop that touches while the wheel moves down, or a rebound stop while it moves
/// up; a long travel; a pad that hardly moves along the direction of the stop. Each has a common cause in the sheet.
fn stop_findings(
    evaluated: &EvaluatedQuestion,
    contact: &NamedContactRecord,
    ratios: &[MotionRatioRecord],
) -> Vec<Finding> {
    let mut found = Vec::new();
    let (true, Some(wheel)) = (contact.brought_to_touch, contact.wheel_travel.first()) else { return found };
    let (name, travel) = (&contact.name, contact.unit.text(wheel.travel.abs()));
    let mut warn = |kind, message| found.push(Finding::about_result(kind, message));
    // The gap closes on the whole path; a wheel that moves back at its end has passed a dead centre.
    let ratio =
        ratios.iter().find(|ratio| ratio.link == wheel.link).and_then(|ratio| ratio.contact_per_wheel);
    if ratio.is_some_and(|ratio| ratio * wheel.travel < 0.0) && wheel.travel.abs() > TOUCH_WRONG_WAY {
        let message = format!(
            "{name} touches after {travel} of wheel travel, while the wheel moves back: the suspension passes a dead centre before the \
             touch; check the gap, the points and the direction of the stop"
        );
        warn(FindingKind::BehindDeadCentre, message);
    }
    let stops = [("bump_stop", "rebound_stop", 1.0, "down"), ("rebound_stop", "bump_stop", -1.0, "up")];
    for (stop, other, sign, sense) in stops {
        if name.starts_with(stop) && sign * wheel.travel < -TOUCH_WRONG_WAY {
            let message = format!(
                "{name} touches after the wheel has moved {sense} by {travel}: is it the {other}, or are its pad and \
                 face exchanged, or its direction reversed?"
            );
            warn(FindingKind::WrongWayStop, message);
        }
    }
    if wheel.travel.abs() > FAR_TOUCH {
        let message = format!(
            "{name} touches after {travel} of wheel travel: check its gap with the unit, its points and its direction"
        );
        warn(FindingKind::FarContactTravel, message);
    }
    if let Some(cosine) = alignment(evaluated).filter(|cosine| *cosine < STOP_ALIGNMENT) {
        let message = format!(
            "the pad of {name} moves at {:.0}° to the direction of the stop: check this direction and the points of the stop",
            cosine.acos().to_degrees()
        );
        warn(FindingKind::ObliqueStop, message);
    }
    found
}

/// Cosine of the angle between the normal of a contact and the motion of the contact point relative to the other side: its
/// inverse is the relative speed per unit closing speed. `None` if a velocity is undetermined.
fn alignment(evaluated: &EvaluatedQuestion) -> Option<f64> {
    let EvaluatedQuestion { pose, contact, result, .. } = evaluated;
    let at = pose.link(contact.link).point(&contact.point);
    let velocity = |link| {
        let point = pose.link(link).inverse_point(&at);
        match pose.point_velocity(result.mechanism_response(), link, &point)? {
            PointVelocity::Known(velocity) => Some(velocity),
            PointVelocity::Undetermined => None,
        }
    };
    let mut relative = velocity(contact.link)?;
    if let Some(other) = contact.against {
        relative -= velocity(other)?;
    }
    Some(1.0 / relative.norm())
}
