//! Carvalho and Martins 2019: an approximation of the Hunt–Crossley law's damping.
//!
//! Agrees with the exact law to third order in 1 − e; finite for e → 0.

use crate::laws::facts::Facts;

pub(in crate::laws) const FACTS: Facts = Facts {
    name: "carvalho-martins",
    title: "Carvalho and Martins 2019",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a = 3(1−e)(11−e)/(2(1+9e))",
    source: "Carvalho and Martins (2019). Formula as in EXUDYN's \
             CObjectContactSphereSphere.cpp (impact model 2, e > 1/3).",
    approximation: Some(dissipation_number),
};

/// Dissipation number a for the required e.
pub(super) fn dissipation_number(e: f64) -> f64 {
    1.5 * (1.0 - e) * (11.0 - e) / (1.0 + 9.0 * e)
}
