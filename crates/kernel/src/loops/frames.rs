//! Poses of the bodies of a linkage, root axes, relative to a centre near the bodies.

use super::layout::{FRAME, add_scaled, dot, get, get_vector, plus, put_vector, size, times};
use super::plan::{LoopBody, LoopMotion, LoopPlan};
use super::relations::fill_relations;
use crate::columns::PositionColumns;
use crate::mechanism::{BodyDirection, BodyPoint, JointPosition};
use percuss_spatial::lanes::{LARGEST_ANGLE, Lanes};
use percuss_spatial::{rotation_rows, splat};

/// Stores the frames of the bodies and the values of the relations. Returns the excess of the angles beyond their accepted range, and the distance of
/// the farthest body from the centre.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn fill_frames<T: Lanes>(
    plan: &LoopPlan,
    columns: PositionColumns<'_>,
    first: usize,
    scratch: &mut [f64],
) -> (T, T) {
    let (mut beyond, mut far) = (T::zero(), T::zero());
    for (i, body) in plan.bodies.iter().enumerate() {
        let fixed = [splat(&body.rotation[0]), splat(&body.rotation[1]), splat(&body.rotation[2])];
        let mut shift: [T; 3] = splat(&body.translation);
        let mut turn: [[T; 3]; 3] = fixed;
        if let Some(parent) = body.parent {
            let (carrier, origin) = frame::<T>(scratch, parent);
            shift = plus(
                &origin,
                &[dot(&carrier[0], &shift), dot(&carrier[1], &shift), dot(&carrier[2], &shift)],
            );
            turn = product(&carrier, &fixed);
        }
        match body.motion {
            LoopMotion::Fixed | LoopMotion::Base => {}
            LoopMotion::Turn(position) => {
                beyond += turn_about_z(&mut turn, position.at(columns, first));
            }
            LoopMotion::Planar(q) => {
                for k in 0..2 {
                    let travel: T = columns.at(q + k, first);
                    shift = add_scaled(&[turn[0][k], turn[1][k], turn[2][k]], travel, &shift);
                }
                beyond += turn_about_z(&mut turn, columns.at(q + 2, first));
            }
            LoopMotion::Slide(position) => {
                let travel: T = position.at(columns, first);
                shift = add_scaled(&[turn[0][2], turn[1][2], turn[2][2]], travel, &shift);
            }
            LoopMotion::Ball(q) => turn = product(&turn, &of_quaternion(columns, q, first)),
            LoopMotion::Floating(q) => {
                let moved = [columns.at(q, first), columns.at(q + 1, first), columns.at(q + 2, first)];
                let moved = [dot(&turn[0], &moved), dot(&turn[1], &moved), dot(&turn[2], &moved)];
                shift = plus(&shift, &moved);
                turn = product(&turn, &of_quaternion(columns, q + 3, first));
            }
        }
        put_vector(scratch, FRAME * i, turn[0]);
        put_vector(scratch, FRAME * i + 3, turn[1]);
        put_vector(scratch, FRAME * i + 6, turn[2]);
        put_vector(scratch, FRAME * i + 9, shift);
        far = far.max(size(&shift));
    }
    fill_relations::<T>(plan, columns, first, scratch);
    (beyond, far)
}

/// Rotates a frame about its z axis. Returns the excess of the angle beyond the accepted range.
#[cfg_attr(not(debug_assertions), inline(always))]
fn turn_about_z<T: Lanes>(turn: &mut [[T; 3]; 3], angle: T) -> T {
    let (s, c) = angle.sin_cos();
    let mut r = 0;
    while r < 3 {
        let [x, y, z] = turn[r];
        turn[r] = [c.mul_add(x, s * y), c.mul_add(y, -(s * x)), z];
        r += 1;
    }
    let over = angle.abs() - T::from_f64(LARGEST_ANGLE);
    over + over.abs()
}

impl JointPosition {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn at<T: Lanes>(&self, columns: PositionColumns<'_>, first: usize) -> T {
        // Two roundings, as in the frames of a pose: far from zero, one rounding less is another angle.
        columns.at::<T>(self.q, first) * T::from_f64(self.multiplier) + T::from_f64(self.offset)
    }
}

/// Matrix product a b, both by rows.
#[cfg_attr(not(debug_assertions), inline(always))]
fn product<T: Lanes>(a: &[[T; 3]; 3], b: &[[T; 3]; 3]) -> [[T; 3]; 3] {
    let mut all = *a;
    let mut r = 0;
    while r < 3 {
        let row = &a[r];
        let mut sum = times(&b[0], row[0]);
        sum = add_scaled(&b[1], row[1], &sum);
        all[r] = add_scaled(&b[2], row[2], &sum);
        r += 1;
    }
    all
}

/// Rotation by rows from the unit quaternion w, x, y, z at the positions from `q` on.
#[cfg_attr(not(debug_assertions), inline(always))]
fn of_quaternion<T: Lanes>(columns: PositionColumns<'_>, q: usize, first: usize) -> [[T; 3]; 3] {
    let w: T = columns.at(q, first);
    rotation_rows([w, columns.at(q + 1, first), columns.at(q + 2, first), columns.at(q + 3, first)])
}

/// Rotation of a body, row by row, and its position.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn frame<T: Lanes>(scratch: &[f64], body: usize) -> ([[T; 3]; 3], [T; 3]) {
    let at = FRAME * body;
    let turn = [get_vector(scratch, at), get_vector(scratch, at + 3), get_vector(scratch, at + 6)];
    (turn, get_vector(scratch, at + 9))
}

/// Axis `k` of a body: a column of its rotation.
#[cfg_attr(not(debug_assertions), inline(always))]
fn axis<T: Lanes>(scratch: &[f64], body: usize, k: usize) -> [T; 3] {
    let at = FRAME * body + k;
    [get(scratch, at), get(scratch, at + 3), get(scratch, at + 6)]
}

/// Axis of velocity `k` of a body's joint, root axes.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn joint_axis<T: Lanes>(bodies: &[LoopBody], body: usize, k: usize, scratch: &[f64]) -> [T; 3] {
    let k = match bodies[body].motion {
        LoopMotion::Planar(_) if k < 2 => {
            // These translations do not rotate with the body.
            let LoopBody { parent, rotation, .. } = &bodies[body];
            return direction_of(scratch, *parent, splat(&[rotation[0][k], rotation[1][k], rotation[2][k]]));
        }
        LoopMotion::Ball(_) => k,
        LoopMotion::Floating(_) | LoopMotion::Base => k % 3,
        LoopMotion::Fixed | LoopMotion::Turn(_) | LoopMotion::Slide(_) | LoopMotion::Planar(_) => 2,
    };
    axis(scratch, body, k)
}

/// Direction fixed in a body or in the root, in root axes. `scratch`: workspace with the frames of the bodies.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn direction<T: Lanes>(scratch: &[f64], heading: &BodyDirection) -> [T; 3] {
    direction_of(scratch, heading.body, splat(&heading.e))
}

/// Directions of the lanes in a body or in the root, in root axes.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn direction_of<T: Lanes>(scratch: &[f64], body: Option<usize>, own: [T; 3]) -> [T; 3] {
    match body {
        Some(body) => {
            let (turn, _) = frame::<T>(scratch, body);
            [dot(&turn[0], &own), dot(&turn[1], &own), dot(&turn[2], &own)]
        }
        None => own,
    }
}

/// Point fixed in a body or in the root, in the coordinates of the kernel's root frame, m. `scratch`: workspace with the
/// frames of the bodies.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn point<T: Lanes>(scratch: &[f64], place: &BodyPoint) -> [T; 3] {
    point_of(scratch, place.body, splat(&place.at))
}

/// Points of the lanes in a body or in the root, in the coordinates of the kernel's root frame, m.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn point_of<T: Lanes>(scratch: &[f64], body: Option<usize>, own: [T; 3]) -> [T; 3] {
    match body {
        Some(body) => {
            let (turn, origin) = frame::<T>(scratch, body);
            plus(&origin, &[dot(&turn[0], &own), dot(&turn[1], &own), dot(&turn[2], &own)])
        }
        None => own,
    }
}
