//! Drawing of a corner: lengths for comparison with the design, lines of the picture, and implausible points.

use crate::findings::{Findings, Spot};
use crate::limits::{
    MAX_ACROSS_MIDDLE_PLANE, MAX_ARM_LENGTH, MAX_LENGTH_RATIO, MIN_CENTRAL_LENGTH, MIN_REPORTED_LENGTH,
    SAME_POINT,
};
use crate::units::FilePlaces;
use percuss_spatial::Vector3;

/// Hardpoint of the centre of the wheel.
const WHEEL_CENTRE: &str = "wheel_centre";

/// Hinges between an outer and an inner point.
const HINGES: [&str; 2] = ["anti_roll_bar", "arm"];

/// Length of a link: from the hinge axis to the outer point for a hinged arm, from end to end for a rod.
#[derive(Clone, Debug)]
pub(crate) struct ArmLength {
    pub name: String,
    pub length: f64,
    spot: Spot,
}

/// Line of the picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Name of the link or the pair of seats.
    pub name: String,
    /// Ends, m; x forward, y left, z up.
    pub ends: [[f64; 3]; 2],
}

/// Wheel of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelCircle {
    /// Centre, m; x forward, y left, z up.
    pub centre: [f64; 3],
    /// Spin axis, a unit vector.
    pub axis: [f64; 3],
    /// Radius, m; `None` if unknown.
    pub radius: Option<f64>,
}

/// Lengths, lines, wheels and points of one corner.
#[derive(Clone, Debug, Default)]
pub(crate) struct Drawing {
    pub arms: Vec<ArmLength>,
    pub lines: Vec<Line>,
    pub wheels: Vec<WheelCircle>,
    points: Vec<CheckedPoint>,
}

/// Point whose side and height are compared with those of the wheel.
#[derive(Clone, Debug)]
struct CheckedPoint {
    name: String,
    at: Vector3<f64>,
    spot: Spot,
    /// False for a point of the axle as a whole, which may be on either side.
    has_side: bool,
}

impl Drawing {
    /// Adds an arm between its hinge and its outer point.
    pub fn add_arm(&mut self, name: &str, hinge: [Vector3<f64>; 2], outer: Vector3<f64>, spot: &Spot) {
        let [first, second] = hinge;
        let along = (second - first).normalize();
        let length = (outer - first).cross(&along).norm();
        if length.is_finite() {
            self.arms.push(ArmLength { name: name.to_owned(), length, spot: spot.clone() });
        }
        for end in hinge {
            self.add_line(name, [end, outer]);
            self.add_point(name, end, spot);
        }
        self.add_point(name, outer, spot);
    }

    /// Adds a rod, or a link between two points.
    pub fn add_rod(&mut self, name: &str, ends: [Vector3<f64>; 2], spot: &Spot) {
        let length = (ends[1] - ends[0]).norm();
        self.arms.push(ArmLength { name: name.to_owned(), length, spot: spot.clone() });
        self.add_line(name, ends);
        for end in ends {
            self.add_point(name, end, spot);
        }
    }

    /// Adds a line to the picture only.
    pub fn add_line(&mut self, name: &str, ends: [Vector3<f64>; 2]) {
        self.lines.push(Line { name: name.to_owned(), ends: ends.map(Into::into) });
    }

    /// Adds a point for the checks of side and height.
    pub fn add_point(&mut self, name: &str, at: Vector3<f64>, spot: &Spot) {
        let name = name.to_owned();
        self.points.push(CheckedPoint { name, at, spot: spot.clone(), has_side: true });
    }

    /// Sets the points that are compared with the wheel to all hardpoints of a sheet: name, position (m), place in the
    /// file, and true for a point of one side, false for a point of the axle as a whole.
    pub fn set_hardpoints<'n>(
        &mut self,
        points: impl Iterator<Item = (&'n str, Vector3<f64>, &'n Spot, bool)>,
    ) {
        let point = |(name, at, spot, has_side): (&str, Vector3<f64>, &Spot, bool)| CheckedPoint {
            name: name.to_owned(),
            at,
            spot: spot.clone(),
            has_side,
        };
        self.points = points.map(point).collect();
    }

    /// Warns about points on the other side of the vehicle, implausible heights, exchanged arms and disproportionate lengths. Returns
    /// true after a warning.
    pub fn check(&self, findings: &mut Findings, places: FilePlaces) -> bool {
        let Some(wheel) = self.wheels.first() else { return false };
        let mut has_warned = false;
        let side = wheel.centre[1].signum();
        // A wheel in the middle plane has no side.
        let is_in_middle = wheel.centre[1] == 0.0;
        let is_across = |point: &CheckedPoint| {
            !is_in_middle && point.has_side && point.at.y * side < -MAX_ACROSS_MIDDLE_PLANE
        };
        // If most points are on the other side, the wheel is on the wrong side; the check of the spindle reports this.
        let most_are_across =
            2 * self.points.iter().filter(|point| is_across(point)).count() > self.points.len();
        for point in self.points.iter().filter(|_| !most_are_across) {
            if is_across(point) {
                let CheckedPoint { name, at, spot, .. } = point;
                let message = format!(
                    "{name}: {} is on the other side of the vehicle than the wheel ({}): change the sign of \
                     its {}, or correct the point. {}",
                    places.coordinate(1, *at),
                    places.coordinate(1, wheel.centre.into()),
                    places.frame.axes.letter(1),
                    self.lengths_text(places)
                );
                findings.warning("mirrored-point", spot, message);
                has_warned = true;
            }
        }
        has_warned |= self.check_heights(wheel, findings, places);
        has_warned |= self.check_exchanged_arms(findings, places);
        let Some(median) = self.median_length() else { return has_warned };
        for arm in &self.arms {
            let is_disproportionate = arm.length > MAX_LENGTH_RATIO * median
                && arm.length > MIN_REPORTED_LENGTH
                && self.arms.len() > 2;
            if is_disproportionate || arm.length > MAX_ARM_LENGTH {
                let message = format!(
                    "{} is {} long; check its two end points. {}",
                    arm.name,
                    places.length(arm.length),
                    self.lengths_text(places)
                );
                findings.warning("astray-point", &arm.spot, message);
                has_warned = true;
            }
        }
        has_warned
    }

    /// Warns about very short links: a coordinate of one end probably has the wrong sign.
    pub fn check_short_links(&self, findings: &mut Findings, places: FilePlaces) {
        for arm in self.arms.iter().filter(|arm| arm.length < MIN_CENTRAL_LENGTH) {
            let message = format!(
                "{} is only {} long: check the signs of the coordinates of its ends",
                arm.name,
                places.length(arm.length)
            );
            findings.warning("astray-point", &arm.spot, message);
        }
    }

    /// Warns about points below the ground, and about a wheel below all points. Returns true after a warning.
    fn check_heights(&self, wheel: &WheelCircle, findings: &mut Findings, places: FilePlaces) -> bool {
        let Some(radius) = wheel.radius else { return false };
        let (ground, top) = (wheel.centre[2] - radius, wheel.centre[2] + radius);
        let others = || self.points.iter().filter(|point| point.name != WHEEL_CENTRE);
        if others().count() > 0 && others().all(|point| point.at.z > top) {
            let spot = self.points.iter().find(|point| point.name == WHEEL_CENTRE);
            let message = format!(
                "all other points are above the top of the wheel, at z = {}: change the sign of the wheel's z, or correct its centre \
                 or radius",
                places.length(top)
            );
            findings.warning(
                "low-wheel",
                &spot.map_or_else(Spot::default, |point| point.spot.clone()),
                message,
            );
            return true;
        }
        let mut has_warned = false;
        for CheckedPoint { name, at, spot, .. } in others().filter(|point| point.at.z < ground) {
            let message = format!(
                "{name}: z = {} is {} below the lowest point of the wheel, under the road: change the sign of its z, or correct \
                 the point or the radius of the wheel",
                places.length(at.z),
                places.length(ground - at.z)
            );
            findings.warning("below-ground", spot, message);
            has_warned = true;
        }
        has_warned
    }

    /// Warns about an outer ball joint of the upper arm below the outer ball joint of the lower arm. Returns true after a warning.
    fn check_exchanged_arms(&self, findings: &mut Findings, places: FilePlaces) -> bool {
        let of = |name: &str| self.points.iter().find(|point| point.name == name);
        let (Some(upper), Some(lower)) = (of("upper_ball"), of("lower_ball")) else { return false };
        if upper.at.z >= lower.at.z {
            return false;
        }
        let message = format!(
            "upper_ball is {} below lower_ball: exchange the two points, or correct their z",
            places.length(lower.at.z - upper.at.z)
        );
        findings.warning("exchanged-arms", &upper.spot, message);
        true
    }

    /// Warns about lateral rods whose outer end is nearer to the vehicle's middle plane than their inner end. Returns true after a
    /// warning.
    pub fn check_exchanged_ends(&self, findings: &mut Findings, places: FilePlaces) -> bool {
        let of = |name: String| self.points.iter().find(|point| point.name == name);
        let mut has_warned = false;
        for outer in &self.points {
            // The two points of a hinge give a line, in either order.
            let rod = outer.name.strip_suffix("_outer").filter(|rod| !HINGES.contains(rod));
            let inner =
                rod.and_then(|rod| of(format!("{rod}_inner")).or_else(|| of(format!("{rod}_chassis"))));
            let Some(inner) = inner else { continue };
            let inward = inner.at.y.abs() - outer.at.y.abs();
            if inward > 0.5 * (inner.at - outer.at).norm() {
                let message = format!(
                    "{} is {} nearer to the middle of the vehicle than {}: exchange the two points, or correct their y",
                    outer.name,
                    places.length(inward),
                    inner.name
                );
                findings.warning("exchanged-ends", &outer.spot, message);
                has_warned = true;
            }
        }
        has_warned
    }

    /// Hardpoint at a position (m) and its place in the file.
    pub fn hardpoint_at(&self, at: Vector3<f64>) -> Option<(&str, &Spot)> {
        let point = self.points.iter().find(|point| (point.at - at).norm() <= SAME_POINT)?;
        Some((&point.name, &point.spot))
    }

    /// Distance of both wheel centres, m; `None` without a wheel.
    pub fn track(&self) -> Option<f64> {
        self.wheels.first().map(|wheel| 2.0 * wheel.centre[1].abs())
    }

    /// Median of the lengths of the links, m; `None` without links.
    pub fn median_length(&self) -> Option<f64> {
        let mut sorted: Vec<f64> = self.arms.iter().map(|arm| arm.length).collect();
        sorted.sort_by(f64::total_cmp);
        sorted.get(sorted.len() / 2).copied()
    }

    /// List of all lengths, for messages.
    fn lengths_text(&self, places: FilePlaces) -> String {
        let shown = |arm: &ArmLength| format!("{} {}", arm.name, places.number(arm.length));
        let list: Vec<String> = self.arms.iter().map(shown).collect();
        let unit = places.frame.unit.name();
        if list.is_empty() { String::new() } else { format!("Lengths in {unit}: {}", list.join(", ")) }
    }

    /// Mirror image, y → −y.
    pub fn mirrored(&self) -> Self {
        let flip = |[x, y, z]: [f64; 3]| [x, 0.0 - y, z];
        let mut drawing = self.clone();
        for line in &mut drawing.lines {
            line.ends = line.ends.map(flip);
        }
        for wheel in &mut drawing.wheels {
            wheel.centre = flip(wheel.centre);
            wheel.axis = flip(wheel.axis);
        }
        drawing.points.iter_mut().for_each(|point| point.at.y = 0.0 - point.at.y);
        drawing
    }
}
