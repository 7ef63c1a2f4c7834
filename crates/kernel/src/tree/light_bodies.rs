//! Bodies that are light compared with their subtree. The kinetic energy of such a body bounds its twist only weakly, so its
//! twist after a unit impulse is computed.

use super::contact_path::ContactPath;
use super::error_bound::EnergyError;
use super::parent_transform::{LanePositions, transform_twist_to_body};
use super::plan::{ScheduledStep, StepForm, TreeMotion, TreeStep};
use super::propagation::{PropagatedWrench, smaller};
use super::workspace::{COSINE, Offsets, SINE, TWIST, number, stored_sizes};
use crate::tolerances::{LARGEST_AMPLIFICATION, NO_BOUND};
use percuss_spatial::lanes::Lanes;
use percuss_spatial::{PackedInertia, PackedTwist, PackedWrench};

/// Adds the change of 1/m̄ by errors of the inertias and wrenches at the light bodies. Their twists after a unit impulse follow from the
/// pivots of the recursion: v = v_parent + Σ e q̇ with q̇ = t/D − (U/D)·v.
///
/// The computed twists belong to the mass matrix M + δM. With |δM| ≤ η M, the effect of δM on 1/m̄ is at most 1 + η times that for
/// these twists; η = κ ε is small by [`LARGEST_AMPLIFICATION`].
///
/// If sizes are tracked, the inertias at this configuration are used, because the bounds by rigid subtrees are much too large for long
/// chains. Their rounding counts twice: at the twist of the body and, for the inertia that the parent receives, at the twist of the parent.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn add_light_body_errors<T: Lanes>(
    steps: &[ScheduledStep],
    selection: &ContactPath,
    at: LanePositions<'_>,
    propagated: &PropagatedWrench<T>,
    scratch: &mut [f64],
    errors: &mut EnergyError<T>,
) {
    let (arm, bound) = (selection.contact.arms::<T>(at), &selection.bound);
    let mut amplification = T::zero();
    for light in &bound.twist_steps {
        let placed = &steps[light.at];
        let (step, offsets) = (&placed.step, &placed.offsets);
        let mut twist = PackedTwist::zero();
        if let Some(parent) = step.parent.filter(|_| !placed.is_root()) {
            twist = load_twist(&steps[steps.len() - 1 - parent].offsets, scratch);
            transform_twist_to_body(step, &mut twist, at, offsets.joint::<T>(scratch));
        }
        let by_parent = twist;
        let on_path = selection.branches.roles[light.at].is_on_path();
        add_joint_velocities(placed, on_path, &mut twist, scratch);
        store_twist(&twist, offsets, scratch);
        if step.share.is_light() {
            let (angular, linear) = (norm(&twist.angular), norm(&twist.linear));
            let mut roots = step.share.roots.map(T::from_f64);
            if propagated.tracks_sizes {
                roots = roots_here(placed, roots, scratch);
                errors.add_inertia(roots, norm(&by_parent.angular), norm(&by_parent.linear));
                let largest = [step.share.angular, step.share.linear].map(T::from_f64);
                let root = roots[0].mul_add(largest[0], roots[1] * largest[1]);
                amplification = amplification.max(root * root);
            }
            errors.add_inertia(roots, angular, linear);
            let power = if !propagated.tracks_sizes {
                light.size.power(arm, propagated.response.sqrt(), angular, linear)
            } else if on_path {
                let [moment, force] = stored_sizes::<T>(offsets, scratch);
                moment.mul_add(angular, force * linear)
            } else {
                T::zero()
            };
            errors.of_wrenches += power * T::from_f64(1.0 + light.contact_error);
        }
    }
    let excess = (amplification - T::from_f64(LARGEST_AMPLIFICATION)).max(T::zero());
    errors.of_inertias = excess.mul_add(T::from_f64(NO_BOUND), errors.of_inertias);
}

/// √moment (√(kg·m²)) and √mass (√kg) of the terms of a light body's articulated inertia at this configuration, at most `constant`. The
/// traces of the inertia bound its terms; mass · reach² bounds the terms of the shift to the parent's origin, `carried` those of children
/// that are not light.
#[cfg_attr(not(debug_assertions), inline(always))]
fn roots_here<T: Lanes>(placed: &ScheduledStep, constant: [T; 2], scratch: &[f64]) -> [T; 2] {
    let (step, stored) = (&placed.step, placed.offsets.inertia::<T>(scratch));
    if !step.has_child_inertia {
        return constant;
    }
    let [moment, mass] = step.share.carried.map(T::from_f64);
    if placed.form == StepForm::GroundHinge {
        // Only the moment about the hinge is stored; the other entries have no effect.
        return [smaller((moment + number::<T>(stored, 5)).sqrt(), constant[0]), constant[1]];
    }
    let inertia: PackedInertia<T> = PackedInertia::load(stored);
    let of_reach = T::from_f64(step.reach * step.reach);
    let moment = inertia.mass_size().mul_add(of_reach, inertia.moment_size() + moment);
    [smaller(moment.sqrt(), constant[0]), smaller((inertia.mass_size() + mass).sqrt(), constant[1])]
}

/// Stores the twist of a light body in its workspace.
#[cfg_attr(not(debug_assertions), inline(always))]
fn store_twist<T: Lanes>(twist: &PackedTwist<T>, offsets: &Offsets, scratch: &mut [f64]) {
    let Some(light) = offsets.light else { return };
    for k in 0..3 {
        twist.angular[k].store(&mut scratch[(light + TWIST + k) * T::WIDTH..]);
        twist.linear[k].store(&mut scratch[(light + TWIST + 3 + k) * T::WIDTH..]);
    }
}

/// Loads a twist written by [`store_twist`].
#[cfg_attr(not(debug_assertions), inline(always))]
fn load_twist<T: Lanes>(offsets: &Offsets, scratch: &[f64]) -> PackedTwist<T> {
    let mut twist = PackedTwist::zero();
    let Some(light) = offsets.light else { return twist };
    for k in 0..3 {
        twist.angular[k] = number(scratch, light + TWIST + k);
        twist.linear[k] = number(scratch, light + TWIST + 3 + k);
    }
    twist
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn norm<T: Lanes>(v: &[T; 3]) -> T {
    v[0].mul_add(v[0], v[1].mul_add(v[1], v[2] * v[2])).sqrt()
}

/// Adds the joint's velocities to the parent's twist, both in the body's frame.
#[cfg_attr(not(debug_assertions), inline(always))]
fn add_joint_velocities<T: Lanes>(
    placed: &ScheduledStep,
    on_path: bool,
    twist: &mut PackedTwist<T>,
    scratch: &[f64],
) {
    let (step, offsets) = (&placed.step, &placed.offsets);
    let rate = |component: usize| match offsets.light {
        Some(light) if on_path => number(scratch, light + component),
        _ => T::zero(),
    };
    if placed.form == StepForm::GroundHinge {
        twist.angular[2] += rate(2);
        return;
    }
    if let Some(leaf) = &step.leaf {
        let pivot = leaf.pivot::<T>();
        let transmitted = twist.power(&pivot.u) * pivot.inverse_d;
        match step.motion {
            TreeMotion::Slide { .. } => twist.linear[2] += rate(5) - transmitted,
            _ => twist.angular[2] += rate(2) - transmitted,
        }
        return;
    }
    if let StepForm::Hinge(_) = placed.form {
        let pivot =
            PackedInertia::load(offsets.inertia::<T>(scratch)).turn_pivot::<2>(T::from_f64(step.armature[2]));
        twist.angular[2] += rate(2) - twist.power(&pivot.u) * pivot.inverse_d;
        return;
    }
    let joint = offsets.joint::<T>(scratch);
    let over_d = eliminated_columns::<T>(step, offsets.inertia::<T>(scratch), joint);
    // The velocity eliminated last depends on the parent's twist alone.
    macro_rules! velocity {
        ($component:literal, $part:ident, $axis:literal) => {
            if step.free[$component] {
                twist.$part[$axis] += rate($component) - twist.power(&over_d[$component]);
            }
        };
    }
    velocity!(2, angular, 2);
    velocity!(1, angular, 1);
    velocity!(0, angular, 0);
    velocity!(5, linear, 2);
    velocity!(4, linear, 1);
    velocity!(3, linear, 0);
    if let TreeMotion::Planar { .. } = step.motion {
        twist.turn_back::<2>(number(joint, COSINE), number(joint, SINE));
    }
}

/// Columns U/D of the joint's velocities, eliminated again from the stored inertia.
#[cfg_attr(not(debug_assertions), inline(always))]
fn eliminated_columns<T: Lanes>(step: &TreeStep, inertia: &[f64], joint: &[f64]) -> [PackedWrench<T>; 6] {
    let mut inertia: PackedInertia<T> =
        if step.has_child_inertia { PackedInertia::load(inertia) } else { step.own.inertia.cast() };
    if let TreeMotion::Planar { .. } = step.motion {
        inertia.turn::<2>(number(joint, COSINE), number(joint, SINE));
    }
    let mut over_d = [PackedWrench::zero(); 6];
    macro_rules! velocity {
        ($component:literal, $pivot:ident, $eliminate:ident, $axis:literal) => {
            if step.free[$component] {
                let pivot = inertia.$pivot::<$axis>(T::from_f64(step.armature[$component]));
                over_d[$component] = pivot.u.scaled(pivot.inverse_d);
                inertia.$eliminate::<$axis>(&pivot, &over_d[$component]);
            }
        };
    }
    velocity!(3, slide_pivot, eliminate_slide, 0);
    velocity!(4, slide_pivot, eliminate_slide, 1);
    velocity!(5, slide_pivot, eliminate_slide, 2);
    velocity!(0, turn_pivot, eliminate_turn, 0);
    velocity!(1, turn_pivot, eliminate_turn, 1);
    velocity!(2, turn_pivot, eliminate_turn, 2);
    over_d
}
