//! `percuss run`.

use crate::args::{FigureArgs, MassFormat, RunArgs};
use crate::failure::Failure;
use crate::mass::Asked;
use crate::report::note;
use crate::sweep::Written;
use crate::table_style::TableStyle;
use crate::{compare, mass, report_page, sweep};
use percuss_study::{Names, StudyFile};
use std::fs;
use std::path::{Path, PathBuf};

/// Runs the command: the contact at the study's pose, or its sweep.
pub fn run(args: &RunArgs) -> Result<(), Failure> {
    let study = StudyFile::load(&args.study, args.max_size)?;
    args.writing.apply();
    if let Some(path) = &args.report {
        if !args.allow_outside {
            inside(path, &study.folder, "--report")?;
        }
        sweep::use_threads(args.threads);
        let written = report_page::write(&study, args, path);
        return written.map_err(|failure| failure.in_file(&args.study));
    }
    if let Some(path) = study.output.as_deref().filter(|_| !args.allow_outside) {
        inside(path, &study.folder, "sweep.output")?;
    }
    if !study.variants.is_empty() && args.format.is_none() {
        let name =
            Path::new(&args.study).file_stem().map_or_else(String::new, |n| n.to_string_lossy().into());
        let compared = compare::show(
            &study.designs(&name),
            Names::Keys,
            study.output.as_deref(),
            MassFormat::Text,
            args.strict,
        );
        return compared.map_err(|failure| failure.in_file(&args.study));
    }
    let answered = match &study.sweep {
        Some(vary) if args.format.is_none() => {
            if study.damping.is_some() {
                note("[damping] is of the contact at its pose, not of the sweep: --format text shows it");
            }
            sweep::use_threads(args.threads);
            let written = Written {
                output: study.output.as_deref(),
                table: TableStyle::default(),
                figure: &FigureArgs::default(),
                strict: args.strict,
            };
            sweep::go_through(&study.model, &study.question, vary, &written)
        }
        _ => {
            let format = args.format.unwrap_or(MassFormat::Text);
            mass::show(
                &study.model,
                &study.question,
                study.damping.as_ref(),
                format,
                &Asked::default(),
                args.strict,
            )
        }
    };
    answered.map_err(|failure| failure.in_file(&args.study))
}

/// Refuses an output that is not in the study's folder or below it, wherever links lead.
fn inside(path: &str, folder: &Path, name: &str) -> Result<(), Failure> {
    let whole = |path: &Path| {
        let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
        fs::canonicalize(path).ok()
    };
    let target = Path::new(path);
    // A file that is not there yet has a folder that is.
    let parent = || whole(target.parent()?)?.join(target.file_name()?).into();
    let at: Option<PathBuf> = whole(target).or_else(parent);
    match (at, whole(folder)) {
        (Some(at), Some(folder)) if at.starts_with(&folder) => Ok(()),
        // A folder that is missing is what the writer says.
        (None, _) => Ok(()),
        _ => Err(Failure::bad_input(format!(
            "{name}: {path} is outside the study's folder; --allow-outside lets the study write there"
        ))),
    }
}
