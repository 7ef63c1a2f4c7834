//! Points of a search for extremes, and the quasi-Newton update.

use nalgebra::Vector3;

/// Relative difference of values that is rounding.
const SAME_TO_ROUNDING: f64 = 1e-13;
/// Distance from a limit, relative to the range, at which the limit is active.
pub(super) const AT_LIMIT: f64 = 1e-9;

/// Point of a search.
#[derive(Clone, Debug)]
pub(super) struct Point {
    /// Positions as parts of their ranges.
    pub unit: Vec<f64>,
    /// 1/m̄, 1/kg; for an inertia its reciprocal; for a bearing the square of the impulse per closing speed, kg².
    pub inverse_mass: f64,
    /// Function to be minimised: plus or minus `inverse_mass`.
    pub value: f64,
    /// Its gradient over the ranges.
    pub gradient: Vec<f64>,
    /// Normal, world axes; `None` for that of the contact.
    pub normal_world: Option<Vector3<f64>>,
    /// Largest component of the projected gradient.
    pub residual: f64,
}

impl Point {
    /// Creates a point. `slopes`: gradient of the measure `inverse_mass`; `sign`: sign of the measure in the function to be minimised.
    /// The residual ignores kept points; a search with kept points replaces it.
    pub fn new(
        unit: Vec<f64>,
        inverse_mass: f64,
        sign: f64,
        slopes: &[f64],
        normal_world: Option<Vector3<f64>>,
    ) -> Self {
        let gradient: Vec<f64> = slopes.iter().map(|slope| sign * slope).collect();
        let component = |k: usize| {
            let blocked = (unit[k] <= AT_LIMIT && gradient[k] > 0.0)
                || (unit[k] >= 1.0 - AT_LIMIT && gradient[k] < 0.0);
            if blocked { 0.0 } else { gradient[k].abs() }
        };
        let residual = (0..unit.len()).map(component).fold(0.0, f64::max);
        Self { unit, inverse_mass, value: sign * inverse_mass, gradient, normal_world, residual }
    }

    /// True if another point has the same value to rounding.
    pub fn has_value_of(&self, other: &Self) -> bool {
        (other.value - self.value).abs() <= SAME_TO_ROUNDING * self.value.abs()
    }

    /// True if another point has the same value to rounding and a smaller residual. Values locate an extreme to the square root of the
    /// rounding only; residuals locate it to the rounding.
    pub fn is_equal_but_worse_than(&self, other: &Self) -> bool {
        self.has_value_of(other) && other.residual < self.residual
    }
}

/// Identity matrix.
pub(super) fn identity(n: usize) -> Vec<Vec<f64>> {
    (0..n).map(|r| (0..n).map(|c| f64::from(u8::from(r == c))).collect()).collect()
}

/// BFGS update of the inverse Hessian. Returns false, without an update, if the curvature is not positive. `is_first`: the matrix is the
/// identity; the curvature of this step scales it before the update (Nocedal and Wright 2006, equation 6.20).
pub(super) fn update(inverse: &mut [Vec<f64>], from: &Point, to: &Point, is_first: bool) -> bool {
    let n = from.unit.len();
    let s: Vec<f64> = (0..n).map(|k| to.unit[k] - from.unit[k]).collect();
    let y: Vec<f64> = (0..n).map(|k| to.gradient[k] - from.gradient[k]).collect();
    let sy: f64 = s.iter().zip(&y).map(|(a, b)| a * b).sum();
    let size = s.iter().map(|x| x * x).sum::<f64>().sqrt() * y.iter().map(|x| x * x).sum::<f64>().sqrt();
    if sy <= 1e-10 * size {
        return false;
    }
    if is_first {
        let scale = sy / y.iter().map(|x| x * x).sum::<f64>();
        inverse.iter_mut().flatten().for_each(|entry| *entry *= scale);
    }
    let hy: Vec<f64> = (0..n).map(|r| (0..n).map(|c| inverse[r][c] * y[c]).sum()).collect();
    let yhy: f64 = y.iter().zip(&hy).map(|(a, b)| a * b).sum();
    for r in 0..n {
        for c in 0..n {
            inverse[r][c] += (1.0 + yhy / sy) * s[r] * s[c] / sy - (hy[r] * s[c] + s[r] * hy[c]) / sy;
        }
    }
    true
}
