//! Recursion of a tree in the bodies' own axes, for one configuration per lane.
//!
//! ```text
//! U = I e,  D = e·U + armature,  t = e·f;  I ← I − U D⁻¹ Uᵀ,  f ← f − U D⁻¹ t,  response += t²/D
//! I and f to the parent
//! ```
//!
//! with e the rotation about, or the translation along, the body's z axis: an entry of I instead of a product. This
//! is the articulated-body recursion (Featherstone 2008, §7.3) that [`crate::recursion`] writes in root axes for
//! every joint and loop. This form needs no forward kinematics and no rotation of the bodies' inertias. A test
//! compares the two.

use super::cluster::{MimicCluster, eliminate_cluster_joint};
use super::contact_path::{ContactPath, TreeNormalFrame};
use super::hinge::eliminate_hinge;
use super::light_bodies::light_body_errors;
use super::parent_transform::{LanePositions, propagate_to_parent};
use super::plan::{ScheduledStep, Shape, StepForm, TreeMotion, TreeStep, Turn};
use super::prismatic_leaf;
use super::propagation::{
    COSINE, PropagatedWrench, SCRATCH_NUMBERS, SINE, add_to_parent, number, store_rate, update_wrench,
};
use super::sizes::Sizes;
use crate::columns::{PositionColumns, excess_beyond, quaternion_norm_excess};
use crate::tolerances::{LOSS_ROUNDINGS, NO_BOUND, NORMAL_ROUNDINGS, ROUTE_ROUNDINGS};
use percuss_spatial::lanes::{LARGEST_ANGLE, Lanes};
use percuss_spatial::{PackedInertia, PackedWrench, rotate_back, turn_vector};
use std::ops::Range;

/// Results of some lanes.
#[derive(Clone, Copy, Debug)]
pub(super) struct TreeResponse<T> {
    /// 1/m̄, 1/kg.
    pub response: T,
    /// Rounding error of the response in units of ε, 1/kg.
    pub error: T,
}

/// Error of the response in units of ε, 1/kg, by the kinetic energy. A rounding error of an articulated inertia has the effect of
/// an error δI of the inertia of the body itself, with vᵀ δI v ≤ κ ε vᵀ I v for every twist v. Therefore the relative error of the
/// mass matrix, and of 1/m̄, is at most ε times the largest κ. An error δf of the wrench on a body changes 1/m̄ by 2 δf·v, where
/// the twist v satisfies vᵀ I v ≤ 1/m̄.
///
/// For light bodies, both effects are computed with their own twists. The computed twists belong to the mass matrix M + δM. With
/// |δM| ≤ η M, the effect of δM on 1/m̄ is at most 1 + η times that for these twists; η = κ ε is small by
/// [`LARGEST_AMPLIFICATION`](crate::tolerances::LARGEST_AMPLIFICATION).
#[cfg_attr(not(debug_assertions), inline(always))]
fn error_by_energy<T: Lanes>(
    steps: &[ScheduledStep],
    selection: &ContactPath,
    at: LanePositions<'_>,
    propagated: &PropagatedWrench<T>,
    scratch: &mut [f64],
) -> T {
    let mut of_inertias = T::from_f64(selection.amplification) * propagated.response;
    let mut of_wrenches = propagated.by_energy * propagated.response.sqrt();
    if !selection.light_bodies.steps.is_empty() {
        let light = light_body_errors::<T>(steps, selection, at, normal_error(selection), scratch);
        of_inertias += light.of_inertias;
        of_wrenches += light.of_wrenches;
    }
    // Twice: the body's own roundings and those of its children.
    T::from_f64(2.0 * LOSS_ROUNDINGS).mul_add(of_inertias, T::from_f64(2.0 * ROUTE_ROUNDINGS) * of_wrenches)
}

/// Smaller value; `other`, a number, if `x` is NaN.
#[cfg_attr(not(debug_assertions), inline(always))]
fn smaller<T: Lanes>(x: T, other: T) -> T {
    -((-other).max(-x))
}

/// 1/m̄ of the configurations from `first` on, one per lane, and its rounding error. `scratch`: workspace of
/// all steps.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn evaluate<T: Lanes>(
    (steps, clusters): (&[ScheduledStep], &[MimicCluster]),
    selection: &ContactPath,
    columns: PositionColumns<'_>,
    first: usize,
    scratch: &mut [f64],
) -> TreeResponse<T> {
    let (beyond, travels): (T, T) = fill_joint_values(steps, selection, columns, first, scratch);
    let at = LanePositions { columns, first };
    let mut propagated = contact_wrench(steps, selection, at, scratch);
    clusters.iter().for_each(|cluster| cluster.clear::<T>(scratch));
    for (placed, on_path) in steps.iter().zip(&selection.on_path) {
        if placed.subtree_root != selection.subtree_root {
            continue;
        }
        if let Some(joint) = &placed.step.cluster_joint {
            eliminate_cluster_joint(clusters, placed, joint, *on_path, at, &mut propagated, scratch);
        } else if *on_path {
            eliminate_step::<T, true>(placed, at, &mut propagated, scratch);
        } else {
            eliminate_step::<T, false>(placed, at, &mut propagated, scratch);
        }
    }
    let stretch = (travels * T::from_f64(selection.over_travel)).max(T::one());
    let by_energy = error_by_energy(steps, selection, at, &propagated, scratch);
    let error = smaller(propagated.error_of_pivots(), by_energy) * stretch * stretch;
    // Angles beyond the range of the sine are marked as doubtful.
    TreeResponse { response: propagated.response, error: beyond.mul_add(T::from_f64(f64::MAX), error) }
}

/// Stores per joint sine and cosine of its angle, with the constant rotation to the parent added, or its travel (m).
/// Returns the excess of angles and quaternion norms beyond their accepted range (0 if all are accepted), and the
/// largest travel, m.
#[cfg_attr(not(debug_assertions), inline(always))]
fn fill_joint_values<T: Lanes>(
    steps: &[ScheduledStep],
    selection: &ContactPath,
    columns: PositionColumns<'_>,
    first: usize,
    scratch: &mut [f64],
) -> (T, T) {
    let (mut beyond, mut angles, mut travels) = (T::zero(), T::zero(), T::zero());
    for (placed, on_path) in steps.iter().zip(&selection.on_path) {
        // The joints above the top of the path rotate normals given in the root link.
        if placed.subtree_root != selection.subtree_root && !on_path {
            continue;
        }
        let step = &placed.step;
        if placed.number == selection.subtree_root {
            // A position above the path does not change m̄, but must be a finite number.
            beyond += nan_unless_finite::<T>(columns, step.positions(), first);
        }
        let slot = &mut scratch[placed.number * SCRATCH_NUMBERS * T::WIDTH..][..SCRATCH_NUMBERS * T::WIDTH];
        match step.motion {
            TreeMotion::Turn { q } => {
                let angle: T = step.own_position(columns.at(q, first));
                angles = angles.max(angle.abs());
                let (mut sin, mut cos) = angle.sin_cos();
                match step.parent_transform.turn_z {
                    None => {}
                    Some(Turn { cos: 0.0, sin: 1.0 }) => (sin, cos) = (cos, -sin),
                    Some(Turn { cos: 0.0, sin: -1.0 }) => (sin, cos) = (-cos, sin),
                    Some(turn) => {
                        let (s, c) = (T::from_f64(turn.sin), T::from_f64(turn.cos));
                        (sin, cos) = (s.mul_add(cos, c * sin), c.mul_add(cos, -(s * sin)));
                    }
                }
                sin.store(&mut slot[SINE * T::WIDTH..]);
                cos.store(&mut slot[COSINE * T::WIDTH..]);
            }
            TreeMotion::Slide { q } => {
                let travel: T = step.own_position(columns.at(q, first));
                travels = travels.max(travel.abs());
                travel.store(&mut slot[SINE * T::WIDTH..]);
            }
            TreeMotion::Planar { q } => {
                for k in 0..2 {
                    travels = travels.max(columns.at::<T>(q + k, first).abs());
                }
                let angle: T = columns.at(q + 2, first);
                angles = angles.max(angle.abs());
                let (sin, cos) = angle.sin_cos();
                sin.store(&mut slot[SINE * T::WIDTH..]);
                cos.store(&mut slot[COSINE * T::WIDTH..]);
            }
            TreeMotion::Ball { q } => beyond += quaternion_norm_excess::<T>(columns, q, first),
            TreeMotion::Floating { q } => {
                for k in 0..3 {
                    travels = travels.max(columns.at::<T>(q + k, first).abs());
                }
                beyond += quaternion_norm_excess::<T>(columns, q + 3, first);
            }
            TreeMotion::Base => {}
        }
    }
    // The sine of NaN is NaN.
    (beyond + excess_beyond(angles, LARGEST_ANGLE), travels)
}

/// Zero if all positions are finite, otherwise NaN.
#[cfg_attr(not(debug_assertions), inline(always))]
fn nan_unless_finite<T: Lanes>(columns: PositionColumns<'_>, positions: Range<usize>, first: usize) -> T {
    let (mut q, mut sum) = (positions.start, T::zero());
    while q < positions.end {
        let position: T = columns.at(q, first);
        sum = position.mul_add(T::zero(), sum);
        q += 1;
    }
    sum
}

/// Error of the normal by its rotations from the root link to the contact link, relative to the error of a wrench.
fn normal_error(selection: &ContactPath) -> f64 {
    match selection.contact.normal_frame {
        TreeNormalFrame::Body => 0.0,
        TreeNormalFrame::Root => NORMAL_ROUNDINGS / ROUTE_ROUNDINGS * selection.path.len() as f64,
    }
}

/// Unit force at the contact point.
#[cfg_attr(not(debug_assertions), inline(always))]
fn contact_wrench<T: Lanes>(
    steps: &[ScheduledStep],
    selection: &ContactPath,
    at: LanePositions<'_>,
    scratch: &[f64],
) -> PropagatedWrench<T> {
    let contact = &selection.contact;
    let mut n: [T; 3] = contact.normals(at);
    if let TreeNormalFrame::Root = contact.normal_frame {
        for &place in &selection.path {
            let placed = &steps[place];
            let slot = &scratch[placed.number * SCRATCH_NUMBERS * T::WIDTH..][..SCRATCH_NUMBERS * T::WIDTH];
            rotate_to_body(&placed.step, &mut n, at, slot);
        }
    }
    let arm: T = contact.arms(at);
    let q: [T; 3] = contact.points(at);
    let moment = [
        q[1].mul_add(n[2], -(q[2] * n[1])),
        q[2].mul_add(n[0], -(q[0] * n[2])),
        q[0].mul_add(n[1], -(q[1] * n[0])),
    ];
    let contact_body = selection.path.last().map(|&place| &steps[place].step.share);
    let power = contact_body.map_or(T::from_f64(NO_BOUND), |share| match share.is_light() {
        true => T::zero(),
        false => arm.mul_add(T::from_f64(share.angular), T::from_f64(share.linear)),
    });
    PropagatedWrench {
        wrench: PackedWrench { moment, force: n },
        moment_size: arm,
        force_size: T::one(),
        by_energy: T::from_f64(normal_error(selection)) * power,
        ..PropagatedWrench::none()
    }
}

/// Vector from the parent's frame to the body's.
#[cfg_attr(not(debug_assertions), inline(always))]
fn rotate_to_body<T: Lanes>(step: &TreeStep, n: &mut [T; 3], at: LanePositions<'_>, slot: &[f64]) {
    if let Some(turn) = step.parent_transform.last_turn_z {
        let (c, s) = back::<T>(turn);
        turn_vector::<T, 2>(n, c, s);
    }
    match step.parent_transform.shape {
        Shape::Parallel => {}
        Shape::Right => (n[1], n[2]) = (n[2], -n[1]),
        Shape::Skew | Shape::General => {
            let (c, s) = back::<T>(step.parent_transform.tilt);
            turn_vector::<T, 0>(n, c, s);
        }
    }
    match (step.motion, step.parent_transform.turn_z) {
        // The angle includes the rotation of the transform.
        (TreeMotion::Turn { .. }, _) | (_, None) => {}
        (_, Some(turn)) => {
            let (c, s) = back::<T>(turn);
            turn_vector::<T, 2>(n, c, s);
        }
    }
    match step.motion {
        TreeMotion::Turn { .. } | TreeMotion::Planar { .. } => {
            let (s, c): (T, T) = (number(slot, SINE), number(slot, COSINE));
            turn_vector::<T, 2>(n, c, -s);
        }
        TreeMotion::Ball { q } => rotate_back(n, &at.rotation(q)),
        TreeMotion::Floating { q } => rotate_back(n, &at.rotation(q + 3)),
        TreeMotion::Slide { .. } | TreeMotion::Base => {}
    }
}

/// Cosine and sine of the opposite rotation.
#[cfg_attr(not(debug_assertions), inline(always))]
fn back<T: Lanes>(turn: Turn) -> (T, T) {
    (T::from_f64(turn.cos), T::from_f64(-turn.sin))
}

/// Eliminates the joint of a body and adds the remaining inertia to the parent.
#[cfg_attr(not(debug_assertions), inline(always))]
fn eliminate_step<T: Lanes, const ON_PATH: bool>(
    placed: &ScheduledStep,
    at: LanePositions<'_>,
    propagated: &mut PropagatedWrench<T>,
    scratch: &mut [f64],
) {
    let step = &placed.step;
    let (rest, own) = scratch.split_at_mut(placed.number * SCRATCH_NUMBERS * T::WIDTH);
    let own = &mut own[..SCRATCH_NUMBERS * T::WIDTH];
    match placed.form {
        StepForm::GroundHinge => eliminate_ground_hinge(step, propagated, own),
        StepForm::Hinge(form) => {
            let Some(parent) = step.parent else { return };
            let slot = &mut rest[parent * SCRATCH_NUMBERS * T::WIDTH..][..SCRATCH_NUMBERS * T::WIDTH];
            eliminate_hinge::<T, ON_PATH>(form, placed, propagated, own, slot);
        }
        StepForm::PrismaticLeaf if !ON_PATH => {
            let (Some(parent), Some(leaf)) = (step.parent, &placed.prismatic_leaf) else { return };
            propagated.loss = propagated.loss.max(T::from_f64(leaf.loss));
            let slot = &mut rest[parent * SCRATCH_NUMBERS * T::WIDTH..][..SCRATCH_NUMBERS * T::WIDTH];
            prismatic_leaf::add_polynomial_inertia::<T>(leaf, number(own, SINE), placed.is_first, slot);
            leaf.sizes.cast::<T>().add_to_parent(step.reach, placed.is_first, slot);
        }
        StepForm::PrismaticLeaf | StepForm::General | StepForm::OfCluster => {
            eliminate_general_joint::<T>(placed, ON_PATH, at, propagated, rest, own)
        }
    }
}

/// Eliminates a hinge on the ground. Only one entry of its inertia is needed. The other entries are not computed, so the
/// size of this entry is used for all.
#[cfg_attr(not(debug_assertions), inline(always))]
fn eliminate_ground_hinge<T: Lanes>(step: &TreeStep, propagated: &mut PropagatedWrench<T>, own: &mut [f64]) {
    let of = T::from_f64;
    let d = number::<T>(own, 5) + of(step.armature[2]);
    let rate = propagated.add_response(
        of(step.moment),
        propagated.wrench.moment[2],
        propagated.moment_size,
        T::one() / d,
    );
    store_rate(rate, 2, own);
    propagated.add_share(&step.share, own);
}

/// Eliminates any joint with any transform, on the contact path or not, and adds the remaining inertia to the parent's.
/// `propagated`: propagated test wrench; `own` and `rest`: workspaces of the body and of the bodies before it.
#[cfg_attr(not(debug_assertions), inline(always))]
fn eliminate_general_joint<T: Lanes>(
    placed: &ScheduledStep,
    on_path: bool,
    at: LanePositions<'_>,
    propagated: &mut PropagatedWrench<T>,
    rest: &mut [f64],
    own: &mut [f64],
) {
    let step = &placed.step;
    let (mut inertia, sizes) = eliminate_velocities::<T>(step, on_path, propagated, own);
    if on_path {
        propagated.add_share(&step.share, own);
    }
    let Some(parent) = step.parent.filter(|_| !step.transmits_nothing()) else { return };
    propagate_to_parent::<T>(step, &mut inertia, on_path, at, propagated, own);
    if on_path {
        propagated.moment_size =
            T::from_f64(step.reach).mul_add(propagated.force_size, propagated.moment_size);
    }
    let slot = &mut rest[parent * SCRATCH_NUMBERS * T::WIDTH..][..SCRATCH_NUMBERS * T::WIDTH];
    add_to_parent(&mut inertia, &placed.parent_inertia, placed.is_first, slot);
    sizes.add_to_parent(step.reach, placed.is_first, slot);
}

/// Remaining inertia of a body after the elimination of its joint, and the sizes of its terms.
#[cfg_attr(not(debug_assertions), inline(always))]
fn eliminate_velocities<T: Lanes>(
    step: &TreeStep,
    on_path: bool,
    propagated: &mut PropagatedWrench<T>,
    own: &mut [f64],
) -> (PackedInertia<T>, Sizes<T>) {
    if let Some(leaf) = &step.leaf {
        propagated.loss = propagated.loss.max(T::from_f64(leaf.loss));
        match step.motion {
            TreeMotion::Slide { .. } if on_path => {
                update_wrench::<T, 5>(step, &leaf.pivot(), propagated, own)
            }
            _ if on_path => update_wrench::<T, 2>(step, &leaf.pivot(), propagated, own),
            _ => {}
        }
        return (leaf.left.cast(), leaf.sizes.cast());
    }
    let mut inertia: PackedInertia<T> =
        if step.has_child_inertia { PackedInertia::load(own) } else { step.own.inertia.cast() };
    if let TreeMotion::Planar { .. } = step.motion {
        // The translations of the joint do not rotate with the body.
        let (s, c): (T, T) = (number(own, SINE), number(own, COSINE));
        inertia.turn::<2>(c, s);
        if on_path {
            propagated.wrench.turn::<2>(c, s);
        }
    }
    // Computed before any velocity of the joint is eliminated: the last pivots are differences of these sizes.
    let mut sizes = Sizes::of(&inertia, step.has_child_inertia, own);
    macro_rules! velocity {
        ($component:literal, $size:ident, $pivot:ident, $eliminate:ident, $axis:literal) => {
            if step.free[$component] {
                let pivot = inertia.$pivot::<$axis>(T::from_f64(step.armature[$component]));
                let loss = propagated.record_loss(sizes.$size, &pivot);
                if on_path {
                    update_wrench::<T, $component>(step, &pivot, propagated, own);
                }
                inertia.$eliminate::<$axis>(&pivot, &pivot.u.scaled(pivot.inverse_d));
                sizes = sizes.amplified(loss);
            }
        };
    }
    velocity!(3, mass, slide_pivot, eliminate_slide, 0);
    velocity!(4, mass, slide_pivot, eliminate_slide, 1);
    velocity!(5, mass, slide_pivot, eliminate_slide, 2);
    velocity!(0, moment, turn_pivot, eliminate_turn, 0);
    velocity!(1, moment, turn_pivot, eliminate_turn, 1);
    velocity!(2, moment, turn_pivot, eliminate_turn, 2);
    (inertia, sizes)
}
