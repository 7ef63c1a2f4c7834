//! Pose at which a stop touches, for programs that use the library directly.

use crate::evaluation::named_contact::named_contact;
use crate::evaluation::passed_stops::answer_findings;
use crate::evaluation::prepared_question::{EvaluatedQuestion, PreparedQuestion};
use crate::evaluation::stop_not_reached::stop_not_reached;
use crate::model::loading::Model;
use crate::model::record::DiagnosticRecord;
use crate::pose::pose_solver;
use crate::pose::touch::StopOfJoint;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::mass_question::MassQuestion;
use crate::question::spelled_contact::FurtherContact;
use crate::question::tables::contact::PoseTable;
use crate::values::position::GivenPosition;
use percuss_dynamics::{Configuration, Contact, Pose, System};

/// Pose at which a stop touches, and its contact: the pose of the command for `--at STOP`. `stop`: name of a contact of the mechanism,
/// or the stop of a joint, `JOINT:lower` or `JOINT:upper`. A contact without a gap always touches, at the pose of the configuration.
///
/// The mechanism moves from the pose of the configuration until the gap is closed. Joints that the configuration sets keep their positions; if
/// they are all joints that move the stop, the pose is that of the configuration, and the contact has the remark
/// [`OpenGap`](percuss_dynamics::Remark::OpenGap). If both sides of a vehicle are built, the same stop of the other side touches too.
///
/// # Errors
/// [`StudyError`]: an unknown name; a stop that is out of reach, with the smallest gap; loops that do not close.
///
/// ```
/// use percuss_dynamics::{Conditions, EffectiveMass, System};
/// use percuss_formats::{LoadOptions, Source};
/// use percuss_study::{Model, pose_at_stop};
/// # use percuss_suspension::{TemplateOptions, template_sheet};
/// # let sheet = template_sheet("double-wishbone", &TemplateOptions::default()).expect("a template");
/// let model = Model::from_source(&Source::from_text("corner.toml", sheet), &LoadOptions::default())?;
/// let system = System::new(model.mechanism.clone(), &Conditions::default())?;
/// let (pose, contact) = pose_at_stop(&system, &system.configuration(), "bump_stop")?;
/// let EffectiveMass::Finite(mass) = pose.respond(&contact)?.effective_mass else { panic!("a mass") };
/// assert!((mass - 151.080_732).abs() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn pose_at_stop(
    system: &System,
    configuration: &Configuration,
    stop: &str,
) -> Result<(Pose, Contact), StudyError> {
    let mechanism = system.mechanism();
    let question = question_at_stop(system, configuration, stop)?;
    let resolved = question.resolve_contact(mechanism)?;
    let contact = match (question.named_contact(mechanism)?, question.spelled_contact(mechanism)?) {
        (Some(named), _) => Some(Contact::named(named, mechanism.root())),
        (None, Some(stop @ FurtherContact::JointStop { .. })) => Some(stop.resolve(mechanism, "contact.at")?),
        _ => None,
    };
    let contact = contact.ok_or_else(|| {
        let message = format!(
            "\"{stop}\" is no stop; expected the name of a contact, JOINT:lower or JOINT:upper; any other contact is evaluated at a \
             pose of the configuration"
        );
        StudyError::input("contact.at", message)
    })?;
    let mut at_limit = configuration.clone();
    for (joint, position) in &resolved.pose.set[question.pose.set.len()..] {
        let id = mechanism.find_joint(joint).map_err(StudyError::about("contact.at"))?;
        let refuse =
            |source| StudyError::input("contact.at", Fault::Position { joint: joint.clone(), source });
        let values = position.values_for_joint(mechanism.joint(id).kind()).map_err(refuse)?;
        at_limit.set(joint, &values).map_err(StudyError::about("contact.at"))?;
    }
    Ok((pose_solver::pose(system, &at_limit, &resolved)?, contact))
}

/// Pose at which a stop touches, its contact, and the findings of the report for `--at STOP`: about the path to the touch, such as a wheel that moves
/// the wrong way, about the pose and about the contact. `model`: that of the system.
///
/// # Errors
/// As [`pose_at_stop`].
pub fn pose_at_stop_with_findings(
    model: &Model,
    system: &System,
    configuration: &Configuration,
    stop: &str,
) -> Result<(Pose, Contact, Vec<DiagnosticRecord>), StudyError> {
    let (pose, contact) = pose_at_stop(system, configuration, stop)?;
    let question = question_at_stop(system, configuration, stop)?;
    let mut prepared = PreparedQuestion::new(model, &question)?;
    (prepared.system, prepared.configuration) = (system.clone(), configuration.clone());
    let mut result = prepared.evaluate(&pose, &contact)?;
    let of_joint = StopOfJoint::of_question(system.mechanism(), &prepared.question)?;
    let not_reached = of_joint.and_then(|stop| stop_not_reached(&pose, &stop, question.names));
    result.findings.extend(not_reached);
    let evaluated = EvaluatedQuestion { prepared, pose, contact, result };
    let named = named_contact(&evaluated)?;
    let findings = answer_findings(&evaluated, named.as_ref());
    Ok((evaluated.pose, contact, findings.into_iter().map(DiagnosticRecord::from).collect()))
}

/// Question about a stop at the set positions of a configuration.
fn question_at_stop(
    system: &System,
    configuration: &Configuration,
    stop: &str,
) -> Result<MassQuestion, StudyError> {
    let mechanism = system.mechanism();
    let name = |joint| mechanism.joint(joint).name().to_owned();
    let set = configuration.given().map(|(joint, values)| {
        let refuse = |source| StudyError::input("pose.set", Fault::Position { joint: name(joint), source });
        Ok((name(joint), GivenPosition::from_numbers(values).map_err(refuse)?))
    });
    let set = set.collect::<Result<Vec<_>, StudyError>>()?;
    Ok(MassQuestion {
        pose: PoseTable { set, ..PoseTable::default() },
        ..MassQuestion::default().at_contact(stop)
    })
}
