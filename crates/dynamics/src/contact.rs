//! Where the mechanism is struck, and how fast the gap closes.

use crate::kinematics::Kinematics;
use crate::{Pose, System};
use nalgebra::{DMatrix, Vector3};
use percuss_mechanism::LinkId;
use percuss_spatial::Transform;

/// In which frame a point or a normal is given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Frame {
    /// The struck link's.
    #[default]
    Link,
    /// The world's.
    World,
    /// The other link's (the world's, where the ground is struck).
    Against,
}

/// Where the normal points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// Along a vector given in a frame; its length does not matter.
    Along(Vector3<f64>, Frame),
    /// From the contact point towards a point (m) of another link, in that link's frame.
    Toward(LinkId, Vector3<f64>),
}

/// A contact between a point of one link and another link, or the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The struck link.
    pub link: LinkId,
    /// The other side; none: the ground.
    pub against: Option<LinkId>,
    /// The contact point in the struck link's frame, m.
    pub point: Vector3<f64>,
    /// The normal n̂, **out of the struck link into the other side**.
    pub normal: Direction,
}

impl Contact {
    /// A point (m) of a link strikes the ground along a normal, both in the link's frame.
    pub fn new(link: LinkId, point: impl Into<Vector3<f64>>, normal: impl Into<Vector3<f64>>) -> Self {
        Self {
            link,
            against: None,
            point: point.into(),
            normal: Direction::Along(normal.into(), Frame::Link),
        }
    }

    /// Lets it strike another link instead of the ground.
    pub fn against(mut self, link: LinkId) -> Self {
        self.against = Some(link);
        self
    }

    /// Gives the normal otherwise.
    pub fn normal(mut self, normal: Direction) -> Self {
        self.normal = normal;
        self
    }
}

/// A contact that means nothing.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ContactError {
    /// NaN, infinite or absurdly large.
    #[error("the contact {what} has a component {value:e}; a finite number of at most 1e100 is wanted")]
    NotFinite {
        /// `point`, `normal` or `line`.
        what: &'static str,
        /// The component.
        value: f64,
    },
    /// The normal is zero, or all but.
    #[error("the normal has length {length:e}; at least 1e-9 is wanted, for a direction")]
    NoNormal {
        /// Its length.
        length: f64,
    },
    /// The line's point is the contact point.
    #[error(
        "the line's point on \"{link}\" is the contact point (distance {distance:e} m): there is no direction"
    )]
    NoLine {
        /// The other link.
        link: String,
        /// How far the points are apart, m.
        distance: f64,
    },
    /// A handle of another mechanism.
    #[error(
        "link number {index} is not of this mechanism, which has {links} links; ask it for the link by name"
    )]
    ForeignLink {
        /// The handle's number.
        index: usize,
        /// How many links this mechanism has.
        links: usize,
    },
    /// A pose of another system.
    #[error("the pose has {got} positions, this mechanism {expected}: it was made by another system")]
    ForeignPose {
        /// Positions of the pose.
        got: usize,
        /// Positions of the mechanism.
        expected: usize,
    },
    /// A link struck by itself.
    #[error("link \"{link}\" cannot strike itself; name another link, or none for the ground")]
    Itself {
        /// The link.
        link: String,
    },
}

/// A contact at a pose: the point and the unit normal in the world and in the struck link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocatedContact {
    /// The struck link.
    pub link: LinkId,
    /// The other side; none: the ground.
    pub against: Option<LinkId>,
    /// The point in the world, m.
    pub point_world: Vector3<f64>,
    /// n̂ in the world.
    pub normal_world: Vector3<f64>,
    /// The point in the struck link, m.
    pub point_link: Vector3<f64>,
    /// n̂ in the struck link.
    pub normal_link: Vector3<f64>,
    /// The point in the root link's frame, m.
    pub(crate) point_root: Vector3<f64>,
    /// n̂ in the root link's frame.
    pub(crate) normal_root: Vector3<f64>,
}

impl System {
    /// A point (m) given in a frame, in the coordinates of `link`.
    pub fn point_in_link(
        &self,
        pose: &Pose,
        link: LinkId,
        against: Option<LinkId>,
        frame: Frame,
        point: Vector3<f64>,
    ) -> Vector3<f64> {
        let x_rl = pose.kinematics.link_frame(self, link);
        match (frame, against) {
            (Frame::Link, _) => point,
            (Frame::Against, Some(other)) => {
                x_rl.inverse_point(&pose.kinematics.link_frame(self, other).point(&point))
            }
            (Frame::World, _) | (Frame::Against, None) => {
                x_rl.inverse_point(&pose.base.inverse_point(&point))
            }
        }
    }

    /// Finds the point and the normal of a contact at a pose.
    ///
    /// # Errors
    /// [`ContactError`]: not finite, no direction, a link against itself.
    pub fn locate(&self, pose: &Pose, contact: &Contact) -> Result<LocatedContact, ContactError> {
        let own = self.joint_q.last().map_or(0, |range| range.end);
        if pose.kinematics.q.len() != own || pose.kinematics.frames.len() != self.bodies.len() {
            return Err(ContactError::ForeignPose { got: pose.kinematics.q.len(), expected: own });
        }
        locate(self, &pose.kinematics, &pose.base, contact)
    }

    /// The contact row j = n̂ᵀ(J_on − J_against) over the coordinates: the closing speed of the gap at unit rates,
    /// 1×n (m for turns, 1 for slides). Joints that carry both sides cancel and are left out.
    pub fn contact_row(&self, pose: &Pose, contact: &LocatedContact) -> Vec<f64> {
        let (row, _) = row_over_tree(self, &pose.kinematics, contact);
        self.reduce_vector(&row, |multiplier| multiplier)
    }

    /// Jacobian of a point of a link, 3×n over the coordinates: v_P = J u, in the root link's axes, relative to
    /// the ground (m for turns, 1 for slides).
    pub fn point_jacobian(&self, pose: &Pose, link: LinkId, point: &Vector3<f64>) -> DMatrix<f64> {
        let at = pose.kinematics.link_frame(self, link).point(point);
        let mut jacobian = DMatrix::zeros(3, self.coordinates);
        let mut next = self.seats[link.index()].body;
        while let Some(i) = next {
            for (k, v) in self.bodies[i].v.clone().enumerate() {
                if let Some(f) = self.follows[v] {
                    let column = velocity_column(self, &pose.kinematics, i, k, &at).0 * f.multiplier;
                    let mut target = jacobian.column_mut(f.index);
                    target += column;
                }
            }
            next = self.bodies[i].parent;
        }
        jacobian
    }
}

/// [`System::locate`] on bare kinematics.
pub(crate) fn locate(
    system: &System,
    kinematics: &Kinematics<f64>,
    base: &Transform<f64>,
    contact: &Contact,
) -> Result<LocatedContact, ContactError> {
    let line = match contact.normal {
        Direction::Toward(link, _) => Some(link),
        Direction::Along(..) => None,
    };
    let links = system.mechanism.links().len();
    for link in [Some(contact.link), contact.against, line].into_iter().flatten() {
        if link.index() >= links {
            return Err(ContactError::ForeignLink { index: link.index(), links });
        }
    }
    let name = |link: LinkId| system.mechanism.link(link).name().to_owned();
    if contact.against == Some(contact.link) {
        return Err(ContactError::Itself { link: name(contact.link) });
    }
    finite("point", &contact.point)?;
    let x_rl = kinematics.link_frame(system, contact.link);
    let point_root = x_rl.point(&contact.point);
    let normal_root = match contact.normal {
        Direction::Along(normal, frame) => {
            finite("normal", &normal)?;
            let length = normal.norm();
            if length < 1e-9 {
                return Err(ContactError::NoNormal { length });
            }
            let unit = normal / length;
            match (frame, contact.against) {
                (Frame::Link, _) => x_rl.vector(&unit),
                (Frame::Against, Some(other)) => kinematics.link_frame(system, other).vector(&unit),
                (Frame::World, _) | (Frame::Against, None) => base.inverse_vector(&unit),
            }
        }
        Direction::Toward(link, point) => {
            finite("line", &point)?;
            let line = kinematics.link_frame(system, link).point(&point) - point_root;
            let distance = line.norm();
            if distance < 1e-9 {
                return Err(ContactError::NoLine { link: name(link), distance });
            }
            line / distance
        }
    };
    Ok(LocatedContact {
        link: contact.link,
        against: contact.against,
        point_world: base.point(&point_root),
        normal_world: base.vector(&normal_root),
        point_link: contact.point,
        normal_link: x_rl.inverse_vector(&normal_root),
        point_root,
        normal_root,
    })
}

fn finite(what: &'static str, v: &Vector3<f64>) -> Result<(), ContactError> {
    match v.iter().find(|x| !x.is_finite() || x.abs() > 1e100) {
        Some(&value) => Err(ContactError::NotFinite { what, value }),
        None => Ok(()),
    }
}

/// The contact row over tree velocities, and the size of the terms whose sum each entry is.
pub(crate) fn row_over_tree(
    system: &System,
    kinematics: &Kinematics<f64>,
    contact: &LocatedContact,
) -> (Vec<f64>, Vec<f64>) {
    let n = system.follows.len();
    let (mut row, mut size) = (vec![0.0; n], vec![0.0; n]);
    row_over_tree_into(system, kinematics, contact, &mut row, &mut size);
    (row, size)
}

/// [`row_over_tree`] in place.
pub(crate) fn row_over_tree_into(
    system: &System,
    kinematics: &Kinematics<f64>,
    contact: &LocatedContact,
    row: &mut [f64],
    size: &mut [f64],
) {
    row.fill(0.0);
    size.fill(0.0);
    let on = system.seats[contact.link.index()].body;
    let against = contact.against.and_then(|l| system.seats[l.index()].body);
    system.for_each_support(on, against, |i, sign| {
        for (k, v) in system.bodies[i].v.clone().enumerate() {
            let (velocity, magnitude) = velocity_column(system, kinematics, i, k, &contact.point_root);
            row[v] = sign * contact.normal_root.dot(&velocity);
            size[v] = magnitude;
        }
    });
}

/// Velocity of the point `at` (root frame) at unit velocity `k` of body `i`, and the size of its terms.
fn velocity_column(
    system: &System,
    kinematics: &Kinematics<f64>,
    i: usize,
    k: usize,
    at: &Vector3<f64>,
) -> (Vector3<f64>, f64) {
    let frame = &kinematics.frames[i];
    let column = kinematics.column(system, i, k);
    let (omega, slide) = (frame.vector(&column.angular), frame.vector(&column.linear));
    let arm = at - frame.translation;
    (slide + omega.cross(&arm), slide.norm() + omega.norm() * arm.norm())
}
