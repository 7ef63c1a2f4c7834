//! Prismatic leaves off the contact path. Their remaining inertia is constant in their own axes, so it is a
//! polynomial of the travel in the parent's frame.

use super::carried::{Carried, ROOM};
use super::plan::{Form, Motion, Placed, Slid};
use super::way::{At, go};
use crate::kernels::estimate::Columns;
use percuss_spatial::PackedInertia;
use percuss_spatial::lanes::{Lanes, Portable};

type One = Portable<1>;

/// Finds the prismatic leaves that pass on an inertia.
pub(super) fn find(steps: &mut [Placed]) {
    for placed in steps {
        let carried = placed.step.parent.is_some() && !placed.step.lets_go();
        if let (true, Motion::Slide { .. }, Some(leaf)) = (carried, placed.step.motion, &placed.step.leaf) {
            let mut constant = in_the_carriers(placed, leaf.left);
            if placed.is_first {
                constant.add(&placed.above.cast());
            }
            let [slope, bend] = leaf.left.along::<2>().map(|rate| in_the_carriers(placed, rate).plain());
            let constant = constant.plain();
            let slid = Slid { constant, slope, bend: bend.angular, loss: leaf.loss, sizes: leaf.sizes };
            placed.slid = Some(Box::new(slid));
            placed.form = Form::Slid;
        }
    }
}

/// Inertia of a slide at 0 in the parent's frame, or its rate: a linear map of its numbers.
fn in_the_carriers(placed: &Placed, inertia: PackedInertia<f64>) -> PackedInertia<One> {
    let mut moved = inertia.cast();
    let at = At { columns: Columns { values: &[], stride: 0 }, first: 0 };
    go(&placed.step, &mut moved, false, at, &mut Carried::none(), &[0.0; ROOM]);
    moved
}

/// Adds I₀ + q I₁ + q² I₂ to the parent's inertia; the first child brings the parent's own.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn pass<T: Lanes>(slid: &Slid, travel: T, is_first: bool, slot: &mut [f64]) {
    let of = T::from_f64;
    let Slid { constant, slope, bend, .. } = slid;
    let mut inertia: PackedInertia<T> = constant.cast();
    for k in 0..6 {
        let rate = travel.mul_add(of(bend[k]), of(slope.angular[k]));
        inertia.angular[k] = travel.mul_add(rate, inertia.angular[k]);
    }
    for i in 0..3 {
        for k in 0..3 {
            inertia.coupling[i][k] = travel.mul_add(of(slope.coupling[i][k]), inertia.coupling[i][k]);
        }
    }
    if !is_first {
        inertia.add(&PackedInertia::load(slot));
    }
    inertia.store(slot);
}
