//! Prismatic leaves off the contact path. Their remaining inertia is constant in their own axes, so it is a
//! polynomial of the travel in the parent's frame.

use super::parent_transform::{LanePositions, transform_to_parent};
use super::plan::{PrismaticLeaf, ScheduledStep, StepForm, TreeMotion};
use crate::columns::PositionColumns;
use percuss_spatial::PackedInertia;
use percuss_spatial::lanes::{Lanes, Single};

type SingleLane = Single;

/// Finds the prismatic leaves that pass on an inertia.
pub(super) fn find_prismatic_leaves(steps: &mut [ScheduledStep]) {
    for placed in steps {
        let propagated = placed.step.parent.is_some() && !placed.step.transmits_nothing();
        if let (true, TreeMotion::Slide { .. }, Some(leaf)) =
            (propagated, placed.step.motion, &placed.step.leaf)
        {
            let mut constant = inertia_in_parent_frame(placed, leaf.left);
            if placed.is_first {
                constant.add(&placed.parent_inertia.cast());
            }
            let [slope, bend] =
                leaf.left.shift_coefficients::<2>().map(|rate| inertia_in_parent_frame(placed, rate).plain());
            let constant = constant.plain();
            let prismatic =
                PrismaticLeaf { constant, slope, bend: bend.angular, loss: leaf.loss, sizes: leaf.sizes };
            placed.prismatic_leaf = Some(Box::new(prismatic));
            placed.form = StepForm::PrismaticLeaf;
        }
    }
}

/// Inertia of a slide at 0 in the parent's frame, or its rate: a linear map of its numbers.
fn inertia_in_parent_frame(placed: &ScheduledStep, inertia: PackedInertia<f64>) -> PackedInertia<SingleLane> {
    let mut moved = inertia.cast();
    let at = LanePositions { columns: PositionColumns { values: &[], stride: 0 }, first: 0 };
    transform_to_parent(&placed.step, &mut moved, at, &[0.0; 2]);
    moved
}

/// Adds I₀ + q I₁ + q² I₂ to the parent's inertia; the first child brings the parent's own.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn add_polynomial_inertia<T: Lanes>(
    leaf: &PrismaticLeaf,
    travel: T,
    is_first: bool,
    slot: &mut [f64],
) {
    let of = T::from_f64;
    let PrismaticLeaf { constant, slope, bend, .. } = leaf;
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
