//! What was understood of a suspension file, in numbers to check against the drawing.

use super::drawing::{Drawing, Line, WheelCircle};
use super::options::{Side, Wheel};
use super::units::{LengthUnit, VehicleAxes};
use percuss_mechanism::Mechanism;

/// What was understood of a suspension file. Lengths in m, masses in kg, places x forward, y left, z up.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Understood {
    /// The suspension's name.
    pub name: String,
    /// Its template.
    pub template: String,
    /// The unit that the file's lengths were read in.
    pub unit: LengthUnit,
    /// The axes that the file was read in.
    pub axes: VehicleAxes,
    /// What was built.
    pub side: Side,
    /// The wheel.
    pub wheel: Option<Wheel>,
    /// Distance of both wheels' centres, twice that of one from the middle plane.
    pub track: Option<f64>,
    /// Lengths of one side and of what both share: of an arm on a hinge, from the hinge's line to its outer point; of a
    /// rod, from end to end.
    pub lengths: Vec<(String, f64)>,
    /// Links with mass, in the order of the mechanism.
    pub masses: Vec<(String, f64)>,
    /// Of all links.
    pub total_mass: f64,
    /// Names of the hardpoints of a sheet or table; none of a file of Chrono's.
    pub points: Vec<String>,
    /// Lines of the picture.
    pub lines: Vec<Line>,
    /// Wheels of the picture.
    pub wheels: Vec<WheelCircle>,
}

impl Understood {
    /// What the mechanism and its drawing say.
    pub(super) fn of(mechanism: &Mechanism, left: &Drawing, middle: Option<&Drawing>, side: Side) -> Self {
        let lengths = left.arms.iter().chain(middle.iter().flat_map(|m| &m.arms));
        let massive = mechanism.links().iter().filter_map(|link| Some((link, link.inertial()?)));
        let right = left.mirrored();
        let sides: &[&Drawing] = match side {
            Side::Left => &[left],
            Side::Right => &[&right],
            Side::Both => &[left, &right],
        };
        let seen: Vec<&Drawing> = sides.iter().copied().chain(middle).collect();
        Self {
            track: left.wheels.first().map(|wheel| 2.0 * wheel.centre[1].abs()),
            lengths: lengths.map(|arm| (arm.name.clone(), arm.length)).collect(),
            masses: massive.map(|(link, inertial)| (link.name().to_owned(), inertial.mass)).collect(),
            total_mass: mechanism.total_mass(),
            lines: seen.iter().flat_map(|d| d.lines.clone()).collect(),
            wheels: seen.iter().flat_map(|d| d.wheels.clone()).collect(),
            ..Self::default()
        }
    }
}
