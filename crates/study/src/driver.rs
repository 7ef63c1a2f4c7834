//! The joint that a sweep moves.

use crate::error::StudyError;
use crate::field::Field;
use percuss_dynamics::{Configuration, Pose, System};
use percuss_mechanism::{JointId, JointKind};

/// A joint that is driven, and where the others are wanted.
#[derive(Debug)]
pub(crate) struct Driver {
    pub joint: JointId,
    pub base: Configuration,
}

impl Driver {
    pub fn kind(&self) -> JointKind {
        self.base.mechanism().joint(self.joint).kind()
    }

    pub fn name(&self) -> &str {
        self.base.mechanism().joint(self.joint).name()
    }

    /// The pose with this joint at a value, followed from another pose where there is one.
    pub fn pose(&self, system: &System, from: Option<&Pose>, value: f64) -> Result<Pose, StudyError> {
        let mut configuration = self.base.clone();
        configuration.set(self.name(), &[value]).map_err(|error| StudyError::input(Field::Vary, error))?;
        Ok(match from {
            Some(from) => system.pose_from(from, &configuration.without_guesses())?,
            None => system.pose(&configuration)?,
        })
    }
}
