//! Report of an exported impact.

use crate::damper::exported_impact::ExportedImpact;
use crate::model::conversion::{ChangeRecord, changes};
use crate::model::loading::{Input, Model};
use crate::model::record::DiagnosticRecord;
use crate::question::spelled_contact::StopRecord;
use schemars::JsonSchema;
use serde::Serialize;

/// Report of `percuss export`, as JSON.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ExportReport {
    /// `percuss.export/1`.
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
    /// Findings about the file and the result.
    pub diagnostics: Vec<DiagnosticRecord>,
}

impl ExportReport {
    /// Report about an exported impact of a model; `files`: model and script.
    pub fn new(model: &Model, exported: &ExportedImpact, format: &'static str, files: [&str; 2]) -> Self {
        let (changes, of_file) = changes(model, exported.model.changes.clone());
        // The findings of the damper begin with those of the file.
        let of_result =
            exported.damping.diagnostics.iter().filter(|finding| !model.diagnostics.contains(finding));
        Self {
            schema: "percuss.export/1",
            percuss: env!("CARGO_PKG_VERSION"),
            inputs: model.inputs.clone(),
            output: files[0].to_owned(),
            script: files[1].to_owned(),
            format,
            stop: exported.damping.stop.clone(),
            effective_mass: exported.damping.effective_mass,
            approach_speed: exported.speed,
            restitution: exported.damping.damper.restitution,
            predicted_restitution: exported.predicted,
            error_bound: exported.error_bound,
            time_step: exported.time_step,
            changes,
            diagnostics: of_file.into_iter().chain(of_result.cloned()).collect(),
        }
    }
}
