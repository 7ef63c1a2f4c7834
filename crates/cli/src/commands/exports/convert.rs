//! Command `percuss convert`.

use crate::args::{ConvertArgs, ModelFormat};
use crate::files::output::{check_writable, record_input, write_file};
use crate::files::own_files::append_hash;
use crate::terminal::failure::Failure;
use crate::terminal::report::{write_diagnostics, write_out, write_unescaped};
use percuss_formats::{Comments, ModelText, write_mjcf, write_sdf, write_urdf_with};
use percuss_mechanism::{Mechanism, Severity};
use percuss_study::DiagnosticRecord;

/// Runs the command.
pub fn run(args: &ConvertArgs) -> Result<(), Failure> {
    args.writing.apply();
    let format = args.format()?;
    if args.output != "-" {
        check_writable(&args.output)?;
    }
    let model = args.model.load()?;
    model.inputs.iter().for_each(|input| record_input(&input.path));
    write_diagnostics(&model.diagnostics, args.model.reading.strict)?;
    // The mark by which percuss recognises its own files.
    let heading = format!("imported by percuss from {}", args.model.model);
    let (text, notes) = write_model(&model.mechanism, format, &heading)?;
    let notes: Vec<DiagnosticRecord> = notes.into_iter().map(note).collect();
    write_diagnostics(&notes, false)?;
    let text = append_hash(text);
    if args.output == "-" {
        return write_unescaped(text.as_bytes());
    }
    write_file(&args.output, text.as_bytes())?;
    let mechanism = &model.mechanism;
    write_out(&format!(
        "{}: {} links, {} joints, {} loops\n",
        args.output,
        mechanism.links().len(),
        mechanism.joints().len(),
        mechanism.closures().len() + mechanism.couplings().len()
    ))
}

/// Text of the model with a comment at its head, and notes about parts that have another form.
fn write_model(
    mechanism: &Mechanism,
    format: ModelFormat,
    heading: &str,
) -> Result<(String, Vec<String>), Failure> {
    match format {
        ModelFormat::Mjcf => {
            let ModelText { text, notes } = write_mjcf(mechanism, heading).map_err(|error| {
                Failure::bad_input(format!("the model cannot be written as MJCF: {error}"))
            })?;
            Ok((text, notes))
        }
        ModelFormat::Sdf => {
            let ModelText { text, notes } = write_sdf(mechanism, heading).map_err(|error| {
                Failure::bad_input(format!("the model cannot be written as SDFormat: {error}"))
            })?;
            Ok((text, notes))
        }
        ModelFormat::Urdf => {
            let comments = Comments { heading: vec![heading.to_owned()], ..Comments::default() };
            Ok((write_urdf_with(mechanism, &comments), Vec::new()))
        }
    }
}

/// Note on a conversion, without a position in a file.
pub(super) fn note(message: String) -> DiagnosticRecord {
    DiagnosticRecord {
        severity: Severity::Note,
        code: "converted",
        path: None,
        line: None,
        column: None,
        element: None,
        message,
    }
}
