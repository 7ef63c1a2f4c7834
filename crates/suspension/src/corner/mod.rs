//! Corner of a vehicle under construction. All positions are those of the design position.

pub(crate) mod build;
pub(crate) mod bushes;
mod checks;
pub(crate) mod design;
pub(crate) mod drawing;
pub(crate) mod frames;
pub(crate) mod plausibility;
pub(crate) mod spindle;

use crate::findings::Spot;
use drawing::Drawing;
use percuss_formats::Comments;
use percuss_mechanism::{
    BushDescription, ClosureDescription, ClosureKind, ContactDescription, ContactKind, ContactNormal,
    Inertial, JointDescription, JointKind, LinkDescription, MechanismBuilder, SpringDamper,
};
use percuss_spatial::{Matrix3, Vector3};
use std::collections::HashMap;

/// Root link.
pub(crate) const CHASSIS: &str = "chassis";
/// Link with the inner ends of the tie rods.
pub(crate) const RACK: &str = "rack";

/// Links between both wheels.
const AXLES: [&str; 3] = ["axle", "axle_tube", "beam"];

/// Part of the mass of a spring or damper that moves with its moving seat, and of a half shaft that moves with the wheel.
const SHARE_OF_SEAT: f64 = 0.5;

/// Name of the ground as the other side of a contact.
pub(crate) const GROUND: &str = "world";

/// Mass and inertia of a link, in the vehicle frame at the design position.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass, m.
    pub com: Vector3<f64>,
    /// Inertia about the centre of mass, in the vehicle's axes, kg·m².
    pub about_com: Matrix3<f64>,
    /// Position in the file.
    pub spot: Spot,
    /// Position of the centre of mass in the file.
    pub com_spot: Spot,
}

/// Left side, the links common to both sides of an axle, and a right side that is no mirror image.
#[derive(Clone)]
pub(crate) struct Built {
    pub left: Corner,
    pub middle: Option<Corner>,
    /// Right side with points of its own, as its mirror image on the left.
    pub right: Option<Corner>,
}

/// Links, joints and closures of the left side; [`mirrored`](Self::mirrored) creates the right side.
///
/// At the design position, the axes of every link are parallel to the vehicle's. A link frame is therefore given by a
/// point, and joint origins and loop frames are differences of points.
#[derive(Clone, Debug)]
pub(crate) struct Corner {
    links: Vec<LinkDescription>,
    joints: Vec<JointDescription>,
    closures: Vec<ClosureDescription>,
    contacts: Vec<ContactDescription>,
    bushes: Vec<BushDescription>,
    /// Origin of each link frame in the vehicle frame, m.
    origins: HashMap<String, Vector3<f64>>,
    comments: Comments,
    spots: HashMap<String, Spot>,
    /// Positions of the centres of mass in the file, by link.
    com_spots: HashMap<String, Spot>,
    /// Pairs of seat frames: on the moving link, on the chassis.
    seat_pairs: Vec<[&'static str; 2]>,
    /// Links common to both sides; their names have no suffix.
    shared: Vec<&'static str>,
    /// Drawing of the corner.
    pub drawing: Drawing,
}

impl Corner {
    /// Creates a corner with only the chassis, at the origin of the vehicle frame.
    pub fn new() -> Self {
        Self {
            links: Vec::new(),
            joints: Vec::new(),
            closures: Vec::new(),
            contacts: Vec::new(),
            bushes: Vec::new(),
            origins: HashMap::from([(CHASSIS.to_owned(), Vector3::zeros())]),
            comments: Comments::default(),
            spots: HashMap::new(),
            com_spots: HashMap::new(),
            seat_pairs: Vec::new(),
            shared: vec![CHASSIS, RACK],
            drawing: Drawing::default(),
        }
    }

    /// Sets the spring of a joint.
    pub fn set_spring(&mut self, joint: &str, spring: SpringDamper) {
        for joint in self.joints.iter_mut().filter(|known| known.name == joint) {
            joint.spring = Some(spring);
        }
    }

    /// Axis of a joint, in the vehicle's axes.
    fn joint_axis(&self, name: &str) -> Option<Vector3<f64>> {
        self.joints.iter().find(|joint| joint.name == name).map(|joint| joint.axis)
    }

    /// Sets the frames of the links common to both sides to those of the other side.
    pub fn share_frames(&mut self, other: &Corner) {
        let of_other = other.origins.iter().filter(|(link, _)| other.is_shared(link));
        self.origins.extend(of_other.map(|(link, at)| (link.clone(), *at)));
    }

    /// Marks a link as common to both sides and sets its frame, unless the other side has set it. The link itself is added by this corner or by
    /// another.
    pub fn mark_shared(&mut self, link: &'static str, at: Vector3<f64>) {
        self.shared.push(link);
        self.origins.entry(link.to_owned()).or_insert(at);
    }

    /// True for a link common to both sides.
    pub fn is_shared(&self, link: &str) -> bool {
        self.shared.contains(&link)
    }

    /// Names of the links, sorted, without frames fixed to other links.
    pub fn link_names(&self) -> Vec<&str> {
        let is_frame = |name: &str| {
            self.joints.iter().any(|joint| joint.child == name && joint.kind == JointKind::Fixed)
        };
        let mut names: Vec<&str> =
            self.origins.keys().map(String::as_str).filter(|name| !is_frame(name)).collect();
        names.sort_unstable();
        names
    }

    /// True if the corner has a link of this name.
    pub fn has_link(&self, name: &str) -> bool {
        self.origins.contains_key(name)
    }

    /// Origin of the rack frame, if set.
    pub fn rack_origin(&self) -> Option<Vector3<f64>> {
        self.origins.get(RACK).copied()
    }

    /// Sets the rack frame to the midpoint between the inner ends of the two tie rods; `end` is one of them.
    pub fn set_rack_origin(&mut self, end: Vector3<f64>) {
        self.origins.entry(RACK.to_owned()).or_insert(Vector3::new(end.x, 0.0, end.z));
    }

    /// Origin of a link frame in the vehicle frame, m.
    fn origin(&self, link: &str) -> Vector3<f64> {
        self.origins.get(link).copied().unwrap_or_default()
    }

    /// Adds a link with its frame at the point `at`.
    pub fn add_link(
        &mut self,
        name: &str,
        at: Vector3<f64>,
        body: Option<&Body>,
        comment: impl Into<String>,
    ) {
        let mut link = LinkDescription::massless(name);
        if let Some(body) = body {
            link.inertial = Some(Inertial { mass: body.mass, com: body.com - at, about_com: body.about_com });
            self.spots.insert(name.to_owned(), body.spot.clone());
            self.com_spots.insert(name.to_owned(), body.com_spot.clone());
        }
        self.links.push(link);
        self.origins.insert(name.to_owned(), at);
        self.comments.links.insert(name.to_owned(), comment.into());
    }

    /// Adds a joint at the child frame; `axis` is in the vehicle's axes.
    pub fn add_joint(
        &mut self,
        (name, kind): (&str, JointKind),
        [parent, child]: [&str; 2],
        axis: Vector3<f64>,
        spot: &Spot,
        comment: impl Into<String>,
    ) {
        let at = self.origin(child) - self.origin(parent);
        let joint = JointDescription::new(name, kind, parent, child).at(at.into());
        self.joints.push(if kind.has_axis() { joint.axis(axis.into()) } else { joint });
        self.spots.insert(name.to_owned(), spot.clone());
        self.comments.joints.insert(name.to_owned(), comment.into());
    }

    /// Adds a massless link fixed to another, for contacts and measurements.
    pub fn add_frame(&mut self, name: &'static str, on: &str, at: Vector3<f64>, comment: impl Into<String>) {
        self.links.push(LinkDescription::massless(name));
        self.joints.push(
            JointDescription::new(format!("{name}_fixed"), JointKind::Fixed, on, name)
                .at((at - self.origin(on)).into()),
        );
        self.origins.insert(name.to_owned(), at);
        self.comments.links.insert(name.to_owned(), comment.into());
    }

    /// Adds the two seats of a spring or damper: on the moving link and on the chassis. Of its mass (kg), half is a point mass at the moving
    /// seat.
    pub fn add_seats(
        &mut self,
        [seat, chassis_seat]: [&'static str; 2],
        on: &str,
        [at, at_chassis]: [Vector3<f64>; 2],
        mass: Option<f64>,
    ) {
        match mass.filter(|mass| *mass > 0.0) {
            Some(mass) => self.add_point_mass(seat, on, at, SHARE_OF_SEAT * mass),
            None => self.add_frame(seat, on, at, String::new()),
        }
        self.add_frame(chassis_seat, CHASSIS, at_chassis, String::new());
        self.seat_pairs.push([seat, chassis_seat]);
        let name = seat.trim_end_matches("_seat").trim_end_matches("_pad");
        self.drawing.add_line(name, [at, at_chassis]);
    }

    /// Adds the part of the mass of a half shaft (kg) that moves with the wheel, at the outer joint.
    pub fn add_half_shaft(&mut self, mass: f64, at: Vector3<f64>) {
        if mass > 0.0 {
            self.add_point_mass("half_shaft_outer", "spindle", at, SHARE_OF_SEAT * mass);
        }
    }

    /// Adds a frame with a mass, kg.
    fn add_point_mass(&mut self, frame: &'static str, on: &str, at: Vector3<f64>, mass: f64) {
        self.add_frame(frame, on, at, String::new());
        if let Some(link) = self.links.last_mut() {
            link.inertial = Some(Inertial::point(mass, [0.0; 3]));
        }
    }

    /// Adds a named contact between the origins of two link frames; the normal is in the frame of the second.
    pub fn add_contact(
        &mut self,
        (name, kind): (&str, ContactKind),
        [link, against]: [&str; 2],
        normal: ContactNormal,
        gap: Option<f64>,
    ) {
        self.add_contact_at((name, kind), [link, against], self.origin(link), normal, gap);
    }

    /// Adds a named contact at a point of the vehicle, m; the normal as in [`add_contact`](Self::add_contact).
    pub fn add_contact_at(
        &mut self,
        (name, kind): (&str, ContactKind),
        [link, against]: [&str; 2],
        at: Vector3<f64>,
        normal: ContactNormal,
        gap: Option<f64>,
    ) {
        self.contacts.push(ContactDescription {
            name: name.to_owned(),
            kind,
            link: link.to_owned(),
            point: at - self.origin(link),
            against: against.to_owned(),
            normal,
            gap,
        });
    }

    /// Adds a closure at a point; `axis` is in the vehicle's axes.
    pub fn add_closure(
        &mut self,
        (name, kind): (&str, ClosureKind),
        [predecessor, successor]: [&str; 2],
        at: Vector3<f64>,
        axis: Vector3<f64>,
        (spot, comment): (&Spot, &str),
    ) {
        let (p, s) = (at - self.origin(predecessor), at - self.origin(successor));
        let closure = ClosureDescription::new(name, kind, predecessor, successor)
            .at(p.into(), s.into())
            .axis(axis.into());
        self.push_closure(closure, spot, comment);
    }

    /// Adds a massless rod with a ball joint at each end. Its length is the distance of the points.
    pub fn add_rod(
        &mut self,
        name: &str,
        [predecessor, successor]: [&str; 2],
        [a, b]: [Vector3<f64>; 2],
        (spot, comment): (&Spot, &str),
    ) {
        let (p, s) = (a - self.origin(predecessor), b - self.origin(successor));
        let closure = ClosureDescription::new(name, ClosureKind::Distance, predecessor, successor)
            .at(p.into(), s.into())
            .distance((b - a).norm());
        self.push_closure(closure, spot, comment);
        self.drawing.add_rod(name, [a, b], spot);
    }

    /// Adds a closure of cylindrical kind: translation along the axis and rotation about the axis are free.
    pub fn add_sliding_closure(
        &mut self,
        name: &str,
        links: [&str; 2],
        at: Vector3<f64>,
        axis: Vector3<f64>,
        spot: &Spot,
    ) {
        let comment = "slides and turns along its line";
        self.add_closure((name, ClosureKind::Cylindrical), links, at, axis, (spot, comment));
    }

    /// Adds a closure with its position in the file and its comment.
    fn push_closure(&mut self, closure: ClosureDescription, spot: &Spot, comment: &str) {
        self.spots.insert(closure.name.clone(), spot.clone());
        self.comments.closures.insert(closure.name.clone(), comment.to_owned());
        self.closures.push(closure);
    }

    /// Sets the position in the file for a link without values of its own.
    pub fn set_spot(&mut self, name: &str, spot: Spot) {
        self.spots.insert(name.to_owned(), spot);
    }

    /// Sets the position in the file of a bush, unless a part has the same name.
    fn set_spot_of_bush(&mut self, name: &str, spot: &Spot) {
        self.spots.entry(name.to_owned()).or_insert_with(|| spot.clone());
    }

    /// Mirror image in the vehicle's middle plane, y → −y. Mirrored motions have equal joint coordinates.
    ///
    /// With S = diag(1, −1, 1): points p → S p; inertias I → S I S; sliding axes a → S a; rotation axes
    /// a → −S a (a rotation R becomes S R S).
    pub fn mirrored(&self) -> Corner {
        let point = |p: &Vector3<f64>| Vector3::new(p.x, flip(p.y), p.z);
        let rotation_axis = |a: &Vector3<f64>| Vector3::new(flip(a.x), a.y, flip(a.z));
        // The frame of a shared link keeps its origin o: relative to o, S p is at S p − o, not at S (p − o).
        let origin_shift = |link: &str| {
            if self.is_shared(link) {
                Vector3::new(0.0, -2.0 * self.origin(link).y, 0.0)
            } else {
                Vector3::zeros()
            }
        };
        let mut corner = self.clone();
        for link in &mut corner.links {
            if let Some(inertial) = &mut link.inertial {
                inertial.com = point(&inertial.com);
                for (row, column) in [(0, 1), (1, 0), (1, 2), (2, 1)] {
                    inertial.about_com[(row, column)] = flip(inertial.about_com[(row, column)]);
                }
            }
        }
        for joint in &mut corner.joints {
            joint.origin.translation = point(&joint.origin.translation) + origin_shift(&joint.parent);
            joint.axis = match joint.kind {
                JointKind::Prismatic => point(&joint.axis),
                JointKind::Fixed
                | JointKind::Revolute
                | JointKind::Continuous
                | JointKind::Planar
                | JointKind::Spherical
                | JointKind::Floating => rotation_axis(&joint.axis),
            };
        }
        for closure in &mut corner.closures {
            for (frame, link) in [
                (&mut closure.predecessor_frame, &closure.predecessor),
                (&mut closure.successor_frame, &closure.successor),
            ] {
                frame.translation = point(&frame.translation) + origin_shift(link);
            }
            // The axis of a closure is a line without a sense.
            closure.axis = rotation_axis(&closure.axis);
            closure.axis2 = rotation_axis(&closure.axis2);
        }
        for contact in &mut corner.contacts {
            contact.point = point(&contact.point) + origin_shift(&contact.link);
            if let ContactNormal::Fixed(normal) = &mut contact.normal {
                *normal = point(normal);
            }
        }
        for bush in &mut corner.bushes {
            bush.frame.translation = point(&bush.frame.translation) + origin_shift(&bush.link);
            // The reversed y-axis keeps the frame right-handed; forces along y and moments about x and z change their sign.
            let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0));
            bush.frame.rotation = mirror * bush.frame.rotation * mirror;
            [0, 2, 4].into_iter().for_each(|row| bush.preload[row] = flip(bush.preload[row]));
        }
        let unshared_origins = corner.origins.iter_mut().filter(|(link, _)| !self.is_shared(link));
        unshared_origins.for_each(|(_, at)| *at = point(at));
        corner.drawing = self.drawing.mirrored();
        corner
    }

    /// Adds the corner to a mechanism, and its comments and file positions to `annotations`. Names of unshared links get
    /// the suffix.
    pub fn add_to(
        self,
        suffix: &str,
        mut builder: MechanismBuilder,
        annotations: &mut Annotations,
    ) -> MechanismBuilder {
        let shared = self.shared;
        let suffixed =
            |name: &str| if shared.contains(&name) { name.to_owned() } else { format!("{name}{suffix}") };
        let mut comments = self.comments;
        for [seat, chassis_seat] in self.seat_pairs {
            let line = self.origins[chassis_seat] - self.origins[seat];
            let (length, [x, y, z]) = (line.norm(), (line / line.norm()).into());
            let direction = format!("line {x:.12} {y:.12} {z:.12}, {length:.6} m at the design position");
            comments.links.insert(
                seat.to_owned(),
                format!("the moving seat; to {}: {direction}", suffixed(chassis_seat)),
            );
            comments.links.insert(
                chassis_seat.to_owned(),
                format!("the seat on the chassis, opposite {}", suffixed(seat)),
            );
        }
        for (from, into) in [
            (comments.links, &mut annotations.comments.links),
            (comments.joints, &mut annotations.comments.joints),
            (comments.closures, &mut annotations.comments.closures),
        ] {
            into.extend(from.into_iter().map(|(name, text)| (suffixed(&name), text)));
        }
        annotations.spots.extend(self.spots.into_iter().map(|(name, spot)| (suffixed(&name), spot)));
        for mut link in self.links {
            link.name = suffixed(&link.name);
            builder = builder.link(link);
        }
        for mut joint in self.joints {
            for name in [&mut joint.name, &mut joint.parent, &mut joint.child] {
                *name = suffixed(name);
            }
            builder = builder.joint(joint);
        }
        for mut closure in self.closures {
            for name in [&mut closure.name, &mut closure.predecessor, &mut closure.successor] {
                *name = suffixed(name);
            }
            builder = builder.closure(closure);
        }
        for mut contact in self.contacts {
            contact.name = format!("{}{suffix}", contact.name);
            contact.link = suffixed(&contact.link);
            if contact.against != GROUND {
                contact.against = suffixed(&contact.against);
            }
            builder = builder.contact(contact);
        }
        for mut bush in self.bushes {
            bush.name.push_str(suffix);
            bush.link = suffixed(&bush.link);
            if bush.against != GROUND {
                bush.against = suffixed(&bush.against);
            }
            bush.replaces.iter_mut().for_each(|joint| *joint = suffixed(joint));
            builder = builder.bush(bush);
        }
        builder
    }
}

/// Returns −x, and 0 for 0.
fn flip(x: f64) -> f64 {
    0.0 - x
}

/// Comments and file positions by name.
#[derive(Default)]
pub(crate) struct Annotations {
    pub comments: Comments,
    pub spots: HashMap<String, Spot>,
}
