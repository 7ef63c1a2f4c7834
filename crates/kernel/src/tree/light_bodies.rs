//! Bodies that are light compared with what they carry. The kinetic energy of such a body bounds its twist only weakly, so its
//! twist after a unit impulse is computed.

use super::contact_path::ContactPath;
use super::parent_transform::{LanePositions, transform_twist_to_body};
use super::plan::{ScheduledStep, StepForm, TreeMotion, TreeStep};
use super::propagation::{
    COSINE, SCRATCH_NUMBERS, SINE, load_twist, number, store_twist, stored_rate, stored_wrench_sizes,
};
use percuss_spatial::lanes::Lanes;
use percuss_spatial::{PackedInertia, PackedTwist, PackedWrench};

/// Change of 1/m̄ by errors of the inertias and wrenches at the light bodies, per unit of relative error.
pub(super) struct LightBodyErrors<T> {
    /// Sum of (√moment |ω| + √mass |v|)² with the bounds of the articulated inertia, 1/kg.
    pub of_inertias: T,
    /// Power of the sizes of the wrenches, 1/kg.
    pub of_wrenches: T,
}

/// Computes the twists of the light bodies after a unit impulse from the pivots of the recursion:
/// v = v_parent + Σ e q̇ with q̇ = t/D − (U/D)·v. `normal_error`: error of the normal relative to that of a wrench.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn light_body_errors<T: Lanes>(
    steps: &[ScheduledStep],
    selection: &ContactPath,
    at: LanePositions<'_>,
    normal_error: f64,
    scratch: &mut [f64],
) -> LightBodyErrors<T> {
    let mut errors = LightBodyErrors { of_inertias: T::zero(), of_wrenches: T::zero() };
    for &index in &selection.light_bodies.steps {
        let (placed, on_path) = (&steps[index], selection.on_path[index]);
        let step = &placed.step;
        let (rest, own) = scratch.split_at_mut(placed.number * SCRATCH_NUMBERS * T::WIDTH);
        let own = &mut own[..SCRATCH_NUMBERS * T::WIDTH];
        let mut twist = PackedTwist::zero();
        if let Some(parent) = step.parent.filter(|_| placed.number != selection.subtree_root) {
            twist = load_twist(&rest[parent * SCRATCH_NUMBERS * T::WIDTH..]);
            transform_twist_to_body(step, &mut twist, at, own);
        }
        add_joint_velocities(placed, on_path, &mut twist, own);
        store_twist(&twist, own);
        if step.share.is_light() {
            let (angular, linear) = (norm(&twist.angular), norm(&twist.linear));
            let [root_moment, root_mass] = step.share.roots.map(T::from_f64);
            let root = root_moment.mul_add(angular, root_mass * linear);
            errors.of_inertias = root.mul_add(root, errors.of_inertias);
            if on_path {
                let (moment, force) = stored_wrench_sizes::<T>(own);
                errors.of_wrenches += moment.mul_add(angular, force * linear);
            }
            if selection.path.last() == Some(&index) {
                let arm = selection.contact.arms::<T>(at);
                errors.of_wrenches += T::from_f64(normal_error) * arm.mul_add(angular, linear);
            }
        }
    }
    errors
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
    own: &[f64],
) {
    let step = &placed.step;
    let rate = |component: usize| if on_path { stored_rate(own, component) } else { T::zero() };
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
        let pivot = PackedInertia::load(own).turn_pivot::<2>(T::from_f64(step.armature[2]));
        twist.angular[2] += rate(2) - twist.power(&pivot.u) * pivot.inverse_d;
        return;
    }
    let over_d = eliminated_columns::<T>(step, own);
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
        twist.turn_back::<2>(number(own, COSINE), number(own, SINE));
    }
}

/// Columns U/D of the joint's velocities, eliminated again from the stored inertia.
#[cfg_attr(not(debug_assertions), inline(always))]
fn eliminated_columns<T: Lanes>(step: &TreeStep, own: &[f64]) -> [PackedWrench<T>; 6] {
    let mut inertia: PackedInertia<T> =
        if step.has_child_inertia { PackedInertia::load(own) } else { step.own.inertia.cast() };
    if let TreeMotion::Planar { .. } = step.motion {
        inertia.turn::<2>(number(own, COSINE), number(own, SINE));
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
