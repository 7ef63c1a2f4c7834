//! Rotation matrices from axis and angle, quaternions, and roll, pitch and yaw.

use crate::Scalar;
use nalgebra::{Matrix3, Vector3};

/// Rotation by `angle` (rad) about the unit vector `axis`: R = cos θ 1 + sin θ \[a\]× + (1 − cos θ) a aᵀ.
///
/// Source: Featherstone 2008, table 2.2 and eq. 2.56 (Rodrigues' formula).
#[inline]
pub fn rotation_about<T: Scalar>(axis: &Vector3<f64>, angle: T) -> Matrix3<T> {
    let (s, c) = angle.sin_cos();
    let d = T::one() - c;
    let a = axis.map(T::from_f64);
    let (x, y, z) = (a.x, a.y, a.z);
    #[rustfmt::skip]
    let rotation = Matrix3::new(
        d * x * x + c,     d * x * y - s * z, d * x * z + s * y,
        d * x * y + s * z, d * y * y + c,     d * y * z - s * x,
        d * x * z - s * y, d * y * z + s * x, d * z * z + c,
    );
    rotation
}

/// Rotation of the unit quaternion `[w, x, y, z]`. The quaternion is not normalised.
#[inline]
pub fn rotation_from_quaternion<T: Scalar>(q: [T; 4]) -> Matrix3<T> {
    let [w, x, y, z] = q;
    let two = T::one() + T::one();
    let one = T::one();
    #[rustfmt::skip]
    let rotation = Matrix3::new(
        one - two * (y * y + z * z), two * (x * y - w * z),       two * (x * z + w * y),
        two * (x * y + w * z),       one - two * (x * x + z * z), two * (y * z - w * x),
        two * (x * z - w * y),       two * (y * z + w * x),       one - two * (x * x + y * y),
    );
    rotation
}

/// Hamilton product a ∘ b of quaternions `[w, x, y, z]`: first the rotation b, then a.
pub fn quaternion_product<T: Scalar>(a: [T; 4], b: [T; 4]) -> [T; 4] {
    [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]
}

/// Rotation of URDF's `rpy`: R = R_z(yaw) R_y(pitch) R_x(roll), fixed axes, radians.
pub fn rotation_from_rpy(rpy: [f64; 3]) -> Matrix3<f64> {
    let [roll, pitch, yaw] = rpy;
    rotation_about(&Vector3::z(), yaw)
        * rotation_about(&Vector3::y(), pitch)
        * rotation_about(&Vector3::x(), roll)
}

/// Roll, pitch and yaw (rad) of a rotation matrix: the inverse of [`rotation_from_rpy`], also near a pitch of ±90°: roll and pitch
/// are those of Rz(−yaw)·R, so that their rotation is R within a few roundings for any yaw.
pub fn rpy_from_rotation(rotation: &Matrix3<f64>) -> [f64; 3] {
    let r = rotation;
    let yaw = r[(1, 0)].atan2(r[(0, 0)]);
    let (s, c) = yaw.sin_cos();
    let pitch = (-r[(2, 0)]).atan2(c * r[(0, 0)] + s * r[(1, 0)]);
    let roll = (s * r[(0, 2)] - c * r[(1, 2)]).atan2(c * r[(1, 1)] - s * r[(0, 1)]);
    [roll, pitch, yaw]
}

/// Right-handed unit vectors `(e1, e2)` with e1 × e2 = `normal` (a unit vector).
///
/// For a coordinate axis, e1 and e2 are the next two axes in cyclic order: z gives (x, y), x gives (y, z), y
/// gives (z, x). Otherwise e1 is the axis after the largest component of `normal`, projected onto the plane.
pub fn plane_basis(normal: &Vector3<f64>) -> (Vector3<f64>, Vector3<f64>) {
    let next = (normal.iamax() + 1) % 3;
    let mut e1 = Vector3::zeros();
    e1[next] = 1.0;
    e1 -= normal * normal[next];
    e1.normalize_mut();
    (e1, normal.cross(&e1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    // A few roundings of numbers of order one.
    const TOL: f64 = 1e-15 * 8.0;

    #[test]
    fn rpy_round_trips_also_near_the_pole() {
        let near = |distance: f64| std::f64::consts::FRAC_PI_2 - distance;
        let pitches =
            [0.0, 1.2, near(1e-3), near(4e-6), near(3e-7), near(3e-10), near(0.0), -near(4e-6), 3.0];
        for pitch in pitches {
            for (roll, yaw) in [(0.3, -2.0), (-3.0, 1.0), (0.0, 0.0)] {
                let r = rotation_from_rpy([roll, pitch, yaw]);
                let again = rotation_from_rpy(rpy_from_rotation(&r));
                assert!((again - r).amax() < 1e-15, "{pitch} {roll} {yaw}");
            }
        }
    }

    #[test]
    fn quaternion_and_axis_angle_agree() {
        let axis = Vector3::new(1.0, -2.0, 0.5).normalize();
        let (s, c) = (0.35f64).sin_cos();
        let q = [c, s * axis.x, s * axis.y, s * axis.z];
        assert_relative_eq!(rotation_from_quaternion(q), rotation_about(&axis, 0.7), epsilon = TOL);
        let twice = quaternion_product(q, q);
        assert_relative_eq!(rotation_from_quaternion(twice), rotation_about(&axis, 1.4), epsilon = TOL);
    }

    #[test]
    fn plane_basis_is_cyclic_and_right_handed() {
        assert_eq!(plane_basis(&Vector3::z()), (Vector3::x(), Vector3::y()));
        assert_eq!(plane_basis(&Vector3::x()), (Vector3::y(), Vector3::z()));
        let n = Vector3::new(0.2, -0.9, 0.4).normalize();
        let (e1, e2) = plane_basis(&n);
        assert_relative_eq!(e1.cross(&e2), n, epsilon = TOL);
        assert_relative_eq!(e1.dot(&n), 0.0, epsilon = TOL);
    }
}
