//! Herbert and McWhannell 1977: an approximation of the Hunt–Crossley law's damping.
//!
//! Agrees with the exact law to first order in 1 − e.

use crate::laws::facts::Facts;

pub(in crate::laws) const FACTS: Facts = Facts {
    name: "herbert-mcwhannell",
    title: "Herbert and McWhannell 1977",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a = 6(1−e)/((2e−1)²+3)",
    source: "Herbert and McWhannell (1977). Formula as in L. Škrinjar's contact_model.py.",
    approximation: Some(dissipation_number),
};

/// Dissipation number a for the required e.
pub(super) fn dissipation_number(e: f64) -> f64 {
    6.0 * (1.0 - e) / ((2.0 * e - 1.0).powi(2) + 3.0)
}
