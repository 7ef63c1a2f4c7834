//! Checks of a corner: implausible positions, masses and inertias.

use super::design::STOPS;
use super::plausibility::{
    CheckedPart, GivenMass, MirroredMass, check_part, check_wheel, distance_from_box, warn_mirrored_masses,
};
use super::{AXLES, CHASSIS, Corner, RACK};
use crate::findings::Findings;
use crate::limits::{
    EXCHANGED_SEATS, MAX_DISTANCE_FROM_JOINTS, MAX_SPRING_LENGTH, MAX_TRACK, MAX_UPRIGHT_REACH,
    MAX_WHEEL_MASS, MIN_PART_SIZE, MIN_TRACK,
};
use crate::units::{FilePlaces, check_proportions};
use percuss_mechanism::{Inertial, JointKind};
use percuss_spatial::Vector3;

impl Corner {
    /// Warns about implausible positions of points and centres of mass.
    pub fn check(&self, findings: &mut Findings, places: FilePlaces) {
        if let Some(wheel) = self.drawing.wheels.first() {
            let track = 2.0 * wheel.centre[1].abs();
            let spot = self.spots.get("spin").cloned().unwrap_or_default();
            check_proportions(findings, track, self.drawing.median_length(), &spot, places.frame.unit);
        }
        // Lengths in a wrong unit explain all other findings.
        if findings.has_errors() {
            return;
        }
        let mut has_warned = self.drawing.check(findings, places);
        // The links of an axle may converge at the axle.
        if !AXLES.iter().any(|axle| self.is_shared(axle)) {
            has_warned |= self.drawing.check_exchanged_ends(findings, places);
        }
        if self.check_wheel_centre(has_warned, findings, places) {
            return;
        }
        self.check_exchanged_seats(findings, places);
        let mirrored = self.mirrored_masses();
        warn_mirrored_masses(&mirrored, findings, places);
        let known: Vec<&str> = mirrored.iter().map(|found| found.link).collect();
        for link in self.moving_links() {
            self.check_link(link, [has_warned, known.contains(&link)], findings, places);
        }
        self.check_parts(None, &known, findings, places);
        let radius = self.drawing.wheels.first().and_then(|wheel| wheel.radius);
        if let (Some(radius), Some(wheel)) = (radius, self.inertial("wheel")) {
            check_wheel(
                wheel,
                radius,
                &self.spots.get("spin").cloned().unwrap_or_default(),
                findings,
                places,
            );
        }
    }

    /// Warns about implausible masses and inertias of the parts. `track`: distance between both wheels, m: size of an axle, whose
    /// joints belong to other corners. `known`: parts to skip, because their centre of mass, which determines their size, is implausible.
    pub fn check_parts(
        &self,
        track: Option<f64>,
        known: &[&str],
        findings: &mut Findings,
        places: FilePlaces,
    ) {
        for part in self.parts(track).into_iter().filter(|part| !known.contains(&part.name)) {
            let spot = self.spots.get(part.name).cloned().unwrap_or_default();
            check_part(&part, &spot, findings, places);
        }
    }

    /// Warns about points far away from all joints of the link: seats, the centre of mass, and, if the link has more
    /// than two joints, a joint far from the others. Warnings about joints are omitted if `has_warned`, because the
    /// drawing check has reported their points, and the warning about the centre of mass if `is_com_reported`.
    fn check_link(
        &self,
        link: &str,
        [has_warned, is_com_reported]: [bool; 2],
        findings: &mut Findings,
        places: FilePlaces,
    ) {
        let (origin, [joints, seats]) = (self.origin(link), self.joints_and_seats(link));
        let distance_from_others = |i: usize| {
            let others = joints.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, (_, at))| at);
            distance_from_box(&joints[i].1, others)
        };
        // A rod has two joints; the drawing check covers its length.
        let outliers: Vec<usize> = (0..joints.len())
            .filter(|i| joints.len() > 2 && distance_from_others(*i) > 2.0 * MAX_DISTANCE_FROM_JOINTS)
            .collect();
        let near: Vec<Vector3<f64>> = joints
            .iter()
            .enumerate()
            .filter(|(i, _)| !outliers.contains(i))
            .map(|(_, (_, at))| *at)
            .collect();
        let mut warn = |code: &'static str, of: &str, subject: String, at: &Vector3<f64>, distance: f64| {
            let message = format!(
                "{subject} at {} is {} away from the joints of {link}; check the value, its axes and its unit",
                places.point(*at),
                places.length(distance)
            );
            findings.warning(code, &self.spots.get(of).cloned().unwrap_or_default(), message);
        };
        for (name, at) in outliers.into_iter().filter(|_| !has_warned).map(|i| joints[i]) {
            warn("astray-point", name, format!("the joint of {name}"), &at, distance_from_box(&at, &near));
        }
        for (name, at) in seats {
            let distance = distance_from_box(&at, &near);
            if distance > MAX_DISTANCE_FROM_JOINTS && self.exchanged_seat(name, at, &near).is_none() {
                warn("astray-point", name, name.to_owned(), &at, distance);
            }
        }
        if let Some(inertial) = self.inertial(link).filter(|inertial| inertial.mass > 0.0 && !is_com_reported)
        {
            let at = origin + inertial.com;
            let distance = distance_from_box(&at, &near);
            if distance > MAX_DISTANCE_FROM_JOINTS {
                warn("astray-com", link, format!("the centre of mass of {link}"), &at, distance);
            }
        }
    }

    /// Warns about a wheel centre with an implausible track or far from all joints of the upright, otherwise about single joints far from
    /// the centre. Warnings about joints are omitted if `has_warned`, because the drawing check has reported their points. Returns true if
    /// the centre is implausible, because it is then the cause of other findings about distances and sizes.
    fn check_wheel_centre(&self, has_warned: bool, findings: &mut Findings, places: FilePlaces) -> bool {
        let Some(wheel) = self.drawing.wheels.first() else { return false };
        let centre = Vector3::from(wheel.centre);
        let [joints, _] = self.joints_and_seats("upright");
        // The bearing is at the centre.
        let joints: Vec<Vector3<f64>> =
            joints.into_iter().filter(|(name, _)| *name != "spindle").map(|(_, at)| at).collect();
        let is_far = |at: &&Vector3<f64>| (*at - centre).norm() > MAX_UPRIGHT_REACH;
        let far: Vec<&Vector3<f64>> = joints.iter().filter(is_far).collect();
        let track = 2.0 * centre.y.abs();
        let is_track_usual = track == 0.0 || (MIN_TRACK..=MAX_TRACK).contains(&track);
        // Findings about the unit or the side of the whole file explain the position of the wheel.
        let is_known = ["small-track", "right-side"].iter().any(|code| findings.has_code(code));
        let are_all_far = joints.len() > 1 && far.len() == joints.len();
        if (!is_track_usual || are_all_far) && !is_known {
            let distance = distance_from_box(&centre, &joints);
            let message = format!(
                "the centre of the wheel gives a track of {} and is {} away from the joints of its carrier: check the size and the \
                 sign of its coordinates ({})",
                places.length(track),
                places.length(distance),
                places.coordinate(1, centre)
            );
            let spot = self.drawing.hardpoint_at(centre).map(|(_, spot)| spot);
            findings.warning("astray-wheel", &spot.cloned().unwrap_or_default(), message);
            return true;
        }
        if !has_warned && !is_known {
            for at in far {
                let (name, spot) = self.drawing.hardpoint_at(*at).unzip();
                let message = format!(
                    "{} at {} is {} away from the centre of the wheel, farther than the joints of an upright are; check the value and its \
                     unit",
                    name.unwrap_or("a joint of the upright"),
                    places.point(*at),
                    places.length((at - centre).norm())
                );
                findings.warning("astray-point", &spot.cloned().unwrap_or_default(), message);
            }
        }
        false
    }

    /// Warns about pairs of seats whose points are exchanged.
    fn check_exchanged_seats(&self, findings: &mut Findings, places: FilePlaces) {
        for [seat, _] in &self.seat_pairs {
            let carrier = self.joints.iter().find(|joint| joint.child == *seat);
            let Some(link) = carrier.map(|joint| joint.parent.as_str()) else { continue };
            let joints: Vec<Vector3<f64>> =
                self.joints_and_seats(link)[0].iter().map(|(_, at)| *at).collect();
            let at = self.origin(seat);
            let Some((chassis_seat, other)) = self.exchanged_seat(seat, at, &joints) else { continue };
            let message = format!(
                "{seat} on {link} is {} away from the joints of {link}, and {chassis_seat} on the chassis only {}: exchange the two points",
                places.length(distance_from_box(&at, &joints)),
                places.length(other)
            );
            let spot = self.spots.get(*seat).cloned().unwrap_or_default();
            findings.warning("exchanged-seats", &spot, message);
        }
    }

    /// Seat on the chassis of a spring or damper and its distance (m) from the joints of the moving link, if this seat is nearer to them
    /// than the moving seat `at` by more than [`EXCHANGED_SEATS`].
    fn exchanged_seat(
        &self,
        seat: &str,
        at: Vector3<f64>,
        joints: &[Vector3<f64>],
    ) -> Option<(&'static str, f64)> {
        let [_, chassis_seat] = self.seat_pairs.iter().find(|[moving, _]| *moving == seat)?;
        if STOPS.iter().any(|stop| stop == chassis_seat) {
            return None;
        }
        let other = distance_from_box(&self.origin(chassis_seat), joints);
        let distance = distance_from_box(&at, joints);
        // If the seats are far from each other, one of them is a wrong point, not an exchanged one.
        let is_one_spring = (self.origin(chassis_seat) - at).norm() <= MAX_SPRING_LENGTH;
        let is_exchanged = distance > other + EXCHANGED_SEATS && is_one_spring;
        (is_exchanged && !joints.is_empty()).then_some((*chassis_seat, other))
    }

    /// Centres of mass with coordinates of the wrong sign.
    fn mirrored_masses(&self) -> Vec<MirroredMass<'_>> {
        let found = self.moving_links().into_iter().filter_map(|link| {
            let inertial = self.inertial(link).filter(|inertial| inertial.mass > 0.0)?;
            let joints = self.joints_and_seats(link)[0].iter().map(|(_, at)| *at).collect();
            let spot = self.com_spots.get(link).cloned().unwrap_or_default();
            MirroredMass::find(link, self.origin(link) + inertial.com, joints, spot)
        });
        found.collect()
    }

    /// Masses of the parts and of the wheel, each with the largest plausible mass, kg. `track`: as in [`check_parts`](Self::check_parts).
    pub fn masses(&self, track: Option<f64>) -> Vec<GivenMass> {
        let spot = |name: &str| self.spots.get(name).cloned().unwrap_or_default();
        let mass = |part: CheckedPart<'_>| GivenMass {
            part: part.name.to_owned(),
            mass: part.inertial.mass,
            most: part.largest_mass(),
            spot: spot(part.name),
        };
        let mut masses: Vec<GivenMass> = self.parts(track).into_iter().map(mass).collect();
        let wheel = self.inertial("wheel").filter(|wheel| wheel.mass > 0.0);
        masses.extend(wheel.map(|wheel| GivenMass {
            part: "wheel".to_owned(),
            mass: wheel.mass,
            most: MAX_WHEEL_MASS,
            spot: spot("spin"),
        }));
        masses
    }

    /// Parts with a mass, apart from the wheel.
    fn parts(&self, track: Option<f64>) -> Vec<CheckedPart<'_>> {
        let mut parts = Vec::new();
        for link in self.moving_links().into_iter().filter(|link| *link != "wheel") {
            let Some(inertial) = self.inertial(link).filter(|inertial| inertial.mass > 0.0) else { continue };
            let com = self.origin(link) + inertial.com;
            let [joints, seats] = self.joints_and_seats(link);
            let points = joints.iter().chain(&seats).map(|(_, at)| *at).chain([com]);
            let corners = |choose: fn(f64, f64) -> f64| points.clone().reduce(|a, b| a.zip_map(&b, choose));
            let (Some(least), Some(most)) = (corners(f64::min), corners(f64::max)) else { continue };
            let is_axle = AXLES.contains(&link);
            let size = track.filter(|_| is_axle).unwrap_or_else(|| (most - least).norm());
            let is_rod = joints.len() == 2 && seats.is_empty();
            let mut others = joints.iter().chain(&seats).map(|(_, at)| at);
            let first = others.next();
            let is_hub = first.is_none_or(|first| others.all(|at| (at - first).norm() < MIN_PART_SIZE));
            parts.push(CheckedPart { name: link, inertial, com, size, is_hub, is_rod, is_axle });
        }
        parts
    }

    /// Links of the corner that move, in the order of their names.
    fn moving_links(&self) -> Vec<&str> {
        let names = self.origins.keys().map(String::as_str);
        let mut moving: Vec<&str> = names.filter(|name| ![CHASSIS, RACK].contains(name)).collect();
        moving.sort_unstable();
        moving
    }

    /// Inertial data of a link of this corner.
    fn inertial(&self, link: &str) -> Option<&Inertial> {
        self.links.iter().find(|known| known.name == link)?.inertial.as_ref()
    }

    /// Names and positions of the joints and of the fixed frames of a link, m.
    fn joints_and_seats<'c>(&'c self, link: &'c str) -> [Vec<(&'c str, Vector3<f64>)>; 2] {
        let origin = self.origin(link);
        let (mut joints, mut seats) = (Vec::new(), Vec::new());
        // A floating joint does not locate the link.
        if self.joints.iter().any(|joint| joint.child == link && joint.kind != JointKind::Floating) {
            joints.push((link, origin));
        }
        for joint in self.joints.iter().filter(|joint| joint.parent == link) {
            let place = (joint.child.as_str(), origin + joint.origin.translation);
            let list = if joint.kind == JointKind::Fixed { &mut seats } else { &mut joints };
            list.push(place);
        }
        for closure in &self.closures {
            for (of, frame) in [
                (&closure.predecessor, &closure.predecessor_frame),
                (&closure.successor, &closure.successor_frame),
            ] {
                if of == link {
                    joints.push((closure.name.as_str(), origin + frame.translation));
                }
            }
        }
        [joints, seats]
    }
}
