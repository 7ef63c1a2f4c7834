//! Contact of a kernel, and its conversion to the frames of a plan.

use nalgebra::{Matrix3, Vector3};
use percuss_spatial::Transform;

/// Frame of a link, given by its body and the transform from link to body coordinates.
#[derive(Clone, Copy, Debug)]
pub struct LinkFrame {
    /// Body of the link; `None` for the root link.
    pub body: Option<usize>,
    /// X_bl.
    pub frame: Transform<f64>,
}

/// Frame in which a normal is constant.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NormalFrame {
    /// The contact link.
    Link,
    /// The link on the other side.
    Against,
    /// The root link.
    Root,
}

/// Normal of a contact.
#[derive(Clone, Copy, Debug)]
pub enum Normal {
    /// A direction of any length.
    Along(Vector3<f64>, NormalFrame),
    /// Direction from the contact point to a point.
    Toward {
        /// Link of the point.
        end: LinkFrame,
        /// The point in the frame of this link, m.
        point: Vector3<f64>,
        /// Unit vector of the line as drawn, in the frame of the link on the other side, or of the root link.
        drawn: Vector3<f64>,
        /// Smallest accepted length of the line, m.
        shortest: f64,
        /// Smallest accepted cosine of the angle between the line and the line as drawn.
        least_cosine: f64,
    },
}

/// Contact of a link with another or with the ground.
#[derive(Clone, Copy, Debug)]
pub struct Contact {
    /// The contact link.
    pub on: LinkFrame,
    /// The link on the other side; `None` for the ground.
    pub against: Option<LinkFrame>,
    /// Contact point in the frame of the contact link, m.
    pub point: Vector3<f64>,
    /// The normal; the axis of a moment.
    pub normal: Normal,
    /// True for a moment about an axis in place of a force: 1/m̄ in 1/(kg·m²).
    pub is_moment: bool,
}

impl Contact {
    /// The bodies in contact; `None` for a contact that a tree does not support: of links of one body, or along a line without length as
    /// drawn.
    pub(crate) fn body_contact(&self) -> Option<BodyContact> {
        let (normal, frame, line) = match self.normal {
            Normal::Along(normal, frame) => (normal, frame, None),
            Normal::Toward { shortest, .. } if !shortest.is_finite() => return None,
            Normal::Toward { end, point, drawn, shortest, least_cosine } => {
                (drawn, NormalFrame::Against, Some(BodyLine { end, point, shortest, least_cosine }))
            }
        };
        let (body, against) = (self.on.body, self.against.and_then(|other| other.body));
        let is_moment = self.is_moment;
        (body != against).then_some(BodyContact { body, against, normal, frame, line, is_moment })
    }

    /// Conversion of a contact. `own` and `other`: transforms from plan to body coordinates of the bodies of the contact link and of
    /// the link on the other side; the identity and `None` for the ground.
    pub(crate) fn conversion(
        &self,
        own: &Transform<f64>,
        other: Option<&Transform<f64>>,
        frame: NormalFrame,
    ) -> ContactConversion {
        let point = relative_frame(own, &self.on.frame);
        let normal = match (frame, &self.against) {
            (NormalFrame::Link, _) => point.rotation,
            (NormalFrame::Against, Some(against)) => {
                other.map_or(against.frame, |other| relative_frame(other, &against.frame)).rotation
            }
            (NormalFrame::Root, _) | (NormalFrame::Against, None) => Matrix3::identity(),
        };
        ContactConversion { point, normal }
    }
}

/// Contact between two bodies, one of which may be the ground.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BodyContact {
    /// Body of the contact link; `None` for the root link.
    pub body: Option<usize>,
    /// Body of the link on the other side; `None` for the ground.
    pub against: Option<usize>,
    /// Direction of any length; for a line its direction as drawn.
    pub normal: Vector3<f64>,
    /// Frame of the direction.
    pub frame: NormalFrame,
    /// Line that defines the normal.
    pub line: Option<BodyLine>,
    /// True for a moment.
    pub is_moment: bool,
}

/// Line from the contact point to a point of a link.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BodyLine {
    /// Link of the point.
    pub end: LinkFrame,
    /// The point in the frame of this link, m.
    pub point: Vector3<f64>,
    /// Smallest accepted length, m.
    pub shortest: f64,
    /// Smallest accepted cosine of the angle between the line and the line as drawn.
    pub least_cosine: f64,
}

/// Conversion of a contact point and its normal, as given, to the frames of a kernel.
#[derive(Clone, Copy, Debug)]
pub struct ContactConversion {
    /// From the frame of the contact link to that of its body in the kernel.
    pub point: Transform<f64>,
    /// From the axes of the normal as given to those of the kernel.
    pub normal: Matrix3<f64>,
}

impl ContactConversion {
    /// Point (m) and unit normal in the frames of the kernel, from the point in the frame of the link (m) and a normal of any
    /// length.
    #[inline]
    pub fn convert(&self, point: &Vector3<f64>, normal: &Vector3<f64>) -> [Vector3<f64>; 2] {
        [self.point.point(point), self.normal * normal.normalize()]
    }
}

/// X_ab from `a` = X_ca and `b` = X_cb. The origins are subtracted before the rotation: distant
/// origins lose only the digits that cancel in this subtraction.
pub(crate) fn relative_frame(a: &Transform<f64>, b: &Transform<f64>) -> Transform<f64> {
    Transform::new(a.rotation.transpose() * b.rotation, a.inverse_point(&b.translation))
}
