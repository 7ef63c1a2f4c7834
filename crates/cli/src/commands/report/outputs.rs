//! Files that the tables of a study name: `sweep.output`, `damping.output`, `map.output`, `kinematics.output`.

use crate::commands::compare::{self, ComparisonOutput};
use crate::commands::suspension::kinematics;
use crate::commands::sweep::{self, SweepOutput};
use crate::commands::{damp, map};
use crate::files::table_style::TableStyle;
use crate::terminal::failure::Failure;
use percuss_study::{Names, StudyFile};

/// Keys and paths of the files that a study names.
pub fn files_of(study: &StudyFile) -> impl Iterator<Item = (&'static str, String)> + '_ {
    let sweep = study.sweep.iter().filter_map(|sweep| Some(("sweep.output", sweep.output.clone()?)));
    let damping = study.damping.iter().filter_map(|d| Some(("damping.output", d.output.clone()?)));
    let map =
        study.map.iter().flat_map(|map| map.outputs.iter().map(|output| ("map.output", output.clone())));
    let kinematics = study.kinematics.iter().filter_map(|k| Some(("kinematics.output", k.output.clone()?)));
    sweep.chain(damping).chain(map).chain(kinematics)
}

/// Writes these files and prints nothing: the report has the results and the findings.
pub(super) fn write(study: &StudyFile, study_path: &str) -> Result<(), Failure> {
    write_rows(study, study_path)?;
    if let Some(damping) = &study.damping
        && let Some(path) = &damping.output
        && (damping.stop.is_some() || study.question.is_some())
    {
        damp::write_history(&damp::study_report(study, damping)?, &damping.question, path)?;
    }
    if let Some(requested) = &study.kinematics
        && let Some(path) = &requested.output
    {
        kinematics::write_output(&requested.report(&study.model)?, requested, path)?;
    }
    if let Some(requested) = &study.map {
        let formats = map::formats(&requested.outputs)?;
        map::write_files(
            &study.model,
            &requested.question,
            &formats,
            TableStyle::from_study(&requested.table),
        )?;
    }
    Ok(())
}

/// Writes the rows of a sweep, or the comparison of several contacts and variants over them.
fn write_rows(study: &StudyFile, study_path: &str) -> Result<(), Failure> {
    let Some(requested) = &study.sweep else { return Ok(()) };
    let (Some(path), Some(question)) = (requested.output.as_deref(), &study.question) else { return Ok(()) };
    let table = TableStyle::from_study(&requested.table);
    if study.variants.is_empty() && study.contacts.is_empty() {
        let written = SweepOutput {
            gradient: requested.gradient,
            output: Some(path),
            table,
            figure: &requested.figure,
            strict: false,
        };
        return sweep::write_rows(&study.model, &study.question_of_rows(question), &requested.rows, &written);
    }
    let written = ComparisonOutput {
        output: Some(path),
        table,
        figure: &requested.figure,
        format: crate::args::MassFormat::Text,
        strict: false,
    };
    compare::write_output(&study.designs(&compare::study_name(study_path)), Names::Keys, &written)
}
