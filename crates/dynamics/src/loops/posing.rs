//! From a configuration to a closed pose: along a branch from a closed pose that is known, or from a guess.

use super::Group;
use super::assembly::{Assembly, AssemblyError, GroupFacts};
use crate::kinematics::Kinematics;
use crate::{Configuration, Pose, System};
use percuss_mechanism::JointId;

/// What a pose of a mechanism with loops stands on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoopState {
    /// Largest residual of a closure or coupling, m.
    pub residual: f64,
    /// How far the file's loops are from fitting, m: rounding that least squares had to spread; else 0.
    pub inexactness: f64,
    /// The joints that drive the loops; the others of their groups follow.
    pub drivers: Vec<JointId>,
    /// Whether the file declared exactly these as independent.
    pub declared: bool,
    /// Drivers that were not set and could not be brought to 0, with where they are.
    pub off_zero: Vec<(JointId, f64)>,
    /// For each group of loops, the sign of the determinant of the followers' Jacobian: which of the ways to put it
    /// together this is. 0 where it vanishes: a dead centre of the drivers, or a change point.
    pub modes: Vec<i8>,
    /// For each group, its coordinates (by index into it) that follow.
    pub(crate) following: Vec<Vec<usize>>,
}

/// Who drives a group.
struct Roles {
    following: Vec<usize>,
    driving: Vec<usize>,
    declared: bool,
}

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

impl System {
    /// The pose at a configuration: joints that were set drive, the others of the loops follow. The branch is that of
    /// the first closed pose found from all joints at 0, or of the configuration's guesses.
    ///
    /// # Errors
    /// [`AssemblyError`]: loops that do not close, drivers that cannot get there, a follower that was set.
    pub fn pose(&self, configuration: &Configuration) -> Result<Pose, AssemblyError> {
        self.pose_along(configuration, None)
    }

    /// The pose at a configuration on the branch of another pose of the same system, followed from there.
    ///
    /// # Errors
    /// [`AssemblyError`], as for [`pose`](Self::pose).
    pub fn pose_from(&self, from: &Pose, configuration: &Configuration) -> Result<Pose, AssemblyError> {
        self.pose_along(configuration, Some(from.positions()))
    }

    fn pose_along(
        &self,
        configuration: &Configuration,
        start: Option<&[f64]>,
    ) -> Result<Pose, AssemblyError> {
        if let Some(unlocked) = &self.unlocked {
            // A lock holds velocities, not the pose.
            return unlocked.pose_along(configuration, start);
        }
        let mut kinematics = Kinematics::new(self);
        for (values, range) in configuration.values.iter().zip(&self.joint_q) {
            kinematics.q[range.clone()].copy_from_slice(values);
        }
        kinematics.refill(self);
        let mut loops = None;
        if !self.groups.is_empty() {
            let assembly = self.assembly()?;
            let state = LoopState { declared: true, ..LoopState::default() };
            let mut closer = Closer { system: self, assembly, configuration, start, kinematics, state };
            for (group, facts) in self.groups.iter().zip(&assembly.groups) {
                closer.close(group, facts)?;
            }
            closer.state.drivers.sort_unstable();
            closer.state.drivers.dedup();
            kinematics = closer.kinematics;
            loops = Some(closer.state);
        }
        Ok(Pose { kinematics, joint_q: self.joint_q.clone(), base: configuration.base, loops })
    }

    /// What is known about the loops, found at the first call.
    pub(crate) fn assembly(&self) -> Result<&Assembly, AssemblyError> {
        if let Some(unlocked) = &self.unlocked {
            return unlocked.assembly();
        }
        self.assembly.get_or_init(|| self.assemble(self.zero_kinematics())).as_ref().map_err(Clone::clone)
    }

    /// Copies the positions of a group's joints.
    pub(crate) fn set_group(&self, kinematics: &mut Kinematics<f64>, group: &Group, q: &[f64]) {
        for &c in &group.coordinates {
            if let Some(id) = self.joint_of_coordinate(c) {
                let range = self.joint_q[id.index()].clone();
                kinematics.q[range.clone()].copy_from_slice(&q[range]);
            }
        }
        kinematics.refill(self);
    }
}

/// Closes the groups of a system one after another.
struct Closer<'a> {
    system: &'a System,
    assembly: &'a Assembly,
    configuration: &'a Configuration,
    start: Option<&'a [f64]>,
    kinematics: Kinematics<f64>,
    state: LoopState,
}

impl Closer<'_> {
    fn close(&mut self, group: &Group, facts: &GroupFacts) -> Result<(), AssemblyError> {
        let system = self.system;
        let roles = self.roles(group, facts)?;
        let tolerance = system.closing_tolerance(&self.kinematics).max(2.0 * facts.inexactness);
        let drivers = self.drivers(group, &roles);
        match self.configuration.guess_for(system, group) {
            Some(guess) => self.close_from_guess(group, &roles, &drivers, &guess, tolerance)?,
            None => self.close_along_branch(group, facts, &roles, &drivers, tolerance)?,
        }
        self.state.residual = self.state.residual.max(system.group_residual(&self.kinematics, group).0);
        self.state.inexactness = self.state.inexactness.max(facts.inexactness);
        self.state.declared &= roles.declared;
        self.state.modes.push(system.mode(&self.kinematics, group, facts, &roles.following));
        self.state.following.push(roles.following);
        let joint = |&at: &usize| system.joint_of_coordinate(group.coordinates[at]);
        self.state.drivers.extend(roles.driving.iter().filter_map(joint));
        Ok(())
    }

    /// Who drives: what was set, else what is declared, else the best-conditioned choice.
    fn roles(&self, group: &Group, facts: &GroupFacts) -> Result<Roles, AssemblyError> {
        let (system, mechanism) = (self.system, &self.system.mechanism);
        let joint = |at: usize| system.joint_of_coordinate(group.coordinates[at]);
        let count = group.coordinates.len();
        let advice: Vec<u8> = (0..count)
            .map(|at| match joint(at).map(|id| mechanism.joint(id).independent()) {
                None | Some(Some(true)) => 2,
                Some(None) => 1,
                Some(Some(false)) => 0,
            })
            .collect();
        let given = |at: usize| joint(at).is_some_and(|id| self.configuration.given[id.index()]);
        let rest = |following: &[usize]| (0..count).filter(|at| !following.contains(at)).collect::<Vec<_>>();
        let by_advice = system.followers(group, facts, &advice);
        let advised = rest(&by_advice);
        let mobility = count - facts.rank.rank;
        let declared = advised.iter().all(|&at| advice[at] == 2)
            && advice.iter().filter(|a| **a == 2).count() == mobility;
        let (following, driving) = if declared {
            (by_advice, advised)
        } else {
            let wish: Vec<u8> = (0..count).map(|at| if given(at) { 3 } else { advice[at] }).collect();
            let following = system.followers(group, facts, &wish);
            let driving = rest(&following);
            (following, driving)
        };
        if let Some(&at) = following.iter().find(|&&at| given(at)) {
            let name = |at: usize| joint(at).map(|id| mechanism.joint(id).name().to_owned());
            let mut drivers: Vec<String> = driving.iter().filter_map(|&d| name(d)).collect();
            drivers.dedup();
            return Err(AssemblyError::Dependent { joint: name(at).unwrap_or_default(), drivers });
        }
        Ok(Roles { following, driving, declared })
    }

    fn drivers(&self, group: &Group, roles: &Roles) -> Vec<Driver> {
        let driver = |&at: &usize| {
            let joint = self.system.joint_of_coordinate(group.coordinates[at])?;
            let range = &self.system.joint_q[joint.index()];
            let given = self.configuration.given[joint.index()];
            let wanted = self.kinematics.q[range.start];
            (range.len() == 1).then_some(Driver { at, joint, q: range.start, wanted, given })
        };
        roles.driving.iter().filter_map(driver).collect()
    }

    /// Puts the group where the guess says, the drivers where they are wanted, and closes it there.
    fn close_from_guess(
        &mut self,
        group: &Group,
        roles: &Roles,
        drivers: &[Driver],
        guess: &[f64],
        tolerance: f64,
    ) -> Result<(), AssemblyError> {
        self.system.set_group(&mut self.kinematics, group, guess);
        for driver in drivers {
            self.kinematics.q[driver.q] = driver.wanted;
        }
        self.kinematics.refill(self.system);
        let correction = self.system.correct(&mut self.kinematics, group, &roles.following, tolerance);
        if correction.closed { Ok(()) } else { Err(self.unreachable(group, drivers)) }
    }

    /// Follows the branch of a known closed pose until the drivers are where they are wanted.
    fn close_along_branch(
        &mut self,
        group: &Group,
        facts: &GroupFacts,
        roles: &Roles,
        drivers: &[Driver],
        tolerance: f64,
    ) -> Result<(), AssemblyError> {
        let system = self.system;
        let wanted: Vec<(std::ops::Range<usize>, Vec<f64>)> = self.set_directly(group, roles);
        let at_home = drivers.iter().all(|d| self.assembly.home[d.q] == d.wanted);
        let start = match self.start {
            Some(start) => start,
            // At a change point there is no branch to follow.
            None if facts.home_is_regular || at_home => &self.assembly.home,
            None => &facts.generic,
        };
        system.set_group(&mut self.kinematics, group, start);
        for (range, values) in &wanted {
            self.kinematics.q[range.clone()].copy_from_slice(values);
        }
        self.kinematics.refill(system);
        if !wanted.is_empty() {
            system.correct(&mut self.kinematics, group, &roles.following, tolerance);
        }
        // Drivers that nobody set go to 0 as far as they can, first and by themselves.
        for given in [false, true] {
            let moving: Vec<&Driver> = drivers.iter().filter(|d| d.given == given).collect();
            let mut way = vec![0.0; group.coordinates.len()];
            moving.iter().for_each(|d| way[d.at] = d.wanted - self.kinematics.q[d.q]);
            if way.iter().all(|w| *w == 0.0) {
                continue;
            }
            let gone = system.drive(&mut self.kinematics, group, &roles.following, &way, tolerance);
            if gone < 1.0 && given {
                return Err(self.unreachable(group, drivers));
            }
            for driver in moving {
                if gone == 1.0 {
                    self.kinematics.q[driver.q] = driver.wanted;
                } else if self.kinematics.q[driver.q] != driver.wanted {
                    self.state.off_zero.push((driver.joint, self.kinematics.q[driver.q]));
                }
            }
            self.kinematics.refill(system);
            system.correct(&mut self.kinematics, group, &roles.following, tolerance);
        }
        let (residual, _) = system.group_residual(&self.kinematics, group);
        if residual <= tolerance { Ok(()) } else { Err(self.unreachable(group, drivers)) }
    }

    /// Driving joints with positions of several numbers that were set: they are put there, not followed.
    fn set_directly(&self, group: &Group, roles: &Roles) -> Vec<(std::ops::Range<usize>, Vec<f64>)> {
        let direct = |&at: &usize| {
            let joint = self.system.joint_of_coordinate(group.coordinates[at])?;
            let range = self.system.joint_q[joint.index()].clone();
            let direct = range.len() > 1 && self.configuration.given[joint.index()];
            direct.then(|| (range.clone(), self.kinematics.q[range].to_vec()))
        };
        roles.driving.iter().filter_map(direct).collect()
    }

    fn unreachable(&self, group: &Group, drivers: &[Driver]) -> AssemblyError {
        let name = |d: &Driver| self.system.mechanism.joint(d.joint).name().to_owned();
        AssemblyError::Unreachable {
            wanted: drivers.iter().map(|d| (name(d), d.wanted)).collect(),
            nearest: drivers.iter().map(|d| (name(d), self.kinematics.q[d.q])).collect(),
            loops: self.system.group_names(group),
        }
    }
}
