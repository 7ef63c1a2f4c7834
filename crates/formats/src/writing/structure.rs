//! Properties of links, used by the writers of all formats.

use percuss_mechanism::{JointKind, LinkId, LoopFrame, Mechanism};
use percuss_spatial::{Matrix3, Transform};

/// World poses of all links as drawn, in the order of the links; the root link is at the world's origin.
pub(crate) fn drawn_poses(mechanism: &Mechanism) -> Vec<Transform<f64>> {
    let mut poses = vec![Transform::identity(); mechanism.links().len()];
    for &link in mechanism.order().iter().skip(1) {
        if let Some(joint) = mechanism.parent_joint(link).map(|joint| mechanism.joint(joint)) {
            poses[link.index()] = poses[joint.parent().index()] * *joint.origin();
        }
    }
    poses
}

/// Loop frame in the world; `poses`: world poses of all links.
pub(crate) fn loop_frame(poses: &[Transform<f64>], end: &LoopFrame) -> Transform<f64> {
    end.link.map_or_else(Transform::identity, |link| poses[link.index()]) * end.frame
}

/// Per link: true if only fixed joints connect the link to the root. True for the root.
pub(crate) fn immovable_links(mechanism: &Mechanism) -> Vec<bool> {
    let mut at_rest = vec![false; mechanism.links().len()];
    for &link in mechanism.order() {
        at_rest[link.index()] = match mechanism.parent_joint(link).map(|id| mechanism.joint(id)) {
            Some(joint) => joint.kind() == JointKind::Fixed && at_rest[joint.parent().index()],
            None => true,
        };
    }
    at_rest
}

/// Per link: true if it is at an end of a closure.
pub(crate) fn held_links(mechanism: &Mechanism) -> Vec<bool> {
    let mut held = vec![false; mechanism.links().len()];
    for frame in mechanism.closures().iter().flat_map(|closure| [closure.predecessor(), closure.successor()])
    {
        if let Some(link) = frame.link {
            held[link.index()] = true;
        }
    }
    held
}

/// True for a link without mass and inertia.
pub(crate) fn is_massless(mechanism: &Mechanism, link: LinkId) -> bool {
    mechanism.link(link).inertial().is_none_or(|i| i.mass == 0.0 && i.about_com == Matrix3::zeros())
}
