//! Pose at which a stop touches, for programs that use the library directly.

use crate::pose::pose_solver;
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
    let name = |joint| mechanism.joint(joint).name().to_owned();
    let set = configuration.given().map(|(joint, values)| {
        let refuse = |source| StudyError::input("pose.set", Fault::Position { joint: name(joint), source });
        Ok((name(joint), GivenPosition::from_numbers(values).map_err(refuse)?))
    });
    let set = set.collect::<Result<Vec<_>, StudyError>>()?;
    let question = MassQuestion {
        pose: PoseTable { set, ..PoseTable::default() },
        ..MassQuestion::default().at_contact(stop)
    };
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
