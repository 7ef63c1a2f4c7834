//! Effective mass at one contact of a model, optionally with the damper for a restitution.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::damped_contact::damping_report;
use crate::evaluation::named_contact::{NamedContactRecord, named_contact};
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::model::loading::Model;
use crate::question::damping_question::DampingQuestion;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::reports::drawing::drawn_mechanism::{DrawnMechanism, draw_evaluated};
use crate::reports::mass_report::MassReport;
use crate::reports::motion_ratio::{MotionRatioRecord, motion_ratios};
use crate::thresholds::{FAR_TOUCH, SLOW_STOP, TOUCH_WRONG_WAY};

/// Evaluates one contact of a model.
///
/// # Errors
/// [`StudyError`]: unknown names, unreachable positions, an invalid contact.
pub fn mass(model: &Model, question: &MassQuestion) -> Result<MassReport, StudyError> {
    build_mass_report(&EvaluatedQuestion::new(model, question)?)
}

/// Report without a damper, with the requested motion ratios.
pub(crate) fn build_mass_report(evaluated: &EvaluatedQuestion) -> Result<MassReport, StudyError> {
    let motion_ratios = motion_ratios(evaluated, &evaluated.prepared.question.ratio_at)?;
    let named_contact = named_contact(evaluated)?;
    let mut report = MassReport::of(evaluated);
    let found = named_contact.iter().flat_map(|contact| stop_findings(contact, &motion_ratios));
    report.diagnostics.extend(found.map(Into::into));
    Ok(MassReport { motion_ratios, named_contact, ..report })
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
    with_damper(&EvaluatedQuestion::new(model, question)?, damping)
}

/// Same as [`mass_with_damper`] (or [`mass()`] without `damping`), with the drawing of the mechanism at the
/// pose.
///
/// # Errors
/// As for [`mass_with_damper`].
pub fn mass_with_drawing(
    model: &Model,
    question: &MassQuestion,
    damping: Option<&DampingQuestion>,
) -> Result<(MassReport, DrawnMechanism), StudyError> {
    let evaluated = EvaluatedQuestion::new(model, question)?;
    let report = match damping {
        Some(damping) => with_damper(&evaluated, damping)?,
        None => build_mass_report(&evaluated)?,
    };
    Ok((report, draw_evaluated(&evaluated)))
}

/// Report with a damper, or with the reason for a missing one.
fn with_damper(evaluated: &EvaluatedQuestion, damping: &DampingQuestion) -> Result<MassReport, StudyError> {
    let mut report = build_mass_report(evaluated)?;
    match damping_report(evaluated, damping) {
        Ok(mut damper) => {
            let found = std::mem::take(&mut damper.diagnostics);
            report.diagnostics.retain(|own| !found.contains(own));
            report.diagnostics.extend(found);
            report.damper = Some(damper);
        }
        Err(error @ (StudyError::NoDamper { .. } | StudyError::BranchMassesDiffer { .. })) => {
            report.diagnostics.push(Finding::about_result(FindingKind::NoDamper, error.to_string()).into());
        }
        Err(error) => return Err(error),
    }
    Ok(report)
}

/// Findings about the way to the touch: a bump stop that touches while the wheel moves down, or a rebound stop while it moves
/// up; a long travel; a stop that hardly closes. Each has a common cause in the sheet.
fn stop_findings(contact: &NamedContactRecord, ratios: &[MotionRatioRecord]) -> Vec<Finding> {
    let mut found = Vec::new();
    let (true, Some(wheel)) = (contact.brought_to_touch, contact.wheel_travel.first()) else { return found };
    let (name, millimetres) = (&contact.name, 1e3 * wheel.travel.abs());
    let ways = [("bump_stop", 1.0, "down"), ("rebound_stop", -1.0, "up")];
    for (stop, sign, sense) in ways.into_iter().filter(|(stop, ..)| name.starts_with(stop)) {
        let other = ways.iter().find(|(other, ..)| *other != stop).map_or("", |(other, ..)| other);
        if sign * wheel.travel < -TOUCH_WRONG_WAY {
            let message = format!(
                "{name} touches after the wheel has moved {sense} by {millimetres:.0} mm: is it the {other}, or are its pad and \
                 face exchanged, or its direction reversed?"
            );
            found.push(Finding::about_result(FindingKind::WrongWayStop, message));
        }
    }
    if wheel.travel.abs() > FAR_TOUCH {
        let message = format!(
            "{name} touches after {millimetres:.0} mm of wheel travel: check its gap with the unit, its points and its direction"
        );
        found.push(Finding::about_result(FindingKind::FarContactTravel, message));
    }
    let closing =
        ratios.iter().find(|ratio| ratio.link == wheel.link).and_then(|ratio| ratio.contact_per_wheel);
    if let Some(closing) = closing.map(f64::abs).filter(|closing| *closing < SLOW_STOP) {
        let message = format!(
            "{name} closes by {closing:.2} mm per millimetre of wheel travel: does its direction follow the motion of its pad?"
        );
        found.push(Finding::about_result(FindingKind::SlowStop, message));
    }
    found
}
