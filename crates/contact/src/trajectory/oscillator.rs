//! Impact on a Kelvin–Voigt contact.
//!
//! With y = x^((p+1)/2) the motion is that of the linear oscillator y″ + 2ζ y′ + y = 0, y(0) = 0, y′(0) = 1, in a
//! transformed time s. The speed is y′, the force y^q (y + 2ζ y′) and dt/ds = (1 − q) y^(−q), with q = (p−1)/(p+1).
//!
//! With r = y′/y, which decreases from ∞ at the touch to 0 at the largest penetration, y = e^(−ζs)/√(r² + 2ζr + 1)
//! and s = arccot((r + ζ)/√(1−ζ²))/√(1−ζ²): the largest force, at 2ζq r² + (1 + q − 4ζ²) r − 2ζ = 0, has a
//! closed form too.

use super::{State, Trajectory};
use crate::Separation;
use crate::limits;
use crate::solutions::kelvin_voigt::{compression_factor, decrement};
use std::f64::consts::PI;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Oscillator {
    ratio: f64,
    separation: Separation,
    /// q = (p−1)/(p+1).
    q: f64,
    /// √|1 − ζ²|.
    root: f64,
    compression: f64,
    expansion: f64,
}

impl Oscillator {
    /// Impact with the damping ratio ζ and the exponent p of the contact force.
    pub(crate) fn new(ratio: f64, exponent: f64, separation: Separation) -> Self {
        let root = (1.0 - ratio).abs().sqrt() * (1.0 + ratio).sqrt();
        let compression = compression_factor(ratio);
        let expansion = match separation {
            Separation::ForceVanishes => compression,
            Separation::GapCloses if ratio < 1.0 => PI / root - compression,
            Separation::GapCloses => limits::SLOW_RETURN * (ratio + root),
        };
        let q = (exponent - 1.0) / (exponent + 1.0);
        Self { ratio, separation, q, root, compression, expansion }
    }

    /// y at s after the touch.
    fn displacement(&self, s: f64) -> f64 {
        if self.ratio < 1.0 {
            (-self.ratio * s).exp() * (self.root * s).sin() / self.root
        } else {
            self.slow_decay(s) * self.fast_factor(s)
        }
    }

    /// y at s before the end. For ζ < 1 the sine is computed from the remaining angle to y = 0, without loss of
    /// digits for small y. This angle at the end is 0 if the gap closes, and π − 2 arccos ζ = 2 arcsin ζ if the force
    /// vanishes.
    fn displacement_before_end(&self, s: f64) -> f64 {
        let at = self.compression + self.expansion - s;
        if self.ratio < 1.0 {
            let end_angle = match self.separation {
                Separation::ForceVanishes => 2.0 * self.ratio.asin(),
                Separation::GapCloses => 0.0,
            };
            (-self.ratio * at).exp() * (self.root * s + end_angle).sin() / self.root
        } else {
            self.displacement(at)
        }
    }

    /// Decay e^(−(ζ−√(ζ²−1)) s) of the slow mode, ζ ≥ 1.
    fn slow_decay(&self, s: f64) -> f64 {
        (-s / (self.ratio + self.root)).exp()
    }

    /// Factor (1 − e^(−2√(ζ²−1) s))/(2√(ζ²−1)) of the fast mode, ζ ≥ 1.
    fn fast_factor(&self, s: f64) -> f64 {
        if self.root == 0.0 { s } else { -(-2.0 * self.root * s).exp_m1() / (2.0 * self.root) }
    }

    /// y′ at s after the touch.
    fn rate(&self, s: f64) -> f64 {
        if self.ratio < 1.0 {
            let (sine, cosine) = (self.root * s).sin_cos();
            (-self.ratio * s).exp() * (cosine - self.ratio / self.root * sine)
        } else {
            // cosh − ζ sinh/√ = e^(√ s) [1 − (ζ + √) (1 − e^(−2√s))/(2√)].
            self.slow_decay(s) * (1.0 - (self.ratio + self.root) * self.fast_factor(s))
        }
    }

    /// y^q; 1 for the linear contact, also at y = 0.
    fn y_power_q(&self, y: f64) -> f64 {
        if self.q == 0.0 { 1.0 } else { y.max(0.0).powf(self.q) }
    }

    /// State for y and y′ = `rate`.
    fn state(&self, y: f64, rate: f64) -> State {
        State {
            penetration: y.max(0.0).powf(1.0 - self.q),
            rate,
            force: self.y_power_q(y) * (y + 2.0 * self.ratio * rate),
        }
    }

    /// dt/ds at y.
    fn time_rate(&self, y: f64) -> f64 {
        (1.0 - self.q) / self.y_power_q(y)
    }

    /// r = y′/y at the largest force; infinite at the touch.
    fn slope_at_peak(&self) -> f64 {
        let (double, q) = (2.0 * self.ratio, self.q);
        // 1 + q − 4ζ² as a product: no overflow, and the correct sign near 0.
        let half = (1.0 + q).sqrt();
        let middle = (half - double) * (half + double);
        let discriminant = middle.hypot(2.0 * double * q.sqrt());
        if middle > 0.0 {
            2.0 * double / (middle + discriminant)
        } else {
            (discriminant - middle) / (2.0 * double * q)
        }
    }

    /// Solves y′/y = r for s, r ≥ 0.
    fn s_at_slope(&self, r: f64) -> f64 {
        let g = r + self.ratio;
        if self.root < limits::SMALL_ANGLE * g {
            // arctan(√/g)/√ to the third order; artanh for ζ > 1.
            let square = (1.0 - self.ratio) * (1.0 + self.ratio) / g / g;
            (1.0 - square / 3.0 + square * square / 5.0) / g
        } else if self.ratio < 1.0 {
            self.root.atan2(g) / self.root
        } else {
            // g − √ = r + 1/(ζ + √), without loss of digits.
            (2.0 * self.root / (r + 1.0 / (self.ratio + self.root))).ln_1p() / (2.0 * self.root)
        }
    }
}

impl Trajectory for Oscillator {
    fn loss(&self) -> f64 {
        -(-decrement(self.ratio, self.separation)).exp_m1()
    }

    fn restitution(&self) -> f64 {
        (-decrement(self.ratio, self.separation)).exp()
    }

    fn compression(&self) -> f64 {
        self.compression
    }

    fn expansion(&self) -> f64 {
        self.expansion
    }

    fn ends(&self) -> bool {
        self.separation == Separation::ForceVanishes || self.ratio < 1.0
    }

    fn max_penetration(&self) -> f64 {
        (-(1.0 - self.q) * self.ratio * self.compression).exp()
    }

    fn peak(&self) -> (f64, f64) {
        let slope = self.slope_at_peak();
        if !slope.is_finite() {
            // Linear contact with ζ ≥ 1/2: the jump of the damper force at the touch is the maximum.
            return (0.0, 2.0 * self.ratio);
        }
        let s = self.s_at_slope(slope);
        // y = e^(−ζs)/√(r² + 2ζr + 1), with a square root that does not overflow.
        let across = ((slope + 2.0 * self.ratio) * slope).sqrt().hypot(1.0);
        let decay = (-self.ratio * s).exp();
        let force = (decay / across).powf(self.q) * decay * (1.0 + 2.0 * self.ratio * slope) / across;
        (s, force)
    }

    fn after_touch(&self, s: f64) -> State {
        self.state(self.displacement(s), self.rate(s))
    }

    fn before_end(&self, s: f64) -> State {
        let at = self.compression + self.expansion - s;
        let mut state = self.state(self.displacement_before_end(s), self.rate(at));
        if self.separation == Separation::ForceVanishes {
            state.force = if s == 0.0 { 0.0 } else { state.force.max(0.0) };
        }
        state
    }

    fn singularities(&self) -> [f64; 2] {
        // With light damping, the gap is nearly closed when the force vanishes.
        let closes = match self.separation {
            Separation::ForceVanishes => self.ratio < limits::LIGHT_DAMPING,
            Separation::GapCloses => self.ratio < 1.0,
        };
        [self.q, if closes { self.q } else { 0.0 }]
    }

    fn time_rate_after_touch(&self, s: f64) -> f64 {
        self.time_rate(self.displacement(s))
    }

    fn time_rate_before_end(&self, s: f64) -> f64 {
        self.time_rate(self.displacement_before_end(s))
    }

    fn time_after_touch(&self, s: f64) -> f64 {
        if self.q == 0.0 { s } else { super::from_singular_end(s, |s| self.time_rate_after_touch(s)) }
    }

    fn time_before_end(&self, s: f64) -> f64 {
        if self.q == 0.0 { s } else { super::from_singular_end(s, |s| self.time_rate_before_end(s)) }
    }
}
