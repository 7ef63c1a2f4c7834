//! Closed loops: measured impacts in tools that close loops by constraints.

use super::{Export, ExportError, Request, Tool};

/// Result of impacts with closed loops in a tool.
enum LoopFinding {
    /// Stated in the export of the tool.
    Stated,
    /// Measured: within the stated error bound.
    WithinBound(&'static str),
    /// Measured: error above the bound, so no bound is stated.
    AboveBound(&'static str),
    /// Measured: the restitution is not reached at all.
    Refused { why: &'static str, remedy: &'static str },
    /// Not measured.
    NotExamined,
}

const OTHER_TOOL: &str = "choose a tool that keeps the restitution with closed loops: mujoco, ode, bullet, chrono, opensim, exudyn";

/// Entry of each tool.
const FINDINGS: [(Tool, LoopFinding); Tool::ALL.len()] = [
    (Tool::MUJOCO, LoopFinding::Stated),
    (Tool::DRAKE, LoopFinding::Stated),
    (
        Tool::GAZEBO,
        LoopFinding::Refused {
            why: "the dartsim plugin does not close the loops of a model (gz-physics, issue 25, open in 2026); \
                read there, not measured",
            remedy: OTHER_TOOL,
        },
    ),
    (Tool::GAZEBO_CLASSIC, LoopFinding::NotExamined),
    (Tool::ODE, LoopFinding::Stated),
    (
        Tool::BULLET,
        LoopFinding::WithinBound(
            "Closed loops: a four-bar (m̄ = 68.1 kg, its bodies 2 to 4.8 kg) was measured within the stated error, of hinges between rigid bodies in \
             C++, and closed by a point-to-point constraint in PyBullet, both in double precision. In single precision such slow impacts fail: \
             the travel in a time step has to be far above the rounding of the bodies' places (6e-8 of their distance from the origin); with \
             4e-8 m at 0.4 m the rebound was off by 0.13 to 0.37.",
        ),
    ),
    (
        Tool::PHYSX,
        LoopFinding::AboveBound(
            "Closed loops: no error is stated. In single precision a four-bar (m̄ = 68.1 kg, its bodies 2 to 4.8 kg) of revolute joints between rigid \
             bodies (ovphysx 0.7.0), at 20 mm/s and 1e6 N/m, was off by 0.017, 0.017, 0.006 for 0.2, 0.5, 0.8 with PGS and by 0.11, 0.09, 0.04 \
             with TGS, and more iterations did not help; at 2 mm/s, where the travel in a time step is that of the rounding of the bodies' places, \
             -0.1 to 0.7 came of 0.5.",
        ),
    ),
    (
        Tool::RAPIER,
        LoopFinding::Refused {
            why: "mechanisms with loops do not reach the restitution: a four-bar of multibody joints closed by \
                an impulse joint had a restitution of 0.0, a four-bar of impulse joints alone 0.26 to 0.65, for \
                0.5 (0.36.1, steps from 1e-5 to 1e-3 s)",
            remedy: OTHER_TOOL,
        },
    ),
    (
        Tool::CHRONO,
        LoopFinding::WithinBound(
            "Closed loops: a four-bar (m̄ = 68.1 kg) of joints was measured within the stated error, by PSOR and by direct solvers; the joint that \
             closed it held the two directions of its plane only, so that no row was redundant.",
        ),
    ),
    (Tool::ADAMS, LoopFinding::NotExamined),
    (Tool::SIMSCAPE, LoopFinding::NotExamined),
    (
        Tool::DART,
        LoopFinding::AboveBound(
            "Closed loops: no error is stated. DART takes (1 + e)·1e-5·m̄/m̄ₒ from e, m̄ₒ the mass with the loop open, and the linkage's motion in \
             a step adds to it: a four-bar (68.1 kg, open 2.49 kg) closed by a BallJointConstraint was off by 4.1e-4 and 4.9e-4 for 0.5 and 0.8 at \
             1e-6 s, 1.2e-3 and 1.0e-3 at 1e-3 s, 0.02 and 0.04 at 1e-2 s; closed by a RevoluteJointConstraint it flew apart.",
        ),
    ),
    (
        Tool::OPENSIM,
        LoopFinding::WithinBound(
            "Closed loops: a four-bar (m̄ = 68.1 kg) closed by a PointConstraint was measured within the stated error.",
        ),
    ),
    (
        Tool::EXUDYN,
        LoopFinding::WithinBound(
            "Closed loops: a four-bar (m̄ = 68.1 kg) whose last joint holds the two directions of its plane only was measured within the stated \
             error; with redundant rows Exudyn's solver finds its matrix singular.",
        ),
    ),
    (
        Tool::NEWTON,
        LoopFinding::AboveBound(
            "Closed loops: no error is stated. XPBD (1.8.0) let a four-bar come back with 0.50 for 0.5, kept it for some steps, and with 50 and 500 \
             iterations let it fall to 0.01 to 0.35 as the joints followed; Featherstone ignores the joint that \
             closes a loop, and gives no warning, and SemiImplicit takes it as the springs that all its joints \
             are (Newton's documentation; not run).",
        ),
    ),
    (Tool::JOLT, LoopFinding::Stated),
];

/// Adds the finding for a mechanism with constraints (loops, mimics, locks, held points) to an export. Removes the error
/// bound if impacts with loops exceed the bound. Error: impacts with loops do not reach the restitution in this tool.
pub(super) fn add_loop_finding(
    tool: Tool,
    request: &Request,
    mut export: Export,
) -> Result<Export, ExportError> {
    if !request.options.constrained && !request.options.closed_loops {
        return Ok(export);
    }
    let (_, finding) = FINDINGS.iter().find(|(of, _)| *of == tool).expect("all tools are in it");
    match finding {
        LoopFinding::Stated => {}
        LoopFinding::WithinBound(text) if request.options.closed_loops => export.add_assumption(*text),
        LoopFinding::AboveBound(text) if request.options.closed_loops => {
            export.error_bound = None;
            export.add_assumption(*text);
        }
        LoopFinding::Refused { why, remedy } if request.options.closed_loops => {
            return Err(ExportError::NoLoop { tool, why, remedy });
        }
        LoopFinding::WithinBound(_) | LoopFinding::AboveBound(_) | LoopFinding::Refused { .. } | LoopFinding::NotExamined => export.add_assumption(
            "Loops, mimics, locks: the compliance of this tool's constraints during the impact was not examined; compliant \
             constraints change the restitution.",
        ),
    }
    Ok(export)
}
