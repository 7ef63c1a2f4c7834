//! Results of all questions of a study.

use super::bands::{Tolerances, tolerances_of_contacts};
use super::sweep::{SweepSection, run_sweep};
use crate::commands::compare;
use crate::commands::impacts::safe_speed;
use crate::terminal::failure::Failure;
use percuss_study::{
    AskError, CheckReport, ContactListReport, DiagnosticRecord, DrawnMechanism, Input, MapResult, MassReport,
    Names, RequestReport, StudyAdditions, StudyFile, WithAdditions, check as check_of, draw_mechanism,
};

/// Name of the first contact of a list with a result: the contact of the details of a report.
pub(super) fn first_with_result(listed: &ContactListReport) -> Option<&str> {
    let first = listed.contacts.iter().find(|contact| contact.report.is_some());
    first.map(|contact| contact.name.as_str())
}

/// Results of all questions of a study.
pub(super) struct StudyResults {
    /// Results of all tables except the sweep.
    pub report: RequestReport,
    pub mechanism: DrawnMechanism,
    /// Contents of the model, if the study requests them or has no contact.
    pub contents: Option<CheckReport>,
    pub sweep: Option<SweepSection>,
    /// Tolerances over the rows at each of several contacts.
    pub tolerances: Vec<Tolerances>,
}

impl From<AskError> for Failure {
    fn from(error: AskError) -> Self {
        match error {
            AskError::Request(error) => error.into(),
            AskError::Question(error) => error.into(),
            AskError::Kinematics(error) => error.into(),
            AskError::Code(error) => error.into(),
            AskError::Conversion(error) => error.into(),
            AskError::Export(error) => error.into(),
            AskError::Comparison(error) => compare::failure(&error, Names::KEYS),
            other => Failure::bad_input(other.to_string()),
        }
    }
}

impl StudyResults {
    /// Computes the results of all questions of a study.
    pub fn from_study(study: &StudyFile) -> Result<Self, Failure> {
        let listed = study.contact_list()?;
        let (mass, drawn) = study.mass_with_drawing(study.detailed_question(listed.as_ref()))?.unzip();
        let has_contact = drawn.is_some();
        let mechanism = drawn.map_or_else(|| draw_mechanism(&study.model, &study.conditions), Ok)?;
        let mut report = study.results(listed, mass)?;
        let contents = match report.check.take() {
            None if !has_contact => Some(check_of(&study.model)?),
            requested => requested,
        };
        let compared = report.comparison.as_ref();
        let tolerances =
            compared.map_or(Ok(Vec::new()), |compared| tolerances_of_contacts(study, compared))?;
        let sweep = study.tables.sweep.as_ref();
        let sweep = sweep.map(|requested| run_sweep(study, requested, report.mass.as_ref())).transpose()?;
        Ok(Self { report, mechanism, contents, sweep, tolerances })
    }

    /// Input files of all results, without duplicates.
    pub fn inputs(&self) -> Vec<Input> {
        let sweep = self.sweep.iter().flat_map(|sweep| &sweep.inputs);
        let compared =
            self.report.comparison.iter().flat_map(|c| c.designs.iter().flat_map(|design| &design.inputs));
        let mapped = self.report.map.iter().flat_map(MapResult::inputs);
        let speeds = self.report.safe_speed.iter().flatten().flat_map(|report| &report.inputs);
        let own = self.report.mass.iter().flat_map(|mass| &mass.inputs);
        let own = own.chain(self.contents.iter().flat_map(|contents| &contents.inputs));
        let own = own.chain(self.report.damping.iter().flat_map(|stop| &stop.inputs));
        let all = own.chain(&self.mechanism.meshes).chain(sweep).chain(compared);
        let mut each: Vec<Input> = Vec::new();
        for input in all.chain(mapped).chain(speeds) {
            if !each.contains(input) {
                each.push(input.clone());
            }
        }
        each
    }

    /// True if the study has several contacts, which are compared over the rows of its sweep.
    pub fn has_several_contacts(&self) -> bool {
        self.report.comparison.as_ref().is_some_and(compare::has_several_contacts)
    }

    /// Findings about the result of a contact that the list of several contacts does not have. Messages of the list may begin with the
    /// names of contacts. Findings with a path of a file are always returned.
    pub fn unlisted<'m>(&self, mass: &'m MassReport) -> Vec<&'m DiagnosticRecord> {
        let listed = self.report.contacts.iter().flat_map(|listed| &listed.diagnostics);
        let listed: Vec<&str> = listed.map(|record| record.message.as_str()).collect();
        let is_listed = |record: &DiagnosticRecord| {
            let named = format!(": {}", record.message);
            listed.iter().any(|message| *message == record.message || message.ends_with(&named))
        };
        mass.diagnostics.iter().filter(|record| record.path.is_some() || !is_listed(record)).collect()
    }

    /// Diagnostics of all results, without duplicates.
    pub fn diagnostics(&self) -> Vec<DiagnosticRecord> {
        // The comparison has the findings of all contacts over the rows.
        let sweep = self.sweep.iter().filter(|_| !self.has_several_contacts());
        let sweep = sweep.flat_map(|sweep| &sweep.end.diagnostics);
        let compared = self.report.comparison.iter().flat_map(|compared| &compared.diagnostics);
        let mapped = self.report.map.iter().flat_map(MapResult::diagnostics);
        let speeds = self.report.safe_speed.iter().flatten().flat_map(|report| &report.diagnostics);
        let own = self.report.mass.iter().flat_map(|mass| self.unlisted(mass));
        let own = own.chain(self.report.contacts.iter().flat_map(|listed| &listed.diagnostics));
        let own = own.chain(self.contents.iter().flat_map(|contents| &contents.diagnostics));
        let own = own.chain(self.report.damping.iter().flat_map(|stop| &stop.diagnostics));
        let own = own.chain(self.report.restitution.iter().flat_map(|report| &report.diagnostics));
        let own = own.chain(self.report.identify.iter().flat_map(|report| &report.diagnostics));
        let own = own.chain(self.report.impact.iter().flat_map(|impact| &impact.diagnostics));
        let own = own.chain(self.report.extremes.iter().flat_map(|extremes| &extremes.diagnostics));
        let own = own.chain(self.report.kinematics.iter().flat_map(|kinematics| &kinematics.diagnostics));
        let all = own.chain(&self.mechanism.diagnostics).chain(sweep);
        let mut each: Vec<DiagnosticRecord> = Vec::new();
        for record in all.chain(compared).chain(mapped).chain(speeds) {
            if !each.contains(record) {
                each.push(record.clone());
            }
        }
        each
    }

    /// JSON of the accompanying file, as with --format json: the result of the contact, otherwise of the stop, map or
    /// safe speed.
    pub fn json(&self) -> Result<String, Failure> {
        let text = match (&self.report.mass, &self.report.damping, &self.report.map, &self.report.safe_speed)
        {
            (Some(_), ..) if self.report.contacts.is_some() => {
                serde_json::to_string_pretty(&self.report.contacts)
            }
            (Some(mass), ..) => {
                let additions = StudyAdditions {
                    impact: self.report.impact.clone(),
                    extremes: self.report.extremes.clone(),
                };
                serde_json::to_string_pretty(&WithAdditions { report: mass, additions: &additions })
            }
            (None, Some(stop), ..) => serde_json::to_string_pretty(stop),
            (None, None, Some(mapped), _) => serde_json::to_string_pretty(mapped),
            (None, None, None, Some(reports)) if reports.len() > 1 => serde_json::to_string_pretty(reports),
            (None, None, None, Some(reports)) => serde_json::to_string_pretty(safe_speed::slowest(reports)),
            // The parser of studies refuses a study without any question.
            (None, None, None, None) => serde_json::to_string_pretty(&self.contents),
        };
        let text = text.map_err(|error| Failure::NoAnswer(format!("the result has no JSON form: {error}")));
        text.map(|text| text + "\n")
    }
}
