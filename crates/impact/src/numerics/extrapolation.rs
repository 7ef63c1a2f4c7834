//! Ordinary differential equations by extrapolation of the modified midpoint rule (Gragg, Bulirsch and Stoer).

/// Largest number of midpoint sequences: 2, 4, …, 2 · SEQUENCES substeps.
const SEQUENCES: usize = 8;

/// Smallest step, relative to one.
const LEAST_STEP: f64 = 1e-14;

/// One step of y′ = f(y) of length `h`. Returns the state and the estimated error of its components, relative to
/// `1 + |y|`.
///
/// The midpoint results with n = 2, 4, … substeps have an expansion in even powers of h/n, which the polynomial of Neville
/// extrapolates to n → ∞. Source: Hairer, Nørsett and Wanner 1993, §II.9.
pub(crate) fn step(f: &impl Fn(&[f64], &mut [f64]), y: &[f64], h: f64, tolerance: f64) -> (Vec<f64>, f64) {
    let dimension = y.len();
    let mut table: Vec<Vec<f64>> = Vec::new();
    let (mut rate, mut start) = (vec![0.0; dimension], vec![0.0; dimension]);
    f(y, &mut start);
    let mut error = f64::INFINITY;
    for sequence in 0..SEQUENCES {
        let count = 2 * (sequence + 1);
        let small = h / count as f64;
        let mut before = y.to_vec();
        let mut now: Vec<f64> = y.iter().zip(&start).map(|(y, r)| y + small * r).collect();
        for _ in 1..count {
            f(&now, &mut rate);
            for i in 0..dimension {
                let next = before[i] + 2.0 * small * rate[i];
                before[i] = now[i];
                now[i] = next;
            }
        }
        f(&now, &mut rate);
        let mut row: Vec<f64> =
            (0..dimension).map(|i| 0.5 * (now[i] + before[i] + small * rate[i])).collect();
        // table[k]: extrapolation of order k from the previous sequences.
        for k in 0..sequence {
            let ratio = count as f64 / (2.0 * (sequence - k) as f64);
            let factor = 1.0 / (ratio * ratio - 1.0);
            let previous = std::mem::replace(&mut table[k], row.clone());
            row = (0..dimension).map(|i| row[i] + (row[i] - previous[i]) * factor).collect();
        }
        if sequence > 0 {
            let lower = &table[sequence - 1];
            let difference = |i: usize| (row[i] - lower[i]).abs() / (1.0 + row[i].abs());
            error = (0..dimension).map(difference).fold(0.0, f64::max);
        }
        table.push(row);
        if error <= tolerance {
            break;
        }
    }
    (table.pop().unwrap_or_else(|| y.to_vec()), error)
}

/// Step of at most `h`, shortened until the error is at most `tolerance`. Returns the state, the length of the step and
/// a proposal for the next one. The last step tried is returned if it cannot be shortened any more.
pub(crate) fn controlled_step(
    f: &impl Fn(&[f64], &mut [f64]),
    y: &[f64],
    h: f64,
    tolerance: f64,
) -> (Vec<f64>, f64, f64) {
    let mut h = h;
    loop {
        let (next, error) = step(f, y, h, tolerance);
        if error <= tolerance {
            return (next, h, 1.5 * h);
        }
        if h <= LEAST_STEP {
            return (next, h, h);
        }
        h *= 0.5;
    }
}

/// State at the distance `h` after `y`, by as many steps as the tolerance requires: one where f is smooth.
pub(crate) fn state_after(f: &impl Fn(&[f64], &mut [f64]), y: &[f64], h: f64, tolerance: f64) -> Vec<f64> {
    let (mut state, mut left, mut proposal) = (y.to_vec(), h, h);
    loop {
        let (next, taken, longer) = controlled_step(f, &state, proposal.min(left), tolerance);
        if taken >= left {
            return next;
        }
        if taken <= LEAST_STEP {
            return step(f, &state, left, tolerance).0;
        }
        (state, left, proposal) = (next, left - taken, longer);
    }
}

#[cfg(test)]
mod tests {
    use super::{controlled_step, state_after};

    /// y″ = −y − c max(0, y − ½): the coarse sequences of a long step pass the kink before the solution, or not.
    #[test]
    fn states_near_a_kink_have_the_error_of_a_step() {
        let f = |y: &[f64], r: &mut [f64]| {
            r[0] = y[1];
            r[1] = -y[0] - 300.0 * (y[0] - 0.5).max(0.0);
        };
        // The kink is at t = π/6; the solution after it is an oscillation about 0.5 · 300/301 with the frequency √301.
        let kink = std::f64::consts::FRAC_PI_6;
        for t in [0.4, 0.5, 0.52, 0.53, 0.56, 0.6] {
            let found = state_after(&f, &[0.0, 1.0], t, 1e-12);
            let (centre, w) = (150.0 / 301.0, 301.0_f64.sqrt());
            let (s, c) = (w * (t - kink)).sin_cos();
            let exact = match t < kink {
                true => t.sin(),
                false => centre + (0.5 - centre) * c + kink.cos() / w * s,
            };
            assert!((found[0] - exact).abs() < 1e-10, "{t}: {} {exact}", found[0]);
        }
    }

    #[test]
    fn an_oscillator_keeps_its_circle() {
        let f = |y: &[f64], r: &mut [f64]| {
            r[0] = y[1];
            r[1] = -y[0];
        };
        let (mut y, mut t, mut h) = (vec![0.0, 1.0], 0.0_f64, 0.1_f64);
        while t < 20.0 {
            let (next, taken, proposal) = controlled_step(&f, &y, h.min(20.0 - t).max(1e-13), 1e-14);
            (y, t, h) = (next, t + taken, proposal);
        }
        assert!((y[0] - t.sin()).abs() < 1e-12 && (y[1] - t.cos()).abs() < 1e-12, "{y:?}");
    }
}
