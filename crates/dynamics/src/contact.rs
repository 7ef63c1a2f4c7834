//! Where the mechanism is struck, and how fast the gap closes.

use crate::input::{foreign_link, is_number};
use crate::kinematics::Kinematics;
use crate::model::Model;
use crate::tangent;
use crate::tolerances::{LINE_TURNED, SHORTEST_DIRECTION, SHORTEST_LINE};
use nalgebra::{DMatrix, Vector3};
use percuss_mechanism::LinkId;
use percuss_spatial::{Scalar, Transform};

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
    /// From the contact point towards a point (m) of another link, in that link's frame: the normal of a stop. Refused where
    /// the line has turned by more than 5° from the line as drawn (all joints at 0), seen from the other side, or is shorter
    /// than a tenth of it: where its points come past each other it is no longer the normal of anything.
    Toward(LinkId, Vector3<f64>),
    /// The same line, which may turn: a spring, a damper or a rod between two points. Refused where it is shorter than a tenth
    /// of the line as drawn.
    TurningToward(LinkId, Vector3<f64>),
}

impl Direction {
    /// The far end of the line that the normal is taken along, if it is: a link and a point (m) in its frame.
    pub fn line(&self) -> Option<(LinkId, Vector3<f64>)> {
        match *self {
            Direction::Along(..) => None,
            Direction::Toward(link, point) | Direction::TurningToward(link, point) => Some((link, point)),
        }
    }

    /// The least cosine of the angle between the line and the line as drawn; below −1 where the line may turn.
    pub(crate) fn least_cosine(&self) -> f64 {
        match self {
            Direction::Toward(..) => LINE_TURNED,
            Direction::Along(..) | Direction::TurningToward(..) => -2.0,
        }
    }
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
    /// A point (m) of a link meets the ground along a normal, both in the link's frame.
    pub fn new(link: LinkId, point: impl Into<Vector3<f64>>, normal: impl Into<Vector3<f64>>) -> Self {
        Self {
            link,
            against: None,
            point: point.into(),
            normal: Direction::Along(normal.into(), Frame::Link),
        }
    }

    /// Puts another link on the other side, instead of the ground.
    pub fn against(mut self, link: LinkId) -> Self {
        self.against = Some(link);
        self
    }

    /// True if the normal is given in the world.
    pub(crate) fn has_world_normal(&self) -> bool {
        match self.normal {
            Direction::Along(_, Frame::World) => true,
            Direction::Along(_, Frame::Against) => self.against.is_none(),
            Direction::Along(_, Frame::Link) | Direction::Toward(..) | Direction::TurningToward(..) => false,
        }
    }

    /// Gives the normal otherwise.
    pub fn normal(mut self, normal: Direction) -> Self {
        self.normal = normal;
        self
    }
}

/// A vector that a contact is given by.
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
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            ContactPart::Point => "point",
            ContactPart::Normal => "normal",
            ContactPart::Line => "line",
        }
    }
}

/// A contact that means nothing.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ContactError {
    /// NaN, infinite or absurdly large.
    #[error("the contact {} has a component {value:e}; expected a finite number of at most 1e100", part.name())]
    NotFinite {
        /// Of what.
        part: ContactPart,
        /// The component.
        value: f64,
    },
    /// The normal is zero, or all but.
    #[error("the normal has length {length:e}; expected at least 1e-9, for a direction")]
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
    /// The line's points come past each other: its direction says nothing.
    #[error(
        "the line towards \"{link}\" is {length:.3e} m long at this pose, less than a tenth of its {drawn:.3e} m as drawn: its \
         direction is no normal. Give the direction as drawn as a fixed normal, {} in the frame of the {}",
        triple(normal), side(*frame)
    )]
    LineShort {
        /// The other link.
        link: String,
        /// Its length, m.
        length: f64,
        /// Its length as drawn, m.
        drawn: f64,
        /// Its unit vector as drawn.
        normal: Vector3<f64>,
        /// The frame of that: of the other side, or the world's.
        frame: Frame,
    },
    /// The line of a stop has turned.
    #[error(
        "the line towards \"{link}\" has turned by {:.1}° from its direction as drawn; up to 5° is the normal of a stop. Give the \
         direction as drawn as a fixed normal, {} in the frame of the {}, or state that the line may turn, as of a spring",
        angle.to_degrees(), triple(normal), side(*frame)
    )]
    LineTurned {
        /// The other link.
        link: String,
        /// By how much, rad.
        angle: f64,
        /// Its unit vector as drawn.
        normal: Vector3<f64>,
        /// The frame of that: of the other side, or the world's.
        frame: Frame,
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
    /// A free body on the other side without a mass, or with one that is none.
    #[error("the other side's mass is {mass} kg; expected a finite number above {least:e}")]
    OtherMass {
        /// What was given, kg.
        mass: f64,
        /// What it must exceed, kg.
        least: f64,
    },
    /// A link struck by itself.
    #[error("link \"{link}\" cannot be in contact with itself; name another link, or none for the ground")]
    Itself {
        /// The link.
        link: String,
    },
}

/// A direction with six decimals: a millionth of a radian is 1e-12 of m̄.
fn triple(v: &Vector3<f64>) -> String {
    let [x, y, z] = [v.x, v.y, v.z].map(|x| (x * 1e6).round() / 1e6 + 0.0);
    format!("({x}, {y}, {z})")
}

fn side(frame: Frame) -> &'static str {
    match frame {
        Frame::Link => "struck link",
        Frame::World => "world",
        Frame::Against => "other side",
    }
}

/// The line of a contact as drawn, all joints at 0.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DrawnLine {
    /// Unit vector in the frame of the other side; the root link's, where that is the ground.
    pub unit: Vector3<f64>,
    /// Its length, m.
    pub length: f64,
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
    /// The far end of the line that n̂ is taken along, if it is: a link and a point (m) in its frame.
    pub(crate) line: Option<(LinkId, Vector3<f64>)>,
}

/// A contact's point and unit normal in the root link's frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ContactPoint<T: Scalar> {
    pub point: Vector3<T>,
    pub normal: Vector3<T>,
}

impl Model {
    /// Refuses a contact that means nothing on this mechanism.
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
            Direction::Toward(_, point) | Direction::TurningToward(_, point) => {
                finite(ContactPart::Line, &point)
            }
        }
    }

    /// The line that the normal of a contact is taken along, all joints at 0. `None` for another normal, and where the line
    /// has no length as drawn.
    pub fn drawn_line(&self, contact: &Contact) -> Option<DrawnLine> {
        let (link, to) = contact.normal.line()?;
        let line = self.drawn_frame(link).point(&to) - self.drawn_frame(contact.link).point(&contact.point);
        let unit = line.try_normalize(SHORTEST_DIRECTION)?;
        let unit = contact.against.map_or(unit, |against| self.drawn_frame(against).inverse_vector(&unit));
        Some(DrawnLine { unit, length: line.norm() })
    }

    /// X_rl of a link, all joints at 0.
    fn drawn_frame(&self, link: LinkId) -> Transform<f64> {
        let on = &self.link_frames[link.index()];
        let (mut frame, mut at) = (on.frame, on.body);
        while let Some(i) = at {
            let body = &self.bodies[i];
            if let Some(joint) = body.joint {
                // A floating joint has the most positions.
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

    /// Refuses a line that is not, at this pose, the normal that it is as drawn.
    fn check_line(
        &self,
        kinematics: &Kinematics<f64>,
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

    /// The point and the normal of a checked contact. A line whose ends coincide has no normal: it comes out as zero.
    pub fn contact_point<T: Scalar>(
        &self,
        kinematics: &Kinematics<T>,
        base: &Transform<f64>,
        contact: &Contact,
    ) -> ContactPoint<T> {
        let x_rl = kinematics.link_frame(self, contact.link);
        let point = x_rl.point(&contact.point.map(T::from_f64));
        let normal = match contact.normal {
            Direction::Along(normal, frame) => {
                let unit = normal.normalize();
                let in_frame = unit.map(T::from_f64);
                match (frame, contact.against) {
                    (Frame::Link, _) => x_rl.vector(&in_frame),
                    (Frame::Against, Some(other)) => kinematics.link_frame(self, other).vector(&in_frame),
                    (Frame::World, _) | (Frame::Against, None) => base.inverse_vector(&unit).map(T::from_f64),
                }
            }
            Direction::Toward(link, to) | Direction::TurningToward(link, to) => {
                let line = kinematics.link_frame(self, link).point(&to.map(T::from_f64)) - point;
                let square = line.dot(&line) + T::from_f64(f64::MIN_POSITIVE);
                line * (T::one() / square.sqrt())
            }
        };
        ContactPoint { point, normal }
    }

    /// Finds the point and the normal of a contact.
    pub fn locate(
        &self,
        kinematics: &Kinematics<f64>,
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

    /// The contact row over tree velocities, and the size of the terms whose sum each entry is. Velocities that carry both
    /// sides cancel and are left out.
    pub fn contact_row(&self, kinematics: &Kinematics<f64>, contact: &LocatedContact) -> ContactRow {
        let mut row = ContactRow::default();
        self.contact_row_into(kinematics, contact, &mut row);
        row
    }

    /// [`contact_row`](Self::contact_row) in place.
    pub fn contact_row_into(
        &self,
        kinematics: &Kinematics<f64>,
        contact: &LocatedContact,
        row: &mut ContactRow,
    ) {
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

    /// Velocity of the point `at` (root frame) at unit velocity `k` of body `i`, and the size of its terms.
    fn velocity_column(
        &self,
        kinematics: &Kinematics<f64>,
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

    /// Jacobian of a point (m, link's frame) of a link, 3×n over the coordinates, root axes.
    pub fn point_jacobian(
        &self,
        kinematics: &Kinematics<f64>,
        link: LinkId,
        point: &Vector3<f64>,
    ) -> DMatrix<f64> {
        let at = kinematics.link_frame(self, link).point(point);
        let mut jacobian = DMatrix::zeros(3, self.coordinates.len());
        self.for_each_support(self.body_of(link), None, |i, _| {
            for (k, v) in self.bodies[i].v.clone().enumerate() {
                if let Some(f) = self.follows[v] {
                    let column = self.velocity_column(kinematics, i, k, &at).0 * f.multiplier;
                    let mut target = jacobian.column_mut(f.index);
                    target += column;
                }
            }
        });
        jacobian
    }
}

/// An entry of the contact row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RowEntry {
    /// Among the tree's velocities.
    pub velocity: usize,
    pub body: usize,
    pub value: f64,
    /// Size of the terms whose sum it is.
    pub size: f64,
    pub turns: bool,
}

/// The contact row over tree velocities, its entries that are not structurally zero.
#[derive(Clone, Debug, Default)]
pub(crate) struct ContactRow {
    pub entries: Vec<RowEntry>,
    /// The contact's own length, m: its greatest arm about a joint that turns.
    pub length: f64,
}

fn finite(part: ContactPart, v: &Vector3<f64>) -> Result<(), ContactError> {
    match v.iter().find(|x| !is_number(**x)) {
        Some(&value) => Err(ContactError::NotFinite { part, value }),
        None => Ok(()),
    }
}
