//! Mixed formula of EXUDYN: an approximation of the Hunt–Crossley law's damping.
//!
//! The most accurate of the approximations; discontinuous at e = 1/3.

use super::{carvalho_martins, gonthier};
use crate::laws::facts::Facts;

pub(in crate::laws) const FACTS: Facts = Facts {
    name: "exudyn-mixed",
    title: "EXUDYN's mixture",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a = 3(1−e)(11−e)/(2(1+9e)) for e > 1/3, else (1−e²)/e",
    source: "EXUDYN's CObjectContactSphereSphere.cpp, impact model 2: Carvalho and Martins \
             above 1/3, Gonthier and others below.",
    approximation: Some(dissipation_number),
};

/// Dissipation number a for the required e.
pub(super) fn dissipation_number(e: f64) -> f64 {
    if e > 1.0 / 3.0 { carvalho_martins::dissipation_number(e) } else { gonthier::dissipation_number(e) }
}
