//! How near two answers must be, and whether a stated error covers the truth.

use percuss_dynamics::{ContactResponse, EffectiveMass, Pose};

/// How near two computations of an answer must be, relative: some thousand roundings of what is left when terms of
/// M a thousand times as large cancel.
pub const NEAR: f64 = 1e-9;

/// Roundings per unit of the condition of M: a step of the elimination of each of some hundred coordinates.
const PER_CONDITION: f64 = 1e-14;
/// Nearer than this they need not be, however well conditioned.
const NEAREST: f64 = 1e-11;
/// Worse than this no two answers may be to one question, however badly conditioned.
const WORST: f64 = 1e-7;

/// The condition of M scaled to unit diagonal, where it is regular: below 1/ε by more than rounding.
pub fn regular_condition(pose: &Pose) -> Option<f64> {
    pose.condition().filter(|condition| *condition < 1e14)
}

/// How near two computations must be, relative, by the condition of M (scaled to unit diagonal) at the pose: a law
/// of the problem, not of the answer. A singular M has no condition; what is left of it is as good as any other.
pub fn near_at(pose: &Pose) -> f64 {
    match regular_condition(pose) {
        Some(condition) => (PER_CONDITION * condition).clamp(NEAREST, WORST),
        None => NEAR,
    }
}

/// Whether |m̄ − truth| stays within the error that the answer states, given the truth's own relative error.
pub fn states_enough(response: &ContactResponse, truth: f64, own: f64) -> bool {
    let EffectiveMass::Finite(m) = response.effective_mass else { return false };
    response.effective_mass_error().is_some_and(|stated| (m - truth).abs() <= stated + own * truth)
}

/// m̄ as a number: 0 where massless, infinite where immovable.
pub fn mass_or_bound(response: &ContactResponse) -> f64 {
    match response.effective_mass {
        EffectiveMass::Massless => 0.0,
        EffectiveMass::Finite(m) => m,
        EffectiveMass::Immovable => f64::INFINITY,
    }
}
