//! Effective mass at one contact of a model, optionally with the damper for a restitution.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::compliance::{compliance, has_elastic_joints};
use crate::damper::damped_contact::damping_report;
use crate::damper::simulators::ExportRecord;
use crate::evaluation::certificate::mass_certificate;
use crate::evaluation::friction_thresholds::thresholds_of;
use crate::evaluation::motion_ratio::{requested_ratios, wheel_ratios};
use crate::evaluation::named_contact::named_contact;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::evaluation::status::Status;
use crate::model::loading::Model;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::contact::ConditionsTable;
use crate::question::tables::damping::DampingQuestion;
use crate::question::tables::mass::MassOptions;
use crate::reports::drawing::drawn_mechanism::{DrawnMechanism, draw_evaluated};
use crate::reports::explain::explain_parts;
use crate::reports::mass_report::{MassReport, OtherBaseRecord, base_name};
use crate::reports::tolerance::tolerances_of;
use percuss_contact::ContactLawError;
use percuss_contact::exports::ExportError;
use percuss_dynamics::Base;
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
    let (compliance, findings) = compliance(evaluated, damping)?;
    if compliance.is_some() || !findings.is_empty() {
        report.diagnostics.retain(|found| !FindingKind::ELASTIC.iter().any(|kind| kind.code() == found.code));
    }
    report.diagnostics.extend(findings.into_iter().map(Into::into));
    Ok(MassReport { compliance, ..report })
}

/// Report without a damper, with the requested motion ratios.
pub(crate) fn build_mass_report(evaluated: &EvaluatedQuestion) -> Result<MassReport, StudyError> {
    let mut motion_ratios = requested_ratios(evaluated, &evaluated.prepared.question.contact.ratio_at)?;
    let of_wheels = wheel_ratios(evaluated);
    let named_contact = named_contact(evaluated)?;
    let report = MassReport::of(evaluated, named_contact, &of_wheels);
    motion_ratios.extend(of_wheels);
    Ok(MassReport { motion_ratios, other_base: other_base(evaluated)?, ..report })
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
    let base = match question.conditions.base() {
        Base::Fixed => Base::Floating,
        Base::Floating => Base::Fixed,
    };
    let conditions = ConditionsTable { base: Some(base.into()), ..question.conditions.clone() };
    let other = MassQuestion { conditions, ..question.clone().into_owned() };
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

/// Effective mass with all results that a study requests for its contact: the damper, the sensitivities, the thresholds of friction and the
/// effects of tolerances. The contact is evaluated once. The report has no damper, and a warning, if m̄ is not finite or depends on the branch.
///
/// # Errors
/// As for [`mass()`] and [`tolerance_report`](crate::tolerance_report); a restitution or a stiffness out of range; thresholds of friction for
/// a moment.
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
        let without_tools = DampingQuestion {
            tools: Vec::new(),
            accuracy: None,
            time_step: None,
            other_own_mass: None,
            diagonal_ratio: None,
            ..damping.clone()
        };
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
