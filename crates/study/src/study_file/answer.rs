//! Results of the tables of a study.

use crate::damper::damped_contact::{damp_contact, damp_stop};
use crate::damper::damping::DampingReport;
use crate::map::map_report::MapAnswer;
use crate::map::point_map::{PointMapReport, map_point};
use crate::map::surface_map::map;
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::StudyError;
use crate::question::field::{Field, Names};
use crate::question::mass_question::MassQuestion;
use crate::reports::answer_mass::{mass_with_drawing, requested_mass};
use crate::reports::compare::{CompareError, ComparisonReport, Design, compare};
use crate::reports::contact_list::{ContactListReport, contact_list_of};
use crate::reports::drawing::drawn_mechanism::DrawnMechanism;
use crate::reports::impact::extremes::{ExtremesReport, extremes};
use crate::reports::impact::report::{ImpactReport, impact};
use crate::reports::kinematics::question::KinematicsError;
use crate::reports::kinematics::report::KinematicsReport;
use crate::reports::mass_report::MassReport;
use crate::reports::safe_speed::SafeSpeedReport;
use crate::study_file::file::{StudyFile, StudyFileError, StudySweep};
use crate::study_file::schema::table_keys;
use crate::study_file::tables::map::StudyMapQuestion;
use crate::sweep::sweep_report::SweepReport;
use crate::sweep::sweep_rows::Sweep;
use serde::{Serialize, Serializer};
use std::ops::ControlFlow;

/// Result of a map.
#[derive(Debug)]
pub enum MapResult {
    /// Map of surfaces.
    Surfaces(Box<MapAnswer>),
    /// Directions at a point.
    Directions(Box<PointMapReport>),
}

impl Serialize for MapResult {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Surfaces(answer) => answer.report.serialize(serializer),
            Self::Directions(report) => report.serialize(serializer),
        }
    }
}

impl StudyMapQuestion {
    /// Computes the map.
    ///
    /// # Errors
    /// As for [`map`] and [`map_point`].
    pub fn answer(&self, model: &Model) -> Result<MapResult, StudyError> {
        Ok(match self {
            Self::Surfaces(question) => MapResult::Surfaces(Box::new(map(model, question)?)),
            Self::Directions(question, count) => {
                MapResult::Directions(Box::new(map_point(model, question, *count)?))
            }
        })
    }
}

impl MapResult {
    /// Input files.
    pub fn inputs(&self) -> &[Input] {
        match self {
            Self::Surfaces(answer) => &answer.report.inputs,
            Self::Directions(report) => &report.inputs,
        }
    }

    /// Findings about the file and the results.
    pub fn diagnostics(&self) -> &[DiagnosticRecord] {
        match self {
            Self::Surfaces(answer) => &answer.report.diagnostics,
            Self::Directions(report) => &report.diagnostics,
        }
    }
}

/// Results of all tables of a study. The key of a table is absent if the study does not have the table.
#[derive(Debug, Serialize)]
pub struct RequestReport {
    /// `percuss.report/1`.
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// The contact at its pose, with the results of `[mass]` and the damper of `[damping]`.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass: Option<MassReport>,
    /// Reason for a missing effective mass at the pose, for a study with a sweep or variants.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mass_problem: Option<String>,
    /// All contacts of a study with several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub contacts: Option<ContactListReport>,
    /// Damper at the stop of a joint.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub damping: Option<DampingReport>,
    /// Impact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub impact: Option<ImpactReport>,
    /// Extremes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub extremes: Option<ExtremesReport>,
    /// Rows of the sweep.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sweep: Option<SweepReport>,
    /// Comparison of several contacts and variants.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub comparison: Option<ComparisonReport>,
    /// Kinematics of a suspension.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub kinematics: Option<KinematicsReport>,
    /// Map.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub map: Option<MapResult>,
    /// Safe speeds.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub safe_speed: Option<Vec<SafeSpeedReport>>,
}

impl RequestReport {
    /// JSON text of the report. A number without a value is null.
    pub fn to_json(&self) -> String {
        // Records have text keys and no other source of errors.
        serde_json::to_string(self).unwrap_or_default()
    }
}

impl StudyFile {
    /// Results of all tables. `name`: name of the study's own model in a comparison. For a study with a sweep or variants, a pose without a
    /// result is no error: `mass_problem` has the reason.
    ///
    /// # Errors
    /// The first error of a table.
    pub fn ask(&self, name: &str) -> Result<RequestReport, AskError> {
        let contacts = self.contact_list()?;
        let has_rows = self.sweep.is_some() || !self.variants.is_empty();
        let question = self.detailed_question(contacts.as_ref());
        let (mass, mass_problem) = match self.mass_of(question) {
            Err(error) if has_rows && error.has_no_result() => (None, Some(error.message(Names::KEYS))),
            mass => (mass?, None),
        };
        Ok(RequestReport {
            schema: "percuss.report/1",
            percuss: env!("CARGO_PKG_VERSION"),
            mass,
            mass_problem,
            damping: self.stop_damper()?,
            impact: self.impact_report(question)?,
            extremes: self.extremes_report(question)?,
            contacts,
            sweep: self.sweep_report()?,
            comparison: self.comparison(name)?,
            kinematics: self.kinematics_report()?,
            map: self.map_result()?,
            safe_speed: self.safe_speeds()?,
        })
    }

    /// Question of the details of a report: that of the first of several contacts with a result.
    pub fn detailed_question(&self, contacts: Option<&ContactListReport>) -> Option<&MassQuestion> {
        let first = contacts.and_then(|list| list.contacts.iter().find(|contact| contact.report.is_some()));
        let first = first.and_then(|first| self.contacts.iter().find(|contact| contact.name == first.name));
        first.map(|contact| &contact.question).or(self.question.as_ref())
    }

    /// Effective mass at a contact, with the results of `[mass]` and `[damping]`.
    fn mass_of(&self, question: Option<&MassQuestion>) -> Result<Option<MassReport>, StudyError> {
        let damping = self.damping.as_ref().map(|damping| &damping.question);
        question
            .map(|question| requested_mass(&self.model, question, damping, &self.mass))
            .transpose()
            .map_err(|error| error.in_table(table_keys("mass")))
    }

    /// Effective mass at the contact of the study, with the results of `[mass]` and `[damping]`.
    ///
    /// # Errors
    /// As for [`requested_mass`].
    pub fn mass_report(&self) -> Result<Option<MassReport>, StudyError> {
        self.mass_of(self.question.as_ref())
    }

    /// Effective mass as in [`mass_report`](Self::mass_report), at a contact of the study, with the drawing of the mechanism.
    ///
    /// # Errors
    /// As for [`requested_mass`].
    pub fn mass_with_drawing(
        &self,
        question: &MassQuestion,
    ) -> Result<(MassReport, DrawnMechanism), StudyError> {
        let damping = self.damping.as_ref().map(|damping| &damping.question);
        mass_with_drawing(&self.model, question, damping, &self.mass)
            .map_err(|error| error.in_table(table_keys("mass")))
    }

    /// All contacts of a study with several, each with its damper.
    ///
    /// # Errors
    /// As for [`contact_list_of`].
    pub fn contact_list(&self) -> Result<Option<ContactListReport>, StudyError> {
        if self.contacts.is_empty() {
            return Ok(None);
        }
        let contacts: Vec<(String, MassQuestion)> =
            self.contacts.iter().map(|contact| (contact.name.clone(), contact.question.clone())).collect();
        let damping = self.damping.as_ref().map(|damping| &damping.question);
        contact_list_of(&self.model, &contacts, damping).map(Some)
    }

    /// Damper of `[damping]`: at the stop of a joint if the table names one, otherwise at the contact.
    ///
    /// # Errors
    /// As for [`damp_stop`] and [`damp_contact`].
    pub fn damper(&self) -> Result<Option<DampingReport>, StudyError> {
        let Some(damping) = &self.damping else { return Ok(None) };
        let report = match (&damping.stop, &self.question) {
            (Some((stop, conditions)), _) => {
                damp_stop(&self.model, stop, conditions.clone(), &damping.question)
            }
            (None, Some(contact)) => damp_contact(&self.model, contact, &damping.question),
            (None, None) => return Ok(None),
        };
        report.map(Some).map_err(|error| error.in_table(table_keys("damping")))
    }

    /// Damper at the stop of a joint.
    ///
    /// # Errors
    /// As for [`damp_stop`].
    pub fn stop_damper(&self) -> Result<Option<DampingReport>, StudyError> {
        if self.damping.as_ref().is_some_and(|damping| damping.stop.is_some()) {
            self.damper()
        } else {
            Ok(None)
        }
    }

    /// Impact at a contact of the study.
    ///
    /// # Errors
    /// As for [`impact`].
    pub fn impact_report(&self, question: Option<&MassQuestion>) -> Result<Option<ImpactReport>, StudyError> {
        let requested = question.zip(self.impact.as_ref());
        requested
            .map(|(question, requested)| impact(&self.model, question, requested))
            .transpose()
            .map_err(|error| error.in_table(table_keys("impact")))
    }

    /// Extremes at a contact of the study.
    ///
    /// # Errors
    /// As for [`extremes`].
    pub fn extremes_report(
        &self,
        question: Option<&MassQuestion>,
    ) -> Result<Option<ExtremesReport>, StudyError> {
        let requested = question.zip(self.extremes.as_ref());
        requested
            .map(|(question, requested)| extremes(&self.model, question, requested))
            .transpose()
            .map_err(|error| error.in_table(table_keys("extremes")))
    }

    /// Sweep of a study, ready to run, with the gradients that it requests. `question`: that of its rows,
    /// [`question_of_rows`](Self::question_of_rows).
    ///
    /// # Errors
    /// As for [`Sweep::new`].
    pub fn prepared_sweep<'a>(
        &'a self,
        requested: &StudySweep,
        question: &'a MassQuestion,
    ) -> Result<Sweep<'a>, StudyError> {
        let sweep = Sweep::new(&self.model, question, &requested.rows);
        let sweep = sweep.map_err(|error| error.in_table(table_keys("sweep")))?;
        Ok(if requested.gradient { sweep.with_gradient() } else { sweep })
    }

    /// All rows of the sweep at the contact of the study.
    ///
    /// # Errors
    /// As for [`Sweep::new`].
    pub fn sweep_report(&self) -> Result<Option<SweepReport>, StudyError> {
        let Some((requested, question)) = self.sweep.as_ref().zip(self.question.as_ref()) else {
            return Ok(None);
        };
        let question = self.question_of_rows(question);
        let sweep = self.prepared_sweep(requested, &question)?;
        let heading = sweep.heading().clone();
        let mut rows = Vec::new();
        let end = sweep.run(&mut |row| {
            rows.push(row);
            ControlFlow::Continue(())
        });
        let end = end.map_err(|error| error.in_table(table_keys("sweep")))?;
        let diagnostics = self.model.diagnostics.iter().cloned().chain(end.diagnostics).collect();
        Ok(Some(SweepReport { heading, rows, diagnostics }))
    }

    /// Comparison of the contacts and variants of the study, whose own model has the name `name`.
    ///
    /// # Errors
    /// As for [`compare`].
    pub fn comparison(&self, name: &str) -> Result<Option<ComparisonReport>, CompareError> {
        if self.variants.is_empty() && self.contacts.is_empty() {
            return Ok(None);
        }
        self.compare(&self.designs(name)).map(Some)
    }

    /// Comparison of the [designs](Self::designs). An error has the key at fault, such as `variant[0].set`.
    ///
    /// # Errors
    /// As for [`compare`].
    pub fn compare(&self, designs: &[Design]) -> Result<ComparisonReport, CompareError> {
        compare(designs).map_err(|error| match error {
            CompareError::Question { design, source, .. } => {
                let is_of = |name: &str| {
                    design.strip_prefix(name).is_some_and(|rest| rest.is_empty() || rest.starts_with(": "))
                };
                let number = self.variants.iter().position(|variant| is_of(&variant.name));
                let key = source.key().map(|key| self.keys.of_variant(number, &key));
                CompareError::Question { design, source, key }
            }
            other => other,
        })
    }

    /// Kinematics of `[kinematics]`.
    ///
    /// # Errors
    /// As for [`kinematics`](crate::kinematics).
    pub fn kinematics_report(&self) -> Result<Option<KinematicsReport>, KinematicsError> {
        self.kinematics.as_ref().map(|requested| requested.report(&self.model)).transpose()
    }

    /// Map of `[map]`.
    ///
    /// # Errors
    /// As for [`map`] and [`map_point`].
    pub fn map_result(&self) -> Result<Option<MapResult>, StudyError> {
        let found = self.map.as_ref().map(|requested| requested.question.answer(&self.model)).transpose();
        // The contact gives the link and the point that the table does not have.
        let is_of_map = |keys: [&str; 2]| keys.iter().any(|key| self.keys.contains(key));
        let of_map = |field| match field {
            Field::Link if is_of_map(["map.link", "map.all"]) => Field::MapLink,
            Field::Point if is_of_map(["map.point"; 2]) => Field::MapPoint,
            other => other,
        };
        found.map_err(|error| error.with_field(of_map).in_table(table_keys("map")))
    }

    /// Safe speeds of `[safe_speed]`.
    ///
    /// # Errors
    /// As for [`StudySafeSpeed::reports`](crate::StudySafeSpeed::reports).
    pub fn safe_speeds(&self) -> Result<Option<Vec<SafeSpeedReport>>, StudyError> {
        let found = self.safe_speed.as_ref().map(|requested| requested.reports(&self.model)).transpose();
        found.map_err(|error| error.in_table(table_keys("safe_speed")))
    }
}

/// Error of a table of a study.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum AskError {
    /// Invalid request.
    #[error(transparent)]
    Request(#[from] StudyFileError),
    /// Error of a question.
    #[error(transparent)]
    Question(#[from] StudyError),
    /// Error of the comparison.
    #[error(transparent)]
    Comparison(#[from] CompareError),
    /// Error of the kinematics.
    #[error(transparent)]
    Kinematics(#[from] KinematicsError),
}

impl AskError {
    /// True if the question is valid but has no result.
    pub fn has_no_result(&self) -> bool {
        match self {
            Self::Question(error)
            | Self::Comparison(CompareError::Question { source: error, .. })
            | Self::Kinematics(KinematicsError::Study(error)) => error.has_no_result(),
            _ => false,
        }
    }

    /// Message with the keys of the request.
    pub fn message(&self) -> String {
        match self {
            Self::Request(StudyFileError::Value { key, why, .. }) => format!("{key}: {why}"),
            Self::Question(error) | Self::Kinematics(KinematicsError::Study(error)) => {
                error.message(Names::KEYS)
            }
            Self::Comparison(error) => error.message(Names::KEYS),
            other => other.to_string(),
        }
    }
}
