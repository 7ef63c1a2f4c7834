//! Lee and Wang 1983: an approximation of the Hunt–Crossley law's damping.
//!
//! Half of the exact damping near e = 1.

use crate::laws::facts::Facts;

pub(in crate::laws) const FACTS: Facts = Facts {
    name: "lee-wang",
    title: "Lee and Wang 1983",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a = 3(1−e)/4",
    source: "Lee and Wang (1983). Formula as in L. Škrinjar's contact_model.py.",
    approximation: Some(dissipation_number),
};

/// Dissipation number a for the required e.
pub(super) fn dissipation_number(e: f64) -> f64 {
    0.75 * (1.0 - e)
}
