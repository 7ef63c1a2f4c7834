//! Input of a damper design.

use crate::question::errors::question_error::{Fault, StudyError};
use crate::question::field::Field;
use percuss_contact::exports::{Options, Tool};
use percuss_contact::{ContactLawError, Law, LawParameter, Separation};
use percuss_units::{Dimension, Quantity};

/// Requested restitution and the other data of a damper, except the mass.
#[derive(Clone, Debug, PartialEq)]
pub struct DampingQuestion {
    /// Coefficient of restitution e, from 0 to 1.
    pub restitution: f64,
    /// Stiffness k, N/m^p.
    pub stiffness: f64,
    /// Exponent p of the spring force k xᵖ.
    pub exponent: f64,
    /// Approach speed, m/s.
    pub speed: Option<f64>,
    /// The law of the damper.
    pub law: Law,
    /// Alias by which the law was requested.
    pub alias: Option<&'static str>,
    /// Condition for the end of a Kelvin–Voigt contact.
    pub separation: Separation,
    /// Simulators to write parameters for.
    pub tools: Vec<Tool>,
    /// Options of single simulators; missing values are completed from the model.
    pub options: Options,
}

impl DampingQuestion {
    /// Question for a linear spring without a speed: Kelvin–Voigt law with separation at zero force, no
    /// simulators.
    pub fn new(restitution: f64, stiffness: f64) -> Self {
        Self {
            restitution,
            stiffness,
            exponent: 1.0,
            speed: None,
            law: Law::KelvinVoigt,
            alias: None,
            separation: Separation::ForceVanishes,
            tools: Vec::new(),
            options: Options::default(),
        }
    }

    /// Selects a law by name. An alias can fix the exponent or the separation as well; given values must not
    /// contradict the alias.
    ///
    /// # Errors
    /// [`ContactLawError`]: unknown law, or a contradiction.
    pub fn choose(
        &mut self,
        name: &str,
        exponent: Option<f64>,
        separation: Option<Separation>,
    ) -> Result<(), ContactLawError> {
        self.law = Law::from_name(name)?;
        let alias = Law::alias(name);
        let (fixed_exponent, fixed_end) = alias.map_or((None, None), |a| (a.exponent, a.separation));
        let contradicts = |what, fixed: String, got: String| ContactLawError::Contradicts {
            name: alias.map_or("", |a| a.name),
            what,
            fixed: fixed.into(),
            got: got.into(),
        };
        if let (Some(fixed), Some(got)) = (fixed_exponent, exponent)
            && fixed != got
        {
            return Err(contradicts(LawParameter::Exponent, fixed.to_string(), got.to_string()));
        }
        if let (Some(fixed), Some(got)) = (fixed_end, separation)
            && fixed != got
        {
            return Err(contradicts(LawParameter::Separation, fixed.name().into(), got.name().into()));
        }
        self.alias = alias.map(|a| a.name);
        self.exponent = fixed_exponent.or(exponent).unwrap_or(self.exponent);
        self.separation = fixed_end.or(separation).unwrap_or(self.separation);
        Ok(())
    }
}

/// Checks the units of stiffness and speed: units of rotation for a joint that turns, units of translation
/// otherwise, and units of a linear spring only with exponent 1.
///
/// # Errors
/// [`StudyError`] with the field and the expected unit.
pub fn check_units(
    question: &DampingQuestion,
    stiffness: Quantity,
    speed: Option<Quantity>,
    turns: bool,
) -> Result<(), StudyError> {
    check_dimensions(
        question.exponent,
        (Field::Stiffness, stiffness.dimension),
        (Field::Speed, speed.and_then(|speed| speed.dimension)),
        turns,
    )
}

/// As [`check_units`], with the fields of the stiffness and the speed, and the dimensions of their given units; `None` for plain numbers.
pub(crate) fn check_dimensions(
    exponent: f64,
    stiffness: (Field, Option<Dimension>),
    speed: (Field, Option<Dimension>),
    turns: bool,
) -> Result<(), StudyError> {
    if stiffness.1.is_some() && exponent != 1.0 {
        return Err(StudyError::input(stiffness.0, Fault::UnitOfLinearSpring { exponent }));
    }
    let of_stiffness = if turns { Dimension::RotationalStiffness } else { Dimension::Stiffness };
    let of_speed = if turns { Dimension::AngularSpeed } else { Dimension::Speed };
    for ((field, given), expected) in [(stiffness, of_stiffness), (speed, of_speed)] {
        if given.is_some_and(|dimension| dimension != expected) {
            let expected = expected.si_unit();
            return Err(StudyError::input(field, Fault::UnitOfMotion { turns, expected }));
        }
    }
    Ok(())
}
