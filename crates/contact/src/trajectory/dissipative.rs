//! Impact on a Hunt–Crossley contact with the dissipation number a = d v > 0.
//!
//! With w = d ẋ, which decreases from a to −e a, λ = ln(1 + w) and G = w − ln(1 + w) = e^λ − 1 − λ:
//! x^(p+1) = 2 (G(a) − G)/a², the force is xᵖ e^λ and dt/ds = (1 − q) x⁻ᵖ/a with q = (p−1)/(p+1), where s is the
//! decrease of λ since the touch. λ decreases by 2h in total, h the parameter of the exact solution.

use super::{State, Trajectory};
use crate::limits;
use crate::solutions::hunt_crossley::Solution;

#[derive(Clone, Copy, Debug)]
pub(crate) struct Dissipative {
    /// a.
    number: f64,
    exponent: f64,
    /// e a.
    end: f64,
    solution: Solution,
    /// λ at the touch, > 0.
    first: f64,
    /// −λ at the end, > 0.
    last: f64,
}

impl Dissipative {
    pub(crate) fn new(number: f64, exponent: f64) -> Self {
        let exact = Solution::of_number(number);
        // Smaller damping affects only 1 − e; other quantities would be 0/0.
        let number = number.max(limits::LEAST_DISSIPATION_NUMBER);
        let solution = Solution::of_number(number);
        let end = number * solution.restitution();
        let first = number.ln_1p();
        // 2h minus the compression, without cancellation if both are small.
        let last = if end < 0.5 { -(-end).ln_1p() } else { 2.0 * solution.h - first };
        Self { number, exponent, end, solution: exact, first, last }
    }

    /// Penetration x from G(a) − G.
    fn penetration(&self, fallen: f64) -> f64 {
        (2.0 * (fallen.max(0.0) / self.number) / self.number).powf(1.0 / (self.exponent + 1.0))
    }

    /// G(a) − G at s after the touch.
    fn fallen_after_touch(&self, s: f64) -> f64 {
        let share = -(-s).exp_m1();
        self.number * share - exp_m1_minus(-s)
    }

    /// G(a) − G at s before the end.
    fn fallen_before_end(&self, s: f64) -> f64 {
        if self.end < 0.5 {
            self.end * s.exp_m1() - exp_m1_minus(s)
        } else if s < 1.0 {
            s - (-self.last).exp() * s.exp_m1()
        } else {
            // e^s may overflow, e^(s − last) does not.
            s - ((s - self.last).exp() - (-self.last).exp())
        }
    }

    fn moment(&self, fallen: f64, log: f64) -> State {
        let penetration = self.penetration(fallen);
        State {
            penetration,
            rate: log.exp_m1() / self.number,
            force: penetration.powf(self.exponent) * log.exp(),
        }
    }

    fn time_rate(&self, fallen: f64) -> f64 {
        2.0 / (self.exponent + 1.0) / self.number * self.penetration(fallen).powf(-self.exponent)
    }
}

impl Trajectory for Dissipative {
    fn loss(&self) -> f64 {
        self.solution.loss()
    }

    fn restitution(&self) -> f64 {
        self.solution.restitution()
    }

    fn compression(&self) -> f64 {
        self.first
    }

    fn expansion(&self) -> f64 {
        self.last
    }

    fn ends(&self) -> bool {
        true
    }

    fn greatest_penetration(&self) -> f64 {
        self.penetration(exp_m1_minus(self.first))
    }

    /// Solves for the largest force, G(a) − G = p/(p+1) w, that is κ w − ln(1 + w) = G(a) with κ = (2p+1)/(p+1). The
    /// left side is convex in λ, and Newton's steps approach the root from above.
    fn peak(&self) -> (f64, f64) {
        let share = self.exponent / (self.exponent + 1.0);
        let fallen = exp_m1_minus(self.first);
        let quadratic = 2.0 * fallen / (share + (share * share + 2.0 * (1.0 + share) * fallen).sqrt());
        let mut log = quadratic.min(self.first);
        for _ in 0..limits::MOST_ITERATIONS {
            let excess = share * log.exp_m1() + exp_m1_minus(log) - fallen;
            let next = log - excess / ((1.0 + share) * log.exp_m1() + share);
            let settled = (next - log).abs() <= limits::CONVERGED * log;
            log = next;
            if settled {
                break;
            }
        }
        let penetration = self.penetration(share * log.exp_m1());
        (self.first - log, penetration.powf(self.exponent) * log.exp())
    }

    fn after_touch(&self, s: f64) -> State {
        self.moment(self.fallen_after_touch(s), self.first - s)
    }

    fn before_end(&self, s: f64) -> State {
        self.moment(self.fallen_before_end(s), s - self.last)
    }

    fn singularities(&self) -> [f64; 2] {
        [self.exponent / (self.exponent + 1.0); 2]
    }

    fn time_rate_after_touch(&self, s: f64) -> f64 {
        self.time_rate(self.fallen_after_touch(s))
    }

    fn time_rate_before_end(&self, s: f64) -> f64 {
        self.time_rate(self.fallen_before_end(s))
    }
}

/// e^x − 1 − x, without loss of digits near 0.
fn exp_m1_minus(x: f64) -> f64 {
    if x.abs() > 0.5 {
        return x.exp_m1() - x;
    }
    // x²/2 (1 + x/3 (1 + x/4 (1 + …))): 15 factors reach 1e-17 at x = 1/2.
    let tail = (3..=17).rev().fold(1.0, |below, n| 1.0 + x / f64::from(n) * below);
    0.5 * x * x * tail
}
