//! Closing the groups of a model one after another: choice of the drivers, and their path to the requested positions.

use super::error::AssemblyError;
use super::facts::{Facts, GroupFacts, Refused};
use super::state::LoopState;
use crate::kinematics::frames::Kinematics;
use crate::kinematics::rows::{GroupRows, largest};
use crate::loops::closing::{Directions, DriverPath, Linearised};
use crate::mobility::{Drivers, Singularity};
use crate::model::configuration::Configuration;
use crate::model::{Group, Model};
use crate::tolerances::{
    CONVERGED_STEP, CORRECTIONS_SHRINK, FEWEST_SET_CORRECTIONS, MATCHED, MODE_STARTS, MODE_STARTS_ASIDE,
    MODE_STARTS_WORK, MOST_SET_STEPS, SET_CORRECTIONS, SET_ROUNDING, SET_WORK,
};
use percuss_mechanism::JointId;

/// A driver with a single position.
struct Driver {
    /// Index into the group's coordinates.
    at: usize,
    joint: JointId,
    /// Index among the positions.
    q: usize,
    requested: f64,
    given: bool,
}

/// Result of closing a group.
#[derive(Default)]
struct Closed {
    /// Positions of a regular pose on the branch, if the pose is (nearly) singular.
    anchor: Option<Vec<f64>>,
    /// Residuals and rows of the group at the current pose, if known.
    linearised: Option<Linearised>,
}

/// Closed pose from which a branch is followed.
#[derive(Clone, Copy)]
pub(crate) struct Start<'a> {
    pub positions: &'a [f64],
    /// For each group at a (nearly) singular pose: positions of a regular pose on the same branch.
    pub anchors: &'a [Option<Vec<f64>>],
}

/// Closes the groups of a model one after another. The frames in `kinematics` must match the positions.
pub(crate) struct Closer<'a> {
    pub model: &'a Model,
    pub facts: &'a Facts,
    pub configuration: &'a Configuration,
    pub start: Option<Start<'a>>,
    pub kinematics: Kinematics,
    pub state: LoopState,
}

impl Closer<'_> {
    /// Closes the loops of group `number` at the requested positions of its driving joints.
    pub fn close(&mut self, number: usize) -> Result<(), AssemblyError> {
        let (model, facts) = (self.model, &self.facts.groups[number]);
        let group = &model.groups[number];
        let divided = self.choose_drivers(group, facts)?;
        let misfit = facts.misfit_beyond(group, &self.kinematics, model);
        let tolerance = model.rounded_tolerance(&self.kinematics, group, misfit);
        let drivers = self.drivers(group, &divided);
        let closed = match self.guess_for(group) {
            Some(guess) => self.close_from_guess(group, &divided, &drivers, &guess, tolerance)?,
            None => match self.close_along_branch(number, &divided, &drivers, tolerance) {
                Err(failed @ AssemblyError::Unreachable { .. }) if self.start.is_none() => {
                    self.close_from_seeded_starts(group, &divided, &drivers, tolerance, failed)?
                }
                followed => followed?,
            },
        };
        let here = closed.linearised.unwrap_or_else(|| Linearised::at(model, &self.kinematics, group));
        let mode = model.mode_of(&here.rows, group, &facts.generic(), &divided);
        let state = &mut self.state;
        state.residual = state.residual.max(largest(&here.residuals).0);
        state.inexactness = state.inexactness.max(facts.inexactness);
        state.declared &= divided.declared;
        state.modes.push(mode.sign);
        state.singularities.push(mode.singularity);
        state.drivers.extend(divided.driving.iter().filter_map(|&at| group.joints[at]));
        state.dependent.push(divided.dependent);
        state.anchors.push(closed.anchor);
        Ok(())
    }

    /// True if the joint of a coordinate was set.
    fn is_given(&self, group: &Group, at: usize) -> bool {
        group.joints[at].is_some_and(|id| self.configuration.given[id.index()])
    }

    /// Drivers: the set coordinates, then declared coordinates, then coordinates that are probably actuated.
    fn choose_drivers(&self, group: &Group, facts: &GroupFacts) -> Result<Drivers, AssemblyError> {
        let given = |at: usize| self.is_given(group, at);
        facts.choose_drivers(self.model, group, || self.search_frames(group), given).map_err(
            |Refused { at, drivers }| {
                let name = |at: usize| group.joints[at].map(|id| self.model.joint_name(id).to_owned());
                let names = |of: &mut dyn Iterator<Item = usize>| {
                    let mut names: Vec<String> = of.filter_map(name).collect();
                    names.dedup();
                    names
                };
                let set = names(&mut drivers.driving.iter().copied().filter(|&d| given(d)));
                let drivers = names(&mut drivers.driving.iter().copied());
                AssemblyError::Dependent { joint: name(at).unwrap_or_default(), drivers, set }
            },
        )
    }

    /// All positions with the guesses for the group inserted; `None` without guesses.
    fn guess_for(&self, group: &Group) -> Option<Vec<f64>> {
        self.configuration.guess_for(&self.model.joint_q, &group.joints)
    }

    /// Frames at which the search for the group begins.
    fn search_frames(&self, group: &Group) -> Kinematics {
        let mut near = self.kinematics.clone();
        let guess = self.guess_for(group);
        let start = guess.as_deref().or(self.start.map(|s| s.positions)).unwrap_or(&self.facts.reference);
        self.model.set_group(&mut near, group, start);
        near
    }

    /// Sets the drivers to the requested positions and closes the dependent coordinates from seeded starts. Used if
    /// the branch of the first closed pose does not reach the positions. Returns an error if the configuration does
    /// not accept another assembly mode.
    fn close_from_seeded_starts(
        &mut self,
        group: &Group,
        divided: &Drivers,
        drivers: &[Driver],
        tolerance: f64,
        failed: AssemblyError,
    ) -> Result<Closed, AssemblyError> {
        let before = self.kinematics.clone();
        let starts = (MODE_STARTS_WORK / group.coordinates.len().pow(3).max(1)).min(MODE_STARTS);
        for attempt in 0..starts {
            self.model.set_group(&mut self.kinematics, group, &self.facts.reference);
            self.model.perturb(
                &mut self.kinematics,
                group,
                MODE_STARTS_ASIDE[attempt % MODE_STARTS_ASIDE.len()],
                5000 + attempt as u64,
            );
            self.set_drivers(group, drivers);
            if self.correct(group, &divided.dependent, tolerance) && self.are_set_joints_at_target(group) {
                if !self.configuration.other_assembly {
                    self.kinematics = before;
                    return Err(failed.on_other_assembly(attempt + 1));
                }
                self.state.starts_tried = Some(attempt + 1);
                return Ok(Closed::default());
            }
        }
        self.kinematics = before;
        Err(failed.after_starts(starts))
    }

    /// Driving joints with a single position, and their requested positions.
    fn drivers(&self, group: &Group, divided: &Drivers) -> Vec<Driver> {
        let driver = |&at: &usize| {
            let joint = group.joints[at]?;
            let range = &self.model.joint_q[joint.index()];
            let given = self.configuration.given[joint.index()];
            let requested = self.configuration.values[joint.index()][0];
            (range.len() == 1).then_some(Driver { at, joint, q: range.start, requested, given })
        };
        divided.driving.iter().filter_map(driver).collect()
    }

    /// Closes the group by moving the coordinates `unknown`. Returns true if closed.
    fn correct(&mut self, group: &Group, unknown: &[usize], tolerance: f64) -> bool {
        let directions = Directions::of(unknown);
        self.model.correct(&mut self.kinematics, group, directions, tolerance).closed
    }

    /// Closes the group from a guess, with the drivers at the requested positions. If the guess is not closed, the
    /// group is closed by the shortest motion, drivers included, and the drivers are then moved back along the
    /// branch. If this fails, only the dependent coordinates are moved.
    fn close_from_guess(
        &mut self,
        group: &Group,
        divided: &Drivers,
        drivers: &[Driver],
        guess: &[f64],
        tolerance: f64,
    ) -> Result<Closed, AssemblyError> {
        let model = self.model;
        let begin = |closer: &mut Self| {
            model.set_group(&mut closer.kinematics, group, guess);
            closer.set_drivers(group, drivers);
        };
        begin(self);
        if model.group_residual(&self.kinematics, group).0 <= tolerance {
            self.correct(group, &divided.dependent, tolerance);
            self.restore_set_joints(group, divided, drivers, tolerance)?;
            return Ok(Closed::default());
        }
        let all: Vec<&Driver> = drivers.iter().collect();
        let closed = self.correct(group, &group.movable, tolerance);
        // The shortest motion may have rotated driving spherical joints, which cannot be moved back along a path.
        if closed && drivers.len() == divided.driving.len() {
            let driven = self.move_drivers(group, divided, drivers, &all, tolerance);
            if let Ok(Closed { anchor, .. }) = driven {
                self.restore_set_joints(group, divided, drivers, tolerance)?;
                return Ok(Closed { anchor, linearised: None });
            }
        }
        begin(self);
        if self.correct(group, &divided.dependent, tolerance) {
            self.restore_set_joints(group, divided, drivers, tolerance)?;
            return Ok(Closed::default());
        }
        Err(self.unreachable_error(group, divided, drivers))
    }

    /// Moves joints with several set positions back to these positions, if closing from a guess has moved the joints.
    fn restore_set_joints(
        &mut self,
        group: &Group,
        divided: &Drivers,
        drivers: &[Driver],
        tolerance: f64,
    ) -> Result<(), AssemblyError> {
        if self.are_set_joints_at_target(group) {
            Ok(())
        } else {
            self.move_set_joints(group, divided, drivers, tolerance)
        }
    }

    /// Follows the branch of a known closed pose until the drivers reach the requested positions. Returns a regular
    /// pose on the branch if the end is singular.
    fn close_along_branch(
        &mut self,
        number: usize,
        divided: &Drivers,
        drivers: &[Driver],
        tolerance: f64,
    ) -> Result<Closed, AssemblyError> {
        let (model, facts) = (self.model, &self.facts.groups[number]);
        let group = &model.groups[number];
        let home = &self.facts.reference;
        let generic = facts.generic();
        let regular = |closer: &Self| {
            let mut rows = GroupRows::default();
            rows.fill(model, group, &closer.kinematics);
            facts.reference_is_regular
                && model.mode_of(&rows, group, &generic, divided).singularity == Singularity::None
        };
        let mut anchor = None;
        match self.start {
            Some(from) => {
                let known = from.anchors.get(number).and_then(|anchor| anchor.as_ref());
                let there = drivers.iter().all(|d| from.positions[d.q] == d.requested);
                anchor = known.cloned();
                match known.filter(|_| !there) {
                    Some(known) => model.restore_group(&mut self.kinematics, group, known),
                    None => model.set_group(&mut self.kinematics, group, from.positions),
                }
            }
            None => {
                model.set_group(&mut self.kinematics, group, home);
                // There is no unique branch to follow at a change point or a dead centre; use the generic pose.
                if !regular(self) {
                    anchor = Some(facts.generic.clone());
                    let there = drivers.iter().all(|d| home[d.q] == d.requested);
                    if !there {
                        model.restore_group(&mut self.kinematics, group, &facts.generic);
                    }
                }
            }
        }
        self.move_set_joints(group, divided, drivers, tolerance)?;
        // First move drivers that were not set to 0: all together, or else each on its own as far as possible.
        let (given, others): (Vec<&Driver>, Vec<&Driver>) = drivers.iter().partition(|d| d.given);
        if !self.are_drivers_at_target(&others) {
            let positions = |closer: &Self| model.group_positions(group, &closer.kinematics.q);
            let before = positions(self);
            match self.move_drivers(group, divided, drivers, &others, tolerance) {
                Ok(found) => anchor = found.anchor,
                Err(_) => {
                    model.restore_group(&mut self.kinematics, group, &before);
                    for driver in &others {
                        let before = positions(self);
                        if self.move_drivers(group, divided, drivers, &[driver], tolerance).is_err() {
                            model.restore_group(&mut self.kinematics, group, &before);
                            self.state.off_zero.push((driver.joint, self.kinematics.q[driver.q]));
                        }
                    }
                    anchor = None;
                }
            }
        }
        let mut here = None;
        if !self.are_drivers_at_target(&given) {
            Closed { anchor, linearised: here } =
                self.move_drivers(group, divided, drivers, &given, tolerance)?;
        }
        let here = here.unwrap_or_else(|| Linearised::at(model, &self.kinematics, group));
        if largest(&here.residuals).0 <= tolerance {
            Ok(Closed { anchor, linearised: Some(here) })
        } else if self.correct(group, &divided.dependent, tolerance) {
            Ok(Closed { anchor, linearised: None })
        } else {
            Err(self.unreachable_error(group, divided, drivers))
        }
    }

    /// True if all drivers are at the requested positions.
    fn are_drivers_at_target(&self, drivers: &[&Driver]) -> bool {
        drivers.iter().all(|d| self.kinematics.q[d.q] == d.requested)
    }

    /// Sets drivers to the requested positions. Returns true if any driver moved.
    fn set_drivers<'d>(&mut self, group: &Group, drivers: impl IntoIterator<Item = &'d Driver>) -> bool {
        let mut moved = false;
        for driver in drivers {
            moved |= self.kinematics.q[driver.q] != driver.requested;
            self.kinematics.q[driver.q] = driver.requested;
        }
        if moved {
            self.model.refill_group(&mut self.kinematics, group);
        }
        moved
    }

    /// Moves some drivers to the requested positions along a straight line.
    fn move_drivers(
        &mut self,
        group: &Group,
        divided: &Drivers,
        drivers: &[Driver],
        moving: &[&Driver],
        tolerance: f64,
    ) -> Result<Closed, AssemblyError> {
        let mut direction = vec![0.0; group.coordinates.len()];
        moving.iter().for_each(|d| direction[d.at] = d.requested - self.kinematics.q[d.q]);
        let Some(path) = DriverPath::new(
            self.model,
            group,
            &divided.dependent,
            direction,
            tolerance,
            divided.conditioning,
            moving.iter().map(|d| (d.q, d.requested)).collect(),
        ) else {
            return Ok(Closed::default());
        };
        let arrival = path.follow(&mut self.kinematics);
        if arrival.too_far {
            return Err(self.too_far_error(group, drivers));
        }
        if arrival.uncertain {
            return Err(self.uncertain_error(group, drivers));
        }
        if !arrival.is_reached {
            return Err(self.unreachable_error(group, divided, drivers));
        }
        let moved = self.set_drivers(group, moving.iter().copied());
        let anchor = arrival.anchor.map(|anchor| self.model.group_positions(group, &anchor));
        Ok(Closed { anchor, linearised: arrival.linearised.filter(|_| !moved) })
    }

    /// Joints of a group with several positions that were set.
    fn multi_position_joints(&self, group: &Group) -> Vec<JointId> {
        let several = |id: &JointId| self.model.joint_q[id.index()].len() > 1;
        let given = group.joints.iter().copied().flatten().filter(|id| self.configuration.given[id.index()]);
        let mut joints: Vec<JointId> = given.filter(several).collect();
        joints.dedup();
        joints
    }

    /// Remaining displacement of the set joints with several positions, over the group's coordinates.
    fn remaining_displacement(&self, group: &Group, joints: &[JointId]) -> Vec<f64> {
        let mut goal = self.kinematics.q.clone();
        for id in joints {
            let requested = &self.configuration.values[id.index()];
            goal[self.model.joint_q[id.index()].clone()].copy_from_slice(requested);
        }
        let mut left = self.model.displacement(group, &self.kinematics.q, &goal);
        for (left, joint) in left.iter_mut().zip(&group.joints) {
            if !joint.is_some_and(|id| joints.contains(&id)) {
                *left = 0.0;
            }
        }
        left
    }

    /// True if the set joints with several positions are at these positions.
    fn are_set_joints_at_target(&self, group: &Group) -> bool {
        let left = self.remaining_displacement(group, &self.multi_position_joints(group));
        left.iter().zip(&group.lengths).all(|(l, length)| (l * length).abs() <= MATCHED * group.size)
    }

    /// Moves set joints with several positions to these positions, in steps of a tenth of the group's size. Each step
    /// solves the closure equations and the remaining displacement together in least squares, because the joints may
    /// have fewer degrees of freedom than positions.
    fn move_set_joints(
        &mut self,
        group: &Group,
        divided: &Drivers,
        drivers: &[Driver],
        tolerance: f64,
    ) -> Result<(), AssemblyError> {
        let model = self.model;
        let joints = self.multi_position_joints(group);
        if joints.is_empty() {
            return Ok(());
        }
        let held = |at: &usize| drivers.iter().any(|d| d.at == *at);
        let unknown: Vec<usize> = group.movable.iter().copied().filter(|at| !held(at)).collect();
        let set: Vec<usize> = (0..unknown.len())
            .filter(|k| group.joints[unknown[*k]].is_some_and(|id| joints.contains(&id)))
            .collect();
        let far = self.remaining_displacement(group, &joints);
        let far = far.iter().zip(&group.lengths).map(|(l, length)| (l * length).abs()).fold(0.0, f64::max);
        let steps = (10.0 * far / group.size).ceil().clamp(1.0, MOST_SET_STEPS) as usize;
        let directions = Directions::of(&unknown);
        let cubes = SET_WORK / group.coordinates.len().pow(3).max(1);
        let mut budget = cubes.clamp(FEWEST_SET_CORRECTIONS, SET_WORK);
        for step in 0..steps {
            let part = 1.0 / (steps - step) as f64;
            let mut left: Vec<f64> =
                self.remaining_displacement(group, &joints).iter().map(|l| l * part).collect();
            let mut before = f64::INFINITY;
            for _ in 0..SET_CORRECTIONS {
                if budget == 0 {
                    return Err(self.too_far_error(group, drivers));
                }
                budget -= 1;
                if step + 1 == steps {
                    // Rotations do not add; in the last step the remaining displacement is measured, not summed.
                    left = self.remaining_displacement(group, &joints);
                }
                let here = Linearised::at(model, &self.kinematics, group);
                let mut jacobian = directions.jacobian(group, &here.rows);
                let mut target: Vec<f64> = here.residuals.iter().map(|r| -r).collect();
                for &k in &set {
                    jacobian.entries.push((jacobian.rows, k, 1.0));
                    jacobian.rows += 1;
                    target.push(left[unknown[k]] * group.lengths[unknown[k]]);
                }
                let x = jacobian.shortest(&target, 0.0);
                let u = directions.expand(group, |k| x[k]);
                model.advance_group(&mut self.kinematics, group, &u);
                left.iter_mut().zip(&u).for_each(|(l, u)| *l -= u);
                let gone = x.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
                let rounding = gone <= CONVERGED_STEP * group.size && gone >= CORRECTIONS_SHRINK * before;
                if gone <= SET_ROUNDING * group.size || rounding {
                    break;
                }
                before = gone;
            }
        }
        // Driving joints take the set positions exactly; dependent joints are as close to them as the loops permit.
        let drives = |id: &JointId| divided.driving.iter().all(|&d| group.joints[d] != Some(*id));
        let whole =
            |id: &&JointId| !divided.dependent.iter().any(|&d| group.joints[d] == Some(**id)) && !drives(id);
        for id in joints.iter().filter(whole) {
            let range = model.joint_q[id.index()].clone();
            self.kinematics.q[range].copy_from_slice(&self.configuration.values[id.index()]);
        }
        model.refill_group(&mut self.kinematics, group);
        let closed = self.correct(group, &divided.dependent, tolerance);
        let depends = |id: &JointId| divided.dependent.iter().any(|&at| group.joints[at] == Some(*id));
        if closed && (self.are_set_joints_at_target(group) || joints.iter().all(depends)) {
            self.record_off_target(group, &joints);
            return Ok(());
        }
        Err(self.unreachable_error(group, divided, drivers))
    }

    /// Records the joints with more set values than degrees of freedom, and their remaining distance.
    fn record_off_target(&mut self, group: &Group, joints: &[JointId]) {
        let left = self.remaining_displacement(group, joints);
        for id in joints {
            let own = left.iter().zip(&group.joints).filter(|(_, joint)| **joint == Some(*id));
            let far = own.map(|(l, _)| l * l).sum::<f64>().sqrt();
            if far > MATCHED {
                self.state.off_target.push((*id, far));
            }
        }
    }

    /// Error with the positions of drivers, then those of set joints with several positions.
    fn too_far_error(&self, group: &Group, drivers: &[Driver]) -> AssemblyError {
        let name = |id: JointId| self.model.joint_name(id).to_owned();
        let numbers = |id: &JointId, values: &[f64]| -> Vec<(String, f64)> {
            values.iter().enumerate().map(|(k, value)| (format!("{}[{k}]", name(*id)), *value)).collect()
        };
        let several = self.multi_position_joints(group);
        let requested = several.iter().flat_map(|id| numbers(id, &self.configuration.values[id.index()]));
        let reached = |id: &JointId| numbers(id, &self.kinematics.q[self.model.joint_q[id.index()].clone()]);
        AssemblyError::TooFar {
            requested: drivers.iter().map(|d| (name(d.joint), d.requested)).chain(requested).collect(),
            reached: drivers
                .iter()
                .map(|d| (name(d.joint), self.kinematics.q[d.q]))
                .chain(several.iter().flat_map(reached))
                .collect(),
        }
    }

    /// Error with the requested and the current positions of the drivers.
    fn uncertain_error(&self, group: &Group, drivers: &[Driver]) -> AssemblyError {
        let name = |id: JointId| self.model.joint_name(id).to_owned();
        AssemblyError::BranchUncertain {
            requested: drivers.iter().map(|d| (name(d.joint), d.requested)).collect(),
            reached: drivers.iter().map(|d| (name(d.joint), self.kinematics.q[d.q])).collect(),
            loops: self.model.group_names(group),
        }
    }

    /// Error with the current positions of drivers, then of dependent joints.
    fn unreachable_error(&self, group: &Group, divided: &Drivers, drivers: &[Driver]) -> AssemblyError {
        let name = |id: JointId| self.model.joint_name(id).to_owned();
        let follower = |&at: &usize| {
            let id = group.joints[at]?;
            let range = &self.model.joint_q[id.index()];
            (range.len() == 1).then(|| (name(id), self.kinematics.q[range.start]))
        };
        let of_drivers = drivers.iter().map(|d| (name(d.joint), self.kinematics.q[d.q]));
        AssemblyError::Unreachable {
            requested: drivers.iter().map(|d| (name(d.joint), d.requested)).collect(),
            nearest: of_drivers.chain(divided.dependent.iter().filter_map(follower)).collect(),
            loops: self.model.group_names(group),
            starts: 0,
        }
    }
}
