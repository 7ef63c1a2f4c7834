//! Parameters for simulators, as they stand in reports.

use percuss_contact::exports::{Export, ExportError, Measurement, Penetration, Snippet, Tool, Value};
use serde::Serialize;
use std::collections::BTreeMap;

/// A contact in the numbers of a simulator, or why it cannot have it. Keys are always present, null or empty where they
/// do not apply.
#[derive(Clone, Debug, Serialize)]
pub struct ExportRecord {
    /// As the tool's makers write it.
    pub title: &'static str,
    /// What the tool integrates.
    pub law: &'static str,
    /// What came out where the tool was run with exported parameters; empty: not measured.
    pub measured: &'static [Measurement],
    /// How the tool makes one value of those of the two sides.
    pub combines: &'static str,
    /// What to watch for.
    pub caution: &'static str,
    /// By the tool's own names.
    pub parameters: BTreeMap<&'static str, Value>,
    /// Units of the parameters that have one.
    pub units: BTreeMap<&'static str, &'static str>,
    /// The text to paste: the first of the snippets.
    pub snippet: Option<String>,
    /// All of them.
    pub snippets: Vec<Snippet>,
    /// s; null where the tool chooses its steps itself.
    pub time_step: Option<f64>,
    /// How far the restitution can be off at that step, without gravity.
    pub error_bound: Option<f64>,
    /// Addition to it in a build of single precision, for tools that have builds of both precisions.
    pub single_precision_error: Option<f64>,
    /// Greatest penetration by the tool's own law, m (rad for a stop that turns); empty without a speed and for rigid contacts.
    pub penetrations: Vec<Penetration>,
    /// Numbers that are missing, and what they are for.
    pub missing: Vec<&'static str>,
    /// What must hold for the contact to bounce as asked.
    pub assumptions: Vec<String>,
    /// What the tool cannot do.
    pub cannot: Vec<&'static str>,
    /// Documentation and source files this stands on.
    pub sources: &'static [&'static str],
    /// Why there are no parameters; null where there are.
    pub error: Option<String>,
}

impl ExportRecord {
    pub(crate) fn of(export: &Export) -> Self {
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
            sources: facts.sources,
            error: None,
        }
    }

    pub(crate) fn refused(tool: Tool, error: &ExportError) -> Self {
        let facts = tool.facts();
        Self {
            title: facts.title,
            law: facts.law,
            measured: facts.measured,
            combines: facts.combines,
            caution: facts.caution,
            parameters: BTreeMap::new(),
            units: BTreeMap::new(),
            snippet: None,
            snippets: Vec::new(),
            time_step: None,
            error_bound: None,
            single_precision_error: None,
            penetrations: Vec::new(),
            missing: Vec::new(),
            assumptions: Vec::new(),
            cannot: Vec::new(),
            sources: facts.sources,
            error: Some(error.to_string()),
        }
    }
}
