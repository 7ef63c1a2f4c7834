//! Ordinary differential equations by the predictor and corrector of Adams, Bashforth and Moulton.

use crate::numerics::extrapolation::controlled_step;
use std::collections::VecDeque;

/// Number of rates in the formulas, which is their order.
const ORDER: usize = 8;

/// Integrals from 0 to 1 of the polynomials of Lagrange through 0, −1, …, −7.
const PREDICTOR: [f64; ORDER] = [
    16083.0 / 4480.0,
    -1_152_169.0 / 120_960.0,
    242_653.0 / 13_440.0,
    -296_053.0 / 13_440.0,
    2_102_243.0 / 120_960.0,
    -115_747.0 / 13_440.0,
    32_863.0 / 13_440.0,
    -5257.0 / 17_280.0,
];

/// Integrals from 0 to 1 of the polynomials of Lagrange through 1, 0, …, −6.
const CORRECTOR: [f64; ORDER] = [
    5257.0 / 17_280.0,
    139_849.0 / 120_960.0,
    -4511.0 / 4480.0,
    123_133.0 / 120_960.0,
    -88_547.0 / 120_960.0,
    1537.0 / 4480.0,
    -11_351.0 / 120_960.0,
    275.0 / 24_192.0,
];

/// Error of the corrector per difference of both results: 33953/(1070017 + 33953), the ratio of the error constants.
const ERROR_PER_DIFFERENCE: f64 = 33_953.0 / (1_070_017.0 + 33_953.0);

/// Integrator of y′ = f(y) with steps of at most `largest`.
///
/// Extrapolation takes the first steps, and all steps near a force that is not smooth. Once eight rates at the distance `largest` are
/// known, a step takes two evaluations of f instead of more than ten. Source: Hairer, Nørsett and Wanner 1993, §III.1.
pub(crate) struct MultistepIntegrator {
    largest: f64,
    tolerance: f64,
    proposal: f64,
    /// Rates at the state and at the states before, the newest first; at distances `largest`.
    rates: VecDeque<Vec<f64>>,
}

impl MultistepIntegrator {
    /// Integrator from a state, with the rates there. `tolerance`: error of a step relative to `1 + |y|`.
    pub fn new(rate: Vec<f64>, largest: f64, tolerance: f64) -> Self {
        Self { largest, tolerance, proposal: largest, rates: VecDeque::from([rate]) }
    }

    /// Rates at the last state.
    pub fn rate(&self) -> &[f64] {
        self.rates.front().map_or(&[], Vec::as_slice)
    }

    /// Next state, and the length of the step.
    pub fn advance(&mut self, f: &impl Fn(&[f64], &mut [f64]), y: &[f64]) -> (Vec<f64>, f64) {
        if let Some(next) = self.adams_step(f, y) {
            return (next, self.largest);
        }
        let h = self.proposal.min(self.largest);
        let (next, taken, proposal) = controlled_step(f, y, h, self.tolerance);
        self.proposal = proposal;
        if taken < self.largest {
            self.rates.clear();
        }
        self.push_rate(f, &next);
        (next, taken)
    }

    /// State after a step of both formulas; `None` with too few rates or above the tolerance.
    fn adams_step(&mut self, f: &impl Fn(&[f64], &mut [f64]), y: &[f64]) -> Option<Vec<f64>> {
        if self.rates.len() < ORDER {
            return None;
        }
        let weighted = |weights: &[f64], i: usize| -> f64 {
            weights.iter().zip(&self.rates).map(|(w, rate)| w * rate[i]).sum()
        };
        let predicted: Vec<f64> =
            y.iter().enumerate().map(|(i, y)| y + self.largest * weighted(&PREDICTOR, i)).collect();
        let mut rate = vec![0.0; y.len()];
        f(&predicted, &mut rate);
        let corrected = |(i, y): (usize, &f64)| {
            y + self.largest * (CORRECTOR[0] * rate[i] + weighted(&CORRECTOR[1..], i))
        };
        let next: Vec<f64> = y.iter().enumerate().map(corrected).collect();
        let error = |(a, b): (&f64, &f64)| ERROR_PER_DIFFERENCE * (a - b).abs() / (1.0 + a.abs());
        // A rate that is not finite gives no step.
        if !next.iter().zip(&predicted).map(error).all(|error| error <= self.tolerance) {
            return None;
        }
        self.push_rate(f, &next);
        Some(next)
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

    /// Steps of 0.03 have errors of 0.01 · 0.03⁹, and there are 700 of them.
    #[test]
    fn an_oscillator_keeps_its_circle_with_two_evaluations_per_step() {
        let count = std::cell::Cell::new(0);
        let f = |y: &[f64], r: &mut [f64]| {
            count.set(count.get() + 1);
            r[0] = y[1];
            r[1] = -y[0];
        };
        let mut integrator = MultistepIntegrator::new(vec![1.0, 0.0], 0.03, 1e-12);
        let (mut y, mut t, mut steps) = (vec![0.0, 1.0], 0.0_f64, 0);
        while t < 20.0 {
            let (next, taken) = integrator.advance(&f, &y);
            (y, t, steps) = (next, t + taken, steps + 1);
        }
        assert!((y[0] - t.sin()).abs() < 1e-12 && (y[1] - t.cos()).abs() < 1e-12, "{y:?}");
        assert!(count.get() < 2 * steps + 200, "{} for {steps}", count.get());
    }

    /// A force with a corner: the steps across it are shortened.
    #[test]
    fn a_corner_is_resolved() {
        let f = |y: &[f64], r: &mut [f64]| {
            r[0] = 1.0;
            r[1] = (y[0] - 0.5).max(0.0);
        };
        let mut integrator = MultistepIntegrator::new(vec![1.0, 0.0], 0.03, 1e-12);
        let (mut y, mut t) = (vec![0.0, 0.0], 0.0_f64);
        while t < 1.0 {
            let (next, taken) = integrator.advance(&f, &y);
            (y, t) = (next, t + taken);
        }
        assert!((y[1] - 0.5 * (t - 0.5).powi(2)).abs() < 1e-10, "{y:?} {t}");
    }
}
