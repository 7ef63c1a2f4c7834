//! Bullet and PyBullet: contact stiffness and contact damping.

use super::linear::Linear;
use super::{Export, ExportError, Facts, Request, Tool};

const TOOL: Tool = Tool::of(&FACTS);

pub(super) const FACTS: Facts = Facts {
    name: "bullet",
    title: "Bullet",
    aliases: &["pybullet", "bullet3"],
    law: "linear spring and damper, never pulling, by implicit Euler",
    combines: "stiffnesses in series, dampings added, restitutions multiplied",
    measured: &[],
    caution: "",
    sources: &[
        "Bullet 3, src/BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.cpp: setupContactConstraint",
        "Bullet 3, src/BulletDynamics/Featherstone/btMultiBodyConstraintSolver.cpp",
        "Bullet 3, src/BulletCollision/CollisionDispatch/btManifoldResult.cpp",
    ],
};

/// For each of two bodies contactStiffness = 2k, contactDamping = c'/2.
///
/// Bullet puts the stiffnesses in series and adds the dampings, makes h k/(h k + c') and 1/(h k + c') of them, and so
/// integrates max(0, k (x − h v⁺) − c' v⁺) by implicit Euler, on the mass of the whole multibody. c' = 2ζ'√(k m̄),
/// ζ' = ζ − ωh/2.
///
/// Measured in PyBullet 3.2.7 at the recommended step, e = 0.2, 0.5, 0.8, the worst of nine phases: 1.4e-4, 2.4e-4, 3.0e-4,
/// ball and pendulum alike; with the struck body's own 1.5 kg for m̄ = 2.28 kg: 0.252, 0.562, 0.833.
pub(super) fn export(request: &Request) -> Result<Export, ExportError> {
    let linear = Linear::of(request, TOOL)?;
    let step = linear.implicit_step();
    let damping = linear.damping(linear.implicit_ratio(step)?) / 2.0;
    let stiffness = 2.0 * linear.stiffness;
    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.error_bound = Some(linear.implicit_error_bound(step));
    export.set("contactStiffness", stiffness, "N/m");
    export.set("contactDamping", damping, "N·s/m");
    export.set("restitution", 0.0, "");
    export.set("fixedTimeStep", step, "s");
    export.write(
        "PyBullet",
        "python",
        format!(
            "import pybullet\n\n\ndef set_contact(body, link):\n    \"\"\"For both bodies of the pair.\"\"\"\n    \
             pybullet.changeDynamics(\n        body, link,\n        contactStiffness={stiffness:?}, contactDamping={damping:?},\n        \
             restitution=0.0, linearDamping=0.0, angularDamping=0.0, jointDamping=0.0,\n    )\n\n\n\
             def set_step():\n    pybullet.setPhysicsEngineParameter(fixedTimeStep={step:?}, numSubSteps=0, numSolverIterations=50)\n"
        ),
    );
    export.write(
        "Bullet",
        "cpp",
        format!(
            "// For both bodies of the pair; sets CF_HAS_CONTACT_STIFFNESS_DAMPING.\n\
             body->setContactStiffnessAndDamping({stiffness:?}, {damping:?});\n\
             body->setRestitution(0.0);\n\
             // In the loop:\n\
             world->stepSimulation({step:?}, 0);\n"
        ),
    );
    export.assume(
        "Both bodies have these values: a body with default values adds a damping of 0.1 N·s/m and is rigid.",
    );
    export.assume(linear.implicit_words(step));
    export.assume(
        "restitution is 0: it would come on top of the spring, as the product of both bodies' values above 0.2 m/s.",
    );
    export.assume("Bullet is built in double precision, as PyBullet is.");
    export.cannot.push(
        "a faithful rigid bounce: restitution acts on contacts that are still open, and gives 0.43 … 0.58 for 0.5 at 240 Hz",
    );
    Ok(export)
}
