//! Lankarani and Nikravesh 1990: an approximation of the Hunt–Crossley law's damping.
//!
//! Agrees with the exact law to first order in 1 − e.

use crate::laws::facts::Facts;

pub(in crate::laws) const FACTS: Facts = Facts {
    name: "lankarani-nikravesh",
    title: "Lankarani and Nikravesh 1990",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a = 3(1−e²)/4",
    source: "Lankarani and Nikravesh (1990). Formula as in L. Škrinjar's contact_model.py.",
    approximation: Some(dissipation_number),
};

/// Dissipation number a for the required e.
pub(super) fn dissipation_number(e: f64) -> f64 {
    0.75 * (1.0 - e) * (1.0 + e)
}
