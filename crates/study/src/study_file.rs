//! A study in a file: the flags of `percuss mass` and `percuss sweep`, kept.

use crate::closure_text::ClosureText;
use crate::damping_question::DampingQuestion;
use crate::model::{Input, Model};
use crate::question::MassQuestion;
use crate::record::DiagnosticRecord;
use crate::refusal::Refusal;
use crate::row_source::RowSource;
use crate::study_text::{DampingText, StudyText, SweepText};
use percuss_formats::{LoadError, LoadOptions, Source};
use percuss_mechanism::{Accept, BuildError, ClosureDescription, ClosureKind, Severity, Subject};
use std::path::{Path, PathBuf};

/// A study, read but not yet run.
#[derive(Clone, Debug)]
pub struct StudyFile {
    /// The model with the study's closures.
    pub model: Model,
    /// The contact and the conditions.
    pub question: MassQuestion,
    /// The damper to give, if a restitution is asked for.
    pub damping: Option<DampingQuestion>,
    /// The rows to go through, if any.
    pub sweep: Option<RowSource>,
    /// Where the sweep's rows go, relative to the study file; none: stdout.
    pub output: Option<String>,
    /// The study's folder: what its paths are relative to.
    pub folder: PathBuf,
}

/// A study that cannot be run.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudyFileError {
    /// The study, or the model it names, cannot be read.
    #[error(transparent)]
    Load(#[from] LoadError),
    /// It is not UTF-8 text.
    #[error("{path}: error: not UTF-8 text; a study is a TOML file")]
    NotText {
        /// The file.
        path: String,
    },
    /// It is no TOML, or has keys that mean nothing; the message has the place.
    #[error("{path}: error: {message}")]
    Toml {
        /// The file.
        path: String,
        /// What and where.
        message: String,
    },
    /// A value that cannot be.
    #[error("{path}: error: {key}: {why}")]
    Value {
        /// The file.
        path: String,
        /// The key.
        key: &'static str,
        /// What is wrong.
        why: String,
    },
    /// The model with the study's closures is none.
    #[error("{path}: error: {source}")]
    Build {
        /// The file.
        path: String,
        /// What the builder found.
        source: BuildError,
    },
}

impl StudyFile {
    /// Reads a study and the model it names (relative to the study's folder). At most `max_size` bytes each.
    ///
    /// # Errors
    /// [`StudyFileError`]: files that cannot be read, keys that mean nothing, values that cannot be.
    pub fn load(path: &str, max_size: u64) -> Result<Self, StudyFileError> {
        let source = Source::read(path, max_size)?;
        let path = source.name.clone();
        let text = String::from_utf8(source.bytes.clone())
            .map_err(|_| StudyFileError::NotText { path: path.clone() })?;
        let study: StudyText = toml::from_str(&text).map_err(|e| StudyFileError::Toml {
            path: path.clone(),
            message: e.to_string().trim().to_owned(),
        })?;
        let value = |key: &'static str, why: String| StudyFileError::Value { path: path.clone(), key, why };
        let refused = |refusal: Refusal| value(refusal.key, refusal.why);
        let mut accept = Accept::default();
        for word in &study.model.accept {
            match word.as_str() {
                "indefinite-inertia" => accept.indefinite_inertia = true,
                _ => {
                    return Err(value(
                        "model.accept",
                        format!("\"{word}\"; known is \"indefinite-inertia\""),
                    ));
                }
            }
        }
        let folder = Path::new(&path).parent().unwrap_or(Path::new(""));
        let model_path = folder.join(&study.model.path);
        let mut model = Model::load(&model_path.to_string_lossy(), max_size, &LoadOptions { accept })?;
        model.inputs.push(Input::of(&source));
        if !study.closure.is_empty() {
            let closures = study
                .closure
                .iter()
                .map(ClosureText::describe)
                .collect::<Result<Vec<_>, _>>()
                .map_err(refused)?;
            model = with_closures(model, &path, closures)
                .map_err(|source| StudyFileError::Build { path: path.clone(), source })?;
        }
        let question = study.question().map_err(refused)?;
        let damping = study.damping.as_ref().map(DampingText::question).transpose().map_err(refused)?;
        let source = |sweep: &SweepText| sweep.source(folder, max_size);
        let sweep = study.sweep.as_ref().map(source).transpose().map_err(refused)?;
        let output =
            study.sweep.and_then(|s| s.output).map(|o| folder.join(o).to_string_lossy().into_owned());
        Ok(Self { model, question, damping, sweep, output, folder: folder.to_owned() })
    }
}

/// The model with more closures than its file has, and the findings about them.
fn with_closures(model: Model, path: &str, closures: Vec<ClosureDescription>) -> Result<Model, BuildError> {
    let of_file = model.mechanism.closures().len();
    let mut diagnostics = model.diagnostics;
    for closure in closures.iter().filter(|c| c.kind == ClosureKind::Distance && c.distance.is_none()) {
        let message =
            format!("loop \"{}\" has no distance: the distance with all joints at 0 is taken", closure.name);
        let record = DiagnosticRecord::about_answer(Severity::Note, "default-distance", message);
        diagnostics.push(DiagnosticRecord { path: Some(path.to_owned()), ..record });
    }
    // Nothing in the file bound these; the study's closures may.
    diagnostics.retain(|d| d.code != "unbound-joint");
    let builder = closures.into_iter().fold(model.mechanism.to_builder(), |b, closure| b.closure(closure));
    let built = builder.build()?;
    // What the builder finds about the rest was reported with its place when the file was read.
    for (subject, problem) in built.findings {
        if matches!(subject, Subject::Closure { index, .. } if index >= of_file) {
            let message = format!("{subject}: {problem}");
            let record = DiagnosticRecord::about_answer(problem.severity(), problem.code(), message);
            diagnostics.push(DiagnosticRecord { path: Some(path.to_owned()), ..record });
        }
    }
    Ok(Model { mechanism: std::sync::Arc::new(built.mechanism), diagnostics, ..model })
}
