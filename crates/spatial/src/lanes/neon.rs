//! Two lanes of NEON, which every 64-bit ARM processor supports.

#![allow(unsafe_code, unused_unsafe, reason = "the operations of some sets are safe functions")]

use super::lane::{Lanes, Work};
use super::register::lanes;
use super::sines::sin_cos;
use crate::Scalar;
use num_traits::{One, Zero};
use std::arch::aarch64::*;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

lanes!(
    Pair,
    float64x2_t,
    2,
    vdupq_n_f64,
    vld1q_f64,
    vst1q_f64,
    vaddq_f64,
    vsubq_f64,
    vmulq_f64,
    vdivq_f64,
    vsqrtq_f64,
    larger,
    |x| vnegq_f64(x),
    |x| vabsq_f64(x),
    |a, b, c| vfmaq_f64(c, a, b)
);

/// The larger of `other` and `own`; `own` if one of them is NaN.
#[inline(always)]
fn larger(other: float64x2_t, own: float64x2_t) -> float64x2_t {
    // SAFETY: every 64-bit ARM processor supports NEON.
    unsafe { vbslq_f64(vcgtq_f64(other, own), other, own) }
}

/// Runs a kernel with two lanes. Not inlined: kernels are large.
#[inline(never)]
pub(super) fn run_pair<W: Work>(work: W) {
    work.run::<Pair>();
}
