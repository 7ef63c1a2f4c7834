//! Errors of the kinematics of a suspension.

use crate::checks::design_variant::DesignError;
use crate::question::errors::question_error::StudyError;
use percuss_suspension::kinematics::{MissingWheel, MotionError};

/// Error of a question about kinematics.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum KinematicsError {
    /// Model without a suspension sheet.
    #[error(
        "\"{path}\" is no suspension sheet: the kinematics of a suspension need its sheet, table or JSON file, in which the \
         parts are named"
    )]
    NoSheet {
        /// Path of the model.
        path: String,
    },
    /// Sheet without a wheel that the kinematics can follow.
    #[error(transparent)]
    NoWheel(#[from] MissingWheel),
    /// Joint without a definition of its rates.
    #[error(transparent)]
    Unsupported(#[from] MotionError),
    /// Search that cannot start.
    #[error("{why}")]
    Search {
        /// Reason.
        why: String,
    },
    /// Steering of a suspension without a rack.
    #[error("the suspension has no tie rod, so there is no rack to move (--steer)")]
    NoRack,
    /// Error of a pose.
    #[error(transparent)]
    Study(#[from] StudyError),
    /// Error of a changed design.
    #[error(transparent)]
    Design(#[from] Box<DesignError>),
}

impl From<DesignError> for KinematicsError {
    fn from(error: DesignError) -> Self {
        KinematicsError::Design(Box::new(error))
    }
}
