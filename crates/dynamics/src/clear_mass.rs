//! What mechanisms that are answered in lanes share: positions by columns, and an answer that rounding leaves no doubt of.

use crate::tolerances::{ROUTE_ROUNDINGS, TRUSTED_ERROR};
use nalgebra::Matrix3;
use percuss_spatial::SpatialInertia;
use percuss_spatial::lanes::Lanes;

/// The widest lanes.
pub(crate) const WIDEST: usize = 8;

/// A finite m̄ that rounding leaves no doubt of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ClearMass {
    /// m̄, kg.
    pub mass: f64,
    /// What rounding may amount to, kg.
    pub error: f64,
}

impl ClearMass {
    /// Where so many roundings of its terms leave the response (1/kg) whole.
    pub fn of(response: f64, terms: f64, loss: f64) -> Option<Self> {
        Self::within(response, ROUTE_ROUNDINGS.max(loss) * terms)
    }

    /// Where so many ε, 1/kg, leave the response whole.
    pub fn within(response: f64, error: f64) -> Option<Self> {
        let relative = f64::EPSILON * error / response;
        let mass = 1.0 / response;
        // NaN is not small.
        (response > 0.0 && relative <= TRUSTED_ERROR).then_some(Self { mass, error: relative * mass })
    }
}

/// Positions by columns: that of configuration `c` and position `q` stands at `q · stride + c`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Columns<'a> {
    pub values: &'a [f64],
    pub stride: usize,
}

impl Columns<'_> {
    #[inline(always)]
    pub fn at<T: Lanes>(&self, q: usize, first: usize) -> T {
        T::load(&self.values[q * self.stride + first..])
    }
}

/// Whether no motion has a negative energy, to rounding.
pub(crate) fn is_positive(inertia: &SpatialInertia<f64>) -> bool {
    if inertia.mass <= 0.0 {
        return inertia.mass == 0.0 && inertia.first_moment.norm() == 0.0 && inertia.rotational.norm() == 0.0;
    }
    let h = inertia.first_moment;
    let steiner = (Matrix3::identity() * h.norm_squared() - h * h.transpose()) / inertia.mass;
    let least = (inertia.rotational - steiner).symmetric_eigenvalues().min();
    least >= -f64::EPSILON * 16.0 * inertia.rotational.norm()
}
