//! Changes of links and joints that the structure of MJCF requires.

use super::body_tree::{BodyTree, has_range};
use super::rotors::Rotor;
use crate::writing::changes::Change;
use percuss_mechanism::JointKind;

/// Changes of links and joints, because bodies of MJCF are nested and can have several joints.
pub(super) fn form_changes(tree: &BodyTree<'_>) -> Vec<Change> {
    let mechanism = tree.mechanism;
    let mut changes = Vec::new();
    let root = mechanism.link(mechanism.root()).name();
    if !tree.root_is_world {
        let what = "a body fixed to the world";
        changes.push(Change::changed("link", root, what, "the root of MJCF is the world"));
    }
    for link in mechanism.link_ids() {
        let name = mechanism.link(link).name();
        match (tree.has_body(link), tree.rotors[link.index()]) {
            (false, Some(Rotor::Tendon(_) | Rotor::Follower)) => changes.push(Change::changed(
                "link",
                name,
                "the armature of a tendon, without a body",
                "the tendon is shorter than a body with a slide and an equality",
            )),
            (false, _) => changes.push(Change::changed(
                "link",
                name,
                "no body of its own: its joint belongs to the body of its child",
                "MuJoCo refuses moving bodies without mass",
            )),
            (true, _) => {}
        }
    }
    for joint in mechanism.joints() {
        let name = joint.name();
        let is_free = joint.parent() == mechanism.root() && tree.is_free(joint.child());
        let parts = match joint.kind() {
            JointKind::Fixed => {
                changes.push(Change::lost(
                    "joint",
                    name,
                    "its name",
                    "a body without a joint is fixed in MJCF",
                ));
                None
            }
            JointKind::Planar => Some("two slides and a hinge"),
            JointKind::Floating if !is_free => Some("three slides and a ball joint"),
            _ => None,
        };
        if let Some(parts) = parts {
            changes.push(Change::changed("joint", name, parts, "MJCF has no such joint between two bodies"));
        }
        if let Some(limits) = joint.limits().filter(|limits| !has_range(limits)) {
            let what = format!("its limits {} and {}", limits.lower, limits.upper);
            changes.push(Change::lost("joint", name, what, "MuJoCo refuses a range without an extent"));
        }
    }
    changes
}
