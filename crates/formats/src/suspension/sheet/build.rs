//! Builds links, joints and loops of a sheet from the parts of its template.

use super::super::corner::{Body, CHASSIS, Corner, RACK};
use super::super::findings::{Findings, Spot};
use super::super::frames;
use super::super::parts::{ball, hooke, spanned};
use super::super::spindle::Spindle;
use super::catalogue::{SEATS, keys};
use super::read::{Sheet, Stated};
use super::template::Part;
use percuss_mechanism::JointKind;
use percuss_spatial::{Matrix3, Vector3};

/// Left side, and the parts common to both sides.
pub(in super::super) struct Built {
    pub left: Corner,
    pub middle: Option<Corner>,
}

/// Name of the link common to both sides of an axle.
const AXLE: &str = "axle";

/// Builds the corner of a sheet; reports points that determine no axis or line.
pub(in super::super) fn build(sheet: &Sheet, findings: &mut Findings) -> Option<Built> {
    let spindle = spindle(sheet, findings);
    let mut left = Corner::new();
    let mut middle = sheet.template.axle.then(Corner::new);
    if let (Some(middle), Some(wheel)) = (&mut middle, sheet.at("wheel_centre")) {
        let at = Vector3::new(wheel.x, 0.0, wheel.z);
        middle.share(AXLE, at);
        left.share(AXLE, at);
    }
    let with_bar = sheet.at("drop_link_bar").is_some();
    let bar = keys().anti_roll_bar.iter().filter(|_| with_bar);
    for part in sheet.template.parts.iter().chain(bar) {
        let corner = match &mut middle {
            Some(middle) if is_central(sheet, part) => {
                // Springs, stops and drop links of both sides may be attached to this link.
                if let Part::Swivel { link, at, .. } = part {
                    left.share(link, sheet.at(at).unwrap_or_default());
                }
                middle
            }
            Some(_) | None => &mut left,
        };
        Building { sheet, findings, corner }.part(part, &spindle);
    }
    for (section, [seat, chassis_seat]) in SEATS {
        let (Some(at), Some(above)) = (sheet.at(seat), sheet.at(chassis_seat)) else { continue };
        let line = frames::unit(above - at).map(|_| ());
        let spot = sheet.spot(seat);
        spanned(findings, line, &spot, "its points coincide: it has no line");
        let Some((link, _)) = sheet.on.get(section) else { continue };
        if line.is_some() {
            left.seats([seat, chassis_seat], link, [at, above]);
            left.stated(seat, spot);
        }
    }
    (!findings.has_errors()).then_some(Built { left, middle })
}

fn is_central(sheet: &Sheet, part: &Part) -> bool {
    let central = |point: &str| sheet.template.is_central(point);
    match part {
        Part::Axle => true,
        Part::Swivel { at, .. } => central(at),
        Part::Rod { ends, .. } => ends.iter().all(|(_, point)| central(point)),
        Part::Hinge { .. }
        | Part::Ball { .. }
        | Part::Free { .. }
        | Part::Fixed { .. }
        | Part::Wheel { .. }
        | Part::Strut { .. }
        | Part::Close { .. } => false,
    }
}

/// Spindle and wheel of the left side.
fn spindle(sheet: &Sheet, findings: &mut Findings) -> Spindle {
    let at = sheet.at("wheel_centre").unwrap_or_default();
    let spot = sheet.spot("wheel_centre");
    let body = match sheet.bodies.get("spindle") {
        Some(Stated::Body(body)) => {
            Body { com: if body.com.x.is_nan() { at } else { body.com }, ..body.clone() }
        }
        Some(Stated::Rod(..)) | None => {
            Body { mass: 0.0, com: at, about_com: Matrix3::zeros(), spot: spot.clone() }
        }
    };
    if at.y <= 0.0 && !findings.has_errors() {
        let message = format!(
            "the wheel's centre is at y = {} m, seen from the side that the points describe: 0 or the other side. \
             side = \"left\" or \"right\" says which it is, axes which way y points",
            at.y
        );
        findings.error("wrong-side", &spot, message);
    }
    Spindle::new(findings, body, at, [sheet.camber, sheet.toe], sheet.axle_inertia, sheet.wheel)
}

struct Building<'s> {
    sheet: &'s Sheet,
    findings: &'s mut Findings,
    corner: &'s mut Corner,
}

impl Building<'_> {
    fn at(&self, key: &str) -> Vector3<f64> {
        self.sheet.at(key).unwrap_or_default()
    }

    /// Resolves a link name: for `SECTION.on`, the link chosen in the sheet.
    fn link<'n>(&'n self, name: &'n str) -> &'n str {
        let chosen = name.strip_suffix(".on").and_then(|section| self.sheet.on.get(section));
        chosen.map_or(name, |(link, _)| link)
    }

    /// Body of a link; `None` for a massless link.
    fn body(&self, link: &str) -> Option<Body> {
        match self.sheet.bodies.get(link) {
            Some(Stated::Body(body)) => Some(body.clone()),
            Some(Stated::Rod(..)) | None => None,
        }
    }

    fn part(&mut self, part: &Part, spindle: &Spindle) {
        match part {
            Part::Hinge { link, parent, points: [first, second] } => {
                let axis = self.at(second) - self.at(first);
                let comment = "about the line through its two points, first to second";
                self.on_hinge(link, parent, first, axis, comment);
                self.draw_hinge(link, [self.at(first), self.at(second)]);
            }
            Part::Swivel { link, parent, at } => {
                self.on_hinge(link, parent, at, Vector3::x(), "about the vehicle's x");
            }
            Part::Ball { link, joint, parent, at } => {
                let body = self.body(link);
                let spot = self.sheet.spot(at);
                self.corner.link(link, self.at(at), body.as_ref(), format!("frame at {at}"));
                let joint = (&**joint, JointKind::Spherical);
                self.corner.joint(joint, [parent, link], Vector3::x(), &spot, "a ball joint");
                if parent == CHASSIS {
                    let ends = [self.at(at), self.at("wheel_centre")];
                    self.corner.drawing.rod(link, ends, &spot);
                }
            }
            Part::Free { link, at } => {
                let body = self.body(link);
                self.corner.link(link, self.at(at), body.as_ref(), format!("frame at {at}"));
                self.float(link, self.sheet.spot(at));
            }
            Part::Axle => {
                let wheel = self.at("wheel_centre");
                let at = Vector3::new(wheel.x, 0.0, wheel.z);
                let body = self.body(AXLE);
                let comment = "frame half way between the wheels".to_owned();
                self.corner.link(AXLE, at, body.as_ref(), comment);
                self.float(AXLE, self.sheet.spot("wheel_centre"));
                let left = Vector3::new(wheel.x, wheel.y, wheel.z);
                let right = Vector3::new(wheel.x, 0.0 - wheel.y, wheel.z);
                self.corner.drawing.line(AXLE, [left, right]);
            }
            Part::Fixed { link, on, at } => {
                let Some(body) = self.body(link) else { return };
                let name = format!("{link}_fixed");
                self.corner.link(link, self.at(at), Some(&body), format!("fixed to {on}"));
                let joint = (&*name, JointKind::Fixed);
                self.corner.joint(joint, [on, link], Vector3::x(), &body.spot, "fixed");
            }
            Part::Wheel { on } => spindle.attach(self.findings, self.corner, on),
            Part::Rod { link, ends } => self.rod(link, ends),
            Part::Strut { link, on, line } => self.strut(link, on, line),
            Part::Close { joint, links, at } => {
                let spot = self.sheet.spot(at);
                ball(self.corner, joint, links.each_ref().map(|link| &**link), self.at(at), &spot);
            }
        }
    }

    fn float(&mut self, link: &str, spot: Spot) {
        let name = format!("{link}_free");
        let comment = "only what is attached to it holds it";
        self.corner.joint((&name, JointKind::Floating), [CHASSIS, link], Vector3::x(), &spot, comment);
    }

    fn on_hinge(&mut self, link: &str, parent: &str, at: &str, axis: Vector3<f64>, comment: &str) {
        let spot = self.sheet.spot(at);
        let axis = spanned(self.findings, frames::unit(axis), &spot, "the hinge's two points coincide");
        let body = self.body(link);
        self.corner.link(link, self.at(at), body.as_ref(), format!("frame at {at}"));
        let name = format!("{link}_hinge");
        self.corner.joint((&name, JointKind::Revolute), [parent, link], axis, &spot, comment);
    }

    /// Draws a hinged arm from its hinge to its next joint: the first ball joint, rod or wheel on the link.
    fn draw_hinge(&mut self, link: &str, hinge: [Vector3<f64>; 2]) {
        let on_it = |part: &&Part| match part {
            Part::Ball { parent, .. } => parent == link,
            Part::Close { links, .. } => links.iter().any(|on| on == link),
            Part::Wheel { on } => on == link,
            Part::Rod { ends, .. } => ends.iter().any(|(on, _)| on == link),
            Part::Hinge { .. }
            | Part::Swivel { .. }
            | Part::Free { .. }
            | Part::Axle
            | Part::Fixed { .. }
            | Part::Strut { .. } => false,
        };
        let outer: &str = match self.sheet.template.parts_with_bar().find(on_it) {
            Some(Part::Ball { at, .. } | Part::Close { at, .. }) => at,
            Some(Part::Wheel { .. }) => "wheel_centre",
            Some(Part::Rod { ends, .. }) => {
                ends.iter().find(|(on, _)| on == link).map_or("", |(_, point)| point)
            }
            Some(_) | None => return,
        };
        let Some((outer, spot)) = self.sheet.points.get(outer) else { return };
        self.corner.drawing.arm(link, hinge, *outer, spot);
    }

    fn rod(&mut self, link: &str, ends: &[(String, String); 2]) {
        let [(from, a), (to, b)] = ends;
        let points = [self.at(a), self.at(b)];
        let (from, to) = (self.link(from).to_owned(), self.link(to).to_owned());
        let spot = self.sheet.spot(b);
        if from == RACK {
            self.corner.place_rack(points[0]);
        }
        let along = points[1] - points[0];
        let Some(direction) = frames::unit(along) else {
            let message = "its ends coincide: it has no line";
            return spanned(self.findings, None, &spot, message);
        };
        let body = match self.sheet.bodies.get(link) {
            None => {
                self.corner.rod(link, [&from, &to], points, (&spot, "a massless rod"));
                return;
            }
            Some(Stated::Body(body)) => body.clone(),
            Some(Stated::Rod(mass, spot)) => {
                // Slender rod: transverse moment m l²/12.
                let across = Matrix3::identity() - direction * direction.transpose();
                let about_com = across * (mass * along.norm_squared() / 12.0);
                Body { mass: *mass, com: (points[0] + points[1]) / 2.0, about_com, spot: spot.clone() }
            }
        };
        let pin = frames::normal(direction, Vector3::x()).or_else(|| frames::normal(direction, Vector3::z()));
        let pin = pin.unwrap_or_default();
        let pins = [pin, direction.cross(&pin)];
        let comment = format!("frame at {a}");
        hooke(self.findings, self.corner, (&from, link), points[0], &body, pins, comment);
        ball(self.corner, &format!("{link}_ball"), [link, &to], points[1], &spot);
        self.corner.drawing.rod(link, points, &spot);
    }

    fn strut(&mut self, link: &str, on: &str, [bottom, top]: &[String; 2]) {
        let spot = self.sheet.spot(top);
        let (low, high) = (self.at(bottom), self.at(top));
        let axis = spanned(self.findings, frames::unit(high - low), &spot, "the strut's two points coincide");
        let body = self.body(link).unwrap_or(Body {
            mass: 0.0,
            com: high,
            about_com: Matrix3::zeros(),
            spot: spot.clone(),
        });
        let pin = frames::normal(axis, Vector3::x()).or_else(|| frames::normal(axis, Vector3::z()));
        let pin = pin.unwrap_or_default();
        let pins = [pin, axis.cross(&pin)];
        hooke(self.findings, self.corner, (CHASSIS, link), high, &body, pins, format!("frame at {top}"));
        self.corner.slide(&format!("{link}_slide"), [link, on], low, axis, &spot);
        self.corner.drawing.rod(link, [low, high], &spot);
    }
}
