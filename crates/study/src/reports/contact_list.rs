//! Effective masses at all named contacts of a model.

use crate::checks::finding::Finding;
use crate::checks::finding_kind::FindingKind;
use crate::damper::sheet_forces::sheet_curve;
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::tables::damping::DampingQuestion;
use crate::question::tables::mass::MassOptions;
use crate::reports::answer_mass::{mass, requested_mass};
use crate::reports::mass_report::MassReport;
use percuss_mechanism::{ContactKind, Mechanism, NamedContact};
use schemars::JsonSchema;
use serde::Serialize;

/// Effective masses at all named contacts, as JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ContactListReport {
    /// `percuss.contacts/1`.
    #[schemars(extend("const" = "percuss.contacts/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files.
    pub inputs: Vec<Input>,
    /// The contacts: stops, springs, dampers, contact patches, others; for a study, in the order of its contacts.
    pub contacts: Vec<ListedContact>,
    /// Findings about the file and the results; a finding about one contact begins with its name.
    pub diagnostics: Vec<DiagnosticRecord>,
}

impl ContactListReport {
    /// First contact with a result: that of the details of a report.
    pub fn first_with_result(&self) -> Option<&ListedContact> {
        self.contacts.iter().find(|contact| contact.report.is_some())
    }
}

/// Named contact with its result.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ListedContact {
    /// Name.
    pub name: String,
    /// `stop`, `spring`, `damper`, `patch` or `other`.
    pub kind: &'static str,
    /// Result; null if the contact has none.
    pub report: Option<MassReport>,
    /// Reason for a missing result.
    pub problem: Option<String>,
    /// Smallest gap of a stop that cannot be reached, m, if known.
    pub remaining_gap: Option<f64>,
}

/// All named contacts of a model: stops, seats of springs, mounts of dampers, contact patches, others; contacts of one kind in the
/// order of the model.
pub(crate) fn contacts_by_kind(mechanism: &Mechanism) -> Vec<&NamedContact> {
    let mut contacts: Vec<&NamedContact> = mechanism.contacts().iter().collect();
    contacts.sort_by_key(|contact| contact.kind());
    contacts
}

/// Evaluates all named contacts of a model under the conditions of a question.
///
/// # Errors
/// [`StudyError`]: a model without named contacts; invalid conditions. A contact without a result, such as a stop that
/// the mechanism does not reach, is a row of the list.
pub fn contact_list(
    model: &Model,
    conditions: &MassQuestion,
    damping: Option<&DampingQuestion>,
) -> Result<ContactListReport, StudyError> {
    let contacts = model.mechanism.contacts();
    if contacts.is_empty() {
        let why = "the model names no contact; a suspension sheet names its stops, springs and dampers, a URDF names contacts by \
                   <contact> elements, an MJCF by its sites; give link, point and normal instead";
        return Err(StudyError::input("contact.at", why));
    }
    let question = |name: &str| (name.to_owned(), conditions.at_contact(name));
    let contacts: Vec<_> =
        contacts_by_kind(&model.mechanism).into_iter().map(|contact| question(contact.name())).collect();
    contact_list_of(model, &contacts, damping)
}

/// Evaluates several contacts of a model: names and questions.
///
/// # Errors
/// [`StudyError`]: an invalid question. A contact without a result is a row of the list.
pub fn contact_list_of(
    model: &Model,
    contacts: &[(String, MassQuestion)],
    damping: Option<&DampingQuestion>,
) -> Result<ContactListReport, StudyError> {
    let mut found: Vec<(&String, DiagnosticRecord)> = Vec::new();
    let mut listed = Vec::with_capacity(contacts.len());
    let curves = contacts.iter().map(|(_, question)| Ok(sheet_curve(model, question)?.is_some()));
    let curves = curves.collect::<Result<Vec<bool>, StudyError>>()?;
    // Without a stiffness, the contacts with a curve of the sheet have a damper.
    let needs_curve = damping.is_some_and(|damping| !damping.has_stiffness()) && curves.contains(&true);
    for ((name, question), has_curve) in contacts.iter().zip(curves) {
        let kind =
            question.named_contact(&model.mechanism)?.map_or(ContactKind::Other, |contact| contact.kind());
        let always_touches = matches!(kind, ContactKind::Spring | ContactKind::Damper);
        // No impact occurs between parts that always touch.
        let is_soft = !needs_curve || has_curve;
        if !always_touches && !is_soft {
            let message = "no damper: the sheet has no force curve of this contact; give a stiffness, or its deflections and forces";
            found.push((name, Finding::about_result(FindingKind::NoDamper, message.to_owned()).into()));
        }
        let answer = match damping.filter(|_| !always_touches && is_soft) {
            Some(damping) => requested_mass(model, question, Some(damping), &MassOptions::default()),
            None => mass(model, question),
        };
        let remaining_gap = match &answer {
            Err(StudyError::StopNotReached { gap, nearest: Some(closed), .. }) => Some(gap - closed),
            _ => None,
        };
        let (report, problem) = match answer {
            Ok(mut report) => {
                let of_contact = std::mem::take(&mut report.diagnostics).into_iter();
                found.extend(
                    of_contact.filter(|found| !model.diagnostics.contains(found)).map(|found| (name, found)),
                );
                (Some(report), None)
            }
            Err(error) if error.has_no_result() => (None, Some(error.message(question.names))),
            Err(error) => return Err(error),
        };
        listed.push(ListedContact { name: name.clone(), kind: kind.name(), report, problem, remaining_gap });
    }
    let answered = listed.iter().filter(|contact| contact.report.is_some()).count();
    Ok(ContactListReport {
        schema: "percuss.contacts/1",
        percuss: env!("CARGO_PKG_VERSION"),
        inputs: model.inputs.clone(),
        contacts: listed,
        diagnostics: merge_findings(model.diagnostics.clone(), &found, answered),
    })
}

/// Adds the findings of the contacts to those of the model, without duplicates. A finding that all contacts with a result share keeps its
/// message; any other message begins with the names of its contacts. `answered`: number of contacts with a result.
fn merge_findings(
    mut all: Vec<DiagnosticRecord>,
    found: &[(&String, DiagnosticRecord)],
    answered: usize,
) -> Vec<DiagnosticRecord> {
    for (_, record) in found {
        let alike = found.iter().filter(|(_, other)| other == record);
        let names: Vec<&str> = alike.map(|(name, _)| name.as_str()).collect();
        let is_shared = answered > 1 && names.len() == answered;
        let message = if is_shared {
            record.message.clone()
        } else {
            format!("{}: {}", names.join(", "), record.message)
        };
        let record = DiagnosticRecord { message, ..record.clone() };
        if !all.contains(&record) {
            all.push(record);
        }
    }
    all
}
