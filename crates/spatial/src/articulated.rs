//! Articulated-body inertia: apparent inertia of a subtree, whose joints are free to move, at its root body.

use crate::{Scalar, SpatialInertia, Twist, Wrench};
use nalgebra::{Matrix3, Vector3};
use std::ops::AddAssign;

/// Symmetric 6×6 map from twist to wrench, in blocks: moment = A ω + C v, force = Cᵀ ω + L v.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArticulatedInertia<T: Scalar> {
    /// A: moment per angular acceleration, kg·m².
    pub angular: Matrix3<T>,
    /// C: moment per linear acceleration, kg·m.
    pub coupling: Matrix3<T>,
    /// L: force per linear acceleration, kg; in general no multiple of the identity.
    pub linear: Matrix3<T>,
}

impl<T: Scalar> ArticulatedInertia<T> {
    /// The zero map.
    #[inline]
    pub fn zero() -> Self {
        Self { angular: Matrix3::zeros(), coupling: Matrix3::zeros(), linear: Matrix3::zeros() }
    }

    /// Wrench I v of the twist or acceleration `v`.
    #[inline]
    pub fn apply(&self, v: &Twist<T>) -> Wrench<T> {
        Wrench::new(
            self.angular * v.angular + self.coupling * v.linear,
            self.coupling.tr_mul(&v.angular) + self.linear * v.linear,
        )
    }

    /// Subtracts the dyad a bᵀ of two parallel wrenches (U D⁻¹ and U). The result is symmetric to the last bit:
    /// no later elimination would remove an asymmetry left by rounding.
    #[inline]
    pub fn subtract_dyad(&mut self, a: &Wrench<T>, b: &Wrench<T>) {
        for i in 0..3 {
            for k in i..3 {
                self.angular[(i, k)] -= a.moment[i] * b.moment[k];
                self.linear[(i, k)] -= a.force[i] * b.force[k];
            }
        }
        self.coupling -= a.moment * b.force.transpose();
        mirror(&mut self.angular);
        mirror(&mut self.linear);
    }
}

/// Copies the upper triangle to the lower one.
#[inline]
fn mirror<T: Scalar>(m: &mut Matrix3<T>) {
    (m[(1, 0)], m[(2, 0)], m[(2, 1)]) = (m[(0, 1)], m[(0, 2)], m[(1, 2)]);
}

impl<T: Scalar> From<&SpatialInertia<T>> for ArticulatedInertia<T> {
    #[inline]
    fn from(body: &SpatialInertia<T>) -> Self {
        let mut angular = body.rotational;
        mirror(&mut angular);
        Self {
            angular,
            coupling: cross_matrix(&body.first_moment),
            linear: Matrix3::from_diagonal_element(body.mass),
        }
    }
}

impl<T: Scalar> AddAssign<&ArticulatedInertia<T>> for ArticulatedInertia<T> {
    #[inline]
    fn add_assign(&mut self, other: &Self) {
        self.angular += other.angular;
        self.coupling += other.coupling;
        self.linear += other.linear;
    }
}

/// \[a\]×, so that \[a\]× b = a × b.
#[inline]
fn cross_matrix<T: Scalar>(a: &Vector3<T>) -> Matrix3<T> {
    let o = T::zero();
    Matrix3::new(o, -a.z, a.y, a.z, o, -a.x, -a.y, a.x, o)
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn of_a_rigid_body_it_is_the_momentum_map() {
        let body = SpatialInertia::about_com(
            1.7,
            Vector3::new(0.2, -0.4, 0.1),
            Matrix3::from_diagonal(&Vector3::new(0.1, 0.2, 0.15)),
        );
        let v = Twist::new(Vector3::new(0.3, 0.8, -0.2), Vector3::new(-1.0, 0.4, 0.6));
        let (a, b) = (ArticulatedInertia::from(&body).apply(&v), body.momentum(&v));
        assert_relative_eq!(a.moment, b.moment, epsilon = 1e-15);
        assert_relative_eq!(a.force, b.force, epsilon = 1e-15);
    }
}
