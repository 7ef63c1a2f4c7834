//! Summary of a suspension file, for comparison with the design.

use super::options::{Side, Wheel};
use super::units::VehicleAxes;
use crate::corner::drawing::{Drawing, Line, WheelCircle};
use crate::forces::ForceElements;
use percuss_mechanism::Mechanism;
use percuss_units::LengthUnit;

/// Summary of a suspension file. Lengths in m, masses in kg; x forward, y left, z up.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Understood {
    /// Name of the suspension.
    pub name: String,
    /// Template.
    pub template: String,
    /// Unit of the file's lengths.
    pub unit: LengthUnit,
    /// Axes of the file.
    pub axes: VehicleAxes,
    /// Side or sides built.
    pub side: Side,
    /// Wheel.
    pub wheel: Option<Wheel>,
    /// Distance between the centres of both wheels across the vehicle: twice the distance of one from the middle plane. `None` for a wheel in
    /// the middle plane.
    pub track: Option<f64>,
    /// Lengths of the links of one side and of the shared links: from the hinge axis to the outer point for a hinged
    /// arm, from end to end for a rod.
    pub lengths: Vec<(String, f64)>,
    /// Links with mass, in the order of the mechanism.
    pub masses: Vec<(String, f64)>,
    /// Mass of all links.
    pub total_mass: f64,
    /// Names of the hardpoints of a sheet or table; empty for a Chrono file.
    pub points: Vec<String>,
    /// Hardpoints with their coordinates, m, in the axes of the file and on the side of its points.
    pub coordinates: Vec<(String, [f64; 3])>,
    /// Two points of the steering axis of the left side as built, each with its link; empty if the template has no axis that
    /// is fixed to two points.
    pub steering_axis: Vec<(String, [f64; 3])>,
    /// The same of the right side, mirrored to the left.
    pub right_steering_axis: Vec<(String, [f64; 3])>,
    /// True if both wheels are on one rigid axle.
    pub axle: bool,
    /// Forces of springs and stops.
    pub forces: ForceElements,
    /// Travel of the rack per turn of the steering wheel.
    pub rack_travel: Option<f64>,
    /// Keys of masses, centres of mass and inertias that are missing in the sheet and optional
    /// ([`masses_optional`](super::ImportOptions::masses_optional)): they are zero.
    pub missing_masses: Vec<String>,
    /// Lines of the picture.
    pub lines: Vec<Line>,
    /// Wheels of the picture.
    pub wheels: Vec<WheelCircle>,
}

impl Understood {
    /// Creates the summary of a mechanism and its drawing.
    pub(super) fn of(
        mechanism: &Mechanism,
        [left, right]: [&Drawing; 2],
        middle: Option<&Drawing>,
        side: Side,
    ) -> Self {
        let lengths = left.arms.iter().chain(middle.iter().flat_map(|m| &m.arms));
        let massive = mechanism.links().iter().filter_map(|link| Some((link, link.inertial()?)));
        let half_track = |side: &Drawing| side.wheels.first().map(|wheel| wheel.centre[1].abs());
        let track = half_track(left).zip(half_track(right)).map(|(left, right)| left + right);
        let right = right.mirrored();
        let sides: &[&Drawing] = match side {
            Side::Left => &[left],
            Side::Right => &[&right],
            Side::Both => &[left, &right],
        };
        let drawings: Vec<&Drawing> = sides.iter().copied().chain(middle).collect();
        Self {
            track: track.filter(|track| *track > 0.0),
            lengths: lengths.map(|arm| (arm.name.clone(), arm.length)).collect(),
            masses: massive.map(|(link, inertial)| (link.name().to_owned(), inertial.mass)).collect(),
            total_mass: mechanism.total_mass(),
            lines: drawings.iter().flat_map(|d| d.lines.clone()).collect(),
            wheels: drawings.iter().flat_map(|d| d.wheels.clone()).collect(),
            ..Self::default()
        }
    }
}
