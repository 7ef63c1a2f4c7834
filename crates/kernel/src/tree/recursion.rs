//! Recursion of a tree in the bodies' own axes, for one configuration per lane.
//!
//! ```text
//! U = I e,  D = e·U + armature,  t = e·f;  I ← I − U D⁻¹ Uᵀ,  f ← f − U D⁻¹ t,  response += t²/D
//! I and f to the parent
//! ```
//!
//! with e the rotation about, or the translation along, the body's z axis: an entry of I instead of a product. This
//! is the articulated-body recursion (Featherstone 2008, §7.3) without forward kinematics and without rotations of the bodies' inertias.
//! For a contact between two bodies, the forces on both are propagated separately up to their first common ancestor; one is stored in the
//! workspace while the other is propagated.

use super::branches::{Branches, StepRole, TreeNormalFrame};
use super::cluster::{MimicCluster, eliminate_cluster_joint};
use super::contact_path::{ContactPath, TreeLine};
use super::hinge::eliminate_hinge;
use super::light_bodies::add_light_body_errors;
use super::parent_transform::{
    CarriedPoint, LanePositions, express_in_body, express_in_parent, transform_to_parent,
};
use super::plan::{ScheduledStep, Shape, StepForm, TreeMotion, TreeStep, Turn};
use super::prismatic_leaf;
use super::propagation::{PropagatedWrench, add_to_parent, smaller, store_wrench, update_wrench};
use super::workspace::{COSINE, Offsets, SINE, Sizes, TrackedSizes, number, store_sizes};
use crate::columns::{PositionColumns, excess_beyond, quaternion_norm_excess};
use percuss_spatial::lanes::{LARGEST_ANGLE, Lanes};
use percuss_spatial::{PackedInertia, PackedWrench, rotate_back, splat, turn_vector};
use std::ops::Range;

/// Results of some lanes.
#[derive(Clone, Copy, Debug)]
pub(super) struct TreeResponse<T> {
    /// 1/m̄, 1/kg.
    pub response: T,
    /// Rounding error of the response in units of ε, 1/kg.
    pub error: T,
}

/// 1/m̄ of the configurations from `first` on, one per lane, and its rounding error. `scratch`: workspace of
/// all steps.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn evaluate<T: Lanes, const GENERAL: bool>(
    (steps, clusters): (&[ScheduledStep], &[MimicCluster]),
    selection: &ContactPath,
    columns: PositionColumns<'_>,
    first: usize,
    scratch: &mut [f64],
) -> TreeResponse<T> {
    debug_assert!(GENERAL || !selection.is_general(), "a contact for the general evaluation");
    let (beyond, travels): (T, T) = fill_joint_values(steps, selection, columns, first, scratch);
    let at = LanePositions { columns, first };
    let (mut propagated, refused) = contact_wrench::<T, GENERAL>(steps, selection, at, scratch);
    clusters.iter().for_each(|cluster| cluster.clear::<T>(scratch));
    let Branches { roles, changes, .. } = &selection.branches;
    let mut changes = changes.as_slice();
    for (index, (placed, role)) in steps.iter().zip(roles).enumerate() {
        if !role.is_eliminated() {
            continue;
        }
        while GENERAL
            && let Some(((before, change), later)) = changes.split_first()
            && *before <= index
        {
            propagated.change(*change, scratch);
            changes = later;
        }
        if let Some(joint) = &placed.step.cluster_joint {
            let on_path = role.is_on_path();
            eliminate_cluster_joint(clusters, placed, joint, on_path, at, &mut propagated, scratch);
        } else if role.is_on_path() {
            eliminate_step::<T, true>(placed, at, &mut propagated, scratch);
        } else {
            eliminate_step::<T, false>(placed, at, &mut propagated, scratch);
        }
    }
    if GENERAL {
        changes.iter().for_each(|(_, change)| propagated.change(*change, scratch));
    }
    let response = propagated.response;
    let (bound, arm) = (&selection.bound, selection.contact.arms(at));
    let mut by_energy = if propagated.tracks_sizes {
        bound.of_power(response, arm, propagated.sizes.power)
    } else {
        bound.of_constants(response, arm)
    };
    if !bound.twist_steps.is_empty() {
        add_light_body_errors(steps, selection, at, &propagated, scratch, &mut by_energy);
    }
    let mut error = by_energy.sum();
    if propagated.tracks_sizes {
        let by_pivots = propagated.sizes.error_by_pivots();
        error = smaller(by_pivots + bound.of_contact(response, arm, propagated.sizes.terms), error);
    }
    let stretch = (travels * T::from_f64(selection.over_travel)).max(T::one());
    // Angles beyond the range of the sine, and refused lines, are marked as doubtful.
    TreeResponse {
        response,
        error: (beyond + refused).mul_add(T::from_f64(f64::MAX), error * stretch * stretch),
    }
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
    for (placed, role) in steps.iter().zip(&selection.branches.roles) {
        if *role == StepRole::Unused {
            continue;
        }
        let step = &placed.step;
        if placed.is_root() {
            // This position may not change m̄, but must be a finite number.
            beyond += nan_unless_finite::<T>(columns, step.positions(), first);
        }
        let slot = placed.offsets.joint_mut::<T>(scratch);
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

/// Unit force or unit moment on the contact link, and the excess of the line of a normal beyond its limits. Stores the opposite wrench on the
/// body on the other side in the workspace.
#[cfg_attr(not(debug_assertions), inline(always))]
fn contact_wrench<T: Lanes, const GENERAL: bool>(
    steps: &[ScheduledStep],
    selection: &ContactPath,
    at: LanePositions<'_>,
    scratch: &mut [f64],
) -> (PropagatedWrench<T>, T) {
    let (contact, bound) = (&selection.contact, &selection.bound);
    let Branches { path, other, shared, .. } = &selection.branches;
    let mut n: [T; 3] = contact.normals(at);
    let turned_by = match contact.normal_frame {
        TreeNormalFrame::Body => &[],
        TreeNormalFrame::Root => path.as_slice(),
        TreeNormalFrame::Against if !GENERAL => &[],
        TreeNormalFrame::Against => {
            let mut along_normal = PackedWrench { moment: [T::zero(); 3], force: n };
            for &place in other[*shared..].iter().rev() {
                let placed = &steps[place];
                let joint = placed.offsets.joint::<T>(scratch);
                express_in_parent(&placed.step, &mut along_normal, at, joint);
            }
            n = along_normal.force;
            &path[*shared..]
        }
    };
    for &place in turned_by {
        let placed = &steps[place];
        rotate_to_body(&placed.step, &mut n, at, placed.offsets.joint::<T>(scratch));
    }
    let mut refused = T::zero();
    if GENERAL && let Some(line) = &contact.line {
        (n, refused) = line_direction(steps, selection, line, &n, at, scratch);
    }
    let arm: T = contact.arms(at);
    let q: [T; 3] = contact.points(at);
    let moment = [
        q[1].mul_add(n[2], -(q[2] * n[1])),
        q[2].mul_add(n[0], -(q[0] * n[2])),
        q[0].mul_add(n[1], -(q[1] * n[0])),
    ];
    let (wrench, sizes) = match contact.is_moment {
        true => (PackedWrench { moment: n, force: [T::zero(); 3] }, [T::one(), T::zero()]),
        false => (PackedWrench { moment, force: n }, [arm, T::one()]),
    };
    if GENERAL && !other.is_empty() {
        let mut opposite = wrench.scaled(-T::one());
        for &place in path[*shared..].iter().rev() {
            let placed = &steps[place];
            express_in_parent(&placed.step, &mut opposite, at, placed.offsets.joint::<T>(scratch));
        }
        for &place in &other[*shared..] {
            let placed = &steps[place];
            express_in_body(&placed.step, &mut opposite, at, placed.offsets.joint::<T>(scratch));
        }
        store_wrench(&opposite, scratch);
        store_sizes(sizes[0] + sizes[1] * T::from_f64(bound.reach), sizes[1], scratch);
    }
    let tracks_sizes = GENERAL && bound.tracks_sizes;
    let sizes = TrackedSizes::new(sizes[0], sizes[1]);
    (PropagatedWrench { wrench, response: T::zero(), tracks_sizes, sizes }, refused)
}

/// Unit vector along a line in the frame of the contact link's body, and the excess of its length and its direction beyond their limits (0
/// within both). `drawn`: direction as drawn, in the same frame.
#[cfg_attr(not(debug_assertions), inline(always))]
fn line_direction<T: Lanes>(
    steps: &[ScheduledStep],
    selection: &ContactPath,
    line: &TreeLine,
    drawn: &[T; 3],
    at: LanePositions<'_>,
    scratch: &[f64],
) -> ([T; 3], T) {
    let Branches { path, line: to_end, line_shared, .. } = &selection.branches;
    // Both ends in the frame of the first body that carries both.
    let mut from = CarriedPoint::<T>(selection.contact.points(at));
    let mut to = CarriedPoint::<T>(splat(&line.end));
    for &place in path[*line_shared..].iter().rev() {
        let placed = &steps[place];
        express_in_parent(&placed.step, &mut from, at, placed.offsets.joint::<T>(scratch));
    }
    for &place in to_end[*line_shared..].iter().rev() {
        let placed = &steps[place];
        express_in_parent(&placed.step, &mut to, at, placed.offsets.joint::<T>(scratch));
    }
    let mut n = [to.0[0] - from.0[0], to.0[1] - from.0[1], to.0[2] - from.0[2]];
    for &place in &path[*line_shared..] {
        let placed = &steps[place];
        rotate_to_body(&placed.step, &mut n, at, placed.offsets.joint::<T>(scratch));
    }
    let length = n[2].mul_add(n[2], n[1].mul_add(n[1], n[0] * n[0])).sqrt();
    let over = T::one() / length;
    let n = [n[0] * over, n[1] * over, n[2] * over];
    let cosine = n[2].mul_add(drawn[2], n[1].mul_add(drawn[1], n[0] * drawn[0]));
    let (short, aside) = (T::from_f64(line.shortest) - length, T::from_f64(line.least_cosine) - cosine);
    (n, short.max(T::zero()) + aside.max(T::zero()))
}

/// Vector from the parent's frame to the body's.
#[cfg_attr(not(debug_assertions), inline(always))]
fn rotate_to_body<T: Lanes>(step: &TreeStep, n: &mut [T; 3], at: LanePositions<'_>, joint: &[f64]) {
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
            let (s, c): (T, T) = (number(joint, SINE), number(joint, COSINE));
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
    match placed.form {
        StepForm::GroundHinge => eliminate_ground_hinge(step, &placed.offsets, propagated, scratch),
        StepForm::Hinge(form) => eliminate_hinge::<T, ON_PATH>(form, placed, propagated, scratch),
        StepForm::PrismaticLeaf if !ON_PATH => {
            let Some(leaf) = &placed.prismatic_leaf else { return };
            let travel = number(placed.offsets.joint::<T>(scratch), SINE);
            let slot = placed.offsets.parent_inertia::<T>(scratch);
            prismatic_leaf::add_polynomial_inertia::<T>(leaf, travel, placed.is_first, slot);
            if propagated.tracks_sizes {
                leaf.sizes.cast::<T>().add_to_parent(step.reach, placed.is_first, slot);
                propagated.sizes.record_loss(T::from_f64(leaf.loss));
            }
        }
        StepForm::PrismaticLeaf | StepForm::General | StepForm::OfCluster => {
            eliminate_general_joint::<T>(placed, ON_PATH, at, propagated, scratch)
        }
    }
}

/// Eliminates a hinge on the ground. Only one entry of its inertia is needed; the moment of the rigid subtree bounds its size.
#[cfg_attr(not(debug_assertions), inline(always))]
fn eliminate_ground_hinge<T: Lanes>(
    step: &TreeStep,
    offsets: &Offsets,
    propagated: &mut PropagatedWrench<T>,
    scratch: &mut [f64],
) {
    let of = T::from_f64;
    let d = number::<T>(offsets.inertia::<T>(scratch), 5) + of(step.armature[2]);
    let rate = propagated.add_response(propagated.wrench.moment[2], T::one() / d);
    if propagated.tracks_sizes {
        propagated.sizes.add_response(of(step.moment), propagated.sizes.along_axis(true), rate);
        propagated.sizes.add_share(&step.share, offsets, scratch);
    }
    offsets.store_rate(rate, 2, scratch);
}

/// Eliminates any joint with any transform, on the contact path or not, and adds the remaining inertia to the parent's.
/// `propagated`: propagated test wrench.
#[cfg_attr(not(debug_assertions), inline(always))]
fn eliminate_general_joint<T: Lanes>(
    placed: &ScheduledStep,
    on_path: bool,
    at: LanePositions<'_>,
    propagated: &mut PropagatedWrench<T>,
    scratch: &mut [f64],
) {
    let (step, offsets) = (&placed.step, &placed.offsets);
    let mut inertia = eliminate_velocities::<T>(placed, on_path, propagated, scratch);
    if on_path && propagated.tracks_sizes {
        propagated.sizes.add_share(&step.share, offsets, scratch);
    }
    if step.parent.is_none() || step.transmits_nothing() {
        return;
    }
    transform_to_parent(step, &mut inertia, at, offsets.joint::<T>(scratch));
    if on_path {
        transform_to_parent(step, &mut propagated.wrench, at, offsets.joint::<T>(scratch));
        if propagated.tracks_sizes {
            propagated.sizes.add_reach(step.reach);
        }
    }
    let slot = offsets.parent_inertia::<T>(scratch);
    add_to_parent(&mut inertia, &placed.parent_inertia, placed.is_first, slot);
}

/// Remaining inertia of a body after the elimination of its joint.
#[cfg_attr(not(debug_assertions), inline(always))]
fn eliminate_velocities<T: Lanes>(
    placed: &ScheduledStep,
    on_path: bool,
    propagated: &mut PropagatedWrench<T>,
    scratch: &mut [f64],
) -> PackedInertia<T> {
    let (step, offsets) = (&placed.step, &placed.offsets);
    if let Some(leaf) = &step.leaf {
        if propagated.tracks_sizes {
            propagated.sizes.record_loss(T::from_f64(leaf.loss));
            placed.add_sizes_to_parent(leaf.sizes.cast::<T>(), scratch);
        }
        match step.motion {
            TreeMotion::Slide { .. } if on_path => {
                update_wrench::<T, 5>(step, offsets, &leaf.pivot(), propagated, scratch)
            }
            _ if on_path => update_wrench::<T, 2>(step, offsets, &leaf.pivot(), propagated, scratch),
            _ => {}
        }
        return leaf.left.cast();
    }
    let mut inertia: PackedInertia<T> = if step.has_child_inertia {
        PackedInertia::load(offsets.inertia::<T>(scratch))
    } else {
        step.own.inertia.cast()
    };
    if let TreeMotion::Planar { .. } = step.motion {
        // The translations of the joint do not rotate with the body.
        let joint = offsets.joint::<T>(scratch);
        let (s, c): (T, T) = (number(joint, SINE), number(joint, COSINE));
        inertia.turn::<2>(c, s);
        if on_path {
            propagated.wrench.turn::<2>(c, s);
        }
    }
    // Computed before any velocity of the joint is eliminated: the last pivots are differences of these sizes.
    let mut sizes = Sizes::zero();
    if propagated.tracks_sizes {
        sizes = Sizes::of(&inertia, step.has_child_inertia, offsets.inertia::<T>(scratch));
    }
    macro_rules! velocity {
        ($component:literal, $size:ident, $pivot:ident, $eliminate:ident, $axis:literal) => {
            if step.free[$component] {
                let pivot = inertia.$pivot::<$axis>(T::from_f64(step.armature[$component]));
                if on_path {
                    update_wrench::<T, $component>(step, offsets, &pivot, propagated, scratch);
                }
                inertia.$eliminate::<$axis>(&pivot, &pivot.u.scaled(pivot.inverse_d));
                if propagated.tracks_sizes {
                    let loss = sizes.$size * pivot.inverse_d.abs();
                    propagated.sizes.record_loss(loss);
                    sizes = sizes.amplified(loss);
                }
            }
        };
    }
    velocity!(3, mass, slide_pivot, eliminate_slide, 0);
    velocity!(4, mass, slide_pivot, eliminate_slide, 1);
    velocity!(5, mass, slide_pivot, eliminate_slide, 2);
    velocity!(0, moment, turn_pivot, eliminate_turn, 0);
    velocity!(1, moment, turn_pivot, eliminate_turn, 1);
    velocity!(2, moment, turn_pivot, eliminate_turn, 2);
    if propagated.tracks_sizes {
        placed.add_sizes_to_parent(sizes, scratch);
    }
    inertia
}
