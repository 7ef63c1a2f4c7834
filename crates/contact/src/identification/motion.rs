//! Motion of an impact and the signals that it causes.

use super::record::{DamperForm, Measured};
use crate::Sample;
use crate::stepping::runge_kutta_step;

/// Estimated durations after which the mass rests on the contact.
const MOST_DURATIONS: f64 = 20.0;
/// Iterations for the time of the separation: 1e-12 of a step.
const END_ITERATIONS: usize = 12;

/// Least penetration of a quotient of powers, m.
const LEAST_DEPTH: f64 = 1e-30;

/// Contact of a constant mass.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contact {
    pub mass: f64,
    pub stiffness: f64,
    pub exponent: f64,
    /// Coefficient and exponent of a second term of the spring.
    pub second: (f64, f64),
    pub damping: f64,
    pub form: DamperForm,
    pub gravity: f64,
}

impl Contact {
    /// Force of the spring at a penetration above 0, N; `power`: the penetration to the power of the exponent.
    fn spring(&self, depth: f64, power: f64) -> f64 {
        let (coefficient, exponent) = self.second;
        let second = if coefficient == 0.0 { 0.0 } else { coefficient * depth.powf(exponent) };
        self.stiffness * power + second
    }

    /// Force, N, with penetrations below 0 as 0. The damper has at least the effect of the penetration `floor`, m.
    fn force(&self, depth: f64, rate: f64, floor: f64) -> f64 {
        let depth = depth.max(0.0);
        match self.form {
            DamperForm::HuntCrossley => {
                self.spring(depth, depth.powf(self.exponent)) * (1.0 + self.damping * rate)
            }
            // Below p = 1 the damper is linear: it has no infinite force at the touch.
            DamperForm::KelvinVoigt if self.exponent <= 1.0 => {
                self.spring(depth, depth.powf(self.exponent)) + self.damping * rate
            }
            DamperForm::KelvinVoigt => {
                let scale = depth.powf(0.5 * (self.exponent - 1.0));
                let at_least = if depth < floor { floor.powf(0.5 * (self.exponent - 1.0)) } else { scale };
                self.spring(depth, depth * scale * scale) + self.damping * at_least * rate
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
        let rates = |(depth, rate): (f64, f64)| {
            (rate, contact.gravity - contact.force(depth, rate, floor) / contact.mass)
        };
        let sample = |time: f64, (penetration, rate): (f64, f64)| Sample {
            time,
            penetration,
            rate,
            force: contact.force(penetration, rate, floor),
        };
        let mut state = (0.0, speed);
        let mut samples = vec![sample(0.0, state)];
        for number in 1..=(MOST_DURATIONS * steps) as usize {
            state = runge_kutta_step(state, step, &rates);
            let next = sample(number as f64 * step, state);
            if !next.force.is_finite() {
                return None;
            }
            samples.push(next);
            if state.1 < 0.0 && (next.force <= 0.0 || state.0 <= 0.0) {
                let mut motion = Self { contact, speed, samples };
                motion.refine_end(step);
                return motion.end().rate.is_finite().then_some(motion);
            }
        }
        None
    }

    /// Moves the end to the zero of a smooth function of the state: the penetration, or the force divided by the power of the damper. The
    /// stepping interpolates the force, which has no slope at the end of a contact without a pull.
    fn refine_end(&mut self, step: f64) {
        let Self { contact, samples, .. } = self;
        let [.., before, end] = &mut samples[..] else { return };
        let remaining = |(depth, rate): (f64, f64)| match contact.form {
            DamperForm::KelvinVoigt if contact.damping > 0.0 => {
                let x = depth.abs().max(LEAST_DEPTH);
                let scale = x.powf(0.5 * (contact.exponent - 1.0).max(0.0));
                let spring = contact.spring(x, x.powf(contact.exponent)) / scale;
                depth.signum() * spring + contact.damping * rate
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

    /// States at times after the touch, s, which increase.
    pub fn states(&self, times: impl Iterator<Item = f64>) -> Vec<Sample> {
        let mut cursor = 0;
        times.map(|time| self.state(time, &mut cursor)).collect()
    }

    /// Force at the touch, N.
    pub fn jump(&self) -> f64 {
        self.samples[0].force
    }

    /// Signal in a state. `width`, s: if above 0, a force that begins with a jump rises over it.
    pub fn signal(&self, quantity: Measured, state: &Sample, width: f64) -> f64 {
        let time = state.time;
        let force = if time.abs() < 0.5 * width {
            let reached = if time >= 0.0 { 1.0 } else { 0.0 };
            state.force + self.jump() * (time / width + 0.5 - reached)
        } else {
            state.force
        };
        match quantity {
            Measured::Force => force,
            Measured::Acceleration => force / self.contact.mass,
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
