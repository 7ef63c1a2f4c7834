//! Which damper is asked for.

use crate::error::{Fault, StudyError};
use crate::field::Field;
use crate::measure::{Measure, Measured};
use percuss_contact::exports::{Options, Tool};
use percuss_contact::{ContactLawError, Law, Separation};

/// The restitution wanted, and what else a damper needs beside the mass.
#[derive(Clone, Debug, PartialEq)]
pub struct DampingQuestion {
    /// e, from 0 to 1.
    pub restitution: f64,
    /// k, N/m^p.
    pub stiffness: f64,
    /// p of the spring's force k xᵖ.
    pub exponent: f64,
    /// Approach speed, m/s.
    pub speed: Option<f64>,
    /// The law of the damper.
    pub law: Law,
    /// The other name by which it was asked for.
    pub alias: Option<&'static str>,
    /// When a Kelvin–Voigt contact ends.
    pub separation: Separation,
    /// For which simulators parameters are written.
    pub tools: Vec<Tool>,
    /// What only some simulators need; what a model gives is filled in.
    pub options: Options,
}

impl DampingQuestion {
    /// A linear spring, no speed, the exact law that simulators integrate, for no tool.
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

    /// Takes a law by its name. An alias stands for an exponent or an end of the contact too; what is given besides must
    /// not contradict it.
    ///
    /// # Errors
    /// [`ContactLawError`]: no such law, a contradiction.
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
            fixed,
            got,
        };
        if let (Some(fixed), Some(got)) = (fixed_exponent, exponent)
            && fixed != got
        {
            return Err(contradicts("exponent", fixed.to_string(), got.to_string()));
        }
        if let (Some(fixed), Some(got)) = (fixed_end, separation)
            && fixed != got
        {
            return Err(contradicts("separation", fixed.name().into(), got.name().into()));
        }
        self.alias = alias.map(|a| a.name);
        self.exponent = fixed_exponent.or(exponent).unwrap_or(self.exponent);
        self.separation = fixed_end.or(separation).unwrap_or(self.separation);
        Ok(())
    }
}

/// Refuses units of a turn for what does not turn, the other way round, and units of a linear spring for another.
///
/// # Errors
/// [`StudyError`]: which of stiffness and speed, and the unit that is expected.
pub fn check_units(
    question: &DampingQuestion,
    stiffness: Measured,
    speed: Option<Measured>,
    turns: bool,
) -> Result<(), StudyError> {
    let exponent = question.exponent;
    if stiffness.unit.is_some() && exponent != 1.0 {
        return Err(StudyError::input(Field::Stiffness, Fault::UnitOfLinearSpring { exponent }));
    }
    let stiffness_unit =
        if turns { (Measure::TurnStiffness, "N·m/rad") } else { (Measure::Stiffness, "N/m") };
    let speed_unit = if turns { (Measure::TurnSpeed, "rad/s") } else { (Measure::Speed, "m/s") };
    let given = [(Field::Stiffness, Some(stiffness), stiffness_unit), (Field::Speed, speed, speed_unit)];
    for (field, given, (measure, expected)) in given {
        if given.and_then(|given| given.unit).is_some_and(|unit| unit != measure) {
            return Err(StudyError::input(field, Fault::UnitOfMotion { turns, expected }));
        }
    }
    Ok(())
}
