//! Files that the tables of a study name: `sweep.output`, `damping.output`, `identify.output`, `response.output`, `map.output`, `kinematics.output`, `generate.output`,
//! `convert.output`, `export.output`.

use super::results::StudyResults;
use crate::commands::compare::{self, ComparisonOutput};
use crate::commands::exports::{convert, export, generate};
use crate::commands::impacts::{identify, response};
use crate::commands::suspension::kinematics;
use crate::commands::sweep::{ReadySweep, SweepOutput};
use crate::commands::{damp, map};
use crate::files::table_style::TableStyle;
use crate::terminal::failure::Failure;
use percuss_study::StudyFile;

/// Writes these files and prints nothing: the report has the results and the findings.
pub(super) fn write(study: &StudyFile, results: &StudyResults) -> Result<(), Failure> {
    write_rows(study, results)?;
    if let Some(damping) = &study.tables.damping
        && let Some(path) = &damping.output
        && let Some(report) = study.damper()?
    {
        damp::write_history(&report, path)?;
    }
    if let (Some(requested), Some(report)) = (&study.tables.identify, &results.report.identify)
        && let Some(path) = &requested.output
    {
        identify::write_output(report, path)?;
    }
    if let (Some(requested), Some(report)) = (&study.tables.response, &results.report.response)
        && let Some(path) = &requested.output
    {
        response::write_output(report, path)?;
    }
    if let (Some(requested), Some(report)) = (&study.tables.kinematics, &results.report.kinematics)
        && let Some(path) = &requested.output
    {
        kinematics::write_output(report, !requested.columns.is_empty(), path)?;
    }
    if let (Some(requested), Some(result)) = (&study.tables.map, &results.report.map) {
        let formats = map::formats(&requested.output)?;
        map::write_files(result, &formats, TableStyle::from_study(&requested.table()))?;
    }
    if let (Some(requested), Some(report)) = (&study.tables.generate, &results.report.generate) {
        generate::write_files(report, requested.output.as_deref().unwrap_or_default())?;
    }
    if let Some(report) = &results.report.convert {
        convert::write_files(&mut report.clone())?;
    }
    if let Some(report) = &results.report.export {
        export::write_files(&mut report.clone())?;
    }
    Ok(())
}

/// Writes the rows of a sweep, or the comparison of several contacts and variants over them.
fn write_rows(study: &StudyFile, results: &StudyResults) -> Result<(), Failure> {
    let Some(requested) = &study.tables.sweep else { return Ok(()) };
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
    results.report.comparison.as_ref().map_or(Ok(()), |report| compare::write_output(report, &written))
}
