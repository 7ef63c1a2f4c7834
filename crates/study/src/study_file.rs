//! A study in a file: the flags of `percuss mass` and `percuss sweep`, kept.

use crate::closure_text::ClosureText;
use crate::compare::Design;
use crate::damping_question::DampingQuestion;
use crate::design::DesignError;
use crate::field::Names;
use crate::model::{Input, Model, Origin};
use crate::question::MassQuestion;
use crate::record::DiagnosticRecord;
use crate::refusal::Refusal;
use crate::row_source::RowSource;
use crate::sheet::is_study;
use crate::study_text::{DampingText, ModelText, StudyText, SweepText};
use crate::variant::{Variant, changes};
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
    /// The same with something changed.
    pub variants: Vec<Variant>,
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
        let options = LoadOptions { accept };
        let mut model = Model::load(&model_path.to_string_lossy(), max_size, &options)?;
        model.inputs.push(Input::of(&source));
        let of_model = |error: DesignError| refused_design(&path, "", error);
        let ModelText { link_mass, link_com, moves, .. } = &study.model;
        model = model.changed(&changes(link_mass, link_com, moves)).map_err(of_model)?;
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
        let question = study.question(folder, max_size).map_err(refused)?;
        let mut variants: Vec<Variant> = Vec::new();
        for text in &study.variant {
            if variants.iter().any(|variant| variant.name == text.name) {
                return Err(value("variant.name", format!("\"{}\" is given twice", text.name)));
            }
            let variant = text.variant(&model, &question, folder, max_size, &options);
            variants.push(variant.map_err(|error| refused_design(&path, &text.name, error))?);
        }
        let damping = study.damping.as_ref().map(DampingText::question).transpose().map_err(refused)?;
        let source = |sweep: &SweepText| sweep.source(folder, max_size);
        let sweep = study.sweep.as_ref().map(source).transpose().map_err(refused)?;
        let output =
            study.sweep.and_then(|s| s.output).map(|o| folder.join(o).to_string_lossy().into_owned());
        Ok(Self { model, question, variants, damping, sweep, output, folder: folder.to_owned() })
    }

    /// Whether a file is a study: TOML with a table `model`.
    pub fn is_study(path: &str, max_size: u64) -> bool {
        Source::read(path, max_size).is_ok_and(|source| is_study(&source))
    }

    /// The designs of the study: its model under a name, then its variants.
    pub fn designs(&self, name: &str) -> Vec<Design> {
        let rows = &self.sweep;
        let design = |name: String, model: &Model, question: &MassQuestion| Design {
            name,
            model: model.clone(),
            question: question.clone(),
            rows: rows.clone(),
        };
        let own = design(name.to_owned(), &self.model, &self.question);
        let variants = self.variants.iter().map(|v| design(v.name.clone(), &v.model, &v.question));
        [own].into_iter().chain(variants).collect()
    }
}

/// A design that cannot be had, with the name of the variant.
fn refused_design(path: &str, variant: &str, error: DesignError) -> StudyFileError {
    let (key, of) = match variant {
        "" => ("model", String::new()),
        name => ("variant", format!("\"{name}\": ")),
    };
    let why = match error {
        DesignError::Load(error) => error.to_string(),
        DesignError::Change(error) => error.message(Names::Keys).replace("model.", ""),
    };
    StudyFileError::Value { path: path.to_owned(), key, why: format!("{of}{why}") }
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
    let added = closures.clone();
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
    let origin = Origin { closures: added, ..model.origin };
    Ok(Model { mechanism: std::sync::Arc::new(built.mechanism), diagnostics, origin, ..model })
}
