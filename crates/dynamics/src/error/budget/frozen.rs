//! Error due to dropped (frozen) pivots that still couple to the parent.

use super::{BudgetWorkspace, UnitImpulse, components, energy_root};
use crate::model::Body;
use crate::recursion::Recursion;
use crate::tolerances::{RESOLVED, SMALL_CHANGE, SUM_ROUNDINGS};
use nalgebra::Vector6;
use percuss_spatial::Twist;

impl UnitImpulse<'_> {
    /// Largest change of 1/m̄ by the pivots of a plain joint that do not count, 1/kg.
    ///
    /// A free motion adds (Uᵀ V)²/D to 1/m̄, with V the twist of the parent. D is not known below its rounding, but Iᴬ ≥ U Uᵀ/D
    /// bounds it from below: D ≥ |U|²/|Iᴬ|. Where U exceeds its rounding, the motion has a mass below rounding and was frozen; where
    /// Uᵀ V exceeds its rounding too, the free motion may take away all of m̄.
    ///
    /// The test wrench along a frozen motion adds to Uᵀ V. Of a motion with a mass even the rounding of this wrench counts; of a
    /// motion without a mass a wrench below its rounding is zero.
    pub(super) fn frozen_change(
        &self,
        workspace: &mut BudgetWorkspace,
        recursion: &Recursion<1>,
        i: usize,
        roots: &Vector6<f64>,
    ) -> f64 {
        let body = &self.model.bodies[i];
        if workspace.composites.is_empty() {
            self.fill_composites(&mut workspace.composites);
            workspace.response = recursion.response(0, 0);
        }
        let response = workspace.response;
        let (moment, mass) = workspace.composites[i];
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
            let motion_size = twist.angular.norm() * moment.sqrt() + twist.linear.norm() * mass.sqrt();
            let frozen = energy_root(roots, &components(&twist)).powi(2);
            let passed = e.u.power(&twist).abs();
            let noise = RESOLVED * own;
            let (about, along) = (e.u.moment.norm(), e.u.force.norm());
            let is_resolved = about > noise * moment.sqrt() || along > noise * mass.sqrt();
            sum += 2.0
                * if passed > noise * motion_size {
                    frozen.max(response)
                } else {
                    let mut most = passed + SUM_ROUNDINGS * f64::EPSILON * own * motion_size;
                    // An unresolved U is zero, or as small as the rounding of D permits.
                    let least = if is_resolved {
                        let test = &recursion.wrenches[i][0];
                        let terms = turn * test.moment.norm() + e.s.linear.norm() * test.force.norm();
                        // Exactly zero in groups that the contact does not reach.
                        if terms > 0.0 {
                            let terms = terms + own * response.abs().sqrt();
                            most += e.t[0].abs() + SUM_ROUNDINGS * f64::EPSILON * terms;
                        }
                        square_over(about, moment).max(square_over(along, mass))
                    } else {
                        e.d.abs().max(f64::EPSILON * own * own)
                    };
                    let change = most * most / least.max(f64::MIN_POSITIVE);
                    // A first-order estimate: a larger change alters the other free motions too, if any are left toward
                    // the root.
                    let accepted = if motion_size > 0.0 { SMALL_CHANGE } else { 1.0 };
                    if change < accepted * response { change } else { frozen.max(response) }
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

/// x²/y; 0 where y vanishes.
fn square_over(x: f64, y: f64) -> f64 {
    if y > 0.0 { x * x / y } else { 0.0 }
}
