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

use super::carried::{COSINE, Carried, ROOM, SINE, number, pass, spend};
use super::hinge::hinge;
use super::plan::{Form, Motion, Placed, Shape, Step, Turn};
use super::sizes::Sizes;
use super::slid;
use super::way::{At, go};
use crate::kernels::estimate::{Columns, off_unit, over};
use percuss_spatial::lanes::{LARGEST_ANGLE, Lanes};
use percuss_spatial::{PackedInertia, PackedWrench, rotate_back, splat, turn_vector};
use std::ops::Range;

/// Contact point and direction of the contact force, in the frames of the plan.
#[derive(Clone, Debug)]
pub(super) struct Struck {
    /// Contact point in the frame of the contact link's body, m.
    pub point: [f64; 3],
    pub normal: Normal,
}

/// Unit normal.
#[derive(Clone, Copy, Debug)]
pub(super) enum Normal {
    /// In the frame of the contact link's body.
    Body([f64; 3]),
    /// In the frame of the root link.
    Root([f64; 3]),
}

/// Data of a contact for a tree.
#[derive(Clone, Debug)]
pub(super) struct Selection {
    /// Indices of the steps from the ground to the contact link's body.
    pub path: Vec<usize>,
    /// True for every step on this path.
    pub on_path: Vec<bool>,
    /// Body of the path on the ground or with a zero remaining inertia.
    pub top: usize,
    /// Reciprocal of the travels in the bounds of sizes, 1/m.
    pub over_travel: f64,
    pub struck: Struck,
}

impl Selection {
    /// Without a contact.
    pub fn none(steps: usize, travel: f64) -> Self {
        let struck = Struck { point: [0.0; 3], normal: Normal::Body([0.0; 3]) };
        Self {
            path: Vec::with_capacity(steps),
            on_path: vec![false; steps],
            top: 0,
            over_travel: 1.0 / travel,
            struck,
        }
    }
}

/// Results of some lanes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Answer<T> {
    /// 1/m̄, 1/kg.
    pub response: T,
    /// Change of the response if every term of its pivots and test wrenches were in error by its own size, 1/kg.
    pub terms: T,
    /// Number of roundings of these terms.
    pub roundings: T,
}

/// 1/m̄ of the configurations from `first` on.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn evaluate<T: Lanes>(
    steps: &[Placed],
    selection: &Selection,
    columns: Columns<'_>,
    first: usize,
    room: &mut [f64],
) -> Answer<T> {
    let (beyond, travels): (T, T) = place(steps, selection, columns, first, room);
    let at = At { columns, first };
    let mut carried = strike(steps, selection, at, room);
    for (placed, on_path) in steps.iter().zip(&selection.on_path) {
        if placed.top != selection.top {
            continue;
        }
        if *on_path {
            advance::<T, true>(placed, at, &mut carried, room);
        } else {
            advance::<T, false>(placed, at, &mut carried, room);
        }
    }
    // Angles beyond the range of the sine are marked as doubtful.
    let roundings = carried.roundings();
    let Carried { response, terms, .. } = carried;
    let stretch = (travels * T::from_f64(selection.over_travel)).max(T::one());
    Answer { response, terms: beyond.mul_add(T::from_f64(f64::MAX), terms * stretch * stretch), roundings }
}

/// Sines and cosines, the excess of angles and quaternions beyond their accepted range, and the largest travel (m).
#[cfg_attr(not(debug_assertions), inline(always))]
fn place<T: Lanes>(
    steps: &[Placed],
    selection: &Selection,
    columns: Columns<'_>,
    first: usize,
    room: &mut [f64],
) -> (T, T) {
    let (mut beyond, mut angles, mut travels) = (T::zero(), T::zero(), T::zero());
    for (placed, on_path) in steps.iter().zip(&selection.on_path) {
        // The joints above the top of the path rotate normals given in the root link.
        if placed.top != selection.top && !on_path {
            continue;
        }
        let step = &placed.step;
        if placed.number == selection.top {
            // A position above the path does not change m̄, but must be a finite number.
            beyond += off_numbers::<T>(columns, step.positions(), first);
        }
        let slot = &mut room[placed.number * ROOM * T::WIDTH..][..ROOM * T::WIDTH];
        match step.motion {
            Motion::Turn { q } => {
                let angle: T = columns.at(q, first);
                angles = angles.max(angle.abs());
                let (mut sin, mut cos) = angle.sin_cos();
                match step.way.turn_z {
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
            Motion::Slide { q } => {
                let travel: T = columns.at(q, first);
                travels = travels.max(travel.abs());
                travel.store(&mut slot[SINE * T::WIDTH..]);
            }
            Motion::Planar { q } => {
                for k in 0..2 {
                    travels = travels.max(columns.at::<T>(q + k, first).abs());
                }
                let angle: T = columns.at(q + 2, first);
                angles = angles.max(angle.abs());
                let (sin, cos) = angle.sin_cos();
                sin.store(&mut slot[SINE * T::WIDTH..]);
                cos.store(&mut slot[COSINE * T::WIDTH..]);
            }
            Motion::Ball { q } => beyond += off_unit::<T>(columns, q, first),
            Motion::Floating { q } => {
                for k in 0..3 {
                    travels = travels.max(columns.at::<T>(q + k, first).abs());
                }
                beyond += off_unit::<T>(columns, q + 3, first);
            }
            Motion::Base => {}
        }
    }
    // The sine of NaN is NaN.
    (beyond + over(angles, LARGEST_ANGLE), travels)
}

/// Zero if all positions are finite, otherwise NaN.
#[cfg_attr(not(debug_assertions), inline(always))]
fn off_numbers<T: Lanes>(columns: Columns<'_>, positions: Range<usize>, first: usize) -> T {
    let (mut q, mut sum) = (positions.start, T::zero());
    while q < positions.end {
        let position: T = columns.at(q, first);
        sum = position.mul_add(T::zero(), sum);
        q += 1;
    }
    sum
}

/// Unit force at the contact point.
#[cfg_attr(not(debug_assertions), inline(always))]
fn strike<T: Lanes>(steps: &[Placed], selection: &Selection, at: At<'_>, room: &[f64]) -> Carried<T> {
    let struck = &selection.struck;
    let n = match struck.normal {
        Normal::Body(n) => splat(&n),
        Normal::Root(n) => {
            let mut n = splat(&n);
            for &place in &selection.path {
                let placed = &steps[place];
                let slot = &room[placed.number * ROOM * T::WIDTH..][..ROOM * T::WIDTH];
                turn_back(&placed.step, &mut n, at, slot);
            }
            n
        }
    };
    let p = struck.point;
    let arm = (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt();
    let q: [T; 3] = splat(&p);
    let moment = [
        q[1].mul_add(n[2], -(q[2] * n[1])),
        q[2].mul_add(n[0], -(q[0] * n[2])),
        q[0].mul_add(n[1], -(q[1] * n[0])),
    ];
    Carried {
        wrench: PackedWrench { moment, force: n },
        about: T::from_f64(arm),
        along: T::one(),
        response: T::zero(),
        terms: T::zero(),
        loss: T::one(),
    }
}

/// Vector from the parent's frame to the body's.
#[cfg_attr(not(debug_assertions), inline(always))]
fn turn_back<T: Lanes>(step: &Step, n: &mut [T; 3], at: At<'_>, slot: &[f64]) {
    if let Some(turn) = step.way.last_turn_z {
        let (c, s) = back::<T>(turn);
        turn_vector::<T, 2>(n, c, s);
    }
    match step.way.shape {
        Shape::Parallel => {}
        Shape::Right => (n[1], n[2]) = (n[2], -n[1]),
        Shape::Skew | Shape::General => {
            let (c, s) = back::<T>(step.way.tilt);
            turn_vector::<T, 0>(n, c, s);
        }
    }
    match (step.motion, step.way.turn_z) {
        // The angle includes the rotation of the transform.
        (Motion::Turn { .. }, _) | (_, None) => {}
        (_, Some(turn)) => {
            let (c, s) = back::<T>(turn);
            turn_vector::<T, 2>(n, c, s);
        }
    }
    match step.motion {
        Motion::Turn { .. } | Motion::Planar { .. } => {
            let (s, c): (T, T) = (number(slot, SINE), number(slot, COSINE));
            turn_vector::<T, 2>(n, c, -s);
        }
        Motion::Ball { q } => rotate_back(n, &at.rotation(q)),
        Motion::Floating { q } => rotate_back(n, &at.rotation(q + 3)),
        Motion::Slide { .. } | Motion::Base => {}
    }
}

/// Cosine and sine of the opposite rotation.
#[cfg_attr(not(debug_assertions), inline(always))]
fn back<T: Lanes>(turn: Turn) -> (T, T) {
    (T::from_f64(turn.cos), T::from_f64(-turn.sin))
}

/// Eliminates the joint of a body and adds the remaining inertia to the parent.
#[cfg_attr(not(debug_assertions), inline(always))]
fn advance<T: Lanes, const ON_PATH: bool>(
    placed: &Placed,
    at: At<'_>,
    carried: &mut Carried<T>,
    room: &mut [f64],
) {
    let step = &placed.step;
    let (rest, own) = room.split_at_mut(placed.number * ROOM * T::WIDTH);
    let own = &mut own[..ROOM * T::WIDTH];
    match placed.form {
        Form::Top => top(step, carried, own),
        Form::Hinge(form) => {
            let Some(parent) = step.parent else { return };
            let slot = &mut rest[parent * ROOM * T::WIDTH..][..ROOM * T::WIDTH];
            hinge::<T, ON_PATH>(form, placed, carried, own, slot);
        }
        Form::Slid if !ON_PATH => {
            let (Some(parent), Some(slid)) = (step.parent, &placed.slid) else { return };
            carried.loss = carried.loss.max(T::from_f64(slid.loss));
            let slot = &mut rest[parent * ROOM * T::WIDTH..][..ROOM * T::WIDTH];
            slid::pass::<T>(slid, number(own, SINE), placed.is_first, slot);
            slid.sizes.cast::<T>().pass(step.reach, placed.is_first, slot);
        }
        Form::Slid | Form::Any => any::<T>(placed, ON_PATH, at, carried, rest, own),
    }
}

/// A hinge on the ground needs one entry of its inertia. The other entries are not formed, so the size of this entry
/// stands for all.
#[cfg_attr(not(debug_assertions), inline(always))]
fn top<T: Lanes>(step: &Step, carried: &mut Carried<T>, own: &[f64]) {
    let of = T::from_f64;
    let d = number::<T>(own, 5) + of(step.armature[2]);
    carried.respond(of(step.moment), carried.wrench.moment[2], carried.about, T::one() / d);
}

/// Any joint with any transform, on the contact path or not; one function, so it is long.
#[cfg_attr(not(debug_assertions), inline(always))]
fn any<T: Lanes>(
    placed: &Placed,
    on_path: bool,
    at: At<'_>,
    carried: &mut Carried<T>,
    rest: &mut [f64],
    own: &[f64],
) {
    let step = &placed.step;
    let (mut inertia, sizes) = eliminated::<T>(step, on_path, carried, own);
    let Some(parent) = step.parent.filter(|_| !step.lets_go()) else { return };
    go::<T>(step, &mut inertia, on_path, at, carried, own);
    if on_path {
        carried.about = T::from_f64(step.reach).mul_add(carried.along, carried.about);
    }
    let slot = &mut rest[parent * ROOM * T::WIDTH..][..ROOM * T::WIDTH];
    pass(&mut inertia, &placed.above, placed.is_first, slot);
    sizes.pass(step.reach, placed.is_first, slot);
}

/// Remaining inertia of a body after the elimination of its joint, and the sizes of its terms.
#[cfg_attr(not(debug_assertions), inline(always))]
fn eliminated<T: Lanes>(
    step: &Step,
    on_path: bool,
    carried: &mut Carried<T>,
    own: &[f64],
) -> (PackedInertia<T>, Sizes<T>) {
    if let Some(leaf) = &step.leaf {
        carried.loss = carried.loss.max(T::from_f64(leaf.loss));
        match step.motion {
            Motion::Slide { .. } if on_path => spend::<T, 5>(step, &leaf.pivot(), carried),
            _ if on_path => spend::<T, 2>(step, &leaf.pivot(), carried),
            _ => {}
        }
        return (leaf.left.cast(), leaf.sizes.cast());
    }
    let mut inertia: PackedInertia<T> =
        if step.carries { PackedInertia::load(own) } else { step.own.inertia.cast() };
    if let Motion::Planar { .. } = step.motion {
        // The translations of the joint do not rotate with the body.
        let (s, c): (T, T) = (number(own, SINE), number(own, COSINE));
        inertia.turn::<2>(c, s);
        if on_path {
            carried.wrench.turn::<2>(c, s);
        }
    }
    // Computed before any velocity of the joint is eliminated: the last pivots are differences of these sizes.
    let mut sizes = Sizes::of(&inertia, step.carries, own);
    macro_rules! velocity {
        ($component:literal, $size:ident, $pivot:ident, $eliminate:ident, $axis:literal) => {
            if step.free[$component] {
                let pivot = inertia.$pivot::<$axis>(T::from_f64(step.armature[$component]));
                let loss = carried.lose(sizes.$size, &pivot);
                if on_path {
                    spend::<T, $component>(step, &pivot, carried);
                }
                inertia.$eliminate::<$axis>(&pivot, &pivot.u.scaled(pivot.over));
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
