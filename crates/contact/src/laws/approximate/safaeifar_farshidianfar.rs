//! Safaeifar and Farshidianfar 2020: an approximation of the Hunt–Crossley law's damping.
//!
//! Damping too small by 1/6 near e = 1, too large by 1/4 for e → 0.

use crate::laws::facts::Facts;

pub(in crate::laws) const FACTS: Facts = Facts {
    name: "safaeifar-farshidianfar",
    title: "Safaeifar and Farshidianfar 2020",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a = 5(1−e)/(4e)",
    source: "Safaeifar and Farshidianfar (2020): formula and attribution cited from memory, not compared with \
        the paper.",
    approximation: Some(dissipation_number),
};

/// Dissipation number a for the required e.
pub(super) fn dissipation_number(e: f64) -> f64 {
    1.25 * (1.0 - e) / e
}
