//! Shared parts of the recursion's steps: propagation of the contact wrench to the ground, and the layout of the
//! workspace.

use super::plan::{EnergyShare, LeafElimination, TreeStep};
use super::sizes::SIZES;
use crate::tolerances::{LOSS_ROUNDINGS, ROUTE_ROUNDINGS};
use percuss_spatial::lanes::Lanes;
use percuss_spatial::{PackedInertia, PackedTwist, PackedWrench, Pivot};

/// Numbers of workspace per step and lane: inertia, sine and cosine (or travel), sizes of terms; for the twists of light bodies
/// t/D of each velocity, the sizes of the wrench, and the twist.
pub(super) const SCRATCH_NUMBERS: usize = TWIST + 6;
const RATES: usize = SIZES + 2;
const WRENCH_SIZES: usize = RATES + 6;
const TWIST: usize = WRENCH_SIZES + 2;
pub(super) const SINE: usize = 21;
pub(super) const COSINE: usize = 22;

/// Contact wrench during its propagation to the ground.
pub(super) struct PropagatedWrench<T> {
    pub wrench: PackedWrench<T>,
    /// Sizes of the terms of the wrench's moment (N·m) and force (N).
    pub moment_size: T,
    pub force_size: T,
    /// 1/m̄, 1/kg, and the sum of the sizes of its terms.
    pub response: T,
    pub terms: T,
    pub loss: T,
    /// Sum over the bodies on the contact path of the sizes of the wrench times the largest twist for 2 E = 1 J, √(1/kg).
    pub by_energy: T,
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn number<T: Lanes>(slot: &[f64], number: usize) -> T {
    T::load(&slot[number * T::WIDTH..])
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
    /// Zero wrench.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn none() -> Self {
        let (o, one) = (T::zero(), T::one());
        Self {
            wrench: PackedWrench::zero(),
            moment_size: o,
            force_size: o,
            response: o,
            terms: o,
            loss: one,
            by_energy: o,
        }
    }

    /// Counts the ratio of a pivot's summed terms to the pivot. Returns that ratio.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn record_loss(&mut self, size: T, pivot: &Pivot<T>) -> T {
        let loss = size * pivot.inverse_d.abs();
        self.loss = self.loss.max(loss);
        loss
    }

    /// Error of the response in units of ε, 1/kg: the sizes of the terms of its pivots and wrenches, times the roundings of the
    /// pivot with the largest loss.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn error_of_pivots(&self) -> T {
        T::from_f64(ROUTE_ROUNDINGS).max(self.loss * T::from_f64(LOSS_ROUNDINGS)) * self.terms
    }

    /// Adds the power of the sizes of the wrench on a body for the largest twist of this body. For a light body, stores the sizes
    /// in its workspace instead.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn add_share(&mut self, share: &EnergyShare, own: &mut [f64]) {
        if share.is_light() {
            self.moment_size.store(&mut own[WRENCH_SIZES * T::WIDTH..]);
            self.force_size.store(&mut own[(WRENCH_SIZES + 1) * T::WIDTH..]);
            return;
        }
        let (angular, linear) = (T::from_f64(share.angular), T::from_f64(share.linear));
        self.by_energy = self.moment_size.mul_add(angular, self.force_size.mul_add(linear, self.by_energy));
    }

    /// Adds t²/D and its terms. Returns t/D.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn add_response(&mut self, size: T, t: T, test: T, over: T) -> T {
        let rate = t * over;
        let part = rate.abs();
        self.response = t.mul_add(rate, self.response);
        self.terms = part.mul_add(part.mul_add(size, test + test), self.terms);
        rate
    }
}

/// Elimination of one velocity for the propagated test wrench f, with t = sᵀf: adds t²/D to 1/m̄ and subtracts U t/D from
/// f. `AXIS`: component of the twist, angular part first. Stores t/D in the workspace `own` of the body.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn update_wrench<T: Lanes, const AXIS: usize>(
    step: &TreeStep,
    pivot: &Pivot<T>,
    propagated: &mut PropagatedWrench<T>,
    own: &mut [f64],
) {
    let of = T::from_f64;
    let size = of(if AXIS < 3 { step.moment } else { step.mass });
    let (t, test) = if AXIS < 3 {
        (propagated.wrench.moment[AXIS], propagated.moment_size)
    } else {
        (propagated.wrench.force[AXIS - 3], propagated.force_size)
    };
    let rate = propagated.add_response(size, t, test, pivot.inverse_d);
    store_rate(rate, AXIS, own);
    let part = rate.abs();
    let (m, f) = (&pivot.u.moment, &pivot.u.force);
    propagated.moment_size = (m[0].abs() + m[1].abs() + m[2].abs()).mul_add(part, propagated.moment_size);
    propagated.force_size = (f[0].abs() + f[1].abs() + f[2].abs()).mul_add(part, propagated.force_size);
    propagated.wrench.subtract(&pivot.u, rate);
}

/// Stores t/D of the velocity along a component of the twist.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn store_rate<T: Lanes>(rate: T, component: usize, own: &mut [f64]) {
    rate.store(&mut own[(RATES + component) * T::WIDTH..]);
}

/// Loads a number written by [`store_rate`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn stored_rate<T: Lanes>(own: &[f64], component: usize) -> T {
    number(own, RATES + component)
}

/// Sizes of the moment and force stored by [`PropagatedWrench::add_share`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn stored_wrench_sizes<T: Lanes>(own: &[f64]) -> (T, T) {
    (number(own, WRENCH_SIZES), number(own, WRENCH_SIZES + 1))
}

/// Stores the twist of a body in its workspace.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn store_twist<T: Lanes>(twist: &PackedTwist<T>, own: &mut [f64]) {
    for k in 0..3 {
        twist.angular[k].store(&mut own[(TWIST + k) * T::WIDTH..]);
        twist.linear[k].store(&mut own[(TWIST + 3 + k) * T::WIDTH..]);
    }
}

/// Loads a twist written by [`store_twist`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn load_twist<T: Lanes>(slot: &[f64]) -> PackedTwist<T> {
    let mut twist = PackedTwist::zero();
    for k in 0..3 {
        twist.angular[k] = number(slot, TWIST + k);
        twist.linear[k] = number(slot, TWIST + 3 + k);
    }
    twist
}
