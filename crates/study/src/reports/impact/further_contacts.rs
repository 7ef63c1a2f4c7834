//! Further contacts of an impact at its pose, and warnings about joints that are not at their stops.

use crate::checks::finding::Finding;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::evaluation::stop_not_reached::stop_not_reached;
use crate::pose::touch::StopOfJoint;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::spelled_contact::FurtherContact;
use crate::question::tables::impact::ImpactQuestion;
use percuss_dynamics::{Contact, Direction, Gap};

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
        let resolved = contact.resolve(mechanism, "impact.also")?;
        let sides = |link: &String, against: &Option<String>| match against {
            Some(other) => format!("{link} against {other}"),
            None => link.clone(),
        };
        let mut gap = None;
        let name = match contact {
            FurtherContact::Named(name) => {
                let named = mechanism.find_contact(name).ok();
                gap = named.and_then(|named| Some(Gap::new(pose, named)?.at(pose)));
                name.clone()
            }
            FurtherContact::Point { link, against, .. } => sides(link, against),
            FurtherContact::Moment { link, against, .. } => format!("moment on {}", sides(link, against)),
            FurtherContact::Cable { link, other, .. } => format!("cable {link} to {other}"),
            FurtherContact::JointStop { joint, is_upper } => {
                let stop = mechanism.find_joint(joint).ok();
                let stop = stop.and_then(|joint| StopOfJoint::new(mechanism, joint, *is_upper));
                gap = stop.map(|stop| stop.distance(pose));
                format!("stop of {joint}")
            }
            FurtherContact::Resolved(contact) => {
                let root = mechanism.root();
                let named = mechanism.contacts().iter().find(|named| Contact::named(named, root) == *contact);
                gap = named.and_then(|named| Some(Gap::new(pose, named)?.at(pose)));
                let name = |link| mechanism.link(link).name().to_owned();
                sides(&name(contact.link), &contact.against.map(name))
            }
        };
        let is_joint_stop = matches!(contact, FurtherContact::JointStop { .. });
        Ok(Self { name, contact: resolved, gap, is_joint_stop })
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
        Err(StudyError::input("impact.sticking", fault))
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
