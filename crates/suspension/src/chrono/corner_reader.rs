//! Reads a corner from a file of Chrono::Vehicle according to its template.

use super::super::build::build;
use super::super::corner::{Body, Corner};
use super::super::design::{Design, Stated};
use super::super::findings::Spot;
use super::super::frames;
use super::super::spindle::Spindle;
use super::reader::{Reader, Section};
use super::sections::{DRAWN, MASS, SectionBody, read_body, read_inertia};
use super::template::{ChronoTemplate, Notation, OwnAxes, PlaneRule, SectionRule};
use percuss_spatial::{Matrix3, Vector3};
use std::collections::BTreeMap;

const HINGE: &str =
    "about the line through the two points on the chassis, first to second; positive is droop";

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
        CornerReader { reader, root, design, in_planes: BTreeMap::new(), arms_in_vehicle_axes };
    for rule in &template.sections {
        match rule {
            SectionRule::Body { .. } => corner_reader.body(rule),
            SectionRule::Strut { key, link } => corner_reader.strut(key, link),
            SectionRule::TieRod { massless } => corner_reader.tie_rod(*massless),
            SectionRule::Seats { key, moving, seats } => corner_reader.seats(key, moving, seats),
        }
    }
    for rule in &template.planes {
        corner_reader.plane(rule);
    }
    let CornerReader { reader, design, .. } = corner_reader;
    if reader.has_errors() { None } else { Some(build(&design, spindle, reader)?.left) }
}

struct CornerReader<'r, 't> {
    reader: &'r mut Reader<'t>,
    root: &'r mut Section<'t>,
    design: Design,
    /// Bodies with axes that depend on points of other sections.
    in_planes: BTreeMap<&'static str, SectionBody>,
    arms_in_vehicle_axes: bool,
}

impl<'t> CornerReader<'_, 't> {
    fn point(&mut self, section: &mut Section<'t>, key: &str, name: &'static str) -> Vector3<f64> {
        let at = self.reader.point(section, key);
        self.design.points.insert(name, (at, section.spot.clone()));
        at
    }

    fn body(&mut self, rule: &'static SectionRule) {
        let SectionRule::Body { key, link, inertia, axes, points, pins } = rule else { return };
        let mut section = self.reader.section(self.root, key);
        let stated = link.as_ref().map(|link| (link, read_body(self.reader, &mut section, *inertia)));
        let points: Vec<_> = points.iter().map(|(key, name)| self.point(&mut section, key, name)).collect();
        let pins = self.read_pins(&mut section, pins);
        let frame = self.own_frame(*axes, &points, &section.spot);
        if let (Some(pins), Some((link, _))) = (pins, &stated) {
            let pins = self.pins(pins, &section.spot);
            self.design.pins.insert(*link, pins);
        }
        self.reader.close(section, &DRAWN);
        let Some((link, stated)) = stated else { return };
        let body = match axes {
            OwnAxes::Plane => {
                self.in_planes.insert(link, stated);
                return;
            }
            OwnAxes::Vehicle => stated.into_vehicle(),
            OwnAxes::Arm if self.arms_in_vehicle_axes => stated.into_vehicle(),
            OwnAxes::Arm | OwnAxes::XInward | OwnAxes::XOutward => stated.in_frame(&frame),
        };
        self.design.bodies.insert(link, Stated::Body(body));
    }

    /// Axes of a section, from its points.
    fn own_frame(&mut self, axes: OwnAxes, points: &[Vector3<f64>], spot: &Spot) -> Matrix3<f64> {
        let at = |i: usize| points.get(i).copied().unwrap_or_default();
        let vertical = "it is vertical, or its ends coincide: its axes have no direction";
        let (frame, defect) = match axes {
            OwnAxes::Vehicle | OwnAxes::Plane => return Matrix3::identity(),
            OwnAxes::Arm => {
                let defect = "its hinge's points and its outer point lie on one line, or coincide";
                (frames::arm(at(0), at(1), at(2)), defect)
            }
            OwnAxes::XInward => (frames::along_x(at(0) - at(1)), vertical),
            OwnAxes::XOutward => (frames::along_x(at(1) - at(0)), vertical),
        };
        self.reader.unwrap_geometry(frame, spot, defect)
    }

    /// Reads the directions of pins; `None` without keys.
    fn read_pins(&mut self, section: &mut Section<'t>, keys: &[String]) -> Option<Pins> {
        match keys {
            [] => None,
            [key] => Some(Pins::OfLink(self.reader.direction(section, key))),
            [chassis, link, ..] => Some(Pins::Both([chassis, link].map(|key| {
                let pin = frames::unit(self.reader.direction(section, key));
                let defect = format!("{key} is zero: it has no direction");
                self.reader.unwrap_geometry(pin, &section.spot, &defect)
            }))),
        }
    }

    /// Pins of a universal joint: fixed in the chassis, fixed in the link.
    fn pins(&mut self, pins: Pins, spot: &Spot) -> [Vector3<f64>; 2] {
        match pins {
            Pins::OfLink(pin) => {
                // The pin on the chassis is the component of ẑ normal to the pin of the link.
                let axes = frames::normal(pin, Vector3::z()).and_then(|w| frames::along_z(w, w.cross(&pin)));
                let defect = "Universal Joint Axis is zero or vertical: the other pin has no direction";
                let axes = self.reader.unwrap_geometry(axes, spot, defect);
                [axes.column(1).into_owned(), axes.column(0).into_owned()]
            }
            Pins::Both(pins) => {
                let defect = "the pins of its universal joint are parallel";
                self.reader.unwrap_geometry(frames::normal(pins[0], pins[1]), spot, defect);
                pins
            }
        }
    }

    fn strut(&mut self, key: &str, link: &'static str) {
        let mut section = self.reader.section(self.root, key);
        let mass = self.reader.number(&mut section, "Mass", MASS);
        let inertia = read_inertia(self.reader, &mut section, Notation::Moments);
        let (com, spot, axes) = (Vector3::zeros(), section.spot.clone(), self.reader.frame.axes);
        self.in_planes.insert(link, SectionBody { mass, com, inertia, spot, axes });
        self.reader.close(section, &DRAWN);
    }

    fn tie_rod(&mut self, massless: bool) {
        let mut section = self.reader.section(self.root, "Tierod");
        let inner = self.point(&mut section, "Location Chassis", "tie_rod_inner");
        let outer = self.point(&mut section, "Location Upright", "tie_rod_outer");
        if !massless && section.has("Mass") {
            let mass = self.reader.number(&mut section, "Mass", MASS);
            let inertia = read_inertia(self.reader, &mut section, Notation::Moments);
            let along = outer - inner;
            let frame = frames::normal(along, Vector3::x()).and_then(|y| frames::along_z(along, y));
            let defect = "it lies along x, or its ends coincide";
            let frame = self.reader.unwrap_geometry(frame, &section.spot, defect);
            let (com, about_com) = ((inner + outer) / 2.0, frames::turned(&frame, &inertia));
            let body = Body { mass, com, about_com, spot: section.spot.clone() };
            self.design.bodies.insert("tie_rod", Stated::Body(body));
            self.design.pins.insert("tie_rod", x_and_y(&frame));
        }
        self.reader.close(section, &["Inertia", "Radius"]);
    }

    /// Reads the ends of a spring or shock absorber. Force laws are not read: they come in many kinds and do not
    /// affect the effective mass.
    fn seats(&mut self, key: &str, moving: &str, [seat, chassis_seat]: &'static [String; 2]) {
        let mut section = self.reader.section(self.root, key);
        let [above, at] = ["Location Chassis", moving].map(|key| self.reader.point(&mut section, key));
        let line = frames::unit(above - at).map(|_| ());
        self.reader.unwrap_geometry(line, &section.spot, "its ends coincide: it has no line");
        for (name, at) in [(seat, at), (chassis_seat, above)] {
            self.design.points.insert(name, (at, Spot::default()));
        }
    }

    /// Determines the axes of a body that depend on points of several sections.
    fn plane(&mut self, rule: &'static PlaneRule) {
        let Some(stated) = self.in_planes.remove(&*rule.link) else { return };
        let [a, b] = rule.ends.each_ref().map(|point| self.design.at(point).unwrap_or_default());
        let third = self.design.at(&rule.third).unwrap_or_default();
        let y = frames::normal(a - third, b - third);
        let frame = y.and_then(|y| frames::along_z(b - a, y));
        let frame = self.reader.unwrap_geometry(frame, &stated.spot, &rule.defect);
        let body = match &rule.strut {
            Some(names) => {
                for (name, at) in names.iter().zip([a, b]) {
                    self.design.points.insert(name, (at, stated.spot.clone()));
                }
                self.design.pins.insert(&rule.link, x_and_y(&frame));
                SectionBody { com: (a + b) / 2.0, ..stated }.into_vehicle()
            }
            None => stated.in_frame(&frame),
        };
        self.design.bodies.insert(&rule.link, Stated::Body(body));
    }
}

/// Directions of pins in a file.
enum Pins {
    /// Pin of the link; the pin of the chassis follows from it.
    OfLink(Vector3<f64>),
    /// Pins of chassis and link.
    Both([Vector3<f64>; 2]),
}

fn x_and_y(frame: &Matrix3<f64>) -> [Vector3<f64>; 2] {
    [0, 1].map(|i| frame.column(i).into_owned())
}
