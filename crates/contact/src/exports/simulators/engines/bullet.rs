//! Bullet and PyBullet: contact stiffness and contact damping.

use crate::exports::linear::Linear;
use crate::exports::simulators::simulated::{Given, SimulatedContact};
use crate::exports::single_precision;
use crate::exports::{Export, ExportError, Facts, Measurement, Request, Tool};

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "bullet",
    title: "Bullet",
    aliases: &["pybullet", "bullet3"],
    law: "linear spring and damper, never pulling, by implicit Euler",
    combines: "stiffnesses in series, dampings added, restitutions multiplied",
    measured: &[
        Measurement {
            engine: "PyBullet 3.2.7",
            solver: "",
            scenes: "ball; pendulums, m̄ = 1.5 and 3.75 kg of a 2 kg body; four-bar closed by a point-to-point constraint, m̄ = 68.1 kg",
            worst: [Some(1.7e-4), Some(2.8e-4), Some(3.4e-4)],
            by_hand: None,
        },
        Measurement {
            engine: "Bullet 3.24",
            solver: "rigid bodies, single precision",
            scenes: "ball; pendulums on a hinge constraint, m̄ = 1.5 and 3.75 kg of a 2 kg body",
            worst: [Some(1.6e-4), Some(2.5e-4), Some(3.1e-4)],
            by_hand: None,
        },
        Measurement {
            engine: "Bullet 3.24",
            solver: "rigid bodies, double precision",
            scenes: "ball; pendulums on a hinge constraint, m̄ = 1.5 and 3.75 kg of a 2 kg body; four-bar of hinges, m̄ = 68.1 kg",
            worst: [Some(1.7e-4), Some(2.8e-4), Some(3.4e-4)],
            by_hand: None,
        },
    ],
    caution: "friction and contactSlop 0 as written: PyBullet's defaults change the rebound of levers, and the compression",
    sources: &[
        "Bullet 3, src/BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.cpp: setupContactConstraint",
        "Bullet 3, src/BulletDynamics/Featherstone/btMultiBodyConstraintSolver.cpp",
        "Bullet 3, src/BulletCollision/CollisionDispatch/btManifoldResult.cpp",
    ],
};

/// For each of two bodies contactStiffness = 2k, contactDamping = c'/2.
///
/// Bullet combines the stiffnesses in series, adds the dampings, computes h k/(h k + c') and 1/(h k + c'), and
/// integrates max(0, k (x − h v⁺) − c' v⁺) by implicit Euler with the effective mass of the whole multibody. c' =
/// 2ζ'√(k m̄), ζ' = ζ − ωh/2.
///
/// Measured in PyBullet 3.2.7 at the recommended step, e = 0.2, 0.5, 0.8, the worst of five phases: 1.4e-4, 2.3e-4,
/// 3.0e-4, ball and pendulum alike; with the 2 kg of the contact link alone for m̄ = 3.75 kg: 0.280, 0.591, 0.848.
/// Bullet 3.24 in C++, rigid bodies and a hinge constraint, single and double precision: the same to 1e-5. With
/// lateralFriction 0.5 on both sides the pendulum shows 0.276, 0.584, 0.837. The four-bar (m̄ = 68.1 kg), closed by a
/// point-to-point constraint: 1.6e-4, 2.7e-4, 3.3e-4; with the coupler's own 4.8 kg 0.580, 0.815, 0.941. With 4k/3
/// and 4k, c'/4 and 3c'/4 on the two sides a ball rebounds as with equal ones.
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let linear = Linear::of(request, TOOL)?;
    let step = linear.implicit_step();
    let damping = linear.damping(linear.implicit_ratio(step)?) / 2.0;
    let stiffness = 2.0 * linear.stiffness;
    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.error_bound = Some(linear.implicit_error_bound(step));
    export.single_precision_error = single_precision::error(request, step);
    export.add_penetration("", linear.penetration(request.speed));
    export.set("contactStiffness", stiffness, "N/m");
    export.set("contactDamping", damping, "N·s/m");
    export.set("restitution", 0.0, "");
    for friction in ["lateralFriction", "rollingFriction", "spinningFriction"] {
        export.set(friction, 0.0, "");
    }
    export.set("contactSlop", 0.0, "m");
    export.set("fixedTimeStep", step, "s");
    export.add_snippet(
        "PyBullet",
        "python",
        format!(
            "import pybullet\n\n\ndef set_contact(body, link):\n    \"\"\"For both bodies of the pair.\"\"\"\n    \
             pybullet.changeDynamics(\n        body, link,\n        contactStiffness={stiffness:?}, contactDamping={damping:?},\n        \
             restitution=0.0, lateralFriction=0.0, rollingFriction=0.0, spinningFriction=0.0,\n        \
             linearDamping=0.0, angularDamping=0.0, jointDamping=0.0,\n    )\n\n\n\
             def set_step():\n    pybullet.setPhysicsEngineParameter(\n        fixedTimeStep={step:?}, numSubSteps=0, \
             numSolverIterations=50, contactSlop=0.0,\n    )\n"
        ),
    );
    export.add_snippet(
        "Bullet",
        "cpp",
        format!(
            "// For both bodies of the pair; sets CF_HAS_CONTACT_STIFFNESS_DAMPING.\n\
             body->setContactStiffnessAndDamping({stiffness:?}, {damping:?});\n\
             body->setRestitution(0.0);\n\
             body->setFriction(0.0);\n\
             body->setRollingFriction(0.0);\n\
             body->setSpinningFriction(0.0);\n\
             body->setDamping(0.0, 0.0);\n\
             world->getSolverInfo().m_linearSlop = 0.0;\n\
             // In the loop:\n\
             world->stepSimulation({step:?}, 0);\n"
        ),
    );
    export.add_assumption(
        "Both bodies have these values: a body with default values adds a damping of 0.1 N·s/m and is rigid.",
    );
    export.add_assumption(linear.implicit_assumption(step));
    export.add_assumption(match export.single_precision_error {
        Some(error) => format!(
            "Double precision (as PyBullet). A build of single precision adds {error:.1e} to the stated error: the rounding of coordinates up to \
             1 m, 3e-8 m, over the travel in a time step."
        ),
        None => "Double precision (as PyBullet): a build of single precision adds to the error, by an amount \
            that depends on the speed.".to_owned(),
    });
    export.add_assumption(
        "restitution is 0: above 0.2 m/s the product of both bodies' values would add to the rebound of the spring.",
    );
    export.add_assumption(
        "Frictionless: with lateralFriction 0.5 on both sides the error of a pendulum's restitution is up to 0.08.",
    );
    export.add_assumption(
        "contactSlop is 0: with PyBullet's 10 µm the compression increases by 10 µm. In C++ the default is 0.",
    );
    export.cannot.push(
        "an accurate rigid bounce: restitution acts before the contact closes, and gives 0.43 … 0.58 for 0.5 at \
         240 Hz",
    );
    Ok(export)
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let stiffness = given.positive("contactStiffness")? / 2.0;
    let damping = 2.0 * given.number("contactDamping")?;
    let step = given.positive("fixedTimeStep")?;
    for name in ["restitution", "lateralFriction", "rollingFriction", "spinningFriction", "contactSlop"] {
        given.assume(name, 0.0)?;
    }
    Ok(vec![SimulatedContact::implicit(given, stiffness, damping, step)?])
}
