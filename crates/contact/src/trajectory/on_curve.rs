//! Impact on a force curve with Hunt–Crossley damping, F = F_s(x)(1 + d ẋ).
//!
//! u du/(1 + d u) = −F_s dx/m̄ gives, with w = d u, λ = ln(1 + w) and G = w − ln(1 + w), the energy integral
//! G(w) = (d²/m̄) ∫ F_s dx from x to the largest penetration. The restitution does not depend on the curve. The parameter s is an angle:
//! x = x_max sin s, from the touch and from the end; dt/ds is smooth between the points of the curve.

use super::dissipative::exp_m1_minus;
use super::{State, Trajectory, from_singular_end};
use crate::error::ContactLawError;
use crate::solutions::hunt_crossley::Solution;
use crate::{ForceCurve, limits};
use std::f64::consts::FRAC_PI_2;

#[derive(Clone, Copy, Debug)]
pub(crate) struct OnCurve<'a> {
    curve: &'a ForceCurve,
    mass: f64,
    speed: f64,
    /// d, s/m.
    dissipation: f64,
    solution: Solution,
    /// Largest penetration, m.
    depth: f64,
    /// Largest penetration without damping, m: unit of the lengths.
    unit: f64,
}

impl<'a> OnCurve<'a> {
    /// Motion of the mass `mass` (kg) with the dissipation number a = d v. `unit`: largest penetration without damping, m. Error: the curve
    /// does not stop the mass.
    pub(crate) fn new(
        curve: &'a ForceCurve,
        mass: f64,
        speed: f64,
        dissipation_number: f64,
        unit: f64,
    ) -> Result<Self, ContactLawError> {
        let solution = Solution::from_dissipation_number(dissipation_number);
        // Smaller damping affects only 1 − e; other quantities would be 0/0.
        let dissipation = dissipation_number.max(limits::MIN_DISSIPATION_NUMBER) / speed;
        let energy = mass * exp_m1_minus((dissipation * speed).ln_1p()) / dissipation / dissipation;
        let depth = curve.depth(energy).filter(|depth| depth.is_normal() && *depth > 0.0);
        let depth = depth.ok_or(ContactLawError::NotStopped { energy })?;
        Ok(Self { curve, mass, speed, dissipation, solution, depth, unit })
    }

    /// λ at the distance `before` (m) before the largest penetration: above 0 in compression, below 0 in expansion.
    fn log(&self, before: f64, is_compression: bool) -> f64 {
        let work = self.curve.work(self.depth - before, before);
        let g = self.dissipation * (self.dissipation * work / self.mass);
        let root = (2.0 * g).sqrt();
        // e^λ − 1 − λ = G is convex. In compression the start is above the root; in expansion the first step of Newton is.
        let (sign, mut size) = match is_compression {
            true => (1.0, root.min((g + root).ln_1p())),
            false => (-1.0, root),
        };
        for _ in 0..limits::MAX_ITERATIONS {
            if size == 0.0 {
                break;
            }
            let next = size - (exp_m1_minus(sign * size) - g) / (sign * (sign * size).exp_m1());
            let converged = (next - size).abs() <= limits::CONVERGED * size;
            size = next;
            if converged {
                break;
            }
        }
        sign * size
    }

    /// Speed ẋ at λ, m/s.
    fn rate(&self, log: f64) -> f64 {
        log.exp_m1() / self.dissipation
    }

    /// State at the angle `s`.
    fn state(&self, s: f64, is_compression: bool) -> State {
        let x = self.depth * s.sin();
        let log = self.log(self.depth - x, is_compression);
        State {
            penetration: x / self.unit,
            rate: self.rate(log) / self.speed,
            force: self.curve.at(x).0 * log.exp() / self.force_unit(),
        }
    }

    fn force_unit(&self) -> f64 {
        self.mass * self.speed * (self.speed / self.unit)
    }

    /// dt/ds at the angle `rest` before the largest penetration, s = π/2 − rest.
    fn time_rate(&self, rest: f64, is_compression: bool) -> f64 {
        let seconds = if rest < limits::TURNING_ANGLE {
            // Near the largest penetration, u = √(F x_max/m̄) rest.
            (self.depth * self.mass / self.curve.at(self.depth).0).sqrt()
        } else {
            let before = 2.0 * self.depth * (0.5 * rest).sin().powi(2);
            self.depth * rest.sin() / self.rate(self.log(before, is_compression)).abs()
        };
        seconds * self.speed / self.unit
    }

    /// Time from the angle 0 to `s`: a sum over the pieces of the curve.
    fn time(&self, s: f64, is_compression: bool) -> f64 {
        let mut from = FRAC_PI_2 - s;
        let corners = self.curve.corners(0.0, self.depth * s.sin()).rev();
        let ends = corners.map(|x| (x / self.depth).acos()).chain([FRAC_PI_2]);
        let piece = |end: f64| {
            let start = std::mem::replace(&mut from, end);
            from_singular_end(end - start, |more| self.time_rate(start + more, is_compression))
        };
        ends.map(piece).sum()
    }
}

impl Trajectory for OnCurve<'_> {
    fn loss(&self) -> f64 {
        self.solution.loss()
    }

    fn restitution(&self) -> f64 {
        self.solution.restitution()
    }

    fn compression(&self) -> f64 {
        FRAC_PI_2
    }

    fn expansion(&self) -> f64 {
        FRAC_PI_2
    }

    fn ends(&self) -> bool {
        true
    }

    fn max_penetration(&self) -> f64 {
        self.depth / self.unit
    }

    /// Largest of the forces at the ends of the parts and at the maximum within a part, where k m̄ w = d² F_s², k the slope of the curve.
    /// The left side falls and the right side rises over a line with k > 0; a line with k ≤ 0 has no maximum inside. The parts of a sum of
    /// powers are so short that a part has at most one maximum.
    fn peak(&self) -> (f64, f64) {
        let force = |x: f64| self.curve.at(x).0 * self.log(self.depth - x, true).exp();
        let mut best = (0.0, force(0.0));
        let mut from = 0.0;
        for to in self.curve.parts(self.depth) {
            let rises = |x: f64| {
                let (force, slope) = self.curve.at(x);
                let scaled = self.dissipation * force;
                slope * self.mass * self.log(self.depth - x, true).exp_m1() > scaled * scaled
            };
            let (mut low, mut high) = (from, to);
            for _ in 0..limits::MAX_ITERATIONS {
                let middle = 0.5 * (low + high);
                *(if rises(middle) { &mut low } else { &mut high }) = middle;
            }
            for x in [low, to] {
                let here = force(x);
                best = if here > best.1 { (x, here) } else { best };
            }
            from = to;
        }
        ((best.0 / self.depth).min(1.0).asin(), best.1 / self.force_unit())
    }

    fn after_touch(&self, s: f64) -> State {
        self.state(s, true)
    }

    fn before_end(&self, s: f64) -> State {
        self.state(s, false)
    }

    fn singularities(&self) -> [f64; 2] {
        [0.0; 2]
    }

    fn time_rate_after_touch(&self, s: f64) -> f64 {
        self.time_rate(FRAC_PI_2 - s, true)
    }

    fn time_rate_before_end(&self, s: f64) -> f64 {
        self.time_rate(FRAC_PI_2 - s, false)
    }

    fn time_after_touch(&self, s: f64) -> f64 {
        self.time(s, true)
    }

    fn time_before_end(&self, s: f64) -> f64 {
        self.time(s, false)
    }
}
