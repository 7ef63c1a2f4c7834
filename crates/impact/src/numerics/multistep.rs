//! Ordinary differential equations by the predictor and corrector of Adams, Bashforth and Moulton.

use crate::numerics::extrapolation::controlled_step;
use crate::numerics::runge_kutta;
use std::collections::VecDeque;

/// Number of rates in the formulas, which is their order.
const ORDER: usize = 10;

/// Error of the corrector divided by the difference of predictor and corrector, from the error constants 26842253/95800320 of the
/// predictor and 3250433/479001600 of the corrector.
const ERROR_PER_DIFFERENCE: f64 = 3_250_433.0 / (5.0 * 26_842_253.0 + 3_250_433.0);

/// Positive points of the Gauss–Legendre quadrature on −1 to 1, with their weights; the opposite points have the same weights. The
/// quadrature is exact up to degree 15.
const GAUSS: [(f64, f64); 4] = [
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_3),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_5),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_3),
];

/// Outcome of a step with predictor and corrector: the next state; the predicted state is beyond the end; too few rates, or an error
/// above the tolerance.
enum AdamsStep {
    Taken(Vec<f64>),
    Ends,
    Refused,
}

/// Integrals from 0 to `end` of the Lagrange basis polynomials of the nodes `newest`, `newest` − 1, …; lengths in steps.
fn lagrange_integrals(end: f64, newest: f64) -> [f64; ORDER] {
    let points = GAUSS.iter().flat_map(|&(x, w)| [(-x, w), (x, w)]);
    let mut integrals = [0.0; ORDER];
    for (x, weight) in points {
        let x = 0.5 * end * (1.0 + x);
        for (i, integral) in integrals.iter_mut().enumerate() {
            let factor = |j: usize| (x - newest + j as f64) / (j as f64 - i as f64);
            *integral += 0.5 * end * weight * (0..ORDER).filter(|j| *j != i).map(factor).product::<f64>();
        }
    }
    integrals
}

/// Integrator of y′ = f(y) with steps of at most `largest`.
///
/// The first step, and all steps near a point at which f is not smooth, use extrapolation. A Runge-Kutta step of order 8 repeats an
/// extrapolated step; if the results agree, Runge-Kutta steps follow, with eleven evaluations of f each. Once ten rates at equal distances
/// `largest` are known, a step of predictor and corrector needs two evaluations of f. Source: Hairer, Nørsett and Wanner 1993, §III.1.
pub(crate) struct MultistepIntegrator {
    largest: f64,
    tolerance: f64,
    proposal: f64,
    /// True if the last extrapolated step agrees with a Runge-Kutta step: Runge-Kutta steps follow.
    is_smooth: bool,
    has_kinks: bool,
    /// Weights of the rates at 0, −1, … steps from the state.
    predictor: [f64; ORDER],
    /// Weights of the rates at 1, 0, −1, … steps from the state.
    corrector: [f64; ORDER],
    /// Rates y′ at the last states, the newest first, at equal distances `largest`.
    rates: VecDeque<Vec<f64>>,
}

impl MultistepIntegrator {
    /// Integrator from a state with the rates `rate`. `tolerance`: largest error of a step, relative to `1 + |y|`.
    pub fn new(rate: Vec<f64>, largest: f64, tolerance: f64) -> Self {
        Self {
            largest,
            tolerance,
            proposal: largest,
            is_smooth: false,
            has_kinks: false,
            predictor: lagrange_integrals(1.0, 0.0),
            corrector: lagrange_integrals(1.0, 1.0),
            rates: VecDeque::from([rate]),
        }
    }

    /// Same integrator for rates with kinks: no step is taken without an estimate of its error.
    pub fn with_kinks(self, has_kinks: bool) -> Self {
        Self { has_kinks, ..self }
    }

    /// Rates at the last state.
    pub fn rate(&self) -> &[f64] {
        self.rates.front().map_or(&[], Vec::as_slice)
    }

    /// Next state, and the length of the step. `ends` is true if the last state at which f was evaluated is beyond the end of the
    /// integration. If the predicted state is beyond the end, no state is returned, because f need not be smooth there; the end is then
    /// within `largest` of `y` (see [`state_after`](Self::state_after)).
    pub fn advance(
        &mut self,
        f: &impl Fn(&[f64], &mut [f64]),
        y: &[f64],
        ends: &impl Fn() -> bool,
    ) -> (Option<Vec<f64>>, f64) {
        match self.adams_step(f, y, ends) {
            AdamsStep::Taken(next) => return (Some(next), self.largest),
            AdamsStep::Ends => return (None, self.largest),
            AdamsStep::Refused => {}
        }
        if self.is_smooth {
            let next = runge_kutta::step(f, y, self.rate(), self.largest);
            if !ends() {
                self.push_rate(f, &next);
                return (Some(next), self.largest);
            }
        }
        let h = self.proposal.min(self.largest);
        let (next, taken, proposal) = controlled_step(f, y, h, self.tolerance);
        self.proposal = proposal;
        self.is_smooth = !self.has_kinks && taken == self.largest && self.rates.len() < ORDER && {
            let other = runge_kutta::step(f, y, self.rate(), taken);
            let error = |(a, b): (&f64, &f64)| (a - b).abs() / (1.0 + a.abs());
            next.iter().zip(&other).map(error).all(|error| error <= self.tolerance)
        };
        if taken < self.largest {
            self.rates.clear();
        }
        self.push_rate(f, &next);
        (Some(next), taken)
    }

    /// True if the rates at the last ten states have equal distances, as [`state_after`](Self::state_after) and
    /// [`state_before`](Self::state_before) need.
    pub fn is_dense(&self) -> bool {
        self.rates.len() == ORDER
    }

    /// State at the distance `h` after the last state `y`, by the polynomial through the rates of the last states.
    pub fn state_after(&self, y: &[f64], h: f64) -> Vec<f64> {
        self.integrated(y, h, 0.0)
    }

    /// State at the distance `h` after `y`, the state before the last one.
    pub fn state_before(&self, y: &[f64], h: f64) -> Vec<f64> {
        self.integrated(y, h, 1.0)
    }

    /// y + ∫ of the polynomial through the rates over the length `h`; the newest rate is `newest` steps after y.
    fn integrated(&self, y: &[f64], h: f64, newest: f64) -> Vec<f64> {
        let weights = lagrange_integrals(h / self.largest, newest);
        let sum = |i: usize| weights.iter().zip(&self.rates).map(|(w, rate)| w * rate[i]).sum::<f64>();
        y.iter().enumerate().map(|(i, y)| y + self.largest * sum(i)).collect()
    }

    /// Step of predictor and corrector.
    fn adams_step(
        &mut self,
        f: &impl Fn(&[f64], &mut [f64]),
        y: &[f64],
        ends: &impl Fn() -> bool,
    ) -> AdamsStep {
        if self.rates.len() < ORDER {
            return AdamsStep::Refused;
        }
        self.is_smooth = false;
        let weighted = |weights: &[f64], i: usize| -> f64 {
            weights.iter().zip(&self.rates).map(|(w, rate)| w * rate[i]).sum()
        };
        let predicted: Vec<f64> =
            y.iter().enumerate().map(|(i, y)| y + self.largest * weighted(&self.predictor, i)).collect();
        let mut rate = vec![0.0; y.len()];
        f(&predicted, &mut rate);
        if ends() {
            return AdamsStep::Ends;
        }
        let corrected = |(i, y): (usize, &f64)| {
            y + self.largest * (self.corrector[0] * rate[i] + weighted(&self.corrector[1..], i))
        };
        let next: Vec<f64> = y.iter().enumerate().map(corrected).collect();
        let error = |(a, b): (&f64, &f64)| ERROR_PER_DIFFERENCE * (a - b).abs() / (1.0 + a.abs());
        // The comparison also refuses a step with NaN.
        if !next.iter().zip(&predicted).map(error).all(|error| error <= self.tolerance) {
            return AdamsStep::Refused;
        }
        self.push_rate(f, &next);
        AdamsStep::Taken(next)
    }

    fn push_rate(&mut self, f: &impl Fn(&[f64], &mut [f64]), y: &[f64]) {
        let mut rate = if self.rates.len() < ORDER { None } else { self.rates.pop_back() }
            .unwrap_or_else(|| vec![0.0; y.len()]);
        f(y, &mut rate);
        self.rates.push_front(rate);
    }
}

#[cfg(test)]
mod tests {
    use super::MultistepIntegrator;

    /// 400 steps of 0.05, each with an error of 0.007 · 0.05¹¹.
    #[test]
    fn an_oscillator_keeps_its_circle_with_two_evaluations_per_step() {
        let count = std::cell::Cell::new(0);
        let f = |y: &[f64], r: &mut [f64]| {
            count.set(count.get() + 1);
            r[0] = y[1];
            r[1] = -y[0];
        };
        let mut integrator = MultistepIntegrator::new(vec![1.0, 0.0], 0.05, 1e-12);
        let (mut y, mut t, mut steps) = (vec![0.0, 1.0], 0.0_f64, 0);
        while t < 20.0 {
            let (next, taken) = integrator.advance(&f, &y, &|| false);
            (y, t, steps) = (next.expect("a state"), t + taken, steps + 1);
        }
        assert!((y[0] - t.sin()).abs() < 1e-12 && (y[1] - t.cos()).abs() < 1e-12, "{y:?}");
        // The polynomials give the states between the last two, and beyond the last one.
        let (next, h) = integrator.advance(&f, &y, &|| false);
        let next = next.expect("a state");
        for part in [0.0, 0.3, 0.9] {
            let (before, after) =
                (integrator.state_before(&y, part * h), integrator.state_after(&next, part * h));
            assert!((before[0] - (t + part * h).sin()).abs() < 1e-12, "{part}: {before:?}");
            assert!((after[1] - (t + h + part * h).cos()).abs() < 1e-12, "{part}: {after:?}");
        }
        assert!(count.get() < 2 * steps + 250, "{} for {steps}", count.get());
    }

    /// f with a kink: the steps across the kink are shortened.
    #[test]
    fn a_corner_is_resolved() {
        let f = |y: &[f64], r: &mut [f64]| {
            r[0] = 1.0;
            r[1] = (y[0] - 0.5).max(0.0);
        };
        let mut integrator = MultistepIntegrator::new(vec![1.0, 0.0], 0.03, 1e-12);
        let (mut y, mut t) = (vec![0.0, 0.0], 0.0_f64);
        while t < 1.0 {
            let (next, taken) = integrator.advance(&f, &y, &|| false);
            (y, t) = (next.expect("a state"), t + taken);
        }
        assert!((y[1] - 0.5 * (t - 0.5).powi(2)).abs() < 1e-10, "{y:?} {t}");
    }
}
