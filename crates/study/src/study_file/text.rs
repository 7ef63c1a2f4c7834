//! Text of a study file: all tables. The doc comments are the descriptions in the JSON schema and in the help of the flags.

use crate::question::errors::refusal::InvalidKey;
use crate::question::link_points::Hold;
use crate::question::mass_question::MassQuestion;
use crate::question::names::Names;
use crate::question::tables::contact::{ConditionsTable, ContactTable, PoseTable};
use crate::question::tables::damping::DampingQuestion;
use crate::question::tables::damping::restitution::RestitutionQuestion;
use crate::question::tables::exports::CodeQuestion;
use crate::question::tables::exports::{ConversionQuestion, ExportQuestion};
use crate::question::tables::extremes::ExtremesQuestion;
use crate::question::tables::identify::IdentifyQuestion;
use crate::question::tables::impact::ImpactQuestion;
use crate::question::tables::kinematics::{KinematicsQuestion, TargetsQuestion};
use crate::question::tables::map::MapQuestion;
use crate::question::tables::mass::MassOptions;
use crate::question::tables::model::{CheckQuestion, ModelTable};
use crate::question::tables::response::ResponseQuestion;
use crate::question::tables::safe_speed::SafeSpeedQuestion;
use crate::question::tables::sweep::SweepQuestion;
use crate::study_file::closure::ClosureText;
use crate::study_file::contacts::{ContactsSchema, contacts};
use crate::study_file::report::StudyReport;
use crate::study_file::variant::VariantText;
use crate::thresholds::{LARGEST_COORDINATE, SHORTEST_DIRECTION};
use nalgebra::Vector3;
use percuss_mechanism::Mechanism;
use schemars::JsonSchema;
use serde::Deserialize;
use std::path::Path;

/// A study of percuss: questions about a mechanism, kept in a TOML file. Numbers are in SI units; text with a
/// unit is allowed ("350 mm", "30 deg"). Paths are relative to the study.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "percuss study")]
pub struct StudyTables {
    /// The mechanism.
    pub model: ModelTable,
    /// The base of the mechanism, locked joints, and armatures.
    #[serde(default)]
    pub conditions: ConditionsTable,
    /// The joint positions.
    #[serde(default)]
    pub pose: PoseTable,
    /// The contact of the study, or several as `[[contact]]`. at = "all" takes all contacts of the model.
    #[serde(default, deserialize_with = "contacts")]
    #[schemars(with = "ContactsSchema")]
    pub contact: Vec<ContactTable>,
    /// Options of percuss mass.
    pub mass: Option<MassOptions>,
    /// Additional loops that are not part of the model.
    #[serde(default)]
    pub(crate) closure: Vec<ClosureText>,
    /// Held points.
    #[serde(default)]
    pub hold: Vec<Hold>,
    /// Design variants of the same question: percuss compare.
    #[serde(default)]
    pub(crate) variant: Vec<VariantText>,
    /// The damper that gives a restitution: percuss damp.
    pub damping: Option<DampingQuestion>,
    /// The restitution of a spring and damper, or of parameters of a simulator: percuss restitution.
    pub restitution: Option<RestitutionQuestion>,
    /// Contact of measured impacts, compared with the effective mass: percuss identify.
    pub identify: Option<IdentifyQuestion>,
    /// Response of the contact over frequency, with the bushes of a suspension: percuss response.
    pub response: Option<ResponseQuestion>,
    /// Rigid impact at the contact: percuss impact.
    pub impact: Option<ImpactQuestion>,
    /// Smallest and largest effective mass over positions: percuss extremes.
    pub extremes: Option<ExtremesQuestion>,
    /// The contact over rows of positions: percuss sweep.
    pub sweep: Option<SweepQuestion>,
    /// Camber, toe, motion ratios of a suspension over a travel: percuss kinematics.
    pub kinematics: Option<KinematicsQuestion>,
    /// Coordinates, masses, curves and dampers of a suspension for required values: percuss kinematics --solve.
    pub targets: Option<TargetsQuestion>,
    /// The surface of links, or all directions at a point: percuss map.
    pub map: Option<MapQuestion>,
    /// Safe speed of the contact if it may hit a person: percuss safe-speed.
    pub safe_speed: Option<SafeSpeedQuestion>,
    /// Contents of the model, for a request or a study about the model itself: percuss check. This table has no keys.
    pub check: Option<CheckQuestion>,
    /// Source code of the effective mass at the contact: percuss generate.
    pub generate: Option<CodeQuestion>,
    /// The model in another format: percuss convert.
    pub convert: Option<ConversionQuestion>,
    /// The impact at the contact with the damper of `[damping]`, as a model for MuJoCo that runs: percuss export.
    pub export: Option<ExportQuestion>,
    /// The head of the report: percuss run STUDY.toml --report FILE.html.
    #[serde(default)]
    pub report: StudyReport,
}

impl StudyTables {
    /// Key and reason of the first invalid held point.
    pub(crate) fn hold_fault(&self, mechanism: &Mechanism) -> Option<(String, String)> {
        self.hold.iter().enumerate().find_map(|(number, hold)| {
            let is_large = |x: &f64| x.abs() > LARGEST_COORDINATE;
            let large = |numbers: [f64; 3]| numbers.into_iter().find(is_large);
            let too_large = |x| format!("{x:e} is no coordinate; at most {LARGEST_COORDINATE:e} is expected");
            let length = hold.normal.map(|normal| Vector3::from(normal).norm());
            let fault = match (
                mechanism.find_link(&hold.link),
                large(hold.point),
                hold.normal.and_then(large),
                length,
            ) {
                (Err(error), ..) => ("link", error.to_string()),
                (_, Some(x), ..) => ("point", too_large(x)),
                (_, _, Some(x), _) => ("normal", too_large(x)),
                (.., Some(length)) if length < SHORTEST_DIRECTION => {
                    let why = format!(
                        "its length is {length:e}; expected at least {SHORTEST_DIRECTION:e}, for a direction"
                    );
                    ("normal", why)
                }
                _ => return None,
            };
            Some((format!("hold[{number}].{}", fault.0), fault.1))
        })
    }

    /// Converts the study to a question at a contact, which may be incomplete. Paths are relative to the study's
    /// folder.
    pub(crate) fn question(
        &self,
        contact: &ContactTable,
        folder: &Path,
        max_size: u64,
    ) -> Result<MassQuestion, InvalidKey> {
        let Self { pose, conditions, hold, .. } = self;
        MassQuestion::of_tables(contact, pose, conditions, hold, Names::KEYS).checked(folder, max_size)
    }
}
