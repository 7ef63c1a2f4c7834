//! Jolt Physics, as in Godot: a coefficient of restitution.

use super::export::single;
use super::{Export, ExportError, Facts, Measurement, Request, Tool};
use crate::limits;

const TOOL: Tool = Tool::of(&FACTS);

pub(super) const FACTS: Facts = Facts {
    name: "jolt",
    title: "Jolt Physics",
    aliases: &["jolt-physics", "joltphysics", "godot"],
    law: "Newton's restitution: the speed of separation is e times that of approach",
    combines: "the greater of the two restitutions; frictions by the root of their product",
    measured: &[
        Measurement {
            engine: "jolt-physics 1.1.0",
            solver: "50 velocity steps",
            scenes: "ball of 2 kg; pendulums of m̄ = 1.5 and 3.75 kg",
            worst: [Some(1e-6), Some(3e-6), Some(8e-6)],
            by_hand: None,
        },
        Measurement {
            engine: "jolt-physics 1.1.0",
            solver: "1000 velocity steps",
            scenes: "four-bar of hinges, m̄ = 68.1 kg",
            worst: [Some(2e-4), Some(4e-4), Some(6e-4)],
            by_hand: None,
        },
    ],
    caution: "mMinVelocityForRestitution is 1 m/s by default: slower impacts do not bounce at all; closed loops need the many velocity steps exported for them",
    sources: &[
        "Jolt Physics 5, Jolt/Physics/Constraints/ContactConstraintManager.cpp: CalculateFrictionAndNonPenetrationConstraintProperties",
        "Jolt Physics 5, Jolt/Physics/PhysicsSettings.h",
        "jolt-physics 1.1.0 (npm), run with the same and with different restitutions of the two sides",
    ],
};

/// `mRestitution` = e for both bodies, and `mMinVelocityForRestitution` half the speed.
///
/// Jolt's contact asks for the speed −e v of the contact points where v is above the threshold and the gap closes within the step.
/// A free body gets it to single precision. Joints are rows beside it, solved in turns, `mNumVelocitySteps` times: of a
/// pendulum with a rotor 10 turns (the default) leave (1 + e)·8e-4, 50 leave none. A four-bar (m̄ = 68.1 kg, its bodies 2 to 4.8 kg) settles
/// more slowly: for e = 0.5 it rebounds with 0.04 after 50 turns, 0.441 after 200, 0.4986 after 500, and 0.4996 from 1000 on, at steps of 1e-3
/// and 1e-4 s alike. Of other linkages the error is not known, and none is stated.
pub(super) fn export(request: &Request) -> Result<Export, ExportError> {
    let e = request.restitution;
    let mut export = Export::new(TOOL);
    let threshold = request.speed.map_or(0.0, |speed| speed / 2.0);
    let step = request.options.time_step.or(request.speed.map(|speed| limits::RIGID_TRAVEL / speed));
    for (what, value) in [
        ("Jolt's restitution", e),
        ("Jolt's mMinVelocityForRestitution, m/s", threshold),
        ("Jolt's time step, s", step.unwrap_or(0.0)),
    ] {
        single(what, value)?;
    }
    export.set("mRestitution", e, "");
    export.set("mFriction", 0.0, "");
    export.set("mLinearDamping", 0.0, "1/s");
    export.set("mAngularDamping", 0.0, "1/s");
    export.set("mMinVelocityForRestitution", threshold, "m/s");
    let loops = request.options.closed_loops;
    let turns = if loops { limits::JOLT_LOOP_TURNS } else { limits::JOLT_TURNS };
    export.set("mNumVelocitySteps", turns, "");
    let mut cpp = format!(
        "// Of both bodies, a JPH::BodyCreationSettings each.\n\
         settings.mRestitution = {e:?}f;\n\
         settings.mFriction = 0.0f;\n\
         settings.mLinearDamping = 0.0f;\n\
         settings.mAngularDamping = 0.0f;\n\
         // Of the JPH::PhysicsSystem.\n\
         JPH::PhysicsSettings physics = system.GetPhysicsSettings();\n\
         physics.mMinVelocityForRestitution = {threshold:?}f;\n\
         physics.mNumVelocitySteps = {turns:.0};\n\
         system.SetPhysicsSettings(physics);\n"
    );
    let mut script = format!(
        "// Of both bodies, a Jolt.BodyCreationSettings each.\n\
         export function dress(settings) {{\n  settings.mRestitution = {e:?};\n  settings.mFriction = 0.0;\n  \
         settings.mLinearDamping = 0.0;\n  settings.mAngularDamping = 0.0;\n}}\n\n\
         export function setUp(system) {{\n  const physics = system.GetPhysicsSettings();\n  \
         physics.mMinVelocityForRestitution = {threshold:?};\n  physics.mNumVelocitySteps = {turns:.0};\n  \
         system.SetPhysicsSettings(physics);\n}}\n"
    );
    match step {
        Some(step) => {
            export.time_step = Some(step);
            export.set("inDeltaTime", step, "s");
            cpp += &format!("// In the loop:\nsystem.Update({step:?}f, 1, allocator, jobs);\n");
            script += &format!("\nexport function advance(jolt) {{\n  jolt.Step({step:?}, 1);\n}}\n");
            // Where the travel is longer, what a turning body does within a step is more than was measured.
            let measured = request.speed.is_some_and(|speed| !loops && speed * step <= limits::RIGID_LONGEST_TRAVEL);
            export.error_bound = measured.then_some(limits::JOLT_ERROR);
        }
        None => export.missing.push("approach speed, m/s: Jolt lets no impact bounce below a threshold, and step and bound depend on it"),
    }
    export.write("Jolt", "cpp", cpp);
    export.write("jolt-physics", "javascript", script);
    export
        .assume("Both bodies have these values; the other may have a lower restitution: the greater counts.");
    if loops {
        export.assume(
            "Closed loops: no error is stated. A four-bar (m̄ = 68.1 kg, its bodies 2 to 4.8 kg) was off by 2e-4, 4e-4, 6e-4 for 0.2, 0.5, 0.8 with \
             these velocity steps; with 50 it rebounds with 0.04 for 0.5. Raise mNumVelocitySteps until the rebound stays the same.",
        );
    } else {
        export.assume(
            "A free body, or one on a hinge to the ground, which the error is for. In longer chains joints settle more slowly: \
             raise mNumVelocitySteps until the rebound stays the same.",
        );
    }
    export.cannot.push("stiffness, penetration, duration, peak force: the contact is rigid");
    Ok(export)
}
