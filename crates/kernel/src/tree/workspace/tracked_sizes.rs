//! Sizes of the terms of the propagated force, computed at each configuration, for trees in which constant bounds are too large. The
//! rounding error is the smaller of a bound by the pivots and a bound by the kinetic energy.

use super::energy_share::EnergyShare;
use super::layout::{LIGHT_SIZES, Offsets, STORED_FORCE, STORED_MOMENT, number};
use crate::tolerances::{LOSS_ROUNDINGS, ROUTE_ROUNDINGS};
use percuss_spatial::PackedWrench;
use percuss_spatial::lanes::Lanes;

/// Sizes of the terms of the propagated force, and sums of them.
pub(in super::super) struct TrackedSizes<T> {
    /// Moment, N·m.
    moment: T,
    /// Force, N.
    force: T,
    /// Sum of the sizes of the terms of the response, 1/kg.
    pub terms: T,
    /// Largest ratio of the terms of a pivot to the pivot.
    loss: T,
    /// Power of the sizes on each body for the largest twist of this body with 2 E = 1 J, all bodies added, √(1/kg).
    pub power: T,
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn store<T: Lanes>(x: T, at: usize, scratch: &mut [f64]) {
    x.store(&mut scratch[at * T::WIDTH..]);
}

/// Stores the sizes of the moment (N·m) and of the force (N) of the stored wrench.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in super::super) fn store_sizes<T: Lanes>(moment: T, force: T, scratch: &mut [f64]) {
    store(moment, STORED_MOMENT, scratch);
    store(force, STORED_FORCE, scratch);
}

impl<T: Lanes> TrackedSizes<T> {
    /// Sizes of a wrench, N·m and N.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn new(moment: T, force: T) -> Self {
        Self { moment, force, terms: T::zero(), loss: T::one(), power: T::zero() }
    }

    /// Exchanges the sizes with those of the stored force.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn exchange(&mut self, scratch: &mut [f64]) {
        let (moment, force) = (number(scratch, STORED_MOMENT), number(scratch, STORED_FORCE));
        store(self.moment, STORED_MOMENT, scratch);
        store(self.force, STORED_FORCE, scratch);
        (self.moment, self.force) = (moment, force);
    }

    /// Adds the sizes of the stored force.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn merge(&mut self, scratch: &[f64]) {
        self.moment += number(scratch, STORED_MOMENT);
        self.force += number(scratch, STORED_FORCE);
    }

    /// Counts the ratio of a pivot's summed terms to the pivot.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn record_loss(&mut self, loss: T) {
        self.loss = self.loss.max(loss);
    }

    /// Size of the terms of the component of the wrench along the axis of a rotation or translation, N·m or N.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn along_axis(&self, turns: bool) -> T {
        if turns { self.moment } else { self.force }
    }

    /// Adds the terms of t²/D, with the rate t/D. `size` and `test` (N·m or N): sizes of the terms of D and t.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn add_response(&mut self, size: T, test: T, rate: T) {
        let part = rate.abs();
        self.terms = part.mul_add(part.mul_add(size, test + test), self.terms);
    }

    /// Adds the terms of U t/D, with the rate t/D.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn subtract(&mut self, momentum: &PackedWrench<T>, rate: T) {
        let (part, m, f) = (rate.abs(), &momentum.moment, &momentum.force);
        self.moment = (m[0].abs() + m[1].abs() + m[2].abs()).mul_add(part, self.moment);
        self.force = (f[0].abs() + f[1].abs() + f[2].abs()).mul_add(part, self.force);
    }

    /// Adds the size of the force at a distance of at most `reach` (m) to the size of the moment.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn add_reach(&mut self, reach: f64) {
        self.moment = T::from_f64(reach).mul_add(self.force, self.moment);
    }

    /// Adds the power of the sizes on a body. For a light body, stores the sizes in its workspace instead.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn add_share(&mut self, share: &EnergyShare, offsets: &Offsets, scratch: &mut [f64]) {
        if share.is_light() {
            if let Some(light) = offsets.light {
                store(self.moment, light + LIGHT_SIZES, scratch);
                store(self.force, light + LIGHT_SIZES + 1, scratch);
            }
            return;
        }
        let (angular, linear) = (T::from_f64(share.angular), T::from_f64(share.linear));
        self.power = self.moment.mul_add(angular, self.force.mul_add(linear, self.power));
    }

    /// Error of the response by the pivots in units of ε, 1/kg: the sizes of the terms of the pivots and forces, times the roundings of the
    /// pivot with the largest loss.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn error_by_pivots(&self) -> T {
        T::from_f64(ROUTE_ROUNDINGS).max(self.loss * T::from_f64(LOSS_ROUNDINGS)) * self.terms
    }
}

/// Sizes of the moment and force stored for a light body.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in super::super) fn stored_sizes<T: Lanes>(offsets: &Offsets, scratch: &[f64]) -> [T; 2] {
    match offsets.light {
        Some(light) => [number(scratch, light + LIGHT_SIZES), number(scratch, light + LIGHT_SIZES + 1)],
        None => [T::zero(); 2],
    }
}
