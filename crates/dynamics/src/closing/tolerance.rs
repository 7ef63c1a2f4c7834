//! When a group counts as closed, on its own size.

use crate::kinematics::Kinematics;
use crate::model::{Group, Model};
use crate::tolerances::{CLOSED, RANK_FLOOR, ROUNDED};

impl Model {
    /// Residual (m) at which a group counts as closed: a part of its size, and rounding of far-off positions.
    pub fn closing_tolerance(&self, kinematics: &Kinematics<f64>, group: &Group) -> f64 {
        let far = |b: &usize| kinematics.frames[*b].translation.amax();
        let far = group.bodies.iter().map(far).fold(0.0, f64::max);
        // Angles of many turns have fewer digits left within one.
        let of_body =
            |b: &usize| kinematics.q[self.bodies[*b].q.clone()].iter().map(|q| q.abs()).fold(0.0, f64::max);
        let turned = group.bodies.iter().map(of_body).fold(0.0, f64::max);
        (CLOSED * group.size).max(16.0 * f64::EPSILON * far).max(4.0 * f64::EPSILON * turned * group.size)
    }

    /// The same for loops that are inexact by so much at the generic pose (m); they may be by some more at others.
    pub fn rounded_tolerance(&self, kinematics: &Kinematics<f64>, group: &Group, inexactness: f64) -> f64 {
        self.closing_tolerance(kinematics, group).max(ROUNDED * inexactness)
    }
}

impl Group {
    /// Singular values of A below this part of the largest count as zero, where the loops are inexact by so much (m).
    pub fn floor_for(&self, inexactness: f64) -> f64 {
        let places = 16.0 * f64::EPSILON * self.far;
        RANK_FLOOR.max(ROUNDED * inexactness.max(places) / self.size)
    }
}
