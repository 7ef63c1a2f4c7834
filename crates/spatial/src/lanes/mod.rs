//! Several numbers side by side, one for each configuration: what the processor has, chosen when the program runs.
//!
//! [`Instructions::best`] says which instruction set there is, [`Instructions::run`] runs a piece of work on its lanes. Products are
//! rounded once with their sums ([`Lanes::mul_add`]) where the set has that instruction, for one number and for many
//! alike, so that a lane and a single number are equal to the last bit on one machine.

mod instructions;
mod lane;
mod portable;
mod sines;
#[cfg(target_arch = "x86_64")]
mod x86;

pub use instructions::Instructions;
pub use lane::{Lanes, Work};
pub use portable::Portable;
pub use sines::LARGEST_ANGLE;
