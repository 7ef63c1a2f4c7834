//! How near two strikes must be, and which is heavier.

use percuss_dynamics::{EffectiveMass, Strike};

/// How near two computations of a strike must be: 1e-12 for every unit of the condition of M (the roundings of some
/// hundred terms), at most 1e-9, unless the strike itself says that fewer digits are left.
pub fn rounding(strike: &Strike) -> f64 {
    let bound = strike.condition.map_or(1e-9, |condition| (1e-12 * condition).min(1e-9));
    match (strike.effective_mass, strike.effective_mass_error) {
        (EffectiveMass::Finite(m), Some(error)) => bound.max(error / m),
        _ => bound,
    }
}

/// Whether the mass matrix is singular or so near it that the recursion may decline: 1e-11, the error it stands for,
/// over ε and some fifty terms.
pub fn hard(strike: &Strike) -> bool {
    strike.condition.is_none_or(|condition| condition > 1e3)
}

/// A number that says which is heavier.
pub fn weight(strike: &Strike) -> f64 {
    match strike.effective_mass {
        EffectiveMass::Massless => 0.0,
        EffectiveMass::Finite(m) => m,
        EffectiveMass::Immovable => f64::INFINITY,
    }
}
