//! Reads a corner from a file of Chrono::Vehicle according to its template.

use super::reader::{Reader, Section};
use super::sections::{MASS, SectionBody, VISUAL_KEYS, read_body, read_inertia};
use super::template::{ChronoTemplate, InertiaAxes, Notation, PlaneRule, SectionRule};
use crate::corner::build::build;
use crate::corner::design::{BushData, Design, GivenBody, GivenBush, Part};
use crate::corner::frames;
use crate::corner::spindle::Spindle;
use crate::corner::{Body, Corner};
use crate::findings::Spot;
use percuss_spatial::{Matrix3, Vector3};
use std::collections::BTreeMap;

const HINGE: &str =
    "about the line through the two points on the chassis, first to second; positive is droop";

/// Key of the data of a bush.
const BUSHING: &str = "Bushing Data";
/// Stiffness and damping of translations, with the expected values.
const LINEAR: [(&str, &str); 2] =
    [("Stiffness Linear", "a stiffness in N/m"), ("Damping Linear", "a damping in N·s/m")];
/// Stiffness and damping of rotations, with the expected values.
const ROTATIONAL: [(&str, &str); 2] =
    [("Stiffness Rotational", "a stiffness in N·m/rad"), ("Damping Rotational", "a damping in N·m·s/rad")];

/// Reads all sections first and builds only if no error was found.
pub(in super::super) fn read_corner<'t>(
    reader: &mut Reader<'t>,
    root: &mut Section<'t>,
    template: &'static ChronoTemplate,
    spindle: &Spindle,
) -> Option<Corner> {
    let arms_in_vehicle_axes = template.vehicle_axes_flag.as_ref().is_some_and(|key| reader.flag(root, key));
    let on = |(section, link): (&'static String, &String)| (&**section, (link.clone(), Spot::default()));
    let design = Design {
        parts: template.parts.iter().collect(),
        on: template.on.iter().map(on).collect(),
        unchecked_rods: true,
        hinge_comment: HINGE,
        ..Design::default()
    };
    let mut corner_reader =
        CornerReader { reader, root, design, pending_bodies: BTreeMap::new(), arms_in_vehicle_axes };
    for rule in &template.sections {
        match rule {
            SectionRule::Body { .. } => corner_reader.read_body_section(rule),
            SectionRule::Strut { key, link } => corner_reader.read_strut(key, link),
            SectionRule::TieRod { massless } => corner_reader.read_tie_rod(*massless),
            SectionRule::Seats { key, moving, seats } => corner_reader.read_seats(key, moving, seats),
        }
    }
    for rule in &template.planes {
        corner_reader.apply_plane_rule(rule);
    }
    let CornerReader { reader, design, .. } = corner_reader;
    if reader.has_errors() { None } else { Some(build(&design, spindle, None, reader)?.left) }
}

/// Reads the sections of a file into a design.
struct CornerReader<'r, 't> {
    reader: &'r mut Reader<'t>,
    root: &'r mut Section<'t>,
    design: Design,
    /// Bodies whose axes depend on points of several sections, by link.
    pending_bodies: BTreeMap<&'static str, SectionBody>,
    arms_in_vehicle_axes: bool,
}

impl<'t> CornerReader<'_, 't> {
    /// Reads a point, and adds it to the design as `name`.
    fn read_point(&mut self, section: &mut Section<'t>, key: &str, name: &'static str) -> Vector3<f64> {
        let at = self.reader.hardpoint(section, key, name);
        self.design.points.insert(name, (at, section.spot.clone()));
        at
    }

    /// Reads the section of a body: points, pins, and mass and inertia if the rule names a link.
    fn read_body_section(&mut self, rule: &'static SectionRule) {
        let SectionRule::Body { key, link, inertia, axes, points, pins } = rule else { return };
        let mut section = self.reader.section(self.root, key);
        let given = link.as_ref().map(|link| (link, read_body(self.reader, &mut section, *inertia)));
        let points: Vec<_> =
            points.iter().map(|(key, name)| self.read_point(&mut section, key, name)).collect();
        let pins = self.read_pins(&mut section, pins);
        let frame = self.inertia_frame(*axes, &points, &section.spot);
        if let (Some(pins), Some((link, _))) = (pins, &given) {
            let pins = self.joint_pins(pins, &section.spot);
            self.design.pins.insert(*link, pins);
        }
        if let Some((link, _)) = &given
            && self
                .design
                .parts
                .iter()
                .any(|part| matches!(part, Part::Hinge { link: arm, .. } if arm == *link))
        {
            self.read_bush(&mut section, link);
        }
        self.reader.warn_unread_keys(section, &VISUAL_KEYS);
        let Some((link, given)) = given else { return };
        let body = match axes {
            InertiaAxes::Plane => {
                self.pending_bodies.insert(link, given);
                return;
            }
            InertiaAxes::Vehicle => given.into_vehicle(),
            InertiaAxes::Arm if self.arms_in_vehicle_axes => given.into_vehicle(),
            InertiaAxes::Arm | InertiaAxes::XInward | InertiaAxes::XOutward => given.in_frame(&frame),
        };
        self.design.bodies.insert(link, GivenBody::Body(body));
    }

    /// Axes of the inertia of a section, from its points.
    fn inertia_frame(&mut self, axes: InertiaAxes, points: &[Vector3<f64>], spot: &Spot) -> Matrix3<f64> {
        let at = |i: usize| points.get(i).copied().unwrap_or_default();
        let vertical = "it is vertical, or its ends coincide: its axes are undetermined";
        let (frame, defect) = match axes {
            InertiaAxes::Vehicle | InertiaAxes::Plane => return Matrix3::identity(),
            InertiaAxes::Arm => {
                let defect = "the two points of its hinge and its outer point are on one line, or coincide";
                (frames::arm_axes(at(0), at(1), at(2)), defect)
            }
            InertiaAxes::XInward => (frames::along_x(at(0) - at(1)), vertical),
            InertiaAxes::XOutward => (frames::along_x(at(1) - at(0)), vertical),
        };
        self.reader.unwrap_geometry(frame, spot, defect)
    }

    /// Reads the directions of pins; `None` without keys.
    fn read_pins(&mut self, section: &mut Section<'t>, keys: &[String]) -> Option<GivenPins> {
        match keys {
            [] => None,
            [key] => Some(GivenPins::OfLink(self.reader.direction(section, key))),
            [chassis, link, ..] => Some(GivenPins::Both([chassis, link].map(|key| {
                let pin = frames::unit(self.reader.direction(section, key));
                let defect = format!("{key} is zero: it has no direction");
                self.reader.unwrap_geometry(pin, &section.spot, &defect)
            }))),
        }
    }

    /// Directions of the two pins of a universal joint: the pin fixed in the chassis, the pin fixed in the link.
    fn joint_pins(&mut self, pins: GivenPins, spot: &Spot) -> [Vector3<f64>; 2] {
        match pins {
            GivenPins::OfLink(pin) => {
                // The pin on the chassis is the component of ẑ normal to the pin of the link.
                let axes = frames::normal(pin, Vector3::z()).and_then(|w| frames::along_z(w, w.cross(&pin)));
                let defect = "Universal Joint Axis is zero or vertical: the other pin has no direction";
                let axes = self.reader.unwrap_geometry(axes, spot, defect);
                [axes.column(1).into_owned(), axes.column(0).into_owned()]
            }
            GivenPins::Both(pins) => {
                let defect = "the pins of its universal joint are parallel";
                self.reader.unwrap_geometry(frames::normal(pins[0], pins[1]), spot, defect);
                pins
            }
        }
    }

    /// Reads the mass and the inertia of a strut; a plane rule completes the body.
    fn read_strut(&mut self, key: &str, link: &'static str) {
        let mut section = self.reader.section(self.root, key);
        let mass = self.reader.number(&mut section, "Mass", MASS);
        let inertia = read_inertia(self.reader, &mut section, Notation::Moments);
        let (com, spot, axes) = (Vector3::zeros(), section.spot.clone(), self.reader.frame.axes);
        self.pending_bodies.insert(link, SectionBody { mass, com, inertia, spot, axes });
        self.reader.warn_unread_keys(section, &VISUAL_KEYS);
    }

    /// Reads the points of the tie rod, and the body if the tie rod has a mass.
    fn read_tie_rod(&mut self, massless: bool) {
        let mut section = self.reader.section(self.root, "Tierod");
        let inner = self.read_point(&mut section, "Location Chassis", "tie_rod_inner");
        let outer = self.read_point(&mut section, "Location Upright", "tie_rod_outer");
        if !massless && section.has("Mass") {
            let mass = self.reader.number(&mut section, "Mass", MASS);
            let inertia = read_inertia(self.reader, &mut section, Notation::Moments);
            let along = outer - inner;
            let frame = frames::normal(along, Vector3::x()).and_then(|y| frames::along_z(along, y));
            let defect = "it lies along x, or its ends coincide";
            let frame = self.reader.unwrap_geometry(frame, &section.spot, defect);
            let (com, about_com) = ((inner + outer) / 2.0, frames::rotate_inertia(&frame, &inertia));
            let spot = section.spot.clone();
            let body = Body { mass, com, about_com, com_spot: spot.clone(), spot };
            self.design.bodies.insert("tie_rod", GivenBody::Body(body));
            self.design.pins.insert("tie_rod", first_two_axes(&frame));
            self.read_bush(&mut section, "tie_rod");
        }
        self.reader.warn_unread_keys(section, &["Inertia", "Radius"]);
    }

    /// Reads the bush of a link, if the section has one: Chrono puts one at the middle of a hinge, and one at each end of a tie rod. Its DOF
    /// values of translations have no effect.
    fn read_bush(&mut self, section: &mut Section<'t>, link: &str) {
        if !section.has(BUSHING) {
            return;
        }
        let mut data = self.reader.section(section, BUSHING);
        let spot = data.spot.clone();
        let pair = |reader: &mut Reader<'t>, section: &mut Section<'t>, keys: [(&str, &str); 2]| {
            keys.map(|(key, expected)| {
                let value = reader.number_or_zero(section, key, expected);
                if value < 0.0 {
                    let message = format!("{key} is {value}; {expected} of at least 0 is expected");
                    reader.error("bad-bush", &section.spot, message);
                }
                value
            })
        };
        let linear = pair(self.reader, &mut data, LINEAR);
        let rotational = pair(self.reader, &mut data, ROTATIONAL);
        let mut free = [0.0; 2];
        if data.has("DOF") {
            let mut dof = self.reader.section(&mut data, "DOF");
            pair(self.reader, &mut dof, LINEAR);
            free = pair(self.reader, &mut dof, ROTATIONAL);
            self.reader.warn_unread_keys(dof, &[]);
        }
        if linear[0] <= 0.0 || rotational[0] <= 0.0 {
            let message =
                "\"Stiffness Linear\" in N/m and \"Stiffness Rotational\" in N·m/rad are expected, above 0";
            self.reader.error("bad-bush", &spot, message.to_owned());
        }
        self.reader.warn_unread_keys(data, &[]);
        let data = BushData::ByJoint { linear, rotational, free };
        self.design.bushes.insert(link.to_owned(), GivenBush::new(data, spot));
    }

    /// Reads the ends of a spring or shock absorber. Force laws are not read: they come in many kinds and do not
    /// affect the effective mass.
    fn read_seats(&mut self, key: &str, moving: &str, [seat, chassis_seat]: &'static [String; 2]) {
        let mut section = self.reader.section(self.root, key);
        let above = self.reader.hardpoint(&mut section, "Location Chassis", chassis_seat);
        let at = self.reader.hardpoint(&mut section, moving, seat);
        let line = frames::unit(above - at).map(|_| ());
        self.reader.unwrap_geometry(line, &section.spot, "its ends coincide: it has no line");
        for (name, at) in [(seat, at), (chassis_seat, above)] {
            self.design.points.insert(name, (at, Spot::default()));
        }
    }

    /// Completes a body whose axes depend on points of several sections.
    fn apply_plane_rule(&mut self, rule: &'static PlaneRule) {
        let Some(given) = self.pending_bodies.remove(&*rule.link) else { return };
        let [a, b] = rule.ends.each_ref().map(|point| self.design.point(point).unwrap_or_default());
        let third = self.design.point(&rule.third).unwrap_or_default();
        let y = frames::normal(a - third, b - third);
        let frame = y.and_then(|y| frames::along_z(b - a, y));
        let frame = self.reader.unwrap_geometry(frame, &given.spot, &rule.defect);
        let body = match &rule.strut {
            Some(names) => {
                for (name, at) in names.iter().zip([a, b]) {
                    self.design.points.insert(name, (at, given.spot.clone()));
                }
                self.design.pins.insert(&rule.link, first_two_axes(&frame));
                SectionBody { com: (a + b) / 2.0, ..given }.into_vehicle()
            }
            None => given.in_frame(&frame),
        };
        self.design.bodies.insert(&rule.link, GivenBody::Body(body));
    }
}

/// Directions of pins in a file.
enum GivenPins {
    /// Pin of the link; the pin of the chassis follows from it.
    OfLink(Vector3<f64>),
    /// Pins of chassis and link.
    Both([Vector3<f64>; 2]),
}

/// x and y axis of a frame.
fn first_two_axes(frame: &Matrix3<f64>) -> [Vector3<f64>; 2] {
    [0, 1].map(|i| frame.column(i).into_owned())
}
