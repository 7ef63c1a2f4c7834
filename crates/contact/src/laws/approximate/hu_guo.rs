//! Hu and Guo 2015: an approximation of the Hunt–Crossley law's damping.
//!
//! Agrees with the exact law to second order in 1 − e; damping too large by 1/2 for e → 0.

use crate::laws::facts::Facts;

pub(in crate::laws) const FACTS: Facts = Facts {
    name: "hu-guo",
    title: "Hu and Guo 2015",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a = 3(1−e)/(2e)",
    source: "Hu and Guo (2015): attribution cited from memory, not compared with the paper; L. Škrinjar's \
        contact_model.py has half of it, which would be \
             wrong near e = 1. For p = 1 it is the law of Ye, Li and Zhu (2009).",
    approximation: Some(dissipation_number),
};

/// Dissipation number a for the required e.
pub(super) fn dissipation_number(e: f64) -> f64 {
    1.5 * (1.0 - e) / e
}
