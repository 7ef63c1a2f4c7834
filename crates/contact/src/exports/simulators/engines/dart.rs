//! DART: a coefficient of restitution.

use crate::exports::rigid;
use crate::exports::simulators::simulated::{ContactModel, Given, SimulatedContact};
use crate::exports::{Export, ExportError, Facts, Measurement, Request, Tool};
use crate::limits;

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "dart",
    title: "DART",
    aliases: &["dartpy"],
    law: "Newton's restitution: the speed of separation is e times the closing speed",
    combines: "product of the restitutions; the smaller friction",
    measured: &[Measurement {
        engine: "dartpy 6.20.0",
        solver: "",
        scenes: "ball of 2 kg; pendulums of m̄ = 1.5 and 3.75 kg",
        worst: [None, Some(1.6e-5), Some(1.9e-5)],
        by_hand: None,
    }],
    caution: "one side has e and the other 1; no rebound below 0.1 m/s; closed loops have larger errors (0.001 \
        for a four-bar at 1 ms), and no error is stated for them",
    sources: &[
        "DART 6.13, dart/constraint/ContactConstraint.cpp",
        "dartpy 6.20.0, run with the same and with different restitutions of the two sides",
    ],
};

/// `RestitutionCoeff` = e for one body and 1 for the other.
///
/// DART's contact row requires the speed e₁e₂v. Below 0.1 m/s (DART_BOUNCING_VELOCITY_THRESHOLD) or with e₁e₂ below
/// 1e-3 the contact does not bounce; the overlap is removed at up to 1e-3 m/s (DART_MAX_ERV). DART_CFM enlarges the
/// diagonal by 1e-5, which reduces e by (1 + e)·1e-5. The mass is that of the whole skeleton.
///
/// The bound is for trees. The enlarged diagonal is that of the open tree: a loop closed by a BallJointConstraint
/// loses (1 + e)·1e-5·m̄/m̄ₒ of e, m̄ₒ the mass of the open loop. For the four-bar (m̄ = 68.1, m̄ₒ = 2.49 kg, 0.3
/// m/s) this loss is 4.1e-4 and 4.9e-4 for e = 0.5 and 0.8, equal to measurements in 6.20.0 at 1e-6 s; the motion of
/// the loop within a step increases the error to 1.2e-3 and 1.0e-3 at 1e-3 s, 0.02 and 0.04 at 1e-2 s. With a
/// RevoluteJointConstraint, which has redundant rows, the four-bar flies apart.
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let e = request.restitution;
    if let Some(speed) = request.speed {
        let unreachable = |why, remedy| ExportError::Unreachable { tool: TOOL, restitution: e, why, remedy };
        if e > 0.0 && (e * speed < limits::DART_SLOWEST || e < limits::DART_LEAST) {
            return Err(unreachable(
                "contacts rebound only if the rebound is faster than 0.1 m/s and e is above 0.001",
                "ask at a higher speed",
            ));
        }
        if e * speed > limits::DART_FASTEST {
            return Err(unreachable("the rebound is limited to 100 m/s", "ask at a lower speed"));
        }
    }
    let mut export = Export::new(TOOL);
    export.time_step = rigid::time_step(request);
    export.set("RestitutionCoeff", e, "");
    export.set("RestitutionCoeff_other", 1.0, "");
    export.set("FrictionCoeff", 0.0, "");
    let mut text = format!(
        "def set_contact(struck, other):\n    \"\"\"The shape nodes of the two sides.\"\"\"\n    \
         for node, restitution in ((struck, {e:?}), (other, 1.0)):\n        \
         node.createCollisionAspect()\n        node.createDynamicsAspect()\n        \
         node.getDynamicsAspect().setRestitutionCoeff(restitution)\n        \
         node.getDynamicsAspect().setFrictionCoeff(0.0)\n"
    );
    if let Some(step) = export.time_step {
        export.set("TimeStep", step, "s");
        text += &format!("\n\ndef set_step(world):\n    world.setTimeStep({step:?})\n");
    }
    export.add_snippet("dartpy", "python", text);
    match request.speed {
        Some(speed) if e == 0.0 => export.error_bound = Some(limits::DART_CORRECTION / speed),
        Some(_) => {
            let travel = rigid::travel_error(request, export.time_step);
            export.error_bound = travel.map(|travel| (1.0 + e) * limits::DART_SOFTENING + travel);
        }
        None => export.missing.push("closing speed, m/s: there is no rebound below 0.1 m/s"),
    }
    export.add_assumption(
        "One side has the restitution, the other 1: DART multiplies the two. The default is 0.",
    );
    rigid::add_travel_assumption(&mut export, request);
    export.add_assumption("The joints have no damping, springs or friction of their own, as by default.");
    export.cannot.push("stiffness, compression, duration, peak force: the contact is rigid");
    Ok(export)
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let restitution =
        given.restitution("RestitutionCoeff")? * given.optional("RestitutionCoeff_other")?.unwrap_or(1.0);
    given.assume("FrictionCoeff", 0.0)?;
    given.optional("TimeStep")?;
    // A rebound below 0.1 m/s, or a coefficient below 0.001, counts as none.
    let restitution = if restitution < limits::DART_LEAST { 0.0 } else { restitution };
    let slowest = if restitution > 0.0 { limits::DART_SLOWEST / restitution } else { 0.0 };
    Ok(vec![SimulatedContact::of(ContactModel::Rigid { restitution, slowest })])
}
