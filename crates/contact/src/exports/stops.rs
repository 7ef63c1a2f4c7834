//! The stops of joints: which tools have a spring and a damper for them, and why the others have none.

use super::{Export, ExportError, Request, StopMotion, Tool, mujoco, newton, ode, physx};

/// What writes the stop of a joint for a tool.
type Write = fn(&Request, StopMotion) -> Result<Export, ExportError>;

/// The tools that stop a joint by a spring and a damper of its own.
const WRITTEN: [(Tool, Write); 4] = [
    (Tool::MUJOCO, mujoco::stop),
    (Tool::ODE, ode::stop),
    (Tool::NEWTON, newton::stop),
    (Tool::PHYSX, physx::stop),
];

/// What to do where a tool's limits cannot be used: the stop as a contact.
const AS_CONTACT: &str = "let the two links collide at the stop, and ask for that contact with --link, --point, --normal and --against";
/// Of the tools whose limits were not examined.
const NOT_EXAMINED: &str = "percuss does not know what its joints' limits do in an impact";

/// (why, what to do) for each of the others.
const NOT_WRITTEN: [(Tool, &str, &str); Tool::ALL.len() - WRITTEN.len()] = [
    (
        Tool::DRAKE,
        "discrete plants hold joint limits with a stiffness and a dissipation of their own that cannot be set (with SAP and \
         lagged a joint stops dead), continuous plants ignore limits",
        AS_CONTACT,
    ),
    (
        Tool::BULLET,
        "multibodies hold limits rigidly, and rebound by what the solver's erp makes of the depth in one step (by 0 to 0.6 of the \
         speed at an erp of 0.9, in PyBullet 3.2.7)",
        AS_CONTACT,
    ),
    (
        Tool::GAZEBO_CLASSIC,
        "its <physics><ode><limit> was not run with exported numbers",
        "ask for --for ode, whose erp and cfm that element takes, and measure the rebound; or use a contact",
    ),
    (Tool::GAZEBO, NOT_EXAMINED, AS_CONTACT),
    (Tool::RAPIER, NOT_EXAMINED, AS_CONTACT),
    (Tool::CHRONO, NOT_EXAMINED, AS_CONTACT),
    (Tool::ADAMS, NOT_EXAMINED, AS_CONTACT),
    (Tool::SIMSCAPE, NOT_EXAMINED, AS_CONTACT),
    (Tool::DART, NOT_EXAMINED, AS_CONTACT),
    (Tool::OPENSIM, NOT_EXAMINED, AS_CONTACT),
    (Tool::EXUDYN, NOT_EXAMINED, AS_CONTACT),
    (Tool::JOLT, NOT_EXAMINED, AS_CONTACT),
];

/// The stop of a joint for a tool. Error: the tool has no spring and damper for it.
pub(super) fn export(tool: Tool, request: &Request, motion: StopMotion) -> Result<Export, ExportError> {
    if let Some((_, write)) = WRITTEN.iter().find(|(of, _)| *of == tool) {
        return write(request, motion);
    }
    let (_, why, remedy) =
        NOT_WRITTEN.iter().find(|(of, ..)| *of == tool).expect("a tool is in one of the two");
    let known = WRITTEN.map(|(tool, _)| tool.name()).join(", ");
    Err(ExportError::NoStop { tool, why, remedy, known })
}
