//! Named contacts: bump stops, spring seats, wheel contact patches.

use crate::LinkId;
use percuss_spatial::Vector3;

/// Kind of a named contact, in the order of lists of contacts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ContactKind {
    /// Stop that limits the travel: bump stop, rebound stop, door stop.
    Stop,
    /// Seat of a spring.
    Spring,
    /// Mount of a damper.
    Damper,
    /// Contact patch of a wheel or foot.
    Patch,
    /// Any other contact.
    Other,
}

impl ContactKind {
    /// All kinds.
    pub const ALL: [ContactKind; 5] =
        [ContactKind::Stop, ContactKind::Spring, ContactKind::Damper, ContactKind::Patch, ContactKind::Other];

    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            ContactKind::Stop => "stop",
            ContactKind::Spring => "spring",
            ContactKind::Damper => "damper",
            ContactKind::Patch => "patch",
            ContactKind::Other => "other",
        }
    }
}

/// Normal of a named contact, out of the contact link into the other side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ContactNormal {
    /// Direction in the frame of the other side; a unit vector in a mechanism.
    Fixed(Vector3<f64>),
    /// Line from the contact point to a point of the other side (m, its frame). The line turns with the mechanism.
    Toward(Vector3<f64>),
    /// Opposite direction of that line: a stop that limits the extension of a damper.
    Away(Vector3<f64>),
}

/// Description of a named contact for the builder.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactDescription {
    /// Unique name among contacts.
    pub name: String,
    /// Kind.
    pub kind: ContactKind,
    /// Name of the contact link.
    pub link: String,
    /// The contact point, m, contact link's frame.
    pub point: Vector3<f64>,
    /// Name of the link on the other side; `world` is the ground, unless a link has this name.
    pub against: String,
    /// Normal.
    pub normal: ContactNormal,
    /// Gap along the normal with all joints at 0, m; negative if the parts are drawn with an overlap. `None`: the
    /// parts always touch, as a spring and its seat.
    pub gap: Option<f64>,
}

/// Contact with a name. Its gap at a pose is the gap with all joints at 0, less the approach along the normal since
/// then.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedContact {
    pub(crate) name: String,
    pub(crate) kind: ContactKind,
    pub(crate) link: LinkId,
    pub(crate) point: Vector3<f64>,
    pub(crate) against: Option<LinkId>,
    pub(crate) normal: ContactNormal,
    pub(crate) gap: Option<f64>,
}

impl NamedContact {
    /// Name, unique among the contacts.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Kind.
    pub fn kind(&self) -> ContactKind {
        self.kind
    }

    /// The contact link.
    pub fn link(&self) -> LinkId {
        self.link
    }

    /// The contact point, m, contact link's frame.
    pub fn point(&self) -> &Vector3<f64> {
        &self.point
    }

    /// The link on the other side; `None` for the ground.
    pub fn against(&self) -> Option<LinkId> {
        self.against
    }

    /// Normal; a fixed direction has length 1.
    pub fn normal(&self) -> &ContactNormal {
        &self.normal
    }

    /// Gap with all joints at 0, m; `None` if the parts always touch.
    pub fn gap(&self) -> Option<f64> {
        self.gap
    }
}
