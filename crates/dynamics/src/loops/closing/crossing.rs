//! Poses at or near a crossing of branches, computed from regular poses on both sides.
//!
//! At a crossing the dependent coordinates' Jacobian is singular, and closing finds the dependent coordinates only to
//! the square root of the tolerance. Along the branch, they are smooth functions of the drivers. They are
//! interpolated from eight points around the crossing.

use super::branch::{BranchEvidence, BranchPoint, BranchStep, CrossingStep, DriverPath, TargetStep};
use super::correct::Linearised;
use crate::kinematics::frames::Kinematics;
use crate::linear::dense::singular_values;
use crate::tolerances::{
    CROSSING_PLACES, CROSSING_STEP, DENSE_LIMIT, LEAP_LENGTHS, LEAP_OVER, SAME_CROSSING,
};

impl DriverPath<'_> {
    /// Distance (m) below which two branches count as one crossing: the square root of the closing tolerance.
    pub(super) fn crossing_width(&self) -> f64 {
        (self.tolerance * self.size()).sqrt()
    }

    /// True if branches cross near a point, false if the branches only come close to each other. The square of the
    /// smallest singular value of [J; tᵀ] is a parabola along the tangent, with a minimum of 0 at a crossing.
    pub(super) fn crosses_near(&self, kinematics: &mut Kinematics, here: &BranchPoint) -> bool {
        let columns = here.tangent.len();
        if columns > DENSE_LIMIT {
            return true;
        }
        let apart = self.crossing_width();
        let mut square = |place: f64| {
            self.restore_positions(kinematics, &here.q);
            let rates = self.directions().expand(self.group, |k| place * here.tangent[k]);
            self.model.advance_group(kinematics, self.group, &rates);
            let jacobian = self
                .directions()
                .jacobian(self.group, &Linearised::at(self.model, kinematics, self.group).rows);
            let mut stacked = vec![0.0; (jacobian.rows + 1) * columns];
            jacobian.entries.iter().for_each(|(r, c, a)| stacked[r * columns + c] += a);
            stacked[jacobian.rows * columns..].copy_from_slice(&here.tangent);
            let mut values = Vec::new();
            singular_values(&mut stacked, columns, &mut values);
            values.last().map_or(0.0, |least| least * least)
        };
        let [first, second, third] = [0.0, apart, 2.0 * apart].map(&mut square);
        self.restore_positions(kinematics, &here.q);
        let curvature = (third - 2.0 * second + first) / (2.0 * apart * apart);
        let slope = (second - first) / apart - curvature * apart;
        curvature > 0.0 && first - slope * slope / (4.0 * curvature) <= SAME_CROSSING * first
    }

    /// Steps straight over a crossing, or to the target if the target lies at the crossing.
    pub(super) fn step_over_crossing(
        &self,
        kinematics: &mut Kinematics,
        here: &BranchPoint,
        target: f64,
    ) -> CrossingStep {
        let sign = (target - here.travelled).signum();
        let mut length = f64::min(LEAP_OVER * self.crossing_width(), self.longest_step(&here.tangent));
        for _ in 0..LEAP_LENGTHS {
            match self.step_along(kinematics, here, length, BranchEvidence::Crossing) {
                BranchStep::Taken(next) if sign * (next.travelled - target) < 0.0 => {
                    return CrossingStep::Beyond(next, length);
                }
                BranchStep::Taken(_) | BranchStep::Doubtful | BranchStep::Failed => length /= 8.0,
            }
        }
        let slope = here.tangent[self.unknown.len()].abs();
        if (target - here.travelled).abs() <= LEAP_OVER * self.crossing_width() * slope
            && let TargetStep::Reached { here, .. } =
                self.step_to_target(kinematics, here, target, BranchEvidence::Crossing)
        {
            return CrossingStep::Target(here);
        }
        self.restore_positions(kinematics, &here.q);
        CrossingStep::None
    }

    /// Moves the group to the target on the branch of a regular point `here`. Returns a regular pose near the
    /// target. `None`, with the pose unchanged, if the branch does not pass through the target (a limit).
    pub(super) fn interpolate_at_target(
        &self,
        kinematics: &mut Kinematics,
        here: &BranchPoint,
        target: f64,
    ) -> Option<Vec<f64>> {
        let plain = kinematics.q.clone();
        let slope = here.tangent[self.unknown.len()].abs();
        let found = [1.0, 1.6, 2.5].iter().find_map(|factor| {
            let apart = factor * CROSSING_STEP * self.group.size * slope;
            self.interpolate_from_points(kinematics, here, target, apart * (target - here.travelled).signum())
        });
        if found.is_none() {
            kinematics.q.copy_from_slice(&plain);
            self.model.refill_group(kinematics, self.group);
        }
        found
    }

    /// Interpolates the pose at the target from places at multiples of `apart`; `None` if a place is not reached.
    fn interpolate_from_points(
        &self,
        kinematics: &mut Kinematics,
        here: &BranchPoint,
        target: f64,
        apart: f64,
    ) -> Option<Vec<f64>> {
        let offsets =
            (1..=CROSSING_PLACES as i32).rev().map(|k| -k).chain(1..=CROSSING_PLACES as i32).map(f64::from);
        let mut known: Vec<(f64, Vec<f64>)> = Vec::with_capacity(2 * CROSSING_PLACES);
        let mut from = here.clone();
        for offset in offsets {
            let gone = target + offset * apart;
            let arrival = self.follow_to(kinematics, from.clone(), gone, false);
            if !arrival.is_reached || arrival.anchor.is_some() {
                return None;
            }
            from = self.point(kinematics, gone, &from.tangent);
            known.push((offset, from.q.clone()));
        }
        kinematics.q.copy_from_slice(&self.interpolate_at_zero(&known));
        // The positions of the drivers are exact at the target; only the frames are recomputed.
        self.model.refill_group(kinematics, self.group);
        let (residual, _) = self.model.group_residual(kinematics, self.group);
        (residual <= self.tolerance).then(|| known.swap_remove(0).1)
    }

    /// Positions at offset 0 by Lagrange's formula, with quaternions normalised.
    fn interpolate_at_zero(&self, known: &[(f64, Vec<f64>)]) -> Vec<f64> {
        let mut q = vec![0.0; known[0].1.len()];
        for (i, (x, values)) in known.iter().enumerate() {
            let others = known.iter().enumerate().filter(|(j, _)| *j != i);
            let weight: f64 = others.map(|(_, (y, _))| y / (y - x)).product();
            q.iter_mut().zip(values).for_each(|(q, value)| *q += weight * value);
        }
        // Positions that are constant are copied exactly.
        for k in 0..q.len() {
            if known.iter().all(|(_, values)| values[k] == known[0].1[k]) {
                q[k] = known[0].1[k];
            }
        }
        for (joint, range) in self.model.mechanism.joints().iter().zip(&self.model.joint_q) {
            crate::model::tangent::normalise(joint.kind(), &mut q[range.clone()]);
        }
        q
    }
}
