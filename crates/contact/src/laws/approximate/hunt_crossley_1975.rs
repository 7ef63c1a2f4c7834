//! Hunt and Crossley 1975, linearised: an approximation of the Hunt–Crossley law's damping.
//!
//! Agrees with the exact law to first order in 1 − e.

use crate::laws::facts::Facts;

pub(in crate::laws) const FACTS: Facts = Facts {
    name: "hunt-crossley-1975",
    title: "Hunt and Crossley 1975, linearised",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a = 3(1−e)/2",
    source: "Hunt and Crossley (1975). Formula as in L. Škrinjar's contact_model.py and \
             EXUDYN's CObjectContactSphereSphere.cpp (impact model 1). Marhefka and Orin's \
             (1999) is the same (cited from memory, not read).",
    approximation: Some(dissipation_number),
};

/// Dissipation number a for the required e.
pub(super) fn dissipation_number(e: f64) -> f64 {
    1.5 * (1.0 - e)
}
