//! Sizes of the terms that articulated inertias are sums of.

use crate::tolerances::COMMON_LOSS;
use percuss_spatial::PackedInertia;
use percuss_spatial::lanes::Lanes;

/// Place of the sizes in the room of a step.
pub(super) const SIZES: usize = 23;

/// Largest terms that the entries of an articulated inertia are sums of, those of the subtree before its eliminations
/// included: an elimination cancels a term, and leaves its rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sizes<T> {
    /// Of angular entries, kg·m².
    pub moment: T,
    /// Of linear entries, kg.
    pub mass: T,
}

impl<T: Lanes> Sizes<T> {
    /// Sizes of an inertia whose children left those in `slot`; `carries`: there are any.
    #[inline(always)]
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

    /// Sizes after the elimination of a pivot whose loss is this: errors of U D⁻¹ Uᵀ are larger by the factor |U|/D.
    #[inline(always)]
    pub fn amplified(self, loss: T) -> Self {
        let factor = T::one().max(loss * T::from_f64(1.0 / COMMON_LOSS));
        Self { moment: self.moment * factor, mass: self.mass * factor }
    }

    /// Sizes about the parent's origin, which is at most `reach` (m) away, added to the parent's.
    #[inline(always)]
    pub fn pass(self, reach: f64, is_first: bool, slot: &mut [f64]) {
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
    /// The same over lanes.
    #[inline(always)]
    pub fn cast<T: Lanes>(&self) -> Sizes<T> {
        Sizes { moment: T::from_f64(self.moment), mass: T::from_f64(self.mass) }
    }
}
