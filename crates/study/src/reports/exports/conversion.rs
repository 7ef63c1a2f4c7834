//! Report of a conversion: everything that changes or is lost between a model file and a written file.

use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::question::tables::exports::{ConversionQuestion, ModelFormat};
use crate::reports::exports::balanced::balanced;
use crate::reports::exports::change_record::ChangeRecord;
use crate::reports::exports::code::TextFile;
use crate::reports::exports::mesh_names::MeshNames;
use crate::reports::exports::named_states::named_states;
use percuss_formats::{Change, Effect, ModelParts, write_mjcf, write_sdf, write_urdf_model};
use schemars::JsonSchema;
use serde::Serialize;

/// Report of `percuss convert`, as JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ConversionReport {
    /// `percuss.convert/1`.
    #[schemars(extend("const" = "percuss.convert/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files.
    pub inputs: Vec<Input>,
    /// Written file, or the name of the file in `files`.
    pub output: String,
    /// Format of the written file: `mjcf`, `sdf` or `urdf`.
    pub format: &'static str,
    /// Number of links.
    pub links: usize,
    /// Number of joints.
    pub joints: usize,
    /// Number of loops.
    pub loops: usize,
    /// Number of couplings and relations.
    pub couplings: usize,
    /// Number of named contacts.
    pub contacts: usize,
    /// Everything that changes or is lost.
    pub changes: Vec<ChangeRecord>,
    /// Least and largest relative change of the effective mass of a contact at the drawn pose by balanced moments of inertia; null without them, and
    /// without a bound.
    pub mass_change: Option<[f64; 2]>,
    /// Other findings about the file.
    pub diagnostics: Vec<DiagnosticRecord>,
    /// The model as text; absent if it is written to a file.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub files: Vec<TextFile>,
}

/// Changes by the reader and by the writer, and the other findings about the file.
pub(super) fn changes(model: &Model, written: Vec<Change>) -> (Vec<ChangeRecord>, Vec<DiagnosticRecord>) {
    let unread = &model.origin.unread;
    let diagnostics = model.diagnostics.iter().filter(|finding| !unread.contains(finding)).cloned();
    let of_reader = unread.iter().cloned().map(|finding| ChangeRecord {
        effect: Effect::Lost.name(),
        element: finding.element.unwrap_or_default(),
        path: finding.path,
        line: finding.line,
        what: finding.message,
        reason: "no part of a mechanism".to_owned(),
    });
    let forces = model.has_sheet().then(|| ChangeRecord {
        effect: Effect::Lost.name(),
        element: "the sheet".to_owned(),
        path: None,
        line: None,
        what: "springs, dampers, and data of the wheels and the vehicle".to_owned(),
        reason: "no part of a mechanism".to_owned(),
    });
    let changes = of_reader.chain(forces).chain(written.into_iter().map(Into::into));
    (changes.collect(), diagnostics.collect())
}

/// Error of a conversion: the format has no form of a part of the model.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the model cannot be written as {format}: {reason}")]
pub struct ConversionError {
    /// Name of the format.
    pub format: &'static str,
    /// Part and reason.
    pub reason: String,
}

/// Writes a model in another format, with its named poses, and lists everything changed or lost.
///
/// # Errors
/// [`ConversionError`]: a part of the mechanism without a form in the format.
pub fn convert(model: &Model, asked: &ConversionQuestion) -> Result<ConversionReport, ConversionError> {
    let balanced = asked.balance_inertia.then(|| balanced(model));
    let model = balanced.as_ref().map_or(model, |balanced| &balanced.model);
    let (format, output) = asked.file();
    let (poses, lost) = named_states(model);
    let meshes = MeshNames::new(model, &output, format);
    let find_mesh = |name: &str| meshes.find(name);
    let parts = ModelParts {
        mechanism: &model.mechanism,
        shapes: &model.shapes,
        find_mesh: &find_mesh,
        poses: &poses,
    };
    let heading = heading(model);
    let mut written = match format {
        ModelFormat::Mjcf => write_mjcf(parts, &heading)
            .map_err(|error| ConversionError { format: "MJCF", reason: error.to_string() })?,
        ModelFormat::Sdf => write_sdf(parts, &heading)
            .map_err(|error| ConversionError { format: "SDFormat", reason: error.to_string() })?,
        ModelFormat::Urdf => write_urdf_model(parts, &heading),
    };
    written.changes.extend(lost);
    let (mut changes, diagnostics) = changes(model, written.changes);
    let mass_change = balanced.as_ref().and_then(|balanced| balanced.mass_change);
    changes.extend(balanced.iter().flat_map(|balanced| balanced.changes.iter().cloned()));
    let mechanism = &model.mechanism;
    Ok(ConversionReport {
        schema: "percuss.convert/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: model.inputs.clone(),
        files: vec![TextFile { name: output.clone(), text: written.text }],
        output,
        format: format.name(),
        links: mechanism.links().len(),
        joints: mechanism.joints().len(),
        loops: mechanism.closures().len(),
        couplings: mechanism.couplings().len(),
        contacts: mechanism.contacts().len(),
        changes,
        mass_change,
        diagnostics,
    })
}

/// Comment at the head of a written model, by which the command recognises its own files.
pub(super) fn heading(model: &Model) -> String {
    let source = model.inputs.first().map_or_else(|| model.mechanism.name(), |input| &input.path);
    format!("imported by percuss from {source}")
}
