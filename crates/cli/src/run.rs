//! `percuss run`.

use crate::args::{MassFormat, RunArgs};
use crate::failure::Failure;
use crate::mass::Asked;
use crate::report::note;
use crate::{compare, mass, sweep};
use percuss_study::{Names, StudyFile};
use std::path::Path;

/// Runs the command: the contact at the study's pose, or its sweep.
pub fn run(args: &RunArgs) -> Result<(), Failure> {
    let study = StudyFile::load(&args.study, args.max_size)?;
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
            sweep::go_through(&study.model, &study.question, vary, study.output.as_deref(), args.strict)
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
