//! Rows over tree velocities: what a wrench between two bodies does to each joint.

use crate::System;
use crate::kinematics::Kinematics;
use nalgebra::Vector3;
use percuss_spatial::{Transform, Twist};

impl System {
    /// Visits the bodies that carry `on` but not `against`, with +1, and the reverse, with −1.
    pub(crate) fn for_each_support(
        &self,
        mut on: Option<usize>,
        mut against: Option<usize>,
        mut visit: impl FnMut(usize, f64),
    ) {
        // Bodies are numbered parents first: the higher number cannot carry the lower one.
        while on != against {
            if on > against {
                let Some(i) = on else { return };
                visit(i, 1.0);
                on = self.bodies[i].parent;
            } else {
                let Some(i) = against else { return };
                visit(i, -1.0);
                against = self.bodies[i].parent;
            }
        }
    }

    /// Visits every tree velocity between two bodies with the relative twist (body `on` against body `against`) that
    /// it makes at unit rate: in root axes, taken at `point` (root frame).
    pub(crate) fn for_each_relative_twist(
        &self,
        kinematics: &Kinematics<f64>,
        on: Option<usize>,
        against: Option<usize>,
        point: &Vector3<f64>,
        mut visit: impl FnMut(usize, Twist<f64>),
    ) {
        self.for_each_support(on, against, |i, sign| {
            let frame = at_point(&kinematics.frames[i], point);
            for (k, v) in self.bodies[i].v.clone().enumerate() {
                visit(v, frame.twist(&kinematics.column(self, i, k)) * sign);
            }
        });
    }
}

/// X: root axes with the origin at the point, from body coordinates.
#[inline]
pub(crate) fn at_point<T: percuss_spatial::Scalar>(frame: &Transform<T>, point: &Vector3<T>) -> Transform<T> {
    Transform::new(frame.rotation, frame.translation - point)
}
