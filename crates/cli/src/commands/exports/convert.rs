//! Command `percuss convert`.

use super::mesh_names::MeshNames;
use crate::args::{CheckFormat, ConvertArgs, ModelArgs, ModelFormat};
use crate::files::output::{check_writable, record_input, write_file};
use crate::files::own_files::append_hash;
use crate::terminal::escape::line;
use crate::terminal::failure::Failure;
use crate::terminal::report::{write_diagnostics, write_json, write_text, write_unescaped};
use crate::terminal::wrap::fact_line;
use percuss_formats::{ModelParts, ModelText, write_mjcf, write_sdf, write_urdf_model};
use percuss_mechanism::Severity;
use percuss_study::{ChangeRecord, ConversionReport, DiagnosticRecord, Model, named_states};

/// Runs the command.
pub fn run(args: &ConvertArgs) -> Result<(), Failure> {
    args.writing.apply();
    let format = ModelFormat::of_output(args.to, &args.output)?;
    if args.balance_inertia && format != ModelFormat::Mjcf {
        return Err(Failure::bad_input(format!(
            "--balance-inertia: only MJCF refuses moments with A + B < C, and the output is {}; leave the flag out",
            format.name()
        )));
    }
    convert(&args.model, (format, args.balance_inertia), &args.output, args.format)
}

/// Converts a model to a format, with balanced inertias or without, and prints the report of the changes in `report_format`.
pub(super) fn convert(
    model_args: &ModelArgs,
    (format, balances_inertia): (ModelFormat, bool),
    output: &str,
    report_format: CheckFormat,
) -> Result<(), Failure> {
    let to_stdout = output == "-";
    if to_stdout && report_format == CheckFormat::Json {
        return Err(Failure::bad_input(
            "--format json: the report and the model (--output -) would both go to the standard output; write the model to a file",
        ));
    }
    if !to_stdout {
        check_writable(output)?;
    }
    let model = model_args.load_for_conversion()?;
    model.inputs.iter().for_each(|input| record_input(&input.path));
    refuse_warnings(&model, model_args.reading.strict)?;
    // The mark by which percuss recognises its own files.
    let heading = format!("imported by percuss from {}", model_args.model);
    let meshes = MeshNames::new(&model_args.model, output, format);
    let ModelText { text, changes } = write_model(&model, (format, balances_inertia), &meshes, &heading)?;
    let report = ConversionReport::new(&model, changes, format.name(), output);
    write_diagnostics(&report.diagnostics, model_args.reading.strict)?;
    let text = append_hash(text);
    if to_stdout {
        let notes: Vec<DiagnosticRecord> = report.changes.iter().map(note).collect();
        write_diagnostics(&notes, false)?;
        return write_unescaped(text.as_bytes());
    }
    write_file(output, text.as_bytes())?;
    match report_format {
        CheckFormat::Json => write_json(&report),
        CheckFormat::Text => write_text(&summary(&report)),
    }
}

/// Refuses a model with warnings under `strict`, including the warnings about parts that are not read.
pub(super) fn refuse_warnings(model: &Model, strict: bool) -> Result<(), Failure> {
    match strict {
        true => write_diagnostics(&model.diagnostics, true),
        false => Ok(()),
    }
}

/// Text of the written model, which starts with the comment `heading`, and everything changed or lost.
fn write_model(
    model: &Model,
    (format, balances_inertia): (ModelFormat, bool),
    meshes: &MeshNames,
    heading: &str,
) -> Result<ModelText, Failure> {
    let (poses, lost) = named_states(model);
    let find_mesh = |name: &str| meshes.find(name);
    let parts = ModelParts {
        mechanism: &model.mechanism,
        shapes: &model.shapes,
        find_mesh: &find_mesh,
        poses: &poses,
        balances_inertia,
    };
    let refuse = |format: &str, error: String| {
        Failure::bad_input(format!("the model cannot be written as {format}: {error}"))
    };
    let mut written = match format {
        ModelFormat::Mjcf => write_mjcf(parts, heading).map_err(|error| refuse("MJCF", error.to_string()))?,
        ModelFormat::Sdf => {
            write_sdf(parts, heading).map_err(|error| refuse("SDFormat", error.to_string()))?
        }
        ModelFormat::Urdf => write_urdf_model(parts, heading),
    };
    written.changes.extend(lost);
    Ok(written)
}

/// Size of the model, and its changes.
fn summary(report: &ConversionReport) -> String {
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
