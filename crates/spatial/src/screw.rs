//! Twists (rigid-body velocities) and wrenches (forces): two types, so that adding a twist to a wrench does not
//! compile.

use crate::Scalar;
use nalgebra::Vector3;
use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

macro_rules! screw {
    ($(#[$doc:meta])* $name:ident { $(#[$adoc:meta])* $angular:ident, $(#[$ldoc:meta])* $linear:ident }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<T: Scalar> {
            $(#[$adoc])*
            pub $angular: Vector3<T>,
            $(#[$ldoc])*
            pub $linear: Vector3<T>,
        }

        impl<T: Scalar> $name<T> {
            /// Creates the value from its angular and linear part, in this order.
            #[inline]
            pub fn new($angular: Vector3<T>, $linear: Vector3<T>) -> Self {
                Self { $angular, $linear }
            }

            /// All components zero.
            #[inline]
            pub fn zero() -> Self {
                Self { $angular: Vector3::zeros(), $linear: Vector3::zeros() }
            }
        }

        impl<T: Scalar> Add for $name<T> {
            type Output = Self;
            #[inline]
            fn add(self, other: Self) -> Self {
                Self { $angular: self.$angular + other.$angular, $linear: self.$linear + other.$linear }
            }
        }

        impl<T: Scalar> Sub for $name<T> {
            type Output = Self;
            #[inline]
            fn sub(self, other: Self) -> Self {
                Self { $angular: self.$angular - other.$angular, $linear: self.$linear - other.$linear }
            }
        }

        impl<T: Scalar> Neg for $name<T> {
            type Output = Self;
            #[inline]
            fn neg(self) -> Self {
                Self { $angular: -self.$angular, $linear: -self.$linear }
            }
        }

        impl<T: Scalar> Mul<T> for $name<T> {
            type Output = Self;
            #[inline]
            fn mul(self, factor: T) -> Self {
                Self { $angular: self.$angular * factor, $linear: self.$linear * factor }
            }
        }

        impl<T: Scalar> AddAssign for $name<T> {
            #[inline]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl<T: Scalar> SubAssign for $name<T> {
            #[inline]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }
    };
}

screw! {
    /// Velocity of a rigid body: angular velocity (rad/s), and velocity (m/s) of the body point at the origin
    /// of the frame.
    ///
    /// A twist and a wrench do not add:
    /// ```compile_fail
    /// use percuss_spatial::{Twist, Wrench};
    /// let _ = Twist::<f64>::zero() + Wrench::<f64>::zero();
    /// ```
    Twist {
        /// Angular velocity, rad/s.
        angular,
        /// Velocity of the point at the origin, m/s.
        linear
    }
}

screw! {
    /// Force on a rigid body, or momentum of a rigid body: moment about the origin of the frame (N·m) and force (N).
    Wrench {
        /// Moment about the origin, N·m (momentum: N·m·s).
        moment,
        /// Force, N (momentum: N·s).
        force
    }
}

impl<T: Scalar> Twist<T> {
    /// Velocity of the body point at `p`: v + ω × p.
    #[inline]
    pub fn velocity_at(&self, p: &Vector3<T>) -> Vector3<T> {
        self.linear + self.angular.cross(p)
    }

    /// Rate of change of the motion vector `m` fixed in a body with this twist: (ω×m_ω, ω×m_v + v×m_ω).
    ///
    /// Featherstone 2008, eq. 2.31 (`crm`).
    #[inline]
    pub fn cross_motion(&self, m: &Twist<T>) -> Twist<T> {
        Twist::new(
            self.angular.cross(&m.angular),
            self.angular.cross(&m.linear) + self.linear.cross(&m.angular),
        )
    }

    /// Rate of change of the force vector `f` fixed in a body with this twist: (ω×f_n + v×f_f, ω×f_f).
    ///
    /// Featherstone 2008, eq. 2.32 (`crf`).
    #[inline]
    pub fn cross_force(&self, f: &Wrench<T>) -> Wrench<T> {
        Wrench::new(self.angular.cross(&f.moment) + self.linear.cross(&f.force), self.angular.cross(&f.force))
    }
}

impl<T: Scalar> Wrench<T> {
    /// Wrench of a force `f` at the point `p`: (p × f, f).
    #[inline]
    pub fn of_force(f: Vector3<T>, p: &Vector3<T>) -> Self {
        Self::new(p.cross(&f), f)
    }

    /// Power of the wrench on a twist in the same frame: n·ω + f·v, W.
    #[inline]
    pub fn power(&self, twist: &Twist<T>) -> T {
        self.moment.dot(&twist.angular) + self.force.dot(&twist.linear)
    }
}
