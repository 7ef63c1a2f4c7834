//! Named contacts as sites: the z-axis of a site is the normal with all joints at 0.

use super::body_tree::{BodyTree, pose_attributes};
use crate::mjcf::values::orientation::rotation_to_z;
use crate::writing::changes::Change;
use crate::writing::xml_text::escape_attribute;
use percuss_mechanism::{ContactKind, ContactNormal, NamedContact};
use percuss_spatial::Transform;

/// Adds a site for each contact, and a change for the data that a site cannot express.
pub(super) fn add_contacts(tree: &mut BodyTree<'_>) {
    let mechanism = tree.mechanism;
    for contact in mechanism.contacts() {
        let name = contact.name();
        if !tree.has_body(contact.link()) {
            let reason = "its link has no body of its own in MJCF";
            tree.changes.push(Change::lost("contact", name, "the contact", reason));
            continue;
        }
        let Some(frame) = site_frame(tree, contact) else {
            let reason = "its normal has no direction as drawn";
            tree.changes.push(Change::lost("contact", name, "the contact", reason));
            continue;
        };
        let line = format!("<site name=\"{}\"{}/>\n", escape_attribute(name), pose_attributes(&frame));
        tree.append_content(Some(contact.link()), &line);
        let is_plain = contact.kind() == ContactKind::Other
            && contact.gap().is_none()
            && contact.against().is_none_or(|other| other == mechanism.root())
            && matches!(contact.normal(), ContactNormal::Fixed(_));
        if !is_plain {
            tree.changes.push(Change::changed(
                "contact",
                name,
                "a site with the normal as drawn, without its kind, gap and other side",
                "a site of MJCF is a frame of a body",
            ));
        }
    }
}

/// Frame in the link with the contact point and the normal as drawn.
fn site_frame(tree: &BodyTree<'_>, contact: &NamedContact) -> Option<Transform<f64>> {
    let own = tree.world_poses[contact.link().index()];
    let other = contact.against().map_or_else(Transform::identity, |link| tree.world_poses[link.index()]);
    let point = own.point(contact.point());
    let normal = match contact.normal() {
        ContactNormal::Fixed(direction) => other.vector(direction),
        ContactNormal::Toward(end) => other.point(end) - point,
        ContactNormal::Away(end) => point - other.point(end),
    };
    let rotation = rotation_to_z(own.inverse_vector(&normal))?;
    Some(Transform::new(rotation, *contact.point()))
}
