//! Errors of the export to a simulator.

use thiserror::Error;

use super::Tool;
use crate::ContactLawError;
use crate::error::suggestion;

/// Why a tool has no parameters for a contact.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ExportError {
    /// A number out of range, or a restitution that no damping gives.
    #[error(transparent)]
    Contact(#[from] ContactLawError),
    /// The tool's spring has another exponent.
    #[error("{tool}: its contact spring cannot have the exponent {exponent:?}: {takes}; {remedy}")]
    Exponent {
        /// The tool.
        tool: Tool,
        /// As asked for.
        exponent: f64,
        /// What the tool has.
        takes: &'static str,
        /// What to do.
        remedy: &'static str,
    },
    /// A number without which there is no answer.
    #[error("{tool}: needs {what}; {why}")]
    Missing {
        /// The tool.
        tool: Tool,
        /// The number, with its unit.
        what: &'static str,
        /// What it is for.
        why: &'static str,
    },
    /// The integrator's own damping is more than the contact is to have.
    #[error(
        "{tool}: at the time step {time_step:?} s its integrator alone damps the contact to a restitution of \
         {reached:.6}; for {restitution:?} the step must be below {largest:?} s"
    )]
    StepTooLong {
        /// The tool.
        tool: Tool,
        /// In s.
        time_step: f64,
        /// As asked for.
        restitution: f64,
        /// With no damping at all.
        reached: f64,
        /// The step at which the integrator's damping is all of it, in s.
        largest: f64,
    },
    /// An explicit integrator cannot follow the contact at this step.
    #[error(
        "{tool}: the time step {time_step:?} s is too long to follow this contact explicitly; it must be at most \
         {largest:?} s"
    )]
    StepTooCoarse {
        /// The tool.
        tool: Tool,
        /// In s.
        time_step: f64,
        /// In s.
        largest: f64,
    },
    /// The tool's own conversion does not reach this restitution.
    #[error("{tool}: the restitution {restitution:?} is not reachable: {why}; {remedy}")]
    Unreachable {
        /// The tool.
        tool: Tool,
        /// As asked for.
        restitution: f64,
        /// What the tool does.
        why: &'static str,
        /// What to do.
        remedy: &'static str,
    },
    /// A tool for which the stops of joints are not written.
    #[error("{tool}: the stop of a joint is not written: {why}; {remedy}; stops are written for {known}")]
    NoStop {
        /// The tool.
        tool: Tool,
        /// What the tool does at a joint's limit.
        why: &'static str,
        /// What to do.
        remedy: &'static str,
        /// The tools that have them.
        known: String,
    },
    /// A tool in which a mechanism with closed loops does not rebound as asked.
    #[error("{tool}: closed loops: {why}; {remedy}")]
    NoLoop {
        /// The tool.
        tool: Tool,
        /// What was measured.
        why: &'static str,
        /// What to do.
        remedy: &'static str,
    },
    /// No tool of this name.
    #[error("\"{name}\" is not a tool that percuss supports{}; known: {known}", suggestion(.nearest))]
    UnknownTool {
        /// As given.
        name: String,
        /// The most similar name, where one is close.
        nearest: Option<&'static str>,
        /// All names, commas between.
        known: String,
    },
}
