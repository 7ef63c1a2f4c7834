//! Command `percuss convert`.

use crate::args::{CheckFormat, ConvertArgs, ModelArgs};
use crate::files::output::{check_writable, record_input, write_file};
use crate::files::own_files::append_hash;
use crate::terminal::escape::line;
use crate::terminal::failure::Failure;
use crate::terminal::report::{write_diagnostics, write_json, write_text, write_unescaped};
use crate::terminal::wrap::fact_line;
use percuss_mechanism::Severity;
use percuss_study::{
    ChangeRecord, ConversionError, ConversionQuestion, ConversionReport, DiagnosticRecord, Model,
    convert as convert_model,
};
use std::path::Path;

/// Runs the command.
pub fn run(args: &ConvertArgs) -> Result<(), Failure> {
    args.writing.apply();
    convert(&args.model, &args.conversion.checked(Path::new(""))?, args.format)
}

/// Converts a model, and prints the report of the changes in `report_format`.
pub(super) fn convert(
    model_args: &ModelArgs,
    asked: &ConversionQuestion,
    report_format: CheckFormat,
) -> Result<(), Failure> {
    let output = asked.output.as_deref().unwrap_or_default();
    let to_stdout = output == "-";
    if to_stdout && report_format == CheckFormat::Json {
        return Err(Failure::bad_input(
            "--format json: the report and the model (--output -) would both go to the standard output; write the model to a file",
        ));
    }
    if !to_stdout {
        check_writable(output)?;
    }
    let model = model_args.load()?;
    model.inputs.iter().for_each(|input| record_input(&input.path));
    let strict = model_args.reading.strict;
    refuse_warnings(&model, strict)?;
    let mut report = convert_model(&model, asked)?;
    write_diagnostics(&report.diagnostics, strict)?;
    if to_stdout {
        let notes: Vec<DiagnosticRecord> = report.changes.iter().map(note).collect();
        write_diagnostics(&notes, false)?;
        return report
            .files
            .into_iter()
            .try_for_each(|file| write_unescaped(append_hash(file.text).as_bytes()));
    }
    write_files(&mut report)?;
    match report_format {
        CheckFormat::Json => write_json(&report),
        CheckFormat::Text => write_text(&summary(&report)),
    }
}

/// Writes the file of a report, which then has no text.
pub fn write_files(report: &mut ConversionReport) -> Result<(), Failure> {
    let mut files = std::mem::take(&mut report.files).into_iter();
    files.try_for_each(|file| write_file(&file.name, append_hash(file.text).as_bytes()))
}

/// Refuses a model with warnings under `strict`, including the warnings about parts that are not read.
pub(super) fn refuse_warnings(model: &Model, strict: bool) -> Result<(), Failure> {
    match strict {
        true => write_diagnostics(&model.diagnostics, true),
        false => Ok(()),
    }
}

/// Size of the model, and its changes.
pub fn summary(report: &ConversionReport) -> String {
    let mut out = format!(
        "{}: {} links, {} joints, {} loops\n",
        line(&report.output),
        report.links,
        report.joints,
        report.loops + report.couplings
    );
    out += &change_lines(&report.changes);
    out
}

/// A line for each change.
pub(super) fn change_lines(changes: &[ChangeRecord]) -> String {
    changes.iter().map(|change| fact_line(change.effect, &line(&change.text()))).collect()
}

/// Change as a note on the standard error, if the model is written to the standard output.
fn note(change: &ChangeRecord) -> DiagnosticRecord {
    DiagnosticRecord {
        severity: Severity::Note,
        code: "converted",
        path: change.path.clone(),
        line: change.line,
        column: None,
        element: Some(change.element.clone()),
        message: format!("{}: {} ({})", change.effect, change.what, change.reason),
    }
}

impl From<ConversionError> for Failure {
    fn from(error: ConversionError) -> Self {
        Failure::bad_input(error.to_string())
    }
}
