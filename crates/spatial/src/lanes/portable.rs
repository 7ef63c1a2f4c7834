//! Lanes as arrays, for any architecture.

use super::lane::{Lanes, Work};
use super::sines::sin_cos;
use crate::Scalar;
use num_traits::{One, Zero};
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// Lanes in an array. `mul_add` is fused on aarch64, where the instruction always exists. The operations name each element instead of
/// using a loop: kernels contain thousands of operations, and a compiler needs much longer to unroll as many loops.
macro_rules! portable {
    ($name:ident, $width:literal, $($i:literal)+) => {
        #[doc = concat!("Lanes in an array: ", $width, ".")]
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name([f64; $width]);

        impl $name {
            #[inline(always)]
            fn map(self, f: impl Fn(f64) -> f64) -> Self {
                Self([$(f(self.0[$i])),+])
            }

            #[inline(always)]
            fn zip(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
                Self([$(f(self.0[$i], other.0[$i])),+])
            }
        }

        operator!($name, Add, add, AddAssign, add_assign, +);
        operator!($name, Sub, sub, SubAssign, sub_assign, -);
        operator!($name, Mul, mul, MulAssign, mul_assign, *);
        operator!($name, Div, div, DivAssign, div_assign, /);

        impl Neg for $name {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                self.map(|a| -a)
            }
        }

        impl Zero for $name {
            #[inline(always)]
            fn zero() -> Self {
                Self([0.0; $width])
            }
            fn is_zero(&self) -> bool {
                self.0.iter().all(|a| *a == 0.0)
            }
        }

        impl One for $name {
            #[inline(always)]
            fn one() -> Self {
                Self([1.0; $width])
            }
        }

        impl Scalar for $name {
            #[inline(always)]
            fn from_f64(x: f64) -> Self {
                Self([x; $width])
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                sin_cos(self)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                self.map(f64::sqrt)
            }
        }

        impl Lanes for $name {
            const WIDTH: usize = $width;
            #[inline(always)]
            fn load(from: &[f64]) -> Self {
                Self([$(from[$i]),+])
            }
            #[inline(always)]
            fn store(self, to: &mut [f64]) {
                $(to[$i] = self.0[$i];)+
            }
            #[inline(always)]
            fn mul_add(self, factor: Self, addend: Self) -> Self {
                #[cfg(target_arch = "aarch64")]
                return Self([$(self.0[$i].mul_add(factor.0[$i], addend.0[$i])),+]);
                #[cfg(not(target_arch = "aarch64"))]
                return self * factor + addend;
            }
            #[inline(always)]
            fn abs(self) -> Self {
                self.map(f64::abs)
            }
            #[inline(always)]
            fn max(self, other: Self) -> Self {
                self.zip(other, |a, b| if b > a { b } else { a })
            }
        }
    };
}

macro_rules! operator {
    ($name:ident, $trait:ident, $method:ident, $assign:ident, $assign_method:ident, $operator:tt) => {
        impl $trait for $name {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.zip(other, |a, b| a $operator b)
            }
        }
        impl $assign for $name {
            #[inline(always)]
            fn $assign_method(&mut self, other: Self) {
                *self = *self $operator other;
            }
        }
    };
}

portable!(Single, 1, 0);
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64", target_arch = "wasm32")))]
portable!(Pair, 2, 0 1);

impl Single {
    /// Value of the lane.
    pub fn number(self) -> f64 {
        self.0[0]
    }
}

/// Runs a kernel with one lane. Not inlined: kernels are large.
#[inline(never)]
pub(super) fn run_single<W: Work>(work: W) {
    work.run::<Single>();
}

/// Runs a kernel with two lanes.
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64", target_arch = "wasm32")))]
#[inline(never)]
pub(super) fn run_pair<W: Work>(work: W) {
    work.run::<Pair>();
}
