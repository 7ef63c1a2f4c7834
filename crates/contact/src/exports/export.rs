//! Export of a contact to one tool.

use serde::Serialize;

use super::{ExportError, Request, Tool};
use crate::ContactLawError;

/// Parameters of one tool for a contact.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Export {
    /// The tool.
    pub tool: Tool,
    /// Parameters with the names of the tool.
    pub parameters: Vec<Parameter>,
    /// Text for files of the tool; the first snippet is the default.
    pub snippets: Vec<Snippet>,
    /// Time step, s: that of the request, or the longest step for the accuracy. `None` if the tool chooses its steps.
    pub time_step: Option<f64>,
    /// Error bound of the restitution at this time step, for every start of the contact within a step. `None` if
    /// unknown.
    pub error_bound: Option<f64>,
    /// Addition to the error bound in a build of single precision, for tools that have builds of both precisions.
    pub single_precision_error: Option<f64>,
    /// Greatest penetration by the tool's own law; empty without a speed and for rigid contacts.
    pub penetrations: Vec<Penetration>,
    /// Missing numbers and their purpose.
    pub missing: Vec<&'static str>,
    /// Assumptions for the required restitution.
    pub assumptions: Vec<String>,
    /// Limitations of the tool.
    pub cannot: Vec<&'static str>,
    /// True if with gravity along the normal there is almost no rebound; an assumption contains the numbers.
    pub weight_prevents_rebound: bool,
}

/// Greatest penetration of an impact.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Penetration {
    /// Solver or mode of the tool, empty if there is only one.
    pub solver: &'static str,
    /// Value in `unit`.
    pub value: f64,
    /// m; rad for a stop that turns.
    pub unit: &'static str,
}

/// A parameter of a tool.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Parameter {
    /// Name in the tool.
    pub name: &'static str,
    /// Value.
    pub value: Value,
    /// Unit; empty for a number without a unit.
    pub unit: &'static str,
}

/// The value of a parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum Value {
    /// One number.
    Number(f64),
    /// Several numbers in the order of the tool.
    Numbers(Vec<f64>),
    /// A word.
    Word(&'static str),
}

/// Text for a file of the tool.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Snippet {
    /// Title.
    pub title: &'static str,
    /// Language: "xml", "python", "cpp", "rust", "matlab", "javascript", "adams".
    pub language: &'static str,
    /// Well-formed text; numbers have all their digits.
    pub text: String,
}

impl Export {
    /// Empty export.
    pub fn new(tool: Tool) -> Self {
        Self {
            tool,
            parameters: Vec::new(),
            snippets: Vec::new(),
            time_step: None,
            error_bound: None,
            single_precision_error: None,
            penetrations: Vec::new(),
            missing: Vec::new(),
            assumptions: Vec::new(),
            cannot: Vec::new(),
            weight_prevents_rebound: false,
        }
    }

    /// Value of a parameter.
    pub fn parameter(&self, name: &str) -> Option<&Value> {
        self.parameters.iter().find(|p| p.name == name).map(|p| &p.value)
    }

    /// Value of a parameter that is a single number.
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.parameter(name)? {
            Value::Number(number) => Some(*number),
            Value::Numbers(_) | Value::Word(_) => None,
        }
    }

    /// Adds a parameter.
    pub(super) fn set(&mut self, name: &'static str, value: impl Into<Value>, unit: &'static str) {
        self.parameters.push(Parameter { name, value: value.into(), unit });
    }

    /// Adds a penetration if the value is known and finite.
    pub(super) fn add_penetration(&mut self, solver: &'static str, value: Option<f64>) {
        self.penetrations.extend(value.filter(|value| value.is_finite()).map(|value| Penetration {
            solver,
            value,
            unit: "m",
        }));
    }

    /// Adds an assumption.
    pub(super) fn add_assumption(&mut self, text: impl Into<String>) {
        self.assumptions.push(text.into());
    }

    /// Adds a snippet.
    pub(super) fn add_snippet(&mut self, title: &'static str, language: &'static str, text: String) {
        self.snippets.push(Snippet { title, language, text });
    }

    /// Returns the export if all parameters are finite. Error: a parameter is not finite.
    pub(super) fn check_finite(self) -> Result<Self, ExportError> {
        let numbers = |value: &Value| match value {
            Value::Number(number) => number.is_finite(),
            Value::Numbers(numbers) => numbers.iter().all(|n| n.is_finite()),
            Value::Word(_) => true,
        };
        if let Some(parameter) = self.parameters.iter().find(|p| !numbers(&p.value)) {
            return Err(ContactLawError::NotRepresentable { what: parameter.name }.into());
        }
        Ok(self)
    }

    /// Returns the export if its error bound is at most the restitution. `drift_error`: part of the bound for the change of m̄. Error: a
    /// larger bound, because the restitution would be unknown.
    pub(super) fn check_error_bound(self, request: &Request, drift_error: f64) -> Result<Self, ExportError> {
        let e = request.restitution;
        let Some(bound) = self.error_bound.filter(|bound| e > 0.0 && *bound > e) else { return Ok(self) };
        let (why, remedy) = if bound - drift_error <= e {
            (
                "the effective mass changes too much over the compression: the error bound for this is larger than the restitution",
                "use a stiffer contact or a slower impact, or move the contact to a pose at which the mass changes less",
            )
        } else {
            (
                "the error bound at these conditions is larger than the restitution",
                "require a smaller error (accuracy) or a shorter time step, a faster impact, or choose a tool of double precision",
            )
        };
        Err(ExportError::Unreachable { tool: self.tool, restitution: e, why, remedy })
    }
}

/// Checks a number that the tool stores in single precision. Error: the number is out of that range.
pub(super) fn check_single_precision(what: &'static str, value: f64) -> Result<(), ExportError> {
    let stored = value as f32;
    if stored.is_normal() || value == 0.0 {
        return Ok(());
    }
    let valid = "a size from 1.2e-38 to 3.4e38: the tool stores it in single precision";
    Err(ContactLawError::OutOfRange { what: what.into(), got: value, valid }.into())
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl<const N: usize> From<[f64; N]> for Value {
    fn from(numbers: [f64; N]) -> Self {
        Self::Numbers(numbers.to_vec())
    }
}

impl From<&'static str> for Value {
    fn from(word: &'static str) -> Self {
        Self::Word(word)
    }
}
