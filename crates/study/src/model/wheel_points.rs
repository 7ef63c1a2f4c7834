//! Links at the wheels, by the names that the suspension importer gives.

use percuss_dynamics::Pose;
use percuss_mechanism::{ContactKind, JointId, JointKind, LinkId, Mechanism, NamedContact};
use percuss_spatial::Vector3;

/// Link names given by the suspension importer; their vertical motion is the wheel travel.
const WHEEL_POINTS: [&str; 2] = ["wheel_centre", "contact_patch"];
/// Joint of the rack of an imported suspension.
pub(crate) const RACK: &str = "rack";
/// Suffixes of the sides in names of the importer.
pub(crate) const SIDES: [&str; 2] = ["_left", "_right"];

/// Wheel of an imported suspension whose lowest point is a contact patch. The patch is no point of a body: while the wheel
/// carrier pitches, the lowest point stays below the wheel centre.
#[derive(Clone, Debug)]
pub(crate) struct LowestPoint {
    centre: LinkId,
    spin: JointId,
    patch: LinkId,
}

impl LowestPoint {
    /// Wheel of a contact; `None` for a contact that is no patch of an imported wheel.
    pub fn of(mechanism: &Mechanism, contact: &NamedContact) -> Option<Self> {
        let side =
            contact.name().strip_prefix(WHEEL_POINTS[1]).filter(|_| contact.kind() == ContactKind::Patch)?;
        let centre = mechanism.find_link(&format!("{}{side}", WHEEL_POINTS[0])).ok()?;
        let spin = mechanism.find_joint(&format!("spin{side}")).ok()?;
        Some(Self { centre, spin, patch: contact.link() })
    }

    /// The lowest point at a pose, m, frame of the patch's link; `None` if the axis of the wheel is vertical.
    pub fn at(&self, pose: &Pose) -> Option<Vector3<f64>> {
        let joint = pose.mechanism().joint(self.spin);
        let axis = pose.link(joint.child()).vector(joint.axis());
        let (centre, patch) = (pose.link(self.centre).translation, pose.link(self.patch));
        let radius = (patch.translation - centre).norm();
        Some(patch.inverse_point(&lowest_point(&centre, &axis, radius)?))
    }
}

/// Lowest point of a wheel, m: `centre` (m), `axis` of the spin (a unit vector) and `radius` (m); `None` if the axis is vertical.
pub(crate) fn lowest_point(centre: &Vector3<f64>, axis: &Vector3<f64>, radius: f64) -> Option<Vector3<f64>> {
    let down = (axis * axis.z - Vector3::z()).try_normalize(f64::EPSILON)?;
    Some(centre + down * radius)
}

/// Wheel points; only those on the side of the contact link if the link name ends in a side.
pub(crate) fn wheel_points(mechanism: &Mechanism, contact_link: &str) -> Vec<LinkId> {
    WHEEL_POINTS.iter().flat_map(|point| links_of_side(mechanism, point, contact_link)).collect()
}

/// Wheel centres; only those on the side of the contact if its name ends in a side.
pub(crate) fn wheel_centres(mechanism: &Mechanism, contact: &str) -> Vec<LinkId> {
    links_of_side(mechanism, WHEEL_POINTS[0], contact)
}

/// Links with a name of the importer and the ending of a side; only those on the side in which `name` ends, if any.
fn links_of_side(mechanism: &Mechanism, link: &str, name: &str) -> Vec<LinkId> {
    let side = SIDES.into_iter().find(|side| name.ends_with(side));
    let sides = SIDES.into_iter().filter(|known| side.is_none_or(|side| side == *known));
    let names = [""].into_iter().chain(sides).map(|end| format!("{link}{end}"));
    names.filter_map(|name| mechanism.find_link(&name).ok()).collect()
}

/// Rack of an imported suspension, if it slides; other models may have a joint of this name.
pub(crate) fn sliding_rack(mechanism: &Mechanism) -> Option<JointId> {
    let rack = mechanism.find_joint(RACK).ok()?;
    let slides = mechanism.joint(rack).kind() == JointKind::Prismatic;
    (slides && !wheel_centres(mechanism, "").is_empty()).then_some(rack)
}
