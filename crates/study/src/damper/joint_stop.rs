//! Stop of a joint, as a contact between the two links of the joint.

use crate::model::loading::Model;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::mass_question::MassQuestion;
use crate::question::spelled_contact::{JointStop, StopEnd, StopRecord, stop_motion};
use crate::question::tables::contact::ContactTable;
use crate::values::position::GivenPosition;
use percuss_contact::exports::StopMotion;
use percuss_dynamics::Contact;
use percuss_mechanism::{Joint, JointId, Mechanism};

impl JointStop {
    /// Stop of a joint given in `at`, and the question without `at`; `None` for another contact.
    pub(crate) fn of_question(
        question: &MassQuestion,
        mechanism: &Mechanism,
    ) -> Option<(Self, MassQuestion)> {
        question.stop_of_joint(mechanism)?;
        let stop = question.contact.at.as_ref()?.parse().ok()?;
        let contact = ContactTable { at: None, ..question.contact.clone() };
        Some((stop, MassQuestion { contact, ..question.clone() }))
    }

    /// Motion of the joint into the stop.
    ///
    /// # Errors
    /// [`StudyError`]: unknown joint; a joint without exactly one degree of freedom.
    pub fn motion(&self, model: &Model) -> Result<StopMotion, StudyError> {
        self.find(model).map(|(_, _, motion)| motion)
    }

    /// Joint of the stop, with the kind of its motion. Error: unknown joint, or a joint without a stop.
    fn find<'a>(&self, model: &'a Model) -> Result<(JointId, &'a Joint, StopMotion), StudyError> {
        let mechanism = &model.mechanism;
        let id = mechanism.find_joint(&self.joint).map_err(StudyError::about("damping.limit"))?;
        let joint = mechanism.joint(id);
        let motion = stop_motion(joint).ok_or_else(|| self.no_stop(joint))?;
        Ok((id, joint, motion))
    }

    /// Error about a joint without a stop.
    fn no_stop(&self, joint: &Joint) -> StudyError {
        StudyError::input("damping.limit", Fault::NoStop { joint: self.joint.clone(), kind: joint.kind() })
    }

    /// Contact question of the stop, [`Contact::joint_stop`]: m̄ equals 1/(e_j M_c⁻¹ e_jᵀ), the inertia (kg·m²) or mass (kg) at the
    /// joint including the loops. All other fields of the question come from `conditions`.
    ///
    /// # Errors
    /// [`StudyError`]: unknown joint; a joint without exactly one degree of freedom; an end without a limit.
    pub fn question(
        &self,
        model: &Model,
        conditions: MassQuestion,
    ) -> Result<(MassQuestion, StopRecord), StudyError> {
        let mechanism = &model.mechanism;
        let refuse = |fault: Fault| StudyError::input("damping.limit", fault);
        let (id, joint, motion) = self.find(model)?;
        let contact = Contact::joint_stop(mechanism, id, self.end != Some(StopEnd::Lower));
        let contact = contact.ok_or_else(|| self.no_stop(joint))?;
        let given = ContactTable { against_mass: None, ..conditions.contact.clone() };
        let mut question = MassQuestion { contact: given.with_contact(&contact, mechanism), ..conditions };
        if let Some(end) = self.end.filter(|_| !question.pose.set.iter().any(|(name, _)| *name == self.joint))
        {
            let limits =
                joint.limits().ok_or_else(|| refuse(Fault::NoLimit { joint: self.joint.clone() }))?;
            let at = if end == StopEnd::Lower { limits.lower } else { limits.upper };
            let position = GivenPosition::from_numbers(&[at]);
            let wrong = |source| refuse(Fault::Position { joint: self.joint.clone(), source });
            question.pose.set.push((self.joint.clone(), position.map_err(wrong)?));
        }
        Ok((question, StopRecord { joint: self.joint.clone(), motion }))
    }
}
