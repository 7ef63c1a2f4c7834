//! `<origin>`: a translation, and a rotation in one of two notations.

use crate::reading::limits::{LARGEST_ANGLE, QUATERNION_NORM_TOLERANCE};
use crate::reading::report::{Place, Report};
use crate::reading::xml::Node;
use crate::urdf::elements::numbers::{optional_numbers, parse_numbers, report_bad_number};
use crate::urdf::elements::survey::child;
use percuss_spatial::{Matrix3, Transform, rotation_from_quaternion, rotation_from_rpy};
use std::f64::consts::{FRAC_PI_2, PI};

/// Checked `<origin>`: transform from the frame of the element to the frame of its parent.
#[derive(Clone, Copy)]
pub(crate) struct Origin {
    pub transform: Transform<f64>,
    /// The transform as the author meant it: angles such as 1.5708 are multiples of π/12.
    pub unrounded: Transform<f64>,
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

/// The `<origin>` of `parent`; identity if absent.
pub(crate) fn read_origin(parent: Node<'_>, report: &mut Report) -> Origin {
    let identity = Transform::identity();
    let absent = Origin { transform: identity, unrounded: identity };
    child(parent, "origin").map_or(absent, |node| read_origin_attributes(node, report))
}

/// Origin from the attributes of an `<origin>` or of another element. `quat_xyzw`, in files of any version, takes precedence over `rpy`;
/// it is not converted to angles, whose error is milliradians near ±90° pitch.
pub(crate) fn read_origin_attributes(node: Node<'_>, report: &mut Report) -> Origin {
    let quaternion =
        node.attribute("quat_xyzw").and_then(|text| parse_quaternion_rotation(node, text, report));
    if node.attribute("quat_xyzw").is_some() && node.attribute("rpy").is_some() {
        report.warning("two-rotations", Place::Attribute(node, "quat_xyzw"), || {
            "both rpy and quat_xyzw are given; quat_xyzw is taken".to_owned()
        });
    }
    let translation = optional_numbers::<3>(node, "xyz", [0.0; 3], report).into();
    let rpy = optional_numbers::<3>(node, "rpy", [0.0; 3], report);
    if let Some(angle) = degrees_in_place_of_radians(&rpy) {
        report.warning("large-angle", Place::Attribute(node, "rpy"), || large_angle_message(angle));
    }
    let mut angles = node.attribute("rpy").unwrap_or_default().split_ascii_whitespace().map(unrounded);
    let exact = match [(); 3].map(|()| angles.next()) {
        [Some(roll), Some(pitch), Some(yaw)] => [roll, pitch, yaw],
        _ => rpy,
    };
    let frame = |rpy| Transform::new(quaternion.unwrap_or_else(|| rotation_from_rpy(rpy)), translation);
    Origin { transform: frame(rpy), unrounded: frame(exact) }
}

/// First angle of more than a turn, rad.
pub(crate) fn degrees_in_place_of_radians(angles: &[f64]) -> Option<f64> {
    angles.iter().copied().find(|angle| angle.abs() > LARGEST_ANGLE)
}

/// Message about such an angle.
pub(crate) fn large_angle_message(angle: f64) -> String {
    let in_rad = (angle.to_radians() * 1e6).round() / 1e6;
    format!("the angles are in rad, and {angle} is more than a turn: if degrees are meant, write {in_rad}")
}

/// Rotation matrix of `quat_xyzw`, normalised; `None` if invalid.
fn parse_quaternion_rotation(node: Node<'_>, text: &str, report: &mut Report) -> Option<Matrix3<f64>> {
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
