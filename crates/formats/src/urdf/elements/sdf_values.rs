//! Notations of values that SDFormat and its joints in URDF files share.

use crate::reading::limits::QUATERNION_NORM_TOLERANCE;
use crate::reading::report::quoted;
use crate::urdf::elements::numbers::parse_numbers;
use percuss_spatial::{Transform, rotation_from_quaternion, rotation_from_rpy};
use std::f64::consts::TAU;

/// Boolean value in SDF notation; `None` for another text. An empty text is false.
pub(crate) fn parse_boolean(text: &str) -> Option<bool> {
    match text.trim_ascii() {
        "true" | "True" | "TRUE" | "1" => Some(true),
        "false" | "False" | "FALSE" | "0" | "" => Some(false),
        _ => None,
    }
}

/// Advance of a screw, m/rad, from `<screw_thread_pitch>`, right-handed metres per turn, or the older `<thread_pitch>`, left-handed
/// radians per metre. The error names the defect.
pub(crate) fn screw_advance(
    screw_thread_pitch: Option<f64>,
    thread_pitch: Option<f64>,
) -> Result<f64, (&'static str, &'static str)> {
    match (screw_thread_pitch, thread_pitch) {
        (Some(pitch), _) => Ok(pitch / TAU),
        (None, Some(pitch)) if pitch != 0.0 => Ok(-1.0 / pitch),
        (None, Some(_)) => Err((
            "bad-number",
            "<thread_pitch> is 0 rad/m; give <screw_thread_pitch>, the advance in m per turn",
        )),
        (None, None) => Err((
            "missing-element",
            "the screw has neither <screw_thread_pitch> (m per turn) nor <thread_pitch> (rad/m, \
             left-handed), and versions of \
             libsdformat have different defaults; give one of them",
        )),
    }
}

/// Message about the meaning of a gearbox.
pub(crate) const GEARBOX: &str = "a gearbox is read by SDFormat's definition, θ₂ = −ratio·θ₁ relative to the reference \
    body; simulators \
    differ (Gazebo Classic takes absolute rates, gz-physics welds the links)";

/// Largest |1 − |cosine|| of the angle between an axis of a gearbox or screw and that of its joint, dimensionless: files have four decimals
/// or more.
pub(crate) const PARALLEL_AXES: f64 = 1e-6;

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
