//! Simulator parameters in reports.

use percuss_contact::exports::{Export, ExportError, Measurement, Penetration, Snippet, Tool, Value};
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;

/// Contact in the parameters of a simulator, or the reason for missing support. All keys are always present; a
/// value is null or empty if not applicable.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ExportRecord {
    /// Name of the tool, in the spelling of its makers.
    pub title: &'static str,
    /// Contact law integrated by the tool.
    pub law: &'static str,
    /// Results measured with exported parameters; empty without a measurement.
    pub measured: &'static [Measurement],
    /// Rule by which the tool combines the values of the two sides.
    pub combines: &'static str,
    /// Precautions for use.
    pub caution: &'static str,
    /// Parameters by the tool's own names.
    pub parameters: BTreeMap<&'static str, Value>,
    /// Units of the parameters that have one.
    pub units: BTreeMap<&'static str, &'static str>,
    /// First snippet, the text to paste.
    pub snippet: Option<String>,
    /// All snippets.
    pub snippets: Vec<Snippet>,
    /// Time step, s; null if the tool chooses the step.
    pub time_step: Option<f64>,
    /// Error bound of the restitution at this time step, without gravity.
    pub error_bound: Option<f64>,
    /// Additional error of a single-precision build, for tools with builds of both precisions.
    pub single_precision_error: Option<f64>,
    /// Greatest penetration by the tool's own law, m (rad for a stop that turns); empty without a speed and for rigid contacts.
    pub penetrations: Vec<Penetration>,
    /// Missing numbers and their purpose.
    pub missing: Vec<&'static str>,
    /// Assumptions for the requested restitution.
    pub assumptions: Vec<String>,
    /// True if with gravity along the normal there is almost no rebound.
    #[serde(skip)]
    pub weight_prevents_rebound: bool,
    /// Limitations of the tool.
    pub cannot: Vec<&'static str>,
    /// Documentation and source files used as sources.
    pub sources: &'static [&'static str],
    /// Reason for missing parameters; null if there are parameters.
    pub error: Option<String>,
}

impl ExportRecord {
    /// Record of a successful export.
    pub(crate) fn from_export(export: &Export) -> Self {
        let facts = export.tool.facts();
        let with_unit = export.parameters.iter().filter(|p| !p.unit.is_empty());
        Self {
            title: facts.title,
            law: facts.law,
            measured: facts.measured,
            combines: facts.combines,
            caution: facts.caution,
            parameters: export.parameters.iter().map(|p| (p.name, p.value.clone())).collect(),
            units: with_unit.map(|p| (p.name, p.unit)).collect(),
            snippet: export.snippets.first().map(|s| s.text.clone()),
            snippets: export.snippets.clone(),
            time_step: export.time_step,
            error_bound: export.error_bound,
            single_precision_error: export.single_precision_error,
            penetrations: export.penetrations.clone(),
            missing: export.missing.clone(),
            assumptions: export.assumptions.clone(),
            cannot: export.cannot.clone(),
            weight_prevents_rebound: export.weight_prevents_rebound,
            sources: facts.sources,
            error: None,
        }
    }

    /// Record of a tool that cannot export the contact.
    pub(crate) fn from_error(tool: Tool, error: &ExportError) -> Self {
        Self { error: Some(error.to_string()), ..Self::from_export(&Export::new(tool)) }
    }
}
