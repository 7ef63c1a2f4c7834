//! A normal along a line between two points, watched over the rows of a travel: where the points come past each other it turns
//! round, and is no longer that of what they stand for.

use crate::answer::Prepared;
use crate::field::{Field, Names};
use crate::finding::{Finding, Subject};
use crate::thresholds::{LINE_TURNED, SHORTEST_DIRECTION};
use nalgebra::Vector3;
use percuss_dynamics::{Contact, Direction, Pose};
use percuss_mechanism::LinkId;

/// The line of a contact where its travel begins.
#[derive(Debug)]
pub(crate) struct TurnedLine {
    contact: Contact,
    toward: (LinkId, Vector3<f64>),
    /// Unit vector in the frame of the other side.
    first: Vector3<f64>,
    finding: Finding,
}

impl TurnedLine {
    /// Of a contact whose normal is a line; none where it is given, or has no length there.
    pub fn new(prepared: &Prepared, start: &Pose, contact: &Contact) -> Option<Self> {
        let Direction::Toward(link, point) = contact.normal else { return None };
        let first = along(contact, (link, point), start)?;
        let mechanism = prepared.system.mechanism();
        let names = prepared.question.names;
        let name = |link: LinkId| mechanism.link(link).name();
        let [x, y, z] = [first.x, first.y, first.z].map(|x| (x * 1e6).round() / 1e6 + 0.0);
        let (frame, other) = match contact.against {
            Some(against) => ("against", format!("\"{}\"", name(against))),
            None => ("world", "the ground".to_owned()),
        };
        let given = match names {
            Names::Flags => format!("--normal {x},{y},{z} --normal-frame {frame}"),
            Names::Keys => format!("normal = [{x}, {y}, {z}] with normal_frame = \"{frame}\""),
            Names::Fields => format!("the normal ({x}, {y}, {z}) in the frame {frame}"),
        };
        let message = format!(
            "the line from \"{}\" to \"{}\"{} has turned by more than 30° from where the travel is 0: where its points come past \
             each other, it is no longer the normal of a stop. One that keeps to {other}: {given}",
            name(contact.link),
            name(link),
            Field::AlongLine.hint(names),
        );
        let finding = Finding::warning("line-turned", Subject::Link(contact.link), message);
        Some(Self { contact: *contact, toward: (link, point), first, finding })
    }

    /// What is to be said at a pose.
    pub fn at(&self, pose: &Pose) -> Option<Finding> {
        let now = along(&self.contact, self.toward, pose)?;
        (now.dot(&self.first) < LINE_TURNED).then(|| self.finding.clone())
    }
}

/// The line's unit vector in the frame of the other side.
fn along(contact: &Contact, (link, point): (LinkId, Vector3<f64>), pose: &Pose) -> Option<Vector3<f64>> {
    let line = pose.link(link).point(&point) - pose.link(contact.link).point(&contact.point);
    let unit = line.try_normalize(SHORTEST_DIRECTION)?;
    Some(contact.against.map_or(unit, |against| pose.link(against).inverse_vector(&unit)))
}
