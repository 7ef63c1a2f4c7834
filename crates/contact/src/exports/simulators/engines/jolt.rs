//! Jolt Physics, as in Godot: a coefficient of restitution.

use crate::exports::export::check_single_precision;
use crate::exports::rigid;
use crate::exports::simulators::simulated::{ContactModel, Given, SimulatedContact};
use crate::exports::{Export, ExportError, Facts, Measurement, Request, Tool};
use crate::limits;

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "jolt",
    title: "Jolt Physics",
    aliases: &["jolt-physics", "joltphysics", "godot"],
    law: "Newton's restitution: the speed of separation is e times the closing speed",
    combines: "the greater of the two restitutions; frictions by the root of their product",
    measured: &[
        Measurement {
            engine: "jolt-physics 1.1.0",
            solver: "one body",
            scenes: "ball of 2 kg; pendulums of m̄ = 1.5 and 3.75 kg",
            worst: [Some(1e-6), Some(3e-6), Some(8e-6)],
            by_hand: None,
        },
        Measurement {
            engine: "jolt-physics 1.1.0",
            solver: "chains and closed loops",
            scenes: "four-bar of hinges, m̄ = 68.1 kg",
            worst: [Some(2e-4), Some(5e-4), Some(7e-4)],
            by_hand: None,
        },
    ],
    caution: "mMinVelocityForRestitution is 1 m/s by default: slower impacts do not rebound; a body on a hinge \
        needs the exported velocity steps for its m̄; no error is stated for chains and closed loops",
    sources: &[
        "Jolt Physics 5, Jolt/Physics/Constraints/ContactConstraintManager.cpp: CalculateFrictionAndNonPenetrationConstraintProperties",
        "Jolt Physics 5, Jolt/Physics/PhysicsSettings.h",
        "jolt-physics 1.1.0 (npm), run with the same and with different restitutions of the two sides",
    ],
};

/// `mRestitution` = e for both bodies, and `mMinVelocityForRestitution` half the speed.
///
/// Jolt's contact row requires the separation speed e v if v is above the threshold and the gap closes within the
/// step. A free body reaches this speed to single precision. The rows of joints and contacts are solved one after
/// another, `mNumVelocitySteps` times (projected Gauss–Seidel). For a hinged body the remaining error of the change
/// of speed decreases by ρ = 1 − m_f/m̄ per iteration, m_f the effective mass at the contact without the hinge: (1 +
/// e) ρᴺ after N iterations. Measured on 14 levers with m̄/m = 0.15 to 49; for m̄ = 36 m the error after 50
/// iterations is 0.46. A four-bar (m̄ = 68.1 kg, bodies of 2 to 4.8 kg) converges more slowly: for e = 0.5 the
/// restitution is 0.04 after 50 iterations, 0.441 after 200, 0.4986 after 500, and 0.4996 from 1000, at 1e-3 and 1e-4
/// s. For other linkages the error is unknown, and none is stated.
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let e = request.restitution;
    let mut export = Export::new(TOOL);
    let threshold = request.speed.map_or(0.0, |speed| speed / 2.0);
    let step = rigid::time_step(request).or(request.speed.map(|speed| limits::RIGID_TRAVEL / speed));
    for (what, value) in [
        ("Jolt's restitution", e),
        ("Jolt's mMinVelocityForRestitution, m/s", threshold),
        ("Jolt's time step, s", step.unwrap_or(0.0)),
    ] {
        check_single_precision(what, value)?;
    }
    export.set("mRestitution", e, "");
    export.set("mFriction", 0.0, "");
    export.set("mLinearDamping", 0.0, "1/s");
    export.set("mAngularDamping", 0.0, "1/s");
    export.set("mMinVelocityForRestitution", threshold, "m/s");
    let loops = request.options.closed_loops;
    let (velocity_step_count, known) = velocity_steps(request)?;
    export.set("mNumVelocitySteps", velocity_step_count, "");
    let mut cpp = format!(
        "// Of both bodies, a JPH::BodyCreationSettings each.\n\
         settings.mRestitution = {e:?}f;\n\
         settings.mFriction = 0.0f;\n\
         settings.mLinearDamping = 0.0f;\n\
         settings.mAngularDamping = 0.0f;\n\
         // Of the JPH::PhysicsSystem.\n\
         JPH::PhysicsSettings physics = system.GetPhysicsSettings();\n\
         physics.mMinVelocityForRestitution = {threshold:?}f;\n\
         physics.mNumVelocitySteps = {velocity_step_count:.0};\n\
         system.SetPhysicsSettings(physics);\n"
    );
    let mut script = format!(
        "// Of both bodies, a Jolt.BodyCreationSettings each.\n\
         export function dress(settings) {{\n  settings.mRestitution = {e:?};\n  settings.mFriction = 0.0;\n  \
         settings.mLinearDamping = 0.0;\n  settings.mAngularDamping = 0.0;\n}}\n\n\
         export function setUp(system) {{\n  const physics = system.GetPhysicsSettings();\n  \
         physics.mMinVelocityForRestitution = {threshold:?};\n  physics.mNumVelocitySteps = {velocity_step_count:.0};\n  \
         system.SetPhysicsSettings(physics);\n}}\n"
    );
    match step {
        Some(step) => {
            export.time_step = Some(step);
            export.set("inDeltaTime", step, "s");
            cpp += &format!("// In the loop:\nsystem.Update({step:?}f, 1, allocator, jobs);\n");
            script += &format!("\nexport function advance(jolt) {{\n  jolt.Step({step:?}, 1);\n}}\n");
            let short = request.speed.is_some_and(|speed| speed * step <= limits::RIGID_LONGEST_TRAVEL);
            let travel = rigid::travel_error(request, Some(step)).filter(|_| known && short);
            export.error_bound = travel.map(|travel| limits::JOLT_ERROR + travel);
        }
        None => export.missing.push(
            "closing speed, m/s: the threshold for a rebound, the step and the error \
            bound depend on the speed",
        ),
    }
    export.add_snippet("Jolt", "cpp", cpp);
    export.add_snippet("jolt-physics", "javascript", script);
    export.add_assumption(
        "Both bodies have these values; the other may have a lower restitution: the greater counts.",
    );
    if loops {
        export.add_assumption(
            "Closed loops: no error is stated. A four-bar (m̄ = 68.1 kg, its bodies 2 to 4.8 kg) had errors of \
             2e-4, 4e-4, 7e-4 for 0.2, 0.5, 0.8 with these velocity steps; with 50 velocity steps its \
             restitution was 0.04 for 0.5. Raise mNumVelocitySteps until the rebound stays the same.",
        );
    } else if known {
        export.add_assumption(
            "The stated error is for a free body, or for a body on a hinge to the ground: mNumVelocitySteps \
             follows from the ratio of m̄ to the effective mass without the hinge.",
        );
    } else {
        export.add_assumption(
            "No error is stated: the velocity steps that a chain of several bodies needs, or a body with an \
             unknown effective mass without its joints, are unknown. Raise mNumVelocitySteps until the rebound \
             stays the same.",
        );
    }
    rigid::add_travel_assumption(&mut export, request);
    export.cannot.push("stiffness, compression, duration, peak force: the contact is rigid");
    Ok(export)
}

/// `mNumVelocitySteps` N at which the error (1 + e) ρᴺ, ρ = 1 − m_f/m̄, is small, and true if this error is valid for the
/// mechanism: a free body, or one hinged body. Error: N is too large.
fn velocity_steps(request: &Request) -> Result<(f64, bool), ExportError> {
    let options = request.options;
    if options.closed_loops {
        return Ok((limits::JOLT_LOOP_VELOCITY_STEPS, false));
    }
    let mass = request.contact.mass();
    let Some(free) = options.free_mass else {
        // Without a model: a free body, unless m̄ differs from the own mass.
        let same = options.own_mass.is_none_or(|own| (mass / own - 1.0).abs() <= limits::SAME_MASS);
        return Ok((if same { limits::JOLT_VELOCITY_STEPS } else { limits::JOLT_LOOP_VELOCITY_STEPS }, same));
    };
    if request.is_jointed() == Some(false) {
        return Ok((limits::JOLT_VELOCITY_STEPS, true));
    }
    let convergence_rate = (1.0 - free / mass).max(f64::EPSILON);
    let velocity_step_count = ((limits::JOLT_CONVERGENCE / (1.0 + request.restitution)).ln()
        / convergence_rate.ln())
    .ceil()
    .max(limits::JOLT_VELOCITY_STEPS);
    if velocity_step_count > limits::JOLT_MAX_VELOCITY_STEPS {
        return Err(ExportError::Unreachable {
            tool: TOOL,
            restitution: request.restitution,
            why: "the ratio of m̄ to the effective mass without joints is so large that Jolt needs more than \
                10,000 velocity steps",
            remedy: "choose a tool that solves joints directly: mujoco, drake, ode, rapier, dart",
        });
    }
    let hinged = options.moving_bodies.is_none_or(|bodies| bodies == 1) && !options.constrained;
    Ok(if hinged {
        (velocity_step_count, true)
    } else {
        (velocity_step_count.max(limits::JOLT_LOOP_VELOCITY_STEPS), false)
    })
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let restitution = given.restitution("mRestitution")?;
    let slowest = given.optional("mMinVelocityForRestitution")?.unwrap_or(1.0);
    for name in ["mFriction", "mLinearDamping", "mAngularDamping"] {
        given.assume(name, 0.0)?;
    }
    given.optional("mNumVelocitySteps")?;
    given.optional("inDeltaTime")?;
    Ok(vec![SimulatedContact::of(ContactModel::Rigid { restitution, slowest })])
}
