//! Generated source code of the effective mass at a contact.

use crate::evaluation::prepared_question::PreparedQuestion;
use crate::model::loading::Model;
use crate::question::errors::question_error::StudyError;
use crate::question::field::Field;
use crate::question::mass_question::MassQuestion;
use nalgebra::Vector3;
use percuss_generate::{Additions, GenerateError, Generated, HeldPoint, Language, Request, generate};

/// Error of generated code.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CodeError {
    /// Invalid question, or no pose.
    #[error(transparent)]
    Question(#[from] StudyError),
    /// The function cannot be generated.
    #[error(transparent)]
    Generate(#[from] GenerateError),
}

/// Generates the source code of a function from a configuration to m̄. `name`: prefix of the names in the code, a C
/// identifier. The pose of the question is the design pose.
///
/// # Errors
/// [`CodeError`]: an invalid question, or a mechanism or contact for which no code is generated.
pub fn generate_code(
    model: &Model,
    question: &MassQuestion,
    name: &str,
    language: Language,
    additions: Additions,
) -> Result<Generated, CodeError> {
    let prepared = PreparedQuestion::new(model, question)?;
    let pose = prepared.pose()?;
    let contact = prepared.contact_at(&pose);
    let mechanism = &model.mechanism;
    let mut armatures = Vec::new();
    for (joint, values) in &question.armature {
        let id = mechanism.find_joint(joint).map_err(|error| StudyError::input(Field::Armature, error))?;
        armatures.push((id, values.clone()));
    }
    let mut holds = Vec::new();
    for hold in &question.hold {
        let link = mechanism.find_link(&hold.link).map_err(|error| StudyError::input(Field::Hold, error))?;
        holds.push(HeldPoint { link, point: hold.point.into(), normal: hold.normal.map(Vector3::from) });
    }
    let request = Request {
        pose,
        contact,
        wheel: prepared.wheel().copied(),
        other_mass: prepared.other_mass(),
        armatures,
        holds,
        name: name.to_owned(),
        origin: model.inputs.iter().map(|input| format!("file         {}", input.path)).collect(),
        model_hash: model.inputs.first().map(|input| input.sha256.clone()).unwrap_or_default(),
        language,
        additions,
        system: prepared.system.clone(),
    };
    Ok(generate(&request)?)
}
