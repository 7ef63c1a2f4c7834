//! Gharib and Hurmuzlu 2012: an approximation of the Hunt–Crossley law's damping.
//!
//! Designed for small e, and exact for e → 0. For e = 1 the damping is not zero: the restitution is 0.59.

use crate::laws::facts::Facts;

pub(in crate::laws) const FACTS: Facts = Facts {
    name: "gharib-hurmuzlu",
    title: "Gharib and Hurmuzlu 2012",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a = 1/e",
    source: "Gharib and Hurmuzlu (2012): formula and attribution cited from memory, not compared with the paper.",
    approximation: Some(dissipation_number),
};

/// Dissipation number a for the required e.
pub(super) fn dissipation_number(e: f64) -> f64 {
    1.0 / e
}
