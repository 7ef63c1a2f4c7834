//! Tolerances for two results, and the test of a stated error.

use percuss_dynamics::{ContactResponse, EffectiveMass, Pose};

/// Relative tolerance for two computations of a result: some thousand roundings of the remainder after cancellation of
/// terms of M a thousand times as large.
pub const NEAR: f64 = 1e-9;

/// Largest relative difference of two results without a stated error: these are near a singular pose or a massless
/// motion, where six digits are left.
pub const UNSTATED: f64 = 1e-6;

/// Rounding per unit of the condition of M: one elimination step for each of some hundred coordinates.
const PER_CONDITION: f64 = 1e-14;
/// Lower limit of the tolerance, for well-conditioned problems.
const NEAREST: f64 = 1e-11;
/// Upper limit of the tolerance, for ill-conditioned problems.
const WORST: f64 = 1e-7;

/// Condition of M scaled to unit diagonal; `None` for a singular M: a condition of about 1/ε.
pub fn regular_condition(pose: &Pose) -> Option<f64> {
    pose.condition().filter(|condition| *condition < 1e14)
}

/// Relative tolerance for two computations, from the condition of M (scaled to unit diagonal) at the pose: a property
/// of the problem, not of the result. A singular M has no condition and gets the default tolerance.
pub fn near_at(pose: &Pose) -> f64 {
    match regular_condition(pose) {
        Some(condition) => (PER_CONDITION * condition).clamp(NEAREST, WORST),
        None => NEAR,
    }
}

/// True if |m̄ − truth| is within the stated error, given the relative error `own` of the truth.
pub fn states_enough(response: &ContactResponse, truth: f64, own: f64) -> bool {
    let EffectiveMass::Finite(m) = response.effective_mass else { return false };
    response.effective_mass_error().is_some_and(|stated| (m - truth).abs() <= stated + own * truth)
}

/// m̄ as a number: 0 for massless, infinite for immovable.
pub fn mass_or_bound(response: &ContactResponse) -> f64 {
    match response.effective_mass {
        EffectiveMass::Massless => 0.0,
        EffectiveMass::Finite(m) => m,
        EffectiveMass::Immovable => f64::INFINITY,
    }
}
