//! Configurations: joint positions and base pose as given by the user.

use crate::model::input::{normalise_quaternion, not_a_number, quaternion_of};
use crate::model::tangent;
use percuss_mechanism::{Joint, JointId, JointKind, Mechanism, UnknownName};
use percuss_spatial::Transform;
use std::sync::Arc;

/// Positions of the joints and the pose of the root link in the world. All joints start at zero.
#[derive(Clone, Debug)]
pub struct Configuration {
    mechanism: Arc<Mechanism>,
    /// Positions of each joint, in joint order. The positions of mimics are computed with the pose.
    pub(crate) values: Vec<Vec<f64>>,
    pub(crate) given: Vec<bool>,
    /// Initial guesses for the joints of loops.
    guesses: Vec<Option<Vec<f64>>>,
    pub(crate) base: Transform<f64>,
    pub(crate) base_is_given: bool,
    /// True if an assembly mode other than that of the first closed pose is accepted.
    pub(crate) other_assembly: bool,
}

/// Error of a position that cannot be set.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ConfigurationError {
    /// A joint does not exist.
    #[error(transparent)]
    UnknownJoint(#[from] UnknownName),
    /// A joint is already set.
    #[error("joint \"{joint}\" is set twice")]
    Twice {
        /// The joint.
        joint: String,
    },
    /// A joint is a mimic of another joint.
    #[error("joint \"{joint}\" mimics \"{master}\"; set \"{master}\" instead")]
    Mimic {
        /// The joint.
        joint: String,
        /// Name of the joint that the mimic follows.
        master: String,
    },
    /// The number of values does not fit the kind of the joint.
    #[error("joint \"{joint}\" is {}: {got} values given, expected {}", kind.name(), kind.layout())]
    Count {
        /// The joint.
        joint: String,
        /// Kind of the joint.
        kind: JointKind,
        /// Number of given values.
        got: usize,
    },
    /// The length of a whole configuration is wrong.
    #[error("{got} positions are given, the mechanism has {expected}: those of all joints, in joint order")]
    PositionCount {
        /// Number of given positions.
        got: usize,
        /// Number of positions of the mechanism.
        expected: usize,
    },
    /// A value is NaN, infinite or above 1e100 in magnitude.
    #[error("joint \"{joint}\" is set to {value:e}; expected a finite number of at most 1e100")]
    NotFinite {
        /// The joint.
        joint: String,
        /// The given value.
        value: f64,
    },
    /// The norm of a quaternion is more than [`QUATERNION_TOLERANCE`](crate::model::input::QUATERNION_TOLERANCE) from 1.
    #[error(
        "joint \"{joint}\": the quaternion w,x,y,z has norm {norm}; expected a unit quaternion, 1 ± {}: divide it by its norm",
        crate::model::input::QUATERNION_TOLERANCE
    )]
    Quaternion {
        /// The joint.
        joint: String,
        /// Norm of the quaternion.
        norm: f64,
    },
}

impl Configuration {
    /// Configuration with every joint at zero (quaternions at identity).
    pub fn zero(mechanism: &Arc<Mechanism>) -> Self {
        let values = mechanism.joints().iter().map(|j| zero_position(j.kind())).collect();
        Self {
            mechanism: Arc::clone(mechanism),
            values,
            given: vec![false; mechanism.joints().len()],
            guesses: vec![None; mechanism.joints().len()],
            base: Transform::identity(),
            base_is_given: false,
            other_assembly: false,
        }
    }

    /// Sets a driving joint (layouts of [`JointKind`]). Quaternions are normalised.
    ///
    /// # Errors
    /// [`ConfigurationError`]: an unknown joint, a joint set twice, a mimic (the message names its master), a wrong
    /// number of values, a value that is not finite.
    pub fn set(&mut self, joint: &str, values: &[f64]) -> Result<&mut Self, ConfigurationError> {
        let id = self.mechanism.find_joint(joint)?;
        let found = self.mechanism.joint(id);
        if let Some(mimic) = found.mimic() {
            let master = self.mechanism.joint(mimic.master).name().to_owned();
            return Err(ConfigurationError::Mimic { joint: joint.to_owned(), master });
        }
        if self.given[id.index()] {
            return Err(ConfigurationError::Twice { joint: joint.to_owned() });
        }
        self.values[id.index()] = checked(found, values)?;
        self.given[id.index()] = true;
        Ok(self)
    }

    /// Sets a driving joint like [`set`](Self::set), also if it is set already: for the steps of a motion.
    ///
    /// # Errors
    /// [`ConfigurationError`], as for [`set`](Self::set), but not [`ConfigurationError::Twice`]. The configuration does not change then.
    pub fn replace(&mut self, joint: &str, values: &[f64]) -> Result<&mut Self, ConfigurationError> {
        let index = self.mechanism.find_joint(joint)?.index();
        let was_given = std::mem::take(&mut self.given[index]);
        if let Err(error) = self.set(joint, values) {
            self.given[index] = was_given;
            return Err(error);
        }
        Ok(self)
    }

    /// Removes the given position of a joint. The position is then zero, or follows from loops. No effect for a joint that is not set.
    pub fn release(&mut self, joint: JointId) -> &mut Self {
        if self.mechanism.has_joint(joint) && std::mem::take(&mut self.given[joint.index()]) {
            self.values[joint.index()] = zero_position(self.mechanism.joint(joint).kind());
        }
        self
    }

    /// Resets every joint to zero and removes all settings and guesses.
    pub fn reset(&mut self) -> &mut Self {
        *self = Self::zero(&self.mechanism);
        self
    }

    /// Sets the initial guess for a joint whose position follows from loops. The guess selects the assembly mode.
    ///
    /// # Errors
    /// [`ConfigurationError`], as for [`set`](Self::set).
    pub fn guess(&mut self, joint: &str, values: &[f64]) -> Result<&mut Self, ConfigurationError> {
        let id = self.mechanism.find_joint(joint)?;
        let found = self.mechanism.joint(id);
        if self.guesses[id.index()].is_some() {
            return Err(ConfigurationError::Twice { joint: joint.to_owned() });
        }
        self.guesses[id.index()] = Some(checked(found, values)?);
        Ok(self)
    }

    /// Iterates over the joints that were set, with their positions.
    pub fn given(&self) -> impl Iterator<Item = (JointId, &[f64])> {
        let is_given = |id: &JointId| self.given[id.index()];
        self.mechanism.joint_ids().filter(is_given).map(|id| (id, &*self.values[id.index()]))
    }

    /// Iterates over the given guesses.
    pub fn guesses(&self) -> impl Iterator<Item = (JointId, &[f64])> {
        self.mechanism.joint_ids().filter_map(|id| Some((id, self.guesses[id.index()].as_deref()?)))
    }

    /// Removes the guesses, for following a branch from a known pose.
    pub fn without_guesses(mut self) -> Self {
        self.guesses.fill(None);
        self
    }

    /// The mechanism of the configuration.
    pub fn mechanism(&self) -> &Arc<Mechanism> {
        &self.mechanism
    }

    /// Positions of all joints, with the guesses for the given joints inserted; `None` if none of these joints has a guess.
    /// `joint_q`: range of each joint's positions; an entry `None` in `joints` is ignored.
    pub(crate) fn guess_for(
        &self,
        joint_q: &[std::ops::Range<usize>],
        joints: &[Option<JointId>],
    ) -> Option<Vec<f64>> {
        let mut found: Option<Vec<f64>> = None;
        for id in joints.iter().copied().flatten() {
            if let Some(guess) = &self.guesses[id.index()] {
                let q = found.get_or_insert_with(|| self.values.concat());
                q[joint_q[id.index()].clone()].copy_from_slice(guess);
            }
        }
        found
    }

    /// True if any joint has a guess.
    pub(crate) fn has_guesses(&self) -> bool {
        self.guesses.iter().any(Option::is_some)
    }

    /// Configuration from the positions of all joints one after another, in joint order (layouts of [`JointKind`]).
    /// Positions of mimics are not read. The pose closes the loops starting from these positions: driving joints keep
    /// the given positions, the other joints move to the nearest closed solution.
    ///
    /// # Errors
    /// [`ConfigurationError`]: a wrong number of positions, an invalid value.
    pub fn from_positions(mechanism: &Arc<Mechanism>, positions: &[f64]) -> Result<Self, ConfigurationError> {
        let expected = mechanism.joints().iter().map(|j| j.kind().positions()).sum();
        if positions.len() != expected {
            return Err(ConfigurationError::PositionCount { got: positions.len(), expected });
        }
        let mut configuration = Self::zero(mechanism);
        let mut rest = positions;
        for (i, joint) in mechanism.joints().iter().enumerate() {
            let (own, others) = rest.split_at(joint.kind().positions());
            rest = others;
            if joint.mimic().is_none() && !own.is_empty() {
                let values = checked(joint, own)?;
                configuration.guesses[i] = Some(values.clone());
                configuration.values[i] = values;
            }
        }
        Ok(configuration)
    }

    /// Sets the pose X_wr of the root link in the world. Poses relative to the root do not change. The pose functions
    /// check that X_wr is a rigid frame ([`input::rigid_base_pose`](crate::model::input::rigid_base_pose)).
    pub fn set_base(&mut self, x_wr: Transform<f64>) -> &mut Self {
        self.base = x_wr;
        self.base_is_given = true;
        self
    }

    /// Accepts a pose in another assembly mode if the driving joints cannot be reached on the branch of the first
    /// closed pose. Such a pose carries the remark [`OtherAssembly`](crate::Remark::OtherAssembly). Without this
    /// setting the pose fails with [`OtherAssembly`](crate::AssemblyError::OtherAssembly). A guess selects a mode
    /// without this setting.
    pub fn allow_other_assembly(&mut self) -> &mut Self {
        self.other_assembly = true;
        self
    }

    /// Position of a joint. The positions of mimics are not set here; the pose computes them.
    ///
    /// # Panics
    /// If the joint belongs to another mechanism.
    pub fn get(&self, joint: JointId) -> &[f64] {
        assert!(
            self.mechanism.has_joint(joint),
            "joint number {} belongs to another mechanism",
            joint.index()
        );
        &self.values[joint.index()]
    }
}

/// Validates the values as a position of the joint and normalises quaternions.
fn checked(joint: &Joint, values: &[f64]) -> Result<Vec<f64>, ConfigurationError> {
    let (name, kind) = (joint.name().to_owned(), joint.kind());
    if values.len() != kind.positions() || values.is_empty() {
        return Err(ConfigurationError::Count { joint: name, kind, got: values.len() });
    }
    if let Some((_, value)) = not_a_number(values) {
        return Err(ConfigurationError::NotFinite { joint: name, value });
    }
    let mut values = values.to_vec();
    if let Some(range) = quaternion_of(kind) {
        normalise_quaternion(&mut values[range])
            .map_err(|norm| ConfigurationError::Quaternion { joint: name, norm })?;
    }
    Ok(values)
}

fn zero_position(kind: JointKind) -> Vec<f64> {
    let mut q = vec![0.0; kind.positions()];
    tangent::zero_position(kind, &mut q);
    q
}
