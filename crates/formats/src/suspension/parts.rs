//! What several templates share: bodies, arms on a hinge, Hooke's joints, tie rods, seats.

use super::corner::{Body, CHASSIS, Corner, RACK};
use super::findings::{Findings, Spot};
use super::frames;
use super::reader::{Reader, Section};
use super::units::VehicleAxes;
use crate::limits::OBLIQUE_PINS;
use percuss_mechanism::{ClosureKind, JointKind};
use percuss_spatial::{Matrix3, Vector3};

/// Keys that only draw.
const DRAWN: [&str; 2] = ["Radius", "Width"];

/// How a file states inertias.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Inertias {
    /// `Inertia`: three principal moments.
    Moments,
    /// `Moments of Inertia` and `Products of Inertia` (the matrix's entries xy, xz, yz).
    WithProducts,
}

/// A body as the file states it: the inertia in axes that the template defines.
pub(super) struct Stated {
    mass: f64,
    pub com: Vector3<f64>,
    pub inertia: Matrix3<f64>,
    pub spot: Spot,
    /// The vehicle's axes in the file.
    axes: VehicleAxes,
}

impl Stated {
    /// kg.
    pub fn mass(&self) -> f64 {
        self.mass
    }

    /// The inertia is stated in the vehicle's axes.
    pub fn into_vehicle(self) -> Body {
        let about_com = self.axes.inertia_to_iso(self.inertia);
        Body { mass: self.mass, com: self.com, about_com, spot: self.spot }
    }

    /// The inertia is stated in this frame.
    pub fn in_frame(self, frame: &Matrix3<f64>) -> Body {
        let about_com = frames::turned(frame, &self.inertia);
        Body { mass: self.mass, com: self.com, about_com, spot: self.spot }
    }
}

/// Mass, centre of mass and inertia of a section.
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

/// A section that holds only a body.
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

/// Ends a section of a body.
pub(super) fn close<'t>(reader: &mut Reader<'t>, section: Section<'t>) {
    reader.close(section, &DRAWN);
}

/// The value; where hardpoints do not make one, says so (unless they were not all there).
pub(super) fn spanned<T: Default>(findings: &mut Findings, value: Option<T>, spot: &Spot, defect: &str) -> T {
    if value.is_none() && !findings.has_errors() {
        findings.error("degenerate-geometry", spot, defect.to_owned());
    }
    value.unwrap_or_default()
}

/// An arm on a hinge with a ball joint at its end.
pub(super) struct Arm {
    pub body: Option<Body>,
    /// The hinge's points and the ball's.
    pub front: Vector3<f64>,
    pub back: Vector3<f64>,
    pub ball: Vector3<f64>,
    pub spot: Spot,
}

/// Where an arm's inertia is stated.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Axes {
    /// In those of its own plane.
    Own,
    /// In the vehicle's.
    Vehicle,
}

/// An arm, its body in the given manner; without one, only its points.
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
    /// The hinge's axis, from front to back: a positive angle lets the wheel droop.
    fn hinge(&self) -> Vector3<f64> {
        frames::unit(self.back - self.front).unwrap_or_default()
    }

    /// The arm on its hinge on the chassis.
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

/// A link on a Hooke's joint on the chassis or rack: two hinges with a massless cross between them, the first about
/// the pin that stays with the parent, the second about the pin that stays with the link.
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

/// A tie rod: massless, or a body.
pub(super) struct TieRod {
    chassis: Vector3<f64>,
    upright: Vector3<f64>,
    body: Option<(Body, [Vector3<f64>; 2])>,
    spot: Spot,
}

/// Reads `Tierod`; one with a mass is a body where the template has such.
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
    /// Between rack and upright.
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

/// A ball joint that closes a loop.
pub(super) fn ball(corner: &mut Corner, name: &str, links: [&str; 2], at: Vector3<f64>, spot: &Spot) {
    let joint = (name, ClosureKind::Spherical);
    corner.closure(joint, links, at, Vector3::x(), (spot, "a ball joint"));
}

/// Reads the ends of a spring or shock; its force law is not ours.
pub(super) fn seats<'t>(
    reader: &mut Reader<'t>,
    root: &mut Section<'t>,
    key: &str,
    moving: &str,
) -> [Vector3<f64>; 2] {
    let mut section = reader.section(root, key);
    let chassis = reader.point(&mut section, "Location Chassis");
    let seat = reader.point(&mut section, moving);
    // Force laws come in many kinds and do not affect the effective mass.
    let line = frames::unit(chassis - seat).map(|_| ());
    spanned(reader, line, &section.spot, "its ends coincide: it has no line");
    [seat, chassis]
}

/// Names of the seats.
pub(super) const SPRING: [&str; 2] = ["spring_seat", "spring_chassis_seat"];
pub(super) const SHOCK: [&str; 2] = ["shock_seat", "shock_chassis_seat"];
