//! SIMD lanes and kernels on them.

use crate::Scalar;

/// Several `f64` in parallel. There are no comparisons, so no lane affects another.
pub trait Lanes: Scalar {
    /// Number of lanes.
    const WIDTH: usize;
    /// Loads the first [`WIDTH`](Self::WIDTH) numbers of a slice.
    fn load(from: &[f64]) -> Self;
    /// Stores the lanes at the start of a slice.
    fn store(self, to: &mut [f64]);
    /// `self · factor + addend`, rounded once if the instruction set has a fused operation.
    fn mul_add(self, factor: Self, addend: Self) -> Self;
    /// |x|.
    fn abs(self) -> Self;
    /// Larger value; `self` if `other` is NaN.
    fn max(self, other: Self) -> Self;
}

/// Kernel that runs with any number of lanes. `run` and all functions called by `run` must be marked
/// `#[inline(always)]`: only inlined code is compiled for the instruction set.
pub trait Work {
    /// Runs the kernel.
    fn run<T: Lanes>(self);
}
