//! Report of a conversion: everything that changes or is lost between a model file and a written file.

use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use percuss_formats::{Change, Effect, NOT_READ};
use percuss_mechanism::Severity;
use schemars::JsonSchema;
use serde::Serialize;

/// Codes of the warnings and notes about parts of a file that are not read.
const UNREAD: [&str; 5] = [NOT_READ, "ignored", "unknown-element", "unknown-attribute", "stray-text"];

/// Part of a model that has another form in the written file, or none.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ChangeRecord {
    /// `changed` or `lost`.
    pub effect: &'static str,
    /// The part: a link, joint, loop, coupling or contact with its name, or an element of the file as an XML path.
    pub element: String,
    /// File of the element; null for a part of the mechanism.
    pub path: Option<String>,
    /// Line of the element, from 1.
    pub line: Option<u32>,
    /// Form in the written file, or what is lost.
    pub what: String,
    /// Reason.
    pub reason: String,
}

impl ChangeRecord {
    /// `file:line: element: what (reason)`, without the effect.
    pub fn text(&self) -> String {
        let place = match (&self.path, self.line) {
            (Some(path), Some(line)) => format!("{path}:{line}: "),
            (Some(path), None) => format!("{path}: "),
            (None, _) => String::new(),
        };
        format!("{place}{}: {} ({})", self.element, self.what, self.reason)
    }
}

impl From<Change> for ChangeRecord {
    fn from(change: Change) -> Self {
        let Change { effect, element, what, reason } = change;
        Self { effect: effect.name(), element, path: None, line: None, what, reason }
    }
}

/// Report of `percuss convert`, as JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ConversionReport {
    /// `percuss.convert/1`.
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files.
    pub inputs: Vec<Input>,
    /// Written file.
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
    /// Other findings about the file.
    pub diagnostics: Vec<DiagnosticRecord>,
}

impl ConversionReport {
    /// Report about a model that was read with [`LoadOptions::list_unread`](percuss_formats::LoadOptions::list_unread), and the changes
    /// of the writer.
    pub fn new(model: &Model, written: Vec<Change>, format: &'static str, output: &str) -> Self {
        let (changes, diagnostics) = changes(model, written);
        let mechanism = &model.mechanism;
        Self {
            schema: "percuss.convert/1",
            percuss: env!("CARGO_PKG_VERSION"),
            inputs: model.inputs.clone(),
            output: output.to_owned(),
            format,
            links: mechanism.links().len(),
            joints: mechanism.joints().len(),
            loops: mechanism.closures().len(),
            couplings: mechanism.couplings().len(),
            contacts: mechanism.contacts().len(),
            changes,
            diagnostics,
        }
    }
}

/// Changes by the reader and by the writer, and the other findings about the file.
pub fn changes(model: &Model, written: Vec<Change>) -> (Vec<ChangeRecord>, Vec<DiagnosticRecord>) {
    let is_unread =
        |finding: &DiagnosticRecord| finding.severity != Severity::Error && UNREAD.contains(&finding.code);
    let (unread, diagnostics): (Vec<_>, Vec<_>) = model.diagnostics.iter().cloned().partition(is_unread);
    let of_reader = unread.into_iter().map(|finding| ChangeRecord {
        effect: Effect::Lost.name(),
        element: finding.element.unwrap_or_default(),
        path: finding.path,
        line: finding.line,
        what: finding.message,
        reason: "no part of a mechanism".to_owned(),
    });
    let lost = |element: String, what: String, reason: &str| ChangeRecord {
        effect: Effect::Lost.name(),
        element,
        path: None,
        line: None,
        what,
        reason: reason.to_owned(),
    };
    let forces = model.has_sheet().then(|| {
        let what = "springs, dampers, and data of the wheels and the vehicle".to_owned();
        lost("the sheet".to_owned(), what, "no part of a mechanism")
    });
    let changes = of_reader.chain(forces).chain(written.into_iter().map(Into::into));
    (changes.collect(), diagnostics)
}
