//! Links at the wheels, by the names that the suspension importer gives.

use percuss_dynamics::LowestPoint;
use percuss_mechanism::{ContactKind, JointId, JointKind, LinkId, Mechanism, NamedContact};

/// Link names given by the suspension importer; their vertical motion is the wheel travel.
const WHEEL_POINTS: [&str; 2] = [WHEEL_CENTRE, "contact_patch"];
/// Link at the centre of a wheel, without the suffix of the side.
pub const WHEEL_CENTRE: &str = "wheel_centre";
/// Joint of the rack of an imported suspension.
pub const RACK: &str = "rack";
/// Suffixes of the sides in names of the importer.
pub const SIDES: [&str; 2] = ["_left", "_right"];

/// Wheel of a contact; `None` for a contact that is no patch of an imported wheel.
pub fn wheel_of_patch(mechanism: &Mechanism, contact: &NamedContact) -> Option<LowestPoint> {
    let side =
        contact.name().strip_prefix(WHEEL_POINTS[1]).filter(|_| contact.kind() == ContactKind::Patch)?;
    let centre = mechanism.find_link(&format!("{}{side}", WHEEL_POINTS[0])).ok()?;
    let spin = mechanism.find_joint(&format!("spin{side}")).ok()?;
    Some(LowestPoint { centre, spin, patch: contact.link() })
}

/// True for a link that turns with a wheel of an imported suspension.
pub fn is_on_wheel(mechanism: &Mechanism, link: LinkId) -> bool {
    let parent = |link: LinkId| mechanism.parent_joint(link).map(|joint| mechanism.joint(joint));
    std::iter::successors(parent(link), |joint| parent(joint.parent())).any(|joint| {
        joint.name().strip_prefix("spin").is_some_and(|side| side.is_empty() || SIDES.contains(&side))
    })
}

/// Wheel points; only those on the side of the contact link if the link name ends in a side.
pub fn wheel_points(mechanism: &Mechanism, contact_link: &str) -> Vec<LinkId> {
    WHEEL_POINTS.iter().flat_map(|point| links_of_side(mechanism, point, contact_link)).collect()
}

/// Wheel centres; only those on the side of the contact if its name ends in a side.
pub fn wheel_centres(mechanism: &Mechanism, contact: &str) -> Vec<LinkId> {
    links_of_side(mechanism, WHEEL_POINTS[0], contact)
}

/// Links with a name of the importer and the ending of a side; only those on the side in which `name` ends, if any.
fn links_of_side(mechanism: &Mechanism, link: &str, name: &str) -> Vec<LinkId> {
    let side = SIDES.into_iter().find(|side| name.ends_with(side));
    let sides = SIDES.into_iter().filter(|known| side.is_none_or(|side| side == *known));
    let names = [""].into_iter().chain(sides).map(|end| format!("{link}{end}"));
    names.filter_map(|name| mechanism.link_named(&name)).collect()
}

/// Rack of an imported suspension, if it slides; other models may have a joint of this name.
pub fn sliding_rack(mechanism: &Mechanism) -> Option<JointId> {
    let rack = mechanism.joint_named(RACK)?;
    let slides = mechanism.joint(rack).kind() == JointKind::Prismatic;
    (slides && !wheel_centres(mechanism, "").is_empty()).then_some(rack)
}
