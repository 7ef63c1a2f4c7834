//! The answer for one tool.

use serde::Serialize;

use super::{ExportError, Tool};
use crate::ContactLawError;

/// A contact in the numbers of a tool.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Export {
    /// The tool.
    pub tool: Tool,
    /// The tool's parameters, under the tool's names.
    pub parameters: Vec<Parameter>,
    /// Text for the tool's files, the first being the one to take by default.
    pub snippets: Vec<Snippet>,
    /// The tool's time step in s: the one of the request, or the longest that holds the accuracy. None where the
    /// tool chooses its steps itself.
    pub time_step: Option<f64>,
    /// How far the restitution can be off at this time step, wherever within a step the contact begins. None where
    /// that is not known.
    pub error_bound: Option<f64>,
    /// Addition to the error bound in a build of single precision, for tools that have builds of both precisions.
    pub single_precision_error: Option<f64>,
    /// Greatest penetration by the tool's own law; empty without a speed and for rigid contacts.
    pub penetrations: Vec<Penetration>,
    /// Numbers that are missing for the whole answer, and what they are for.
    pub missing: Vec<&'static str>,
    /// What has to hold for the contact to have the required restitution.
    pub assumptions: Vec<String>,
    /// What the tool cannot do.
    pub cannot: Vec<&'static str>,
}

/// Greatest penetration of an impact.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Penetration {
    /// Solver or mode of the tool, empty if there is only one.
    pub solver: &'static str,
    /// In `unit`.
    pub value: f64,
    /// m; rad for a stop that turns.
    pub unit: &'static str,
}

/// A parameter of a tool.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Parameter {
    /// As the tool calls it.
    pub name: &'static str,
    /// What to set it to.
    pub value: Value,
    /// Its unit, empty for what has none.
    pub unit: &'static str,
}

/// The value of a parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Value {
    /// One number.
    Number(f64),
    /// Several, in the tool's order.
    Numbers(Vec<f64>),
    /// A word.
    Word(&'static str),
}

/// Text for a tool's file.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Snippet {
    /// What it is.
    pub title: &'static str,
    /// "xml", "python", "cpp", "rust", "matlab", "adams".
    pub language: &'static str,
    /// Well-formed, all numbers in full.
    pub text: String,
}

impl Export {
    /// An answer with nothing in it yet.
    pub(super) fn new(tool: Tool) -> Self {
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
        }
    }

    /// The value of the parameter of this name.
    pub fn parameter(&self, name: &str) -> Option<&Value> {
        self.parameters.iter().find(|p| p.name == name).map(|p| &p.value)
    }

    /// The single number that the parameter of this name is.
    pub fn number(&self, name: &str) -> Option<f64> {
        match self.parameter(name)? {
            Value::Number(number) => Some(*number),
            Value::Numbers(_) | Value::Word(_) => None,
        }
    }

    pub(super) fn set(&mut self, name: &'static str, value: impl Into<Value>, unit: &'static str) {
        self.parameters.push(Parameter { name, value: value.into(), unit });
    }

    /// Adds a penetration, if it is known.
    pub(super) fn penetrate(&mut self, solver: &'static str, value: Option<f64>) {
        self.penetrations.extend(value.filter(|value| value.is_finite()).map(|value| Penetration {
            solver,
            value,
            unit: "m",
        }));
    }

    pub(super) fn assume(&mut self, text: impl Into<String>) {
        self.assumptions.push(text.into());
    }

    pub(super) fn write(&mut self, title: &'static str, language: &'static str, text: String) {
        self.snippets.push(Snippet { title, language, text });
    }

    /// Itself, if all its numbers are finite.
    pub(super) fn finite(self) -> Result<Self, ExportError> {
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
}

/// A number for a tool that stores it in single precision. Error: it is too large or too small for that.
pub(super) fn single(what: &'static str, value: f64) -> Result<(), ExportError> {
    let stored = value as f32;
    if stored.is_normal() || value == 0.0 {
        return Ok(());
    }
    let valid = "a size from 1.2e-38 to 3.4e38: the tool stores it in single precision";
    Err(ContactLawError::OutOfRange { what, got: value, valid }.into())
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
