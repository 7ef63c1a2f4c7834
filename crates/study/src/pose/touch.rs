//! Stops that a mechanism reaches by a motion: contacts with a gap, and limits of joints whose position follows from loops.

use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::spelled_contact::FurtherContact;
use percuss_dynamics::{Gap, Pose};
use percuss_mechanism::{JointId, JointKind, Mechanism, NamedContact};
use percuss_suspension::kinematics::SIDES;

/// Stop that closes by a motion of the mechanism.
#[derive(Clone, Debug)]
pub(crate) enum Stop {
    /// Contact with a gap.
    Contact(Gap),
    /// Limit of a joint with one position.
    Joint(StopOfJoint),
}

/// Limit of a joint with one position.
#[derive(Clone, Debug)]
pub(crate) struct StopOfJoint {
    pub joint: JointId,
    pub is_upper: bool,
    /// The limit, rad or m.
    pub limit: f64,
    /// Gap per unit of the position: the characteristic length (m/rad) for a joint that turns, otherwise 1.
    pub length: f64,
}

impl Stop {
    /// Gap at a pose, m. For a joint that turns, the angle to the limit is multiplied by the characteristic length.
    pub fn gap(&self, pose: &Pose) -> f64 {
        match self {
            Stop::Contact(gap) => gap.at(pose),
            Stop::Joint(stop) => stop.length * stop.distance(pose),
        }
    }
}

impl StopOfJoint {
    /// Stop of a joint; `None` for a joint without limits, or with no or several positions.
    pub fn new(mechanism: &Mechanism, joint: JointId, is_upper: bool) -> Option<Self> {
        let declared = mechanism.joint(joint);
        let limits = declared.limits().filter(|_| declared.kind().positions() == 1)?;
        let length = match declared.kind() {
            JointKind::Prismatic => 1.0,
            _ => mechanism.characteristic_length(),
        };
        Some(Self { joint, is_upper, limit: if is_upper { limits.upper } else { limits.lower }, length })
    }

    /// Joint stop that is the contact of a question; `None` for other contacts.
    pub fn of_question(mechanism: &Mechanism, question: &MassQuestion) -> Result<Option<Self>, StudyError> {
        let spelled = question.spelled_contact(mechanism)?;
        let Some(FurtherContact::JointStop { joint, is_upper }) = spelled else { return Ok(None) };
        let Ok(joint) = mechanism.find_joint(&joint) else { return Ok(None) };
        Ok(Self::new(mechanism, joint, is_upper))
    }

    /// True if a question sets the joint to this limit.
    pub fn is_requested(&self, mechanism: &Mechanism, question: &MassQuestion) -> bool {
        let joint = mechanism.joint(self.joint);
        let mut given = question.pose.set.iter().filter(|(name, _)| name == joint.name());
        let values = given.next().and_then(|(_, given)| given.values_for_joint(joint.kind()).ok());
        values.is_some_and(|values| values == [self.limit])
    }

    /// Distance of the joint from its limit at a pose, rad or m; negative beyond the limit.
    pub fn distance(&self, pose: &Pose) -> f64 {
        let short = self.limit - pose.joint(self.joint)[0];
        if self.is_upper { short } else { -short }
    }
}

/// Stops that touch at the pose of a question, with their gaps: the stop of the question and, on a vehicle with both
/// sides, the same stop of the other side, because both wheels move up together. Empty if the contact of the question
/// is no stop, or if the question gives the pose by a travel or a file.
pub(crate) fn touching_stops<'m>(
    mechanism: &'m Mechanism,
    question: &MassQuestion,
    start: &Pose,
) -> Result<Vec<(&'m NamedContact, Gap)>, StudyError> {
    if question.gives_pose() {
        return Ok(Vec::new());
    }
    let Some(contact) = question.named_contact(mechanism)? else { return Ok(Vec::new()) };
    let stops = [Some(contact), other_side(mechanism, contact)];
    let with_gap = |stop: &'m NamedContact| Some((stop, Gap::new(start, stop)?));
    Ok(stops.into_iter().flatten().filter_map(with_gap).collect())
}

/// Contact of the same name on the other side of the vehicle.
fn other_side<'m>(mechanism: &'m Mechanism, contact: &NamedContact) -> Option<&'m NamedContact> {
    let [left, right] = SIDES;
    let other = |own: &str, other: &str| Some(format!("{}{other}", contact.name().strip_suffix(own)?));
    mechanism.find_contact(&other(left, right).or_else(|| other(right, left))?).ok()
}
