//! Rigid impact of a contact.

use crate::analysis::model::Model;
use crate::conversion::arrays::list;
use crate::conversion::errors::input;
use crate::questions::question::{Conditions, Damping, GivenContact};
use crate::questions::reports::contact_report;
use percuss::study::{self, GivenRates, ImpactQuestion, PercussionRequest};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};

/// Python class `percuss._reports._Impact`.
#[derive(FromPyObject)]
pub struct Impact<'py> {
    restitution: f64,
    speed: Option<f64>,
    friction: Option<f64>,
    rates: Bound<'py, PyDict>,
    base_twist: Option<[f64; 6]>,
    law: Option<Damping>,
    rate_limits: Bound<'py, PyDict>,
    reflected: Vec<String>,
    percussion: Vec<String>,
}

/// Rates by joint, from numbers or text such as "30deg/s".
fn rates(given: &Bound<'_, PyDict>, what: &str) -> PyResult<Vec<(String, GivenRates)>> {
    let one = |(joint, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let joint: String = joint.extract()?;
        let rates = match value.extract::<String>() {
            Ok(text) => text.parse(),
            Err(_) => GivenRates::from_numbers(&list(&value, &format!("{what} of \"{joint}\""))?),
        };
        let rates = rates.map_err(|error| input(format_args!("{what} of \"{joint}\": {error}")))?;
        Ok((joint, rates))
    };
    given.iter().map(one).collect()
}

impl Impact<'_> {
    /// Converts the fields to a question of the study crate.
    fn question(&self) -> PyResult<ImpactQuestion> {
        let percussion = |text: &String| {
            text.parse::<PercussionRequest>()
                .map_err(|error| input(format_args!("percussion: \"{text}\": {error}")))
        };
        Ok(ImpactQuestion {
            restitution: self.restitution,
            speed: self.speed,
            friction: self.friction,
            rates: rates(&self.rates, "rates")?,
            base_twist: self.base_twist,
            law: self.law.as_ref().map(Damping::question).transpose()?,
            rate_limits: rates(&self.rate_limits, "rate_limit")?,
            reflected: self.reflected.clone(),
            percussion: self.percussion.iter().map(percussion).collect::<PyResult<_>>()?,
        })
    }
}

/// Report on a rigid impact at a contact of a model.
#[pyfunction]
pub fn impact(
    py: Python<'_>,
    model: &Model,
    contact: GivenContact<'_>,
    conditions: Conditions<'_>,
    impact: Impact<'_>,
) -> PyResult<String> {
    let requested = impact.question()?;
    contact_report(py, model, contact, &conditions, |model, question| {
        study::impact(model, question, &requested)
    })
}
