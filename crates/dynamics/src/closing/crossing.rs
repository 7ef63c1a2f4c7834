//! A pose at or near a crossing of branches, from regular ones on both sides.
//!
//! There the followers' Jacobian is singular, and closing finds them to the root of the tolerance only. Along the branch
//! they are smooth functions of the drivers all the same: taken at eight places around, they are interpolated.

use super::branch::{DriverPath, Point};
use crate::kinematics::Kinematics;
use crate::tolerances::{CROSSING_PLACES, CROSSING_STEP};

impl DriverPath<'_> {
    /// Puts the group at the target on the branch of a regular point `here`. Gives a regular pose beside it; none, and
    /// the pose left as it was, where the branch does not run through (a limit).
    pub(super) fn across(
        &self,
        kinematics: &mut Kinematics<f64>,
        here: &Point,
        target: f64,
    ) -> Option<Vec<f64>> {
        let plain = kinematics.q.clone();
        let slope = here.tangent[self.unknown.len()].abs();
        let found = [1.0, 1.6, 2.5].iter().find_map(|factor| {
            let apart = factor * CROSSING_STEP * self.group.size * slope;
            self.interpolated(kinematics, here, target, apart * (target - here.gone).signum())
        });
        if found.is_none() {
            kinematics.q.copy_from_slice(&plain);
            self.model.refill_group(kinematics, self.group);
        }
        found
    }

    fn interpolated(
        &self,
        kinematics: &mut Kinematics<f64>,
        here: &Point,
        target: f64,
        apart: f64,
    ) -> Option<Vec<f64>> {
        let offsets =
            (1..=CROSSING_PLACES as i32).rev().map(|k| -k).chain(1..=CROSSING_PLACES as i32).map(f64::from);
        let mut known: Vec<(f64, Vec<f64>)> = Vec::with_capacity(2 * CROSSING_PLACES);
        let mut from = here.clone();
        for offset in offsets {
            let gone = target + offset * apart;
            let arrival = self.run(kinematics, from.clone(), gone, false);
            if !arrival.there || arrival.anchor.is_some() {
                return None;
            }
            from = Point { q: kinematics.q.clone(), gone, tangent: self.tangent(kinematics, &from.tangent) };
            known.push((offset, from.q.clone()));
        }
        kinematics.q.copy_from_slice(&self.at_zero(&known));
        // Drivers stand at the positions asked for, not where the interpolation has them.
        self.model.refill_group(kinematics, self.group);
        let (residual, _) = self.model.group_residual(kinematics, self.group);
        (residual <= self.tolerance).then(|| known.swap_remove(0).1)
    }

    /// Positions at offset 0 by Lagrange's formula; quaternions normalised.
    fn at_zero(&self, known: &[(f64, Vec<f64>)]) -> Vec<f64> {
        let mut q = vec![0.0; known[0].1.len()];
        for (i, (x, values)) in known.iter().enumerate() {
            let others = known.iter().enumerate().filter(|(j, _)| *j != i);
            let weight: f64 = others.map(|(_, (y, _))| y / (y - x)).product();
            q.iter_mut().zip(values).for_each(|(q, value)| *q += weight * value);
        }
        // What does not move stays as it is to the last bit.
        for k in 0..q.len() {
            if known.iter().all(|(_, values)| values[k] == known[0].1[k]) {
                q[k] = known[0].1[k];
            }
        }
        for (joint, range) in self.model.mechanism.joints().iter().zip(&self.model.joint_q) {
            crate::tangent::normalise(joint.kind(), &mut q[range.clone()]);
        }
        q
    }
}
