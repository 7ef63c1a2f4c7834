//! The ten inertia parameters of a rigid body.

use crate::{Scalar, Twist, Wrench};
use nalgebra::{Matrix3, Vector3};
use std::ops::{Add, AddAssign};

/// Inertia of a rigid body about the origin of its frame: the ten parameters, which the kinetic energy depends
/// on linearly.
///
/// 2T = ω·I ω + 2 v·(ω × h) + m v·v, with h = m c.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpatialInertia<T: Scalar> {
    /// Mass m, kg.
    pub mass: T,
    /// First moment of mass h = m c, kg·m.
    pub first_moment: Vector3<T>,
    /// Rotational inertia about the origin (not about the centre of mass), kg·m².
    pub rotational: Matrix3<T>,
}

impl<T: Scalar> SpatialInertia<T> {
    /// Zero inertia.
    #[inline]
    pub fn zero() -> Self {
        Self { mass: T::zero(), first_moment: Vector3::zeros(), rotational: Matrix3::zeros() }
    }

    /// Inertia from the mass (kg), the centre of mass (m) and the rotational inertia about the centre of mass
    /// (kg·m²), all in the axes of the frame.
    pub fn about_com(mass: T, com: Vector3<T>, rotational_about_com: Matrix3<T>) -> Self {
        let (xx, yy, zz) = (com.x * com.x, com.y * com.y, com.z * com.z);
        // The form |c|² 1 − c cᵀ would cancel large terms on the diagonal.
        let steiner = Matrix3::from_diagonal(&Vector3::new(yy + zz, zz + xx, xx + yy))
            + (Matrix3::from_diagonal(&Vector3::new(xx, yy, zz)) - com * com.transpose());
        Self { mass, first_moment: com * mass, rotational: rotational_about_com + steiner * mass }
    }

    /// Inertia from the mass (kg), the first moment m c (kg·m) and the rotational inertia about the origin (kg·m²).
    pub fn about_origin(mass: T, first_moment: Vector3<T>, rotational_about_origin: Matrix3<T>) -> Self {
        Self { mass, first_moment, rotational: rotational_about_origin }
    }

    /// Inertia of a point mass (kg) at `p` (m).
    pub fn point_mass(mass: T, p: Vector3<T>) -> Self {
        Self::about_com(mass, p, Matrix3::zeros())
    }

    /// Momentum at the twist `v` (same frame): (I ω + h × v, m v − h × ω).
    #[inline]
    pub fn momentum(&self, v: &Twist<T>) -> Wrench<T> {
        let h = &self.first_moment;
        Wrench::new(
            self.rotational * v.angular + h.cross(&v.linear),
            v.linear * self.mass - h.cross(&v.angular),
        )
    }

    /// Twice the kinetic energy at the twist `v` (same frame), J.
    #[inline]
    pub fn twice_energy(&self, v: &Twist<T>) -> T {
        self.momentum(v).power(v)
    }
}

impl SpatialInertia<f64> {
    /// Converts the inertia to another scalar type.
    #[inline]
    pub fn cast<T: Scalar>(&self) -> SpatialInertia<T> {
        SpatialInertia {
            mass: T::from_f64(self.mass),
            first_moment: self.first_moment.map(T::from_f64),
            rotational: self.rotational.map(T::from_f64),
        }
    }
}

impl<T: Scalar> Add for SpatialInertia<T> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self {
            mass: self.mass + other.mass,
            first_moment: self.first_moment + other.first_moment,
            rotational: self.rotational + other.rotational,
        }
    }
}

impl<T: Scalar> AddAssign for SpatialInertia<T> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn about_com_is_about_origin_shifted() {
        let c = Vector3::new(0.3, -0.1, 0.7);
        let i_c = Matrix3::new(0.5, 0.01, 0.0, 0.01, 0.6, 0.02, 0.0, 0.02, 0.4);
        let body = SpatialInertia::about_com(2.0, c, i_c);
        // For a rotation about an axis through the centre of mass only I_c counts.
        let omega = Vector3::new(1.0, 2.0, -0.5);
        let spin = Twist::new(omega, -omega.cross(&c));
        assert_relative_eq!(body.twice_energy(&spin), omega.dot(&(i_c * omega)), epsilon = 1e-14);
        // Parallel-axis theorem: I_zz = I_c,zz + m (x² + y²).
        assert_relative_eq!(body.rotational[(2, 2)], 0.4 + 2.0 * (0.09 + 0.01), epsilon = 1e-15);
    }
}
