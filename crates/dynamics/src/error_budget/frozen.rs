//! Error due to dropped (frozen) pivots that still couple to the parent.

use super::{BudgetRoom, UnitImpulse, components, energy_root};
use crate::model::Body;
use crate::recursion::Recursion;
use crate::tolerances::{PIVOT, SUM_ROUNDINGS};
use nalgebra::Vector6;
use percuss_spatial::Twist;

impl UnitImpulse<'_> {
    /// Bound for the change of 1/m̄ due to the dropped pivots of a plain joint, 1/kg.
    ///
    /// Iᴬ ≥ U Uᵀ/D, so a motion without mass has U = 0. A dropped motion with U above rounding has a mass below
    /// rounding. Such a motion, if not dropped, may reduce m̄ to zero, because its mass after the elimination of the
    /// other free motions is unknown.
    pub(super) fn of_frozen(
        &self,
        room: &mut BudgetRoom,
        recursion: &Recursion<f64, 1>,
        i: usize,
        roots: &Vector6<f64>,
    ) -> f64 {
        let body = &self.model.bodies[i];
        if room.composites.is_empty() {
            self.fill_composites(&mut room.composites);
        }
        let (moment, mass) = room.composites[i];
        let arm = (self.kinematics.frames[i].translation - self.contact.point_root).norm();
        let mut twist = body.parent.map_or_else(Twist::zero, |p| self.twists[p]);
        let mut sum = 0.0;
        // The last eliminated pivot comes first.
        for &v in recursion.order[body.v.clone()].iter().rev() {
            let e = &recursion.joints[v];
            if e.counts {
                twist += e.s * self.velocities[v];
                continue;
            }
            let turn = e.s.angular.norm();
            let own = turn * moment.sqrt() + (e.s.linear.norm() + turn * arm) * mass.sqrt();
            let carried = twist.angular.norm() * moment.sqrt() + twist.linear.norm() * mass.sqrt();
            let frozen = energy_root(roots, &components(&twist)).powi(2);
            let passed = e.u.power(&twist).abs();
            sum += 2.0
                * if passed > PIVOT * own * carried {
                    frozen.max(recursion.response(0, 0))
                } else {
                    // U is zero, or as small as the rounding of D permits.
                    let most = passed + SUM_ROUNDINGS * f64::EPSILON * own * carried;
                    (most * most / e.d.abs().max(f64::EPSILON * own * own).max(f64::MIN_POSITIVE)).min(frozen)
                };
        }
        sum
    }

    /// Sums moment (about the contact point) and mass of every body over its subtree.
    fn fill_composites(&self, composites: &mut Vec<(f64, f64)>) {
        let own = |(i, body): (usize, &Body)| {
            let arm = (self.kinematics.frames[i].translation - self.contact.point_root).norm();
            let mass = body.inertia.mass.abs();
            let levers = 2.0 * body.inertia.first_moment.norm() + arm * mass;
            (body.inertia.rotational.trace().abs() + 2.0 * arm * levers, mass)
        };
        composites.extend(self.model.bodies.iter().enumerate().map(own));
        for i in (0..composites.len()).rev() {
            if let Some(parent) = self.model.bodies[i].parent {
                let (moment, mass) = composites[i];
                composites[parent].0 += moment;
                composites[parent].1 += mass;
            }
        }
    }
}
