//! Shared parts of the recursion's steps: propagation of the contact wrench to the ground.

use super::branches::Change;
use super::plan::{LeafElimination, TreeStep};
use super::workspace::{Offsets, TrackedSizes, number};
use percuss_spatial::lanes::Lanes;
use percuss_spatial::{PackedInertia, PackedWrench, Pivot};

/// Contact wrench during its propagation to the ground.
pub(super) struct PropagatedWrench<T> {
    pub wrench: PackedWrench<T>,
    /// 1/m̄, 1/kg.
    pub response: T,
    /// True if the sizes of the terms are computed at this configuration, false if constants bound them.
    pub tracks_sizes: bool,
    /// Sizes of its terms, if they are tracked.
    pub sizes: TrackedSizes<T>,
}

/// Smaller value; `other` if `x` is NaN. `other` must be a number.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn smaller<T: Lanes>(x: T, other: T) -> T {
    -((-other).max(-x))
}

/// Stores the wrench on the other body in the workspace.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn store_wrench<T: Lanes>(wrench: &PackedWrench<T>, scratch: &mut [f64]) {
    let mut k = 0;
    while k < 3 {
        wrench.moment[k].store(&mut scratch[k * T::WIDTH..]);
        wrench.force[k].store(&mut scratch[(3 + k) * T::WIDTH..]);
        k += 1;
    }
}

/// Adds the remaining inertia to the parent's.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn add_to_parent<T: Lanes>(
    inertia: &mut PackedInertia<T>,
    above: &PackedInertia<f64>,
    is_first: bool,
    slot: &mut [f64],
) {
    if is_first {
        inertia.add_rigid(above);
        inertia.store(slot);
    } else {
        inertia.add(&PackedInertia::load(slot));
        inertia.store(slot);
    }
}

impl LeafElimination {
    /// The stored pivot, in all lanes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn pivot<T: Lanes>(&self) -> Pivot<T> {
        let of = T::from_f64;
        Pivot {
            u: self.u.cast(),
            d: of(self.d),
            inverse_d: of(self.inverse_d),
            armature_part: of(self.armature_part),
        }
    }
}

impl<T: Lanes> PropagatedWrench<T> {
    /// Exchanges the wrench with the stored one, or adds the stored one.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn change(&mut self, change: Change, scratch: &mut [f64]) {
        let stored = |k: usize| number::<T>(scratch, k);
        let other = PackedWrench {
            moment: [stored(0), stored(1), stored(2)],
            force: [stored(3), stored(4), stored(5)],
        };
        match change {
            Change::Exchange => {
                store_wrench(&self.wrench, scratch);
                self.wrench = other;
                if self.tracks_sizes {
                    self.sizes.exchange(scratch);
                }
            }
            Change::Merge => {
                self.wrench.add(&other);
                if self.tracks_sizes {
                    self.sizes.merge(scratch);
                }
            }
        }
    }

    /// Adds t²/D to the response. Returns t/D.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn add_response(&mut self, t: T, over: T) -> T {
        let rate = t * over;
        self.response = t.mul_add(rate, self.response);
        rate
    }
}

/// Elimination of one velocity for the propagated test wrench f, with t = sᵀf: adds t²/D to 1/m̄ and subtracts U t/D from
/// f. `AXIS`: component of the twist, angular part first. Stores t/D in the workspace of a light body.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn update_wrench<T: Lanes, const AXIS: usize>(
    step: &TreeStep,
    offsets: &Offsets,
    pivot: &Pivot<T>,
    propagated: &mut PropagatedWrench<T>,
    scratch: &mut [f64],
) {
    let turns = AXIS < 3;
    let t = if turns { propagated.wrench.moment[AXIS] } else { propagated.wrench.force[AXIS - 3] };
    let rate = propagated.add_response(t, pivot.inverse_d);
    offsets.store_rate(rate, AXIS, scratch);
    propagated.wrench.subtract(&pivot.u, rate);
    if propagated.tracks_sizes {
        let (size, sizes) = (if turns { step.moment } else { step.mass }, &mut propagated.sizes);
        sizes.add_response(T::from_f64(size), sizes.along_axis(turns), rate);
        sizes.subtract(&pivot.u, rate);
    }
}
