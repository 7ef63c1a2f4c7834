//! Command `percuss export`.

use super::convert::{change_lines, convert, refuse_warnings};
use super::mesh_names::MeshNames;
use crate::args::{CheckFormat, ExportArgs, ModelFormat};
use crate::files::output::{check_writable, record_input, write_file};
use crate::files::own_files::append_hash;
use crate::terminal::escape::line;
use crate::terminal::failure::Failure;
use crate::terminal::number::number;
use crate::terminal::report::{write_diagnostics, write_json, write_text};
use crate::terminal::text::shell_quoted;
use crate::terminal::wrap::fact_line;
use percuss_study::contact::exports::StopMotion;
use percuss_study::{ExportReport, ImpactExportError, ImpactFileOptions, export_impact, export_stop};
use std::path::Path;

/// Script that runs an exported impact. It finds the model by its own name.
const SCRIPT: &str = include_str!("impact_script.py");
/// Ending of the names of exported models.
const ENDING: &str = "xml";

/// Runs the command.
pub fn run(args: &ExportArgs) -> Result<(), Failure> {
    args.writing.apply();
    let format = ModelFormat::of_output(args.to, &args.output)?;
    let has_damping = args.damping.restitution.is_some() || !args.damping.tools.is_empty();
    if !args.contact.is_given() && args.limit.is_none() && !has_damping {
        return convert(&args.model, (format, false), &args.output, args.format);
    }
    match format {
        ModelFormat::Mjcf => {}
        ModelFormat::Sdf => return Err(no_impact(args, "SDFormat", "sdf", "gazebo-classic or --for drake")),
        ModelFormat::Urdf => return Err(no_impact(args, "URDF", "urdf", "drake or --for bullet")),
    }
    let script = script_path(&args.output)?;
    let contact = match &args.limit {
        Some(_) => args.contact.conditions()?,
        None => args.contact.question()?,
    };
    if !args.damping.tools.is_empty() {
        return Err(Failure::bad_input("--for: the format of the file selects the simulator (--to)"));
    }
    let Some(damping) = args.damping.checked()? else {
        return Err(Failure::bad_input(
            "--restitution E (the required restitution) and --stiffness N/m (the contact spring) are missing; an impact at a contact requires \
             both. Omit the contact to write the mechanism alone",
        ));
    };
    for path in [&args.output, &script] {
        check_writable(path)?;
    }
    let model = args.model.load_for_conversion()?;
    model.inputs.iter().for_each(|input| record_input(&input.path));
    refuse_warnings(&model, args.model.reading.strict)?;
    let turns = match &args.limit {
        Some(stop) => stop.motion(&model)? == StopMotion::Turn,
        None => contact.is_moment(&model.mechanism),
    };
    damping.check_units(turns)?;
    // The mark by which percuss recognises its own files.
    let heading = format!("imported by percuss from {}", args.model.model);
    let meshes = MeshNames::new(&args.model.model, &args.output, format);
    let find_mesh = |name: &str| meshes.find(name);
    let file = ImpactFileOptions { heading: &heading, find_mesh: &find_mesh };
    let exported = match &args.limit {
        Some(stop) => export_stop(&model, stop, contact, damping, &file)?,
        None => export_impact(&model, &contact, damping, &file)?,
    };
    let report = ExportReport::new(&model, &exported, "mjcf", [&args.output, &script]);
    write_diagnostics(&report.diagnostics, args.model.reading.strict)?;
    write_file(&args.output, append_hash(exported.model.text).as_bytes())?;
    write_file(&script, SCRIPT.as_bytes())?;
    match args.format {
        CheckFormat::Json => write_json(&report),
        CheckFormat::Text => write_text(&summary(args, &report)),
    }
}

/// Refusal of a format that cannot express the state of an impact.
fn no_impact(args: &ExportArgs, format: &str, ending: &str, tools: &str) -> Failure {
    let given = match args.to {
        Some(format) => format!("--to {}", format.name()),
        None => format!("--output {}", args.output),
    };
    Failure::bad_input(format!(
        "{given}: {format} cannot store the positions and velocities of joints at an impact; write MJCF (-o FILE.xml), or write the mechanism \
         alone with \"percuss export MODEL -o FILE.{ending}\" and the contact parameters with \"percuss damp --for {tools}\""
    ))
}

/// Name of the script of a model file.
fn script_path(output: &str) -> Result<String, Failure> {
    let path = Path::new(output);
    if path.extension().is_none_or(|ending| ending != ENDING) {
        return Err(Failure::bad_input(format!(
            "--output {output}: a file name with .{ENDING} is expected; the script has the same name with .py"
        )));
    }
    Ok(path.with_extension("py").to_string_lossy().into_owned())
}

/// Files, the impact, and the command that runs it.
fn summary(args: &ExportArgs, report: &ExportReport) -> String {
    let bound = report.error_bound.map_or_else(String::new, |bound| format!(" ± {bound:.1e}"));
    let mut out = fact_line("written", &line(&format!("{}, {}", args.output, report.script)));
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
