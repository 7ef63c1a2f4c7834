//! What the steps of the recursion share: the struck point's wrench on its way to the ground, and the room of the bodies.

use super::plan::{Leaf, Step};
use super::sizes::SIZES;
use crate::tolerances::{LOSS_ROUNDINGS, ROUTE_ROUNDINGS};
use percuss_spatial::lanes::Lanes;
use percuss_spatial::{PackedInertia, PackedWrench, Pivot};

/// How many numbers of room a step takes, for each lane: its inertia, sine and cosine (or travel), sizes of terms.
pub(super) const ROOM: usize = SIZES + 2;
pub(super) const SINE: usize = 21;
pub(super) const COSINE: usize = 22;

/// Of the struck point's wrench while it is carried to the ground.
pub(super) struct Carried<T> {
    pub wrench: PackedWrench<T>,
    /// Sizes of what its moment (N·m) and its force (N) are sums of.
    pub about: T,
    pub along: T,
    /// 1/m̄, 1/kg, and what its terms amount to.
    pub response: T,
    pub terms: T,
    pub loss: T,
}

#[inline(always)]
pub(super) fn number<T: Lanes>(slot: &[f64], number: usize) -> T {
    T::load(&slot[number * T::WIDTH..])
}

/// Adds what is left to what the carrier has.
#[inline(always)]
pub(super) fn pass<T: Lanes>(
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

impl Leaf {
    #[inline(always)]
    pub fn pivot<T: Lanes>(&self) -> Pivot<T> {
        let of = T::from_f64;
        Pivot { u: self.u.cast(), d: of(self.d), over: of(self.over), armature_part: of(self.armature_part) }
    }
}

impl<T: Lanes> Carried<T> {
    /// No wrench.
    #[inline(always)]
    pub fn none() -> Self {
        let (o, one) = (T::zero(), T::one());
        Self { wrench: PackedWrench::zero(), about: o, along: o, response: o, terms: o, loss: one }
    }

    /// Counts the ratio of a pivot's summed terms to the pivot. Returns that ratio.
    #[inline(always)]
    pub fn lose(&mut self, size: T, pivot: &Pivot<T>) -> T {
        let loss = size * pivot.over.abs();
        self.loss = self.loss.max(loss);
        loss
    }

    /// Roundings by which the terms of the response are off.
    #[inline(always)]
    pub fn roundings(&self) -> T {
        T::from_f64(ROUTE_ROUNDINGS).max(self.loss * T::from_f64(LOSS_ROUNDINGS))
    }

    /// t²/D, and its terms. Gives t/D.
    #[inline(always)]
    pub fn respond(&mut self, size: T, t: T, test: T, over: T) -> T {
        let rate = t * over;
        let part = rate.abs();
        self.response = t.mul_add(rate, self.response);
        self.terms = part.mul_add(part.mul_add(size, test + test), self.terms);
        rate
    }
}

/// What a velocity takes of the struck point's wrench. `AXIS`: which of the twist's components it is, turns first.
#[inline(always)]
pub(super) fn spend<T: Lanes, const AXIS: usize>(step: &Step, pivot: &Pivot<T>, carried: &mut Carried<T>) {
    let of = T::from_f64;
    let size = of(if AXIS < 3 { step.moment } else { step.mass });
    let (t, test) = if AXIS < 3 {
        (carried.wrench.moment[AXIS], carried.about)
    } else {
        (carried.wrench.force[AXIS - 3], carried.along)
    };
    let rate = carried.respond(size, t, test, pivot.over);
    let part = rate.abs();
    let (m, f) = (&pivot.u.moment, &pivot.u.force);
    carried.about = (m[0].abs() + m[1].abs() + m[2].abs()).mul_add(part, carried.about);
    carried.along = (f[0].abs() + f[1].abs() + f[2].abs()).mul_add(part, carried.along);
    carried.wrench.subtract(&pivot.u, rate);
}
