//! Flores and others 2011: an approximation of the Hunt–Crossley law's damping.
//!
//! A fifteenth too much near e = 1, 1.6 times the exact towards e = 0.

use super::facts::Facts;

pub(super) const FACTS: Facts = Facts {
    name: "flores",
    title: "Flores and others 2011",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a = 8(1−e)/(5e)",
    source: "Flores, Machado, Silva and Martins (2011). Formula as in L. Škrinjar's \
             contact_model.py.",
    approximation: Some(number),
};

/// a of the requested e.
pub(super) fn number(e: f64) -> f64 {
    1.6 * (1.0 - e) / e
}
