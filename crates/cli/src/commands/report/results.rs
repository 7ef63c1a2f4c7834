//! Results of all questions of a study.

use super::bands::{Tolerances, tolerances_of_contacts};
use super::sweep::{SweepSection, run_sweep};
use crate::commands::compare;
use crate::terminal::failure::Failure;
use percuss_study::{
    AskError, DiagnosticRecord, DrawnMechanism, Input, MapResult, MassReport, Names, RequestReport,
    StudyFile, check as check_of, draw_mechanism,
};

/// Results of all questions of a study.
pub(super) struct StudyResults {
    /// Results of all tables except the sweep; the contents of the model also if the study has no contact.
    pub report: RequestReport,
    pub mechanism: DrawnMechanism,
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
        let mut report = study.results(listed, mass, &StudyFile::TABLES)?;
        if report.check.is_none() && !has_contact {
            report.check = Some(check_of(&study.model)?);
        }
        let compared = report.comparison.as_ref();
        let tolerances =
            compared.map_or(Ok(Vec::new()), |compared| tolerances_of_contacts(study, compared))?;
        let sweep = study.tables.sweep.as_ref();
        let sweep = sweep.map(|requested| run_sweep(study, requested, report.mass.as_ref())).transpose()?;
        Ok(Self { report, mechanism, sweep, tolerances })
    }

    /// Input files of all results, without duplicates.
    pub fn inputs(&self) -> Vec<Input> {
        let sweep = self.sweep.iter().flat_map(|sweep| &sweep.inputs);
        let compared =
            self.report.comparison.iter().flat_map(|c| c.designs.iter().flat_map(|design| &design.inputs));
        let mapped = self.report.map.iter().flat_map(MapResult::inputs);
        let speeds = self.report.safe_speed.iter().flatten().flat_map(|report| &report.inputs);
        let own = self.report.mass.iter().flat_map(|mass| &mass.inputs);
        let own = own.chain(self.report.check.iter().flat_map(|contents| &contents.inputs));
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
        let own = own.chain(self.report.check.iter().flat_map(|contents| &contents.diagnostics));
        let own = own.chain(self.report.damping.iter().flat_map(|stop| &stop.diagnostics));
        let own = own.chain(self.report.restitution.iter().flat_map(|report| &report.diagnostics));
        let own = own.chain(self.report.identify.iter().flat_map(|report| &report.diagnostics));
        let own = own.chain(self.report.response.iter().flat_map(|report| &report.diagnostics));
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
}
