//! Lanes of x86-64: SSE2, AVX2 with FMA, AVX-512.
//!
//! The only unsafe code of this crate. The code is sound because the functions of an instruction set are called
//! only after a check that the processor supports the set, and because the lane types of a set are private to
//! this file.

#![allow(unsafe_code)]

use super::lane::{Lanes, Work};
use super::portable::run_single;
use super::register::lanes;
use super::sines::sin_cos;
use crate::Scalar;
use num_traits::{One, Zero};
use std::arch::is_x86_feature_detected;
use std::arch::x86_64::*;
use std::hint::black_box;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

/// True if the processor supports AVX2 and FMA.
pub(super) fn has_avx2() -> bool {
    is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")
}

/// True if the processor supports all parts of AVX-512 that are used here, AVX2 and FMA.
pub(super) fn has_avx512() -> bool {
    has_avx2()
        && is_x86_feature_detected!("avx512f")
        && is_x86_feature_detected!("avx512dq")
        && is_x86_feature_detected!("avx512vl")
}

/// Forces the alignment of a stack frame to a cache line, so that spilled registers do not cross a line.
#[repr(align(64))]
struct Line(#[allow(dead_code, reason = "only where it stands matters")] [u8; 1]);

/// Runs a kernel with two lanes of SSE2, which every x86-64 processor supports. Not inlined: kernels are large, and each would be
/// compiled again in every caller.
#[inline(never)]
pub(super) fn run_two<W: Work>(work: W) {
    work.run::<Two>();
}

/// Runs a kernel with four lanes of AVX2 and FMA; with two lanes of SSE2 if the processor does not support these.
pub(super) fn run_four<W: Work>(work: W) {
    #[target_feature(enable = "avx2,fma")]
    fn inside<W: Work>(work: W) {
        let mut line = Line([0]);
        black_box(&mut line);
        work.run::<Four>();
    }
    if has_avx2() {
        // SAFETY: the processor supports the set, checked above.
        unsafe { inside(work) }
    } else {
        run_two(work);
    }
}

/// Runs a kernel with eight lanes of AVX-512; with two lanes of SSE2 if the processor does not support this set.
pub(super) fn run_eight<W: Work>(work: W) {
    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,fma")]
    fn inside<W: Work>(work: W) {
        let mut line = Line([0]);
        black_box(&mut line);
        work.run::<Eight>();
    }
    if has_avx512() {
        // SAFETY: the processor supports the set, checked above.
        unsafe { inside(work) }
    } else {
        run_two(work);
    }
}

/// Runs a kernel with one lane and fused multiply-add, which rounds as the lanes of AVX2 and AVX-512 do. Without fused
/// operations if the processor does not support AVX2 and FMA.
pub(super) fn run_fused<W: Work>(work: W) {
    #[target_feature(enable = "avx2,fma")]
    fn inside<W: Work>(work: W) {
        work.run::<Fused>();
    }
    if has_avx2() {
        // SAFETY: the processor supports the set, checked above.
        unsafe { inside(work) }
    } else {
        run_single(work);
    }
}

lanes!(
    Two,
    __m128d,
    2,
    _mm_set1_pd,
    _mm_loadu_pd,
    _mm_storeu_pd,
    _mm_add_pd,
    _mm_sub_pd,
    _mm_mul_pd,
    _mm_div_pd,
    _mm_sqrt_pd,
    _mm_max_pd,
    |x| _mm_xor_pd(x, _mm_set1_pd(-0.0)),
    |x| _mm_andnot_pd(_mm_set1_pd(-0.0), x),
    |a, b, c| _mm_add_pd(_mm_mul_pd(a, b), c)
);
lanes!(
    Four,
    __m256d,
    4,
    _mm256_set1_pd,
    _mm256_loadu_pd,
    _mm256_storeu_pd,
    _mm256_add_pd,
    _mm256_sub_pd,
    _mm256_mul_pd,
    _mm256_div_pd,
    _mm256_sqrt_pd,
    _mm256_max_pd,
    |x| _mm256_xor_pd(x, _mm256_set1_pd(-0.0)),
    |x| _mm256_andnot_pd(_mm256_set1_pd(-0.0), x),
    |a, b, c| _mm256_fmadd_pd(a, b, c)
);
lanes!(
    Eight,
    __m512d,
    8,
    _mm512_set1_pd,
    _mm512_loadu_pd,
    _mm512_storeu_pd,
    _mm512_add_pd,
    _mm512_sub_pd,
    _mm512_mul_pd,
    _mm512_div_pd,
    _mm512_sqrt_pd,
    _mm512_max_pd,
    |x| _mm512_xor_pd(x, _mm512_set1_pd(-0.0)),
    |x| _mm512_abs_pd(x),
    |a, b, c| _mm512_fmadd_pd(a, b, c)
);

/// One lane with fused multiply-add: plain operations, compiled for a set that has the instruction.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Fused(f64);

macro_rules! fused {
    ($trait:ident, $method:ident, $assign:ident, $assign_method:ident, $operator:tt) => {
        impl $trait for Fused {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0 $operator other.0)
            }
        }
        impl $assign for Fused {
            #[inline(always)]
            fn $assign_method(&mut self, other: Self) {
                self.0 = self.0 $operator other.0;
            }
        }
    };
}

fused!(Add, add, AddAssign, add_assign, +);
fused!(Sub, sub, SubAssign, sub_assign, -);
fused!(Mul, mul, MulAssign, mul_assign, *);
fused!(Div, div, DivAssign, div_assign, /);

impl Neg for Fused {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Zero for Fused {
    #[inline(always)]
    fn zero() -> Self {
        Self(0.0)
    }
    fn is_zero(&self) -> bool {
        self.0 == 0.0
    }
}

impl One for Fused {
    #[inline(always)]
    fn one() -> Self {
        Self(1.0)
    }
}

impl Scalar for Fused {
    #[inline(always)]
    fn from_f64(x: f64) -> Self {
        Self(x)
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        sin_cos(self)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
}

impl Lanes for Fused {
    const WIDTH: usize = 1;
    #[inline(always)]
    fn load(from: &[f64]) -> Self {
        Self(from[0])
    }
    #[inline(always)]
    fn store(self, to: &mut [f64]) {
        to[0] = self.0;
    }
    #[inline(always)]
    fn mul_add(self, factor: Self, addend: Self) -> Self {
        Self(self.0.mul_add(factor.0, addend.0))
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        Self(if other.0 > self.0 { other.0 } else { self.0 })
    }
}
