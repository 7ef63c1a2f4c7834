//! From a configuration to a closed pose: along a branch from a closed pose that is known, or from a guess.

use super::Group;
use super::assembly::{Assembly, AssemblyError};
use super::closer::Closer;
use super::freedom::Singularity;
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
    /// together this is. 0 where it vanishes: see [`singularities`](Self::singularities).
    pub modes: Vec<i8>,
    /// For each group of loops, whether it stands at a dead centre of its drivers or at a change point.
    pub singularities: Vec<Singularity>,
    /// For each group, its coordinates (by index into it) that follow.
    pub(crate) following: Vec<Vec<usize>>,
    /// For each group that stands (nearly) singular, positions of a regular pose on the same branch.
    pub(crate) anchors: Vec<Option<Vec<f64>>>,
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

    /// The pose at a configuration on the branch of another pose of the same system, followed from there: through
    /// crossings of branches too.
    ///
    /// # Errors
    /// [`AssemblyError`], as for [`pose`](Self::pose).
    pub fn pose_from(&self, from: &Pose, configuration: &Configuration) -> Result<Pose, AssemblyError> {
        self.pose_along(configuration, Some(from))
    }

    fn pose_along(&self, configuration: &Configuration, start: Option<&Pose>) -> Result<Pose, AssemblyError> {
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
            let assembly = self.assembly_near(configuration)?;
            let state = LoopState { declared: true, ..LoopState::default() };
            let mut closer = Closer { system: self, assembly, configuration, start, kinematics, state };
            for number in 0..self.groups.len() {
                closer.close(number)?;
            }
            closer.state.drivers.sort_unstable();
            closer.state.drivers.dedup();
            kinematics = closer.kinematics;
            kinematics.refill(self);
            loops = Some(closer.state);
        }
        Ok(Pose { kinematics, joint_q: self.joint_q.clone(), base: configuration.base, loops })
    }

    /// What is known about the loops, found at the first call: from all joints at 0, or, where that leads nowhere, from
    /// the first guess that does.
    pub(crate) fn assembly(&self) -> Result<&Assembly, AssemblyError> {
        if let Some(unlocked) = &self.unlocked {
            return unlocked.assembly();
        }
        let from_zero = self.assembly.get_or_init(|| self.assemble(self.zero_kinematics()));
        match (from_zero, self.guided.get()) {
            (Ok(found), _) | (Err(_), Some(found)) => Ok(found),
            (Err(error), None) => Err(error.clone()),
        }
    }

    /// As [`assembly`](Self::assembly), and where that failed tries the configuration's guesses.
    fn assembly_near(&self, configuration: &Configuration) -> Result<&Assembly, AssemblyError> {
        let failed = match self.assembly() {
            Ok(found) => return Ok(found),
            Err(error) => error,
        };
        let mut start = self.zero_kinematics();
        let mut guessed = false;
        for group in &self.groups {
            if let Some(guess) = configuration.guess_for(self, group) {
                self.set_group(&mut start, group, &guess);
                guessed = true;
            }
        }
        start.refill(self);
        if !guessed {
            return Err(failed);
        }
        let found = self.assemble(start)?;
        Ok(self.guided.get_or_init(|| found))
    }

    /// Copies the positions of a group's joints.
    pub(crate) fn set_group(&self, kinematics: &mut Kinematics<f64>, group: &Group, q: &[f64]) {
        for id in group.joints.iter().copied().flatten() {
            let range = self.joint_q[id.index()].clone();
            kinematics.q[range.clone()].copy_from_slice(&q[range]);
        }
        self.refill_group(kinematics, group);
    }
}
