//! Kelvin–Voigt law: spring in parallel with a damper, F = k x + c ẋ, and the generalisation to any exponent.
//!
//! With ζ = c/(2√(k m̄)) and C(ζ) = arccos ζ/√(1−ζ²), continued beyond ζ = 1 as arccosh ζ/√(ζ²−1):
//!
//! | the contact ends          | restitution             | damping ratio for it       |
//! |---------------------------|-------------------------|----------------------------|
//! | when the force vanishes   | e = exp(−2ζ C(ζ))       | the root of ζ C(ζ) = −½ ln e |
//! | when the gap closes       | e = exp(−πζ/√(1−ζ²)); 0 from ζ = 1 on | ζ = L/√(π²+L²), L = −ln e |
//!
//! For the exponent p the force k xᵖ + c x^((p−1)/2) ẋ with c = 2ζ√((p+1)/2)√(k m̄) has the same restitution at every
//! speed: the substitution y = x^((p+1)/2) gives the linear oscillator. For p = 3/2, this is the law of Tsuji, Tanaka
//! and Ishida (1992).
//!
//! Source: derived here from the equation of motion and tested against its integration. The force-vanishes row is
//! also in Schwager and Pöschel (2007) (cited from memory, not read).

use crate::error::{LawParameter, not_negative, unit_interval};
use crate::limits;
use crate::{ContactLawError, Separation};
use std::f64::consts::PI;

/// Name of the law in messages and files.
pub(crate) const NAME: &str = "kelvin-voigt";

/// Restitution of the damping ratio ζ, for every speed and every exponent.
///
/// Underflows to 0 at ζ ≈ 1e162. Errors: ζ is negative, NaN or infinite.
pub fn restitution(ratio: f64, separation: Separation) -> Result<f64, ContactLawError> {
    Ok((-decrement(not_negative("damping ratio", ratio)?, separation)).exp())
}

/// 1 − e of the damping ratio ζ, without loss of digits for small ζ. Errors: as [`restitution`].
pub fn restitution_loss(ratio: f64, separation: Separation) -> Result<f64, ContactLawError> {
    Ok(-(-decrement(not_negative("damping ratio", ratio)?, separation)).exp_m1())
}

/// Damping ratio ζ that gives the restitution e.
///
/// 0 for e = 1. If the contact ends when the gap closes, e = 0 results from critical damping, ζ = 1 (and from every
/// larger ζ): the gap then never closes. Errors: e is not from 0 to 1; e = 0 if the contact ends when the force
/// vanishes, because no ζ reaches e = 0 (e ≈ 1/(4ζ²) for large ζ).
pub fn ratio(restitution: f64, separation: Separation) -> Result<f64, ContactLawError> {
    let e = unit_interval(LawParameter::Restitution, restitution)?;
    if e == 0.0 && separation == Separation::ForceVanishes {
        return Err(unreachable());
    }
    Ok(ratio_from_decrement(0.0 - e.ln(), separation))
}

/// Damping ratio ζ that gives the restitution e = 1 − loss, for losses too small to be represented in e.
///
/// Errors: the loss is not from 0 to 1; a loss of 1 as e = 0 of [`ratio`].
pub fn ratio_from_loss(loss: f64, separation: Separation) -> Result<f64, ContactLawError> {
    let loss = unit_interval("1 - restitution", loss)?;
    if loss == 1.0 && separation == Separation::ForceVanishes {
        return Err(unreachable());
    }
    Ok(ratio_from_decrement(0.0 - (-loss).ln_1p(), separation))
}

/// Error for e = 0 with a contact that ends when the force vanishes.
fn unreachable() -> ContactLawError {
    ContactLawError::Unreachable {
        law: NAME,
        restitution: 0.0,
        why: "a contact that cannot pull approaches 0 only for infinite damping (e = 1/(4 ratio^2))",
        remedy: "use a small restitution, such as 0.01 (ratio 4.8)",
    }
}

/// C(ζ) = arccos ζ/√(1−ζ²) = arccosh ζ/√(ζ²−1), C(1) = 1: the time from the first touch to the largest penetration
/// of a linear contact, in units of √(m̄/k).
///
/// Errors: ζ is negative, NaN or infinite.
pub fn compression_time(ratio: f64) -> Result<f64, ContactLawError> {
    Ok(compression_factor(not_negative("damping ratio", ratio)?))
}

/// C(ζ) of [`compression_time`] for a valid ζ.
pub(crate) fn compression_factor(ratio: f64) -> f64 {
    let gap = 1.0 - ratio;
    if gap > 0.0 {
        ratio.acos() / (gap * (1.0 + ratio)).sqrt()
    } else if gap == 0.0 {
        1.0
    } else {
        // arccosh ζ = ln(1 + (ζ−1) + √(ζ²−1)) does not lose digits near 1, and its square root does not overflow.
        let root = (-gap).sqrt() * (1.0 + ratio).sqrt();
        (root - gap).ln_1p() / root
    }
}

/// Logarithmic decrement −ln e of the damping ratio ζ.
pub(crate) fn decrement(ratio: f64, separation: Separation) -> f64 {
    match separation {
        Separation::ForceVanishes => 2.0 * ratio * compression_factor(ratio),
        Separation::GapCloses if ratio < 1.0 => PI * ratio / ((1.0 - ratio) * (1.0 + ratio)).sqrt(),
        Separation::GapCloses => f64::INFINITY,
    }
}

/// Damping ratio ζ with the logarithmic decrement −ln e; inverse of [`decrement`].
fn ratio_from_decrement(decrement: f64, separation: Separation) -> f64 {
    match separation {
        Separation::ForceVanishes => solve_ratio_times_compression(0.5 * decrement),
        Separation::GapCloses if decrement.is_infinite() => 1.0,
        Separation::GapCloses => decrement / PI.hypot(decrement),
    }
}

/// Solves ζ C(ζ) = h by Newton's method within a bracket: the left side increases from 0 with decreasing slope.
fn solve_ratio_times_compression(h: f64) -> f64 {
    let mut ratio = match h {
        _ if h < 0.75 => 2.0 * h / PI * (1.0 + 8.0 * h / (PI * PI)).min(1.5),
        _ if h < 3.0 => 1.0,
        _ => 0.5 * h.exp(),
    };
    // ζ C(ζ) ≥ ln(2ζ) for ζ ≥ 1.
    let (mut low, mut high) = (0.0, h.exp().max(1.0));
    for _ in 0..limits::MAX_ITERATIONS {
        let time = compression_factor(ratio);
        let excess = ratio * time - h;
        if excess > 0.0 {
            high = ratio
        } else {
            low = ratio
        }
        let gap = 1.0 - ratio;
        // d(ζC)/dζ = (C − ζ)/(1 − ζ²), 2/3 at ζ = 1.
        let slope =
            if gap.abs() < limits::CRITICAL_SLOPE { 2.0 / 3.0 } else { (time - ratio) / gap / (1.0 + ratio) };
        let newton = ratio - excess / slope;
        let next = if newton >= low && newton <= high { newton } else { 0.5 * (low + high) };
        if (next - ratio).abs() <= limits::CONVERGED * ratio {
            return next;
        }
        ratio = next;
    }
    ratio
}
