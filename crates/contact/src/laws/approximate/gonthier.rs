//! Gonthier and others 2004: an approximation of the Hunt–Crossley law's damping.
//!
//! Exact for e → 0; damping too large by 1/3 near e = 1.

use crate::laws::facts::Facts;

pub(in crate::laws) const FACTS: Facts = Facts {
    name: "gonthier",
    title: "Gonthier and others 2004",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a = (1−e²)/e",
    source: "Gonthier, McPhee, Lange and Piedboeuf (2004), their approximation. Formula as in \
             L. Škrinjar's contact_model.py and EXUDYN's CObjectContactSphereSphere.cpp \
             (impact model 2, e ≤ 1/3).",
    approximation: Some(dissipation_number),
};

/// Dissipation number a for the required e.
pub(super) fn dissipation_number(e: f64) -> f64 {
    (1.0 - e) * (1.0 + e) / e
}
