//! Builds links, joints and loops of a corner from its design.

use super::design::{Design, GivenBody, ON_DAMPER, Part, SEATS, STOPS, Stop, THIRD_SPRING, is_central};
use super::frames;
use super::spindle::Spindle;
use super::{Body, Built, CHASSIS, Corner, GROUND, RACK};
use crate::findings::{Findings, Spot};
use crate::limits::STOP_GAPS;
use crate::units::short;
use percuss_formats::reading::{OBLIQUE_PINS, shortened};
use percuss_mechanism::{ClosureKind, ContactKind, ContactNormal, JointKind, near_names};
use percuss_spatial::{Matrix3, Vector3};
use percuss_units::LengthUnit;

/// Name of the link common to both sides of an axle.
const AXLE: &str = "axle";

/// Builds a corner from a design; `None` after an error. `beside`: corner of the other side, whose frames of shared links are used.
pub(crate) fn build(
    design: &Design,
    spindle: &Spindle,
    beside: Option<&Corner>,
    findings: &mut Findings,
) -> Option<Built> {
    let mut left = Corner::new();
    if let Some(other) = beside {
        left.share_frames(other);
    }
    let mut middle = design.axle.then(Corner::new);
    if let (Some(middle), Some(wheel)) = (&mut middle, design.point("wheel_centre")) {
        let guided = design.parts.iter().find_map(|part| match part {
            Part::GuidedAxle { at } => design.point(at),
            _ => None,
        });
        let at = guided.unwrap_or_else(|| Vector3::new(wheel.x, 0.0, wheel.z));
        middle.mark_shared(AXLE, at);
        left.mark_shared(AXLE, at);
    }
    for part in design.parts.iter().copied() {
        let corner = match &mut middle {
            Some(middle) if is_on_axle(design, part) => {
                // Springs, stops and drop links of both sides may be attached to this link.
                if let Part::Swivel { link, at, .. } = part {
                    left.mark_shared(link, design.point(at).unwrap_or_default());
                }
                middle
            }
            Some(_) | None => &mut left,
        };
        let mut builder = CornerBuilder { design, findings, corner };
        builder.add_part(part, spindle);
        builder.add_bushes(part);
    }
    for (section, [seat, chassis_seat]) in SEATS {
        let (Some(at), Some(above)) = (design.point(seat), design.point(chassis_seat)) else { continue };
        let line = frames::unit(above - at);
        let spot = design.spot(seat);
        findings.unwrap_geometry(line.map(|_| ()), &spot, "its points coincide: it has no line");
        let (Some(line), Some((link, on))) = (line, design.on.get(section)) else { continue };
        if link == ON_DAMPER {
            let message = format!(
                "a stop on the damper has no points, only a gap: remove {seat} and {chassis_seat}, or name the link that the pad is on"
            );
            findings.error("conflict", on, message);
            continue;
        }
        left.add_seats([seat, chassis_seat], link, [at, above], design.part_masses.get(section).copied());
        left.set_spot(seat, spot);
        let (kind, normal, gap) = match section {
            "bump_stop" | "rebound_stop" => {
                let stop = design.stops.get(section).cloned().unwrap_or_default();
                let normal = match stop.direction.map(|direction| frames::unit(direction / direction.amax()))
                {
                    None => line,
                    Some(direction) => {
                        findings.unwrap_geometry(direction, &stop.spot, "the direction of the stop is zero")
                    }
                };
                let distance = normal.dot(&(above - at));
                let gap = stop.gap.unwrap_or(distance);
                check_gap(section, &stop, gap, Some(distance), design.unit, findings);
                (ContactKind::Stop, ContactNormal::Fixed(normal), Some(gap))
            }
            "spring" => (ContactKind::Spring, ContactNormal::Toward(Vector3::zeros()), None),
            _ => (ContactKind::Damper, ContactNormal::Toward(Vector3::zeros()), None),
        };
        left.add_contact((section, kind), [seat, chassis_seat], normal, gap);
    }
    if let (Some((mass, outer)), Some(wheel)) = (design.half_shaft, design.point("wheel_centre")) {
        left.add_half_shaft(mass, outer.unwrap_or(wheel));
    }
    add_damper_stops(design, &mut left, findings);
    add_own_contacts(design, &mut left, findings);
    let hardpoints =
        design.points.iter().map(|(name, (at, spot))| (*name, *at, spot, !is_central(design.axle, name)));
    let own = design.contacts.iter().map(|contact| {
        let has_side = !left.is_shared(&contact.link.0);
        (contact.name.as_str(), contact.at, &contact.spot, has_side)
    });
    let points: Vec<_> = hardpoints.chain(own).collect();
    left.drawing.set_hardpoints(points.into_iter());
    let ends = ["watt_left_chassis", "watt_right_chassis"].map(|end| Some((end, design.point(end)?)));
    if let [Some((name, one)), Some((_, other))] = ends
        && one.y * other.y > 0.0
    {
        let message = format!(
            "{name}: both rods of Watt's linkage go to the same side of the vehicle: change the sign of the y of one end"
        );
        findings.warning("mirrored-point", &design.spot(name), message);
    }
    let (section, seat) = THIRD_SPRING;
    if let (Some(at), Some((link, _))) = (design.point(seat), design.on.get(section)) {
        left.add_frame(seat, link, at, "the third spring, to the same point of the other side");
        left.set_spot(seat, design.spot(seat));
        left.drawing.add_line(section, [at, Vector3::new(at.x, 0.0, at.z)]);
    }
    (!findings.has_errors()).then_some(Built { left, middle, right: None })
}

/// Warns about an implausible gap (m) of a stop. `unit`: unit of the file, for messages; `distance`: distance of its two points along the
/// normal, m.
fn check_gap(
    section: &str,
    stop: &Stop,
    gap: f64,
    distance: Option<f64>,
    unit: LengthUnit,
    findings: &mut Findings,
) {
    if stop.gap == Some(0.0) && distance.is_none_or(|distance| STOP_GAPS.contains(&distance)) {
        let other = distance.map_or_else(
            || "give the gap at the design position".to_owned(),
            |distance| {
                let apart = short(unit.of_metres(distance));
                format!("its points are {apart} {} apart: give the gap, or remove the key", unit.name())
            },
        );
        let message = format!("the gap is 0: the stop would touch at the design position; {other}");
        findings.warning("implausible-gap", &stop.spot, message);
        return;
    }
    let given = format!("{} {}", short(unit.of_metres(gap)), unit.name());
    if gap < 0.0 {
        let cause = match stop {
            Stop { gap: Some(_), .. } => {
                format!(
                    "write {section}.gap as a positive number, unless the parts overlap in the design position"
                )
            }
            Stop { direction: Some(_), .. } => {
                format!(
                    "the sign of {section}.direction is wrong, or the parts overlap in the design position"
                )
            }
            Stop { .. } => "the parts overlap in the design position".to_owned(),
        };
        findings.warning("overlapping-stop", &stop.spot, format!("the gap is {given}: {cause}"));
    } else if gap > 0.0 && !STOP_GAPS.contains(&gap) {
        let [least, most] = [STOP_GAPS.start(), STOP_GAPS.end()].map(|end| short(unit.of_metres(*end)));
        let message = format!(
            "the gap is {given}; {least} to {most} {} are usual: is it in another unit? Write it with one: \"30 mm\"",
            unit.name()
        );
        findings.warning("implausible-gap", &stop.spot, message);
    }
}

/// Names of the ground as the other side of a contact.
const IS_GROUND: [&str; 2] = [GROUND, "ground"];

/// Adds the contacts that the file names itself.
fn add_own_contacts(design: &Design, corner: &mut Corner, findings: &mut Findings) {
    for contact in &design.contacts {
        let against = contact.against.as_ref().filter(|(link, _)| !IS_GROUND.contains(&link.as_str()));
        let mut links = [Some(&contact.link), against].into_iter().flatten();
        if let Some((link, spot)) = links.find(|(link, _)| !corner.has_link(link)) {
            let near = near_names(link, corner.link_names()).into_iter().next();
            let near = near.map_or_else(String::new, |near| format!("; did you mean {near}?"));
            let names = corner.link_names().join(", ");
            findings.error(
                "unknown-link",
                spot,
                format!("no link \"{}\"{near} (the links are {names})", shortened(link)),
            );
            continue;
        }
        let normal = frames::unit(contact.direction / contact.direction.amax());
        let normal = findings.unwrap_geometry(normal, &contact.spot, "the direction is zero");
        if let Some(gap) = contact.gap {
            let stop = Stop { gap: Some(gap), direction: None, spot: contact.spot.clone() };
            check_gap(&format!("contact.{}", contact.name), &stop, gap, None, design.unit, findings);
        }
        let against = against.map_or(GROUND, |(link, _)| link);
        let kind = if contact.gap.is_some() { ContactKind::Stop } else { ContactKind::Other };
        let of = [contact.link.0.as_str(), against];
        corner.add_contact_at(
            (&contact.name, kind),
            of,
            contact.at,
            ContactNormal::Fixed(normal),
            contact.gap,
        );
    }
}

/// Adds the stops without points. They are on the rod of the damper, and their gap is a change of its length. An error is reported for a
/// stop without points that names another link.
fn add_damper_stops(design: &Design, corner: &mut Corner, findings: &mut Findings) {
    let has_points =
        |name: &str| SEATS.iter().any(|(key, [seat, _])| *key == name && design.point(seat).is_some());
    let damper = ["damper", "shock"].into_iter().find(|name| has_points(name));
    for section in STOPS.into_iter().filter(|section| !has_points(section)) {
        let (link, on) = design.on.get(section).cloned().unwrap_or_default();
        let is_on_damper = link == ON_DAMPER;
        let Some(stop) = design.stops.get(section) else {
            if is_on_damper {
                let message = format!(
                    "the key is missing; {section}.gap, the change of the damper's length, is expected"
                );
                findings.error("missing-key", &on, message);
            }
            continue;
        };
        if on.has_path() && !is_on_damper {
            let message = format!(
                "the stop is on {link} and has a gap but no points: give {section}_pad and {section}, or \
                 write on = \"{ON_DAMPER}\" for a stop on the rod of the damper"
            );
            findings.error("missing-key", &on, message);
            continue;
        }
        if stop.direction.is_some() {
            let message = format!(
                "the stop has no points: it is on the damper and acts along it; remove the direction, or give {section}_pad and \
                 {section}"
            );
            findings.error("conflict", &stop.spot, message);
            continue;
        }
        let Some(gap) = stop.gap else { continue };
        check_gap(section, stop, gap, None, design.unit, findings);
        let seats = SEATS.iter().find(|(key, _)| Some(*key) == damper);
        let Some((_, seats)) = seats else {
            let message = format!(
                "a stop without points is on the damper, and the sheet has no damper: give the points {section}_pad and \
                 {section}, or those of the damper"
            );
            findings.error("missing-key", &stop.spot, message);
            continue;
        };
        // The bump stop limits the compression of the damper, the rebound stop the extension.
        let end = Vector3::zeros();
        let normal =
            if section == "bump_stop" { ContactNormal::Toward(end) } else { ContactNormal::Away(end) };
        corner.add_contact((section, ContactKind::Stop), *seats, normal, Some(gap));
    }
}

/// True if a part belongs to the axle as a whole, not to one side.
fn is_on_axle(design: &Design, part: &Part) -> bool {
    let central = |point: &str| is_central(design.axle, point);
    match part {
        Part::Axle | Part::GuidedAxle { .. } => true,
        Part::Swivel { at, .. } => central(at),
        Part::Rod { ends, .. } => ends.iter().all(|(_, point)| central(point)),
        Part::Hinge { .. }
        | Part::Ball { .. }
        | Part::Free { .. }
        | Part::Fixed { .. }
        | Part::Wheel { .. }
        | Part::Strut { .. }
        | Part::Slide { .. }
        | Part::Close { .. } => false,
    }
}

/// Comment of a link: the comment of its part, or the point of its frame.
fn link_comment(comment: Option<&String>, at: &str) -> String {
    comment.cloned().unwrap_or_else(|| format!("frame at {at}"))
}

/// Adds the parts of a design to a corner.
pub(super) struct CornerBuilder<'d> {
    pub(super) design: &'d Design,
    pub(super) findings: &'d mut Findings,
    pub(super) corner: &'d mut Corner,
}

impl CornerBuilder<'_> {
    /// Position of a hardpoint, m; the origin if the file does not contain the point.
    pub(super) fn point(&self, key: &str) -> Vector3<f64> {
        self.design.point(key).unwrap_or_default()
    }

    /// Resolves a link name: for `SECTION.on`, the link chosen in the file.
    pub(super) fn resolve_link<'n>(&'n self, name: &'n str) -> &'n str {
        let chosen = name.strip_suffix(".on").and_then(|section| self.design.on.get(section));
        chosen.map_or(name, |(link, _)| link)
    }

    /// Body of a link; `None` for a massless link.
    fn body(&self, link: &str) -> Option<Body> {
        match self.design.bodies.get(link) {
            Some(GivenBody::Body(body)) => Some(body.clone()),
            Some(GivenBody::Rod(..)) | None => None,
        }
    }

    /// Adds a link of the design, with the link frame at the point `at`.
    fn add_link(&mut self, link: &str, at: &str, comment: Option<&String>) {
        let body = self.body(link);
        self.corner.add_link(link, self.point(at), body.as_ref(), link_comment(comment, at));
    }

    /// Carries out a construction step.
    fn add_part(&mut self, part: &Part, spindle: &Spindle) {
        match part {
            Part::Hinge { link, parent, points: [first, second], comment, outer } => {
                let axis = self.point(second) - self.point(first);
                self.add_link(link, first, comment.as_ref());
                self.add_hinge_joint(link, parent, first, axis, self.design.hinge_comment);
                self.draw_hinge(link, [self.point(first), self.point(second)], outer.as_deref());
            }
            Part::Swivel { link, parent, at, axis } => {
                self.add_link(link, at, None);
                let about = axis.map_or(Vector3::x(), Vector3::from);
                let comment = format!("about the vehicle's {}", ["x", "y", "z"][about.iamax()]);
                self.add_hinge_joint(link, parent, at, about, &comment);
                // A crank about x is drawn by its rods.
                if axis.is_some()
                    && let Some(outer) = self.outer_point(link)
                {
                    let (ends, spot) = ([self.point(at), self.point(outer)], self.design.spot(outer));
                    self.corner.drawing.add_rod(link, ends, &spot);
                }
            }
            Part::Ball { link, joint, parent, at, comment, outer } => {
                let spot = self.design.spot(at);
                self.add_link(link, at, comment.as_ref());
                let joint = (&**joint, JointKind::Spherical);
                self.corner.add_joint(joint, [parent, link], Vector3::x(), &spot, "a ball joint");
                if parent == CHASSIS {
                    let ends = [self.point(at), self.point(outer.as_deref().unwrap_or("wheel_centre"))];
                    self.corner.drawing.add_rod(link, ends, &spot);
                }
            }
            Part::Free { link, at, comment, joint_comment } => {
                self.add_link(link, at, comment.as_ref());
                self.add_floating_joint(link, self.design.spot(at), joint_comment.as_deref());
            }
            Part::Axle => {
                let wheel = self.point("wheel_centre");
                let at = Vector3::new(wheel.x, 0.0, wheel.z);
                let body = self.body(AXLE);
                let comment = "frame half way between the wheels".to_owned();
                self.corner.add_link(AXLE, at, body.as_ref(), comment);
                self.add_floating_joint(AXLE, self.design.spot("wheel_centre"), None);
                let left = Vector3::new(wheel.x, wheel.y, wheel.z);
                let right = Vector3::new(wheel.x, 0.0 - wheel.y, wheel.z);
                self.corner.drawing.add_line(AXLE, [left, right]);
            }
            Part::GuidedAxle { at } => self.add_guided_axle(at),
            Part::Fixed { link, on, at } => {
                let Some(body) = self.body(link) else { return };
                let name = format!("{link}_fixed");
                self.corner.add_link(link, self.point(at), Some(&body), format!("fixed to {on}"));
                let joint = (&*name, JointKind::Fixed);
                self.corner.add_joint(joint, [on, link], Vector3::x(), &body.spot, "fixed");
            }
            Part::Wheel { on } => spindle.attach(self.findings, self.corner, on),
            Part::Rod { link, ends, comment, massless_comment } => {
                self.add_rod(link, ends, comment.as_ref(), massless_comment.as_deref());
            }
            Part::Strut { link, on, line, comment, undrawn } => {
                self.add_strut(link, on, line, comment.as_ref());
                if !undrawn {
                    let spot = self.design.spot(&line[1]);
                    self.corner.drawing.add_rod(link, [self.point(&line[0]), self.point(&line[1])], &spot);
                }
            }
            Part::Slide { link, parent, line: [bottom, top] } => {
                let (spot, ends) = (self.design.spot(bottom), [self.point(bottom), self.point(top)]);
                let defect = "the two points of the line coincide";
                let axis = self.findings.unwrap_geometry(frames::unit(ends[1] - ends[0]), &spot, defect);
                self.add_link(link, bottom, None);
                let (name, comment) = (format!("{link}_slide"), "along the line of its two points");
                self.corner.add_joint((&name, JointKind::Prismatic), [parent, link], axis, &spot, comment);
                self.corner.drawing.add_rod(link, ends, &spot);
            }
            Part::Close { joint, links: [predecessor, successor], at } => {
                let spot = self.design.spot(at);
                self.add_closing_ball_joint(joint, [predecessor, successor], self.point(at), &spot);
            }
        }
    }

    /// Adds a floating joint from the chassis: only closures constrain the link.
    fn add_floating_joint(&mut self, link: &str, spot: Spot, comment: Option<&str>) {
        let name = format!("{link}_free");
        let comment = comment.unwrap_or("constrained only by the loops");
        self.corner.add_joint((&name, JointKind::Floating), [CHASSIS, link], Vector3::x(), &spot, comment);
    }

    /// Adds the axle on slides along x and z and on pins along z and x through a point of the middle plane.
    fn add_guided_axle(&mut self, at: &str) {
        let (pivot, spot) = (self.point(at), self.design.spot(at));
        let mut parent = CHASSIS;
        let steps = [
            (
                "axle_forward",
                "axle_forward_slide",
                JointKind::Prismatic,
                Vector3::x(),
                "along the vehicle's x",
            ),
            ("axle_up", "axle_up_slide", JointKind::Prismatic, Vector3::z(), "along the vehicle's z"),
            ("axle_yaw", "axle_yaw_hinge", JointKind::Revolute, Vector3::z(), "yaw, about the vehicle's z"),
            (AXLE, "axle_roll_hinge", JointKind::Revolute, Vector3::x(), "roll, about the axle's x"),
        ];
        for (link, joint, kind, axis, comment) in steps {
            let body = self.body(link);
            self.corner.add_link(
                link,
                pivot,
                body.as_ref(),
                "frame in the middle plane, at the line of the eyes",
            );
            self.corner.add_joint((joint, kind), [parent, link], axis, &spot, comment);
            parent = link;
        }
        let wheel = self.point("wheel_centre");
        let ends = [1.0, -1.0].map(|side| Vector3::new(wheel.x, side * wheel.y, wheel.z));
        self.corner.drawing.add_line(AXLE, ends);
    }

    /// Adds a revolute joint from the parent to the link, at the point `at`.
    fn add_hinge_joint(&mut self, link: &str, parent: &str, at: &str, axis: Vector3<f64>, comment: &str) {
        let spot = self.design.spot(at);
        let defect = "the hinge's two points coincide";
        let axis = self.findings.unwrap_geometry(frames::unit(axis), &spot, defect);
        let name = format!("{link}_hinge");
        self.corner.add_joint((&name, JointKind::Revolute), [parent, link], axis, &spot, comment);
    }

    /// Draws a hinged arm from its hinge to its outer point.
    fn draw_hinge(&mut self, link: &str, hinge: [Vector3<f64>; 2], outer: Option<&str>) {
        let Some(outer) = outer.or_else(|| self.outer_point(link)) else { return };
        let Some((outer, spot)) = self.design.points.get(outer) else { return };
        self.corner.drawing.add_arm(link, hinge, *outer, spot);
    }

    /// Point of the first ball joint, rod or wheel on a link.
    fn outer_point(&self, link: &str) -> Option<&'static str> {
        self.design.parts.iter().copied().find_map(|part| match part {
            Part::Ball { parent, at, .. } if parent == link => Some(at.as_str()),
            Part::Close { links, at, .. } if links.iter().any(|on| on == link) => Some(at.as_str()),
            Part::Wheel { on } if on == link => Some("wheel_centre"),
            Part::Rod { ends, .. } => ends.iter().find(|(on, _)| on == link).map(|(_, point)| point.as_str()),
            Part::Hinge { .. }
            | Part::Swivel { .. }
            | Part::Ball { .. }
            | Part::Free { .. }
            | Part::Axle
            | Part::GuidedAxle { .. }
            | Part::Fixed { .. }
            | Part::Wheel { .. }
            | Part::Strut { .. }
            | Part::Slide { .. }
            | Part::Close { .. } => None,
        })
    }

    /// Adds a rod between two links: a distance closure without mass; with mass, a link on a universal joint at the first
    /// end and a ball joint at the second.
    fn add_rod(
        &mut self,
        link: &str,
        ends: &[(String, String); 2],
        comment: Option<&String>,
        massless_comment: Option<&str>,
    ) {
        let [(from, a), (to, b)] = ends;
        let points = [self.point(a), self.point(b)];
        let (from, to) = (self.resolve_link(from).to_owned(), self.resolve_link(to).to_owned());
        let spot = self.design.spot(b);
        if from == RACK {
            self.corner.set_rack_origin(points[0]);
        }
        let along = points[1] - points[0];
        let direction = frames::unit(along);
        let given = self.design.bodies.get(link);
        let massless = GivenBody::Rod(0.0, spot.clone());
        let given = given.or_else(|| {
            let is_link = self.design.builds_rods_as_links()
                || self.design.is_holder(link)
                || self.design.has_bush([a, b]);
            (is_link && direction.is_some()).then_some(&massless)
        });
        if given.is_none() && (direction.is_some() || self.design.unchecked_rods) {
            let comment = massless_comment.unwrap_or("a massless rod");
            return self.corner.add_rod(link, [&from, &to], points, (&spot, comment));
        }
        let (Some(direction), Some(given)) = (direction, given) else {
            let message = "its ends coincide: it has no line";
            return self.findings.unwrap_geometry(None, &spot, message);
        };
        let body = match given {
            GivenBody::Body(body) => body.clone(),
            GivenBody::Rod(mass, spot) => {
                // Slender rod: transverse moment m l²/12.
                let across = Matrix3::identity() - direction * direction.transpose();
                let about_com = across * (mass * along.norm_squared() / 12.0);
                Body {
                    mass: *mass,
                    com: (points[0] + points[1]) / 2.0,
                    about_com,
                    spot: spot.clone(),
                    com_spot: spot.clone(),
                }
            }
        };
        self.add_universal_joint((&from, link), points[0], &body, direction, link_comment(comment, a));
        self.add_closing_ball_joint(&format!("{link}_ball"), [link, &to], points[1], &spot);
        self.corner.drawing.add_rod(link, points, &spot);
    }

    /// Adds a strut on a universal joint at its top, and a cylindrical closure along its axis to the link `on`.
    fn add_strut(&mut self, link: &str, on: &str, [bottom, top]: &[String; 2], comment: Option<&String>) {
        let spot = self.design.spot(top);
        let (low, high) = (self.point(bottom), self.point(top));
        let defect = "the strut's two points coincide";
        let axis = self.findings.unwrap_geometry(frames::unit(high - low), &spot, defect);
        let body = self.body(link).unwrap_or(Body {
            mass: 0.0,
            com: high,
            about_com: Matrix3::zeros(),
            spot: spot.clone(),
            com_spot: spot.clone(),
        });
        self.add_universal_joint((CHASSIS, link), high, &body, axis, link_comment(comment, top));
        self.corner.add_sliding_closure(&format!("{link}_slide"), [link, on], low, axis, &spot);
    }

    /// Adds a link along `direction` on a universal joint: two hinges with a massless cross in between.
    fn add_universal_joint(
        &mut self,
        (parent, name): (&str, &str),
        at: Vector3<f64>,
        body: &Body,
        direction: Vector3<f64>,
        comment: String,
    ) {
        let [parent_pin, pin] = self.universal_pins(name, direction);
        let cosine = parent_pin.dot(&pin).abs();
        if cosine > OBLIQUE_PINS {
            let message = format!(
                "the angle between the pins of the universal joint is {:.3}°, not 90°; the pins are used as given",
                cosine.acos().to_degrees()
            );
            self.findings.warning("oblique-pins", &body.spot, message);
        }
        let cross = format!("{name}_cross");
        self.corner.add_link(
            &cross,
            at,
            None,
            format!("the massless cross of the universal joint of {name}"),
        );
        self.corner.add_link(name, at, Some(body), comment);
        for (joint, links, pin, comment) in [
            ("first", [parent, &*cross], parent_pin, "pin fixed to the parent"),
            ("second", [&*cross, name], pin, "pin fixed to the link"),
        ] {
            let joint = format!("{name}_{joint}_pin");
            self.corner.add_joint((&joint, JointKind::Revolute), links, pin, &body.spot, comment);
        }
    }

    /// Pins of the universal joint of a link along `direction`: as given, or normal to the link and to the vehicle's x axis.
    fn universal_pins(&mut self, link: &str, direction: Vector3<f64>) -> [Vector3<f64>; 2] {
        if let Some(pins) = self.design.pins.get(link) {
            return *pins;
        }
        if let Some((pin, spot)) = self.design.first_pins.get(link) {
            let second =
                frames::unit(*pin).and_then(|first| Some([first, frames::normal(direction, first)?]));
            let defect = "the pin has no direction, or is parallel to the link";
            return self.findings.unwrap_geometry(second, spot, defect);
        }
        let pin = frames::normal(direction, Vector3::x()).or_else(|| frames::normal(direction, Vector3::z()));
        let pin = pin.unwrap_or_default();
        [pin, direction.cross(&pin)]
    }

    /// Adds a ball joint that closes a loop.
    fn add_closing_ball_joint(&mut self, name: &str, links: [&str; 2], at: Vector3<f64>, spot: &Spot) {
        let joint = (name, ClosureKind::Spherical);
        self.corner.add_closure(joint, links, at, Vector3::x(), (spot, "a ball joint"));
    }
}
