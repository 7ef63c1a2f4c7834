//! Triangular factor of Φ, and the wrenches to which massless motions respond.

use crate::kinematics::outcome::EffectiveMass;
use crate::tolerances::{MAP_CLEAR_SPECTRUM, MASSLESS_CLOSING};
use nalgebra::{SMatrix, SVector, Vector3};
use percuss_spatial::Twist;

/// Direction along which m̄ is stationary among all directions at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrincipalMass {
    /// Effective mass along the direction.
    pub mass: EffectiveMass,
    /// Error of m̄, kg; `None` unless m̄ is finite.
    pub error: Option<f64>,
    /// Unit vector of the direction, in the axes of the contact link.
    pub direction: Vector3<f64>,
}

/// Φ = RᵀR, updated by one rank-one term at a time.
pub(super) struct InertiaFactor {
    reach: f64,
    /// R, upper triangular.
    rows: SMatrix<f64, 6, 6>,
    massless_responses: Vec<SVector<f64, 6>>,
}

impl InertiaFactor {
    pub fn new(reach: f64) -> Self {
        Self { reach, rows: SMatrix::zeros(), massless_responses: Vec::new() }
    }

    /// Adds t tᵀ/d. False if d is not positive, or the result is not finite.
    pub fn add(&mut self, t: &[f64; 6], d: f64) -> bool {
        if d.is_nan() || d <= 0.0 {
            return false;
        }
        let root = d.sqrt();
        let mut row = t.map(|t| t / root);
        for i in 0..6 {
            if row[i] == 0.0 {
                continue;
            }
            let (a, b) = (self.rows[(i, i)], row[i]);
            let length = a.hypot(b);
            let (cosine, sine) = (a / length, b / length);
            for (k, entry) in row.iter_mut().enumerate().skip(i) {
                let (upper, lower) = (self.rows[(i, k)], *entry);
                self.rows[(i, k)] = cosine * upper + sine * lower;
                *entry = cosine * lower - sine * upper;
            }
        }
        row.iter().all(|x| x.is_finite())
    }

    /// Adds a massless motion to the space of massless responses. `t`: power of the six unit wrenches (moments first) on the
    /// motion; `motion`: sizes of its twist, for the rounding of `t`. Without effect if `t` is rounding, or if the space already
    /// contains the motion.
    pub fn add_massless_motion(&mut self, t: &[f64; 6], motion: &Twist<f64>) {
        let row = SVector::<f64, 6>::from_fn(|a, _| if a < 3 { t[a] * self.reach } else { t[a] });
        let terms = motion.angular.norm() * self.reach + motion.linear.norm();
        // Smaller values are rounding.
        if row.norm() > MASSLESS_CLOSING * terms {
            let mut unit = row / row.norm();
            for known in &self.massless_responses {
                unit -= known * known.dot(&unit);
            }
            for known in &self.massless_responses {
                unit -= known * known.dot(&unit);
            }
            if unit.norm() > MASSLESS_CLOSING {
                self.massless_responses.push(unit.normalize());
            }
        }
    }

    /// R, row by row from the diagonal.
    pub fn packed(&self) -> [f64; 21] {
        let mut packed = [0.0; 21];
        let mut next = 0;
        for row in 0..6 {
            for column in row..6 {
                packed[next] = self.rows[(row, column)];
                next += 1;
            }
        }
        packed
    }

    /// Largest square root of the diagonal of Φ, with moments scaled by the reach.
    pub fn size(&self) -> f64 {
        let root = |a: usize| self.rows.column(a).norm() * if a < 3 { self.reach } else { 1.0 };
        let size = (0..6).map(root).fold(0.0, f64::max);
        // Nothing moves; any positive size can be used.
        if size > 0.0 { size } else { 1.0 }
    }

    /// True if every eigenvalue of Φ (moments scaled by the reach) is either rounding or clearly larger.
    pub fn is_clear(&self) -> bool {
        let per = |a: usize| if a < 3 { self.reach } else { 1.0 };
        let phi = self.rows.transpose() * self.rows;
        let scaled = SMatrix::<f64, 6, 6>::from_fn(|a, b| phi[(a, b)] * per(a) * per(b));
        let values = scaled.symmetric_eigenvalues();
        let most = values.max();
        let [rounding, clear] = MAP_CLEAR_SPECTRUM;
        values.iter().all(|v| v.abs() <= rounding * most || *v >= clear * most)
    }

    /// Wrenches that move the links without kinetic energy.
    pub fn into_massless_wrenches(self) -> FreeWrenches {
        FreeWrenches { reach: self.reach, units: self.massless_responses }
    }
}

/// Wrenches that cause massless motions: orthonormal basis, with moments scaled by the reach.
#[derive(Clone, Debug, Default)]
pub(super) struct FreeWrenches {
    reach: f64,
    units: Vec<SVector<f64, 6>>,
}

impl FreeWrenches {
    pub fn is_empty(&self) -> bool {
        self.units.is_empty()
    }

    /// Fraction of a contact's wrench within the space of these wrenches, 0 to 1.
    pub fn fraction(&self, arm: &Vector3<f64>, normal: &Vector3<f64>) -> f64 {
        let moment = arm.cross(normal) / self.reach;
        let along = |unit: &SVector<f64, 6>| {
            unit.fixed_rows::<3>(0).dot(&moment) + unit.fixed_rows::<3>(3).dot(normal)
        };
        let square: f64 = self.units.iter().map(along).map(|along| along * along).sum();
        (square / (moment.norm_squared() + normal.norm_squared())).sqrt()
    }

    /// Forces at a point to which massless motions respond, one row each.
    pub fn project_forces(&self, arm: &Vector3<f64>) -> SMatrix<f64, 6, 3> {
        let mut rows = SMatrix::<f64, 6, 3>::zeros();
        for (i, unit) in self.units.iter().take(6).enumerate() {
            let moment = unit.fixed_rows::<3>(0) / self.reach;
            let force = unit.fixed_rows::<3>(3) + arm.cross_matrix().transpose() * moment;
            rows.fixed_rows_mut::<1>(i).copy_from(&force.transpose());
        }
        rows
    }
}
