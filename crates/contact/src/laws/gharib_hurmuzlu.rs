//! Gharib and Hurmuzlu 2012: an approximation of the Hunt–Crossley law's damping.
//!
//! Right towards e = 0; made for that end. At e = 1 it still damps, to e = 0.59.

use super::facts::Facts;

pub(super) const FACTS: Facts = Facts {
    name: "gharib-hurmuzlu",
    title: "Gharib and Hurmuzlu 2012",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a = 1/e",
    source: "Gharib and Hurmuzlu (2012): formula and attribution from memory of the \
             literature, not checked against the paper.",
    approximation: Some(number),
};

/// a of the requested e.
pub(super) fn number(e: f64) -> f64 {
    1.0 / e
}
