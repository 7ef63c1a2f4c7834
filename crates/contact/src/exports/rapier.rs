//! Rapier: a coefficient of restitution.

use super::{Export, ExportError, Facts, Request, Tool};

const TOOL: Tool = Tool::of(&FACTS);

pub(super) const FACTS: Facts = Facts {
    name: "rapier",
    title: "Rapier",
    aliases: &["rapier3d"],
    law: "Newton's restitution: the speed of separation is e times that of approach",
    combines: "by the combine rule: average, minimum, maximum or product",
    measured: &[],
    caution: "",
    sources: &[
        "Rapier 0.36, src/dynamics/integration_parameters.rs",
        "Rapier 0.36, src/dynamics/coefficient_combine_rule.rs",
    ],
};

/// `restitution` = e: Rapier turns the approach speed v into −e v in a pass at the end of the step.
///
/// Measured in rapier3d-f64 0.36.1: a free ball exact at any step; a pendulum as multibody −0.010, −1.1e-3, −1e-4 at
/// steps of 1/240, 5e-4, 5e-5 s; a pendulum held by an impulse joint 0 … 0.36 for 0.5. Restitution 0 with any contact
/// softness: at most 1.5e-3.
pub(super) fn export(request: &Request) -> Result<Export, ExportError> {
    let e = request.restitution;
    let mut export = Export::new(TOOL);
    export.time_step = request.options.time_step;
    export.set("restitution", e, "");
    export.set("restitution_combine_rule", "Average", "");
    let mut text = format!(
        "use rapier3d_f64::prelude::*;\n\n\
         /// For both colliders of the pair.\n\
         fn bouncing(collider: ColliderBuilder) -> ColliderBuilder {{\n    \
         collider.restitution({e:?}).restitution_combine_rule(CoefficientCombineRule::Average)\n}}\n"
    );
    if let Some(step) = request.options.time_step {
        text += &format!(
            "\nfn parameters() -> IntegrationParameters {{\n    \
             IntegrationParameters {{ dt: {step:?}, ..Default::default() }}\n}}\n"
        );
    }
    export.write("Rapier", "rust", text);
    export.assume("Both colliders have the restitution (their average counts).");
    export.assume(
        "Articulated bodies are multibody joints (reduced coordinates): there the restitution was 1e-3 low at 5e-4 s. \
         Impulse joints do not reach it.",
    );
    export
        .cannot
        .push("stiffness, penetration, duration, peak force: the contact's softness only removes overlap");
    Ok(export)
}
