//! Errors of the export to a simulator.

use thiserror::Error;

use super::Tool;
use crate::error::suggestion;
use crate::{ContactLawError, LawParameter};

/// Reason for missing parameters of a tool.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ExportError {
    /// Number out of range, or restitution that no damping gives.
    #[error(transparent)]
    Contact(#[from] ContactLawError),
    /// The spring of the tool has a different exponent.
    #[error("{tool}: its contact spring cannot have the exponent {exponent:?}: {takes}; {remedy}")]
    Exponent {
        /// Tool.
        tool: Tool,
        /// Required value.
        exponent: f64,
        /// Exponents of the tool.
        takes: &'static str,
        /// Remedy.
        remedy: &'static str,
    },
    /// Missing number that the parameters depend on.
    #[error("{tool}: needs the {what}; {why}")]
    Missing {
        /// Tool.
        tool: Tool,
        /// The number.
        what: LawParameter,
        /// Purpose of the number.
        why: &'static str,
    },
    /// The numerical damping of the integrator exceeds the required damping.
    #[error(
        "{tool}: at the time step {time_step:?} s its integrator alone damps the contact to a restitution of \
         {reached:.6}; for {restitution:?} the step must be below {largest:?} s"
    )]
    StepTooLong {
        /// Tool.
        tool: Tool,
        /// Time step, in s.
        time_step: f64,
        /// Required value.
        restitution: f64,
        /// Restitution with zero damping at this step.
        reached: f64,
        /// Time step at which the numerical damping equals the required damping, in s.
        largest: f64,
    },
    /// Time step too long for an explicit integrator.
    #[error(
        "{tool}: the time step {time_step:?} s is too long for an explicit integration of this contact; it must be at most \
         {largest:?} s"
    )]
    StepTooCoarse {
        /// Tool.
        tool: Tool,
        /// Time step, in s.
        time_step: f64,
        /// Longest permitted time step, in s.
        largest: f64,
    },
    /// Restitution that the conversion of the tool cannot reach.
    #[error("{tool}: the restitution {restitution:?} is not reachable: {why}; {remedy}")]
    Unreachable {
        /// Tool.
        tool: Tool,
        /// Required value.
        restitution: f64,
        /// Behaviour of the tool.
        why: &'static str,
        /// Remedy.
        remedy: &'static str,
    },
    /// Tool without an export of joint stops.
    #[error("{tool}: the stop of a joint is not written: {why}; {remedy}; stops are written for {known}")]
    NoStop {
        /// Tool.
        tool: Tool,
        /// Behaviour of the tool at a joint limit.
        why: &'static str,
        /// Remedy.
        remedy: &'static str,
        /// Tools with an export of joint stops.
        known: String,
    },
    /// Contact that is a moment about an axis.
    #[error(
        "{tool}: the contact is a moment about an axis, but contacts in simulators act at points; give the stop of a joint (JOINT:lower or \
         JOINT:upper), or a contact point with a normal"
    )]
    Moment {
        /// Tool.
        tool: Tool,
    },
    /// Tool in which mechanisms with closed loops do not reach the required restitution.
    #[error("{tool}: closed loops: {why}; {remedy}")]
    NoLoop {
        /// Tool.
        tool: Tool,
        /// Measured behaviour.
        why: &'static str,
        /// Remedy.
        remedy: &'static str,
    },
    /// Invalid, missing or unknown parameter of the tool.
    #[error("{tool}: the parameter {name}: {why}")]
    Parameter {
        /// Tool.
        tool: Tool,
        /// Name of the parameter.
        name: String,
        /// Received and expected value.
        why: String,
    },
    /// Unknown name of a tool.
    #[error("\"{name}\" is not a tool that percuss supports{}; known: {known}", suggestion(.nearest))]
    UnknownTool {
        /// Given name.
        name: String,
        /// Most similar name, if one is close.
        nearest: Option<&'static str>,
        /// All names, separated by commas.
        known: String,
    },
}

impl ExportError {
    /// Parameter that is missing or invalid.
    pub fn parameter(&self) -> Option<LawParameter> {
        match self {
            Self::Contact(error) => error.parameter(),
            Self::Exponent { .. } => Some(LawParameter::Exponent),
            Self::Missing { what, .. } => Some(*what),
            Self::Unreachable { .. } => Some(LawParameter::Restitution),
            Self::StepTooLong { .. } | Self::StepTooCoarse { .. } => Some(LawParameter::TimeStep),
            _ => None,
        }
    }
}
