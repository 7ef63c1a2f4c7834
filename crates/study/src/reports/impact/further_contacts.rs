//! Further contacts of an impact at its pose, and warnings about joints that are not at their stops.

use crate::checks::finding::Finding;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::evaluation::stop_not_reached::stop_not_reached;
use crate::pose::touch::StopOfJoint;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::field::Field;
use crate::question::spelled_contact::FurtherContact;
use crate::reports::impact::question::ImpactQuestion;
use percuss_dynamics::{Contact, Direction, Frame, Gap};
use percuss_spatial::Vector3;

/// Further contact of an impact at a pose.
pub(crate) struct TouchingContact {
    /// Name in the report.
    pub name: String,
    /// The contact.
    pub contact: Contact,
    /// Gap of a named contact, m; distance of a joint from its stop, rad or m; `None` for other contacts.
    pub gap: Option<f64>,
    is_joint_stop: bool,
}

impl TouchingContact {
    /// Finds the links and joints of a further contact.
    ///
    /// # Errors
    /// Unknown names; the stop of a joint that has several velocities, or none.
    pub fn new(evaluated: &EvaluatedQuestion, contact: &FurtherContact) -> Result<Self, StudyError> {
        let pose = &evaluated.pose;
        let mechanism = pose.mechanism();
        let find =
            |name: &String| mechanism.find_link(name).map_err(|error| StudyError::input(Field::Also, error));
        let sides = |link: &String, against: &Option<String>| match against {
            Some(other) => format!("{link} against {other}"),
            None => link.clone(),
        };
        let touching = |name, contact| Self { name, contact, gap: None, is_joint_stop: false };
        match contact {
            FurtherContact::Named(name) => {
                let named =
                    mechanism.find_contact(name).map_err(|error| StudyError::input(Field::Also, error))?;
                let gap = Gap::new(pose, named).map(|gap| gap.at(pose));
                let contact = Contact::named(named, mechanism.root());
                Ok(Self { name: name.clone(), contact, gap, is_joint_stop: false })
            }
            FurtherContact::Point { link, point, normal, against } => {
                let normal = Direction::Along(Vector3::from(*normal), Frame::World);
                let other = against.as_ref().map(find).transpose()?;
                let contact =
                    Contact { link: find(link)?, against: other, point: Vector3::from(*point), normal };
                Ok(touching(sides(link, against), contact))
            }
            FurtherContact::Moment { link, axis, against } => {
                let contact = Contact::about_axis(find(link)?, *axis);
                let contact = Contact { against: against.as_ref().map(find).transpose()?, ..contact };
                Ok(touching(format!("moment on {}", sides(link, against)), contact))
            }
            FurtherContact::Cable { link, point, other, end } => {
                let contact = Contact::cable(find(link)?, *point, find(other)?, *end);
                Ok(touching(format!("cable {link} to {other}"), contact))
            }
            FurtherContact::JointStop { joint, is_upper } => {
                let id =
                    mechanism.find_joint(joint).map_err(|error| StudyError::input(Field::Also, error))?;
                let declared = mechanism.joint(id);
                let contact = Contact::joint_stop(mechanism, id, *is_upper).ok_or_else(|| {
                    StudyError::input(
                        Field::Also,
                        Fault::NoStop { joint: joint.clone(), kind: declared.kind() },
                    )
                })?;
                let gap = StopOfJoint::new(mechanism, id, *is_upper).map(|stop| stop.distance(pose));
                Ok(Self { name: format!("stop of {joint}"), contact, gap, is_joint_stop: true })
            }
        }
    }

    /// Refuses a plastic impact with sticking contact points if this contact has no contact point.
    pub fn refuse_sticking(&self) -> Result<(), StudyError> {
        let contact = match self.contact.normal {
            _ if self.is_joint_stop => "the stop of a joint",
            Direction::About(..) => "a moment about an axis",
            Direction::TurningToward(..) | Direction::TurningAwayFrom(..) => "a cable, a spring or a rod",
            Direction::Along(..) | Direction::Toward(..) => return Ok(()),
        };
        let fault = Fault::NoContactPoint { contact, result: "sticking contact point" };
        Err(StudyError::input(Field::Sticking, fault))
    }
}

/// Warnings about joints that are not at their stops, for the joint stops among the further contacts.
pub(crate) fn stop_findings(evaluated: &EvaluatedQuestion, question: &ImpactQuestion) -> Vec<Finding> {
    let (pose, names) = (&evaluated.pose, evaluated.prepared.question.names);
    let mechanism = pose.mechanism();
    let stop = |further: &FurtherContact| match further {
        FurtherContact::JointStop { joint, is_upper } => {
            StopOfJoint::new(mechanism, mechanism.find_joint(joint).ok()?, *is_upper)
        }
        _ => None,
    };
    let stops = question.also.iter().filter_map(stop);
    stops.filter_map(|stop| stop_not_reached(pose, &stop, names)).collect()
}
