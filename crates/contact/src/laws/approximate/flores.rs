//! Flores and others 2011: an approximation of the Hunt–Crossley law's damping.
//!
//! Damping too large by 1/15 near e = 1, and by a factor of 1.6 for e → 0.

use crate::laws::facts::Facts;

pub(in crate::laws) const FACTS: Facts = Facts {
    name: "flores",
    title: "Flores and others 2011",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a = 8(1−e)/(5e)",
    source: "Flores, Machado, Silva and Martins (2011). Formula as in L. Škrinjar's \
             contact_model.py.",
    approximation: Some(dissipation_number),
};

/// Dissipation number a for the required e.
pub(super) fn dissipation_number(e: f64) -> f64 {
    1.6 * (1.0 - e) / e
}
