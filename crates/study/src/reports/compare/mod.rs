//! Comparison of one question over several designs: the result of each design and the difference from the
//! first.

pub(crate) mod design_changes;

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::evaluation::status::{Status, mass_unit};
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::names::Names;
use crate::question::row_source::RowSource;
use crate::question::travel::varied_values::VariedColumn;
use crate::reports::answer_mass::mass;
use crate::reports::compare::design_changes::{DesignChange, design_changes};
use crate::sweep::sweep_rows::sweep_report;
use percuss_units::LengthUnit;
use schemars::JsonSchema;
use serde::Serialize;

/// Model and question of a design.
#[derive(Clone, Debug)]
pub struct Design {
    /// Name of the design.
    pub name: String,
    /// The model.
    pub model: Model,
    /// Question; equal for all designs except for the changes of the design.
    pub question: MassQuestion,
    /// Text that identifies the contact of the design; a design is compared with the first design of equal text. `None`: the contact of
    /// the first design, even if its link has another name in this model.
    pub contact: Option<String>,
    /// Rows of positions, if any.
    pub rows: Option<RowSource>,
}

/// Report of `percuss compare`, as JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ComparisonReport {
    /// `percuss.compare/1`.
    #[schemars(extend("const" = "percuss.compare/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Results of the designs. Each is compared with the first design that has the same contact.
    pub designs: Vec<DesignRecord>,
    /// Varied columns; empty without rows.
    pub varied: Vec<VariedColumn>,
    /// Rows with the values of all designs.
    pub rows: Vec<ComparisonRow>,
    /// Findings about all designs.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// Result of a design at the pose of the question.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct DesignRecord {
    /// Name of the design.
    pub name: String,
    /// Named contact of the design; null if link, point and normal give the contact.
    pub contact: Option<String>,
    /// Number of the design that this design is compared with, from 0; null for the first with its contact.
    pub reference: Option<usize>,
    /// Input files of the design.
    pub inputs: Vec<Input>,
    /// Kind of result; null without a result.
    pub status: Option<Status>,
    /// m̄ in the unit of `mass_unit`; null unless finite.
    pub effective_mass: Option<f64>,
    /// Unit of the effective masses of the design: `kg`; `kg·m²` for a moment about an axis, and for the stop of a revolute joint.
    pub mass_unit: &'static str,
    /// Error bound of m̄, in the unit of `mass_unit`.
    pub effective_mass_error: Option<f64>,
    /// Motion ratio: closing of the contact per upward travel of the wheel; null if it differs between motions of the mechanism.
    pub motion_ratio: Option<f64>,
    /// Upward travel of the wheel at the touch, m; null unless the contact is a stop that was brought to the touch.
    pub travel_at_touch: Option<f64>,
    /// Unit of lengths in texts.
    #[serde(skip)]
    pub unit: LengthUnit,
    /// Difference from m̄ of the reference, per cent of the reference.
    pub difference_percent: Option<f64>,
    /// Smallest and largest difference over the rows, per cent.
    pub difference_range_percent: Option<[f64; 2]>,
    /// Differences from the reference; empty without a reference.
    pub changes: Vec<DesignChange>,
    /// Links with the largest shares of m̄, and the shares.
    pub most: Vec<(String, f64)>,
    /// Reason for a missing result.
    pub error: Option<String>,
}

/// Row of the comparison with the values of all designs.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub struct ComparisonRow {
    /// Number of the row, from 0.
    pub row: usize,
    /// The varied numbers, rad or m.
    pub varied: Vec<f64>,
    /// m̄ of each design, in the unit of its `mass_unit`; null without a finite result.
    pub effective_mass: Vec<Option<f64>>,
    /// Difference of each design from its reference, per cent.
    pub difference_percent: Vec<Option<f64>>,
    /// Motion ratio of each design: closing of the contact per varied travel; null without a travel.
    pub motion_ratio: Vec<Option<f64>>,
}

/// Largest number of links listed per design.
const MAX_LISTED_LINKS: usize = 3;

/// Error of a comparison.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CompareError {
    /// Fewer than two designs.
    #[error(
        "{count} design(s); expected two at least: files, contacts of one file (bump_stop,spring), or a study with [[variant]]"
    )]
    TooFew {
        /// Number of designs.
        count: usize,
    },
    /// Rows differ between designs.
    #[error(
        "\"{first}\" and \"{other}\" have different rows ({why}); expected the same range in all designs, or no \
         range at all"
    )]
    OtherRows {
        /// The first design.
        first: String,
        /// Design with the different rows.
        other: String,
        /// Difference between the rows.
        why: String,
    },
    /// Invalid question for a design.
    #[error("\"{design}\": {source}")]
    Question {
        /// The design.
        design: String,
        /// Number of the design, from 0.
        number: usize,
        /// Cause.
        source: Box<StudyError>,
        /// Key at fault in a study; `None` without a study.
        key: Option<Box<str>>,
    },
}

impl CompareError {
    /// Message with the names of `names`: flags, study keys or fields.
    pub fn message(&self, names: Names) -> String {
        match self {
            CompareError::Question { design, source, key, .. } => {
                let message = source.message(names);
                match (key, source.key()) {
                    (Some(key), Some(own)) if matches!(names, Names::Keys(_)) => {
                        let why = message.strip_prefix(&format!("{own}: ")).unwrap_or(&message);
                        format!("{key}: \"{design}\": {why}")
                    }
                    _ => format!("\"{design}\": {message}"),
                }
            }
            other => other.to_string(),
        }
    }
}

/// Compares designs.
///
/// # Errors
/// [`CompareError`]: fewer than two designs, an invalid question for a design, or different rows. A design with
/// a valid question but without a result is no error: `DesignRecord::error` holds the reason.
pub fn compare(designs: &[Design]) -> Result<ComparisonReport, CompareError> {
    if designs.len() < 2 {
        return Err(CompareError::TooFew { count: designs.len() });
    }
    let mut diagnostics = DesignFindings::default();
    let mut records = Vec::new();
    for (number, design) in designs.iter().enumerate() {
        let mut record = record(design, number, &mut diagnostics)?;
        record.reference = reference(designs, number);
        if let Some(first) = record.reference.map(|at| &designs[at]) {
            record.changes =
                design_changes([&first.model, &design.model], [&first.question, &design.question]);
        }
        let compared = record.reference.map(|at: usize| &records[at] as &DesignRecord);
        record.difference_percent =
            compared.and_then(|compared| difference(compared.effective_mass, record.effective_mass));
        records.push(record);
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
        diagnostics: diagnostics.into_records(designs.len()),
    })
}

/// Design that a design is compared with: the first with the same contact.
fn reference(designs: &[Design], number: usize) -> Option<usize> {
    let has_same_contact = |other: &Design| other.contact == designs[number].contact;
    designs.iter().position(has_same_contact).filter(|first| *first < number)
}

/// Relative difference, per cent of the first value; `None` if the first value is zero or either is missing.
fn difference(first: Option<f64>, other: Option<f64>) -> Option<f64> {
    let (first, other) = (first?, other?);
    (first > 0.0).then(|| 100.0 * (other - first) / first)
}

/// Result of a design at its pose; its findings are added to `diagnostics`. Error: an invalid question.
fn record(
    design: &Design,
    number: usize,
    diagnostics: &mut DesignFindings,
) -> Result<DesignRecord, CompareError> {
    let mut record = DesignRecord {
        name: design.name.clone(),
        contact: design.question.contact.at.clone(),
        reference: None,
        inputs: design.model.inputs.clone(),
        status: None,
        effective_mass: None,
        mass_unit: mass_unit(design.question.is_moment(&design.model.mechanism)),
        effective_mass_error: None,
        motion_ratio: None,
        travel_at_touch: None,
        unit: design.model.length_unit(),
        difference_percent: None,
        difference_range_percent: None,
        changes: Vec::new(),
        most: Vec::new(),
        error: None,
    };
    match mass(&design.model, &design.question) {
        Ok(report) => {
            record.inputs = report.inputs;
            record.status = Some(report.status);
            record.effective_mass = report.effective_mass;
            record.effective_mass_error = report.effective_mass_error;
            record.motion_ratio = report.motion_ratios.first().and_then(|ratio| ratio.contact_per_wheel);
            let touch = report.named_contact.as_ref().filter(|contact| contact.brought_to_touch);
            record.travel_at_touch = touch.and_then(|contact| Some(contact.wheel_travel.first()?.travel));
            let shares = report.bodies.into_iter().filter_map(|body| Some((body.link, body.share?)));
            record.most = shares.filter(|(_, share)| *share > 0.0).collect();
            record.most.sort_by(|a, b| b.1.total_cmp(&a.1));
            record.most.truncate(MAX_LISTED_LINKS);
            diagnostics.add(report.diagnostics, &design.name);
        }
        Err(error) if error.has_no_result() => {
            record.error = Some(error.message(design.question.names));
        }
        Err(source) => return Err(question_error(design, number, source)),
    }
    Ok(record)
}

/// Error of a design with an invalid question.
fn question_error(design: &Design, number: usize, source: StudyError) -> CompareError {
    CompareError::Question { design: design.name.clone(), number, source: Box::new(source), key: None }
}

/// Findings with the names of their designs; equal findings of several designs are one.
#[derive(Default)]
struct DesignFindings(Vec<(DiagnosticRecord, Vec<String>)>);

impl DesignFindings {
    /// Adds the findings of a design.
    fn add(&mut self, found: Vec<DiagnosticRecord>, design: &str) {
        for finding in found {
            match self.0.iter_mut().find(|(known, _)| *known == finding) {
                Some((_, designs)) if designs.iter().any(|known| known == design) => {}
                Some((_, designs)) => designs.push(design.to_owned()),
                None => self.0.push((finding, vec![design.to_owned()])),
            }
        }
    }

    /// Findings of `count` designs. The message of a finding without a file begins with its designs.
    fn into_records(self, count: usize) -> Vec<DiagnosticRecord> {
        let record = |(finding, designs): (DiagnosticRecord, Vec<String>)| {
            let of = match &designs[..] {
                _ if finding.path.is_some() => return finding,
                all if all.len() == count => "all designs".to_owned(),
                [first, others @ ..] if !others.is_empty() => {
                    format!(
                        "\"{first}\" and {} other{}",
                        others.len(),
                        if others.len() == 1 { "" } else { "s" }
                    )
                }
                names => format!("\"{}\"", names.join("")),
            };
            DiagnosticRecord { message: format!("{of}: {}", finding.message), ..finding }
        };
        self.0.into_iter().map(record).collect()
    }
}

/// Results of all designs over their ranges, row by row.
fn rows(
    designs: &[Design],
    diagnostics: &mut DesignFindings,
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
        let report = sweep_report(&design.model, &source.question_of_rows(&design.question), source)
            .map_err(|error| question_error(design, number, error))?;
        let of_rows = report.diagnostics.into_iter().filter(|d| d.path.is_none()).collect();
        diagnostics.add(of_rows, &design.name);
        let missing = || report.rows.iter().filter_map(|row| Some((row.row, row.error.as_ref()?)));
        if let Some((row, why)) = missing().next() {
            let message = format!(
                "{} of {} rows have no result; the first, row {row}: {why}",
                missing().count(),
                report.rows.len()
            );
            let warning = Finding::about_result(FindingKind::RowsUnanswered, message).into();
            diagnostics.add(vec![warning], &design.name);
        }
        if number == 0 {
            varied.clone_from(&report.heading.varied);
        } else if varied != report.heading.varied {
            return Err(other(design, "they vary other things"));
        } else if rows.len() != report.rows.len() {
            return Err(other(design, "the numbers of rows differ"));
        }
        for (i, row) in report.rows.into_iter().enumerate() {
            let values = row.varied.values();
            if number == 0 {
                rows.push(ComparisonRow { row: i, varied: values.to_vec(), ..ComparisonRow::default() });
            }
            let compared = &mut rows[i];
            if compared.varied != values {
                return Err(other(design, "their values differ"));
            }
            let against = reference(designs, number).and_then(|at| compared.effective_mass[at]);
            compared.difference_percent.push(difference(against, row.effective_mass));
            compared.effective_mass.push(row.effective_mass);
            compared.motion_ratio.push(row.motion_ratio);
        }
    }
    Ok((varied, rows))
}
