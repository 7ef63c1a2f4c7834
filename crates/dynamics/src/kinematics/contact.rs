//! Contacts: the contact point with its normal, or the axis of a moment.

use crate::kinematics::frames::Kinematics;
use crate::model::Model;
use crate::model::input::{foreign_link, is_number};
use crate::model::tangent;
use crate::tolerances::{DIRECTION_DECIMALS, LINE_TURNED, SHORTEST_DIRECTION, SHORTEST_LINE};
use nalgebra::Vector3;
use percuss_mechanism::{JointId, JointKind, LinkId, Mechanism};
use percuss_spatial::{Transform, Twist, Wrench};

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

/// Direction of the contact normal, or axis of a moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// Along a vector given in a frame; the length of the vector has no effect.
    Along(Vector3<f64>, Frame),
    /// A moment about an axis â, given in a frame, instead of a force along a normal. The closing speed is the relative
    /// angular velocity â·(ω_link − ω_against), rad/s, and m̄ is an inertia, kg·m². The length of the vector and the contact
    /// point have no effect.
    About(Vector3<f64>, Frame),
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
            Direction::Along(..) | Direction::About(..) => None,
            Direction::Toward(link, point)
            | Direction::TurningToward(link, point)
            | Direction::TurningAwayFrom(link, point) => Some((link, point)),
        }
    }

    /// True for a moment about an axis: m̄ in kg·m², closing speed in rad/s.
    pub fn is_moment(&self) -> bool {
        matches!(self, Direction::About(..))
    }

    /// Vector and frame of a normal or an axis given as a vector; `None` for a line.
    pub fn vector(&self) -> Option<(Vector3<f64>, Frame)> {
        match *self {
            Direction::Along(vector, frame) | Direction::About(vector, frame) => Some((vector, frame)),
            Direction::Toward(..) | Direction::TurningToward(..) | Direction::TurningAwayFrom(..) => None,
        }
    }

    /// Direction of the same kind with another vector and frame; a line is returned unchanged.
    pub(crate) fn with_vector(self, vector: Vector3<f64>, frame: Frame) -> Self {
        match self {
            Direction::Along(..) => Direction::Along(vector, frame),
            Direction::About(..) => Direction::About(vector, frame),
            Direction::Toward(..) | Direction::TurningToward(..) | Direction::TurningAwayFrom(..) => self,
        }
    }

    /// Smallest accepted cosine of the angle between the line and the line as drawn; below −1 if the line may turn.
    pub(crate) fn least_cosine(&self) -> f64 {
        match self {
            Direction::Toward(..) => LINE_TURNED,
            Direction::Along(..)
            | Direction::About(..)
            | Direction::TurningToward(..)
            | Direction::TurningAwayFrom(..) => -2.0,
        }
    }
}

/// A contact between one link and another link, or the ground: at a point along a normal, or by a moment about an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// The contact link.
    pub link: LinkId,
    /// The link on the other side; `None` for the ground.
    pub against: Option<LinkId>,
    /// The contact point in the frame of the contact link, m; has no effect for a moment.
    pub point: Vector3<f64>,
    /// The normal n̂, **out of the contact link into the other side**; the axis â of a moment.
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

    /// Moment about an axis (frame of the link) between a link and the ground.
    ///
    /// m̄ = 1/(j M⁻¹ jᵀ), kg·m², with j q̇ = â·ω. For a free body with the central inertia I_c, m̄ = 1/(âᵀ I_c⁻¹ â). For a link whose only
    /// joint is a hinge to the ground along â, m̄ is the moment of inertia about the hinge.
    pub fn about_axis(link: LinkId, axis: impl Into<Vector3<f64>>) -> Self {
        let normal = Direction::About(axis.into(), Frame::Link);
        Self { link, against: None, point: Vector3::zeros(), normal }
    }

    /// Stop of a joint with one velocity: a contact of child and parent whose closing speed is the rate of the joint, or minus this rate if
    /// not `is_upper`. For a hinge the contact is a moment about the joint axis, and m̄ is the inertia at the joint in kg·m². `None` unless
    /// the joint has one velocity.
    pub fn joint_stop(mechanism: &Mechanism, joint: JointId, is_upper: bool) -> Option<Self> {
        let joint = mechanism.joint(joint);
        let axis = if is_upper { *joint.axis() } else { -joint.axis() };
        let stop = match joint.kind() {
            JointKind::Revolute | JointKind::Continuous => Self::about_axis(joint.child(), axis),
            JointKind::Prismatic => Self::new(joint.child(), Vector3::zeros(), axis),
            JointKind::Fixed | JointKind::Planar | JointKind::Spherical | JointKind::Floating => return None,
        };
        Some(stop.against(joint.parent()))
    }

    /// Replaces the ground on the other side by a link.
    pub fn against(mut self, link: LinkId) -> Self {
        self.against = Some(link);
        self
    }

    /// True if the normal or the axis is constant in the world frame.
    pub(crate) fn has_world_normal(&self) -> bool {
        match self.normal.vector() {
            Some((_, Frame::World)) => true,
            Some((_, Frame::Against)) => self.against.is_none(),
            Some((_, Frame::Link)) | None => false,
        }
    }

    /// Replaces the normal or the axis.
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
    /// The axis of a moment.
    Axis,
    /// The point that the normal points towards.
    Line,
}

impl ContactPart {
    /// Name for messages.
    pub fn name(self) -> &'static str {
        match self {
            ContactPart::Point => "point",
            ContactPart::Normal => "normal",
            ContactPart::Axis => "axis",
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
    /// The normal or the axis is zero or shorter than 1e-9.
    #[error("the {} has length {length:e}; expected at least 1e-9, for a direction", part.name())]
    NoDirection {
        /// The normal or the axis.
        part: ContactPart,
        /// Length of the vector.
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
    /// Free body given by its mass as the other side of a moment.
    #[error(
        "the contact is a moment about an axis; the moment of inertia of the free body of {mass} kg on the other side is unknown; \
         expected the other body as a link of the mechanism"
    )]
    MassOfMoment {
        /// The given mass, kg.
        mass: f64,
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

/// A contact at a pose: the point and the unit normal in the world frame and in the frame of the contact link. For a moment the point is
/// the origin of the contact link, and the normal is the unit axis â.
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
    /// True for a moment about an axis: m̄ in kg·m², closing speed in rad/s.
    pub is_moment: bool,
    /// The point in the root link's frame, m.
    pub(crate) point_root: Vector3<f64>,
    /// n̂ in the root link's frame.
    pub(crate) normal_root: Vector3<f64>,
    /// Far end of the line that defines n̂, as a link and a point (m) in the link's frame; `None` for a fixed normal.
    pub(crate) line: Option<(LinkId, Vector3<f64>)>,
}

impl LocatedContact {
    /// Wrench of a unit impulse between the two sides, in the frame of the contact link: (p × n̂, n̂), or (â, 0) for a moment. Its power
    /// with the relative twist of the two sides is the closing speed.
    pub fn wrench_link(&self) -> Wrench<f64> {
        unit_wrench(self.is_moment, self.normal_link, &self.point_link)
    }

    /// The same wrench in root axes, about the contact point.
    pub(crate) fn wrench_root(&self) -> Wrench<f64> {
        unit_wrench(self.is_moment, self.normal_root, &Vector3::zeros())
    }

    /// Part of a twist (root axes, at the contact point) that is conjugate to the contact wrench: the linear velocity; for a moment, the
    /// angular velocity.
    pub(crate) fn conjugate_velocity(&self, twist: &Twist<f64>) -> Vector3<f64> {
        if self.is_moment { twist.angular } else { twist.linear }
    }
}

/// Wrench of a unit force along `direction` at a point, or of a unit moment about `direction`.
fn unit_wrench(is_moment: bool, direction: Vector3<f64>, point: &Vector3<f64>) -> Wrench<f64> {
    match is_moment {
        true => Wrench::new(direction, Vector3::zeros()),
        false => Wrench::of_force(direction, point),
    }
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
            Direction::Along(vector, _) | Direction::About(vector, _) => {
                let is_moment = contact.normal.is_moment();
                let part = if is_moment { ContactPart::Axis } else { ContactPart::Normal };
                finite(part, &vector)?;
                let length = vector.norm();
                if length < SHORTEST_DIRECTION {
                    return Err(ContactError::NoDirection { part, length });
                }
                Ok(())
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

    /// Contact point and normal of a checked contact; for a moment the origin of the contact link and the axis. The normal is zero if the
    /// ends of the line coincide.
    pub fn contact_point(
        &self,
        kinematics: &Kinematics,
        base: &Transform<f64>,
        contact: &Contact,
    ) -> ContactPoint {
        let x_rl = kinematics.link_frame(self, contact.link);
        let point = if contact.normal.is_moment() { x_rl.translation } else { x_rl.point(&contact.point) };
        let normal = match contact.normal {
            Direction::Along(normal, frame) | Direction::About(normal, frame) => {
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
            point_link: if contact.normal.is_moment() { Vector3::zeros() } else { contact.point },
            is_moment: contact.normal.is_moment(),
            normal_link: x_rl.inverse_vector(&normal),
            point_root: point,
            normal_root: normal,
            line: contact.normal.line(),
        })
    }
}

/// Checks that all components are valid numbers.
fn finite(part: ContactPart, v: &Vector3<f64>) -> Result<(), ContactError> {
    match v.iter().find(|x| !is_number(**x)) {
        Some(&value) => Err(ContactError::NotFinite { part, value }),
        None => Ok(()),
    }
}
