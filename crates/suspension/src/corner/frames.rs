//! Axes of the inertias in a file, constructed from hardpoints as in Chrono.
//!
//! A frame is a rotation matrix R, whose columns are the axes of the frame in vehicle coordinates; I = R I′ Rᵀ. All
//! frames are right-handed. The result is `None` if the points do not determine the frame.

use crate::limits::MAX_PARALLEL_SINE;
use percuss_spatial::{Matrix3, Vector3};

/// Normalises a vector; `None` if it is zero or not finite.
pub(crate) fn unit(v: Vector3<f64>) -> Option<Vector3<f64>> {
    let length = v.norm();
    (length > 0.0 && length.is_finite()).then(|| v / length)
}

/// Unit vector along a × b; `None` for parallel or zero vectors.
pub(crate) fn normal(a: Vector3<f64>, b: Vector3<f64>) -> Option<Vector3<f64>> {
    let (a, b) = (unit(a)?, unit(b)?);
    let cross = a.cross(&b);
    if cross.norm() > MAX_PARALLEL_SINE { unit(cross) } else { None }
}

/// Frame of an arm on a hinge: x along the hinge from back to front; z along (back − ball) × (front − ball), the
/// normal of the arm's plane; y = z × x.
pub(crate) fn arm_axes(front: Vector3<f64>, back: Vector3<f64>, ball: Vector3<f64>) -> Option<Matrix3<f64>> {
    let x = unit(front - back)?;
    let z = normal(back - ball, front - ball)?;
    Some(Matrix3::from_columns(&[x, z.cross(&x), z]))
}

/// Frame of a link along x: y = ẑ × x with the vehicle's ẑ; z = x × y.
pub(crate) fn along_x(along: Vector3<f64>) -> Option<Matrix3<f64>> {
    let x = unit(along)?;
    let y = normal(Vector3::z(), x)?;
    Some(Matrix3::from_columns(&[x, y, x.cross(&y)]))
}

/// Frame of a link along z with y along a given normal: x = y × z.
pub(crate) fn along_z(along: Vector3<f64>, y: Vector3<f64>) -> Option<Matrix3<f64>> {
    let (y, z) = (unit(y)?, unit(along)?);
    Some(Matrix3::from_columns(&[y.cross(&z), y, z]))
}

/// Inertia in the vehicle's axes, from the inertia in `frame`; exactly symmetric.
pub(crate) fn rotate_inertia(frame: &Matrix3<f64>, inertia: &Matrix3<f64>) -> Matrix3<f64> {
    let rotated = frame * inertia * frame.transpose();
    (rotated + rotated.transpose()) * 0.5
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_rotation(frame: &Matrix3<f64>) -> bool {
        (frame.transpose() * frame - Matrix3::identity()).amax() < 1e-14 && frame.determinant() > 0.0
    }

    #[test]
    fn frames_are_right_handed_and_their_axes_where_they_are_said_to_be() {
        let [front, back, ball] = [[0.2, 0.3, 0.0], [-0.2, 0.3, 0.0], [0.0, 0.8, 0.0]].map(Vector3::from);
        let Some(arm) = arm_axes(front, back, ball) else { panic!("a plane arm") };
        assert!(is_rotation(&arm) && (arm - Matrix3::identity()).amax() < 1e-15);
        let Some(rod) = along_x(Vector3::new(0.7, 0.1, 0.2)) else { panic!("a rod") };
        // y is horizontal, z points upward.
        assert!(is_rotation(&rod) && rod[(2, 1)].abs() < 1e-15 && rod[(2, 2)] > 0.0);
        let Some(rod) = along_z(Vector3::y(), Vector3::new(0.0, 0.0, -2.0)) else { panic!("a rod") };
        assert!(is_rotation(&rod) && rod[(0, 0)] == 1.0);
    }

    #[test]
    fn points_on_one_line_span_no_frame() {
        let on_x = [0.0, 1.0, 3.0].map(|x| Vector3::new(x, 0.1, 0.2));
        assert_eq!(arm_axes(on_x[0], on_x[1], on_x[2]), None);
        assert_eq!(arm_axes(on_x[0], on_x[0], on_x[2]), None);
        assert_eq!(along_x(Vector3::z()), None);
        assert_eq!(unit(Vector3::zeros()), None);
    }

    #[test]
    fn the_sense_of_two_axes_does_not_matter_to_principal_moments() {
        let moments = Matrix3::from_diagonal(&Vector3::new(0.1, 0.2, 0.25));
        let Some(frame) = along_x(Vector3::new(1.0, 2.0, 3.0)) else { panic!("a rod") };
        let flipped = frame * Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, -1.0));
        assert!((rotate_inertia(&frame, &moments) - rotate_inertia(&flipped, &moments)).amax() < 1e-16);
    }
}
