//! One question asked of several designs: each answer, and by how much it differs from the first.

use crate::error::StudyError;
use crate::field::Names;
use crate::mass::mass;
use crate::mass_report::Status;
use crate::model::{Input, Model};
use crate::question::MassQuestion;
use crate::record::DiagnosticRecord;
use crate::row_source::RowSource;
use crate::sweep::sweep_report;
use crate::varied_values::VariedColumn;
use percuss_mechanism::Severity;
use serde::Serialize;

/// A model, and what is asked of it.
#[derive(Clone, Debug)]
pub struct Design {
    /// What it is called.
    pub name: String,
    /// The model.
    pub model: Model,
    /// The question, the same in each design but for what the design changes.
    pub question: MassQuestion,
    /// The rows to go through, if any.
    pub rows: Option<RowSource>,
}

/// `percuss compare`, as JSON.
#[derive(Clone, Debug, Serialize)]
pub struct ComparisonReport {
    /// `percuss.compare/1`.
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// The designs, the first of which the others are compared with.
    pub designs: Vec<DesignRecord>,
    /// What the rows vary; none where there are no rows.
    pub varied: Vec<VariedColumn>,
    /// The rows of all designs side by side.
    pub rows: Vec<ComparisonRow>,
    /// What was found in any of them.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// A design's answer at its pose.
#[derive(Clone, Debug, Serialize)]
pub struct DesignRecord {
    /// What it is called.
    pub name: String,
    /// Its files.
    pub inputs: Vec<Input>,
    /// Kind of answer; null where there is none.
    pub status: Option<Status>,
    /// m̄, kg; null unless finite.
    pub effective_mass: Option<f64>,
    /// What it may be off by, kg.
    pub effective_mass_error: Option<f64>,
    /// By how much it differs from the first design's, per cent of that.
    pub difference_percent: Option<f64>,
    /// Of the rows' differences the least and the greatest, per cent.
    pub difference_range_percent: Option<[f64; 2]>,
    /// The links that contribute most, and their shares.
    pub most: Vec<(String, f64)>,
    /// Why there is no answer.
    pub error: Option<String>,
}

/// A row of all designs.
#[derive(Clone, Debug, Serialize)]
pub struct ComparisonRow {
    /// Its number, from 0.
    pub row: usize,
    /// The varied numbers, rad or m.
    pub varied: Vec<f64>,
    /// m̄ of each design, kg; null where it has none.
    pub effective_mass: Vec<Option<f64>>,
    /// By how much each differs from the first, per cent.
    pub difference_percent: Vec<Option<f64>>,
}

/// Links that a design's record names.
const NAMED: usize = 3;

/// Why designs cannot be compared.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CompareError {
    /// Too few.
    #[error("{count} design(s); expected two at least: files, or a study with [[variant]]")]
    TooFew {
        /// How many.
        count: usize,
    },
    /// Rows that do not stand side by side.
    #[error(
        "\"{first}\" and \"{other}\" go through different rows ({why}); expected the same range in all, or none in any"
    )]
    OtherRows {
        /// The first design.
        first: String,
        /// The one whose rows are others.
        other: String,
        /// What differs.
        why: String,
    },
    /// The question means nothing for a design.
    #[error("\"{design}\": {source}")]
    Question {
        /// The design.
        design: String,
        /// Why.
        source: StudyError,
    },
}

impl CompareError {
    /// The message, with the names of where the question was asked.
    pub fn message(&self, names: Names) -> String {
        match self {
            CompareError::Question { design, source } => format!("\"{design}\": {}", source.message(names)),
            other => other.to_string(),
        }
    }
}

/// Compares designs.
///
/// # Errors
/// [`CompareError`]: fewer than two, a question that means nothing for one of them, rows that are not the same. A design
/// whose question is fine and has no answer says so in its record.
pub fn compare(designs: &[Design]) -> Result<ComparisonReport, CompareError> {
    if designs.len() < 2 {
        return Err(CompareError::TooFew { count: designs.len() });
    }
    let mut diagnostics = Vec::new();
    let mut records = Vec::new();
    for design in designs {
        records.push(record(design, &mut diagnostics)?);
    }
    let first = records[0].effective_mass;
    for other in &mut records[1..] {
        other.difference_percent = difference(first, other.effective_mass);
    }
    let (varied, rows) = rows(designs, &mut diagnostics)?;
    for (i, record) in records.iter_mut().enumerate().skip(1) {
        let differences = rows.iter().filter_map(|row: &ComparisonRow| row.difference_percent[i]);
        record.difference_range_percent = differences.fold(None, |range, x| {
            let [least, greatest] = range.unwrap_or([x, x]);
            Some([least.min(x), greatest.max(x)])
        });
    }
    Ok(ComparisonReport {
        schema: "percuss.compare/1",
        percuss: env!("CARGO_PKG_VERSION"),
        designs: records,
        varied,
        rows,
        diagnostics,
    })
}

/// Per cent of the first.
fn difference(first: Option<f64>, other: Option<f64>) -> Option<f64> {
    let (first, other) = (first?, other?);
    (first > 0.0).then(|| 100.0 * (other - first) / first)
}

fn record(design: &Design, diagnostics: &mut Vec<DiagnosticRecord>) -> Result<DesignRecord, CompareError> {
    let mut record = DesignRecord {
        name: design.name.clone(),
        inputs: design.model.inputs.clone(),
        status: None,
        effective_mass: None,
        effective_mass_error: None,
        difference_percent: None,
        difference_range_percent: None,
        most: Vec::new(),
        error: None,
    };
    match mass(&design.model, &design.question) {
        Ok(report) => {
            record.inputs = report.inputs;
            record.status = Some(report.status);
            record.effective_mass = report.effective_mass;
            record.effective_mass_error = report.effective_mass_error;
            let shares = report.bodies.into_iter().filter_map(|body| Some((body.link, body.share?)));
            record.most = shares.filter(|(_, share)| *share > 0.0).collect();
            record.most.sort_by(|a, b| b.1.total_cmp(&a.1));
            record.most.truncate(NAMED);
            collect(diagnostics, report.diagnostics, &design.name);
        }
        Err(error) if error.is_no_answer() => {
            record.error = Some(error.message(design.question.names));
        }
        Err(source) => return Err(CompareError::Question { design: design.name.clone(), source }),
    }
    Ok(record)
}

/// Findings, each once, with the design that it is about.
fn collect(all: &mut Vec<DiagnosticRecord>, found: Vec<DiagnosticRecord>, design: &str) {
    for mut finding in found {
        if finding.path.is_none() {
            finding.message = format!("\"{design}\": {}", finding.message);
        }
        if !all.contains(&finding) {
            all.push(finding);
        }
    }
}

fn rows(
    designs: &[Design],
    diagnostics: &mut Vec<DiagnosticRecord>,
) -> Result<(Vec<VariedColumn>, Vec<ComparisonRow>), CompareError> {
    let other = |design: &Design, why: &str| CompareError::OtherRows {
        first: designs[0].name.clone(),
        other: design.name.clone(),
        why: why.to_owned(),
    };
    let mut varied = Vec::new();
    let mut rows: Vec<ComparisonRow> = Vec::new();
    for (number, design) in designs.iter().enumerate() {
        let Some(source) = &design.rows else {
            match rows.is_empty() {
                true => continue,
                false => return Err(other(design, "it has no range")),
            }
        };
        if number > 0 && rows.is_empty() {
            return Err(other(design, "the first has no range"));
        }
        let report = sweep_report(&design.model, &design.question, source)
            .map_err(|source| CompareError::Question { design: design.name.clone(), source })?;
        let of_rows = report.diagnostics.into_iter().filter(|d| d.path.is_none()).collect();
        collect(diagnostics, of_rows, &design.name);
        let missing = || report.rows.iter().filter_map(|row| Some((row.row, row.error.as_ref()?)));
        if let Some((row, why)) = missing().next() {
            let message = format!(
                "{} of {} rows have no answer; the first, row {row}: {why}",
                missing().count(),
                report.rows.len()
            );
            let warning = DiagnosticRecord::about_answer(Severity::Warning, "rows-unanswered", message);
            collect(diagnostics, vec![warning], &design.name);
        }
        if number == 0 {
            varied.clone_from(&report.heading.varied);
        } else if varied != report.heading.varied {
            return Err(other(design, "they vary other things"));
        } else if rows.len() != report.rows.len() {
            return Err(other(design, "they have other numbers of rows"));
        }
        for (i, row) in report.rows.into_iter().enumerate() {
            let values = row.varied.values().to_vec();
            if number == 0 {
                let (effective_mass, difference_percent) = (vec![row.effective_mass], vec![None]);
                rows.push(ComparisonRow { row: i, varied: values, effective_mass, difference_percent });
                continue;
            }
            if rows[i].varied != values {
                return Err(other(design, "their values differ"));
            }
            let against = rows[i].effective_mass[0];
            rows[i].effective_mass.push(row.effective_mass);
            rows[i].difference_percent.push(difference(against, row.effective_mass));
        }
    }
    Ok((varied, rows))
}
