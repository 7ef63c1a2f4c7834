//! What lanes can do, and what is done on them.

use crate::Scalar;

/// Numbers side by side. Nothing compares them: what a lane holds decides nothing for the others.
pub trait Lanes: Scalar {
    /// How many.
    const WIDTH: usize;
    /// The first [`WIDTH`](Self::WIDTH) numbers of a slice.
    fn load(from: &[f64]) -> Self;
    /// Writes them to the start of a slice.
    fn store(self, to: &mut [f64]);
    /// `self · factor + addend`, rounded once where the instruction set has it.
    fn mul_add(self, factor: Self, addend: Self) -> Self;
    /// |x|.
    fn abs(self) -> Self;
    /// The greater one; `self`, where `other` is NaN.
    fn max(self, other: Self) -> Self;
}

/// Work that runs on any lanes. `run` must be marked `#[inline(always)]`, and so must all that it calls: only what is
/// inlined is compiled for the instruction set.
pub trait Work {
    /// The work itself.
    fn run<T: Lanes>(self);
}
