//! Positions by columns and certified results, shared by the SIMD kernels.

use crate::tolerances::UNIT_QUATERNION;
use percuss_spatial::lanes::Lanes;

/// Largest number of lanes.
pub const WIDEST: usize = 8;

/// m̄ with its rounding error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CertifiedMass {
    /// m̄, kg.
    pub mass: f64,
    /// Rounding error, kg.
    pub error: f64,
}

impl CertifiedMass {
    /// True if m̄ is finite and its relative rounding error at most `limit`. False for NaN.
    #[inline]
    pub fn is_clear(&self, limit: f64) -> bool {
        (self.mass > 0.0) & (self.mass <= f64::MAX) & (self.error <= limit * self.mass)
    }

    /// Result of `work` on one lane, if m̄ is finite and its relative error at most `limit`.
    #[inline]
    pub fn of_one(limit: f64, work: impl FnOnce(MassColumns<'_>)) -> Option<Self> {
        let (mut mass, mut error) = ([f64::NAN], [f64::NAN]);
        work(MassColumns { masses: &mut mass, errors: &mut error });
        Some(Self { mass: mass[0], error: error[0] }).filter(|mass| mass.is_clear(limit))
    }
}

/// Results of lanes, certified or not.
pub struct MassColumns<'a> {
    /// m̄, kg.
    pub masses: &'a mut [f64],
    /// Rounding errors, kg.
    pub errors: &'a mut [f64],
}

impl MassColumns<'_> {
    /// Stores m̄ and errors for the lanes from `first` on. Input: 1/m̄ (1/kg), and its error in units of ε (1/kg).
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn store<T: Lanes>(&mut self, first: usize, response: T, error: T) {
        let mass = T::one() / response;
        mass.store(&mut self.masses[first..]);
        (T::from_f64(f64::EPSILON) * error * mass * mass).store(&mut self.errors[first..]);
    }
}

/// Positions by columns: position `q` of configuration `c` has index `q · stride + c`.
#[derive(Clone, Copy, Debug)]
pub struct PositionColumns<'a> {
    /// Positions, column by column.
    pub values: &'a [f64],
    /// Number of configurations in a column.
    pub stride: usize,
}

impl PositionColumns<'_> {
    /// Loads position `q` of the configurations from `first` on, one per lane.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn at<T: Lanes>(&self, q: usize, first: usize) -> T {
        T::load(&self.values[q * self.stride + first..])
    }
}

/// Contact points and unit normals of the configurations, in the frames of a kernel: six further columns after those of the
/// positions.
#[derive(Clone, Copy, Debug)]
pub struct LaneContacts {
    /// Index of the first of the six columns.
    pub first_column: usize,
}

impl LaneContacts {
    /// Number of columns.
    pub const COUNT: usize = 6;

    /// Contact points, m.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn points<T: Lanes>(&self, columns: PositionColumns<'_>, first: usize) -> [T; 3] {
        let q = self.first_column;
        [columns.at(q, first), columns.at(q + 1, first), columns.at(q + 2, first)]
    }

    /// Unit normals.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn normals<T: Lanes>(&self, columns: PositionColumns<'_>, first: usize) -> [T; 3] {
        let q = self.first_column + 3;
        [columns.at(q, first), columns.at(q + 1, first), columns.at(q + 2, first)]
    }
}

/// Deviation of a quaternion from unit norm, beyond rounding.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn quaternion_norm_excess<T: Lanes>(columns: PositionColumns<'_>, q: usize, first: usize) -> T {
    let mut square = -T::one();
    for k in 0..4 {
        let part: T = columns.at(q + k, first);
        square = part.mul_add(part, square);
    }
    excess_beyond(square, UNIT_QUATERNION)
}

/// Twice the excess of |x| over a limit; 0 below the limit.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn excess_beyond<T: Lanes>(x: T, most: f64) -> T {
    let above = x.abs() - T::from_f64(most);
    above + above.abs()
}
