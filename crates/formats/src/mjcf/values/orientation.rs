//! Poses and the five notations of an orientation.

use crate::mjcf::values::attributes::Attributes;
use crate::mjcf::values::settings::Settings;
use crate::reading::findings::Findings;
use crate::urdf::elements::origin::{
    degrees_in_place_of_radians, large_angle_message, rotation_from_any_quaternion,
};
use percuss_spatial::{Matrix3, Transform, Vector3, rotation_about};

/// Notations of an orientation.
const NOTATIONS: [&str; 5] = ["quat", "axisangle", "xyaxes", "zaxis", "euler"];

/// Pose of an element in its parent: `pos` and an orientation.
pub(crate) fn read_pose(
    attributes: Attributes<'_>,
    settings: &Settings,
    findings: &mut Findings<'_>,
) -> Transform<f64> {
    let translation = attributes.numbers::<3>("pos", findings).unwrap_or_default();
    let rotation = read_orientation(attributes, settings, findings).unwrap_or_else(Matrix3::identity);
    Transform::new(rotation, translation.into())
}

/// Orientation of an element; `None` if absent, or, with an error, if invalid.
pub(crate) fn read_orientation(
    attributes: Attributes<'_>,
    settings: &Settings,
    findings: &mut Findings<'_>,
) -> Option<Matrix3<f64>> {
    let source = attributes.source(&NOTATIONS)?;
    let own = Attributes::new(attributes.tree, source);
    let mut given = NOTATIONS.into_iter().filter(|name| attributes.tree.attribute(source, name).is_some());
    let notation = given.next()?;
    if let Some(second) = given.next() {
        findings.attribute_error("two-orientations", source, second, || {
            format!("both {notation} and {second} are given; one orientation is expected")
        });
        return None;
    }
    let rotation = match notation {
        "quat" => own.numbers::<4>("quat", findings).map(rotation_from_quat),
        "axisangle" => own.numbers::<4>("axisangle", findings).map(|[x, y, z, angle]| {
            Some(rotation_about(&unit(Vector3::new(x, y, z))?, angle * settings.angle_unit))
        }),
        "xyaxes" => own.numbers::<6>("xyaxes", findings).map(rotation_from_axes),
        "zaxis" => own.numbers::<3>("zaxis", findings).map(|z| rotation_to_z(z.into())),
        _ => own.numbers::<3>("euler", findings).map(|angles| Some(rotation_from_euler(angles, settings))),
    }?;
    let angles =
        own.numbers::<3>("euler", findings).filter(|_| notation == "euler" && settings.angle_unit == 1.0);
    if let Some(angle) = angles.and_then(|angles| degrees_in_place_of_radians(&angles)) {
        findings.warning("large-angle", source, || {
            large_angle_message(angle) + ", or angle=\"degree\" in <compiler>"
        });
    }
    if rotation.is_none() {
        findings.attribute_error("zero-axis", source, notation, || {
            format!("{notation} gives no direction: it is zero, or its axes are parallel")
        });
    }
    rotation
}

/// Rotation of a quaternion w, x, y, z of any length; `None` if it is zero.
pub(crate) fn rotation_from_quat([w, x, y, z]: [f64; 4]) -> Option<Matrix3<f64>> {
    rotation_from_any_quaternion([x, y, z, w]).map(|(rotation, _)| rotation)
}

/// Rotation of Euler angles in the units of the file: factors of axes of the parent frame are multiplied from the left.
pub(crate) fn rotation_from_euler(angles: [f64; 3], settings: &Settings) -> Matrix3<f64> {
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let mut rotation = Matrix3::identity();
    for (angle, (axis, is_fixed)) in angles.into_iter().zip(settings.euler_sequence) {
        let factor = rotation_about(&axes[axis], angle * settings.angle_unit);
        rotation = if is_fixed { factor * rotation } else { rotation * factor };
    }
    rotation
}

/// Vector of length 1; `None` for a zero vector. Scaling first avoids overflow of the squares.
pub(crate) fn unit(vector: Vector3<f64>) -> Option<Vector3<f64>> {
    let scale = vector.amax();
    (scale >= f64::MIN_POSITIVE).then(|| (vector / scale).normalize())
}

/// Rotation with the given x-axis; the y-axis is made orthogonal to it.
fn rotation_from_axes([a, b, c, d, e, f]: [f64; 6]) -> Option<Matrix3<f64>> {
    let x = unit(Vector3::new(a, b, c))?;
    let given = unit(Vector3::new(d, e, f))?;
    let y = given - x * x.dot(&given);
    // Below this length the direction of y is a rounding error.
    let y = unit(y).filter(|_| y.norm() > 1e-8)?;
    Some(Matrix3::from_columns(&[x, y, x.cross(&y)]))
}

/// Smallest rotation that turns the z-axis to a direction.
pub(crate) fn rotation_to_z(direction: Vector3<f64>) -> Option<Matrix3<f64>> {
    let to = unit(direction)?;
    let axis = Vector3::z().cross(&to);
    let sine = axis.norm();
    let angle = sine.atan2(to.z);
    Some(match unit(axis).filter(|_| sine > 0.0) {
        Some(axis) => rotation_about(&axis, angle),
        None if to.z > 0.0 => Matrix3::identity(),
        // Half a turn about x, as in MuJoCo.
        None => rotation_about(&Vector3::x(), std::f64::consts::PI),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn lower_case_angles_turn_with_the_frame() {
        // Quaternion (0.5, 0.5, 0.5, 0.5), as MuJoCo 4.0 gives for "90 90 0".
        let rotation = rotation_from_euler([90.0, 90.0, 0.0], &Settings::default());
        let expected = rotation_from_quat([0.5; 4]).unwrap();
        assert_relative_eq!(rotation, expected, epsilon = 1e-15);
        let fixed = Settings { euler_sequence: [(0, true), (1, true), (2, true)], ..Settings::default() };
        let expected = rotation_from_quat([0.5, 0.5, 0.5, -0.5]).unwrap();
        assert_relative_eq!(rotation_from_euler([90.0, 90.0, 0.0], &fixed), expected, epsilon = 1e-15);
    }

    #[test]
    fn the_z_axis_is_turned_by_the_shortest_way() {
        for direction in [[0.0, 0.0, 1.0], [0.0, 0.0, -2.0], [1.0, 1.0, 0.2], [1e-9, 0.0, -1.0]] {
            let direction = Vector3::from(direction);
            let rotation = rotation_to_z(direction).unwrap();
            assert_relative_eq!(rotation * Vector3::z(), direction.normalize(), epsilon = 1e-14);
        }
    }
}
