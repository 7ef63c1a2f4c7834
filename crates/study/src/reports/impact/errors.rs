//! Errors of impacts, with the part of the question at fault.

use crate::question::errors::question_error::StudyError;
use crate::question::field::Field;
use crate::question::tables::impact::ImpactQuestion;
use percuss_impact::ImpactError;

/// Error of an impact, about the part of the question at fault.
pub(crate) fn impact_error(error: ImpactError, impact: &ImpactQuestion) -> StudyError {
    match error {
        ImpactError::Friction { .. } => StudyError::input(Field::Friction, error),
        ImpactError::NoEnd { .. } if impact.friction.is_some() => {
            StudyError::input(Field::RestitutionLaw, error)
        }
        ImpactError::Restitution { .. } => StudyError::input(Field::Restitution, error),
        ImpactError::ClosingSpeed { .. } if impact.speed.is_some() => {
            StudyError::input(Field::ClosingSpeed, error)
        }
        ImpactError::Spring { .. } | ImpactError::SpringJoint { .. } => {
            StudyError::input(Field::JointSpring, error)
        }
        _ => StudyError::NoImpact(error),
    }
}
