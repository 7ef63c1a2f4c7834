//! Open Dynamics Engine: soft contacts by ERP and CFM.

use super::linear::Linear;
use super::{Export, ExportError, Facts, Request, Tool};

const TOOL: Tool = Tool::of(&FACTS);

pub(super) const FACTS: Facts = Facts {
    name: "ode",
    title: "Open Dynamics Engine",
    aliases: &["open-dynamics-engine"],
    law: "linear spring and damper, never pulling, by implicit Euler",
    combines: "nothing: the near callback sets the pair's values",
    measured: &[],
    caution: "",
    sources: &[
        "Gazebo Classic, gazebo/physics/ode/ODEPhysics.cc: Collide",
        "ODE manual, \"How To Use ERP and CFM\" (from memory, not opened)",
    ],
};

/// ERP = h k/(h k + c'), CFM = 1/(h k + c').
///
/// ODE's contact row, multiplied out with these, is max(0, k (x − h v⁺) − c' v⁺): implicit Euler of the linear spring
/// and damper, with v⁺ the speed of separation after the step. c' = 2ζ'√(k m̄), ζ' = ζ − ωh/2.
pub(super) fn export(request: &Request) -> Result<Export, ExportError> {
    let linear = Linear::of(request, TOOL)?;
    let step = linear.implicit_step();
    let damping = linear.damping(linear.implicit_ratio(step)?);
    let (erp, cfm) = erp_and_cfm(linear.stiffness, damping, step);
    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.error_bound = Some(linear.implicit_error_bound(step));
    export.set("soft_erp", erp, "");
    export.set("soft_cfm", cfm, "m/(N·s)");
    export.set("time_step", step, "s");
    export.write(
        "near callback and step",
        "cpp",
        format!(
            "// In the near callback, for each contact:\n\
             contact.surface.mode = dContactSoftERP | dContactSoftCFM;\n\
             contact.surface.soft_erp = {erp:?};\n\
             contact.surface.soft_cfm = {cfm:?};\n\
             contact.surface.mu = 0.0;\n\n\
             // In the loop:\n\
             dWorldStep(world, {step:?});\n"
        ),
    );
    export.assume(linear.implicit_words(step));
    export.assume(
        "ODE is built in double precision, and dContactBounce is off: its bounce would come on top of the spring's.",
    );
    export.assume(
        "The world's contact settings are ODE's own: no cap on the correcting speed, no surface layer.",
    );
    export.assume("Not measured in ODE itself: the formulas are those that Gazebo Classic hands to it, run in a model of its row.");
    Ok(export)
}

/// (ERP, CFM) of a stiffness, a damping and a time step.
pub(super) fn erp_and_cfm(stiffness: f64, damping: f64, step: f64) -> (f64, f64) {
    let sum = step * stiffness + damping;
    (step * stiffness / sum, 1.0 / sum)
}
