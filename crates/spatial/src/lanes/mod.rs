//! SIMD lanes, one configuration per lane; the instruction set is selected at run time.
//!
//! [`Instructions::best`] detects the instruction set, [`Instructions::run`] runs a kernel on its lanes. Fused
//! multiply-add ([`Lanes::mul_add`]) is used wherever the instruction set supports it, for one lane and for
//! several. On one machine, results with one lane and with several are therefore equal to the last bit.

mod instructions;
mod lane;
#[cfg(target_arch = "aarch64")]
mod neon;
mod portable;
#[cfg(any(target_arch = "x86_64", target_arch = "aarch64", target_feature = "simd128"))]
mod register;
mod sines;
#[cfg(target_feature = "simd128")]
mod wasm;
#[cfg(target_arch = "x86_64")]
mod x86;

pub use instructions::Instructions;
pub use lane::{Lanes, Work};
pub use portable::Single;
pub use sines::LARGEST_ANGLE;
