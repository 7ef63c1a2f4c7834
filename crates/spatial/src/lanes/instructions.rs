//! SIMD instruction sets, selected at run time.

use super::lane::Work;
#[cfg(target_arch = "aarch64")]
use super::neon::run_pair;
#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64", target_arch = "wasm32")))]
use super::portable::run_pair;
use super::portable::run_single;
#[cfg(target_feature = "simd128")]
use super::wasm::run_pair;
#[cfg(target_arch = "x86_64")]
use super::x86;

/// True for WebAssembly without 128-bit SIMD: a second instance of every kernel would not be faster, and would enlarge the module that is
/// downloaded.
const ONE_LANE: bool = cfg!(all(target_arch = "wasm32", not(target_feature = "simd128")));

/// SIMD instruction set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Instructions {
    /// Minimum of the architecture, two lanes: SSE2 of x86-64, NEON of 64-bit ARM, 128-bit SIMD of WebAssembly. One lane in modules
    /// of WebAssembly without SIMD.
    Baseline,
    /// x86-64 with AVX2 and FMA: four lanes.
    Avx2,
    /// x86-64 with AVX-512: eight lanes.
    Avx512,
}

impl Instructions {
    /// Number of `f64` lanes.
    pub fn width(self) -> usize {
        match self {
            Instructions::Baseline if ONE_LANE => 1,
            Instructions::Baseline => 2,
            Instructions::Avx2 => 4,
            Instructions::Avx512 => 8,
        }
    }

    /// Name of the instruction set.
    pub fn name(self) -> &'static str {
        match self {
            Instructions::Baseline => "baseline",
            Instructions::Avx2 => "AVX2",
            Instructions::Avx512 => "AVX-512",
        }
    }

    /// True if this processor supports the instruction set.
    pub fn is_available(self) -> bool {
        match self {
            Instructions::Baseline => true,
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2 => x86::has_avx2(),
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx512 => x86::has_avx512(),
            #[cfg(not(target_arch = "x86_64"))]
            _ => false,
        }
    }

    /// Widest instruction set of this processor.
    pub fn best() -> Self {
        let sets = [Instructions::Avx512, Instructions::Avx2];
        sets.into_iter().find(|set| set.is_available()).unwrap_or(Instructions::Baseline)
    }

    /// Runs a kernel with the lanes of the set; with the baseline if the processor does not support the set.
    #[inline]
    pub fn run<W: Work>(self, work: W) {
        #[cfg(target_arch = "x86_64")]
        match self {
            Instructions::Avx512 => x86::run_eight(work),
            Instructions::Avx2 => x86::run_four(work),
            Instructions::Baseline => x86::run_two(work),
        }
        #[cfg(all(target_arch = "wasm32", not(target_feature = "simd128")))]
        run_single(work);
        #[cfg(not(any(
            target_arch = "x86_64",
            all(target_arch = "wasm32", not(target_feature = "simd128"))
        )))]
        run_pair(work);
    }

    /// Runs a kernel with one lane and the same instructions, so that results agree to the last bit.
    #[inline]
    pub fn run_one<W: Work>(self, work: W) {
        #[cfg(target_arch = "x86_64")]
        if self != Instructions::Baseline {
            return x86::run_fused(work);
        }
        run_single(work);
    }
}
