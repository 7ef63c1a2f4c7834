//! Wrench in arrays, with the same transforms as the packed inertia.

use super::vector::{after, rotated, splat, turn_vector};
use crate::Scalar;
use crate::lanes::Lanes;

/// Wrench in arrays: moment about the origin of the frame (N·m) and force (N).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PackedWrench<T> {
    /// Moment, N·m.
    pub moment: [T; 3],
    /// Force, N.
    pub force: [T; 3],
}

impl PackedWrench<f64> {
    /// Converts the wrench to lanes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn cast<T: Scalar>(&self) -> PackedWrench<T> {
        PackedWrench { moment: splat(&self.moment), force: splat(&self.force) }
    }
}

impl<T: Lanes> PackedWrench<T> {
    /// Zero wrench.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn zero() -> Self {
        Self { moment: [T::zero(); 3], force: [T::zero(); 3] }
    }

    /// Transforms to a frame in which the present frame is rotated about axis `Z`, with cosine `c` and sine `s`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn turn<const Z: usize>(&mut self, c: T, s: T) {
        turn_vector::<T, Z>(&mut self.moment, c, s);
        turn_vector::<T, Z>(&mut self.force, c, s);
    }

    /// A [`turn`](Self::turn) by +90° about axis `Z`, without multiplications.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn turn_right<const Z: usize>(&mut self) {
        let (x, y) = after(Z);
        let (m, f) = (&mut self.moment, &mut self.force);
        (m[x], m[y]) = (-m[y], m[x]);
        (f[x], f[y]) = (-f[y], f[x]);
    }

    /// Transforms to a frame in which the present frame is rotated by R, given by rows.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn rotate(&mut self, r: &[[T; 3]; 3]) {
        self.moment = rotated(&self.moment, r);
        self.force = rotated(&self.force, r);
    }

    /// Transforms to a frame with parallel axes, in which the present origin is at `d` (m) on axis `Z`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn shift<const Z: usize>(&mut self, d: T) {
        let (x, y) = after(Z);
        self.moment[x] = (-d).mul_add(self.force[y], self.moment[x]);
        self.moment[y] = d.mul_add(self.force[x], self.moment[y]);
    }

    /// A [`turn`](Self::turn) followed by a [`shift`](Self::shift) along the same axis.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn screw<const Z: usize>(&mut self, c: T, s: T, d: T) {
        self.turn::<Z>(c, s);
        self.shift::<Z>(d);
    }

    /// Subtracts `other · factor`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn subtract(&mut self, other: &Self, factor: T) {
        each!(k in [0 1 2] {
            self.moment[k] = (-factor).mul_add(other.moment[k], self.moment[k]);
            self.force[k] = (-factor).mul_add(other.force[k], self.force[k]);
        });
    }

    /// Wrench times a factor.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn scaled(&self, factor: T) -> Self {
        let ([a, b, c], [d, e, f]) = (self.moment, self.force);
        Self { moment: [a * factor, b * factor, c * factor], force: [d * factor, e * factor, f * factor] }
    }

    /// Adds another wrench.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn add(&mut self, other: &Self) {
        each!(k in [0 1 2] {
            self.moment[k] += other.moment[k];
            self.force[k] += other.force[k];
        });
    }
}
