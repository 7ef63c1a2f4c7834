//! Parts common to several templates: bodies, hinged arms, Hooke's joints, tie rods, seats.

use super::corner::{Body, CHASSIS, Corner, RACK};
use super::findings::{Findings, Spot};
use super::frames;
use super::reader::{Reader, Section};
use super::units::VehicleAxes;
use crate::reading::limits::OBLIQUE_PINS;
use percuss_mechanism::{ClosureKind, JointKind};
use percuss_spatial::{Matrix3, Vector3};

/// Keys that affect only the visualisation.
const DRAWN: [&str; 2] = ["Radius", "Width"];

/// Notation of inertias in a file.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Inertias {
    /// `Inertia`: three principal moments.
    Moments,
    /// `Moments of Inertia` and `Products of Inertia` (matrix entries xy, xz, yz).
    WithProducts,
}

/// Body as given in the file: the template defines the axes of the inertia.
pub(super) struct Stated {
    mass: f64,
    pub com: Vector3<f64>,
    pub inertia: Matrix3<f64>,
    pub spot: Spot,
    /// Vehicle axes of the file.
    axes: VehicleAxes,
}

impl Stated {
    /// Mass, kg.
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// Converts an inertia given in the vehicle's axes.
    pub fn into_vehicle(self) -> Body {
        let about_com = self.axes.inertia_to_iso(self.inertia);
        Body { mass: self.mass, com: self.com, about_com, spot: self.spot }
    }

    /// Converts an inertia given in `frame`.
    pub fn in_frame(self, frame: &Matrix3<f64>) -> Body {
        let about_com = frames::turned(frame, &self.inertia);
        Body { mass: self.mass, com: self.com, about_com, spot: self.spot }
    }
}

/// Reads mass, centre of mass and inertia of a section.
pub(super) fn body<'t>(reader: &mut Reader<'t>, section: &mut Section<'t>, how: Inertias) -> Stated {
    let mass = reader.number(section, "Mass", MASS);
    let com = reader.point(section, "COM");
    let inertia = inertia(reader, section, how);
    Stated { mass, com, inertia, spot: section.spot.clone(), axes: reader.frame.axes }
}

const MASS: &str = "a mass in kg";
const MOMENTS: &str = "three moments in kg·m², [xx, yy, zz],";

fn inertia<'t>(reader: &mut Reader<'t>, section: &mut Section<'t>, how: Inertias) -> Matrix3<f64> {
    match how {
        Inertias::Moments => Matrix3::from_diagonal(&reader.triple(section, "Inertia", MOMENTS)),
        Inertias::WithProducts => {
            let moments = reader.triple(section, "Moments of Inertia", MOMENTS);
            let expected = "the inertia matrix's entries [xy, xz, yz] in kg·m²";
            let products = reader.triple(section, "Products of Inertia", expected);
            if products != Vector3::zeros() {
                reader.products.get_or_insert_with(|| section.spot.clone());
            }
            let mut matrix = Matrix3::from_diagonal(&moments);
            for (value, (row, column)) in products.iter().zip([(0, 1), (0, 2), (1, 2)]) {
                matrix[(row, column)] = *value;
                matrix[(column, row)] = *value;
            }
            matrix
        }
    }
}

/// Reads a section that contains only a body.
pub(super) fn lone_body<'t>(
    reader: &mut Reader<'t>,
    root: &mut Section<'t>,
    key: &str,
    how: Inertias,
) -> Body {
    let mut section = reader.section(root, key);
    let stated = body(reader, &mut section, how);
    reader.close(section, &DRAWN);
    stated.into_vehicle()
}

/// Closes the section of a body; keys for visualisation are ignored.
pub(super) fn close<'t>(reader: &mut Reader<'t>, section: Section<'t>) {
    reader.close(section, &DRAWN);
}

/// Unwraps a value computed from hardpoints. `None` is reported as degenerate geometry, unless an earlier error
/// explains it; the result is then the default.
pub(super) fn spanned<T: Default>(findings: &mut Findings, value: Option<T>, spot: &Spot, defect: &str) -> T {
    if value.is_none() && !findings.has_errors() {
        findings.error("degenerate-geometry", spot, defect.to_owned());
    }
    value.unwrap_or_default()
}

/// Arm on a hinge, with a ball joint at the outer end.
pub(super) struct Arm {
    pub body: Option<Body>,
    /// Points of the hinge (front, back) and of the ball joint, m.
    pub front: Vector3<f64>,
    pub back: Vector3<f64>,
    pub ball: Vector3<f64>,
    pub spot: Spot,
}

/// Axes of an arm's inertia.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Axes {
    /// Axes of the arm's own plane.
    Own,
    /// Axes of the vehicle.
    Vehicle,
}

/// Reads an arm. `how` gives the notation of its body; `None` reads the points only.
pub(super) fn arm<'t>(
    reader: &mut Reader<'t>,
    root: &mut Section<'t>,
    key: &str,
    [front, back, ball]: [&str; 3],
    how: Option<(Inertias, Axes)>,
) -> Arm {
    let mut section = reader.section(root, key);
    let stated = how.map(|(inertias, axes)| (body(reader, &mut section, inertias), axes));
    let [front, back, ball] = [front, back, ball].map(|key| reader.point(&mut section, key));
    let spot = section.spot.clone();
    close(reader, section);
    let defect = "its hinge's points and its outer point lie on one line, or coincide";
    let frame = spanned(reader, frames::arm(front, back, ball), &spot, defect);
    let body = stated.map(|(stated, axes)| match axes {
        Axes::Own => stated.in_frame(&frame),
        Axes::Vehicle => stated.into_vehicle(),
    });
    Arm { body, front, back, ball, spot }
}

pub(super) const WISHBONE: [&str; 3] =
    ["Location Chassis Front", "Location Chassis Back", "Location Upright"];

impl Arm {
    /// Unit vector of the hinge axis, from front to back: a positive angle lowers the wheel (droop).
    fn hinge(&self) -> Vector3<f64> {
        frames::unit(self.back - self.front).unwrap_or_default()
    }

    /// Adds the arm and its hinge on the chassis.
    pub fn attach(&self, corner: &mut Corner, name: &str) {
        let comment = format!("{}: frame at the hinge's first point", self.spot.label());
        corner.link(name, self.front, self.body.as_ref(), comment);
        let joint = (&*format!("{name}_hinge"), JointKind::Revolute);
        let comment =
            "about the line through the two points on the chassis, first to second; positive is droop";
        corner.joint(joint, [CHASSIS, name], self.hinge(), &self.spot, comment);
        corner.drawing.arm(name, [self.front, self.back], self.ball, &self.spot);
    }
}

/// Adds a link on a Hooke's joint on the chassis or rack: two hinges with a massless cross in between. The first pin
/// is fixed in the parent, the second in the link.
pub(super) fn hooke(
    findings: &mut Findings,
    corner: &mut Corner,
    (parent, name): (&str, &str),
    at: Vector3<f64>,
    body: &Body,
    [parent_pin, pin]: [Vector3<f64>; 2],
    comment: String,
) {
    let cosine = parent_pin.dot(&pin).abs();
    if cosine > OBLIQUE_PINS {
        let message = format!(
            "the pins of the universal joint stand at {:.3}° to one another, not at 90°; they are taken as they are",
            cosine.acos().to_degrees()
        );
        findings.warning("oblique-pins", &body.spot, message);
    }
    let cross = format!("{name}_cross");
    corner.link(&cross, at, None, format!("the massless cross of the universal joint of {name}"));
    corner.link(name, at, Some(body), comment);
    let first = (&*format!("{name}_first_pin"), JointKind::Revolute);
    corner.joint(first, [parent, &cross], parent_pin, &body.spot, "the pin that stays with the parent");
    let second = (&*format!("{name}_second_pin"), JointKind::Revolute);
    corner.joint(second, [&cross, name], pin, &body.spot, "the pin that stays with the link");
}

/// Tie rod: a massless rod, or a body with the pins of its Hooke's joint.
pub(super) struct TieRod {
    chassis: Vector3<f64>,
    upright: Vector3<f64>,
    body: Option<(Body, [Vector3<f64>; 2])>,
    spot: Spot,
}

/// Reads `Tierod`. A tie rod with a mass is a body if `may_be_body`.
pub(super) fn tie_rod<'t>(reader: &mut Reader<'t>, root: &mut Section<'t>, may_be_body: bool) -> TieRod {
    let mut section = reader.section(root, "Tierod");
    let chassis = reader.point(&mut section, "Location Chassis");
    let upright = reader.point(&mut section, "Location Upright");
    let spot = section.spot.clone();
    let mut body = None;
    if may_be_body && section.has("Mass") {
        let mass = reader.number(&mut section, "Mass", MASS);
        let inertia = inertia(reader, &mut section, Inertias::Moments);
        let along = upright - chassis;
        let y = frames::normal(along, Vector3::x());
        let frame = y.and_then(|y| frames::along_z(along, y));
        let frame = spanned(reader, frame, &spot, "it lies along x, or its ends coincide");
        let com = (chassis + upright) / 2.0;
        let stated = Stated { mass, com, inertia, spot: spot.clone(), axes: reader.frame.axes };
        body = Some((stated.in_frame(&frame), [frame.column(0).into(), frame.column(1).into()]));
    }
    reader.close(section, &["Inertia", "Radius"]);
    TieRod { chassis, upright, body, spot }
}

impl TieRod {
    /// Adds the tie rod between rack and upright.
    pub fn tie(&self, findings: &mut Findings, corner: &mut Corner) {
        corner.place_rack(self.chassis);
        let Some((body, pins)) = &self.body else {
            let ends = [self.chassis, self.upright];
            corner.rod("tie_rod", [RACK, "upright"], ends, (&self.spot, "Tierod: a massless rod"));
            return;
        };
        let comment = "Tierod: a body; frame at its inner end".to_owned();
        corner.drawing.rod("tie_rod", [self.chassis, self.upright], &self.spot);
        hooke(findings, corner, (RACK, "tie_rod"), self.chassis, body, *pins, comment);
        ball(corner, "tie_rod_ball", ["tie_rod", "upright"], self.upright, &self.spot);
    }
}

/// Adds a ball joint that closes a loop.
pub(super) fn ball(corner: &mut Corner, name: &str, links: [&str; 2], at: Vector3<f64>, spot: &Spot) {
    let joint = (name, ClosureKind::Spherical);
    corner.closure(joint, links, at, Vector3::x(), (spot, "a ball joint"));
}

/// Reads the ends of a spring or shock absorber.
pub(super) fn seats<'t>(
    reader: &mut Reader<'t>,
    root: &mut Section<'t>,
    key: &str,
    moving: &str,
) -> [Vector3<f64>; 2] {
    let mut section = reader.section(root, key);
    let chassis = reader.point(&mut section, "Location Chassis");
    let seat = reader.point(&mut section, moving);
    // Force laws are not read: they come in many kinds and do not affect the effective mass.
    let line = frames::unit(chassis - seat).map(|_| ());
    spanned(reader, line, &section.spot, "its ends coincide: it has no line");
    [seat, chassis]
}

/// Names of the seats.
pub(super) const SPRING: [&str; 2] = ["spring_seat", "spring_chassis_seat"];
pub(super) const SHOCK: [&str; 2] = ["shock_seat", "shock_chassis_seat"];
