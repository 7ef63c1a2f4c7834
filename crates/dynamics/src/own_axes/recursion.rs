//! The recursion of a tree in its bodies' own axes, for as many configurations as there are lanes.
//!
//! ```text
//! U = I e,  D = e·U + armature,  t = e·f;  I ← I − U D⁻¹ Uᵀ,  f ← f − U D⁻¹ t,  response += t²/D;  both to the carrier
//! ```
//!
//! with e the turn about, or the slide along, the body's z axis: an entry of I, no product. It is the articulated recursion
//! (Featherstone 2008, §7.3) that [`crate::recursion`] writes in the root's axes for every joint and every loop; this form
//! leaves out the forward kinematics and the turning of every body's inertia. A test compares the two.

use super::carried::{COSINE, Carried, ROOM, SINE, number, pass, spend};
use super::hinge::hinge;
use super::plan::{Form, Motion, Placed, Shape, Step, Turn};
use super::sizes::Sizes;
use super::slid;
use super::way::{At, go};
use crate::answered::{Columns, off_unit, over};
use percuss_spatial::lanes::{LARGEST_ANGLE, Lanes};
use percuss_spatial::{PackedInertia, PackedWrench, rotate_back, splat, turn_vector};
use std::ops::Range;

/// The struck point and what wrench it gives, in the frames of the plan.
#[derive(Clone, Debug)]
pub(super) struct Struck {
    /// The point in the struck body's frame, m.
    pub point: [f64; 3],
    pub normal: Normal,
}

/// The unit normal.
#[derive(Clone, Copy, Debug)]
pub(super) enum Normal {
    /// In the struck body's frame.
    Body([f64; 3]),
    /// In the root link's.
    Root([f64; 3]),
}

/// What a contact needs of a tree.
#[derive(Clone, Debug)]
pub(super) struct Selection {
    /// Where the steps from the ground to the struck body are.
    pub path: Vec<usize>,
    /// For every step.
    pub on_path: Vec<bool>,
    /// The body of the path that leaves nothing to another, or stands on the ground.
    pub top: usize,
    /// 1 over the travels that sizes are bounded with, 1/m.
    pub over_travel: f64,
    pub struck: Struck,
}

impl Selection {
    /// Of no contact yet.
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

/// The answers of some lanes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Answer<T> {
    /// 1/m̄, 1/kg.
    pub response: T,
    /// What the response would be off by, were all that its pivots and tests are sums of off by as much as themselves, 1/kg.
    pub terms: T,
    /// How many roundings of the terms count.
    pub roundings: T,
}

/// 1/m̄ of configurations `first` and those after it.
#[inline(always)]
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
    // What lies beyond the angles that this is right for is doubted.
    let roundings = carried.roundings();
    let Carried { response, terms, .. } = carried;
    let stretch = (travels * T::from_f64(selection.over_travel)).max(T::one());
    Answer { response, terms: beyond.mul_add(T::from_f64(f64::MAX), terms * stretch * stretch), roundings }
}

/// Sines and cosines; how far angles and quaternions are beyond what they may be, and the largest travel (m).
#[inline(always)]
fn place<T: Lanes>(
    steps: &[Placed],
    selection: &Selection,
    columns: Columns<'_>,
    first: usize,
    room: &mut [f64],
) -> (T, T) {
    let (mut beyond, mut angles, mut travels) = (T::zero(), T::zero(), T::zero());
    for (placed, on_path) in steps.iter().zip(&selection.on_path) {
        // What carries the top turns normals of the root's.
        if placed.top != selection.top && !on_path {
            continue;
        }
        let step = &placed.step;
        if placed.number == selection.top {
            // What moves all the rest may leave m̄ as it is, but has to be a number.
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
    // An angle that is no number has no sine either.
    (beyond + over(angles, LARGEST_ANGLE), travels)
}

/// Zero where all positions are finite, else NaN.
#[inline(always)]
fn off_numbers<T: Lanes>(columns: Columns<'_>, positions: Range<usize>, first: usize) -> T {
    let (mut q, mut sum) = (positions.start, T::zero());
    while q < positions.end {
        let position: T = columns.at(q, first);
        sum = position.mul_add(T::zero(), sum);
        q += 1;
    }
    sum
}

/// The unit force at the struck point.
#[inline(always)]
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

/// A vector of the carrier's frame in the body's.
#[inline(always)]
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
        // The way's turn is in its angle.
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

/// Cosine and sine of a turn the other way.
#[inline(always)]
fn back<T: Lanes>(turn: Turn) -> (T, T) {
    (T::from_f64(turn.cos), T::from_f64(-turn.sin))
}

/// Eliminates a body's joint and passes what is left to its carrier.
#[inline(always)]
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

/// A hinge on the ground asks for one entry: the rest of its inertia was not formed, so that the size of that entry is what can
/// be known.
#[inline(always)]
fn top<T: Lanes>(step: &Step, carried: &mut Carried<T>, own: &[f64]) {
    let of = T::from_f64;
    let d = number::<T>(own, 5) + of(step.armature[2]);
    carried.respond(of(step.moment), carried.wrench.moment[2], carried.about, T::one() / d);
}

/// Any joint, and any way. One piece of code for all, on the contact's path or not: it is long.
#[inline(always)]
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

/// What a body's joint leaves of its inertia, and the sizes of its terms.
#[inline(always)]
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
        // Its slides do not turn with it.
        let (s, c): (T, T) = (number(own, SINE), number(own, COSINE));
        inertia.turn::<2>(c, s);
        if on_path {
            carried.wrench.turn::<2>(c, s);
        }
    }
    // Before any of the joint's velocities is eliminated: the first pivots cancel what the last are differences of.
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
