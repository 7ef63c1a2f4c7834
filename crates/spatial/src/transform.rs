//! Rigid transforms of points, twists, wrenches and inertias.

use crate::{Scalar, SpatialInertia, Twist, Wrench};
use nalgebra::{Matrix3, Vector3};
use std::ops::Mul;

/// Transform `X_ab` from b-coordinates to a-coordinates: x_a = R_ab x_b + p_ab.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform<T: Scalar> {
    /// R_ab; the columns are the axes of b in a.
    pub rotation: Matrix3<T>,
    /// p_ab: origin of b in a, m.
    pub translation: Vector3<T>,
}

impl<T: Scalar> Transform<T> {
    /// Creates the transform from a rotation matrix (assumed orthonormal) and a translation in m.
    #[inline]
    pub fn new(rotation: Matrix3<T>, translation: Vector3<T>) -> Self {
        Self { rotation, translation }
    }

    /// Identity transform.
    #[inline]
    pub fn identity() -> Self {
        Self::new(Matrix3::identity(), Vector3::zeros())
    }

    /// Translation: parallel axes, origin of b at `translation` in a.
    #[inline]
    pub fn from_translation(translation: Vector3<T>) -> Self {
        Self::new(Matrix3::identity(), translation)
    }

    /// Inverse transform `X_ba`.
    #[inline]
    pub fn inverse(&self) -> Self {
        let rotation = self.rotation.transpose();
        Self::new(rotation, -(rotation * self.translation))
    }

    /// Coordinates in a of the point `p` given in b.
    #[inline]
    pub fn point(&self, p: &Vector3<T>) -> Vector3<T> {
        self.rotation * p + self.translation
    }

    /// Components in a of the free vector `v` given in b.
    #[inline]
    pub fn vector(&self, v: &Vector3<T>) -> Vector3<T> {
        self.rotation * v
    }

    /// Components in b of the free vector `v` given in a.
    #[inline]
    pub fn inverse_vector(&self, v: &Vector3<T>) -> Vector3<T> {
        self.rotation.tr_mul(v)
    }

    /// Coordinates in b of the point `p` given in a.
    #[inline]
    pub fn inverse_point(&self, p: &Vector3<T>) -> Vector3<T> {
        self.rotation.tr_mul(&(p - self.translation))
    }

    /// Transforms a twist from b to a: ω_a = R ω_b, v_a = R v_b + p × ω_a.
    #[inline]
    pub fn twist(&self, v: &Twist<T>) -> Twist<T> {
        let angular = self.rotation * v.angular;
        Twist::new(angular, self.rotation * v.linear + self.translation.cross(&angular))
    }

    /// Transforms a twist from a to b.
    #[inline]
    pub fn inverse_twist(&self, v: &Twist<T>) -> Twist<T> {
        Twist::new(
            self.rotation.tr_mul(&v.angular),
            self.rotation.tr_mul(&(v.linear - self.translation.cross(&v.angular))),
        )
    }

    /// Transforms a wrench from b to a: f_a = R f_b, n_a = R n_b + p × f_a.
    #[inline]
    pub fn wrench(&self, f: &Wrench<T>) -> Wrench<T> {
        let force = self.rotation * f.force;
        Wrench::new(self.rotation * f.moment + self.translation.cross(&force), force)
    }

    /// Transforms an inertia from b to a: first moment R h + m p, rotational inertia by the parallel-axis theorem.
    ///
    /// I_a = R I_b Rᵀ − \[p\]×\[Rh + m p\]× − \[Rh\]×\[p\]×. Featherstone 2008, §2.13.
    #[inline]
    pub fn inertia(&self, body: &SpatialInertia<T>) -> SpatialInertia<T> {
        let p = &self.translation;
        let h = self.rotation * body.first_moment;
        let shifted = h + p * body.mass;
        let rotated = self.rotation * body.rotational * self.rotation.transpose();
        // −[a]×[b]× = (a·b) 1 − b aᵀ
        let spread = p.dot(&shifted) + h.dot(p);
        let shift = Matrix3::from_diagonal_element(spread) - shifted * p.transpose() - p * h.transpose();
        SpatialInertia { mass: body.mass, first_moment: shifted, rotational: rotated + shift }
    }
}

impl Transform<f64> {
    /// Converts the transform to another scalar type.
    #[inline]
    pub fn cast<T: Scalar>(&self) -> Transform<T> {
        Transform::new(self.rotation.map(T::from_f64), self.translation.map(T::from_f64))
    }
}

/// `X_ab * X_bc = X_ac`.
impl<T: Scalar> Mul for Transform<T> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::new(self.rotation * other.rotation, self.rotation * other.translation + self.translation)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rotation_from_rpy;
    use approx::assert_relative_eq;

    const TOL: f64 = 1e-14; // a few roundings of numbers of order one to ten

    fn x_ab() -> Transform<f64> {
        Transform::new(rotation_from_rpy([0.3, -1.1, 2.0]), Vector3::new(0.4, -0.7, 1.3))
    }

    #[test]
    fn inverse_undoes() {
        let x = x_ab() * x_ab().inverse();
        assert_relative_eq!(x.rotation, Matrix3::identity(), epsilon = TOL);
        assert_relative_eq!(x.translation, Vector3::zeros(), epsilon = TOL);
        let v = Twist::new(Vector3::new(1.0, 2.0, 3.0), Vector3::new(-1.0, 0.5, 0.2));
        let back = x_ab().inverse_twist(&x_ab().twist(&v));
        assert_relative_eq!(back.linear, v.linear, epsilon = TOL);
    }

    #[test]
    fn power_and_energy_do_not_depend_on_the_frame() {
        let v = Twist::new(Vector3::new(0.1, -0.4, 0.9), Vector3::new(2.0, 0.3, -0.8));
        let f = Wrench::new(Vector3::new(-0.5, 1.0, 0.2), Vector3::new(3.0, -1.0, 0.7));
        let body = SpatialInertia::about_com(
            2.3,
            Vector3::new(0.1, 0.2, -0.3),
            Matrix3::from_diagonal(&Vector3::new(0.2, 0.3, 0.4)),
        );
        let x = x_ab();
        assert_relative_eq!(x.wrench(&f).power(&x.twist(&v)), f.power(&v), epsilon = TOL);
        let there = x.inertia(&body);
        assert_relative_eq!(there.twice_energy(&x.twist(&v)), body.twice_energy(&v), epsilon = TOL);
    }
}
