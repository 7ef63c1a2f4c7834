//! Transform from a body's frame to its parent's, with the joint's motion first.

use super::carried::{COSINE, Carried, SINE, number};
use super::plan::{Motion, Step};
use crate::kernels::estimate::Columns;
use percuss_spatial::lanes::Lanes;
use percuss_spatial::{PackedInertia, rotation_rows};

/// Location of the positions of the lanes.
#[derive(Clone, Copy)]
pub(super) struct At<'a> {
    pub columns: Columns<'a>,
    pub first: usize,
}

impl At<'_> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn position<T: Lanes>(&self, q: usize) -> T {
        self.columns.at(q, self.first)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn rotation<T: Lanes>(&self, q: usize) -> [[T; 3]; 3] {
        rotation_rows([self.position(q), self.position(q + 1), self.position(q + 2), self.position(q + 3)])
    }
}

/// Transform to the parent's frame.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn go<T: Lanes>(
    step: &Step,
    inertia: &mut PackedInertia<T>,
    on_path: bool,
    at: At<'_>,
    carried: &mut Carried<T>,
    own: &[f64],
) {
    let of = T::from_f64;
    let (way, wrench) = (&step.way, &mut carried.wrench);
    macro_rules! both {
        ($what:ident::<$axis:literal>($($by:expr),*)) => {
            inertia.$what::<$axis>($($by),*);
            if on_path {
                wrench.$what::<$axis>($($by),*);
            }
        };
    }
    macro_rules! rotate {
        ($q:expr) => {
            let rotation = at.rotation($q);
            inertia.rotate(&rotation);
            if on_path {
                wrench.rotate(&rotation);
            }
        };
    }
    let along_z = of(way.along_z);
    match step.motion {
        Motion::Turn { .. } => {
            let (s, c): (T, T) = (number(own, SINE), number(own, COSINE));
            both!(screw::<2>(c, s, along_z));
        }
        Motion::Slide { .. } => {
            both!(shift::<2>(number::<T>(own, SINE) + along_z));
        }
        Motion::Planar { q } => {
            both!(shift::<0>(at.position(q)));
            both!(shift::<1>(at.position(q + 1)));
            both!(shift::<2>(along_z));
        }
        Motion::Ball { q } => {
            rotate!(q);
            both!(shift::<2>(along_z));
        }
        Motion::Floating { q } => {
            rotate!(q + 3);
            both!(shift::<0>(at.position(q)));
            both!(shift::<1>(at.position(q + 1)));
            both!(shift::<2>(at.position::<T>(q + 2) + along_z));
        }
        Motion::Base => {}
    }
    match (step.motion, way.turn_z) {
        (Motion::Turn { .. }, _) | (_, None) => {}
        (_, Some(turn)) => {
            both!(turn::<2>(of(turn.cos), of(turn.sin)));
        }
    }
    both!(screw::<0>(of(way.tilt.cos), of(way.tilt.sin), of(way.along[0])));
    both!(shift::<1>(of(way.along[1])));
    both!(shift::<2>(of(way.along[2])));
    if let Some(turn) = way.last_turn_z {
        both!(turn::<2>(of(turn.cos), of(turn.sin)));
    }
}
