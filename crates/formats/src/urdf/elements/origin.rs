//! `<origin>`: a translation, and a rotation in one of two notations.

use crate::reading::limits::QUATERNION_NORM_TOLERANCE;
use crate::reading::report::{Place, Report};
use crate::urdf::elements::numbers::{optional_numbers, parse_numbers, report_bad_number};
use crate::urdf::elements::survey::child;
use percuss_spatial::{Matrix3, Transform, rotation_from_quaternion, rotation_from_rpy};
use roxmltree::Node;
use std::f64::consts::{FRAC_PI_2, PI};

/// Checked `<origin>`.
#[derive(Clone, Copy)]
pub(crate) struct Origin<'a> {
    /// Three valid numbers, m.
    pub xyz: &'a str,
    /// Three valid numbers, rad.
    pub rpy: &'a str,
    /// Rotation matrix of `quat_xyzw`, in files of any version; `quat_xyzw` takes precedence over `rpy`. The
    /// quaternion is not converted to angles, whose error is milliradians near ±90° pitch.
    pub quaternion: Option<Matrix3<f64>>,
}

impl Origin<'_> {
    pub const IDENTITY: Origin<'static> = Origin { xyz: ZERO, rpy: ZERO, quaternion: None };

    /// Transform from the frame of the element to the frame of its parent.
    pub fn transform(&self) -> Transform<f64> {
        // The texts are already checked.
        let rotation = || rotation_from_rpy(parse_numbers(self.rpy).unwrap_or_default());
        let translation = parse_numbers::<3>(self.xyz).unwrap_or_default();
        Transform::new(self.quaternion.unwrap_or_else(rotation), translation.into())
    }

    /// The transform as the author meant it: angles such as 1.5708 are multiples of π/12.
    pub fn unrounded_transform(&self) -> Transform<f64> {
        let transform = self.transform();
        let mut angles = self.rpy.split_ascii_whitespace().map(unrounded);
        match [(); 3].map(|()| angles.next()) {
            [Some(roll), Some(pitch), Some(yaw)] if self.quaternion.is_none() => {
                Transform::new(rotation_from_rpy([roll, pitch, yaw]), transform.translation)
            }
            _ => transform,
        }
    }
}

/// The multiple of π/2, or of π/12 in a text with four decimals or more, that an angle (rad) in decimal notation rounds; otherwise the angle.
fn unrounded(text: &str) -> f64 {
    let [angle] = parse_numbers(text).unwrap_or_default();
    let decimals = text.split_once('.').map_or(0, |(_, digits)| digits.len());
    let unit = 10f64.powi(-(decimals.min(17) as i32));
    let is_plain = text.bytes().all(|byte| byte.is_ascii_digit() || matches!(byte, b'.' | b'-' | b'+'));
    let steps =
        [(2, FRAC_PI_2), (4, PI / 12.0)].into_iter().filter(|(least, _)| is_plain && decimals >= *least);
    let exact =
        steps.map(|(_, step)| (angle / step).round() * step).find(|exact| (exact - angle).abs() <= unit);
    exact.unwrap_or(angle)
}

const ZERO: &str = "0 0 0";

/// The `<origin>` of `parent`; identity if absent.
pub(crate) fn read_origin<'a, 'i: 'a>(parent: Node<'a, 'i>, report: &mut Report) -> Origin<'a> {
    child(parent, "origin").map_or(Origin::IDENTITY, |node| read_origin_attributes(node, report))
}

/// Origin from the attributes of an `<origin>` or of another element.
pub(crate) fn read_origin_attributes<'a>(node: Node<'a, '_>, report: &mut Report) -> Origin<'a> {
    let quaternion =
        node.attribute("quat_xyzw").and_then(|text| parse_quaternion_rotation(node, text, report));
    if node.attribute("quat_xyzw").is_some() && node.attribute("rpy").is_some() {
        report.warning("two-rotations", Place::Attribute(node, "quat_xyzw"), || {
            "both rpy and quat_xyzw are given; quat_xyzw is taken".to_owned()
        });
    }
    Origin {
        xyz: optional_numbers::<3>(node, "xyz", ZERO, report),
        rpy: optional_numbers::<3>(node, "rpy", ZERO, report),
        quaternion,
    }
}

/// Rotation matrix of `quat_xyzw`, normalised; `None` if invalid.
fn parse_quaternion_rotation(node: Node<'_, '_>, text: &str, report: &mut Report) -> Option<Matrix3<f64>> {
    let [x, y, z, w] = match parse_numbers::<4>(text) {
        Ok(values) => values,
        Err(defect) => {
            report_bad_number(node, "quat_xyzw", text, &defect, report);
            return None;
        }
    };
    let Some((rotation, length)) = rotation_from_any_quaternion([x, y, z, w]) else {
        report_bad_number(node, "quat_xyzw", text, ZERO_QUATERNION, report);
        return None;
    };
    if (length - 1.0).abs() > QUATERNION_NORM_TOLERANCE {
        report.warning("quaternion-not-unit", Place::Attribute(node, "quat_xyzw"), || {
            format!("the quaternion has norm {length}, not 1; it was normalised")
        });
    }
    Some(rotation)
}

pub(crate) const ZERO_QUATERNION: &str = "it is zero; a unit quaternion x y z w is expected";

/// Rotation matrix and norm of a quaternion x, y, z, w of any norm; `None` if the quaternion is zero.
pub(crate) fn rotation_from_any_quaternion([x, y, z, w]: [f64; 4]) -> Option<(Matrix3<f64>, f64)> {
    // Scaling first avoids overflow and underflow of the squares.
    let scale = [x, y, z, w].iter().fold(0.0f64, |a, b| a.max(b.abs()));
    let q = [w / scale, x / scale, y / scale, z / scale];
    let norm = q.iter().map(|c| c * c).sum::<f64>().sqrt();
    (scale >= f64::MIN_POSITIVE).then(|| (rotation_from_quaternion(q.map(|c| c / norm)), norm * scale))
}
