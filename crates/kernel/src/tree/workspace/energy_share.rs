//! Bounds of the motion of a body, and of rounding errors, by its kinetic energy.

use crate::tolerances::{LEAST_MOMENT, LIGHT_BODY, NO_BOUND};
use nalgebra::{Matrix3, Vector3};
use percuss_spatial::PackedInertia;

/// Bounds of the twist of a body, and of the effect of rounding errors, by its kinetic energy 2 E = vᵀ I v. After a unit
/// impulse, the sum of 2 E over all bodies is 1/m̄. For a body without inertia the bounds are [`NO_BOUND`].
#[derive(Clone, Copy, Debug, Default)]
pub(in super::super) struct EnergyShare {
    /// Amplification κ: largest (√moment |ω| + √mass |v|)² for 2 E = 1 J, with the bounds of the articulated inertia.
    pub amplification: f64,
    /// √moment, √(kg·m²), and √mass, √kg, of these bounds.
    pub roots: [f64; 2],
    /// Moment (kg·m²) about the body's origin and mass (kg) of the subtrees of the children that are not light.
    pub carried: [f64; 2],
    /// Largest |ω| (rad/s) and velocity of the origin (m/s) for 2 E = 1 J.
    pub angular: f64,
    pub linear: f64,
}

impl EnergyShare {
    /// Bounds for a body with its own inertia. `moment` (kg·m²) and `mass` (kg): bounds of its articulated inertia; `carried`: the part
    /// of these bounds from children that are not light.
    pub fn of(own: &PackedInertia<f64>, [moment, mass]: [f64; 2], carried: [f64; 2]) -> Self {
        let (a, h, m) = (&own.angular, &own.coupling, own.linear[0]);
        let rotational = Matrix3::new(a[0], a[1], a[2], a[1], a[3], a[4], a[2], a[4], a[5]);
        let centre = Vector3::new(h[2][1], h[0][2], h[1][0]) / m;
        let about_centre =
            rotational - (Matrix3::identity() * centre.norm_squared() - centre * centre.transpose()) * m;
        let least = about_centre.symmetric_eigenvalues().min();
        // A smaller moment may be rounding.
        let roots = [moment, mass].map(f64::sqrt);
        if !(m > 0.0 && least > LEAST_MOMENT * rotational.trace()) {
            return Self { amplification: NO_BOUND, roots, carried, angular: NO_BOUND, linear: NO_BOUND };
        }
        // |v| ≤ |v_c| + |c| |ω| with the velocity v_c of the centre of mass; then Cauchy–Schwarz.
        let about_angular = roots[0] + roots[1] * centre.norm();
        Self {
            amplification: about_angular * about_angular / least + mass / m,
            roots,
            carried,
            angular: 1.0 / least.sqrt(),
            linear: (1.0 / m + centre.norm_squared() / least).sqrt(),
        }
    }

    /// True for a body whose kinetic energy bounds rounding errors only weakly.
    #[inline]
    pub fn is_light(&self) -> bool {
        self.amplification > LIGHT_BODY
    }
}
