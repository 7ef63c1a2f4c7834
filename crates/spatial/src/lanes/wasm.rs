//! Two lanes of WebAssembly, for modules compiled with 128-bit SIMD.

#![allow(unsafe_code, unused_unsafe, reason = "the operations of some sets are safe functions")]

use super::lane::{Lanes, Work};
use super::register::lanes;
use super::sines::sin_cos;
use crate::Scalar;
use num_traits::{One, Zero};
use std::arch::wasm32::*;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

lanes!(
    Pair,
    v128,
    2,
    f64x2_splat,
    load,
    store,
    f64x2_add,
    f64x2_sub,
    f64x2_mul,
    f64x2_div,
    f64x2_sqrt,
    larger,
    |x| f64x2_neg(x),
    |x| f64x2_abs(x),
    |a, b, c| f64x2_add(f64x2_mul(a, b), c)
);

/// # Safety
/// `from` points to two numbers.
#[inline(always)]
unsafe fn load(from: *const f64) -> v128 {
    // SAFETY: as required of the caller; the load needs no alignment.
    unsafe { v128_load(from.cast()) }
}

/// # Safety
/// `to` points to two numbers.
#[inline(always)]
unsafe fn store(to: *mut f64, lanes: v128) {
    // SAFETY: as required of the caller; the store needs no alignment.
    unsafe { v128_store(to.cast(), lanes) }
}

/// The larger of `other` and `own`; `own` if one of them is NaN.
#[inline(always)]
fn larger(other: v128, own: v128) -> v128 {
    f64x2_pmax(own, other)
}

/// Runs a kernel with two lanes. Not inlined: kernels are large.
#[inline(never)]
pub(super) fn run_pair<W: Work>(work: W) {
    work.run::<Pair>();
}
