//! Where the joints stand, as the user gives it.

use crate::input::{normalise_quaternion, not_a_number, quaternion_of};
use crate::tangent;
use percuss_mechanism::{Joint, JointId, JointKind, Mechanism, UnknownName};
use percuss_spatial::Transform;
use std::sync::Arc;

/// Positions of the joints, and where the root link stands in the world. Starts at zero everywhere.
#[derive(Clone, Debug)]
pub struct Configuration {
    mechanism: Arc<Mechanism>,
    /// One list a joint, in joint order; mimics are filled in when a pose is made.
    pub(crate) values: Vec<Vec<f64>>,
    pub(crate) given: Vec<bool>,
    /// Where joints of loops are looked for.
    guesses: Vec<Option<Vec<f64>>>,
    pub(crate) base: Transform<f64>,
    pub(crate) base_is_given: bool,
    /// Whether another assembly mode than that of the first closed pose is accepted.
    pub(crate) other_assembly: bool,
}

/// A position that cannot be set.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ConfigurationError {
    /// A joint that does not exist.
    #[error(transparent)]
    UnknownJoint(#[from] UnknownName),
    /// A joint that is set already.
    #[error("joint \"{joint}\" is set twice")]
    Twice {
        /// The joint.
        joint: String,
    },
    /// A joint that follows another.
    #[error("joint \"{joint}\" mimics \"{master}\"; set \"{master}\" instead")]
    Mimic {
        /// The joint.
        joint: String,
        /// What it follows.
        master: String,
    },
    /// The number of values does not fit the kind.
    #[error("joint \"{joint}\" is {}: {got} values given, expected {}", kind.name(), kind.layout())]
    Count {
        /// The joint.
        joint: String,
        /// Its kind.
        kind: JointKind,
        /// How many were given.
        got: usize,
    },
    /// A whole configuration of another length.
    #[error("{got} positions are given, the mechanism has {expected}: those of all joints, in joint order")]
    PositionCount {
        /// How many were given.
        got: usize,
        /// How many there are.
        expected: usize,
    },
    /// NaN or infinite.
    #[error("joint \"{joint}\" is set to {value:e}; expected a finite number of at most 1e100")]
    NotFinite {
        /// The joint.
        joint: String,
        /// What was given.
        value: f64,
    },
    /// The quaternion is more than [`QUATERNION_TOLERANCE`](crate::input::QUATERNION_TOLERANCE) from unit norm.
    #[error(
        "joint \"{joint}\": the quaternion w,x,y,z has norm {norm}; expected a unit quaternion, 1 ± {}: divide it by its norm",
        crate::input::QUATERNION_TOLERANCE
    )]
    Quaternion {
        /// The joint.
        joint: String,
        /// Its norm.
        norm: f64,
    },
}

impl Configuration {
    /// Every joint at zero (quaternions at identity).
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

    /// Sets a driving joint (layouts of [`JointKind`]); quaternions are normalised.
    ///
    /// # Errors
    /// [`ConfigurationError`]: unknown, set twice, a mimic (the message names its master), a count that does not
    /// fit, not finite.
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

    /// Sets where to look for a joint that follows from loops: which assembly mode is meant.
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

    /// The guesses given.
    pub fn guesses(&self) -> impl Iterator<Item = (JointId, &[f64])> {
        self.mechanism.joint_ids().filter_map(|id| Some((id, self.guesses[id.index()].as_deref()?)))
    }

    /// The same without guesses, to follow a branch from a pose that is known.
    pub fn without_guesses(mut self) -> Self {
        self.guesses.fill(None);
        self
    }

    /// The mechanism it belongs to.
    pub fn mechanism(&self) -> &Arc<Mechanism> {
        &self.mechanism
    }

    /// All positions with the guesses for these joints in place, if there is any.
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

    /// Whether any joint is guessed.
    pub(crate) fn has_guesses(&self) -> bool {
        self.guesses.iter().any(Option::is_some)
    }

    /// A whole configuration: positions of all joints one after another, in joint order (layouts of [`JointKind`]); those
    /// of mimics are not read. Loops are closed from there: driving joints stand where they are given, the others come out
    /// next to where they are given.
    ///
    /// # Errors
    /// [`ConfigurationError`]: a number of positions that is not the mechanism's, a value that is none.
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

    /// Sets where the root link stands in the world: X_wr. Moves nothing relative to the root. Checked when a pose is made: a
    /// rigid frame ([`input::rigid_base_pose`](crate::input::rigid_base_pose)).
    pub fn set_base(&mut self, x_wr: Transform<f64>) -> &mut Self {
        self.base = x_wr;
        self.base_is_given = true;
        self
    }

    /// Accepts a pose on another assembly mode, where the branch of the first closed pose does not reach the driving joints.
    /// Such a pose has the remark [`OtherAssembly`](crate::Remark::OtherAssembly); without this it is the error
    /// [`OtherAssembly`](crate::AssemblyError::OtherAssembly). A guess chooses a mode by itself.
    pub fn allow_other_assembly(&mut self) -> &mut Self {
        self.other_assembly = true;
        self
    }

    /// The position of a joint that follows none; a mimic's is filled in by the pose.
    ///
    /// # Panics
    /// A joint of another mechanism.
    pub fn get(&self, joint: JointId) -> &[f64] {
        assert!(self.mechanism.has_joint(joint), "joint number {} is of another mechanism", joint.index());
        &self.values[joint.index()]
    }
}

/// The values as a position of the joint, or why they are none.
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
