//! Rigid impact of a contact.

use crate::analysis::contact::GivenContact;
use crate::analysis::model::Model;
use crate::conversion::arrays::list;
use crate::conversion::errors::{input, of_argument};
use crate::questions::question::{Conditions, Damping, optional_rows};
use crate::questions::reports::contact_report;
use percuss::Mechanism;
use percuss::study::{
    self, ExtremesQuestion, FurtherContact, GivenGearLimits, GivenPath, GivenRange, GivenRates, GivenSpring,
    ImpactQuestion, Keep, PercussionRequest, QuantityError, RestitutionLawName,
};
use pyo3::prelude::*;
use pyo3::types::{PyAny, PyDict};
use std::str::FromStr;

/// Python class `percuss._reports._Impact`.
#[derive(FromPyObject)]
pub struct Impact<'py> {
    restitution: f64,
    speed: Option<f64>,
    friction: Option<f64>,
    restitution_law: Option<String>,
    also: Vec<GivenContact<'py>>,
    also_restitution: Vec<f64>,
    sticking: bool,
    stiffness_ratios: Vec<f64>,
    contact_exponent: Option<f64>,
    rates: Bound<'py, PyDict>,
    base_twist: Option<[f64; 6]>,
    law: Option<Damping>,
    in_time: bool,
    gravity: Option<[f64; 3]>,
    joint_springs: Bound<'py, PyDict>,
    rate_limits: Bound<'py, PyDict>,
    gear_limits: Bound<'py, PyDict>,
    point_error: Option<f64>,
    reflected: Vec<String>,
    percussion: Vec<String>,
}

/// Rows of a path: ranges, file with ignored columns, random rows.
type PathRows<'py> = (Option<Vec<Bound<'py, PyAny>>>, Option<(String, Vec<String>)>, Option<(usize, u64)>);

/// Values by joint, from numbers or text with units such as "30deg/s".
fn by_joint<T: FromStr<Err = QuantityError>>(
    given: &Bound<'_, PyDict>,
    what: &str,
    from_numbers: impl Fn(&[f64]) -> Result<T, QuantityError>,
) -> PyResult<Vec<(String, T)>> {
    let one = |(joint, value): (Bound<'_, PyAny>, Bound<'_, PyAny>)| {
        let joint: String = joint.extract()?;
        let read = match value.extract::<String>() {
            Ok(text) => text.parse(),
            Err(_) => from_numbers(&list(&value, &format!("{what} of \"{joint}\""))?),
        };
        let read = read.map_err(|error| input(format_args!("{what} of \"{joint}\": {error}")))?;
        Ok((joint, read))
    };
    given.iter().map(one).collect()
}

/// Law of restitution by name.
fn law(name: &str) -> PyResult<RestitutionLawName> {
    RestitutionLawName::ALL.into_iter().find(|law| law.law().name() == name).ok_or_else(|| {
        let names = RestitutionLawName::ALL.map(|law| law.law().name()).join(", ");
        input(format_args!("restitution_law: \"{name}\"; expected one of {names}"))
    })
}

impl Impact<'_> {
    /// Converts the fields to a question of the study crate.
    fn question(&self, mechanism: &Mechanism) -> PyResult<ImpactQuestion> {
        let percussion = |text: &String| {
            text.parse::<PercussionRequest>()
                .map_err(|error| input(format_args!("percussion: \"{text}\": {error}")))
        };
        let further = |given: &GivenContact<'_>| match given {
            GivenContact::Named(text) => text
                .parse::<FurtherContact>()
                .map_err(|error| input(format_args!("also: \"{text}\": {error}"))),
            contact => contact.resolve(mechanism).map(FurtherContact::Resolved).map_err(of_argument("also")),
        };
        if self.restitution_law.is_some() && self.friction.is_none() {
            return Err(input("restitution_law: without friction it has no effect; give friction too"));
        }
        let damping = self.law.as_ref().map(Damping::question).transpose()?.unwrap_or_default();
        Ok(ImpactQuestion {
            restitution: Some(self.restitution.into()),
            speed: self.speed.map(Into::into),
            friction: self.friction.map(Into::into),
            restitution_law: self.restitution_law.as_deref().map(law).transpose()?,
            also: self.also.iter().map(further).collect::<PyResult<_>>()?,
            also_restitution: self.also_restitution.clone(),
            sticking: self.sticking,
            stiffness_ratio: self.stiffness_ratios.clone(),
            contact_exponent: self.contact_exponent.map(Into::into),
            rates: by_joint(&self.rates, "rates", GivenRates::from_numbers)?,
            base_twist: self.base_twist.map(Vec::from).unwrap_or_default(),
            stiffness: damping.stiffness,
            exponent: damping.exponent,
            law: damping.law,
            separation: damping.separation,
            in_time: self.in_time,
            gravity: self.gravity.map(Vec::from).unwrap_or_default(),
            joint_spring: by_joint(&self.joint_springs, "joint_spring", GivenSpring::from_numbers)?,
            rate_limit: by_joint(&self.rate_limits, "rate_limit", GivenRates::from_numbers)?,
            gear_limit: by_joint(&self.gear_limits, "gear_limit", GivenGearLimits::from_numbers)?,
            point_error: self.point_error.map(Into::into),
            reflected: self.reflected.clone(),
            percussion: self.percussion.iter().map(percussion).collect::<PyResult<_>>()?,
        })
    }
}

/// Smallest and largest effective mass, or another quantity, over ranges of driving joints, "JOINT=FROM:TO", with kept links or points, or
/// along a path of rows.
#[pyfunction]
#[allow(clippy::too_many_arguments, reason = "arguments of the Python function")]
pub fn extremes(
    py: Python<'_>,
    model: &Model,
    contact: GivenContact<'_>,
    conditions: Conditions<'_>,
    ranges: Vec<String>,
    quantity: &str,
    normals: &str,
    starts: usize,
    keep: Vec<String>,
    contact_law: Option<Damping>,
    rows: PathRows<'_>,
) -> PyResult<String> {
    let (vary, input_file, random) = rows;
    let path = optional_rows(vary, input_file, random)?;
    let kept = |text: &String| {
        text.parse::<Keep>().map_err(|error| input(format_args!("keep: \"{text}\": {error}")))
    };
    let keep = keep.iter().map(kept).collect::<PyResult<_>>()?;
    let range = |text: &String| {
        text.parse::<GivenRange>().map_err(|error| input(format_args!("ranges: \"{text}\": {error}")))
    };
    let quantity =
        quantity.parse().map_err(|error| input(format_args!("quantity: \"{quantity}\": {error}")))?;
    let normals = normals.parse().map_err(|error| input(format_args!("normals: \"{normals}\": {error}")))?;
    let law = contact_law.as_ref().map(Damping::question).transpose()?.unwrap_or_default();
    let requested = ExtremesQuestion {
        range: ranges.iter().map(range).collect::<PyResult<_>>()?,
        keep,
        path: path.map(GivenPath),
        quantity: Some(quantity),
        normals: Some(normals),
        starts: (starts > 0).then(|| starts.try_into().unwrap_or(u16::MAX)),
        stiffness: law.stiffness,
        restitution: law.restitution,
        speed: law.speed,
        exponent: law.exponent,
        law: law.law,
        separation: law.separation,
        ..ExtremesQuestion::default()
    };
    contact_report(py, model, contact, &conditions, |model, question| {
        study::extremes(model, question, &requested)
    })
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
    let requested = impact.question(&model.read.mechanism)?;
    contact_report(py, model, contact, &conditions, |model, question| {
        study::impact(model, question, &requested)
    })
}
