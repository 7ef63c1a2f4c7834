//! Hysteresis with a loss factor η: F = F_s(x) (1 + h sgn ẋ), h = πη/2.
//!
//! A loss factor is the energy lost in a full cycle over 2π times the largest stored energy. One compression and return on the spring lose
//! 2h W, W = ∫ F_s dx, a full cycle twice as much: η = 4hW/(2πW). With (1 + h) W = ½ m̄ v² and (1 − h) W = ½ m̄ e² v²
//!
//! ```text
//! e² = (1 − h)/(1 + h),   η = (2/π) (1 − e²)/(1 + e²)
//! ```
//!
//! for every spring, mass and speed, and for a mass that changes over the penetration (one degree of freedom). To second order in η, e is the
//! restitution e^(−πη/2) of a linear damper with ζ = η/2. Source: energy balance; the law is that of Reid (1956, cited from memory).

use crate::ContactLawError;
use crate::error::{LawParameter, unit_interval};
use std::f64::consts::FRAC_PI_2;

/// Name of the law in messages and files.
pub(crate) const NAME: &str = "loss-factor";

/// Part h = πη/2 of the spring force that the hysteresis adds. Errors: η is not from 0 to less than 2/π.
pub(crate) fn hysteresis(loss_factor: f64) -> Result<f64, ContactLawError> {
    let h = FRAC_PI_2 * loss_factor;
    if (0.0..1.0).contains(&h) {
        return Ok(h);
    }
    let (what, valid) = ("loss factor".into(), "a number from 0 to less than 2/pi = 0.6366");
    Err(ContactLawError::OutOfRange { what, got: loss_factor, valid })
}

/// Restitution e and loss 1 − e of the part h = πη/2.
pub(crate) fn rebound(h: f64) -> (f64, f64) {
    let e = ((1.0 - h) / (1.0 + h)).sqrt();
    (e, 2.0 * h / (1.0 + h) / (1.0 + e))
}

/// Loss factor η that gives the restitution e. Errors: e is not from 0 to 1; e = 0, for which no force is left for the return.
pub(crate) fn loss_factor(restitution: f64) -> Result<f64, ContactLawError> {
    let e = unit_interval(LawParameter::Restitution, restitution)?;
    let found = (1.0 - e) * (1.0 + e) / (1.0 + e * e) / FRAC_PI_2;
    hysteresis(found).map(|_| found).map_err(|_| ContactLawError::Unreachable {
        law: NAME,
        restitution: e,
        why: "no force is left for the return (the loss factor is 2/pi)",
        remedy: "use a small restitution, such as 0.01",
    })
}
