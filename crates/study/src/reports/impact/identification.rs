//! Contact of measured impacts, compared with the effective mass of a model.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::damped_contact::finite_mass;
use crate::damper::sheet_forces::{ParallelForces, parallel_forces};
use crate::evaluation::named_contact::{NamedContactRecord, named_contact};
use crate::evaluation::passed_stops::answer_findings;
use crate::evaluation::prepared_question::EvaluatedQuestion;
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::errors::table_error::TableError;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::identify::IdentifyQuestion;
use crate::reports::explain::explain_parts;
use crate::tables::records::{MOST_NUMBERS, ReadRecord, RecordColumn, read_record};
use percuss_contact::ContactLawError;
use percuss_contact::identification::{
    DamperForm, EXPONENTS, Estimate, Identification, IdentifiedRecord, Measured, OtherModel, Record,
    SampleUse, identify,
};
use schemars::JsonSchema;
use serde::Serialize;

/// Relative residual, and relative uncertainty, above which a result is a guess.
const GUESS: f64 = 0.2;
/// Standard uncertainties within which a mass agrees: 95 of 100 cases.
const AGREEMENT: f64 = 2.0;
/// Values of a contact beyond which a unit or a column is wrong rather than the contact is unusual: approach speed (m/s), penetration (m),
/// duration (s), and ratio of the identified mass and the expected one.
const MOST_SPEED: f64 = 50.0;
const MOST_PENETRATION: f64 = 0.5;
const MOST_DURATION: f64 = 2.0;
const MOST_MASS_RATIO: f64 = 5.0;
/// Part of the largest force above which forces of the sheet change the result.
const FORCE_BESIDE: f64 = 0.02;
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
    /// Coefficient c of a second term c x^q of the spring, N/m^q; null if the spring has one term.
    pub second_stiffness: Option<Estimate>,
    /// Exponent q of the second term.
    pub second_exponent: Option<f64>,
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
    let in_file = |error| StudyError::input("identify.data", Fault::Table(Box::new(error)));
    let (mut records, mut columns, mut inputs) = (Vec::new(), Vec::new(), Vec::new());
    let (mut diagnostics, mut numbers) = (Vec::new(), 0);
    for (file, path) in asked.data.iter().enumerate() {
        let ReadRecord { record, columns: of_file, input, findings } =
            read_record(path, asked).map_err(in_file)?;
        diagnostics.extend(findings);
        numbers += record.times.len() * (1 + record.signals.len());
        if numbers > MOST_NUMBERS {
            let why =
                format!("more than {MOST_NUMBERS} numbers with this file; cut the files around the impacts");
            return Err(in_file(TableError::in_file(path, why)));
        }
        if inputs.iter().any(|other: &Input| other.sha256 == input.sha256) {
            let why = "it has the contents of another of the files; give each impact once";
            return Err(in_file(TableError::in_file(path, why)));
        }
        records.push(Record { speed: asked.approach_speed(file), ..record });
        columns.push(of_file);
        inputs.push(input);
    }
    let known = asked.known(mass);
    let found = identify(&records, &known).map_err(|error| match error {
        ContactLawError::Record { record: Some(number), why } => {
            in_file(TableError::in_file(&asked.data[number], why))
        }
        ContactLawError::Record { record: None, why } => StudyError::input("identify.data", why),
        error => error.into(),
    })?;
    diagnostics.extend(contradictions(asked, &found));
    diagnostics.extend(guesses(&found));
    diagnostics.extend(weight_finding(asked, &found));
    diagnostics.extend(implausible(&found, mass));
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
        second_stiffness: found.second_term.map(|(stiffness, _)| stiffness),
        second_exponent: found.second_term.map(|(_, exponent)| exponent),
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
    let EvaluatedQuestion { prepared, .. } = &evaluated;
    let mass = finite_mass(&evaluated)?;
    let mut report = identify_contact(asked, Some(mass))?;
    if let Some(compared) = report.compared.as_mut().filter(|compared| compared.agrees == Some(false))
        && let Some(explanation) = explain_parts(&evaluated, question, false)
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
    report.diagnostics.extend(forces_of_sheet(&evaluated, &report));
    report.named_contact = named_contact(&evaluated)?;
    let findings = answer_findings(&evaluated, report.named_contact.as_ref());
    let findings = findings.into_iter().map(DiagnosticRecord::from);
    let own = std::mem::take(&mut report.diagnostics);
    report.diagnostics = model.diagnostics.iter().cloned().chain(findings).chain(own).collect();
    report.inputs.extend(prepared.inputs());
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

/// Values of another model of the contact.
fn values_of(other: &OtherModel) -> String {
    let OtherModel { ratio, mass, speed, restitution, max_penetration, contact_duration } = other;
    format!(
        "with {ratio:.2} times the mean square residual a mass of {mass:.4} kg, a speed of {speed:.4} m/s, a restitution of {restitution:.4}, a \
         penetration of {:.3} mm and a duration of {:.3} ms",
        1e3 * max_penetration,
        1e3 * contact_duration
    )
}

/// Findings about signals from which the identified contact differs by more than noise, and about springs of more than one power.
fn contradictions(asked: &IdentifyQuestion, found: &Identification) -> Vec<DiagnosticRecord> {
    let mut messages = Vec::new();
    for (file, record) in asked.data.iter().zip(&found.records) {
        for signal in &record.signals {
            if signal.contradicts(record.contact_duration.value) || signal.relative_residual > GUESS {
                let (name, _) = signal.quantity.name_and_unit();
                let included = match signal.excess {
                    Some(excess) => format!(
                        "the residuals are {excess:.1} times those before and after the contact, and so are the uncertainties"
                    ),
                    None => "the uncertainties do not include that".to_owned(),
                };
                messages.push(format!(
                    "{file}: the identified contact differs from the {name} by {:.1} % of its largest value; the contact has another law, \
                     something acts beside it, or the data are filtered (give the filter); {included}",
                    100.0 * signal.relative_residual
                ));
            }
        }
    }
    if let Some(other) = &found.other_spring {
        let values = values_of(other);
        messages.push(match found.second_term {
            Some((_, power)) => {
                let power = if power == 1.0 { String::new() } else { format!("^{power}") };
                format!("the spring is k x^p + c x{power}; k x^p alone gives {values}: a law with one power is no law of this contact")
            }
            None => format!("a spring with a second power of the penetration gives {values}; leave out the exponent"),
        });
    }
    if EXPONENTS.end() == &found.exponent.value || EXPONENTS.start() == &found.exponent.value {
        messages.push(format!(
            "the exponent is at an end of the range {} to {} in which it is searched",
            EXPONENTS.start(),
            EXPONENTS.end()
        ));
    }
    let finding = |message| Finding::about_result(FindingKind::LawContradicted, message).into();
    messages.into_iter().map(finding).collect()
}

/// Finding about a weight that is not stated, or contradicts the data.
fn weight_finding(asked: &IdentifyQuestion, found: &Identification) -> Option<DiagnosticRecord> {
    let (is_better, other) = found.other_weight.as_ref()?;
    let is_given = asked.gravity.is_some() || asked.drop.is_some();
    if is_given && !is_better {
        return None;
    }
    let acts = if asked.known(None).gravity == 0.0 { "with the weight" } else { "without the weight" };
    let verdict = if *is_better { "contradict the motion" } else { "do not show whether the weight acts" };
    let remedy = "give --gravity for a body that falls onto the contact, --gravity=0 for a horizontal motion";
    let message = format!("the data {verdict}: {acts} they give {}; {remedy}", values_of(other));
    Some(Finding::about_result(FindingKind::WeightNotGiven, message).into())
}

/// Finding about values that no impact has.
fn implausible(found: &Identification, expected: Option<f64>) -> Option<DiagnosticRecord> {
    let largest = |of: fn(&IdentifiedRecord) -> Estimate| {
        found.records.iter().map(|record| of(record).value).fold(0.0, f64::max)
    };
    let (speed, duration) = (largest(|record| record.speed), largest(|record| record.contact_duration));
    let depth = largest(|record| record.max_penetration);
    let ratio = expected.filter(|_| found.finds_mass).map(|mass| found.mass.value / mass);
    let values = [
        (speed > MOST_SPEED).then(|| format!("an approach speed of {speed:.4} m/s")),
        (depth > MOST_PENETRATION).then(|| format!("a penetration of {depth:.4} m")),
        (duration > MOST_DURATION).then(|| format!("a duration of {duration:.4} s")),
        ratio
            .filter(|ratio| !(1.0 / MOST_MASS_RATIO..MOST_MASS_RATIO).contains(ratio))
            .map(|ratio| format!("a mass of {:.4} kg, {ratio:.4} times the expected one", found.mass.value)),
    ];
    let values: Vec<String> = values.into_iter().flatten().collect();
    let message = format!("the result is implausible: {}; check the units of the columns", values.join(", "));
    (!values.is_empty()).then(|| Finding::about_result(FindingKind::ImplausibleContact, message).into())
}

/// Finding about springs and dampers of the sheet that act during the contact.
fn forces_of_sheet(evaluated: &EvaluatedQuestion, report: &IdentificationReport) -> Option<DiagnosticRecord> {
    let ParallelForces { names, unknown, force } = parallel_forces(evaluated)?;
    let part = |record: &IdentifiedRecord| {
        let (x, v) = (record.max_penetration.value, record.speed.value);
        force(x, 0.0).abs().max(force(0.0, v).abs()) / record.peak_force.value
    };
    let part = report.impacts.iter().map(|impact| part(&impact.identified)).fold(0.0, f64::max);
    if !unknown.is_empty() {
        let message = format!(
            "forces act during the contact and are not in the fit: {}; remove them from the rig",
            unknown.join(", ")
        );
        return Some(Finding::about_result(FindingKind::SpringsAct, message).into());
    }
    let message = format!(
        "springs and dampers of the model act during the contact ({}), with up to {:.0} % of its largest force, and are not in the fit: a \
         measured motion includes them; remove them from the rig, or measure the impact with a speed at which their force is small",
        names.join(", "),
        100.0 * part
    );
    (part > FORCE_BESIDE).then(|| Finding::about_result(FindingKind::SpringsAct, message).into())
}
