//! Notations of values that SDFormat and its joints in URDF files share.

use crate::reading::limits::QUATERNION_NORM_TOLERANCE;
use crate::reading::report::quoted;
use crate::urdf::elements::numbers::parse_numbers;
use percuss_spatial::{Transform, rotation_from_quaternion, rotation_from_rpy};

/// Boolean value in SDF notation; `None` for another text. An empty text is false.
pub(crate) fn parse_boolean(text: &str) -> Option<bool> {
    match text.trim_ascii() {
        "true" | "True" | "TRUE" | "1" => Some(true),
        "false" | "False" | "FALSE" | "0" | "" => Some(false),
        _ => None,
    }
}

/// Pose from the text of a `<pose>` in m and rad, or degrees: x y z roll pitch yaw (`format` euler_rpy), or x y z and a unit quaternion
/// x y z w (quat_xyzw). An empty text is the identity. The error names the defect.
pub(crate) fn parse_pose(text: &str, format: &str, degrees: bool) -> Result<Transform<f64>, String> {
    match format.trim_ascii() {
        _ if text.trim_ascii().is_empty() => Ok(Transform::identity()),
        "euler_rpy" => {
            let [x, y, z, roll, pitch, yaw] =
                parse_numbers::<6>(text).map_err(|defect| named(text, &defect))?;
            let unit = |angle: f64| if degrees { angle.to_radians() } else { angle };
            Ok(Transform::new(rotation_from_rpy([roll, pitch, yaw].map(unit)), [x, y, z].into()))
        }
        "quat_xyzw" if !degrees => {
            let [x, y, z, a, b, c, w] = parse_numbers::<7>(text).map_err(|defect| named(text, &defect))?;
            let norm = [a, b, c, w].iter().map(|c| c * c).sum::<f64>().sqrt();
            if (norm - 1.0).abs() > QUATERNION_NORM_TOLERANCE || norm.is_nan() {
                return Err(format!("the quaternion x y z w has norm {norm}; a unit quaternion is expected"));
            }
            let rotation = rotation_from_quaternion([w, a, b, c].map(|c| c / norm));
            Ok(Transform::new(rotation, [x, y, z].into()))
        }
        other => Err(format!(
            "rotation_format={}: euler_rpy, or quat_xyzw without degrees, is expected",
            quoted(other)
        )),
    }
}

/// Message of a defect, with the text in quotes first.
fn named(text: &str, defect: &str) -> String {
    format!("{}: {defect}", quoted(text.trim_ascii()))
}
