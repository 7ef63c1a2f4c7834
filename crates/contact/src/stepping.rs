//! Integration of an impact of one degree of freedom with fixed steps.

use crate::error::{LawParameter, positive};
use crate::impact::{self, Impact, Sample};
use crate::{CompliantContact, ContactLawError};
use serde::Serialize;
use std::cell::Cell;
use std::f64::consts::PI;

/// Steps of the integration over the duration of the impact with the mass at the touch.
pub(crate) const STEPS: f64 = 4000.0;
/// Greatest number of steps: an impact that takes longer has no end.
pub(crate) const MOST_STEPS: usize = 100_000;
/// Iterations for the step to a point of a force curve; each multiplies the error by the relative change of the speed over the step.
const CORNER_ITERATIONS: usize = 6;

/// Key figures of an impact with an effective mass that changes over the penetration.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct VaryingMassImpact {
    /// Rebound speed divided by approach speed.
    pub restitution: f64,
    /// Largest penetration, m.
    pub max_penetration: f64,
    /// m̄ at the largest penetration, kg.
    pub mass_at_max_penetration: f64,
    /// Largest force, N.
    pub peak_force: f64,
}

/// Impact m̄ δ̈ + ½ m̄′ δ̇² = −F(δ, δ̇) − k δ.
pub(crate) struct Stepping<'a> {
    /// F over penetration (m) and rate (m/s), N.
    pub force: &'a dyn Fn(f64, f64) -> f64,
    /// True if the contact ends when its force vanishes.
    pub ends_at_zero_force: bool,
    /// True if the force jumps where the rate changes its sign. A step that crosses zero rate ends there.
    pub jumps_at_reversal: bool,
    /// Penetrations at which the slope of the force jumps, m. A step that crosses one ends there.
    pub corners: &'a [f64],
    /// Length of a step, s.
    pub step: f64,
    /// Approach speed, m/s.
    pub speed: f64,
    /// Force beside the contact over penetration and rate, N; positive against the penetration.
    pub beside: &'a dyn Fn(f64, f64) -> f64,
    /// Greatest number of steps.
    pub most_steps: usize,
}

/// Step on a force curve, s: a part of the half period of a linear spring with this penetration.
pub(crate) fn step_on_curve(contact: CompliantContact, speed: f64) -> Result<f64, ContactLawError> {
    Ok(PI * contact.undamped_penetration(speed)? / speed / STEPS)
}

impl Stepping<'_> {
    /// Integrates the impact and passes the state at the touch, after every step and at the end to `record`. `profile`: pairs of penetration
    /// (m) and m̄ (kg). With w = √m̄ δ̇ the equation is ẇ = −F/√m̄. `None`: the contact does not end.
    pub(crate) fn run(
        &self,
        profile: &[(f64, f64)],
        mut record: impl FnMut(Sample),
    ) -> Option<VaryingMassImpact> {
        let mass = |x: f64| interpolate(profile, x);
        let is_closing = Cell::new(true);
        // The force of one direction within a step.
        let force = |x: f64, rate: f64| match (self.jumps_at_reversal, is_closing.get()) {
            (false, _) => (self.force)(x, rate),
            (true, true) => (self.force)(x, rate.max(f64::MIN_POSITIVE)),
            (true, false) => (self.force)(x, rate.min(-f64::MIN_POSITIVE)),
        };
        let rates = |(x, w): (f64, f64)| {
            let root = mass(x).sqrt();
            (w / root, -(force(x, w / root) + (self.beside)(x, w / root)) / root)
        };
        let rate = |(x, w): (f64, f64)| w / mass(x).sqrt();
        let mut state = (0.0, mass(0.0).sqrt() * self.speed);
        let (mut deepest, mut peak_force) = (0.0f64, force(0.0, self.speed));
        let sample = |time: f64, state: (f64, f64)| Sample {
            time,
            penetration: state.0,
            rate: rate(state),
            force: force(state.0, rate(state)),
        };
        record(sample(0.0, state));
        let (mut origin, mut steps) = (0.0, 0.0);
        for _ in 0..self.most_steps {
            let time = origin + steps * self.step;
            let mut length = self.step;
            let mut next = runge_kutta_step(state, length, &rates);
            let reverses =
                self.jumps_at_reversal && if is_closing.get() { next.1 < 0.0 } else { next.1 > 0.0 };
            if reverses {
                // Regula falsi: the rate is nearly linear over the step.
                for _ in 0..CORNER_ITERATIONS {
                    length *= state.1 / (state.1 - next.1);
                    next = runge_kutta_step(state, length, &rates);
                }
                next.1 = 0.0;
            }
            let (low, high) = (state.0.min(next.0), state.0.max(next.0));
            let mut crossed = self.corners.iter().copied().filter(|x| low < *x && *x < high);
            let corner = if next.0 > state.0 { crossed.next() } else { crossed.next_back() };
            if let Some(corner) = corner {
                // Regula falsi: the penetration is nearly linear over the step.
                for _ in 0..CORNER_ITERATIONS {
                    length *= (corner - state.0) / (next.0 - state.0);
                    next = runge_kutta_step(state, length, &rates);
                }
                next.0 = corner;
            }
            // The contact ends where this quantity falls below zero during the expansion.
            let remaining = |state: (f64, f64)| {
                if self.ends_at_zero_force { force(state.0, rate(state)) } else { state.0 }
            };
            if next.1 < 0.0 && (remaining(next) <= 0.0 || next.0 <= 0.0) {
                // A force curve with a force at the touch: the gap closes first.
                let closes = next.0 <= 0.0 && force(0.0, rate(next)) > 0.0;
                let (before, after) =
                    if closes { (state.0, next.0) } else { (remaining(state), remaining(next)) };
                let fraction = if before > after { (before / (before - after)).clamp(0.0, 1.0) } else { 1.0 };
                let end = (state.0 + fraction * (next.0 - state.0), state.1 + fraction * (next.1 - state.1));
                record(sample(time + fraction * length, end));
                return Some(VaryingMassImpact {
                    restitution: -rate(end) / self.speed,
                    max_penetration: deepest,
                    mass_at_max_penetration: mass(deepest),
                    peak_force,
                });
            }
            deepest = deepest.max(next.0);
            peak_force = peak_force.max(force(next.0, rate(next)));
            state = next;
            if reverses && state.1 == 0.0 {
                is_closing.set(!is_closing.get());
                // The sides stay together if the force of the other direction does not drive the motion on.
                let drives = rates(state).1;
                if if is_closing.get() { drives <= 0.0 } else { drives >= 0.0 } {
                    return None;
                }
            }
            (origin, steps) =
                if corner.is_some() || reverses { (time + length, 0.0) } else { (origin, steps + 1.0) };
            record(sample(time + length, state));
        }
        None
    }

    /// Impact with a constant mass, kg.
    pub(crate) fn impact(&self, mass: f64) -> Impact {
        let (mut deepest, mut largest) = ((0.0, 0.0), (0.0, 0.0));
        let mut last = Sample { time: 0.0, penetration: 0.0, rate: self.speed, force: 0.0 };
        let profile = [(0.0, mass), (1.0, mass)];
        let found = self.run(&profile, |sample| {
            if last.rate > 0.0 && sample.rate <= 0.0 {
                // The rate is nearly linear over a step.
                let time = (sample.time - last.time) * last.rate / (last.rate - sample.rate);
                deepest = (last.penetration + 0.5 * last.rate * time, last.time + time);
            }
            largest = if sample.force > largest.0 { (sample.force, sample.time) } else { largest };
            last = sample;
        });
        let restitution = found.map_or(0.0, |found| found.restitution.max(0.0));
        Impact {
            restitution,
            duration: found.map(|_| last.time),
            max_penetration: deepest.0,
            time_of_max_penetration: deepest.1,
            peak_force: largest.0,
            time_of_peak_force: largest.1,
            energy_lost: 0.5 * mass * self.speed * self.speed * (1.0 - restitution * restitution),
            rebound_speed: restitution * self.speed,
        }
    }

    /// History of the impact with a constant mass (kg) at `count` equal distances of time, from the touch to the end. Error: the count.
    pub(crate) fn history(&self, mass: f64, count: usize) -> Result<Vec<Sample>, ContactLawError> {
        impact::check_count(count)?;
        let mut all: Vec<Sample> = Vec::new();
        let profile = [(0.0, mass), (1.0, mass)];
        self.run(&profile, |sample| all.push(sample));
        let end = all.last().map_or(0.0, |sample| sample.time);
        let at = |number: usize| {
            let time = end * number as f64 / (count - 1) as f64;
            let right = all.partition_point(|sample| sample.time < time).clamp(1, all.len() - 1);
            let (a, b) = (all[right - 1], all[right]);
            let part = if b.time > a.time { (time - a.time) / (b.time - a.time) } else { 0.0 };
            let between = |a: f64, b: f64| a + part * (b - a);
            Sample {
                time,
                penetration: between(a.penetration, b.penetration),
                rate: between(a.rate, b.rate),
                force: between(a.force, b.force),
            }
        };
        Ok((0..count).map(at).collect())
    }
}

/// State after a step of the classical Runge–Kutta method of fourth order; `rates`: derivatives of a state with respect to time.
pub(crate) fn runge_kutta_step(
    state: (f64, f64),
    step: f64,
    rates: &dyn Fn((f64, f64)) -> (f64, f64),
) -> (f64, f64) {
    let along = |(x, v): (f64, f64), (dx, dv): (f64, f64), h: f64| (x + h * dx, v + h * dv);
    let a = rates(state);
    let b = rates(along(state, a, 0.5 * step));
    let c = rates(along(state, b, 0.5 * step));
    let d = rates(along(state, c, step));
    let mean = |a: f64, b: f64, c: f64, d: f64| (a + 2.0 * b + 2.0 * c + d) / 6.0;
    along(state, (mean(a.0, b.0, c.0, d.0), mean(a.1, b.1, c.1, d.1)), step)
}

/// Depth of the last point of a profile, m.
pub(crate) fn checked_depth(profile: &[(f64, f64)]) -> Result<f64, ContactLawError> {
    for (_, mass) in profile {
        positive(LawParameter::Mass, *mass)?;
    }
    match profile {
        [_, .., (depth, _)] => positive("depth of the last mass, m", *depth),
        _ => {
            let (what, valid) = ("points of the mass".into(), "at least 2");
            Err(ContactLawError::OutOfRange { what, got: profile.len() as f64, valid })
        }
    }
}

/// Cubic through the values and slopes at the ends of an interval; slopes of the parabolas through three neighbours.
pub(crate) fn interpolate(points: &[(f64, f64)], x: f64) -> f64 {
    let last = points.len() - 1;
    if x <= points[0].0 {
        return points[0].1;
    }
    if x >= points[last].0 {
        return points[last].1;
    }
    let right = points.partition_point(|(at, _)| *at <= x).clamp(1, last);
    let ((x0, y0), (x1, y1)) = (points[right - 1], points[right]);
    let chord = |i: usize| (points[i + 1].1 - points[i].1) / (points[i + 1].0 - points[i].0);
    let slope = |i: usize| match i {
        0 => chord(0),
        i if i == last => chord(last - 1),
        i => {
            let (before, after) = (points[i].0 - points[i - 1].0, points[i + 1].0 - points[i].0);
            (chord(i - 1) * after + chord(i) * before) / (before + after)
        }
    };
    let (h, t) = (x1 - x0, (x - x0) / (x1 - x0));
    let (t2, t3) = (t * t, t * t * t);
    (2.0 * t3 - 3.0 * t2 + 1.0) * y0
        + (t3 - 2.0 * t2 + t) * h * slope(right - 1)
        + (3.0 * t2 - 2.0 * t3) * y1
        + (t3 - t2) * h * slope(right)
}
