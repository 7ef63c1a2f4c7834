//! Generated source code of the effective mass at a contact.

use crate::evaluation::named_contact::findings_at_touch;
use crate::evaluation::prepared_question::PreparedQuestion;
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::exports::{CodeQuestion, LanguageName};
use nalgebra::Vector3;
use percuss_generate::{GenerateError, GeneratedFile, HeldPoint, Request, generate};
use schemars::JsonSchema;
use serde::Serialize;

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

/// Generated source code.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CodeReport {
    /// `percuss.generate/1`.
    #[schemars(extend("const" = "percuss.generate/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files.
    pub inputs: Vec<Input>,
    /// Language.
    pub language: LanguageName,
    /// Prefix of all names in the code.
    pub name: String,
    /// Number of positions.
    pub positions: usize,
    /// Number of arithmetic operations of one configuration, without sines and cosines.
    pub operations: usize,
    /// Number of pairs of sine and cosine.
    pub angles: usize,
    /// Number of reference values in the self-test.
    pub references: usize,
    /// Files: header, source and self-test, or one Rust file.
    pub files: Vec<TextFile>,
    /// Findings about the file of the model.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// File as text.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct TextFile {
    /// Name of the file.
    pub name: String,
    /// Content of the file.
    pub text: String,
}

/// Generates the source code of a function from a configuration to m̄. The pose of the question is the design pose.
///
/// # Errors
/// [`CodeError`]: an invalid question, or a mechanism or contact for which no code is generated.
pub fn generate_code(
    model: &Model,
    question: &MassQuestion,
    asked: &CodeQuestion,
) -> Result<CodeReport, CodeError> {
    let prepared = PreparedQuestion::new(model, question)?;
    let pose = prepared.pose()?;
    let contact = prepared.contact_at(&pose);
    let mechanism = &model.mechanism;
    let mut armatures = Vec::new();
    for (joint, values) in &question.conditions.armature {
        let id = mechanism.find_joint(joint).map_err(StudyError::about("conditions.armature"))?;
        armatures.push((id, values.clone()));
    }
    let mut holds = Vec::new();
    for hold in &question.hold {
        let link = mechanism.find_link(&hold.link).map_err(StudyError::about("hold"))?;
        holds.push(HeldPoint { link, point: hold.point.into(), normal: hold.normal.map(Vector3::from) });
    }
    let request = Request {
        pose,
        contact,
        wheel: prepared.wheel().copied(),
        other_mass: prepared.other_mass(),
        armatures,
        holds,
        name: asked.identifier(model),
        origin: model.inputs.iter().map(|input| format!("file         {}", input.path)).collect(),
        model_hash: model.inputs.first().map(|input| input.sha256.clone()).unwrap_or_default(),
        language: asked.language.into(),
        additions: asked.additions(),
        system: prepared.system.clone(),
    };
    let of_pose = prepared.start_findings(&request.pose, &request.contact);
    let of_pose = of_pose
        .into_iter()
        .chain(findings_at_touch(model, question))
        .map(DiagnosticRecord::from)
        .collect::<Vec<_>>();
    let generated = generate(&request)?;
    let file = |file: GeneratedFile| TextFile { name: file.name, text: file.text };
    Ok(CodeReport {
        schema: "percuss.generate/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: model.inputs.clone(),
        language: asked.language,
        name: request.name,
        positions: generated.positions,
        operations: generated.operations,
        angles: generated.angles,
        references: generated.references,
        files: generated.files.into_iter().map(file).collect(),
        diagnostics: model.diagnostics.iter().cloned().chain(of_pose).collect(),
    })
}
