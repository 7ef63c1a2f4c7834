//! Names and sources of the laws that are solved exactly.

use super::facts::Facts;
use crate::solutions::{hunt_crossley, kelvin_voigt, loss_factor};

pub(super) const KELVIN_VOIGT: Facts = Facts {
    name: kelvin_voigt::NAME,
    title: "Kelvin–Voigt",
    formula: "F = k xᵖ + c x^((p−1)/2) ẋ, c = 2ζ√((p+1)/2)√(k m̄), e = exp(−2ζ arccos ζ/√(1−ζ²)), \
              or exp(−πζ/√(1−ζ²)) where the gap closes",
    source: "the equation of motion, solved; p = 3/2: Tsuji, Tanaka and Ishida (1992)",
    approximation: None,
};

pub(super) const HUNT_CROSSLEY: Facts = Facts {
    name: hunt_crossley::NAME,
    title: "Hunt–Crossley, solved exactly",
    formula: "F = k xᵖ (1 + d ẋ), d = a/v, a (1 + e) = ln((1 + a)/(1 − e a))",
    source: "the law of Hunt and Crossley (1975); the equation of motion, solved",
    approximation: None,
};

pub(super) const LOSS_FACTOR: Facts = Facts {
    name: loss_factor::NAME,
    title: "Loss factor",
    formula: "F = F_s (1 + (π/2) η sgn ẋ), F_s = k xᵖ or a force curve, η = (2/π)(1 − e²)/(1 + e²)",
    source: "hysteresis that does not depend on the speed; the energy balance, solved; Reid (1956, cited from memory)",
    approximation: None,
};
