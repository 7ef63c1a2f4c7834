//! Rapier: a coefficient of restitution.

use crate::exports::rigid;
use crate::exports::simulators::simulated::{ContactModel, Given, SimulatedContact};
use crate::exports::{Export, ExportError, Facts, Measurement, Request, Tool};
use crate::limits;

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "rapier",
    title: "Rapier",
    aliases: &["rapier3d"],
    law: "rigid, Newton's restitution: the speed of separation is e times the closing speed",
    combines: "by the combine rule with the higher priority of the two; average has the lowest: the mean of \
        both sides by default",
    measured: &[Measurement {
        engine: "Rapier 0.36.1",
        solver: "multibody joints",
        scenes: "ball; pendulums, m̄ = 1.5 and 3.75 kg of a 2 kg body",
        worst: [Some(1.0e-12), Some(1.0e-12), Some(1.0e-12)],
        by_hand: None,
    }],
    caution: "articulated bodies as multibody joints, their damping set to 0 as written; impulse joints and \
        closed loops do not reach the restitution",
    sources: &[
        "Rapier 0.36.1, src/dynamics/integration_parameters.rs",
        "Rapier 0.36.1, src/dynamics/coefficient_combine_rule.rs",
        "Rapier 0.36.1, src/dynamics/joint/multibody_joint/multibody.rs: default_damping",
    ],
};

/// `restitution` = e: Rapier changes the approach speed v to −e v in a pass at the end of each step. A mechanism moves
/// within the step: error of a double pendulum at 1/60 s 1.2e-2 ([`rigid::travel_error`]).
///
/// A multibody joint has a damping of 0.1 by default, 0.1 N·m·s/rad at a hinge, which slows the mechanism before and
/// after the impact: the pendulum measured lost 1e-3 of e = 0.5 in eleven steps of 5e-4 s. Held by an impulse joint
/// the pendulum of m̄ = 3.75 kg is off by 0.15 … 0.31 for e = 0.5, at every step from 1/60 to 5e-5 s. The four-bar
/// (m̄ = 68.1 kg), by hand: multibody joints closed by an impulse joint do not rebound; with impulse joints alone the
/// coupler rests for some steps and returns with 0.26 … 0.65. Restitution 0 with any contact softness: at most
/// 1.5e-3.
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let e = request.restitution;
    let mut export = Export::new(TOOL);
    export.time_step = rigid::time_step(request);
    export.error_bound =
        rigid::travel_error(request, export.time_step).map(|travel| limits::RAPIER_ERROR + travel);
    if export.error_bound.is_none() {
        export.missing.push(rigid::SPEED_MISSING);
    }
    export.set("restitution", e, "");
    export.set("restitution_combine_rule", "Average", "");
    export.set("multibody_damping", 0.0, "");
    let mut text = format!(
        "use rapier3d_f64::prelude::*;\n\n\
         /// For both colliders of the pair.\n\
         fn bouncing(collider: ColliderBuilder) -> ColliderBuilder {{\n    \
         collider\n        .restitution({e:?})\n        \
         .restitution_combine_rule(CoefficientCombineRule::Average)\n        .friction(0.0)\n}}\n\n\
         /// For the mechanism: its joints are damped by default.\n\
         fn undamped(multibody: &mut Multibody) {{\n    multibody.damping_mut().fill(0.0);\n}}\n"
    );
    if let Some(step) = export.time_step {
        export.set("dt", step, "s");
        text += &format!(
            "\nfn parameters() -> IntegrationParameters {{\n    \
             IntegrationParameters {{ dt: {step:?}, ..Default::default() }}\n}}\n"
        );
    }
    export.add_snippet("Rapier", "rust", text);
    export.add_assumption("Both colliders have the restitution (their average counts), and nothing else touches at the same time.");
    export.add_assumption("Articulated bodies are multibody joints (reduced coordinates). Impulse joints do not reach the restitution.");
    export.add_assumption("The restitution does not depend on m̄, and that of a free body holds at any step.");
    rigid::add_travel_assumption(&mut export, request);
    export
        .cannot
        .push("stiffness, compression, duration, peak force: the contact's softness only removes overlap");
    Ok(export)
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let restitution = given.restitution("restitution")?;
    given.assume("multibody_damping", 0.0)?;
    given.optional("dt")?;
    Ok(vec![SimulatedContact::of(ContactModel::Rigid { restitution, slowest: 0.0 })])
}
