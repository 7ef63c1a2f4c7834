//! Instruction sets, chosen when the program runs.

use super::lane::Work;
use super::portable::Portable;
#[cfg(target_arch = "x86_64")]
use super::x86;

/// An instruction set for lanes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Instructions {
    /// What every processor of the architecture has: two numbers side by side.
    Baseline,
    /// x86-64 with AVX2 and FMA: four.
    Avx2,
    /// x86-64 with AVX-512: eight.
    Avx512,
}

impl Instructions {
    /// How many numbers stand side by side.
    pub fn width(self) -> usize {
        match self {
            Instructions::Baseline => 2,
            Instructions::Avx2 => 4,
            Instructions::Avx512 => 8,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Instructions::Baseline => "baseline",
            Instructions::Avx2 => "AVX2",
            Instructions::Avx512 => "AVX-512",
        }
    }

    /// Whether this processor has it.
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

    /// The widest that this processor has.
    pub fn best() -> Self {
        let sets = [Instructions::Avx512, Instructions::Avx2];
        sets.into_iter().find(|set| set.is_available()).unwrap_or(Instructions::Baseline)
    }

    /// Runs work on lanes as wide as the set's; on the baseline where the processor does not have it.
    #[inline]
    pub fn run<W: Work>(self, work: W) {
        #[cfg(target_arch = "x86_64")]
        match self {
            Instructions::Avx512 => x86::run_eight(work),
            Instructions::Avx2 => x86::run_four(work),
            Instructions::Baseline => x86::run_two(work),
        }
        #[cfg(not(target_arch = "x86_64"))]
        work.run::<Portable<2>>();
    }

    /// Runs work on one number, with the same instructions and so to the same last bit.
    #[inline]
    pub fn run_one<W: Work>(self, work: W) {
        #[cfg(target_arch = "x86_64")]
        if self != Instructions::Baseline {
            return x86::run_fused(work);
        }
        work.run::<Portable<1>>();
    }
}
