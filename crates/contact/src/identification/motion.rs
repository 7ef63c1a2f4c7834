//! Motion of an impact and the signals that it causes.

use super::record::{DamperForm, Measured};
use crate::Sample;
use crate::stepping::{Stepping, runge_kutta_step};

/// Estimated durations after which the mass rests on the contact.
const MOST_DURATIONS: f64 = 20.0;
/// Iterations for the time of the separation: 1e-12 of a step.
const END_ITERATIONS: usize = 12;

/// Contact of a constant mass.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contact {
    pub mass: f64,
    pub stiffness: f64,
    pub exponent: f64,
    pub damping: f64,
    pub form: DamperForm,
    pub gravity: f64,
}

impl Contact {
    /// Force, N, with penetrations below 0 as 0. The damper has at least the effect of the penetration `floor`, m.
    fn force(&self, depth: f64, rate: f64, floor: f64) -> f64 {
        let depth = depth.max(0.0);
        let spring = self.stiffness * depth.powf(self.exponent);
        match self.form {
            DamperForm::HuntCrossley => spring * (1.0 + self.damping * rate),
            DamperForm::KelvinVoigt => {
                // Below p = 1 the damper is linear: it has no infinite force at the touch.
                let scale = if self.exponent <= 1.0 {
                    1.0
                } else {
                    depth.max(floor).powf(0.5 * (self.exponent - 1.0))
                };
                spring + self.damping * scale * rate
            }
        }
    }
}

/// Motion from the touch to the separation.
#[derive(Debug)]
pub(super) struct Motion {
    contact: Contact,
    speed: f64,
    samples: Vec<Sample>,
}

impl Motion {
    /// Motion with `steps` steps over an estimated duration, s. `None`: the mass does not separate within [`MOST_DURATIONS`], or numbers
    /// overflow.
    pub fn new(contact: Contact, speed: f64, duration: f64, steps: f64) -> Option<Self> {
        let step = duration / steps;
        // The mean of the first step: a step from an infinite slope would have an error that changes with the exponent.
        let floor = 0.25 * speed * step;
        let force = |depth: f64, rate: f64| contact.force(depth, rate, floor);
        let weight = -contact.mass * contact.gravity;
        let stepping = Stepping {
            force: &force,
            ends_at_zero_force: true,
            corners: &[],
            step,
            speed,
            beside: &|_, _| weight,
            most_steps: (MOST_DURATIONS * steps) as usize,
        };
        let mut samples = Vec::new();
        let profile = [(0.0, contact.mass), (1.0, contact.mass)];
        let found = stepping.run(&profile, |sample| samples.push(sample))?;
        let mut motion = Self { contact, speed, samples };
        motion.refine_end(step);
        let is_finite = found.peak_force.is_finite() && motion.end().rate.is_finite();
        is_finite.then_some(motion)
    }

    /// Moves the end to the zero of a smooth function of the state: the penetration, or the force divided by the power of the damper. The
    /// stepping interpolates the force, which has no slope at the end of a contact without a pull.
    fn refine_end(&mut self, step: f64) {
        let Self { contact, samples, .. } = self;
        let [.., before, end] = &mut samples[..] else { return };
        let remaining = |(depth, rate): (f64, f64)| match contact.form {
            DamperForm::KelvinVoigt if contact.damping > 0.0 => {
                let power = 0.5 * (contact.exponent + 1.0).min(2.0 * contact.exponent);
                contact.stiffness * depth.signum() * depth.abs().powf(power) + contact.damping * rate
            }
            // Without a damper that pulls, the force vanishes with the penetration.
            _ => depth,
        };
        let rates = |(depth, rate): (f64, f64)| {
            (rate, contact.gravity - contact.force(depth, rate, 0.0) / contact.mass)
        };
        let state = (before.penetration, before.rate);
        let (mut low, mut high) = (0.0, step);
        let (mut at_low, mut at_high) = (remaining(state), remaining(runge_kutta_step(state, step, &rates)));
        let mut length = step;
        for _ in 0..END_ITERATIONS {
            if !(at_low > 0.0 && at_high < 0.0) {
                break;
            }
            length = (low * at_high - high * at_low) / (at_high - at_low);
            let found = remaining(runge_kutta_step(state, length, &rates));
            // The Illinois variant of regula falsi halves the value of an end that stays.
            if found > 0.0 {
                (low, at_low, at_high) = (length, found, 0.5 * at_high);
            } else {
                (high, at_high, at_low) = (length, found, 0.5 * at_low);
            }
        }
        let (penetration, rate) = runge_kutta_step(state, length, &rates);
        *end = Sample { time: before.time + length, penetration, rate, force: 0.0 };
    }

    /// State at the separation.
    fn end(&self) -> Sample {
        self.samples[self.samples.len() - 1]
    }

    /// Restitution, largest force (N), largest penetration (m), and duration (s).
    pub fn key_figures(&self) -> [f64; 4] {
        let largest = |of: fn(&Sample) -> f64| self.samples.iter().map(of).fold(0.0, f64::max);
        let end = self.end();
        [-end.rate / self.speed, largest(|s| s.force), largest(|s| s.penetration), end.time]
    }

    /// Signals at a time after the touch, s, which increases from call to call; `cursor`: 0 before the first call. `width`, s: if above 0, a
    /// force that begins with a jump rises over it.
    pub fn signal(&self, quantity: Measured, time: f64, width: f64, cursor: &mut usize) -> f64 {
        let state = self.state(time, cursor);
        let rises = |force: f64| {
            if time.abs() < 0.5 * width {
                // The jump is the force of the damper at the touch.
                let jump = self.samples[0].force;
                force - jump * f64::from(u8::from(time >= 0.0)) + jump * (time / width + 0.5)
            } else {
                force
            }
        };
        match quantity {
            Measured::Force => rises(state.force),
            Measured::Acceleration => rises(state.force) / self.contact.mass,
            Measured::Velocity => state.rate,
            Measured::Displacement => state.penetration,
        }
    }

    /// State at a time after the touch, s: free before the touch and after the separation, cubic between two steps.
    fn state(&self, time: f64, cursor: &mut usize) -> Sample {
        let end = self.end();
        let free = |from: Sample| {
            let (dt, g) = (time - from.time, self.contact.gravity);
            let penetration = from.penetration + (from.rate + 0.5 * g * dt) * dt;
            Sample { time, penetration, rate: from.rate + g * dt, force: 0.0 }
        };
        if time < 0.0 {
            return free(self.samples[0]);
        }
        if time >= end.time {
            return free(end);
        }
        while *cursor + 2 < self.samples.len() && self.samples[*cursor + 1].time <= time {
            *cursor += 1;
        }
        let (a, b) = (self.samples[*cursor], self.samples[*cursor + 1]);
        let h = b.time - a.time;
        let t = (time - a.time) / h;
        let (t2, change) = (t * t, b.penetration - a.penetration);
        let bend = a.rate + b.rate - 2.0 * change / h;
        let first = 3.0 * change - h * (2.0 * a.rate + b.rate);
        let penetration = a.penetration + h * a.rate * t + first * t2 + h * bend * t2 * t;
        let rate = a.rate + (2.0 * first * t + 3.0 * h * bend * t2) / h;
        Sample { time, penetration, rate, force: self.contact.force(penetration, rate, 0.0).max(0.0) }
    }
}

/// Butterworth filter of second order, run forward and backward: SAE J211-1, appendix C.
#[derive(Clone, Copy, Debug)]
pub(super) struct Filter {
    inputs: f64,
    before: [f64; 2],
    /// Samples after which an end of the signal has no influence.
    pub reach: usize,
}

impl Filter {
    /// Filter of a channel frequency class, Hz, for a distance of samples, s. `None`: the samples are too far apart for the class, or the class is not above 0.
    pub fn new(class: f64, step: f64) -> Option<Self> {
        // The SAE's factor 2.0775 is the ratio of the -3 dB frequency of one pass to the class.
        let angle = std::f64::consts::PI * class * 2.0775 * step;
        if !(angle > 0.0 && angle < 0.5 * std::f64::consts::PI) {
            return None;
        }
        let wa = angle.tan();
        let root = std::f64::consts::SQRT_2 * wa;
        let sum = 1.0 + root + wa * wa;
        Some(Self {
            inputs: wa * wa / sum,
            before: [2.0 * (1.0 - wa * wa) / sum, (root - 1.0 - wa * wa) / sum],
            // The slower pole decays by exp(-angle √2) per sample: 1e-9 after this number.
            reach: (21.0 / (std::f64::consts::SQRT_2 * angle)).ceil().min(1e9) as usize,
        })
    }

    /// Filters a signal in place.
    pub fn run(&self, values: &mut [f64]) {
        for _ in 0..2 {
            let Some(&first) = values.first() else { return };
            let (mut x, mut y) = ([first; 2], [first; 2]);
            for value in values.iter_mut() {
                let out = self.inputs * (*value + 2.0 * x[0] + x[1])
                    + self.before[0] * y[0]
                    + self.before[1] * y[1];
                (x, y) = ([*value, x[0]], [out, y[0]]);
                *value = out;
            }
            values.reverse();
        }
    }
}
