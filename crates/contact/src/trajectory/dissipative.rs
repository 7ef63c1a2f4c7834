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
    /// Dissipation number a.
    dissipation_number: f64,
    exponent: f64,
    /// e a, the dimensionless rebound speed.
    end: f64,
    solution: Solution,
    /// Decrease of λ during compression: λ at the touch, > 0.
    compression: f64,
    /// Decrease of λ during expansion: −λ at the end, > 0.
    expansion: f64,
}

impl Dissipative {
    pub(crate) fn new(dissipation_number: f64, exponent: f64) -> Self {
        let exact = Solution::from_dissipation_number(dissipation_number);
        // Smaller damping affects only 1 − e; other quantities would be 0/0.
        let dissipation_number = dissipation_number.max(limits::MIN_DISSIPATION_NUMBER);
        let solution = Solution::from_dissipation_number(dissipation_number);
        let end = dissipation_number * solution.restitution();
        let compression = dissipation_number.ln_1p();
        // 2h minus the compression, without cancellation if both are small.
        let expansion = if end < 0.5 { -(-end).ln_1p() } else { 2.0 * solution.h - compression };
        Self { dissipation_number, exponent, end, solution: exact, compression, expansion }
    }

    /// Penetration x from G(a) − G.
    fn penetration(&self, g_decrease: f64) -> f64 {
        (2.0 * (g_decrease.max(0.0) / self.dissipation_number) / self.dissipation_number)
            .powf(1.0 / (self.exponent + 1.0))
    }

    /// G(a) − G at s after the touch.
    fn g_decrease_after_touch(&self, s: f64) -> f64 {
        let share = -(-s).exp_m1();
        self.dissipation_number * share - exp_m1_minus(-s)
    }

    /// G(a) − G at s before the end.
    fn g_decrease_before_end(&self, s: f64) -> f64 {
        if self.end < 0.5 {
            self.end * s.exp_m1() - exp_m1_minus(s)
        } else if s < 1.0 {
            s - (-self.expansion).exp() * s.exp_m1()
        } else {
            // e^s may overflow, e^(s − last) does not.
            s - ((s - self.expansion).exp() - (-self.expansion).exp())
        }
    }

    /// State for G(a) − G = `g_decrease` and λ = `log`.
    fn state(&self, g_decrease: f64, log: f64) -> State {
        let penetration = self.penetration(g_decrease);
        State {
            penetration,
            rate: log.exp_m1() / self.dissipation_number,
            force: penetration.powf(self.exponent) * log.exp(),
        }
    }

    /// dt/ds at G(a) − G = `g_decrease`.
    fn time_rate(&self, g_decrease: f64) -> f64 {
        2.0 / (self.exponent + 1.0) / self.dissipation_number
            * self.penetration(g_decrease).powf(-self.exponent)
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
        self.compression
    }

    fn expansion(&self) -> f64 {
        self.expansion
    }

    fn ends(&self) -> bool {
        true
    }

    fn max_penetration(&self) -> f64 {
        self.penetration(exp_m1_minus(self.compression))
    }

    /// Solves for the largest force, G(a) − G = p/(p+1) w, that is κ w − ln(1 + w) = G(a) with κ = (2p+1)/(p+1). The
    /// left side is convex in λ, and Newton's steps approach the root from above.
    fn peak(&self) -> (f64, f64) {
        let share = self.exponent / (self.exponent + 1.0);
        let g_decrease = exp_m1_minus(self.compression);
        let quadratic =
            2.0 * g_decrease / (share + (share * share + 2.0 * (1.0 + share) * g_decrease).sqrt());
        let mut log = quadratic.min(self.compression);
        for _ in 0..limits::MAX_ITERATIONS {
            let excess = share * log.exp_m1() + exp_m1_minus(log) - g_decrease;
            let next = log - excess / ((1.0 + share) * log.exp_m1() + share);
            let converged = (next - log).abs() <= limits::CONVERGED * log;
            log = next;
            if converged {
                break;
            }
        }
        let penetration = self.penetration(share * log.exp_m1());
        (self.compression - log, penetration.powf(self.exponent) * log.exp())
    }

    fn after_touch(&self, s: f64) -> State {
        self.state(self.g_decrease_after_touch(s), self.compression - s)
    }

    fn before_end(&self, s: f64) -> State {
        self.state(self.g_decrease_before_end(s), s - self.expansion)
    }

    fn singularities(&self) -> [f64; 2] {
        [self.exponent / (self.exponent + 1.0); 2]
    }

    fn time_rate_after_touch(&self, s: f64) -> f64 {
        self.time_rate(self.g_decrease_after_touch(s))
    }

    fn time_rate_before_end(&self, s: f64) -> f64 {
        self.time_rate(self.g_decrease_before_end(s))
    }
}

/// e^x − 1 − x, without loss of digits near 0.
pub(super) fn exp_m1_minus(x: f64) -> f64 {
    if x.abs() > 0.5 {
        return x.exp_m1() - x;
    }
    // x²/2 (1 + x/3 (1 + x/4 (1 + …))): 15 factors reach 1e-17 at x = 1/2.
    let tail = (3..=17).rev().fold(1.0, |below, n| 1.0 + x / f64::from(n) * below);
    0.5 * x * x * tail
}
