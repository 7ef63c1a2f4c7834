//! Vehicle axes, with their names in files and flags, and the frame of a file.

use super::findings::{Findings, Spot};
use crate::limits::{
    MAX_ARM_LENGTH, MAX_VEHICLE_EXTENT, MESSAGE_LENGTH, MIN_LINK_LENGTH, MIN_TRACK, MIN_VEHICLE_EXTENT,
    USUAL_TRACKS,
};
use percuss_spatial::{Matrix3, Vector3};
use percuss_units::LengthUnit;

/// Axes of a file: each direction of ISO 8855 (forward, left, up) is an axis of the file or its negative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VehicleAxes {
    /// Axis of the file along forward, left and up: 0 for x, 1 for y, 2 for z.
    along: [usize; 3],
    /// True if the axis of the file points to the other side: backward, right, down.
    is_negative: [bool; 3],
}

impl Default for VehicleAxes {
    fn default() -> Self {
        Self::ISO
    }
}

/// Letters of the axes of a file.
const LETTERS: [&str; 3] = ["x", "y", "z"];

impl VehicleAxes {
    /// ISO 8855: x forward, y left, z up.
    pub const ISO: Self = Self { along: [0, 1, 2], is_negative: [false; 3] };
    /// Adams/Car: x backward, y right, z up.
    pub const ADAMS: Self = Self { along: [0, 1, 2], is_negative: [true, true, false] };
    /// SAE J670: x forward, y right, z down.
    pub const SAE: Self = Self { along: [0, 1, 2], is_negative: [false, true, true] };
    /// rFactor: x left, y up, z backward; left-handed.
    pub const RFACTOR: Self = Self { along: [2, 0, 1], is_negative: [true, false, false] };
    /// Conventions with a name.
    pub const ALL: [Self; 4] = [Self::ISO, Self::ADAMS, Self::SAE, Self::RFACTOR];
    const NAMES: [&str; 4] = ["iso", "adams", "sae", "rfactor"];
    /// Description of valid names, for messages.
    pub const CHOICES: &str = "iso (x forward, y left, z up), adams (x backward, y right, z up), sae (x forward, y right, z down), \
         rfactor (x left, y up, z backward), or the axes of the file that point forward, left and up, such as \"-x y -z\"";

    /// Name of the convention, or the axes that point forward, left and up: `-z x y`.
    pub fn name(self) -> String {
        if let Some(named) = Self::ALL.iter().position(|known| *known == self) {
            return Self::NAMES[named].to_owned();
        }
        let axis = |k: usize| format!("{}{}", if self.is_negative[k] { "-" } else { "" }, self.letter(k));
        [0, 1, 2].map(axis).join(" ")
    }

    /// Axes of a name: `iso`, `adams`, `sae`, `rfactor`, or three different axes with their signs, `-z x y`: those of the file that
    /// point forward, left and up. `None` for another text.
    pub fn from_name(name: &str) -> Option<Self> {
        let name = name.trim().to_ascii_lowercase().replace('−', "-");
        if let Some(known) = Self::NAMES.iter().position(|known| *known == name) {
            return Some(Self::ALL[known]);
        }
        let mut axes = Self::ISO;
        let parts: Vec<&str> = name.split([' ', ',']).filter(|part| !part.is_empty()).collect();
        if parts.len() != 3 {
            return None;
        }
        for (k, part) in parts.into_iter().enumerate() {
            let letter = part.trim_start_matches(['-', '+']);
            axes.is_negative[k] = part.starts_with('-');
            axes.along[k] = LETTERS.iter().position(|known| *known == letter)?;
            if part.len() > letter.len() + 1 || axes.along[..k].contains(&axes.along[k]) {
                return None;
            }
        }
        Some(axes)
    }

    /// Directions of the axes, in words.
    pub fn words(self) -> String {
        const DIRECTIONS: [[&str; 2]; 3] = [["forward", "backward"], ["left", "right"], ["up", "down"]];
        let of_axis = |axis: usize| {
            let k = (0..3).find(|k| self.along[*k] == axis).unwrap_or_default();
            format!("{} {}", LETTERS[axis], DIRECTIONS[k][usize::from(self.is_negative[k])])
        };
        [0, 1, 2].map(of_axis).join(", ")
    }

    /// Letter of the axis of the file along forward (0), left (1) or up (2).
    pub(super) fn letter(self, direction: usize) -> &'static str {
        LETTERS[self.along[direction]]
    }

    /// Coordinate of the file along that axis, from the one forward (0), left (1) or up (2).
    pub(super) fn coordinate(self, direction: usize, value: f64) -> f64 {
        // 0 − x avoids −0.
        if self.is_negative[direction] { 0.0 - value } else { value }
    }

    /// True if the axes x, y, z are along the vehicle, across it and vertical, in this order.
    pub fn is_in_order(self) -> bool {
        self.along == [0, 1, 2]
    }

    /// Same axes turned by 180° about the vertical.
    pub(super) fn turned(self) -> Self {
        let [forward, left, up] = self.is_negative;
        Self { is_negative: [!forward, !left, up], ..self }
    }

    /// Converts a vector to the axes of ISO 8855.
    pub fn to_iso(self, v: Vector3<f64>) -> Vector3<f64> {
        Vector3::from([0, 1, 2].map(|k| self.coordinate(k, v[self.along[k]])))
    }

    /// Converts a vector from the axes of ISO 8855.
    pub fn from_iso(self, v: Vector3<f64>) -> Vector3<f64> {
        let mut own = Vector3::zeros();
        (0..3).for_each(|k| own[self.along[k]] = self.coordinate(k, v[k]));
        own
    }

    /// Converts an inertia to the axes of ISO 8855: R I Rᵀ.
    pub fn inertia_to_iso(self, inertia: Matrix3<f64>) -> Matrix3<f64> {
        let entry = |i: usize, k: usize| {
            let value = inertia[(self.along[i], self.along[k])];
            if self.is_negative[i] == self.is_negative[k] { value } else { 0.0 - value }
        };
        Matrix3::from_fn(entry)
    }

    /// Converts an inertia from the axes of ISO 8855: Rᵀ I R.
    pub fn inertia_from_iso(self, inertia: Matrix3<f64>) -> Matrix3<f64> {
        let mut own = Matrix3::zeros();
        for (i, k) in (0..9).map(|n| (n / 3, n % 3)) {
            let is_reversed = self.is_negative[i] != self.is_negative[k];
            let value = if is_reversed { 0.0 - inertia[(i, k)] } else { inertia[(i, k)] };
            own[(self.along[i], self.along[k])] = value;
        }
        own
    }
}

/// Unit of length and axes of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Frame {
    pub unit: LengthUnit,
    pub axes: VehicleAxes,
}

impl Frame {
    /// Converts a point to metres and to the axes of ISO 8855.
    pub fn point(self, p: Vector3<f64>) -> Vector3<f64> {
        self.axes.to_iso(p.map(|x| self.unit.to_metres(x)))
    }
}

/// Number with four significant digits for messages, without the rounding errors of a conversion.
pub(super) fn short(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

/// Unit, axes and side of the positions in a file. Converts positions of the left side (ISO 8855, m) for messages.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct FilePlaces {
    pub frame: Frame,
    /// True if the file describes the right side.
    pub is_right: bool,
}

impl FilePlaces {
    /// Number for a length (m) in the unit of the file, to a tenth of a millimetre.
    pub fn number(self, length: f64) -> f64 {
        let in_unit = self.frame.unit.of_metres(length);
        let per_tenth = self.frame.unit.of_metres(MESSAGE_LENGTH).log10().floor() as i32;
        let scale = 10f64.powi(-per_tenth);
        (in_unit * scale).round() / scale + 0.0
    }

    /// Length (m) with the unit of the file.
    pub fn length(self, length: f64) -> String {
        format!("{} {}", self.number(length), self.frame.unit.name())
    }

    /// Coordinates (m) in the axes and on the side of the file, from the left side in ISO 8855.
    pub fn coordinates(self, at: Vector3<f64>) -> Vector3<f64> {
        let at = Vector3::new(at.x, if self.is_right { 0.0 - at.y } else { at.y }, at.z);
        self.frame.axes.from_iso(at)
    }

    /// Coordinate of a position along (0), across (1) or vertical (2) to the vehicle, as the file has it: `y = 720 mm`.
    pub fn coordinate(self, direction: usize, at: Vector3<f64>) -> String {
        let axes = self.frame.axes;
        let side = if direction == 1 && self.is_right { -1.0 } else { 1.0 };
        format!(
            "{} = {}",
            axes.letter(direction),
            self.length(axes.coordinate(direction, side * at[direction]))
        )
    }

    /// Position with the unit and the axes of the file.
    pub fn point(self, at: Vector3<f64>) -> String {
        let [x, y, z]: [f64; 3] = self.coordinates(at).map(|x| self.number(x)).into();
        let Frame { unit, axes } = self.frame;
        format!("({x}, {y}, {z}) {}, axes {} ({})", unit.name(), axes.name(), axes.words())
    }
}

/// Refuses a vehicle with a farthest coordinate (m) beyond the limit: the lengths are in another unit.
pub(super) fn check_size(findings: &mut Findings, far: f64, spot: &Spot, unit: LengthUnit) {
    let (size, name) = (short(unit.of_metres(far)), unit.name());
    if far > MAX_VEHICLE_EXTENT {
        let other = if unit == LengthUnit::Metre { "mm" } else { "another unit" };
        let message = format!(
            "a coordinate of {size} {name}, read in {name}: no hardpoint has a coordinate of {} m. If the file is in {other}, \
             {}; if only this number is wrong, correct it",
            short(far),
            unit_remedy(if unit == LengthUnit::Metre { "mm" } else { "UNIT" })
        );
        findings.error("wrong-unit", spot, message);
    } else if far < MIN_VEHICLE_EXTENT {
        let message = format!(
            "the coordinate farthest from the vehicle's origin is {size} {name}, read in {name}: no vehicle is so \
             small. If the file is in metres, {}",
            unit_remedy("m")
        );
        findings.error("wrong-unit", spot, message);
    }
}

/// Remedy for lengths in another unit than stated, valid for sheets, tables and files of Chrono.
fn unit_remedy(unit: &str) -> String {
    format!(
        "write unit = \"{unit}\" in the sheet, or import a file without a unit by `percuss import … --unit {unit}`"
    )
}

/// Checks the size of a corner: `track` is the distance of both wheel centres, `link` the median length of the links, m. Long
/// links are refused; a very small track is a warning, because the vehicle may be a model.
pub(super) fn check_proportions(
    findings: &mut Findings,
    track: f64,
    link: Option<f64>,
    spot: &Spot,
    unit: LengthUnit,
) {
    let stated = unit.name();
    let fitting = LengthUnit::ALL.into_iter().filter(|other| {
        let in_other = other.to_metres(unit.of_metres(track));
        *other != unit && USUAL_TRACKS.contains(&in_other)
    });
    let fitting: Vec<String> = fitting
        .map(|other| {
            let in_other = 1e3 * other.to_metres(unit.of_metres(track));
            format!("{} (track {in_other:.0} mm)", other.name())
        })
        .collect();
    let remedy = match &fitting[..] {
        [] => format!("Check the unit; {}", unit_remedy("UNIT")),
        [first, ..] => {
            let unit = first.split(' ').next().unwrap_or_default();
            format!("Is the file in {}? Then {}", fitting.join(" or "), unit_remedy(unit))
        }
    };
    if let Some(link) = link.filter(|link| *link > MAX_ARM_LENGTH) {
        let message = format!(
            "with coordinates in {stated}, the track would be {track:.2} m and the median length of the links {link:.2} m; no \
             suspension is so large. {remedy}"
        );
        findings.error("wrong-unit", spot, message);
    } else if track < MIN_TRACK && !fitting.is_empty() && link.is_none_or(|link| link < MIN_LINK_LENGTH) {
        let message = format!(
            "with coordinates in {stated}, the track would be only {:.0} mm, the track of a scale model. {remedy}",
            1e3 * track
        );
        findings.warning("small-track", spot, message);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Matrix of the conversion to the axes of ISO 8855.
    fn matrix(axes: VehicleAxes) -> Matrix3<f64> {
        Matrix3::from_columns(&[Vector3::x(), Vector3::y(), Vector3::z()].map(|v| axes.to_iso(v)))
    }

    #[test]
    fn axes_have_one_name_each_and_convert_both_ways() {
        let letters = |text: &str| VehicleAxes::from_name(text).unwrap();
        assert_eq!(letters("x y z"), VehicleAxes::ISO);
        assert_eq!(letters("-x, -y, z"), VehicleAxes::ADAMS);
        assert_eq!(letters("x -y −z"), VehicleAxes::SAE);
        assert_eq!(letters("-Z +X Y"), VehicleAxes::RFACTOR);
        assert_eq!(VehicleAxes::RFACTOR.words(), "x left, y up, z backward");
        for text in ["", "x y", "x y y", "x y z z", "--x y z", "a b c", "ISO 8855"] {
            assert_eq!(VehicleAxes::from_name(text), None, "{text}");
        }
        let v = Vector3::new(1.0, -2.0, 3.0);
        let inertia = Matrix3::new(1.0, 0.1, 0.2, 0.1, 2.0, 0.3, 0.2, 0.3, 2.5);
        let orders = ["x y z", "x z y", "y x z", "y z x", "z x y", "z y x"];
        for (i, order) in orders.into_iter().flat_map(|order| (0..8).map(move |i| (i, order))) {
            let signed = |(k, axis)| format!("{}{axis}", if i >> k & 1 == 1 { "-" } else { "" });
            let text: Vec<String> = order.split(' ').enumerate().map(signed).collect();
            let axes = letters(&text.join(" "));
            assert_eq!(letters(&axes.name()), axes);
            assert_eq!(axes.from_iso(axes.to_iso(v)), v);
            let r = matrix(axes);
            assert_eq!(axes.to_iso(v), r * v);
            assert_eq!(axes.inertia_to_iso(inertia), r * inertia * r.transpose());
            assert_eq!(axes.inertia_from_iso(axes.inertia_to_iso(inertia)), inertia);
        }
    }
}
