//! Twist in arrays, with the inverse transforms of the packed wrench.

use super::vector::{after, rotate_back, turn_vector};
use super::wrench::PackedWrench;
use crate::lanes::Lanes;

/// Twist in arrays: angular velocity (rad/s) and velocity of the origin of the frame (m/s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PackedTwist<T> {
    /// Angular velocity, rad/s.
    pub angular: [T; 3],
    /// Velocity of the origin, m/s.
    pub linear: [T; 3],
}

impl<T: Lanes> PackedTwist<T> {
    /// Zero twist.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn zero() -> Self {
        Self { angular: [T::zero(); 3], linear: [T::zero(); 3] }
    }

    /// Rotation by −angle about axis `Z`: inverse of [`PackedWrench::turn`].
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn turn_back<const Z: usize>(&mut self, c: T, s: T) {
        turn_vector::<T, Z>(&mut self.angular, c, -s);
        turn_vector::<T, Z>(&mut self.linear, c, -s);
    }

    /// Inverse of [`PackedWrench::rotate`].
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn rotate_back(&mut self, r: &[[T; 3]; 3]) {
        rotate_back(&mut self.angular, r);
        rotate_back(&mut self.linear, r);
    }

    /// Inverse of [`PackedWrench::shift`].
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn shift_back<const Z: usize>(&mut self, d: T) {
        let (x, y) = after(Z);
        self.linear[x] = d.mul_add(self.angular[y], self.linear[x]);
        self.linear[y] = (-d).mul_add(self.angular[x], self.linear[y]);
    }

    /// Power of a wrench, W.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn power(&self, wrench: &PackedWrench<T>) -> T {
        let (m, f, w, v) = (&wrench.moment, &wrench.force, &self.angular, &self.linear);
        let turning = m[0].mul_add(w[0], m[1].mul_add(w[1], m[2] * w[2]));
        f[0].mul_add(v[0], f[1].mul_add(v[1], f[2].mul_add(v[2], turning)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Scalar;
    use crate::lanes::Single;

    type One = Single;

    fn numbers(values: [f64; 3]) -> [One; 3] {
        values.map(One::from_f64)
    }

    /// A change of the frame does not change the power: fᵀv before equals fᵀv after.
    #[test]
    fn transforms_keep_the_power() {
        let (c, s, d) = (One::from_f64(0.8), One::from_f64(0.6), One::from_f64(0.7));
        let r = [[0.0, -1.0, 0.0], [0.6, 0.0, -0.8], [0.8, 0.0, 0.6]].map(numbers);
        let above = PackedTwist { angular: numbers([0.3, -1.1, 0.7]), linear: numbers([2.0, 0.4, -0.9]) };
        let below = PackedWrench { moment: numbers([1.2, 0.5, -0.4]), force: numbers([-0.6, 0.9, 1.7]) };
        macro_rules! same_power {
            ($forth:ident::<$axis:literal>, $back:ident, $($by:expr),*) => {{
                let (mut wrench, mut twist) = (below, above);
                wrench.$forth::<$axis>($($by),*);
                twist.$back::<$axis>($($by),*);
                // A few roundings of terms of size 3.
                assert!((above.power(&wrench) - twist.power(&below)).number().abs() < 1e-14);
            }};
        }
        same_power!(turn::<0>, turn_back, c, s);
        same_power!(turn::<2>, turn_back, c, s);
        same_power!(shift::<0>, shift_back, d);
        same_power!(shift::<1>, shift_back, d);
        same_power!(shift::<2>, shift_back, d);
        let (mut wrench, mut twist) = (below, above);
        wrench.rotate(&r);
        twist.rotate_back(&r);
        assert!((above.power(&wrench) - twist.power(&below)).number().abs() < 1e-14);
    }
}
