//! Errors of impacts, with the part of the question at fault.

use crate::question::errors::question_error::StudyError;
use crate::question::tables::impact::ImpactQuestion;
use percuss_impact::ImpactError;

/// Error of an impact, about the part of the question at fault.
pub(crate) fn impact_error(error: ImpactError, impact: &ImpactQuestion) -> StudyError {
    match error {
        ImpactError::Friction { .. } => StudyError::input("impact.friction", error),
        ImpactError::NoEnd { .. } if impact.friction.is_some() => {
            StudyError::input("impact.restitution_law", error)
        }
        ImpactError::Restitution { .. } => StudyError::input("impact.restitution", error),
        ImpactError::ClosingSpeed { .. } if impact.speed.is_some() => {
            StudyError::input("impact.speed", error)
        }
        ImpactError::Spring { .. } | ImpactError::SpringJoint { .. } => {
            StudyError::input("impact.joint_spring", error)
        }
        _ => StudyError::NoImpact(error),
    }
}
