//! Runge-Kutta step of order 8 with eleven stages.

/// √21.
const S: f64 = 4.582_575_694_955_84;

/// Coefficients of the stages after the first, row by row. Source: Cooper and Verner 1972.
const ROWS: [&[f64]; 10] = [
    &[0.5],
    &[0.25, 0.25],
    &[1.0 / 7.0, (-7.0 - 3.0 * S) / 98.0, (21.0 + 5.0 * S) / 49.0],
    &[(11.0 + S) / 84.0, 0.0, (18.0 + 4.0 * S) / 63.0, (21.0 - S) / 252.0],
    &[(5.0 + S) / 48.0, 0.0, (9.0 + S) / 36.0, (-231.0 + 14.0 * S) / 360.0, (63.0 - 7.0 * S) / 80.0],
    &[
        (10.0 - S) / 42.0,
        0.0,
        (-432.0 + 92.0 * S) / 315.0,
        (633.0 - 145.0 * S) / 90.0,
        (-504.0 + 115.0 * S) / 70.0,
        (63.0 - 13.0 * S) / 35.0,
    ],
    &[1.0 / 14.0, 0.0, 0.0, 0.0, (14.0 - 3.0 * S) / 126.0, (13.0 - 3.0 * S) / 63.0, 1.0 / 9.0],
    &[
        1.0 / 32.0,
        0.0,
        0.0,
        0.0,
        (91.0 - 21.0 * S) / 576.0,
        11.0 / 72.0,
        (-385.0 - 75.0 * S) / 1152.0,
        (63.0 + 13.0 * S) / 128.0,
    ],
    &[
        1.0 / 14.0,
        0.0,
        0.0,
        0.0,
        1.0 / 9.0,
        (-733.0 - 147.0 * S) / 2205.0,
        (515.0 + 111.0 * S) / 504.0,
        (-51.0 - 11.0 * S) / 56.0,
        (132.0 + 28.0 * S) / 245.0,
    ],
    &[
        0.0,
        0.0,
        0.0,
        0.0,
        (-42.0 + 7.0 * S) / 18.0,
        (-18.0 + 28.0 * S) / 45.0,
        (-273.0 - 53.0 * S) / 72.0,
        (301.0 + 53.0 * S) / 72.0,
        (28.0 - 28.0 * S) / 45.0,
        (49.0 - 7.0 * S) / 18.0,
    ],
];

/// Weights of the stages.
const WEIGHTS: [f64; 11] =
    [0.05, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 49.0 / 180.0, 16.0 / 45.0, 49.0 / 180.0, 0.05];

/// Returns the state after one step of length `h` of y′ = f(y). `rate`: f(y). The local error is of order h⁹. The last evaluation of f is
/// at an approximation of the result, so a condition that f records there holds for the end of the step.
pub(crate) fn step(f: &impl Fn(&[f64], &mut [f64]), y: &[f64], rate: &[f64], h: f64) -> Vec<f64> {
    let mut rates = vec![rate.to_vec()];
    let mut state = vec![0.0; y.len()];
    for row in ROWS {
        for (i, state) in state.iter_mut().enumerate() {
            *state = y[i] + h * row.iter().zip(&rates).map(|(a, rate)| a * rate[i]).sum::<f64>();
        }
        let mut next = vec![0.0; y.len()];
        f(&state, &mut next);
        rates.push(next);
    }
    let sum = |i: usize| WEIGHTS.iter().zip(&rates).map(|(b, rate)| b * rate[i]).sum::<f64>();
    y.iter().enumerate().map(|(i, y)| y + h * sum(i)).collect()
}

#[cfg(test)]
mod tests {
    use super::{ROWS, S, WEIGHTS, step};

    /// Halving the step divides the error over a fixed time by about 2⁸ (asserted: 2^7.8 to 2^9.5). The row sums equal the nodes.
    #[test]
    fn the_order_is_eight() {
        assert_eq!(S, 21.0_f64.sqrt());
        let nodes = [
            0.5,
            0.5,
            (7.0 + S) / 14.0,
            (7.0 + S) / 14.0,
            0.5,
            (7.0 - S) / 14.0,
            (7.0 - S) / 14.0,
            0.5,
            (7.0 + S) / 14.0,
            1.0,
        ];
        for (row, node) in ROWS.iter().zip(nodes) {
            assert!((row.iter().sum::<f64>() - node).abs() < 1e-14);
        }
        assert!((WEIGHTS.iter().sum::<f64>() - 1.0).abs() < 1e-15);
        // Pendulum of large amplitude: y″ = −sin y; its energy ½ y′² − cos y is constant.
        let f = |y: &[f64], r: &mut [f64]| {
            r[0] = y[1];
            r[1] = -y[0].sin();
        };
        let end = |count: usize| {
            let (mut y, h) = (vec![2.5, 0.0], 4.0 / count as f64);
            for _ in 0..count {
                let mut rate = vec![0.0; 2];
                f(&y, &mut rate);
                y = step(&f, &y, &rate, h);
            }
            y
        };
        let exact = end(400);
        let error = |count: usize| {
            let y = end(count);
            (y[0] - exact[0]).abs().max((y[1] - exact[1]).abs())
        };
        let order = (error(10) / error(20)).log2();
        assert!((7.8..9.5).contains(&order), "{order} {} {}", error(10), error(20));
    }
}
