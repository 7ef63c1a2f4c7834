//! Files that the tables of a study name: `sweep.output`, `damping.output`, `map.output`, `kinematics.output`.

use super::results::StudyResults;
use crate::commands::compare::{self, ComparisonOutput};
use crate::commands::suspension::kinematics;
use crate::commands::sweep::{ReadySweep, SweepOutput};
use crate::commands::{damp, map};
use crate::files::table_style::TableStyle;
use crate::terminal::failure::Failure;
use percuss_study::StudyFile;

/// Keys and paths of the files that a study names.
pub fn files_of(study: &StudyFile) -> impl Iterator<Item = (&'static str, String)> + '_ {
    let sweep = study.sweep.iter().filter_map(|sweep| Some(("sweep.output", sweep.output.clone()?)));
    let damping = study.damping.iter().filter_map(|d| Some(("damping.output", d.output.clone()?)));
    let map = study.map.iter().flat_map(|map| map.output.iter().map(|output| ("map.output", output.clone())));
    let kinematics = study.kinematics.iter().filter_map(|k| Some(("kinematics.output", k.output.clone()?)));
    sweep.chain(damping).chain(map).chain(kinematics)
}

/// Writes these files and prints nothing: the report has the results and the findings.
pub(super) fn write(study: &StudyFile, results: &StudyResults) -> Result<(), Failure> {
    write_rows(study, results)?;
    if let Some(damping) = &study.damping
        && let Some(path) = &damping.output
        && let Some(report) = study.damper()?
    {
        damp::write_history(&report, damping, path)?;
    }
    if let (Some(requested), Some(report)) = (&study.kinematics, &results.kinematics)
        && let Some(path) = &requested.output
    {
        kinematics::write_output(report, requested, path)?;
    }
    if let (Some(requested), Some(result)) = (&study.map, &results.mapped) {
        let formats = map::formats(&requested.output)?;
        map::write_files(result, &formats, TableStyle::from_study(&requested.table()))?;
    }
    Ok(())
}

/// Writes the rows of a sweep, or the comparison of several contacts and variants over them.
fn write_rows(study: &StudyFile, results: &StudyResults) -> Result<(), Failure> {
    let Some(requested) = &study.sweep else { return Ok(()) };
    let (Some(path), Some(question)) = (requested.output.as_deref(), &study.question) else { return Ok(()) };
    let table = TableStyle::from_study(&requested.table());
    if study.variants.is_empty() && study.contacts.is_empty() {
        let destination =
            SweepOutput { output: Some(path), table, figure: requested.figure(), strict: false };
        let question = study.question_of_rows(question);
        let sweep = study.prepared_sweep(requested, &question);
        return ReadySweep::new(&study.model, &question, &requested.rows(), sweep, destination)?.write_rows();
    }
    let written = ComparisonOutput {
        output: Some(path),
        table,
        figure: &requested.figure(),
        format: crate::args::MassFormat::Text,
        strict: false,
    };
    results.compared.as_ref().map_or(Ok(()), |report| compare::write_output(report, &written))
}
