//! Vehicle axes, with their names in files and flags, and the frame of a file.

use super::findings::{Findings, Spot};
use crate::limits::{
    MAX_ARM_LENGTH, MAX_VEHICLE_EXTENT, MESSAGE_LENGTH, MIN_LINK_LENGTH, MIN_TRACK, MIN_VEHICLE_EXTENT,
    USUAL_TRACKS,
};
use percuss_spatial::{Matrix3, Vector3};
use percuss_units::LengthUnit;

/// Axes of a vehicle; z points up in both conventions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum VehicleAxes {
    /// ISO 8855: x forward, y left, z up.
    #[default]
    Iso,
    /// Adams/Car: x backward, y right, z up; rotated by 180° about z relative to ISO 8855.
    Adams,
}

impl VehicleAxes {
    /// Both conventions.
    pub const ALL: [Self; 2] = [Self::Iso, Self::Adams];

    /// Name: `iso` or `adams`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Iso => "iso",
            Self::Adams => "adams",
        }
    }

    /// Axes with the given name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|axes| axes.name() == name)
    }

    /// Directions of the axes, in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Iso => "x forward, y left, z up",
            Self::Adams => "x backward, y right, z up",
        }
    }

    /// Converts a vector to the axes of ISO 8855, or back: R = diag(−1, −1, 1) is its own inverse.
    pub fn to_iso(self, v: Vector3<f64>) -> Vector3<f64> {
        match self {
            Self::Iso => v,
            // 0 − x avoids −0.
            Self::Adams => Vector3::new(0.0 - v.x, 0.0 - v.y, v.z),
        }
    }

    /// Converts an inertia to the axes of ISO 8855, or back: R I Rᵀ.
    pub fn inertia_to_iso(self, inertia: Matrix3<f64>) -> Matrix3<f64> {
        let mut inertia = inertia;
        if self == Self::Adams {
            for (row, column) in [(0, 2), (2, 0), (1, 2), (2, 1)] {
                inertia[(row, column)] = 0.0 - inertia[(row, column)];
            }
        }
        inertia
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
        // The conversion of the axes is its own inverse.
        self.frame.axes.to_iso(at)
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

    #[test]
    fn axes_have_one_name_each_and_convert_both_ways() {
        for axes in VehicleAxes::ALL {
            assert_eq!(VehicleAxes::from_name(axes.name()), Some(axes));
            let v = Vector3::new(1.0, -2.0, 3.0);
            assert_eq!(axes.to_iso(axes.to_iso(v)), v);
        }
    }

    #[test]
    fn an_inertia_turns_with_its_axes() {
        let inertia = Matrix3::new(1.0, 0.1, 0.2, 0.1, 2.0, 0.3, 0.2, 0.3, 2.5);
        let r = Matrix3::from_diagonal(&Vector3::new(-1.0, -1.0, 1.0));
        assert_eq!(VehicleAxes::Adams.inertia_to_iso(inertia), r * inertia * r.transpose());
    }
}
