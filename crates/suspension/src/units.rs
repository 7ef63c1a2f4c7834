//! Vehicle axes, with their names in files and flags, and the frame of a file.

use super::findings::{Findings, Spot};
use crate::limits::{MAX_VEHICLE_EXTENT, MIN_VEHICLE_EXTENT};
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

/// Refuses a vehicle with a farthest coordinate (m) beyond the limit: the lengths are in another unit.
pub(super) fn check_size(findings: &mut Findings, far: f64, spot: &Spot, unit: LengthUnit) {
    let (size, name) = (unit.of_metres(far), unit.name());
    if far > MAX_VEHICLE_EXTENT {
        let remedy = match unit {
            LengthUnit::Metre => "if the file is in millimetres, give --unit mm",
            LengthUnit::Centimetre | LengthUnit::Millimetre | LengthUnit::Inch => {
                "give the file's unit by --unit"
            }
        };
        let message = format!(
            "a coordinate of {size} {name}, read in {name}: no hardpoint lies {far} m out. {remedy}; if only this \
             number is wrong, correct it"
        );
        findings.error("wrong-unit", spot, message);
    } else if far < MIN_VEHICLE_EXTENT {
        let message = format!(
            "the coordinate farthest from the vehicle's origin is {size} {name}, read in {name}: no vehicle is so \
             small. If the file is in metres, give --unit m"
        );
        findings.error("wrong-unit", spot, message);
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
