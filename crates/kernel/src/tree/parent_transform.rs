//! Transform from a body's frame to its parent's, with the joint's motion first.

use super::plan::{Shape, TreeMotion, TreeStep};

use super::workspace::{COSINE, SINE, number};
use crate::columns::PositionColumns;
use percuss_spatial::lanes::Lanes;
use percuss_spatial::{PackedInertia, PackedTwist, PackedWrench, rotation_rows, turn_vector};

/// Location of the positions of the lanes.
#[derive(Clone, Copy)]
pub(super) struct LanePositions<'a> {
    pub columns: PositionColumns<'a>,
    pub first: usize,
}

impl LanePositions<'_> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn position<T: Lanes>(&self, q: usize) -> T {
        self.columns.at(q, self.first)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn rotation<T: Lanes>(&self, q: usize) -> [[T; 3]; 3] {
        rotation_rows([self.position(q), self.position(q + 1), self.position(q + 2), self.position(q + 3)])
    }
}

/// Quantity that a change of frame transforms: inertia, wrench or point.
pub(super) trait Transformed<T: Lanes> {
    /// Rotation about and shift along axis `Z`.
    fn screw<const Z: usize>(&mut self, c: T, s: T, d: T);
    /// Shift along axis `Z`.
    fn shift<const Z: usize>(&mut self, d: T);
    /// Rotation about axis `Z`.
    fn turn<const Z: usize>(&mut self, c: T, s: T);
    /// Rotation to the parent by the matrix with these rows.
    fn rotate(&mut self, rows: &[[T; 3]; 3]);
}

macro_rules! transformed {
    ($name:ident) => {
        impl<T: Lanes> Transformed<T> for $name<T> {
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn screw<const Z: usize>(&mut self, c: T, s: T, d: T) {
                $name::screw::<Z>(self, c, s, d);
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn shift<const Z: usize>(&mut self, d: T) {
                $name::shift::<Z>(self, d);
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn turn<const Z: usize>(&mut self, c: T, s: T) {
                $name::turn::<Z>(self, c, s);
            }
            #[cfg_attr(not(debug_assertions), inline(always))]
            fn rotate(&mut self, rows: &[[T; 3]; 3]) {
                $name::rotate(self, rows);
            }
        }
    };
}

transformed!(PackedInertia);
transformed!(PackedWrench);

/// Coordinates of a point, m.
pub(super) struct CarriedPoint<T>(pub [T; 3]);

impl<T: Lanes> Transformed<T> for CarriedPoint<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn screw<const Z: usize>(&mut self, c: T, s: T, d: T) {
        turn_vector::<T, Z>(&mut self.0, c, s);
        self.0[Z] += d;
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn shift<const Z: usize>(&mut self, d: T) {
        self.0[Z] += d;
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn turn<const Z: usize>(&mut self, c: T, s: T) {
        turn_vector::<T, Z>(&mut self.0, c, s);
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn rotate(&mut self, rows: &[[T; 3]; 3]) {
        let [x, y, z] = self.0;
        let along = |row: &[T; 3]| row[2].mul_add(z, row[1].mul_add(y, row[0] * x));
        self.0 = [along(&rows[0]), along(&rows[1]), along(&rows[2])];
    }
}

/// Transforms an inertia, a wrench or a point to the parent's frame. `joint`: sine and cosine of the angle, or the travel.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn transform_to_parent<T: Lanes>(
    step: &TreeStep,
    carried: &mut impl Transformed<T>,
    at: LanePositions<'_>,
    joint: &[f64],
) {
    let of = T::from_f64;
    let transform = &step.parent_transform;
    let along_z = of(transform.along_z);
    match step.motion {
        TreeMotion::Turn { .. } => {
            let (s, c): (T, T) = (number(joint, SINE), number(joint, COSINE));
            carried.screw::<2>(c, s, along_z);
        }
        TreeMotion::Slide { .. } => carried.shift::<2>(number::<T>(joint, SINE) + along_z),
        TreeMotion::Planar { q } => {
            carried.shift::<0>(at.position(q));
            carried.shift::<1>(at.position(q + 1));
            carried.shift::<2>(along_z);
        }
        TreeMotion::Ball { q } => {
            carried.rotate(&at.rotation(q));
            carried.shift::<2>(along_z);
        }
        TreeMotion::Floating { q } => {
            carried.rotate(&at.rotation(q + 3));
            carried.shift::<0>(at.position(q));
            carried.shift::<1>(at.position(q + 1));
            carried.shift::<2>(at.position::<T>(q + 2) + along_z);
        }
        TreeMotion::Base => {}
    }
    match (step.motion, transform.turn_z) {
        (TreeMotion::Turn { .. }, _) | (_, None) => {}
        (_, Some(turn)) => carried.turn::<2>(of(turn.cos), of(turn.sin)),
    }
    carried.screw::<0>(of(transform.tilt.cos), of(transform.tilt.sin), of(transform.shift[0]));
    if transform.shape == Shape::General {
        carried.shift::<1>(of(transform.shift[1]));
        carried.shift::<2>(of(transform.shift[2]));
        if let Some(turn) = transform.last_turn_z {
            carried.turn::<2>(of(turn.cos), of(turn.sin));
        }
    }
}

/// Expresses a wrench or a point in the parent's frame. Unlike [`transform_to_parent`], this includes the rotation of a planar joint, which the
/// elimination applies itself.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn express_in_parent<T: Lanes>(
    step: &TreeStep,
    carried: &mut impl Transformed<T>,
    at: LanePositions<'_>,
    joint: &[f64],
) {
    if let TreeMotion::Planar { .. } = step.motion {
        carried.turn::<2>(number(joint, COSINE), number(joint, SINE));
    }
    transform_to_parent(step, carried, at, joint);
}

/// Expresses a wrench of the parent's frame in the body's frame: the inverse of [`express_in_parent`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn express_in_body<T: Lanes>(
    step: &TreeStep,
    wrench: &mut PackedWrench<T>,
    at: LanePositions<'_>,
    joint: &[f64],
) {
    // A force and its moment are transformed as an angular velocity and the velocity of a point.
    let mut twist = PackedTwist { angular: wrench.force, linear: wrench.moment };
    transform_twist_to_body(step, &mut twist, at, joint);
    if let TreeMotion::Planar { .. } = step.motion {
        twist.turn_back::<2>(number(joint, COSINE), number(joint, SINE));
    }
    *wrench = PackedWrench { moment: twist.linear, force: twist.angular };
}

/// Transforms a twist from the parent's frame: the inverse of [`transform_to_parent`].
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn transform_twist_to_body<T: Lanes>(
    step: &TreeStep,
    twist: &mut PackedTwist<T>,
    at: LanePositions<'_>,
    joint: &[f64],
) {
    let of = T::from_f64;
    let transform = &step.parent_transform;
    if transform.shape == Shape::General {
        if let Some(turn) = transform.last_turn_z {
            twist.turn_back::<2>(of(turn.cos), of(turn.sin));
        }
        twist.shift_back::<2>(of(transform.shift[2]));
        twist.shift_back::<1>(of(transform.shift[1]));
    }
    twist.shift_back::<0>(of(transform.shift[0]));
    twist.turn_back::<0>(of(transform.tilt.cos), of(transform.tilt.sin));
    match (step.motion, transform.turn_z) {
        (TreeMotion::Turn { .. }, _) | (_, None) => {}
        (_, Some(turn)) => twist.turn_back::<2>(of(turn.cos), of(turn.sin)),
    }
    let along_z = of(transform.along_z);
    match step.motion {
        TreeMotion::Turn { .. } => {
            twist.shift_back::<2>(along_z);
            twist.turn_back::<2>(number(joint, COSINE), number(joint, SINE));
        }
        TreeMotion::Slide { .. } => twist.shift_back::<2>(number::<T>(joint, SINE) + along_z),
        TreeMotion::Planar { q } => {
            twist.shift_back::<2>(along_z);
            twist.shift_back::<1>(at.position(q + 1));
            twist.shift_back::<0>(at.position(q));
        }
        TreeMotion::Ball { q } => {
            twist.shift_back::<2>(along_z);
            twist.rotate_back(&at.rotation(q));
        }
        TreeMotion::Floating { q } => {
            twist.shift_back::<2>(at.position::<T>(q + 2) + along_z);
            twist.shift_back::<1>(at.position(q + 1));
            twist.shift_back::<0>(at.position(q));
            twist.rotate_back(&at.rotation(q + 3));
        }
        TreeMotion::Base => {}
    }
}
