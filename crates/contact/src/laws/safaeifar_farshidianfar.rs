//! Safaeifar and Farshidianfar 2020: an approximation of the Hunt–Crossley law's damping.
//!
//! A sixth too little near e = 1, a quarter too much towards e = 0.

use super::facts::Facts;

pub(super) const FACTS: Facts = Facts {
    name: "safaeifar-farshidianfar",
    title: "Safaeifar and Farshidianfar 2020",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a = 5(1−e)/(4e)",
    source: "Safaeifar and Farshidianfar (2020): formula and attribution from memory of the \
             literature, not checked against the paper.",
    approximation: Some(number),
};

/// a of the requested e.
pub(super) fn number(e: f64) -> f64 {
    1.25 * (1.0 - e) / e
}
