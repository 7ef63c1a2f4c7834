//! The axes in which a file states its inertias, built from hardpoints as Chrono builds them.
//!
//! A frame is a rotation R whose columns are its axes in the vehicle's; I = R I′ Rᵀ. All are right-handed. None where
//! the points do not span it.

use crate::limits::PARALLEL;
use percuss_spatial::{Matrix3, Vector3};

/// The unit vector; none where there is no direction.
pub(super) fn unit(v: Vector3<f64>) -> Option<Vector3<f64>> {
    let length = v.norm();
    (length > 0.0 && length.is_finite()).then(|| v / length)
}

/// a × b of unit length; none where they are parallel or zero.
pub(super) fn normal(a: Vector3<f64>, b: Vector3<f64>) -> Option<Vector3<f64>> {
    let (a, b) = (unit(a)?, unit(b)?);
    let cross = a.cross(&b);
    if cross.norm() > PARALLEL { unit(cross) } else { None }
}

/// An arm on a hinge: x along the hinge from back to front, z = (back − ball) × (front − ball), the normal of its
/// plane, y = z × x.
pub(super) fn arm(front: Vector3<f64>, back: Vector3<f64>, ball: Vector3<f64>) -> Option<Matrix3<f64>> {
    let x = unit(front - back)?;
    let z = normal(back - ball, front - ball)?;
    Some(Matrix3::from_columns(&[x, z.cross(&x), z]))
}

/// A link with x along it: y = ẑ × x with the vehicle's ẑ, z = x × y.
pub(super) fn along_x(along: Vector3<f64>) -> Option<Matrix3<f64>> {
    let x = unit(along)?;
    let y = normal(Vector3::z(), x)?;
    Some(Matrix3::from_columns(&[x, y, x.cross(&y)]))
}

/// A link with z along it and y along a normal to it: x = y × z.
pub(super) fn along_z(along: Vector3<f64>, y: Vector3<f64>) -> Option<Matrix3<f64>> {
    let (y, z) = (unit(y)?, unit(along)?);
    Some(Matrix3::from_columns(&[y.cross(&z), y, z]))
}

/// The inertia stated in the frame, in the vehicle's axes; symmetric to the last bit.
pub(super) fn turned(frame: &Matrix3<f64>, inertia: &Matrix3<f64>) -> Matrix3<f64> {
    let turned = frame * inertia * frame.transpose();
    (turned + turned.transpose()) * 0.5
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
        let Some(arm) = arm(front, back, ball) else { panic!("a plane arm") };
        assert!(is_rotation(&arm) && (arm - Matrix3::identity()).amax() < 1e-15);
        let Some(rod) = along_x(Vector3::new(0.7, 0.1, 0.2)) else { panic!("a rod") };
        // y level, z upward.
        assert!(is_rotation(&rod) && rod[(2, 1)].abs() < 1e-15 && rod[(2, 2)] > 0.0);
        let Some(rod) = along_z(Vector3::y(), Vector3::new(0.0, 0.0, -2.0)) else { panic!("a rod") };
        assert!(is_rotation(&rod) && rod[(0, 0)] == 1.0);
    }

    #[test]
    fn points_on_one_line_span_no_frame() {
        let on_x = [0.0, 1.0, 3.0].map(|x| Vector3::new(x, 0.1, 0.2));
        assert_eq!(arm(on_x[0], on_x[1], on_x[2]), None);
        assert_eq!(arm(on_x[0], on_x[0], on_x[2]), None);
        assert_eq!(along_x(Vector3::z()), None);
        assert_eq!(unit(Vector3::zeros()), None);
    }

    #[test]
    fn the_sense_of_two_axes_does_not_matter_to_principal_moments() {
        let moments = Matrix3::from_diagonal(&Vector3::new(0.1, 0.2, 0.25));
        let Some(frame) = along_x(Vector3::new(1.0, 2.0, 3.0)) else { panic!("a rod") };
        let flipped = frame * Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, -1.0));
        assert!((turned(&frame, &moments) - turned(&flipped, &moments)).amax() < 1e-16);
    }
}
