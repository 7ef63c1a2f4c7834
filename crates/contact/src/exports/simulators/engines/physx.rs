//! PhysX 5, Isaac Sim and Isaac Lab: compliant contacts.

use crate::exports::export::check_single_precision;
use crate::exports::linear::{Linear, UnclampedLinear};
use crate::exports::simulators::simulated::{Given, SimulatedContact};
use crate::exports::single_precision;
use crate::exports::{Export, ExportError, Facts, Measurement, Request, StopMotion, Tool};
use crate::limits;

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "physx",
    title: "PhysX and Isaac",
    aliases: &["isaac", "isaac-sim", "isaac-lab", "isaaclab"],
    law: "linear spring and damper, never pulling, by implicit Euler; of each position iteration with TGS",
    combines: "by the combine mode, average by default; of a rigid and a compliant material, the compliant one \
        counts",
    measured: &[
        Measurement {
            engine: "ovphysx 0.7.0",
            solver: "PGS",
            scenes: "ball of 2 kg; pendulums of m̄ = 1.5 and 3.75 kg, by a joint; stop of a hinge",
            worst: [Some(8e-4), Some(9e-4), Some(9e-4)],
            by_hand: Some("2026-11-22"),
        },
        Measurement {
            engine: "ovphysx 0.7.0",
            solver: "TGS, 0 velocity iterations",
            scenes: "ball of 2 kg; pendulums of m̄ = 1.5 and 3.75 kg, by a joint",
            worst: [Some(7e-4), Some(7e-4), Some(7e-4)],
            by_hand: Some("2026-11-22"),
        },
    ],
    caution: "PGS and TGS (Isaac Lab's default) need different dampings, and TGS no velocity iterations; never the acceleration mode; single precision: the stated error grows as the travel in a step shrinks; none is stated for closed loops",
    sources: &[
        "PhysX 5, physx/include/PxMaterial.h",
        "PhysX 5, physx/source/lowleveldynamics/src/DyContactPrepShared.h: computeCompliantContactCoefficients",
        "PhysX 5, physx/source/physxextensions/src/ExtConstraintHelper.h: addLimit; ExtRevoluteJoint.cpp: computePhi",
        "Isaac Lab, isaaclab.sim.spawners.materials: RigidBodyMaterialCfg",
        "ovphysx 0.7.0 (PyPI), run",
    ],
};

/// Force mode: stiffness k, damping c' = 2ζ'√(k m̄).
///
/// PhysX's compliant contact is a = h(c + h k), impulse scale 1/(1 + a/m̄): implicit Euler of the linear spring and
/// damper. PGS uses the step of the scene: ζ' = ζ − ωh/2. TGS divides the step among N position iterations: ζ' = ζ −
/// ωh/(2N). Velocity iterations apply the contact again: errors for e = 0.2, 0.5, 0.8 with the damping of PGS and 16
/// position iterations and 1 velocity iteration 1.4e-2, 1.8e-2, 4.9e-3, with 4 and 1 4.9e-2, 6.8e-2, 3.7e-2; with 0
/// velocity iterations and the damping of TGS 7e-4. A negative restitution of the material is a stiffness.
///
/// Closed loops have no bound: the error of a four-bar of revolute joints is 0.017 with PGS and 0.11 with TGS at 20
/// mm/s (single precision).
///
/// The acceleration mode is not exported: PhysX multiplies stiffness and damping by the effective mass of the body
/// without joints (a pendulum with 1.667 kg without the joint: 0.305 and 0.616 for 0.2 and 0.5).
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let linear = Linear::of(request, TOOL)?;
    let step = linear.implicit_step();
    let damping = linear.damping(linear.implicit_ratio(step)?);
    let position_iterations = limits::TGS_POSITION_ITERATIONS;
    let tgs = linear.damping(linear.implicit_ratio(step / position_iterations)?);
    let stiffness = linear.stiffness;
    for (what, value) in [
        ("PhysX's stiffness, N/m", stiffness),
        ("PhysX's damping, N·s/m", damping),
        ("PhysX's damping for TGS, N·s/m", tgs),
        ("PhysX's time step, s", step),
    ] {
        check_single_precision(what, value)?;
    }
    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.error_bound = Some(linear.implicit_error_bound(step));
    export.add_penetration("", linear.penetration(request.speed));
    export.set("compliant_contact_stiffness", stiffness, "N/m");
    export.set("compliant_contact_damping", damping, "N·s/m");
    export.set("compliant_contact_damping_tgs", tgs, "N·s/m");
    export.set("tgs_position_iterations", position_iterations, "");
    export.set("tgs_velocity_iterations", 0.0, "");
    export.set("dt", step, "s");
    export.add_snippet(
        "PhysX, PGS",
        "cpp",
        format!(
            "// PhysX 5; a negative restitution is a stiffness. Force mode: the flag for the acceleration mode stays off\n\
             // (PxMaterialFlag::eCOMPLIANT_ACCELERATION_SPRING; versions up to 5.1.3 have only eCOMPLIANT_CONTACT, which must be on).\n\
             material->setRestitution({:?}f);\n\
             material->setDamping({damping:?}f);\n\
             // PxSceneDesc::solverType = physx::PxSolverType::ePGS. In the loop:\n\
             scene->simulate({step:?}f);\n",
            -stiffness
        ),
    );
    export.add_snippet(
        "PhysX, TGS",
        "cpp",
        format!(
            "// As above, with PxSceneDesc::solverType = physx::PxSolverType::eTGS.\n\
             material->setRestitution({:?}f);\n\
             material->setDamping({tgs:?}f);\n\
             body->setSolverIterationCounts({position_iterations:.0}, 0);\n\
             scene->simulate({step:?}f);\n",
            -stiffness
        ),
    );
    export.add_snippet(
        "Isaac Lab, TGS",
        "python",
        format!(
            "import isaaclab.sim as sim_utils\n\n\
             material = sim_utils.RigidBodyMaterialCfg(\n    restitution=0.0, static_friction=0.0, dynamic_friction=0.0,\n    \
             compliant_contact_stiffness={stiffness:?},\n    compliant_contact_damping={tgs:?},\n)\n\
             body = sim_utils.RigidBodyPropertiesCfg(\n    solver_position_iteration_count={position_iterations:.0}, \
             solver_velocity_iteration_count=0,\n    linear_damping=0.0, angular_damping=0.0,\n)\n\
             # solver_type: 0 PGS, 1 TGS. An articulation has iteration counts of its own, in ArticulationRootPropertiesCfg.\n\
             simulation = sim_utils.SimulationCfg(\n    dt={step:?},\n    \
             physx=sim_utils.PhysxCfg(solver_type=1, min_velocity_iteration_count=0),\n)\n"
        ),
    );
    export.add_assumption(
        "Both materials have these values (two compliant materials are combined by the combine mode, average by \
         default), or the other is rigid: the compliant one then wins.",
    );
    export.add_assumption(format!(
        "PGS, or TGS with {position_iterations:.0} position iterations and no velocity iterations and the damping for it; another number of \
         position iterations needs another damping. Friction 0."
    ));
    export.add_assumption(linear.implicit_assumption(step));
    // TGS moves the bodies in each position iteration.
    single_precision::add(&mut export, TOOL, request, step / position_iterations, "m")?;
    export.cannot.push(
        "the acceleration mode of a body with joints: PhysX multiplies by the free body's mass there, not by m̄",
    );
    Ok(export)
}

/// A soft limit of a joint between rigid bodies: `PxSpring`'s stiffness k and damping c', which pull.
///
/// PhysX has a row for a soft limit only if the joint is past the limit: implicit Euler of k x + c' ẋ in SI units
/// (force mode, not the acceleration mode of a drive). Unlike a compliant contact the limit pulls, so ζ is that of a
/// contact that ends at the closed gap, ζ' = ζ − ωh/2. Measured with the damper of a contact that does not pull:
/// 0.0905, 0.436, 0.791 for 0.2, 0.5, 0.8, equal to exp(−πζ/√(1−ζ²)).
///
/// Measured in ovphysx 0.7.0 with PGS, a hinge: within 1.6e-4, 2.2e-4, 4.2e-4. TGS, and mechanisms of several bodies,
/// were not measured.
pub(crate) fn stop(request: &Request, motion: StopMotion) -> Result<Export, ExportError> {
    let unclamped = UnclampedLinear::of(request, TOOL)?;
    let (step, linear) = (unclamped.implicit_step(), unclamped.0);
    let damping = linear.damping(unclamped.implicit_ratio(step)?);
    let stiffness = linear.stiffness;
    for (what, value) in [
        ("PhysX's stiffness of a limit", stiffness),
        ("PhysX's damping of a limit", damping),
        ("PhysX's time step, s", step),
    ] {
        check_single_precision(what, value)?;
    }
    let units = motion.units();
    let (limit, joint) = match motion {
        StopMotion::Turn => ("PxJointAngularLimitPair", "PxRevoluteJoint"),
        StopMotion::Slide => ("PxJointLinearLimitPair", "PxPrismaticJoint"),
    };
    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.add_penetration("", linear.penetration(request.speed));
    // Measured errors: shoulder of an open chain 2.2e-2, closed loops 0.01 to 2.2.
    let single_body = request.options.moving_bodies.is_none_or(|bodies| bodies == 1);
    export.error_bound = (single_body && !request.options.constrained).then(|| unclamped.error_bound(step));
    export.set("limit_stiffness", stiffness, units.stiffness);
    export.set("limit_damping", damping, units.damping);
    export.set("dt", step, "s");
    export.add_snippet(
        "PhysX, PGS",
        "cpp",
        format!(
            "// PhysX 5; joint is a physx::{joint}.\n\
             joint->setLimit(physx::{limit}(lower, upper, physx::PxSpring({stiffness:?}f, {damping:?}f)));\n\
             joint->set{0}Flag(physx::{joint}Flag::eLIMIT_ENABLED, true);\n\
             // PxSceneDesc::solverType = physx::PxSolverType::ePGS. In the loop:\n\
             scene->simulate({step:?}f);\n",
            joint.trim_start_matches("Px")
        ),
    );
    export.add_assumption(linear.implicit_assumption(step));
    export.add_assumption("Joints between rigid bodies, with PGS. Both ends of the range have these values.");
    single_precision::add(&mut export, TOOL, request, step, units.coordinate)?;
    if export.error_bound.is_none() && request.speed.is_some() {
        export.add_assumption(
            "No error is stated for mechanisms of several bodies: the shoulder of an open chain had an error of \
             2.2e-2, stops in closed loops 0.01 to 2.2. Choose mujoco or ode.",
        );
    }
    export.add_assumption(
        "The angle of a revolute joint is found from an arc cosine: with the joint frames turned so that the stop is \
         between 0.3 and 3 rad, it is known to 4e-7 rad; near 0 it is not.",
    );
    export.cannot.push(
        "stops of articulations (PxArticulationReducedCoordinate, Isaac Lab's robots): their limits have no spring (PxArticulationLimit: low \
         and high); TGS and mechanisms of several bodies: not measured",
    );
    Ok(export)
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let stiffness = given.positive("compliant_contact_stiffness")?;
    let step = given.positive("dt")?;
    let position_iterations =
        given.optional("tgs_position_iterations")?.unwrap_or(limits::TGS_POSITION_ITERATIONS);
    given.assume("tgs_velocity_iterations", 0.0)?;
    let solvers = [
        ("PGS", "compliant_contact_damping", step),
        ("TGS", "compliant_contact_damping_tgs", step / position_iterations),
    ];
    let mut found = Vec::new();
    for (solver, name, step) in solvers {
        if let Some(damping) = given.optional(name)? {
            found.push(SimulatedContact::implicit(given, stiffness, damping, step)?.of_solver(solver));
        }
    }
    if found.is_empty() {
        return Err(given.refuse(
            "compliant_contact_damping",
            "it is required, or compliant_contact_damping_tgs for TGS",
        ));
    }
    Ok(found)
}
