//! Sizes of the terms of articulated inertias.

use super::layout::SIZES;
use crate::tolerances::COMMON_LOSS;
use percuss_spatial::PackedInertia;
use percuss_spatial::lanes::Lanes;

/// Largest terms in the entries of an articulated inertia. Terms of the subtree before its eliminations count too: an
/// elimination cancels a term but not its rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in super::super) struct Sizes<T> {
    /// Angular entries, kg·m².
    pub moment: T,
    /// Linear entries, kg.
    pub mass: T,
}

impl<T: Lanes> Sizes<T> {
    /// Zero, if sizes are not tracked.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn zero() -> Self {
        Self { moment: T::zero(), mass: T::zero() }
    }

    /// Sizes of a body's inertia, or those of its children stored in `slot` if larger; `carries`: true if the body has
    /// children.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn of(inertia: &PackedInertia<T>, carries: bool, slot: &[f64]) -> Self {
        let (moment, mass) = (inertia.moment_size(), inertia.mass_size());
        if !carries {
            return Self { moment, mass };
        }
        Self {
            moment: moment.max(T::load(&slot[SIZES * T::WIDTH..])),
            mass: mass.max(T::load(&slot[(SIZES + 1) * T::WIDTH..])),
        }
    }

    /// Sizes after the elimination of a pivot with the given loss: errors of U D⁻¹ Uᵀ grow by the factor |U|/D.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn amplified(self, loss: T) -> Self {
        let factor = T::one().max(loss * T::from_f64(1.0 / COMMON_LOSS));
        Self { moment: self.moment * factor, mass: self.mass * factor }
    }

    /// Sizes about the parent's origin, at a distance of at most `reach` (m), added to the parent's.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn add_to_parent(self, reach: f64, is_first: bool, slot: &mut [f64]) {
        let mut moment = self.moment.max(self.mass * T::from_f64(reach * reach));
        let mut mass = self.mass;
        if !is_first {
            moment = moment.max(T::load(&slot[SIZES * T::WIDTH..]));
            mass = mass.max(T::load(&slot[(SIZES + 1) * T::WIDTH..]));
        }
        moment.store(&mut slot[SIZES * T::WIDTH..]);
        mass.store(&mut slot[(SIZES + 1) * T::WIDTH..]);
    }
}

impl Sizes<f64> {
    /// The same sizes in every lane.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn cast<T: Lanes>(&self) -> Sizes<T> {
        Sizes { moment: T::from_f64(self.moment), mass: T::from_f64(self.mass) }
    }
}
