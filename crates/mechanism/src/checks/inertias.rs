//! Physical validity of inertias.

use crate::limits::{MOMENT_SLACK, STEINER_SLACK};
use crate::{Inertial, Problem};
use nalgebra::Matrix3;

/// Checks the inertia about the centre of mass; `size` (m) is the characteristic length of the mechanism.
///
/// Indefinite: λ_min < −max(1e-9 λ_max, 1e-12 m size²). Triangle inequality: λ_max > λ_min + λ_mid beyond the
/// same tolerance. All numbers must be finite.
pub(crate) fn check(inertial: &Inertial, size: f64, accept_indefinite: bool) -> Option<Problem> {
    let principal = principal_moments(&inertial.about_com);
    let [a, b, c] = principal;
    let slack = (MOMENT_SLACK * c.abs().max(a.abs())).max(STEINER_SLACK * inertial.mass * size * size);
    if a < -slack {
        Some(Problem::IndefiniteInertia { principal, accepted: accept_indefinite })
    } else if c > a + b + slack {
        Some(Problem::TriangleInequality { principal })
    } else {
        None
    }
}

/// Eigenvalues of the symmetric matrix in ascending order.
pub(crate) fn principal_moments(inertia: &Matrix3<f64>) -> [f64; 3] {
    // Scaled to one, so that the iteration does not underflow for very small inertias.
    let scale = inertia.amax();
    if scale == 0.0 {
        return [0.0; 3];
    }
    let values = (inertia / scale).symmetric_eigenvalues() * scale;
    let mut values = [values[0], values[1], values[2]];
    values.sort_by(f64::total_cmp);
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    fn diagonal(moments: [f64; 3]) -> Inertial {
        Inertial::diagonal(2.0, [0.0; 3], moments)
    }

    #[test]
    fn point_masses_rods_and_discs_are_possible() {
        for moments in [[0.0; 3], [0.0, 0.3, 0.3], [0.3, 0.3, 0.6], [1e-12, 1e-12, 1e-12]] {
            assert_eq!(check(&diagonal(moments), 1.0, false), None, "{moments:?}");
        }
        // A rod with general orientation: one eigenvalue is a rounding error of either sign.
        let axis = nalgebra::Vector3::new(0.3, -0.5, 0.81).normalize();
        let rod = Inertial {
            about_com: (Matrix3::identity() - axis * axis.transpose()) * 0.7,
            ..diagonal([0.0; 3])
        };
        assert_eq!(check(&rod, 1.0, false), None);
    }

    #[test]
    fn negative_and_impossible_moments_are_told_apart() {
        let negative = check(&diagonal([0.1, 0.1, -0.01]), 1.0, false);
        assert!(matches!(negative, Some(Problem::IndefiniteInertia { accepted: false, .. })));
        let broken = check(&diagonal([0.1, 0.1, 0.3]), 1.0, false);
        assert!(matches!(broken, Some(Problem::TriangleInequality { .. })));
    }
}
