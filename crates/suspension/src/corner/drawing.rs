//! Drawing of a corner: lengths for comparison with the design, lines of the picture, and implausible points.

use crate::findings::{Findings, Spot};
use crate::limits::{MAX_ACROSS_MIDDLE_PLANE, MAX_ARM_LENGTH, MAX_LENGTH_RATIO, MIN_REPORTED_LENGTH};
use percuss_spatial::Vector3;

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
    points: Vec<(String, Vector3<f64>, Spot)>,
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

    /// Adds a point, for the check of its side.
    pub fn add_point(&mut self, name: &str, at: Vector3<f64>, spot: &Spot) {
        self.points.push((name.to_owned(), at, spot.clone()));
    }

    /// Warns about points on the other side of the vehicle and about disproportionate lengths. Returns true after a
    /// warning.
    pub fn check(&self, findings: &mut Findings) -> bool {
        let Some(wheel) = self.wheels.first() else { return false };
        let mut has_warned = false;
        let side = wheel.centre[1].signum();
        // A wheel in the middle plane has no side.
        let is_in_middle = wheel.centre[1] == 0.0;
        let is_across = |at: &Vector3<f64>| !is_in_middle && at.y * side < -MAX_ACROSS_MIDDLE_PLANE;
        // If most points are on the other side, the wheel is on the wrong side, which the spindle's check reports.
        let most_are_across =
            2 * self.points.iter().filter(|(_, at, _)| is_across(at)).count() > self.points.len();
        for (name, at, spot) in self.points.iter().filter(|_| !most_are_across) {
            if is_across(at) {
                let message = format!(
                    "{}: a point {} m from the middle plane is on the other side of the vehicle than the wheel ({} m from \
                     it): change the sign of its y, or correct the point. {}",
                    name,
                    rounded(at.y.abs()),
                    rounded(wheel.centre[1].abs()),
                    self.lengths_text()
                );
                findings.warning("mirrored-point", spot, message);
                has_warned = true;
            }
        }
        let Some(median) = self.median_length() else { return has_warned };
        for arm in &self.arms {
            let is_disproportionate = arm.length > MAX_LENGTH_RATIO * median
                && arm.length > MIN_REPORTED_LENGTH
                && self.arms.len() > 2;
            if is_disproportionate || arm.length > MAX_ARM_LENGTH {
                let message = format!(
                    "{} is {} m long: is one of its points astray? {}",
                    arm.name,
                    rounded(arm.length),
                    self.lengths_text()
                );
                findings.warning("astray-point", &arm.spot, message);
                has_warned = true;
            }
        }
        has_warned
    }

    /// Median of the lengths of the links, m; `None` without links.
    pub fn median_length(&self) -> Option<f64> {
        let mut sorted: Vec<f64> = self.arms.iter().map(|arm| arm.length).collect();
        sorted.sort_by(f64::total_cmp);
        sorted.get(sorted.len() / 2).copied()
    }

    /// List of all lengths, for messages.
    fn lengths_text(&self) -> String {
        let shown = |arm: &ArmLength| format!("{} {}", arm.name, rounded(arm.length));
        let list: Vec<String> = self.arms.iter().map(shown).collect();
        if list.is_empty() { String::new() } else { format!("Lengths in m: {}", list.join(", ")) }
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
        drawing.points.iter_mut().for_each(|(_, at, _)| at.y = 0.0 - at.y);
        drawing
    }
}

/// Rounds to 0.1 mm.
pub(crate) fn rounded(x: f64) -> f64 {
    (x * 1e4).round() / 1e4 + 0.0
}
