//! Rounding of the mobility and of the velocities of a contact with friction: parts that are rounding are set to zero, so that no sign or
//! direction is taken from them.

use crate::mobility::semidefinite::SemidefiniteSolver;
use crate::tolerances::{MASSLESS_RESPONSE, NO_SLIDING, WEDGED};
use nalgebra::{DMatrix, DVector, Matrix2, Matrix3, Vector2, Vector3};

/// Velocity of a contact point before an impact without a sliding velocity that is rounding: its direction would be arbitrary.
pub(crate) fn resolved_velocity(before: &Vector3<f64>) -> Vector3<f64> {
    let slides = before[1].hypot(before[2]) > NO_SLIDING * before.norm();
    if slides { *before } else { Vector3::new(before[0], 0.0, 0.0) }
}

/// Mobility of a contact point without rounding: tangential directions in which the point cannot move have no entries, and a coupling of
/// normal and tangential motion that is rounding is zero.
pub(crate) fn resolved_mobility(mobility: &Matrix3<f64>) -> Matrix3<f64> {
    let size = mobility.norm();
    let mut resolved = *mobility;
    let movable: Vec<DVector<f64>> = tangential_solver(mobility).movable_directions().collect();
    if movable.len() < 2 {
        let project = movable.iter().fold(Matrix2::zeros(), |sum, v| {
            let v = Vector2::new(v[0], v[1]);
            sum + v * v.transpose()
        });
        let tangential = project * mobility.fixed_view::<2, 2>(1, 1) * project;
        resolved.fixed_view_mut::<2, 2>(1, 1).copy_from(&tangential);
    }
    if mobility[(1, 0)].hypot(mobility[(2, 0)]) <= MASSLESS_RESPONSE * size {
        for t in [1, 2] {
            (resolved[(t, 0)], resolved[(0, t)]) = (0.0, 0.0);
        }
    }
    resolved
}

/// Decomposition of the tangential block A_tt of a mobility.
fn tangential_solver(mobility: &Matrix3<f64>) -> SemidefiniteSolver {
    let tangential = DMatrix::from_fn(2, 2, |r, c| mobility[(r + 1, c + 1)]);
    SemidefiniteSolver::within(tangential, mobility.norm())
}

/// Tangential impulse per normal impulse of a contact that sticks, −A_tt⁻¹ a_tn; `None` if a_tn has a component in a tangential direction in
/// which the contact cannot move.
pub(crate) fn sticking_ratio(mobility: &Matrix3<f64>) -> Option<Vector2<f64>> {
    let coupling = DVector::from_vec(vec![mobility[(1, 0)], mobility[(2, 0)]]);
    let solver = tangential_solver(mobility);
    let open = (solver.kernel().transpose() * &coupling).norm();
    let ratio = -solver.solve(&coupling);
    (open <= MASSLESS_RESPONSE.sqrt() * mobility.norm()).then(|| Vector2::new(ratio[0], ratio[1]))
}

/// Change `alpha` of the normal velocity per normal impulse, or zero if it is rounding. `size`: change without friction.
pub(crate) fn resolved_rate(alpha: f64, size: f64) -> f64 {
    if alpha.abs() <= WEDGED * size { 0.0 } else { alpha }
}
