//! Command `percuss export`.

use super::convert::{change_lines, convert, refuse_warnings};
use crate::args::{CheckFormat, ExportArgs};
use crate::files::output::{check_writable, record_input, write_file};
use crate::files::own_files::append_hash;
use crate::terminal::escape::line;
use crate::terminal::failure::Failure;
use crate::terminal::number::number;
use crate::terminal::report::{write_diagnostics, write_json, write_text};
use crate::terminal::text::shell_quoted;
use crate::terminal::wrap::fact_line;
use percuss_study::contact::exports::StopMotion;
use percuss_study::{ExportReport, ImpactExportError, export};
use std::path::Path;

/// Runs the command.
pub fn run(args: &ExportArgs) -> Result<(), Failure> {
    args.writing.apply();
    let conversion = args.export.conversion()?;
    let has_damping = args.damping.restitution.is_some() || !args.damping.tools.is_empty();
    if !args.contact.is_given() && args.damping.limit.is_none() && !has_damping {
        return convert(&args.model, &conversion, args.format);
    }
    let asked = args.export.checked(Path::new(""))?;
    let contact = match &args.damping.limit {
        Some(_) => args.contact.conditions()?,
        None => args.contact.question()?,
    };
    let Some(damping) = args.damping.checked()? else {
        return Err(Failure::bad_input(
            "--restitution E (the required restitution) and --stiffness N/m (the contact spring) are missing; an impact at a contact requires \
             both. Omit the contact to write the mechanism alone",
        ));
    };
    asked.files().iter().try_for_each(|path| check_writable(path))?;
    let model = args.model.load()?;
    model.inputs.iter().for_each(|input| record_input(&input.path));
    refuse_warnings(&model, args.model.reading.strict)?;
    let mut report = export(&model, &contact, damping, &asked)?;
    write_diagnostics(&report.diagnostics, args.model.reading.strict)?;
    write_files(&mut report)?;
    match args.format {
        CheckFormat::Json => write_json(&report),
        CheckFormat::Text => write_text(&summary(&report)),
    }
}

/// Writes the model and the script of a report, which then has no texts.
pub fn write_files(report: &mut ExportReport) -> Result<(), Failure> {
    for file in std::mem::take(&mut report.files) {
        let text = if file.name == report.output { append_hash(file.text) } else { file.text };
        write_file(&file.name, text.as_bytes())?;
    }
    Ok(())
}

/// Files, the impact, and the command that runs it.
pub fn summary(report: &ExportReport) -> String {
    let bound = report.error_bound.map_or_else(String::new, |bound| format!(" ± {bound:.1e}"));
    let mut out = fact_line("written", &line(&format!("{}, {}", report.output, report.script)));
    let turns = report.stop.as_ref().is_some_and(|stop| stop.motion == StopMotion::Turn);
    let (name, mass, speed) =
        if turns { ("effective inertia", "kg·m²", "rad/s") } else { ("effective mass", "kg", "m/s") };
    out += &fact_line(name, &format!("{} {mass}", number(report.effective_mass)));
    out += &fact_line("closing speed", &format!("{} {speed}", number(report.approach_speed)));
    out += &fact_line("restitution", &format!("{}{bound}", number(report.restitution)));
    out += &fact_line("time step", &format!("{} s", number(report.time_step)));
    out += &fact_line("run", &line(&format!("python {}", shell_quoted(&report.script))));
    out += &change_lines(&report.changes);
    out
}

impl From<ImpactExportError> for Failure {
    fn from(error: ImpactExportError) -> Self {
        match error {
            ImpactExportError::Question(error) => error.into(),
            error => Failure::bad_input(error.to_string()),
        }
    }
}
