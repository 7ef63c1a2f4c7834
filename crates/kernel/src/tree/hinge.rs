//! Elimination of a hinge with a short transform to its parent, the most common joint: code without branches for each
//! form.

use super::plan::{HingeForm, ScheduledStep, Shape};
use super::propagation::{PropagatedWrench, add_to_parent, update_wrench};
use super::workspace::{COSINE, SINE, Sizes, number};
use percuss_spatial::PackedInertia;
use percuss_spatial::lanes::Lanes;

/// Eliminates a hinge and adds the remaining inertia to the parent.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn eliminate_hinge<T: Lanes, const ON_PATH: bool>(
    form: HingeForm,
    placed: &ScheduledStep,
    propagated: &mut PropagatedWrench<T>,
    scratch: &mut [f64],
) {
    let HingeForm { shape, bare, leaf, is_parent_on_ground: next_to_last } = form;
    macro_rules! variant {
        ($bare:literal, $leaf:literal, $next_to_last:literal) => {
            eliminate_hinge_variant::<T, ON_PATH, $bare, $leaf, $next_to_last>(
                shape, placed, propagated, scratch,
            )
        };
    }
    // Compile time grows with the number of variants. Leaves have no variant for a parent on the ground.
    match (bare, leaf, next_to_last) {
        (true, true, _) => variant!(true, true, false),
        (true, false, true) => variant!(true, false, true),
        (true, false, false) => variant!(true, false, false),
        (false, true, _) => variant!(false, true, false),
        (false, false, true) => variant!(false, false, true),
        (false, false, false) => variant!(false, false, false),
    }
}

/// A hinge with its transform. `BARE`: no armature, so that row z of the remaining inertia is zero.
#[cfg_attr(not(debug_assertions), inline(always))]
fn eliminate_hinge_variant<
    T: Lanes,
    const ON_PATH: bool,
    const BARE: bool,
    const LEAF: bool,
    const NEXT_TO_LAST: bool,
>(
    shape: Shape,
    placed: &ScheduledStep,
    propagated: &mut PropagatedWrench<T>,
    scratch: &mut [f64],
) {
    let of = T::from_f64;
    let ScheduledStep { step, offsets, parent_inertia: above, is_first, .. } = placed;
    let tracks_sizes = propagated.tracks_sizes;
    let mut inertia = if LEAF {
        let Some(leaf) = &step.leaf else { return };
        if tracks_sizes {
            propagated.sizes.record_loss(of(leaf.loss));
            placed.add_sizes_to_parent(leaf.sizes.cast::<T>(), scratch);
        }
        if ON_PATH {
            update_wrench::<T, 2>(step, offsets, &leaf.pivot(), propagated, scratch);
        }
        let mut left = leaf.left.cast();
        if BARE {
            left.clear_row::<2>();
        }
        left
    } else {
        let stored = offsets.inertia::<T>(scratch);
        let mut inertia = PackedInertia::load(stored);
        let pivot = inertia.turn_pivot::<2>(of(step.armature[2]));
        if tracks_sizes {
            let sizes = Sizes::of(&inertia, true, stored);
            let loss = sizes.moment * pivot.inverse_d.abs();
            propagated.sizes.record_loss(loss);
            placed.add_sizes_to_parent(sizes.amplified(loss), scratch);
        }
        if ON_PATH {
            update_wrench::<T, 2>(step, offsets, &pivot, propagated, scratch);
        }
        let over_d = pivot.u.scaled(pivot.inverse_d);
        if BARE {
            inertia.eliminate_bare_turn::<2>(&pivot, &over_d);
        } else {
            inertia.eliminate_turn::<2>(&pivot, &over_d);
        }
        inertia
    };
    let transform = &step.parent_transform;
    let joint = offsets.joint::<T>(scratch);
    let (s, c): (T, T) = (number(joint, SINE), number(joint, COSINE));
    let (along_z, along_x) = (of(transform.along_z), of(transform.shift[0]));
    let (tilt_c, tilt_s) = (of(transform.tilt.cos), of(transform.tilt.sin));
    if BARE {
        inertia.screw_without::<2, 2>(c, s, along_z);
    } else {
        inertia.screw::<2>(c, s, along_z);
    }
    match shape {
        Shape::Right => {
            inertia.turn_right::<0>();
            inertia.shift::<0>(along_x);
        }
        Shape::Parallel => inertia.shift::<0>(along_x),
        _ if BARE => inertia.screw_without::<0, 2>(tilt_c, tilt_s, along_x),
        _ => inertia.screw::<0>(tilt_c, tilt_s, along_x),
    }
    if ON_PATH {
        let wrench = &mut propagated.wrench;
        wrench.screw::<2>(c, s, along_z);
        match shape {
            Shape::Right => wrench.turn_right::<0>(),
            Shape::Parallel => {}
            Shape::Skew | Shape::General => wrench.turn::<0>(tilt_c, tilt_s),
        }
        wrench.shift::<0>(along_x);
        if tracks_sizes {
            propagated.sizes.add_reach(step.reach);
            propagated.sizes.add_share(&step.share, offsets, scratch);
        }
    }
    let slot = offsets.parent_inertia::<T>(scratch);
    if NEXT_TO_LAST {
        // The compiler drops the entries that no caller reads.
        let known = if *is_first { of(above.angular[5]) } else { number(slot, 5) };
        (known + inertia.angular[5]).store(&mut slot[5 * T::WIDTH..]);
    } else {
        add_to_parent(&mut inertia, above, *is_first, slot);
    }
}
