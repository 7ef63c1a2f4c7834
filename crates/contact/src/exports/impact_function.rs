//! Dimensionless IMPACT force of Adams: restitution of a damping, and damping of a restitution.

use crate::ContactLawError;
use crate::error::{LawParameter, not_negative, positive, representable, unit_interval};
use crate::limits;

/// F = max(0, k xᵖ + STEP(x, 0, 0, d, cmax) ẋ), in the penetration x₀ = ((p+1) m̄ v²/(2k))^{1/(p+1)} that the spring
/// alone would reach, and the approach speed v.
///
/// y″ = −(p+1)/2 · max(0, yᵖ + ĉ S(y/D) y′), y(0) = 0, y′(0) = 1, S(u) = 3u² − 2u³ up to 1; with D = d/x₀ and
/// ĉ = cmax v/(k x₀ᵖ). The contact ends when y is 0 again: before that the force can be zero for a while.
/// There is no closed form; the motion is integrated by Dormand and Prince's pair of orders 5 and 4.
/// For D → 0 and p = 1, ĉ → 2ζ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ImpactFunction {
    exponent: f64,
    ramp: f64,
}

impl ImpactFunction {
    /// `exponent`: p, 1 to 10. `ramp`: D, 1e-4 to 1e4. Error: a number is out of range.
    pub fn new(exponent: f64, ramp: f64) -> Result<Self, ContactLawError> {
        if !crate::CompliantContact::EXPONENTS.contains(&exponent) {
            let (what, valid) = (LawParameter::Exponent, "a number from 1 to 10");
            return Err(ContactLawError::OutOfRange { what, got: exponent, valid });
        }
        if !limits::RAMPS.contains(&ramp) {
            let (what, valid) =
                ("IMPACT's ramp d over the undamped compression".into(), "a number from 1e-4 to 1e4");
            return Err(ContactLawError::OutOfRange { what, got: ramp, valid });
        }
        Ok(Self { exponent, ramp })
    }

    /// x₀, m. Errors: an argument is not above 0; overflow.
    pub fn undamped_penetration(
        exponent: f64,
        mass: f64,
        stiffness: f64,
        speed: f64,
    ) -> Result<f64, ContactLawError> {
        let speed = positive(LawParameter::Speed, speed)?;
        // Sum of logarithms: single terms can overflow.
        let sum = ((exponent + 1.0) / 2.0).ln() + mass.ln() + 2.0 * speed.ln() - stiffness.ln();
        representable("undamped compression, m", (sum / (exponent + 1.0)).exp())
    }

    /// Restitution of the damping ĉ. Errors: ĉ is negative or not finite; the contact does not end.
    pub fn restitution(&self, damping: f64) -> Result<f64, ContactLawError> {
        let damping = not_negative("IMPACT's dimensionless damping", damping)?;
        if damping == 0.0 {
            return Ok(1.0);
        }
        let mut state = [0.0, 1.0];
        let mut step = limits::FIRST_STEP * self.ramp.min(1.0);
        for _ in 0..limits::MAX_STEPS {
            let (next, error) = self.dormand_prince(damping, state, step);
            let growth = step_growth(error);
            if error > limits::STEP_TOLERANCE {
                step *= growth;
                continue;
            }
            let is_tensile = |state| self.force(damping, state) < 0.0;
            if next[0] <= 0.0 {
                return Ok((-self.locate_event(damping, state, step, |s| s[0] <= 0.0)[1]).clamp(0.0, 1.0));
            }
            if !is_tensile(next) {
                state = next;
                step *= growth;
                continue;
            }
            let [y, u] = self.locate_event(damping, state, step, is_tensile);
            let Some(y) = self.next_compressive_penetration(damping, y, u) else {
                return Ok((-u).clamp(0.0, 1.0));
            };
            state = [y, u];
            step = step.min(0.1 * y / -u);
        }
        Err(unreachable(f64::NAN))
    }

    /// Ratio of the greatest penetration to the undamped penetration. Errors: the damping is negative or not finite;
    /// the motion does not reverse.
    pub fn penetration(&self, damping: f64) -> Result<f64, ContactLawError> {
        let damping = not_negative("IMPACT's dimensionless damping", damping)?;
        let mut state = [0.0, 1.0];
        let mut step = limits::FIRST_STEP * self.ramp.min(1.0);
        for _ in 0..limits::MAX_STEPS {
            let (next, error) = self.dormand_prince(damping, state, step);
            if error <= limits::STEP_TOLERANCE {
                if next[1] <= 0.0 {
                    return Ok(self.locate_event(damping, state, step, |s| s[1] <= 0.0)[0]);
                }
                state = next;
            }
            step *= step_growth(error);
        }
        Err(unreachable(f64::NAN))
    }

    /// During separation at constant speed u with zero force: the largest penetration below y at which the force is
    /// positive again; `None` if there is none.
    fn next_compressive_penetration(&self, damping: f64, y: f64, u: f64) -> Option<f64> {
        let is_compressive = |y: f64| self.force(damping, [y, u]) > 0.0;
        let mut above = y;
        // The region may be as small as (D/ĉ)^(1/(2−p)): the search goes down by a constant ratio.
        while above > limits::CLOSED_GAP {
            let below = limits::SEARCH_RATIO * above;
            if is_compressive(below) {
                return Some(bisect(below, above, |y| !is_compressive(y)).0);
            }
            above = below;
        }
        None
    }

    /// Damping ĉ of the restitution e; 0 for e = 1. Errors: e is out of 0 to 1, or so small that the mass nearly
    /// comes to rest in the contact (including e = 0).
    pub fn damping(&self, restitution: f64) -> Result<f64, ContactLawError> {
        let e = unit_interval(LawParameter::Restitution, restitution)?;
        if e == 1.0 {
            return Ok(0.0);
        }
        if e < limits::MIN_RESTITUTION {
            return Err(unreachable(e));
        }
        // For small damping the loss is proportional to the damping; integration cannot distinguish the loss from 0.
        if 1.0 - e < limits::MIN_LOSS {
            return Ok(self.damping(1.0 - limits::MIN_LOSS)? * ((1.0 - e) / limits::MIN_LOSS));
        }
        let log_error =
            |damping: f64| -> Result<f64, ContactLawError> { Ok(self.restitution(damping)?.ln() - e.ln()) };
        // Search for a bracket from 1 − e by factors.
        let mut low = 1.0 - e;
        let mut at_low = log_error(low)?;
        while at_low < 0.0 {
            low /= 4.0;
            at_low = log_error(low)?;
        }
        let (mut high, mut at_high) = (low, at_low);
        while at_high > 0.0 {
            (low, at_low) = (high, at_high);
            high *= 2.0;
            if high > limits::MAX_IMPACT_DAMPING {
                return Err(unreachable(e));
            }
            at_high = log_error(high)?;
        }
        regula_falsi(low, at_low, high, at_high, log_error)
    }

    /// Dimensionless force yᵖ + ĉ S(y/D) y′ without the clamp to positive values; continued smoothly to y < 0.
    fn force(&self, damping: f64, [y, u]: [f64; 2]) -> f64 {
        let part = (y / self.ramp).min(1.0);
        y.abs().powf(self.exponent).copysign(y) + damping * part * part * (3.0 - 2.0 * part) * u
    }

    /// Derivatives (y′, y″) of a state.
    fn rates(&self, damping: f64, state: [f64; 2]) -> [f64; 2] {
        [state[1], -(self.exponent + 1.0) / 2.0 * self.force(damping, state)]
    }

    /// State after one step of the Dormand–Prince pair, and its estimated error.
    fn dormand_prince(&self, damping: f64, state: [f64; 2], step: f64) -> ([f64; 2], f64) {
        const A: [&[f64]; 6] = [
            &[1.0 / 5.0],
            &[3.0 / 40.0, 9.0 / 40.0],
            &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
            &[19372.0 / 6561.0, -25360.0 / 2187.0, 64448.0 / 6561.0, -212.0 / 729.0],
            &[9017.0 / 3168.0, -355.0 / 33.0, 46732.0 / 5247.0, 49.0 / 176.0, -5103.0 / 18656.0],
            &[35.0 / 384.0, 0.0, 500.0 / 1113.0, 125.0 / 192.0, -2187.0 / 6784.0, 11.0 / 84.0],
        ];
        const ERROR: [f64; 7] = [
            71.0 / 57600.0,
            0.0,
            -71.0 / 16695.0,
            71.0 / 1920.0,
            -17253.0 / 339200.0,
            22.0 / 525.0,
            -1.0 / 40.0,
        ];
        let mut slopes = [self.rates(damping, state); 7];
        let mut end_state = state;
        for (i, row) in A.iter().enumerate() {
            end_state = state;
            for (weight, slope) in row.iter().zip(&slopes) {
                end_state[0] += step * weight * slope[0];
                end_state[1] += step * weight * slope[1];
            }
            slopes[i + 1] = self.rates(damping, end_state);
        }
        let part = |j: usize| ERROR.iter().zip(&slopes).map(|(w, s)| w * s[j]).sum::<f64>() * step;
        (end_state, part(0).abs().max(part(1).abs()))
    }

    /// First state within a step for which the condition is true.
    fn locate_event(
        &self,
        damping: f64,
        state: [f64; 2],
        step: f64,
        condition: impl Fn([f64; 2]) -> bool,
    ) -> [f64; 2] {
        let at = |part: f64| self.dormand_prince(damping, state, part).0;
        at(bisect(0.0, step, |part| condition(at(part))).1)
    }
}

/// Ratio of the next step to a step with this error.
fn step_growth(error: f64) -> f64 {
    (0.9 * (limits::STEP_TOLERANCE / error.max(limits::MIN_STEP_ERROR)).powf(0.2)).clamp(0.2, 4.0)
}

/// Neighbouring numbers between which the condition changes: false at `low`, true at `high`.
fn bisect(mut low: f64, mut high: f64, condition: impl Fn(f64) -> bool) -> (f64, f64) {
    for _ in 0..limits::MAX_ITERATIONS {
        let middle = (low + high) / 2.0;
        if condition(middle) { high = middle } else { low = middle }
    }
    (low, high)
}

/// Zero x of the decreasing function `log_error` from `low` to `high`, by the Illinois variant of regula falsi in ln x;
/// `at_low` and `at_high` are the values at the ends.
fn regula_falsi(
    low: f64,
    at_low: f64,
    high: f64,
    at_high: f64,
    log_error: impl Fn(f64) -> Result<f64, ContactLawError>,
) -> Result<f64, ContactLawError> {
    let (mut a, mut f_a, mut b, mut f_b) = (low.ln(), at_low, high.ln(), at_high);
    let mut last_side = 0;
    for _ in 0..limits::MAX_SEARCH_STEPS {
        let middle = if f_a == f_b { (a + b) / 2.0 } else { (a * f_b - b * f_a) / (f_b - f_a) };
        let middle = if middle > a && middle < b { middle } else { (a + b) / 2.0 };
        let log_error = log_error(middle.exp())?;
        if log_error.abs() < limits::RESTITUTION_TOLERANCE
            || b - a < limits::BRACKET_TOLERANCE * b.abs().max(1.0)
        {
            return Ok(middle.exp());
        }
        if log_error > 0.0 {
            (a, f_a) = (middle, log_error);
            f_b = if last_side == 1 { f_b / 2.0 } else { f_b };
            last_side = 1;
        } else {
            (b, f_b) = (middle, log_error);
            f_a = if last_side == -1 { f_a / 2.0 } else { f_a };
            last_side = -1;
        }
    }
    Ok(((a + b) / 2.0).exp())
}

/// Error for a restitution that is too small for this force.
fn unreachable(restitution: f64) -> ContactLawError {
    ContactLawError::Unreachable {
        law: "adams-impact",
        restitution,
        why: "the mass nearly comes to rest in the contact",
        remedy: "ask for a restitution of at least 0.001",
    }
}
