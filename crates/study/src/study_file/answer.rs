//! Results of the tables of a study.

use crate::checks::model_check::{CheckReport, check};
use crate::damper::damped_contact::{damp_contact, damp_stop};
use crate::damper::damping::DampingReport;
use crate::damper::response::{ResponseReport, response};
use crate::damper::restitution::{RestitutionReport, restitution_at};
use crate::map::map_report::{MapAnswer, MapReport};
use crate::map::point_map::{PointMapReport, map_point};
use crate::map::surface_map::map;
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::question::errors::question_error::StudyError;
use crate::question::mass_question::MassQuestion;
use crate::question::names::Names;
use crate::question::tables::damping::DampingQuestion;
use crate::question::tables::kinematics::TargetsQuestion;
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
use crate::reports::kinematics::target_question::TargetSearch;
use crate::reports::kinematics::target_search::{TargetReport, search_targets};
use crate::reports::mass_report::MassReport;
use crate::reports::safe_speed::report::{SafeSpeedReport, safe_speeds};
use crate::study_file::additions::{StudyAdditions, WithAdditions};
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
    /// Response over frequency.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub response: Option<ResponseReport>,
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
    /// Search for required values of a suspension.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub targets: Option<TargetReport>,
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

    /// JSON text of the main result: the contacts, or the contact with the keys `impact` and `extremes`; otherwise the damper of a stop, the
    /// map, the safe speeds (a list, if there are several), the contents of the model, or the kinematics; `None` without these.
    pub fn main_json(&self) -> Option<String> {
        Some(match self {
            Self { contacts: Some(list), .. } => pretty(list),
            Self { mass: Some(report), impact, extremes, .. } => {
                let additions = &StudyAdditions { impact: impact.clone(), extremes: extremes.clone() };
                pretty(&WithAdditions { report, additions })
            }
            Self { damping: Some(stop), .. } => pretty(stop),
            Self { map: Some(map), .. } => pretty(map),
            Self { safe_speed: Some(reports), .. } => match &reports[..] {
                [report] => pretty(report),
                reports => pretty(&reports),
            },
            Self { check: Some(contents), .. } => pretty(contents),
            Self { kinematics, .. } => pretty(kinematics.as_ref()?),
        })
    }
}

/// Indented JSON of a record, which has text keys and no other source of errors.
fn pretty<R: Serialize>(record: &R) -> String {
    serde_json::to_string_pretty(record).unwrap_or_default()
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
        generator.subschema_for::<ResponseReport>(),
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
    /// Names of the tables with a result, and of the comparison of contacts and variants. Without a contact, the first given table has the
    /// main result.
    pub const TABLES: [&str; 15] = [
        "damping",
        "map",
        "safe_speed",
        "check",
        "kinematics",
        "targets",
        "restitution",
        "identify",
        "response",
        "impact",
        "extremes",
        "generate",
        "convert",
        "export",
        "comparison",
    ];

    /// Names of the [`TABLES`](Self::TABLES) that the study has.
    pub fn given_tables(&self) -> Vec<&'static str> {
        Self::TABLES.into_iter().filter(|table| self.keys.contains(table)).collect()
    }

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
        let report = self.results(contacts, mass, &Self::TABLES)?;
        Ok(RequestReport { mass_problem, sweep: self.sweep_report()?, ..report })
    }

    /// Results of the tables with these names of [`TABLES`](Self::TABLES), with the list of contacts and the result at the contact that are
    /// computed before.
    ///
    /// # Errors
    /// The first error of a table.
    pub fn results(
        &self,
        contacts: Option<ContactListReport>,
        mass: Option<MassReport>,
        names: &[&str],
    ) -> Result<RequestReport, AskError> {
        let Self { model, conditions, tables, .. } = self;
        let contact = self.detailed_question(contacts.as_ref());
        let is_wanted = |name: &str| names.contains(&name);
        // The contact gives the link and the point that the table of a map does not have.
        let is_of_map = |keys: [&str; 2]| keys.iter().any(|key| self.keys.contains(key));
        let of_map = |field| match field {
            "contact.link" if is_of_map(["map.link", "map.all"]) => "map.link",
            "contact.point" if is_of_map(["map.point"; 2]) => "map.point",
            other => other,
        };
        macro_rules! asked {
            ($table:ident) => {
                tables.$table.as_ref().filter(|_| is_wanted(stringify!($table)))
            };
        }
        let has_designs = !(self.variants.is_empty() && self.contacts.is_empty()) && is_wanted("comparison");
        Ok(RequestReport {
            schema: "percuss.report/1",
            percuss: env!("CARGO_PKG_VERSION"),
            mass,
            mass_problem: None,
            damping: self.stop_damper(asked!(damping))?,
            restitution: of_table("restitution", contact.zip(asked!(restitution)), |(contact, asked)| {
                restitution_at(model, contact, asked)
            })?,
            identify: of_table("identify", contact.zip(asked!(identify)), |(contact, asked)| {
                identify_contact_of(model, contact, asked)
            })?,
            response: of_table("response", contact.zip(asked!(response)), |(contact, asked)| {
                response(model, contact, asked)
            })?,
            impact: of_table("impact", contact.zip(asked!(impact)), |(contact, asked)| {
                impact(model, contact, asked)
            })?,
            extremes: of_table("extremes", contact.zip(asked!(extremes)), |(contact, asked)| {
                extremes(model, contact, asked)
            })?,
            contacts,
            sweep: None,
            comparison: has_designs.then(|| self.compare(&self.designs())).transpose()?,
            kinematics: asked!(kinematics).map(|asked| kinematics(model, asked)).transpose()?,
            targets: asked!(targets).map(|asked| self.search(asked)).transpose()?,
            map: of_table("map", asked!(map), |asked| {
                requested_map(model, conditions, asked).map_err(|error| error.with_field(of_map))
            })?,
            safe_speed: of_table("safe_speed", asked!(safe_speed), |asked| {
                safe_speeds(model, conditions, asked)
            })?,
            check: asked!(check).map(|_| check(model)).transpose()?,
            generate: self
                .question
                .as_ref()
                .zip(asked!(generate))
                .map(|(contact, asked)| generate_code(model, contact, asked))
                .transpose()?,
            convert: asked!(convert).map(|asked| convert(model, asked)).transpose()?,
            export: tables
                .damping
                .as_ref()
                .zip(asked!(export))
                .map(|(damping, asked)| export(model, conditions, damping, asked))
                .transpose()?,
        })
    }

    /// Search of the table `[targets]`.
    fn search(&self, asked: &TargetsQuestion) -> Result<TargetReport, AskError> {
        let search = TargetSearch::of_table(asked, self.question.clone());
        let search = search.map_err(StudyError::from)?;
        Ok(search_targets(&self.model, &asked.question, &search)?)
    }

    /// Impact and extremes at the contact of the study.
    ///
    /// # Errors
    /// As for [`impact`] and [`extremes`].
    pub fn additions(&self) -> Result<StudyAdditions, AskError> {
        let RequestReport { impact, extremes, .. } = self.results(None, None, &["impact", "extremes"])?;
        Ok(StudyAdditions { impact, extremes })
    }

    /// Question of the details of a report: that of the first of several contacts with a result.
    pub fn detailed_question(&self, contacts: Option<&ContactListReport>) -> Option<&MassQuestion> {
        let first = contacts.and_then(ContactListReport::first_with_result);
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
        let damping = self.tables.damping.as_ref();
        match (self.stop_damper(damping)?, &self.question) {
            (None, Some(contact)) => {
                of_table("damping", damping, |damping| damp_contact(&self.model, contact, damping))
            }
            (found, _) => Ok(found),
        }
    }

    /// Damper at the stop of a joint.
    fn stop_damper(&self, damping: Option<&DampingQuestion>) -> Result<Option<DampingReport>, StudyError> {
        let stop = damping.and_then(|damping| Some((damping, damping.limit.as_ref()?)));
        of_table("damping", stop, |(damping, stop)| {
            damp_stop(&self.model, stop, self.conditions.clone(), damping)
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
    fn sweep_report(&self) -> Result<Option<SweepReport>, StudyError> {
        of_table("sweep", self.tables.sweep.as_ref().zip(self.question.as_ref()), |(requested, question)| {
            let question = self.question_of_rows(question);
            self.prepared_sweep(requested, &question)?.report()
        })
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
