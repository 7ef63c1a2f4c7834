//! Closing the groups of a system one after another: who drives each, and the way of the drivers to where they are wanted.

use super::Group;
use super::assembly::{Assembly, AssemblyError, GroupFacts};
use super::closing::Moves;
use super::following::Course;
use super::freedom::Singularity;
use super::posing::LoopState;
use super::roles::Roles;
use crate::kinematics::Kinematics;
use crate::{Configuration, Pose, System};
use percuss_mechanism::JointId;

/// A driver with a position of one number.
struct Driver {
    /// Index into the group's coordinates.
    at: usize,
    joint: JointId,
    /// Its place among the positions.
    q: usize,
    wanted: f64,
    given: bool,
}

/// Closes the groups of a system one after another.
pub(super) struct Closer<'a> {
    pub system: &'a System,
    pub assembly: &'a Assembly,
    pub configuration: &'a Configuration,
    pub start: Option<&'a Pose>,
    pub kinematics: Kinematics<f64>,
    pub state: LoopState,
}

impl Closer<'_> {
    /// Closes a group.
    pub fn close(&mut self, number: usize) -> Result<(), AssemblyError> {
        let (system, facts) = (self.system, &self.assembly.groups[number]);
        let group = &system.groups[number];
        let roles = self.roles(group, facts)?;
        let tolerance = system.rounded_tolerance(&self.kinematics, facts.inexactness);
        let drivers = self.drivers(group, &roles);
        let anchor = match self.configuration.guess_for(system, group) {
            Some(guess) => self.close_from_guess(group, &roles, &drivers, &guess, tolerance)?,
            None => self.close_along_branch(number, &roles, &drivers, tolerance)?,
        };
        let place = system.place_of(&self.kinematics, group, facts, &roles);
        let state = &mut self.state;
        state.residual = state.residual.max(system.group_residual(&self.kinematics, group).0);
        state.inexactness = state.inexactness.max(facts.inexactness);
        state.declared &= roles.declared;
        state.modes.push(place.mode);
        state.singularities.push(place.singularity);
        state.drivers.extend(roles.driving.iter().filter_map(|&at| group.joints[at]));
        state.following.push(roles.following);
        state.anchors.push(anchor);
        Ok(())
    }

    /// Who drives: what was set, else what is declared, else the best-conditioned choice.
    fn roles(&self, group: &Group, facts: &GroupFacts) -> Result<Roles, AssemblyError> {
        let given = |at: usize| group.joints[at].is_some_and(|id| self.configuration.given[id.index()]);
        let mut roles = self.system.roles(group, facts, given);
        let follower = |roles: &Roles| roles.following.iter().copied().find(|&at| given(at));
        if follower(&roles).is_some() && !roles.declared {
            // Long trains may carry a driver at one pose and not, to rounding, at another: try where this one starts.
            let near = self.near(group);
            let there = self.system.roles_at(group, &near, &roles, given);
            if follower(&there).is_none() {
                roles = there;
            }
        }
        if let Some(at) = follower(&roles) {
            let name =
                |at: usize| group.joints[at].map(|id| self.system.mechanism.joint(id).name().to_owned());
            let mut drivers: Vec<String> = roles.driving.iter().filter_map(|&d| name(d)).collect();
            drivers.dedup();
            return Err(AssemblyError::Dependent { joint: name(at).unwrap_or_default(), drivers });
        }
        Ok(roles)
    }

    /// Where the group's search begins.
    fn near(&self, group: &Group) -> Kinematics<f64> {
        let mut near = self.kinematics.clone();
        let guess = self.configuration.guess_for(self.system, group);
        let start = guess.as_deref().or(self.start.map(Pose::positions)).unwrap_or(&self.assembly.home);
        self.system.set_group(&mut near, group, start);
        near
    }

    fn drivers(&self, group: &Group, roles: &Roles) -> Vec<Driver> {
        let driver = |&at: &usize| {
            let joint = group.joints[at]?;
            let range = &self.system.joint_q[joint.index()];
            let given = self.configuration.given[joint.index()];
            let wanted = self.configuration.values[joint.index()][0];
            (range.len() == 1).then_some(Driver { at, joint, q: range.start, wanted, given })
        };
        roles.driving.iter().filter_map(driver).collect()
    }

    fn correct(&mut self, group: &Group, unknown: &[usize], tolerance: f64) -> bool {
        let moves = Moves { unknown, course: None };
        self.system.correct(&mut self.kinematics, group, moves, tolerance).closed
    }

    /// Puts the group where the guess says and the drivers where they are wanted. What is not closed there is closed by
    /// the shortest way, drivers and all, and then driven back along the branch; or else by the followers alone.
    fn close_from_guess(
        &mut self,
        group: &Group,
        roles: &Roles,
        drivers: &[Driver],
        guess: &[f64],
        tolerance: f64,
    ) -> Result<Option<Vec<f64>>, AssemblyError> {
        let system = self.system;
        let begin = |closer: &mut Self| {
            system.set_group(&mut closer.kinematics, group, guess);
            closer.put(group, drivers);
        };
        begin(self);
        if system.group_residual(&self.kinematics, group).0 <= tolerance {
            self.correct(group, &roles.following, tolerance);
            return Ok(None);
        }
        let all: Vec<&Driver> = drivers.iter().collect();
        let closed = self.correct(group, &group.movable, tolerance);
        // The short way may have turned driving balls aside, which cannot be driven back.
        if closed && drivers.len() == roles.driving.len() {
            let driven = self.drive(group, roles, drivers, &all, tolerance);
            if driven.is_ok() {
                return driven;
            }
        }
        begin(self);
        if self.correct(group, &roles.following, tolerance) {
            return Ok(None);
        }
        Err(self.unreachable(group, roles, drivers))
    }

    /// Follows the branch of a known closed pose until the drivers are where they are wanted. Gives a regular pose on
    /// the branch where the end is singular.
    fn close_along_branch(
        &mut self,
        number: usize,
        roles: &Roles,
        drivers: &[Driver],
        tolerance: f64,
    ) -> Result<Option<Vec<f64>>, AssemblyError> {
        let (system, facts) = (self.system, &self.assembly.groups[number]);
        let group = &system.groups[number];
        let home = &self.assembly.home;
        let regular = |closer: &Self| {
            facts.home_is_regular
                && closer.system.place_of(&closer.kinematics, group, facts, roles).singularity
                    == Singularity::None
        };
        let mut anchor = None;
        match self.start {
            Some(from) => {
                let known = from.loops.as_ref().and_then(|l| l.anchors.get(number)?.as_ref());
                let there = drivers.iter().all(|d| from.positions()[d.q] == d.wanted);
                anchor = known.cloned();
                let start = known.filter(|_| !there).map_or(from.positions(), Vec::as_slice);
                system.set_group(&mut self.kinematics, group, start);
            }
            None => {
                system.set_group(&mut self.kinematics, group, home);
                // At a change point or a dead centre there is no branch to follow.
                if !regular(self) {
                    anchor = Some(facts.generic.clone());
                    let there = drivers.iter().all(|d| home[d.q] == d.wanted);
                    if !there {
                        system.set_group(&mut self.kinematics, group, &facts.generic);
                    }
                }
            }
        }
        self.set_directly(group, roles, drivers, tolerance)?;
        // Drivers that nobody set go to 0, first and by themselves: together, or those that can.
        let (given, idle): (Vec<&Driver>, Vec<&Driver>) = drivers.iter().partition(|d| d.given);
        let before = self.kinematics.clone();
        match self.drive(group, roles, drivers, &idle, tolerance) {
            Ok(found) => {
                anchor = found.or(anchor.filter(|_| self.stands(&idle) && before.q == self.kinematics.q))
            }
            Err(_) => {
                self.kinematics = before;
                for driver in &idle {
                    let before = self.kinematics.clone();
                    if self.drive(group, roles, drivers, &[driver], tolerance).is_err() {
                        self.kinematics = before;
                        self.state.off_zero.push((driver.joint, self.kinematics.q[driver.q]));
                    }
                }
                anchor = None;
            }
        }
        if !self.stands(&given) {
            anchor = self.drive(group, roles, drivers, &given, tolerance)?;
        }
        let (residual, _) = system.group_residual(&self.kinematics, group);
        if residual <= tolerance || self.correct(group, &roles.following, tolerance) {
            Ok(anchor)
        } else {
            Err(self.unreachable(group, roles, drivers))
        }
    }

    fn stands(&self, drivers: &[&Driver]) -> bool {
        drivers.iter().all(|d| self.kinematics.q[d.q] == d.wanted)
    }

    fn put<'d>(&mut self, group: &Group, drivers: impl IntoIterator<Item = &'d Driver>) {
        for driver in drivers {
            self.kinematics.q[driver.q] = driver.wanted;
        }
        self.system.refill_group(&mut self.kinematics, group);
    }

    /// Moves some drivers to where they are wanted, in a straight line.
    fn drive(
        &mut self,
        group: &Group,
        roles: &Roles,
        drivers: &[Driver],
        moving: &[&Driver],
        tolerance: f64,
    ) -> Result<Option<Vec<f64>>, AssemblyError> {
        let mut way = vec![0.0; group.coordinates.len()];
        moving.iter().for_each(|d| way[d.at] = d.wanted - self.kinematics.q[d.q]);
        let Some(course) = Course::new(self.system, group, &roles.following, way, tolerance, roles.ease)
        else {
            return Ok(None);
        };
        let arrival = course.go(&mut self.kinematics);
        if arrival.too_far {
            return Err(self.too_far(drivers));
        }
        if !arrival.there {
            return Err(self.unreachable(group, roles, drivers));
        }
        self.put(group, moving.iter().copied());
        Ok(arrival.anchor)
    }

    /// Driving joints with positions of several numbers that were set go there in steps of a tenth, each closed from the
    /// last.
    fn set_directly(
        &mut self,
        group: &Group,
        roles: &Roles,
        drivers: &[Driver],
        tolerance: f64,
    ) -> Result<(), AssemblyError> {
        let system = self.system;
        let set = |at: &usize| {
            let id = group.joints[*at]?;
            let several = system.joint_q[id.index()].len() > 1;
            (several && self.configuration.given[id.index()]).then_some(id)
        };
        let mut joints: Vec<JointId> = roles.driving.iter().filter_map(set).collect();
        joints.dedup();
        if joints.is_empty() {
            return Ok(());
        }
        let mut goal = self.kinematics.q.clone();
        for id in &joints {
            goal[system.joint_q[id.index()].clone()].copy_from_slice(&self.configuration.values[id.index()]);
        }
        let way = system.displacement(group, &self.kinematics.q, &goal);
        let size = system.mechanism.characteristic_length();
        let far = way.iter().zip(&group.lengths).map(|(w, l)| (w * l).abs()).fold(0.0, f64::max);
        let steps = (10.0 * far / size).ceil().clamp(1.0, 1e4);
        let part: Vec<f64> = way.iter().map(|w| w / steps).collect();
        for step in 1..=steps as usize {
            system.advance_group(&mut self.kinematics, group, &part);
            if step as f64 == steps {
                for id in &joints {
                    let range = system.joint_q[id.index()].clone();
                    self.kinematics.q[range.clone()].copy_from_slice(&goal[range]);
                }
                system.refill_group(&mut self.kinematics, group);
            }
            if !self.correct(group, &roles.following, tolerance) {
                return Err(self.unreachable(group, roles, drivers));
            }
        }
        Ok(())
    }

    fn too_far(&self, drivers: &[Driver]) -> AssemblyError {
        let place = |d: &Driver, at: f64| (self.system.mechanism.joint(d.joint).name().to_owned(), at);
        AssemblyError::TooFar {
            wanted: drivers.iter().map(|d| place(d, d.wanted)).collect(),
            reached: drivers.iter().map(|d| place(d, self.kinematics.q[d.q])).collect(),
        }
    }

    /// Drivers, then followers, where the group stands now.
    fn unreachable(&self, group: &Group, roles: &Roles, drivers: &[Driver]) -> AssemblyError {
        let name = |id: JointId| self.system.mechanism.joint(id).name().to_owned();
        let follower = |&at: &usize| {
            let id = group.joints[at]?;
            let range = &self.system.joint_q[id.index()];
            (range.len() == 1).then(|| (name(id), self.kinematics.q[range.start]))
        };
        let of_drivers = drivers.iter().map(|d| (name(d.joint), self.kinematics.q[d.q]));
        AssemblyError::Unreachable {
            wanted: drivers.iter().map(|d| (name(d.joint), d.wanted)).collect(),
            nearest: of_drivers.chain(roles.following.iter().filter_map(follower)).collect(),
            loops: self.system.group_names(group),
        }
    }
}
