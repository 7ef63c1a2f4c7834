//! Effective mass at one contact of a model, optionally with the damper for a restitution.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::damped_contact::damping_report;
use crate::evaluation::named_contact::named_contact;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::model::loading::Model;
use crate::question::damping_question::DampingQuestion;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::reports::drawing::drawn_mechanism::{DrawnMechanism, draw_evaluated};
use crate::reports::mass_report::MassReport;
use crate::reports::motion_ratio::motion_ratios;

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
    Ok(MassReport { motion_ratios, named_contact, ..MassReport::of(evaluated) })
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
            report.diagnostics = std::mem::take(&mut damper.diagnostics);
            report.damper = Some(damper);
        }
        Err(error @ (StudyError::NoDamper { .. } | StudyError::BranchMassesDiffer { .. })) => {
            report.diagnostics.push(Finding::about_result(FindingKind::NoDamper, error.to_string()).into());
        }
        Err(error) => return Err(error),
    }
    Ok(report)
}
