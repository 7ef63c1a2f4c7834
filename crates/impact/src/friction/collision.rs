//! Frictional impact at one contact from its mobility matrix.

use crate::error::ImpactError;
use crate::friction::phases::{Collision, RestitutionLaw};
use crate::friction::planar::{PlanarMobility, planar_collision};
use crate::friction::rounding::{resolved_mobility, resolved_rate, resolved_velocity, sticking_ratio};
use crate::friction::spatial::spatial_collision;
use crate::mobility::semidefinite::SemidefiniteSolver;
use crate::tolerances::{MASSLESS_RESPONSE, PLANAR};
use nalgebra::{DMatrix, DVector, Matrix2, Matrix3, Vector2, Vector3};

/// Impact with Coulomb friction at one contact.
///
/// | symbol | meaning                                              | unit |
/// |--------|------------------------------------------------------|------|
/// | W      | `mobility`: block of [`Delassus`](crate::Delassus)    | 1/kg |
/// | u⁻     | `before`: opening speed (negative), sliding velocity | m/s  |
///
/// The velocities change by du = W dP. Sliding along ŝ has dP_t = −µ ŝ dp_n, sticking dP_t = −A_tt⁻¹ a_tn dp_n. There is no
/// tangential compliance: a result is in general not the limit of a compliant contact of increasing stiffness.
///
/// A motion that stays in one plane is computed in closed form, others by integration with a relative error of about 1e-12.
/// Sources: Routh 1905, Keller 1986, Wang and Mason 1992, Stronge 2000.
///
/// # Errors
/// [`ImpactError`]: values out of range, an immovable contact, an impact without an end.
pub fn frictional_collision(
    mobility: &Matrix3<f64>,
    before: &Vector3<f64>,
    friction: f64,
    restitution: f64,
    law: RestitutionLaw,
) -> Result<Collision, ImpactError> {
    if !(0.0..=1.0).contains(&restitution) {
        return Err(ImpactError::Restitution { got: restitution });
    }
    if !(friction.is_finite() && friction >= 0.0) {
        return Err(ImpactError::Friction { got: friction });
    }
    if !(before[0].is_finite() && before[0] < 0.0) {
        return Err(ImpactError::ClosingSpeed { got: -before[0] });
    }
    if mobility[(0, 0)].is_nan() || mobility[(0, 0)] <= 0.0 {
        return Err(ImpactError::Immovable);
    }
    let (mobility, before) = (&resolved_mobility(mobility), &resolved_velocity(before));
    if law == RestitutionLaw::Algebraic {
        return algebraic(mobility, before, friction, restitution)
            .ok_or(ImpactError::NoEnd { law: law.name() });
    }
    let found = match plane(mobility, before) {
        Some(tangent) => planar(mobility, before, &tangent, friction, restitution, law),
        None => spatial_collision(mobility, before, friction, restitution, law),
    };
    found.ok_or(ImpactError::NoEnd { law: law.name() })
}

/// Smallest coefficient of friction at which the contact can stick, |A_tt⁻¹ a_tn|; `None` if a_tn has a component in a tangential
/// direction in which the contact cannot move.
pub fn sticking_threshold(mobility: &Matrix3<f64>) -> Option<f64> {
    sticking_ratio(mobility).map(|ratio| ratio.norm())
}

/// Smallest coefficient of friction at which sliding in some direction jams, a_nn/|a_tn|: the friction then accelerates the
/// approach (Painlevé). `None` without a coupling of normal and tangential motion.
pub fn jamming_threshold(mobility: &Matrix3<f64>) -> Option<f64> {
    let coupling = mobility[(1, 0)].hypot(mobility[(2, 0)]);
    (coupling > MASSLESS_RESPONSE * mobility.norm()).then(|| mobility[(0, 0)] / coupling)
}

/// Tangent of the plane in which the contact moves; `None` if the motion is not planar.
fn plane(mobility: &Matrix3<f64>, before: &Vector3<f64>) -> Option<Vector2<f64>> {
    let coupling = Vector2::new(mobility[(1, 0)], mobility[(2, 0)]);
    let sliding = Vector2::new(before[1], before[2]);
    let size = mobility.norm();
    let tangential: Matrix2<f64> = mobility.fixed_view::<2, 2>(1, 1).into_owned();
    // Without sliding and coupling there is no friction.
    let tangent = sliding.try_normalize(0.0).or_else(|| coupling.try_normalize(0.0));
    let Some(tangent) = tangent else { return Some(Vector2::new(1.0, 0.0)) };
    let across = Vector2::new(-tangent[1], tangent[0]);
    let leaves = across.dot(&coupling).abs().max((across.transpose() * tangential * tangent)[0].abs());
    (leaves <= PLANAR * size).then_some(tangent)
}

/// Result in a plane, in three components.
fn planar(
    mobility: &Matrix3<f64>,
    before: &Vector3<f64>,
    tangent: &Vector2<f64>,
    friction: f64,
    restitution: f64,
    law: RestitutionLaw,
) -> Option<Collision> {
    let coupling = Vector2::new(mobility[(1, 0)], mobility[(2, 0)]);
    let tangential: Matrix2<f64> = mobility.fixed_view::<2, 2>(1, 1).into_owned();
    let in_plane = PlanarMobility {
        normal: mobility[(0, 0)],
        coupling: tangent.dot(&coupling),
        tangential: (tangent.transpose() * tangential * tangent)[0],
    };
    let sliding = tangent.dot(&Vector2::new(before[1], before[2]));
    let found = planar_collision(&in_plane, [before[0], sliding], friction, restitution, law)?;
    let lift = |[n, t]: [f64; 2]| Vector3::new(n, t * tangent[0], t * tangent[1]);
    let (impulse, after) = (lift(found.impulse), lift(found.after));
    Some(Collision {
        energy_change: 0.5 * impulse.dot(&(before + after)),
        impulse,
        after,
        phases: found.phases,
        compression: found.compression,
        normal_work: found.normal_work,
        is_wedged: found.is_wedged,
    })
}

/// Algebraic form of Newton's law: no sliding after the impact if the friction suffices, otherwise full friction against the initial
/// sliding.
fn algebraic(
    mobility: &Matrix3<f64>,
    before: &Vector3<f64>,
    friction: f64,
    restitution: f64,
) -> Option<Collision> {
    let result = |impulse: Vector3<f64>| {
        let after = before + mobility * impulse;
        Collision {
            energy_change: 0.5 * impulse.dot(&(before + after)),
            impulse,
            after,
            phases: Vec::new(),
            compression: 0.0,
            normal_work: [0.0; 2],
            is_wedged: false,
        }
    };
    let wanted = Vector3::new(-(1.0 + restitution) * before[0], -before[1], -before[2]);
    if let Some(impulse) = solve(mobility, &wanted)
        && impulse[0] >= 0.0
        && impulse[1].hypot(impulse[2]) <= friction * impulse[0]
    {
        return Some(result(impulse));
    }
    let sliding = Vector2::new(before[1], before[2]);
    let coupling = Vector2::new(mobility[(1, 0)], mobility[(2, 0)]);
    let direction = sliding.try_normalize(0.0).or_else(|| coupling.try_normalize(0.0))?;
    let rate = resolved_rate(mobility[(0, 0)] - friction * coupling.dot(&direction), mobility[(0, 0)]);
    let normal = -(1.0 + restitution) * before[0] / rate;
    (rate > 0.0).then(|| {
        result(Vector3::new(normal, -friction * normal * direction[0], -friction * normal * direction[1]))
    })
}

/// Impulse of least norm with W P = `wanted`; `None` if the contact cannot reach this change of velocity.
fn solve(mobility: &Matrix3<f64>, wanted: &Vector3<f64>) -> Option<Vector3<f64>> {
    let solver = SemidefiniteSolver::new(DMatrix::from_column_slice(3, 3, mobility.as_slice()));
    let wanted = DVector::from_column_slice(wanted.as_slice());
    let reaches = (solver.kernel().transpose() * &wanted).norm() <= MASSLESS_RESPONSE.sqrt() * wanted.norm();
    reaches.then(|| Vector3::from_column_slice(solver.solve(&wanted).as_slice()))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two algorithms on the rod: closed form in the plane, and integration.
    #[test]
    fn integration_agrees_with_the_closed_form() {
        let mut compared = 0;
        for angle in [5.0_f64, 20.0, 35.0, 50.0, 63.0, 70.0, 80.0, 88.0] {
            let (s, c) = angle.to_radians().sin_cos();
            let w = Matrix3::new(
                1.0 + 3.0 * c * c,
                -3.0 * s * c,
                0.0,
                -3.0 * s * c,
                1.0 + 3.0 * s * s,
                0.0,
                0.0,
                0.0,
                1.0,
            );
            for friction in [0.05, 0.3, 0.8, 1.4, 2.5] {
                for restitution in [0.0, 0.4, 1.0] {
                    for slip in [-3.0, -0.4, 0.7, 2.0] {
                        let before = Vector3::new(-1.0, slip, 0.0);
                        for law in
                            [RestitutionLaw::Energetic, RestitutionLaw::Poisson, RestitutionLaw::Newton]
                        {
                            let exact = frictional_collision(&w, &before, friction, restitution, law);
                            let other = spatial_collision(&w, &before, friction, restitution, law);
                            let (Ok(exact), Some(other)) = (exact, other) else {
                                panic!("{angle} {friction} {slip}")
                            };
                            let error = (exact.impulse - other.impulse).norm() / exact.impulse.norm();
                            assert!(error < 1e-11, "{angle} {friction} {restitution} {slip}: {error:e}");
                            let kinds = |phases: &[crate::friction::phases::Phase]| {
                                phases.iter().map(|p| (p.kind, p.is_expansion)).collect::<Vec<_>>()
                            };
                            assert_eq!(kinds(&exact.phases), kinds(&other.phases));
                            compared += 1;
                        }
                    }
                }
            }
        }
        assert_eq!(compared, 8 * 5 * 3 * 4 * 3);
    }
}
