//! Contact of measured impacts, compared with the effective mass of a model.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::damped_contact::finite_mass;
use crate::evaluation::named_contact::{NamedContactRecord, named_contact};
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::errors::table_error::TableError;
use crate::question::field::Field;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::identify::IdentifyQuestion;
use crate::reports::explain::explain_parts;
use crate::tables::records::{RecordColumn, read_record};
use percuss_contact::ContactLawError;
use percuss_contact::identification::{
    DamperForm, Estimate, Identification, IdentifiedRecord, MOST_SAMPLES, Measured, Record, SampleUse,
    identify,
};
use schemars::JsonSchema;
use serde::Serialize;

/// Relative residual, and relative uncertainty, above which a result is a guess.
const GUESS: f64 = 0.2;
/// Standard uncertainties within which a mass agrees: 95 of 100 cases.
const AGREEMENT: f64 = 2.0;
/// Number of links that are listed as explanations.
const EXPLANATIONS: usize = 3;

/// Measured impact of a file.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MeasuredImpact {
    /// File.
    pub file: String,
    /// Columns that were used.
    pub columns: Vec<RecordColumn>,
    /// Result.
    #[serde(flatten)]
    pub identified: IdentifiedRecord,
    /// Times and signals of the file.
    #[serde(skip)]
    pub record: Record,
}

impl MeasuredImpact {
    /// Quantity, times (s), data, fit and use of each signal in the used times.
    pub fn signals(&self) -> impl Iterator<Item = (Measured, &[f64], &[f64], &[f64], &[SampleUse])> {
        let first = self.identified.first;
        self.record.signals.iter().zip(&self.identified.signals).map(move |(data, signal)| {
            let range = first..first + signal.fitted.len();
            (
                signal.quantity,
                &self.record.times[range.clone()],
                &data.values[range],
                &signal.fitted[..],
                &signal.uses[..],
            )
        })
    }
}

/// Change of the mass of a link at which the effective mass of the model is the identified one, to first order.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct MassExplanation {
    /// The link.
    pub link: String,
    /// Change of its mass, kg.
    pub change: f64,
    /// Change of its mass, relative.
    pub relative_change: f64,
}

/// Identified effective mass beside that of the model.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ComparedMass {
    /// m̄ of the model, or the given mass, kg.
    pub expected: f64,
    /// Identified mass minus the expected one, kg.
    pub difference: f64,
    /// True if the difference is at most two standard uncertainties; null if these are above a fifth of the mass.
    pub agrees: Option<bool>,
    /// Links whose mass explains the difference, the smallest relative change first.
    pub explanations: Vec<MassExplanation>,
}

/// Report of `percuss identify`, as JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct IdentificationReport {
    /// `percuss.identification/1`.
    #[schemars(extend("const" = "percuss.identification/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Files of the data and of the model.
    pub inputs: Vec<Input>,
    /// Named contact of the model.
    pub named_contact: Option<NamedContactRecord>,
    /// Effective mass m̄, kg. Uncertainties are standard uncertainties: the value lies within two of them in 95 of 100 cases.
    pub effective_mass: Estimate,
    /// True if the data determine the mass; false if it is the given one.
    pub finds_mass: bool,
    /// Comparison with the model or the given mass.
    pub compared: Option<ComparedMass>,
    /// Form of the damper.
    pub damper: DamperForm,
    /// Mean square of the residuals with the other form, divided by that with this form; null if the form is given.
    pub other_form: Option<f64>,
    /// Stiffness k of k x^p, N/m^p.
    pub stiffness: Estimate,
    /// Exponent p.
    pub exponent: Estimate,
    /// Damping c of c x^((p-1)/2) v, N·s/m^((p+1)/2); null for the other form.
    pub damping: Option<Estimate>,
    /// Dissipation d of d k x^p v, s/m; null for the other form.
    pub dissipation: Option<Estimate>,
    /// Correlations of mass, stiffness, exponent and damping or dissipation.
    pub correlation: [[f64; 4]; 4],
    /// Measured impacts.
    pub impacts: Vec<MeasuredImpact>,
    /// Findings about the files and the result.
    pub diagnostics: Vec<DiagnosticRecord>,
}

/// Identifies the contact of measured impacts. `mass`: expected effective mass, kg; used if the data do not determine it.
///
/// # Errors
/// [`StudyError`]: invalid keys, a file that is no record of an impact, data that do not determine the contact.
pub fn identify_contact(
    asked: &IdentifyQuestion,
    mass: Option<f64>,
) -> Result<IdentificationReport, StudyError> {
    asked.check()?;
    let in_file = |error| StudyError::input(Field::Data, Fault::Table(Box::new(error)));
    let (mut records, mut columns, mut inputs) = (Vec::new(), Vec::new(), Vec::new());
    let mut samples = 0;
    for path in &asked.data {
        let (record, of_file, input) = read_record(path, &asked.ignore).map_err(in_file)?;
        samples += record.times.len() * record.signals.len();
        if samples > MOST_SAMPLES {
            let why =
                format!("more than {MOST_SAMPLES} samples with this file; cut the files around the impacts");
            return Err(in_file(TableError::in_file(path, why)));
        }
        if inputs.iter().any(|other: &Input| other.sha256 == input.sha256) {
            let why = "it has the contents of another of the files; give each impact once";
            return Err(in_file(TableError::in_file(path, why)));
        }
        records.push(Record { speed: asked.approach_speed(), ..record });
        columns.push(of_file);
        inputs.push(input);
    }
    let known = asked.known(mass);
    let found = identify(&records, &known).map_err(|error| match error {
        ContactLawError::Record { record: Some(number), why } => {
            in_file(TableError::in_file(&asked.data[number], why))
        }
        ContactLawError::Record { record: None, why } => StudyError::input(Field::Data, why),
        error => error.into(),
    })?;
    let mut diagnostics = contradictions(&asked.data, &found.records);
    diagnostics.extend(guesses(&found));
    let parts = asked.data.iter().zip(columns).zip(records).zip(found.records);
    let impacts = parts.map(|(((file, columns), record), identified)| MeasuredImpact {
        file: file.clone(),
        columns,
        identified,
        record,
    });
    let compared = mass.filter(|_| found.finds_mass).map(|expected| {
        let difference = found.mass.value - expected;
        let is_known = found.mass.uncertainty <= GUESS * found.mass.value;
        let agrees = is_known.then_some(difference.abs() <= AGREEMENT * found.mass.uncertainty);
        ComparedMass { expected, difference, agrees, explanations: Vec::new() }
    });
    let of_form = |form| (found.damper == form).then_some(found.damping);
    Ok(IdentificationReport {
        schema: "percuss.identification/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs,
        named_contact: None,
        effective_mass: found.mass,
        finds_mass: found.finds_mass,
        compared,
        damper: found.damper,
        other_form: found.other_form,
        stiffness: found.stiffness,
        exponent: found.exponent,
        damping: of_form(DamperForm::KelvinVoigt),
        dissipation: of_form(DamperForm::HuntCrossley),
        correlation: found.correlation,
        impacts: impacts.collect(),
        diagnostics,
    })
}

/// Identifies a contact as [`identify_contact`] does, and compares its mass with the effective mass at a contact of a model.
///
/// # Errors
/// [`StudyError`], as for `mass` and [`identify_contact`]; a contact without a finite mass, or with different masses on different branches;
/// a moment.
pub fn identify_contact_of(
    model: &Model,
    question: &MassQuestion,
    asked: &IdentifyQuestion,
) -> Result<IdentificationReport, StudyError> {
    asked.check()?;
    let question = &*question.resolve_contact(&model.mechanism)?;
    question.refuse_moment("contact of measured impacts")?;
    let evaluated = EvaluatedQuestion::new(model, question)?;
    let EvaluatedQuestion { prepared, result, .. } = &evaluated;
    let mass = finite_mass(&evaluated)?;
    let mut report = identify_contact(asked, Some(mass))?;
    if let Some(compared) = report.compared.as_mut().filter(|compared| compared.agrees == Some(false))
        && let Some(explanation) = explain_parts(&evaluated, question, false)?
    {
        let changes = explanation.links.into_iter().map(|link| {
            let change = compared.difference / link.per_kilogram;
            MassExplanation { link: link.link, change, relative_change: change / link.mass }
        });
        // A link cannot lose more than its mass.
        let mut changes: Vec<MassExplanation> = changes
            .filter(|found| found.relative_change.is_finite() && found.relative_change > -1.0)
            .collect();
        changes.sort_by(|a, b| a.relative_change.abs().total_cmp(&b.relative_change.abs()));
        changes.truncate(EXPLANATIONS);
        compared.explanations = changes;
    }
    let findings = result.findings.iter().cloned().map(DiagnosticRecord::from);
    let own = std::mem::take(&mut report.diagnostics);
    report.diagnostics = model.diagnostics.iter().cloned().chain(findings).chain(own).collect();
    report.inputs.extend(prepared.inputs());
    report.named_contact = named_contact(&evaluated)?;
    Ok(report)
}

/// Finding about values whose uncertainty is above a fifth of the value, and about a restitution above 1.
fn guesses(found: &Identification) -> Option<DiagnosticRecord> {
    let first = &found.records[0];
    let values = [
        ("the effective mass", found.mass),
        ("the stiffness", found.stiffness),
        ("the restitution", first.restitution),
    ];
    let is_guess = |estimate: &Estimate| estimate.uncertainty > GUESS * estimate.value.abs();
    let names: Vec<&str> =
        values.iter().filter(|(_, estimate)| is_guess(estimate)).map(|(name, _)| *name).collect();
    let gains = first.restitution.value - AGREEMENT * first.restitution.uncertainty > 1.0;
    let message = match (names.is_empty(), gains) {
        (false, _) => format!(
            "the data hardly determine {}: the uncertainty is above a fifth of the value, and is itself too small; give the exponent, the \
             approach speed or another signal",
            names.join(" and ")
        ),
        (true, true) => {
            "the restitution is above 1: the contact gains energy; check signs, units and the drop height"
                .to_owned()
        }
        (true, false) => return None,
    };
    Some(Finding::about_result(FindingKind::ContactGuessed, message).into())
}

/// Findings about signals from which the identified contact differs by more than noise.
fn contradictions(files: &[String], records: &[IdentifiedRecord]) -> Vec<DiagnosticRecord> {
    let mut findings = Vec::new();
    for (file, record) in files.iter().zip(records) {
        for signal in &record.signals {
            if signal.contradicts(record.contact_duration.value) || signal.relative_residual > GUESS {
                let (name, _) = signal.quantity.name_and_unit();
                let message = format!(
                    "{file}: the identified contact differs from the {name} by {:.1} % of its largest value; the contact has another law, \
                     something acts beside it, or the data are filtered (give the filter), and the uncertainties do not include that",
                    100.0 * signal.relative_residual
                );
                findings.push(Finding::about_result(FindingKind::LawContradicted, message).into());
            }
        }
    }
    findings
}
