//! Safe speed for one mass of the robot.

use crate::question::errors::question_error::StudyError;
use crate::question::tables::safe_speed::Limit;
use percuss_contact::{BodyRegion, ContactLawError, SafeSpeed, TransientContact};
use schemars::JsonSchema;
use serde::Serialize;

/// Speed for one mass of the robot.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct SpeedRecord {
    /// Robot mass m_R, kg: the mass of the standard, or the effective mass plus its error bound (at a singular pose the
    /// largest limit along the branches). Null if the robot is immovable.
    pub robot_mass: Option<f64>,
    /// μ = 1/(1/m_H + 1/m_R), kg; null if neither side can move.
    pub reduced_mass: Option<f64>,
    /// Largest relative speed, m/s.
    pub speed: f64,
}

/// Safe speed for a robot mass, kg; `None` for an immovable robot.
pub(super) fn safe_speed_record(
    region: Option<&BodyRegion>,
    limit: Limit,
    robot_mass: Option<f64>,
) -> Result<(SpeedRecord, Option<SafeSpeed>), ContactLawError> {
    let contact = match (robot_mass, region) {
        (Some(mass), Some(region)) => TransientContact::new(region, mass)?,
        (None, Some(region)) => TransientContact::immovable(region),
        (Some(mass), None) => TransientContact::against_fixed_body(mass)?,
        (None, None) => {
            return Ok((SpeedRecord { robot_mass, reduced_mass: None, speed: 0.0 }, None));
        }
    };
    let safe = match limit {
        Limit::Force(force) => contact.speed_for_force(force),
        Limit::Pressure(pressure, area) => contact.speed_for_pressure(pressure, area),
        Limit::Energy(energy) => contact.speed_for_energy(energy),
        Limit::Momentum(momentum) => contact.speed_for_momentum(momentum),
    }?;
    let reduced_mass = Some(contact.reduced_mass());
    Ok((SpeedRecord { robot_mass, reduced_mass, speed: safe.speed }, Some(safe)))
}

/// Error: the error of m̄ is unknown.
pub(super) fn mass_unknown() -> StudyError {
    let why = "the error of the effective mass is unknown: near this pose the effective mass is not finite; no safe speed can be stated";
    StudyError::NoResult(why.to_owned())
}
