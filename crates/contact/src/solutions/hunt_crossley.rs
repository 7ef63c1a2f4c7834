//! Hunt–Crossley law F = k xᵖ (1 + d ẋ), d in s/m, solved exactly.
//!
//! The restitution depends only on a = d v, v the approach speed, and not on p, k and m̄:
//!
//! | quantity          | equation                                                |
//! |-------------------|---------------------------------------------------------|
//! | the relation      | a (1 + e) = ln[(1 + a)/(1 − e a)]                       |
//! | solved by h > 0   | e = (1 − 𝓛)/(1 + 𝓛), a = h (1 + 𝓛), e a = h (1 − 𝓛)  |
//! | with Langevin's   | 𝓛(h) = coth h − 1/h, which rises from 0 to 1           |
//!
//! so that a(e) = 2h/(1 + e) with 𝓛(h) = (1 − e)/(1 + e). The rebound speed e v is always below 1/d. Near e = 1,
//! a ≈ (3/2)(1 − e); towards e = 0, a → 1/e.
//!
//! Source: u du/(1 + d u) = −(k/m̄) xᵖ dx integrated from v to −e v, derived here and tested against the integration of
//! the motion. Zhang and Sharf (2004, 2009) give the same implicit relation (cited from memory, not read).
//! The law itself is Hunt and Crossley's (1975).

use crate::ContactLawError;
use crate::error::{LawParameter, not_negative, unit_interval};
use crate::limits;

/// Name of the law in messages and files.
pub(crate) const NAME: &str = "hunt-crossley";

/// Restitution of the dissipation number a = d v. Errors: a is negative, NaN or infinite.
pub fn restitution(dissipation_number: f64) -> Result<f64, ContactLawError> {
    Ok(Solution::from_dissipation_number(not_negative("dissipation number", dissipation_number)?)
        .restitution())
}

/// 1 − e of the dissipation number a = d v, without loss of digits for small a. Errors: as [`restitution`].
pub fn restitution_loss(dissipation_number: f64) -> Result<f64, ContactLawError> {
    Ok(Solution::from_dissipation_number(not_negative("dissipation number", dissipation_number)?).loss())
}

/// Dissipation number a = d v that gives the restitution e.
///
/// 0 for e = 1. Errors: e is not from 0 to 1; e = 0, because no dissipation reaches e = 0 (a → 1/e).
pub fn dissipation_number(restitution: f64) -> Result<f64, ContactLawError> {
    let e = unit_interval(LawParameter::Restitution, restitution)?;
    number_from_loss(1.0 - e, e)
}

/// Dissipation number a = d v that gives the restitution e = 1 − loss, for losses too small to be represented in e.
///
/// Errors: the loss is not from 0 to 1; a loss of 1 as e = 0 of [`dissipation_number`].
pub fn dissipation_number_from_loss(loss: f64) -> Result<f64, ContactLawError> {
    let loss = unit_interval("1 - restitution", loss)?;
    number_from_loss(loss, 1.0 - loss)
}

/// Dissipation number of the restitution e = 1 − `loss`; both are given, so that neither loses digits.
fn number_from_loss(loss: f64, e: f64) -> Result<f64, ContactLawError> {
    // 1/e overflows for smaller e.
    if e < f64::MIN_POSITIVE {
        return Err(ContactLawError::Unreachable {
            law: NAME,
            restitution: e,
            why: "the rebound speed approaches 1/d for large dissipation d, and 0 only for d → ∞",
            remedy: "use a small restitution, such as 0.01",
        });
    }
    Ok(2.0 * inverse_langevin(loss / (1.0 + e), 2.0 * e / (1.0 + e)) / (1.0 + e))
}

/// Exact solution, with the parameter h = ½ ln[(1 + a)/(1 − e a)].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Solution {
    pub(crate) h: f64,
    langevin: f64,
    complement: f64,
}

impl Solution {
    /// Solves h (1 + 𝓛(h)) = a for h by Newton's method; the left side is convex, so the steps approach the root from above.
    pub(crate) fn from_dissipation_number(a: f64) -> Self {
        let mut h = if a < 2.0 { 2.0 * a / (1.0 + (1.0 + 4.0 * a / 3.0).sqrt()) } else { 0.5 * a + 0.5 };
        for _ in 0..limits::MAX_ITERATIONS {
            let (langevin, _) = langevin(h);
            // h 𝓛' = h − h 𝓛² − 2 𝓛.
            let slope = 1.0 + langevin + h * langevin_slope(h, langevin);
            let next = h - (h * (1.0 + langevin) - a) / slope;
            let settled = (next - h).abs() <= limits::CONVERGED * h;
            h = next;
            if settled {
                break;
            }
        }
        let (langevin, complement) = langevin(h);
        Self { h, langevin, complement }
    }

    /// Restitution e = (1 − 𝓛)/(1 + 𝓛).
    pub(crate) fn restitution(self) -> f64 {
        self.complement / (1.0 + self.langevin)
    }

    /// Loss of restitution 1 − e = 2𝓛/(1 + 𝓛).
    pub(crate) fn loss(self) -> f64 {
        2.0 * self.langevin / (1.0 + self.langevin)
    }
}

/// 𝓛(h) = coth h − 1/h and 1 − 𝓛(h), each without loss of digits, for h ≥ 0.
fn langevin(h: f64) -> (f64, f64) {
    if h < limits::LANGEVIN_FRACTION {
        // h/(3 + h²/(5 + h²/(7 + …))), all terms positive; 16 levels reach 1e-17 at h = 3.
        let tail = (1..17).rev().fold(35.0, |below, n| f64::from(2 * n + 1) + h * h / below);
        let value = h / tail;
        (value, 1.0 - value)
    } else {
        let complement = 1.0 / h - 2.0 / (2.0 * h).exp_m1();
        (1.0 - complement, complement)
    }
}

/// 𝓛'(h) = 1/h² − 1/sinh² h = 1 − 𝓛² − 2𝓛/h.
fn langevin_slope(h: f64, langevin: f64) -> f64 {
    if h < limits::LANGEVIN_SERIES {
        1.0 / 3.0 - h * h / 15.0
    } else if h < limits::LANGEVIN_FRACTION {
        1.0 - langevin * langevin - 2.0 * langevin / h
    } else {
        1.0 / h / h - h.sinh().powi(-2)
    }
}

/// Solves 𝓛(h) = value, with 1 − value also given, by Newton's method from Cohen's rational estimate (1991).
fn inverse_langevin(value: f64, complement: f64) -> f64 {
    if complement < limits::LANGEVIN_ASYMPTOTE {
        // 1 − 𝓛 = 1/h − 2/(e^(2h) − 1), the last term 1e-43 at h = 50.
        return 1.0 / complement;
    }
    let mut h = value * (3.0 - value * value) / (complement * (1.0 + value));
    for _ in 0..limits::MAX_ITERATIONS {
        let (at, short) = langevin(h);
        let excess = if value < 0.5 { at - value } else { complement - short };
        let next = if h < limits::LANGEVIN_FRACTION {
            h - excess / langevin_slope(h, at)
        } else {
            // 1 − 𝓛 is nearly 1/h, so Newton's step is in 1/h.
            let inverse = 1.0 / h;
            1.0 / (inverse + excess * inverse * inverse / langevin_slope(h, at))
        };
        let settled = (next - h).abs() <= limits::CONVERGED * h;
        h = next;
        if settled {
            break;
        }
    }
    h
}
