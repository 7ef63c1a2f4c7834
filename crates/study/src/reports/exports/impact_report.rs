//! Report of an exported impact.

use crate::model::loading::Input;
use crate::model::record::DiagnosticRecord;
use crate::question::spelled_contact::StopRecord;
use crate::reports::exports::change_record::ChangeRecord;
use crate::reports::exports::code::TextFile;
use schemars::JsonSchema;
use serde::Serialize;

/// Report of `percuss export`, as JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ExportReport {
    /// `percuss.export/1`.
    #[schemars(extend("const" = "percuss.export/1"))]
    pub schema: &'static str,
    /// Version of percuss.
    pub percuss: &'static str,
    /// Input files.
    pub inputs: Vec<Input>,
    /// Written model.
    pub output: String,
    /// Written script.
    pub script: String,
    /// Format of the model.
    pub format: &'static str,
    /// Stop of a joint; its `motion` determines the units. Null for a contact.
    pub stop: Option<StopRecord>,
    /// m̄ at the touch, kg.
    pub effective_mass: f64,
    /// Closing speed at the touch, m/s.
    pub approach_speed: f64,
    /// Required restitution.
    pub restitution: f64,
    /// Restitution with the mass as it changes over the penetration, for an infinitely short time step; null if the mechanism
    /// cannot follow the impact.
    pub predicted_restitution: Option<f64>,
    /// Bound of the difference between the restitution that the simulator reaches and the required one; null if unknown.
    pub error_bound: Option<f64>,
    /// Time step, s.
    pub time_step: f64,
    /// Everything that changes or is lost.
    pub changes: Vec<ChangeRecord>,
    /// Least and largest relative change of the effective mass of a contact at the drawn pose by balanced moments of inertia; null without them, and
    /// without a bound. All other keys are those of the balanced moments.
    pub mass_change: Option<[f64; 2]>,
    /// Findings about the file and the result.
    pub diagnostics: Vec<DiagnosticRecord>,
    /// The model and the script as text; absent if they are written to files.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub files: Vec<TextFile>,
}
