//! A mechanism at the pose of an answer, as lines to draw: where its links are, what they contribute, how they move.

use crate::answer::Answered;
use percuss_dynamics::PointVelocity;
use percuss_mechanism::LinkId;
use percuss_spatial::Vector3;

/// A link as lines, in the world, m.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnLink {
    /// Its name.
    pub name: String,
    /// Its contribution to the effective mass; none unless that is finite.
    pub share: Option<f64>,
    /// From the middle of its joints, loops, centre of mass and, of the links in contact, the contact point to each of these.
    pub lines: Vec<[[f64; 3]; 2]>,
    /// Its centre of mass; none without mass.
    pub com: Option<[f64; 3]>,
    /// v* of the centre of mass over the ground: m/s per unit closing speed; none where it is not determined.
    pub velocity: Option<[f64; 3]>,
}

/// Every link but those without extent.
pub(crate) fn drawn(answered: &Answered) -> Vec<DrawnLink> {
    let Answered { prepared, pose, answer, .. } = answered;
    let mechanism = &prepared.model.mechanism;
    let response = &answer.response;
    let shares = response.contributions.as_ref();
    let mut places: Vec<Vec<Vector3<f64>>> = vec![Vec::new(); mechanism.links().len()];
    for joint in mechanism.joints() {
        // The child's frame is where the joint is.
        let at = pose.link(joint.child()).point(&Vector3::zeros());
        places[joint.child().index()].push(at);
        let before = pose.link(joint.parent()).point(&joint.origin().point(&Vector3::zeros()));
        places[joint.parent().index()].push(before);
    }
    for closure in mechanism.closures() {
        for end in [closure.predecessor(), closure.successor()] {
            let Some(link) = end.link else { continue };
            let at = pose.link(link).point(&end.frame.point(&Vector3::zeros()));
            places[link.index()].push(at);
        }
    }
    let contact = &response.contact;
    places[contact.link.index()].push(contact.point_world);
    if let Some(against) = contact.against {
        places[against.index()].push(contact.point_world);
    }
    let of_link = |id: LinkId| {
        let link = mechanism.link(id);
        let inertial = link.inertial().filter(|inertial| inertial.mass > 0.0);
        let com = inertial.map(|inertial| pose.link(id).point(&inertial.com));
        let mut ends = places[id.index()].clone();
        ends.extend(com);
        let middle = ends.iter().sum::<Vector3<f64>>() / ends.len().max(1) as f64;
        let mut lines: Vec<[[f64; 3]; 2]> = match ends[..] {
            [a, b] => vec![[a.into(), b.into()]],
            _ => ends.iter().map(|end| [middle.into(), (*end).into()]).collect(),
        };
        lines.retain(|[a, b]| a != b);
        let velocity = inertial.and_then(|inertial| {
            match pose.point_velocity_over_ground(response, id, &inertial.com)? {
                PointVelocity::Known(v) => Some(pose.base().vector(&v).into()),
                PointVelocity::Undetermined => None,
            }
        });
        DrawnLink {
            name: link.name().to_owned(),
            share: shares.and_then(|s| s.links.get(id.index()).copied()),
            lines,
            com: com.map(Into::into),
            velocity,
        }
    };
    // The root is the ground, as long as it does not move.
    let is_drawn = |id: &LinkId| *id != mechanism.root() || shares.is_some_and(|s| s.links[id.index()] > 0.0);
    mechanism.link_ids().filter(is_drawn).map(of_link).filter(|link| !link.lines.is_empty()).collect()
}
