//! `percuss run`.

use crate::args::{MassFormat, RunArgs};
use crate::failure::Failure;
use crate::mass::Asked;
use crate::report::note;
use crate::{mass, sweep};
use percuss_study::StudyFile;

/// Runs the command: the contact at the study's pose, or its sweep.
pub fn run(args: &RunArgs) -> Result<(), Failure> {
    let study = StudyFile::load(&args.study, args.max_size)?;
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
