//! Least coefficient of friction of sticking contacts, over the impulses that redundant contacts leave open.

use crate::tolerances::{MOST_FRICTION, OPEN_IMPULSES, OPEN_PER_IMPULSE, PULLING};
use nalgebra::{DMatrix, DVector};

/// Least coefficient of friction μ for which a z exists with |p_t| ≤ μ p_n at all given contacts, P = P₀ + Z z. `None` if for every z a
/// contact pulls or needs more than [`MOST_FRICTION`].
///
/// `given`: P₀, 3k: normal component and two tangential ones for each contact. `open`: Z, 3k×d with orthonormal columns.
///
/// max |p_t|/p_n is a quasi-convex function of z where all p_n are positive. The ellipsoid method encloses its minimum: each cut removes
/// the half in which the worst contact pulls or needs more friction (Bland, Goldfarb and Todd 1981). Open impulses are at most
/// [`OPEN_IMPULSES`] times the given ones.
pub(crate) fn least_friction(given: &DVector<f64>, open: &DMatrix<f64>, contacts: &[usize]) -> Option<f64> {
    let size = given.amax();
    if size == 0.0 {
        return Some(0.0);
    }
    // In one dimension the formulas of the ellipsoid are not defined: a second direction without effect is added.
    let dimension = if open.ncols() == 0 { 0 } else { open.ncols().max(2) };
    let open = open.clone().resize_horizontally(dimension, 0.0);
    let d = dimension as f64;
    let mut z = DVector::zeros(dimension);
    let mut ellipsoid = DMatrix::identity(dimension, dimension) * (OPEN_IMPULSES * size).powi(2);
    let mut best: Option<f64> = None;
    let steps = (STEPS_PER_DIMENSION * d * (d + 1.0)) as usize;
    for _ in 0..=steps {
        let impulses = given + &open * &z;
        let (ratio, gradient) = worst_contact(&impulses, &open, contacts, PULLING * size);
        if let Some(ratio) = ratio {
            best = Some(best.map_or(ratio, |best: f64| best.min(ratio)));
        }
        let along = &ellipsoid * &gradient;
        let width = gradient.dot(&along);
        if ratio == Some(0.0) || width.is_nan() || width <= (OPEN_PER_IMPULSE * size).powi(2) {
            break;
        }
        let step = along / width.sqrt();
        z -= &step / (d + 1.0);
        ellipsoid = (ellipsoid - &step * step.transpose() * (2.0 / (d + 1.0))) * (d * d / (d * d - 1.0));
    }
    best.filter(|friction| *friction <= MOST_FRICTION)
}

/// Steps of the ellipsoid method per d (d+1): each step reduces the mean axis by the factor e^(−1/(2 d (d+1))), so that 70 of them reduce
/// it by e^−35, from [`OPEN_IMPULSES`] to rounding.
const STEPS_PER_DIMENSION: f64 = 70.0;

/// Largest ratio |p_t|/p_n with the gradient of |p_t| − ratio p_n over z; no ratio, and the gradient of −p_n, if a contact pulls.
fn worst_contact(
    impulses: &DVector<f64>,
    open: &DMatrix<f64>,
    contacts: &[usize],
    rounding: f64,
) -> (Option<f64>, DVector<f64>) {
    let row = |row: usize| open.row(row).transpose();
    let least = contacts.iter().copied().min_by(|a, b| impulses[3 * a].total_cmp(&impulses[3 * b]));
    if let Some(i) = least.filter(|i| impulses[3 * i] <= -rounding) {
        return (None, -row(3 * i));
    }
    let (mut worst, mut gradient) = (0.0, DVector::zeros(open.ncols()));
    for i in contacts.iter().copied() {
        let (t1, t2) = (impulses[3 * i + 1], impulses[3 * i + 2]);
        let tangential = t1.hypot(t2);
        if tangential <= rounding {
            continue;
        }
        let ratio = tangential / (impulses[3 * i] + rounding);
        if ratio > worst {
            worst = ratio;
            gradient = (row(3 * i + 1) * t1 + row(3 * i + 2) * t2) / tangential - row(3 * i) * ratio;
        }
    }
    (Some(worst), gradient)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Feet of a body on a line along t₁: a normal impulse N, a tangential impulse T, and open opposite tangential impulses. The least
    /// coefficient is T/N for each split of N. With open normal impulses too it is the same; a normal impulse below zero has none.
    #[test]
    fn the_least_friction_of_two_feet_is_that_of_their_sum() {
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let tangents = DMatrix::from_column_slice(6, 1, &[0.0, half, 0.0, 0.0, -half, 0.0]);
        let both = DMatrix::from_column_slice(
            6,
            2,
            &[0.0, half, 0.0, 0.0, -half, 0.0, half, 0.0, 0.0, -half, 0.0, 0.0],
        );
        for (first, second, tangential) in [(1.0, 1.0, 0.5), (0.2, 3.0, 2.0), (4.0, 0.01, 0.1)] {
            let given = DVector::from_vec(vec![first, tangential, 0.0, second, 0.0, 0.0]);
            let expected = tangential / (first + second);
            for open in [&tangents, &both] {
                let found = least_friction(&given, open, &[0, 1]).expect("a coefficient");
                assert!((found - expected).abs() < 1e-5 * (1.0 + expected), "{found} {expected}");
            }
            let none = DMatrix::zeros(6, 0);
            let alone = least_friction(&given, &none, &[0, 1]).expect("a coefficient");
            assert!((alone - tangential / first).abs() < 1e-5 * (1.0 + alone), "{alone}");
        }
        let pulls = DVector::from_vec(vec![1.0, 0.0, 0.0, -1.5, 0.0, 0.0]);
        assert_eq!(least_friction(&pulls, &both, &[0, 1]), None);
        assert_eq!(least_friction(&pulls, &tangents, &[0, 1]), None);
        // A tangential impulse without a normal one.
        let sideways = DVector::from_vec(vec![0.0, 1.0, 0.0, 1.0, 0.0, 0.0]);
        assert_eq!(least_friction(&sideways, &DMatrix::zeros(6, 0), &[0, 1]), None);
    }
}
