//! Contacts: the contact point, the normal, and the closing speed of the gap per joint rate.

use crate::kinematics::frames::Kinematics;
use crate::model::Model;
use crate::model::input::{foreign_link, is_number};
use crate::model::tangent;
use crate::tolerances::{DIRECTION_DECIMALS, LINE_TURNED, SHORTEST_DIRECTION, SHORTEST_LINE};
use nalgebra::{DMatrix, Vector3};
use percuss_mechanism::{JointId, JointKind, LinkId, Mechanism};
use percuss_spatial::{Transform, plane_basis};

/// Frame of a contact point or a normal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Frame {
    /// The frame of the contact link.
    #[default]
    Link,
    /// The world frame.
    World,
    /// The frame of the other link; the world frame if the other side is the ground.
    Against,
}

/// Direction of the contact normal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// Along a vector given in a frame; the length of the vector has no effect.
    Along(Vector3<f64>, Frame),
    /// From the contact point towards a point (m) of another link, in that link's frame: the normal of a stop.
    /// Refused if the line has turned by more than 5° from its direction as drawn (all joints at 0), measured in the
    /// frame of the other side, or if the line is shorter than a tenth of its length as drawn. In both cases the line
    /// no longer represents the normal of the stop.
    Toward(LinkId, Vector3<f64>),
    /// Along the same line, which may turn: a spring, a damper or a rod between two points. Refused if the line is
    /// shorter than a tenth of its length as drawn.
    TurningToward(LinkId, Vector3<f64>),
    /// Opposite direction of this line: a stop that limits the extension of a damper.
    TurningAwayFrom(LinkId, Vector3<f64>),
}

impl Direction {
    /// Far end of the line that defines the normal, as a link and a point (m) in the link's frame; `None` for a fixed
    /// normal.
    pub fn line(&self) -> Option<(LinkId, Vector3<f64>)> {
        match *self {
            Direction::Along(..) => None,
            Direction::Toward(link, point)
            | Direction::TurningToward(link, point)
            | Direction::TurningAwayFrom(link, point) => Some((link, point)),
        }
    }

    /// Smallest accepted cosine of the angle between the line and the line as drawn; below −1 if the line may turn.
    pub(crate) fn least_cosine(&self) -> f64 {
        match self {
            Direction::Toward(..) => LINE_TURNED,
            Direction::Along(..) | Direction::TurningToward(..) | Direction::TurningAwayFrom(..) => -2.0,
        }
    }
}

/// A contact between a point of one link and another link, or the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The contact link.
    pub link: LinkId,
    /// The link on the other side; `None` for the ground.
    pub against: Option<LinkId>,
    /// The contact point in the frame of the contact link, m.
    pub point: Vector3<f64>,
    /// The normal n̂, **out of the contact link into the other side**.
    pub normal: Direction,
}

impl Contact {
    /// Contact of a point (m) of a link with the ground along a normal, both in the link's frame.
    pub fn new(link: LinkId, point: impl Into<Vector3<f64>>, normal: impl Into<Vector3<f64>>) -> Self {
        Self {
            link,
            against: None,
            point: point.into(),
            normal: Direction::Along(normal.into(), Frame::Link),
        }
    }

    /// Cable between a point of a link and a point of another link (m, frames of the links). A motion that lengthens the cable closes the
    /// gap.
    pub fn cable(
        link: LinkId,
        point: impl Into<Vector3<f64>>,
        other: LinkId,
        end: impl Into<Vector3<f64>>,
    ) -> Self {
        let normal = Direction::TurningAwayFrom(other, end.into());
        Self { link, against: Some(other), point: point.into(), normal }
    }

    /// Stop of a joint with one velocity: a contact of child and parent whose closing speed is the rate of the joint, or minus this rate if
    /// not `is_upper`. For a hinge the contact point is 1 m from the axis, so m̄ is the inertia at the joint in kg·m². `None` unless the joint
    /// has one velocity.
    pub fn joint_stop(mechanism: &Mechanism, joint: JointId, is_upper: bool) -> Option<Self> {
        let joint = mechanism.joint(joint);
        let axis = joint.axis();
        let (point, normal) = match joint.kind() {
            JointKind::Revolute | JointKind::Continuous => {
                let across = plane_basis(axis).0;
                (across, axis.cross(&across))
            }
            JointKind::Prismatic => (Vector3::zeros(), *axis),
            JointKind::Fixed | JointKind::Planar | JointKind::Spherical | JointKind::Floating => return None,
        };
        let normal = if is_upper { normal } else { -normal };
        Some(Self::new(joint.child(), point, normal).against(joint.parent()))
    }

    /// Replaces the ground on the other side by a link.
    pub fn against(mut self, link: LinkId) -> Self {
        self.against = Some(link);
        self
    }

    /// True if the normal is constant in the world frame.
    pub(crate) fn has_world_normal(&self) -> bool {
        match self.normal {
            Direction::Along(_, Frame::World) => true,
            Direction::Along(_, Frame::Against) => self.against.is_none(),
            Direction::Along(_, Frame::Link)
            | Direction::Toward(..)
            | Direction::TurningToward(..)
            | Direction::TurningAwayFrom(..) => false,
        }
    }

    /// Replaces the normal.
    pub fn normal(mut self, normal: Direction) -> Self {
        self.normal = normal;
        self
    }
}

/// Vector in the definition of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactPart {
    /// The contact point.
    Point,
    /// The normal.
    Normal,
    /// The point that the normal points towards.
    Line,
}

impl ContactPart {
    /// Name for messages.
    pub fn name(self) -> &'static str {
        match self {
            ContactPart::Point => "point",
            ContactPart::Normal => "normal",
            ContactPart::Line => "line",
        }
    }
}

/// Error of an invalid contact.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ContactError {
    /// A component is NaN, infinite or above 1e100 in magnitude.
    #[error("the contact {} has a component {value:e}; expected a finite number of at most 1e100", part.name())]
    NotFinite {
        /// The vector with the component.
        part: ContactPart,
        /// The component.
        value: f64,
    },
    /// The normal is zero or shorter than 1e-9.
    #[error("the normal has length {length:e}; expected at least 1e-9, for a direction")]
    NoNormal {
        /// Length of the normal.
        length: f64,
    },
    /// The end point of the line coincides with the contact point.
    #[error(
        "the line's point on \"{link}\" is the contact point (distance {distance:e} m): the direction is undefined"
    )]
    NoLine {
        /// The other link.
        link: String,
        /// Distance of the two points, m.
        distance: f64,
    },
    /// The line is too short at this pose to define a direction.
    #[error(
        "the line towards \"{link}\" is {length:.3e} m long at this pose, less than a tenth of its length \
         {drawn:.3e} m in the design pose: its direction is not a normal. Give the direction of the design pose \
         as a fixed normal, {} in the frame of the {}",
        triple(normal), side(*frame)
    )]
    LineShort {
        /// The other link.
        link: String,
        /// Length of the line, m.
        length: f64,
        /// Length of the line as drawn, m.
        drawn: f64,
        /// Unit vector of the line as drawn.
        normal: Vector3<f64>,
        /// Frame of `normal`: `Against` or `World`.
        frame: Frame,
    },
    /// The line of a stop has turned too far.
    #[error(
        "the line towards \"{link}\" has turned by {:.1}° from its direction in the design pose; the normal of \
         a stop may turn by at most 5°. Give the direction of the design pose as a fixed normal, {} in the \
         frame of the {}, or permit the line to turn, as for a spring",
        angle.to_degrees(), triple(normal), side(*frame)
    )]
    LineTurned {
        /// The other link.
        link: String,
        /// Angle of the turn, rad.
        angle: f64,
        /// Unit vector of the line as drawn.
        normal: Vector3<f64>,
        /// Frame of `normal`: `Against` or `World`.
        frame: Frame,
    },
    /// A link handle of another mechanism.
    #[error(
        "link number {index} is not in this mechanism, which has {links} links; look up the link by name"
    )]
    ForeignLink {
        /// Index of the handle.
        index: usize,
        /// Number of links of this mechanism.
        links: usize,
    },
    /// The mass of a free body on the other side is not a finite number above the limit.
    #[error("the other side's mass is {mass} kg; expected a finite number above {least:e}")]
    OtherMass {
        /// The given mass, kg.
        mass: f64,
        /// Exclusive lower limit, kg.
        least: f64,
    },
    /// The contact link is also the other side.
    #[error("link \"{link}\" cannot be in contact with itself; name another link, or none for the ground")]
    Itself {
        /// The link.
        link: String,
    },
}

/// Formats a direction with six decimals.
fn triple(v: &Vector3<f64>) -> String {
    let [x, y, z] = [v.x, v.y, v.z].map(|x| (x * DIRECTION_DECIMALS).round() / DIRECTION_DECIMALS + 0.0);
    format!("({x}, {y}, {z})")
}

/// Name of the link or frame that defines a frame, for messages.
fn side(frame: Frame) -> &'static str {
    match frame {
        Frame::Link => "contact link",
        Frame::World => "world",
        Frame::Against => "other side",
    }
}

/// Line of a contact as drawn (all joints at 0).
#[derive(Clone, Copy, Debug)]
pub(crate) struct DrawnLine {
    /// Unit vector in the frame of the other side; in the frame of the root link if the other side is the ground.
    pub unit: Vector3<f64>,
    /// Length, m.
    pub length: f64,
}

/// A contact at a pose: the point and the unit normal in the world frame and in the frame of the contact link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocatedContact {
    /// The contact link.
    pub link: LinkId,
    /// The link on the other side; `None` for the ground.
    pub against: Option<LinkId>,
    /// The point in the world, m.
    pub point_world: Vector3<f64>,
    /// n̂ in the world.
    pub normal_world: Vector3<f64>,
    /// The point in the frame of the contact link, m.
    pub point_link: Vector3<f64>,
    /// n̂ in the frame of the contact link.
    pub normal_link: Vector3<f64>,
    /// The point in the root link's frame, m.
    pub(crate) point_root: Vector3<f64>,
    /// n̂ in the root link's frame.
    pub(crate) normal_root: Vector3<f64>,
    /// Far end of the line that defines n̂, as a link and a point (m) in the link's frame; `None` for a fixed normal.
    pub(crate) line: Option<(LinkId, Vector3<f64>)>,
}

/// Contact point and unit normal in the frame of the root link.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ContactPoint {
    pub point: Vector3<f64>,
    pub normal: Vector3<f64>,
}

impl Model {
    /// Refuses a contact that is invalid on this mechanism.
    pub fn check_contact(&self, contact: &Contact) -> Result<(), ContactError> {
        let line = contact.normal.line().map(|(link, _)| link);
        let links = self.mechanism.links().len();
        let given = [Some(contact.link), contact.against, line];
        if let Some(index) = foreign_link(&self.mechanism, given.into_iter().flatten()) {
            return Err(ContactError::ForeignLink { index, links });
        }
        if contact.against == Some(contact.link) {
            let link = self.mechanism.link(contact.link).name().to_owned();
            return Err(ContactError::Itself { link });
        }
        finite(ContactPart::Point, &contact.point)?;
        match contact.normal {
            Direction::Along(normal, _) => {
                finite(ContactPart::Normal, &normal)?;
                let length = normal.norm();
                if length < SHORTEST_DIRECTION { Err(ContactError::NoNormal { length }) } else { Ok(()) }
            }
            Direction::Toward(_, point)
            | Direction::TurningToward(_, point)
            | Direction::TurningAwayFrom(_, point) => finite(ContactPart::Line, &point),
        }
    }

    /// Line that defines the normal of a contact, with all joints at 0. `None` for a fixed normal, and for a line of
    /// zero length as drawn.
    pub fn drawn_line(&self, contact: &Contact) -> Option<DrawnLine> {
        let (link, to) = contact.normal.line()?;
        let line = self.drawn_frame(link).point(&to) - self.drawn_frame(contact.link).point(&contact.point);
        let unit = line.try_normalize(SHORTEST_DIRECTION)?;
        let unit = contact.against.map_or(unit, |against| self.drawn_frame(against).inverse_vector(&unit));
        Some(DrawnLine { unit, length: line.norm() })
    }

    /// X_rl of a link with all joints at 0.
    pub fn drawn_frame(&self, link: LinkId) -> Transform<f64> {
        let on = &self.link_frames[link.index()];
        let (mut frame, mut at) = (on.frame, on.body);
        while let Some(i) = at {
            let body = &self.bodies[i];
            if let Some(joint) = body.joint {
                // A floating joint has the largest number of positions, 7.
                let mut q = [0.0; 7];
                let q = &mut q[..body.q.len()];
                tangent::zero_position(self.mechanism.joint(joint).kind(), q);
                if let Some(mimic) = body.mimic {
                    q[0] = mimic.offset;
                }
                frame = body.origin * body.motion.transform(q) * frame;
            }
            at = body.parent;
        }
        frame
    }

    /// Refuses a line that at this pose is too short, or turned too far from the line as drawn.
    fn check_line(
        &self,
        kinematics: &Kinematics,
        base: &Transform<f64>,
        contact: &Contact,
    ) -> Result<(), ContactError> {
        let Some((end, to)) = contact.normal.line() else { return Ok(()) };
        let point = kinematics.link_frame(self, contact.link).point(&contact.point);
        let line = kinematics.link_frame(self, end).point(&to) - point;
        let link = || self.mechanism.link(end).name().to_owned();
        let Some(drawn) = self.drawn_line(contact) else {
            return Err(ContactError::NoLine { link: link(), distance: 0.0 });
        };
        let length = line.norm();
        if length < SHORTEST_DIRECTION {
            return Err(ContactError::NoLine { link: link(), distance: length });
        }
        let (frame, normal) = match contact.against {
            Some(_) => (Frame::Against, drawn.unit),
            None => (Frame::World, base.vector(&drawn.unit)),
        };
        if length < SHORTEST_LINE * drawn.length {
            return Err(ContactError::LineShort { link: link(), length, drawn: drawn.length, normal, frame });
        }
        let unit = line / length;
        let unit = contact
            .against
            .map_or(unit, |against| kinematics.link_frame(self, against).inverse_vector(&unit));
        let cosine = unit.dot(&drawn.unit);
        if cosine < contact.normal.least_cosine() {
            let angle = unit.cross(&drawn.unit).norm().atan2(cosine);
            return Err(ContactError::LineTurned { link: link(), angle, normal, frame });
        }
        Ok(())
    }

    /// Contact point and normal of a checked contact. The normal is zero if the ends of the line coincide.
    pub fn contact_point(
        &self,
        kinematics: &Kinematics,
        base: &Transform<f64>,
        contact: &Contact,
    ) -> ContactPoint {
        let x_rl = kinematics.link_frame(self, contact.link);
        let point = x_rl.point(&contact.point);
        let normal = match contact.normal {
            Direction::Along(normal, frame) => {
                let unit = normal.normalize();
                let in_frame = unit;
                match (frame, contact.against) {
                    (Frame::Link, _) => x_rl.vector(&in_frame),
                    (Frame::Against, Some(other)) => kinematics.link_frame(self, other).vector(&in_frame),
                    (Frame::World, _) | (Frame::Against, None) => base.inverse_vector(&unit),
                }
            }
            Direction::Toward(link, to)
            | Direction::TurningToward(link, to)
            | Direction::TurningAwayFrom(link, to) => {
                let line = kinematics.link_frame(self, link).point(&to) - point;
                let square = line.dot(&line) + f64::MIN_POSITIVE;
                let sense = if let Direction::TurningAwayFrom(..) = contact.normal { -1.0 } else { 1.0 };
                line * (sense / square.sqrt())
            }
        };
        ContactPoint { point, normal }
    }

    /// Computes the point and the normal of a contact; refuses an invalid contact.
    pub fn locate(
        &self,
        kinematics: &Kinematics,
        base: &Transform<f64>,
        contact: &Contact,
    ) -> Result<LocatedContact, ContactError> {
        self.check_contact(contact)?;
        let ContactPoint { point, normal } = self.contact_point(kinematics, base, contact);
        let x_rl = kinematics.link_frame(self, contact.link);
        self.check_line(kinematics, base, contact)?;
        Ok(LocatedContact {
            link: contact.link,
            against: contact.against,
            point_world: base.point(&point),
            normal_world: base.vector(&normal),
            point_link: contact.point,
            normal_link: x_rl.inverse_vector(&normal),
            point_root: point,
            normal_root: normal,
            line: contact.normal.line(),
        })
    }

    /// Contact row over the tree velocities, with the size of the summed terms of each entry. Joints that move both
    /// sides equally are left out: their contributions cancel.
    pub fn contact_row(&self, kinematics: &Kinematics, contact: &LocatedContact) -> ContactRow {
        let mut row = ContactRow::default();
        self.contact_row_into(kinematics, contact, &mut row);
        row
    }

    /// Computes [`contact_row`](Self::contact_row) in place.
    pub fn contact_row_into(&self, kinematics: &Kinematics, contact: &LocatedContact, row: &mut ContactRow) {
        row.entries.clear();
        row.length = 0.0;
        let against = contact.against.and_then(|link| self.body_of(link));
        self.for_each_support(self.body_of(contact.link), against, |i, sign| {
            let arm = (contact.point_root - kinematics.frames[i].translation).norm();
            for (component, velocity) in self.bodies[i].v.clone().enumerate() {
                let turns = self.bodies[i].motion.turns(component);
                let (point_velocity, size) =
                    self.velocity_column(kinematics, i, component, &contact.point_root);
                let value = sign * contact.normal_root.dot(&point_velocity);
                row.entries.push(RowEntry { velocity, body: i, value, size, turns });
                if turns {
                    row.length = row.length.max(arm);
                }
            }
        });
        if row.length == 0.0 {
            row.length = 1.0;
        }
    }

    /// Velocity of the point `at` (root frame) at unit velocity `k` of body `i`, and the sum of the magnitudes of its
    /// terms.
    fn velocity_column(
        &self,
        kinematics: &Kinematics,
        i: usize,
        k: usize,
        at: &Vector3<f64>,
    ) -> (Vector3<f64>, f64) {
        let frame = &kinematics.frames[i];
        let column = kinematics.column(self, i, k);
        let (omega, slide) = (frame.vector(&column.angular), frame.vector(&column.linear));
        let arm = at - frame.translation;
        (slide + omega.cross(&arm), slide.norm() + omega.norm() * arm.norm())
    }

    /// Jacobian of a point (m, link frame) of a link over the coordinates, 3×n, in root axes.
    pub fn point_jacobian(
        &self,
        kinematics: &Kinematics,
        link: LinkId,
        point: &Vector3<f64>,
    ) -> DMatrix<f64> {
        let at = kinematics.link_frame(self, link).point(point);
        let mut jacobian = DMatrix::zeros(3, self.coordinates.len());
        self.for_each_support(self.body_of(link), None, |i, _| {
            for (k, v) in self.bodies[i].v.clone().enumerate() {
                if let Some(f) = self.velocity_coordinates[v] {
                    let column = self.velocity_column(kinematics, i, k, &at).0 * f.multiplier;
                    let mut target = jacobian.column_mut(f.index);
                    target += column;
                }
            }
        });
        jacobian
    }
}

/// Entry of the contact row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RowEntry {
    /// Index among the tree velocities.
    pub velocity: usize,
    pub body: usize,
    pub value: f64,
    /// Sum of the magnitudes of the terms of `value`.
    pub size: f64,
    pub turns: bool,
}

/// Contact row over the tree velocities, without the structural zeros.
#[derive(Clone, Debug, Default)]
pub(crate) struct ContactRow {
    pub entries: Vec<RowEntry>,
    /// Characteristic length of the contact, m: the largest distance of the contact point from a rotating joint on
    /// its path; 1 without such a joint.
    pub length: f64,
}

/// Checks that all components are valid numbers.
fn finite(part: ContactPart, v: &Vector3<f64>) -> Result<(), ContactError> {
    match v.iter().find(|x| !is_number(**x)) {
        Some(&value) => Err(ContactError::NotFinite { part, value }),
        None => Ok(()),
    }
}
