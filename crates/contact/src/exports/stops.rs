//! Joint stops: tools with a spring and a damper for joint limits, and reasons for the other tools.

use super::simulators::{mujoco, newton, ode, physx};
use super::{Export, ExportError, Request, StopMotion, Tool};

/// Function that exports a joint stop.
type StopExport = fn(&Request, StopMotion) -> Result<Export, ExportError>;

/// Tools with a spring and a damper at joint limits.
const SUPPORTED: [(Tool, StopExport); 4] = [
    (Tool::MUJOCO, mujoco::stop),
    (Tool::ODE, ode::stop),
    (Tool::NEWTON, newton::stop),
    (Tool::PHYSX, physx::stop),
];

/// Remedy for tools without usable joint limits: a contact as the stop.
const USE_CONTACT: &str = "let the two links collide at the stop, and export this contact with --link, --point, \
    --normal and --against";
/// Reason for tools with unexamined joint limits.
const NOT_EXAMINED: &str = "the behaviour of its joint limits in an impact was not examined";

/// Reason and remedy for each of the other tools.
const UNSUPPORTED: [(Tool, &str, &str); Tool::ALL.len() - SUPPORTED.len()] = [
    (
        Tool::DRAKE,
        "discrete plants hold joint limits with a stiffness and a dissipation of their own that cannot be set \
         (with SAP and lagged a joint stops without rebound), continuous plants ignore limits",
        USE_CONTACT,
    ),
    (
        Tool::BULLET,
        "multibodies have rigid limits, and the rebound depends on the solver's erp and the depth in one step \
         (by 0 to 0.6 of the \
         speed at an erp of 0.9, in PyBullet 3.2.7)",
        USE_CONTACT,
    ),
    (
        Tool::GAZEBO_CLASSIC,
        "its <physics><ode><limit> was not run with exported numbers",
        "use --for ode, whose erp and cfm apply to that element, and measure the rebound; or use a contact",
    ),
    (Tool::GAZEBO, NOT_EXAMINED, USE_CONTACT),
    (Tool::RAPIER, NOT_EXAMINED, USE_CONTACT),
    (Tool::CHRONO, NOT_EXAMINED, USE_CONTACT),
    (Tool::ADAMS, NOT_EXAMINED, USE_CONTACT),
    (Tool::SIMSCAPE, NOT_EXAMINED, USE_CONTACT),
    (Tool::DART, NOT_EXAMINED, USE_CONTACT),
    (Tool::OPENSIM, NOT_EXAMINED, USE_CONTACT),
    (Tool::EXUDYN, NOT_EXAMINED, USE_CONTACT),
    (Tool::JOLT, NOT_EXAMINED, USE_CONTACT),
];

/// Exports a joint stop. Error: the tool has no spring and damper for joint limits.
pub(super) fn export(tool: Tool, request: &Request, motion: StopMotion) -> Result<Export, ExportError> {
    if let Some((_, export_stop)) = SUPPORTED.iter().find(|(of, _)| *of == tool) {
        return export_stop(request, motion);
    }
    let (_, why, remedy) =
        UNSUPPORTED.iter().find(|(of, ..)| *of == tool).expect("a tool is in one of the two");
    let known = SUPPORTED.map(|(tool, _)| tool.name()).join(", ");
    Err(ExportError::NoStop { tool, why, remedy, known })
}
