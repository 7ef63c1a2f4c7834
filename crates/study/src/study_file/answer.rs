//! Results of the tables of a study.

use crate::checks::model_check::{CheckReport, check};
use crate::damper::damped_contact::{damp_contact, damp_stop};
use crate::damper::damping::DampingReport;
use crate::damper::restitution::{RestitutionReport, restitution_at};
use crate::map::map_report::{MapAnswer, MapReport};
use crate::map::point_map::{PointMapReport, map_point};
use crate::map::surface_map::map;
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::StudyError;
use crate::question::field::{Field, Names};
use crate::question::mass_question::MassQuestion;
use crate::question::tables::map::MapQuestion;
use crate::question::tables::sweep::SweepQuestion;
use crate::reports::answer_mass::{mass_with_drawing, requested_mass};
use crate::reports::compare::{CompareError, ComparisonReport, Design, compare};
use crate::reports::contact_list::{ContactListReport, contact_list_of};
use crate::reports::drawing::drawn_mechanism::DrawnMechanism;
use crate::reports::exports::code::{CodeError, CodeReport, generate_code};
use crate::reports::exports::conversion::{ConversionError, ConversionReport, convert};
use crate::reports::exports::impact::{ImpactExportError, export};
use crate::reports::exports::impact_report::ExportReport;
use crate::reports::impact::extremes::{ExtremesReport, extremes};
use crate::reports::impact::identification::{IdentificationReport, identify_contact_of};
use crate::reports::impact::reflected::ReflectedReport;
use crate::reports::impact::report::{ImpactReport, impact};
use crate::reports::kinematics::errors::KinematicsError;
use crate::reports::kinematics::report::{KinematicsReport, kinematics};
use crate::reports::kinematics::target_search::TargetReport;
use crate::reports::mass_report::MassReport;
use crate::reports::safe_speed::{SafeSpeedReport, safe_speeds};
use crate::study_file::file::{StudyFile, StudyFileError};
use crate::study_file::schema::table_keys;
use crate::sweep::sweep_report::SweepReport;
use crate::sweep::sweep_rows::Sweep;
use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde::{Serialize, Serializer};
use serde_json::Value;

/// Result of a map.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(untagged)]
pub enum MapResult {
    /// Map of surfaces; its report in JSON.
    Surfaces(
        #[serde(serialize_with = "without_facets")]
        #[schemars(with = "MapReport")]
        Box<MapAnswer>,
    ),
    /// Directions at a point.
    Directions(Box<PointMapReport>),
}

/// Serializes the report of a map.
fn without_facets<S: Serializer>(answer: &MapAnswer, serializer: S) -> Result<S::Ok, S::Error> {
    answer.report.serialize(serializer)
}

/// Map of surfaces, or of directions at a point. `contact`: pose, conditions and other side, and the point if `question` has none.
///
/// # Errors
/// As for [`map`] and [`map_point`].
pub fn requested_map(
    model: &Model,
    contact: &MassQuestion,
    question: &MapQuestion,
) -> Result<MapResult, StudyError> {
    Ok(match question.directions {
        None => MapResult::Surfaces(Box::new(map(model, contact, question)?)),
        Some(count) => {
            MapResult::Directions(Box::new(map_point(model, &question.point_question(contact), count)?))
        }
    })
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
#[derive(Debug, Serialize, JsonSchema)]
pub struct RequestReport {
    /// `percuss.report/1`.
    #[schemars(extend("const" = "percuss.report/1"))]
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
    /// Restitution of a spring and damper.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub restitution: Option<RestitutionReport>,
    /// Contact of measured impacts.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub identify: Option<IdentificationReport>,
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
    /// Contents of the model.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub check: Option<CheckReport>,
    /// Source code of the effective mass at the contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub generate: Option<CodeReport>,
    /// The model in another format.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub convert: Option<ConversionReport>,
    /// The impact as a model for MuJoCo.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub export: Option<ExportReport>,
}

impl RequestReport {
    /// JSON text of the report. A number without a value is null.
    pub fn to_json(&self) -> String {
        // Records have text keys and no other source of errors.
        serde_json::to_string(self).unwrap_or_default()
    }
}

/// Answer of a table of a study; `None` without its question. An error names the keys of the table.
fn of_table<Q, T>(
    table: &str,
    question: Option<Q>,
    answer: impl FnOnce(Q) -> Result<T, StudyError>,
) -> Result<Option<T>, StudyError> {
    question.map(answer).transpose().map_err(|error| error.in_table(table_keys(table)))
}

/// JSON schema (draft 2020-12) of the reports, each with all of its records as `$defs`.
pub fn report_schema() -> Value {
    let mut generator = SchemaSettings::draft2020_12().for_serialize().into_generator();
    let reports = [
        generator.subschema_for::<RequestReport>(),
        generator.subschema_for::<MassReport>(),
        generator.subschema_for::<ContactListReport>(),
        generator.subschema_for::<DampingReport>(),
        generator.subschema_for::<RestitutionReport>(),
        generator.subschema_for::<IdentificationReport>(),
        generator.subschema_for::<ImpactReport>(),
        generator.subschema_for::<ExtremesReport>(),
        generator.subschema_for::<ReflectedReport>(),
        generator.subschema_for::<SweepReport>(),
        generator.subschema_for::<ComparisonReport>(),
        generator.subschema_for::<KinematicsReport>(),
        generator.subschema_for::<TargetReport>(),
        generator.subschema_for::<MapAnswer>(),
        generator.subschema_for::<MapReport>(),
        generator.subschema_for::<PointMapReport>(),
        generator.subschema_for::<SafeSpeedReport>(),
        generator.subschema_for::<Vec<SafeSpeedReport>>(),
        generator.subschema_for::<CheckReport>(),
        generator.subschema_for::<ConversionReport>(),
        generator.subschema_for::<ExportReport>(),
        generator.subschema_for::<CodeReport>(),
    ];
    serde_json::json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Report of percuss",
        "anyOf": reports,
        "$defs": generator.take_definitions(true),
    })
}

impl StudyFile {
    /// Results of all tables. For a study with a sweep or variants, a pose without a result is no error: `mass_problem` has the reason.
    ///
    /// # Errors
    /// The first error of a table.
    pub fn ask(&self) -> Result<RequestReport, AskError> {
        let contacts = self.contact_list()?;
        let has_rows = self.tables.sweep.is_some() || !self.variants.is_empty();
        let (mass, mass_problem) = match self.mass_of(self.detailed_question(contacts.as_ref())) {
            Err(error) if has_rows && error.has_no_result() => (None, Some(error.message(Names::KEYS))),
            mass => (mass?, None),
        };
        let report = self.results(contacts, mass)?;
        Ok(RequestReport { mass_problem, sweep: self.sweep_report()?, ..report })
    }

    /// Results of all tables except the sweep, with the list of contacts and the result at the contact that are computed before.
    ///
    /// # Errors
    /// The first error of a table.
    pub fn results(
        &self,
        contacts: Option<ContactListReport>,
        mass: Option<MassReport>,
    ) -> Result<RequestReport, AskError> {
        let question = self.detailed_question(contacts.as_ref());
        Ok(RequestReport {
            schema: "percuss.report/1",
            percuss: env!("CARGO_PKG_VERSION"),
            mass,
            mass_problem: None,
            damping: self.stop_damper()?,
            restitution: self.restitution_report(question)?,
            identify: self.identification_report(question)?,
            impact: self.impact_report(question)?,
            extremes: self.extremes_report(question)?,
            contacts,
            sweep: None,
            comparison: self.comparison()?,
            kinematics: self.kinematics_report()?,
            map: self.map_result()?,
            safe_speed: self.safe_speeds()?,
            check: self.check_report()?,
            generate: self.generated_code()?,
            convert: self.conversion()?,
            export: self.exported_impact()?,
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
        let damping = self.tables.damping.as_ref();
        of_table("mass", question, |question| requested_mass(&self.model, question, damping, &self.mass))
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
        question: Option<&MassQuestion>,
    ) -> Result<Option<(MassReport, DrawnMechanism)>, StudyError> {
        let damping = self.tables.damping.as_ref();
        of_table("mass", question, |question| mass_with_drawing(&self.model, question, damping, &self.mass))
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
        contact_list_of(&self.model, &contacts, self.tables.damping.as_ref()).map(Some)
    }

    /// Damper of `[damping]`: at the stop of a joint if the table names one, otherwise at the contact.
    ///
    /// # Errors
    /// As for [`damp_stop`] and [`damp_contact`].
    pub fn damper(&self) -> Result<Option<DampingReport>, StudyError> {
        match (self.stop_damper()?, &self.question) {
            (None, Some(contact)) => of_table("damping", self.tables.damping.as_ref(), |damping| {
                damp_contact(&self.model, contact, damping)
            }),
            (found, _) => Ok(found),
        }
    }

    /// Damper at the stop of a joint.
    ///
    /// # Errors
    /// As for [`damp_stop`].
    pub fn stop_damper(&self) -> Result<Option<DampingReport>, StudyError> {
        let stop = self.tables.damping.as_ref().and_then(|damping| Some((damping, damping.limit.as_ref()?)));
        of_table("damping", stop, |(damping, stop)| {
            damp_stop(&self.model, stop, self.conditions.clone(), damping)
        })
    }

    /// Restitution of a spring and damper at a contact of the study.
    ///
    /// # Errors
    /// As for [`restitution_at`].
    pub fn restitution_report(
        &self,
        question: Option<&MassQuestion>,
    ) -> Result<Option<RestitutionReport>, StudyError> {
        of_table("restitution", question.zip(self.tables.restitution.as_ref()), |(question, asked)| {
            restitution_at(&self.model, question, asked)
        })
    }

    /// Contact of measured impacts, compared with the effective mass at a contact of the study.
    ///
    /// # Errors
    /// As for [`identify_contact_of`].
    pub fn identification_report(
        &self,
        question: Option<&MassQuestion>,
    ) -> Result<Option<IdentificationReport>, StudyError> {
        of_table("identify", question.zip(self.tables.identify.as_ref()), |(question, asked)| {
            identify_contact_of(&self.model, question, asked)
        })
    }

    /// Impact at a contact of the study.
    ///
    /// # Errors
    /// As for [`impact`].
    pub fn impact_report(&self, question: Option<&MassQuestion>) -> Result<Option<ImpactReport>, StudyError> {
        of_table("impact", question.zip(self.tables.impact.as_ref()), |(question, asked)| {
            impact(&self.model, question, asked)
        })
    }

    /// Extremes at a contact of the study.
    ///
    /// # Errors
    /// As for [`extremes`].
    pub fn extremes_report(
        &self,
        question: Option<&MassQuestion>,
    ) -> Result<Option<ExtremesReport>, StudyError> {
        of_table("extremes", question.zip(self.tables.extremes.as_ref()), |(question, asked)| {
            extremes(&self.model, question, asked)
        })
    }

    /// Sweep of a study, ready to run, with the gradients that it requests. `question`: that of its rows,
    /// [`question_of_rows`](Self::question_of_rows).
    ///
    /// # Errors
    /// As for [`Sweep::new`].
    pub fn prepared_sweep<'a>(
        &'a self,
        requested: &SweepQuestion,
        question: &'a MassQuestion,
    ) -> Result<Sweep<'a>, StudyError> {
        let sweep = Sweep::new(&self.model, question, requested.rows());
        let sweep = sweep.map_err(|error| error.in_table(table_keys("sweep")))?;
        Ok(if requested.gradient { sweep.with_gradient() } else { sweep })
    }

    /// All rows of the sweep at the contact of the study.
    ///
    /// # Errors
    /// As for [`Sweep::new`].
    pub fn sweep_report(&self) -> Result<Option<SweepReport>, StudyError> {
        of_table("sweep", self.tables.sweep.as_ref().zip(self.question.as_ref()), |(requested, question)| {
            let question = self.question_of_rows(question);
            self.prepared_sweep(requested, &question)?.report()
        })
    }

    /// Comparison of the contacts and variants of the study.
    ///
    /// # Errors
    /// As for [`compare`].
    pub fn comparison(&self) -> Result<Option<ComparisonReport>, CompareError> {
        if self.variants.is_empty() && self.contacts.is_empty() {
            return Ok(None);
        }
        self.compare(&self.designs()).map(Some)
    }

    /// Comparison of the [designs](Self::designs). An error has the key at fault, such as `variant[0].set`.
    ///
    /// # Errors
    /// As for [`compare`].
    pub fn compare(&self, designs: &[Design]) -> Result<ComparisonReport, CompareError> {
        compare(designs).map_err(|error| self.with_key(error, 0))
    }

    /// Error of a comparison with the key at fault. `first`: number of the first of the [designs](Self::designs) in the comparison.
    pub fn with_key(&self, error: CompareError, first: usize) -> CompareError {
        match error {
            CompareError::Question { design, number, source, .. } => {
                let variant = number.checked_sub(first).and_then(|number| self.variant_of_design(number));
                let key = source.key().map(|key| self.keys.of_variant(variant, &key).into());
                CompareError::Question { design, number, source, key }
            }
            other => other,
        }
    }

    /// Kinematics of `[kinematics]`.
    ///
    /// # Errors
    /// As for [`kinematics`](crate::kinematics).
    pub fn kinematics_report(&self) -> Result<Option<KinematicsReport>, KinematicsError> {
        self.tables.kinematics.as_ref().map(|requested| kinematics(&self.model, requested)).transpose()
    }

    /// Map of `[map]`.
    ///
    /// # Errors
    /// As for [`map`] and [`map_point`].
    pub fn map_result(&self) -> Result<Option<MapResult>, StudyError> {
        // The contact gives the link and the point that the table does not have.
        let is_of_map = |keys: [&str; 2]| keys.iter().any(|key| self.keys.contains(key));
        let of_map = |field| match field {
            Field::Link if is_of_map(["map.link", "map.all"]) => Field::MapLink,
            Field::Point if is_of_map(["map.point"; 2]) => Field::MapPoint,
            other => other,
        };
        of_table("map", self.tables.map.as_ref(), |asked| {
            requested_map(&self.model, &self.conditions, asked).map_err(|error| error.with_field(of_map))
        })
    }

    /// Safe speeds of `[safe_speed]`.
    ///
    /// # Errors
    /// As for [`safe_speeds`](crate::safe_speeds).
    pub fn safe_speeds(&self) -> Result<Option<Vec<SafeSpeedReport>>, StudyError> {
        of_table("safe_speed", self.tables.safe_speed.as_ref(), |asked| {
            safe_speeds(&self.model, &self.conditions, asked)
        })
    }

    /// Contents of the model, for a table `[check]`.
    ///
    /// # Errors
    /// As for [`check`].
    pub fn check_report(&self) -> Result<Option<CheckReport>, StudyError> {
        self.tables.check.as_ref().map(|_| check(&self.model)).transpose()
    }

    /// Source code of `[generate]`, at the contact of the study.
    ///
    /// # Errors
    /// As for [`generate_code`].
    pub fn generated_code(&self) -> Result<Option<CodeReport>, CodeError> {
        let asked = self.question.as_ref().zip(self.tables.generate.as_ref());
        asked.map(|(question, asked)| generate_code(&self.model, question, asked)).transpose()
    }

    /// The model in the format of `[convert]`.
    ///
    /// # Errors
    /// As for [`convert`].
    pub fn conversion(&self) -> Result<Option<ConversionReport>, ConversionError> {
        self.tables.convert.as_ref().map(|asked| convert(&self.model, asked)).transpose()
    }

    /// The impact of `[export]` with the damper of `[damping]`.
    ///
    /// # Errors
    /// As for [`export`].
    pub fn exported_impact(&self) -> Result<Option<ExportReport>, ImpactExportError> {
        let asked = self.tables.damping.as_ref().zip(self.tables.export.as_ref());
        asked.map(|(damping, asked)| export(&self.model, &self.conditions, damping, asked)).transpose()
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
    /// Error of the generated code.
    #[error(transparent)]
    Code(#[from] CodeError),
    /// Error of the conversion.
    #[error(transparent)]
    Conversion(#[from] ConversionError),
    /// Error of the exported impact.
    #[error(transparent)]
    Export(#[from] ImpactExportError),
}

impl AskError {
    /// Error of the question, if it is the reason.
    fn question(&self) -> Option<&StudyError> {
        match self {
            Self::Question(error)
            | Self::Kinematics(KinematicsError::Study(error))
            | Self::Code(CodeError::Question(error))
            | Self::Export(ImpactExportError::Question(error)) => Some(error),
            _ => None,
        }
    }

    /// True if the question is valid but has no result.
    pub fn has_no_result(&self) -> bool {
        match self {
            Self::Comparison(CompareError::Question { source, .. }) => source.has_no_result(),
            other => other.question().is_some_and(StudyError::has_no_result),
        }
    }

    /// Message with the keys of the request.
    pub fn message(&self) -> String {
        match (self, self.question()) {
            (_, Some(error)) => error.message(Names::KEYS),
            (Self::Request(StudyFileError::Value { key, why, .. }), _) => format!("{key}: {why}"),
            (Self::Comparison(error), _) => error.message(Names::KEYS),
            (other, _) => other.to_string(),
        }
    }
}
