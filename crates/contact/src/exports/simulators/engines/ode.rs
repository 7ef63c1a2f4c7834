//! Open Dynamics Engine: soft contacts by ERP and CFM.

use crate::exports::linear::Linear;
use crate::exports::simulators::simulated::{Given, SimulatedContact};
use crate::exports::{Export, ExportError, Facts, Measurement, Request, StopMotion, Tool};

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "ode",
    title: "Open Dynamics Engine",
    aliases: &["open-dynamics-engine"],
    law: "linear spring and damper, never pulling, by implicit Euler",
    combines: "none: the near callback sets the values of the pair",
    measured: &[
        Measurement {
            engine: "ODE 0.16.2",
            solver: "Step",
            scenes: "ball; pendulums, m̄ = 1.5 and 3.75 kg of a 2 kg body; four-bar of hinges, m̄ = 68.1 kg; stops of joints",
            worst: [Some(5.0e-4), Some(4.1e-4), Some(3.5e-4)],
            by_hand: None,
        },
        Measurement {
            engine: "ODE 0.16.2",
            solver: "QuickStep",
            scenes: "ball; pendulums, m̄ = 1.5 and 3.75 kg of a 2 kg body; four-bar of hinges, m̄ = 68.1 kg; stops of joints",
            worst: [Some(5.0e-4), Some(4.1e-4), Some(3.5e-4)],
            by_hand: None,
        },
    ],
    caution: "soft_erp and soft_cfm are for one time step; other time steps need other values",
    sources: &[
        "ODE 0.16.2, libode-dev of Debian 12: ode/contact.h",
        "ODE, ode/src/joints/joint.cpp: dxJointLimitMotor::addLimot",
        "Gazebo Classic, gazebo/physics/ode/ODEPhysics.cc: Collide",
    ],
};

/// ERP = h k/(h k + c'), CFM = 1/(h k + c').
///
/// With these values the contact row of ODE is max(0, k (x − h v⁺) − c' v⁺): implicit Euler of the linear spring
/// and damper, with v⁺ the speed of separation after the step. c' = 2ζ'√(k m̄), ζ' = ζ − ωh/2.
///
/// Measured in ODE 0.16.2, e = 0.2, 0.5, 0.8, the worst of five phases, Step and QuickStep (20 iterations):
/// 4.9e-4, 4.0e-4, 3.4e-4, ball, pendulums and four-bar; at twice the step 9.9e-4, 8.0e-4, 6.7e-4. With the mass of
/// the contact link alone: 0.280, 0.592, 0.848 (2 kg for m̄ = 3.75 kg); 0.580, 0.815, 0.941 (four-bar, 4.8 kg for
/// 68.1 kg).
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let linear = Linear::of(request, TOOL)?;
    let step = linear.implicit_step();
    let damping = linear.damping(linear.implicit_ratio(step)?);
    let (erp, cfm) = erp_and_cfm(linear.stiffness, damping, step);
    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.error_bound = Some(linear.implicit_error_bound(step));
    export.add_penetration("", linear.penetration(request.speed));
    export.set("soft_erp", erp, "");
    export.set("soft_cfm", cfm, "m/(N·s)");
    export.set("time_step", step, "s");
    export.add_snippet(
        "near callback and step",
        "cpp",
        format!(
            "// In the near callback, for each contact:\n\
             contact.surface.mode = dContactSoftERP | dContactSoftCFM;\n\
             contact.surface.soft_erp = {erp:?};\n\
             contact.surface.soft_cfm = {cfm:?};\n\
             contact.surface.mu = 0.0;\n\n\
             // In the loop:\n\
             dWorldStep(world, {step:?}); // dWorldQuickStep: the same\n"
        ),
    );
    export.add_assumption(linear.implicit_assumption(step));
    export.add_assumption(
        "ODE is built in double precision, and dContactBounce is off, because its bounce would add to the \
         rebound of the spring.",
    );
    export.add_assumption(
        "The world's contact settings are ODE's own: no cap on the correcting speed, no surface layer.",
    );
    if request.options.constrained {
        export.add_assumption(
            "Loops, mimics, locks: joints of bodies in maximal coordinates, with ODE's own ERP and CFM (1e-10 in double precision), \
             kept the restitution of a four-bar as that of a ball.",
        );
    }
    Ok(export)
}

/// Stop of a joint: `dParamStopERP` and `dParamStopCFM`. The row is that of a contact with the joint rate as closing
/// speed.
///
/// ODE applies a limit that the joint has passed at the beginning of a step, with a force that pushes back only.
/// `dParamBounce` adds a return speed through the same CFM: with 0.5 and these ERP and CFM the restitution is 0.174,
/// 0.486, 0.798 for 0.2, 0.5, 0.8. With a CFM of 0 `dParamBounce` is the restitution of a rigid stop: 0.5 gave 0.499997
/// on a hinge.
///
/// Measured in ODE 0.16.2, Step and QuickStep: a hinge with and without a rotor, upper and lower end, an elbow
/// whose shoulder is free, the crank of a four-bar (0.473 kg·m²), the slider of a slider-crank (2.77 kg): within
/// 5.0e-4, 4.1e-4, 3.5e-4. With the link's own inertia: 0.150, 0.429, 0.757 (elbow, 0.107 for 0.0668 kg·m²); 0.494,
/// 0.763, 0.921 (crank, 0.06 kg·m²); 0.351, 0.658, 0.878 (slider, 0.9 kg).
pub(crate) fn stop(request: &Request, motion: StopMotion) -> Result<Export, ExportError> {
    let linear = Linear::of(request, TOOL)?;
    let step = linear.implicit_step();
    let damping = linear.damping(linear.implicit_ratio(step)?);
    let (erp, cfm) = erp_and_cfm(linear.stiffness, damping, step);
    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.error_bound = Some(linear.implicit_error_bound(step));
    export.add_penetration("", linear.penetration(request.speed));
    export.set("stop_erp", erp, "");
    export.set("stop_cfm", cfm, motion.units().softness);
    export.set("bounce", 0.0, "");
    export.set("time_step", step, "s");
    let setter = match motion {
        StopMotion::Turn => "dJointSetHingeParam",
        StopMotion::Slide => "dJointSetSliderParam",
    };
    export.add_snippet(
        "joint and step",
        "cpp",
        format!(
            "// The joint has its dParamLoStop or dParamHiStop.\n\
             {setter}(joint, dParamStopERP, {erp:?});\n\
             {setter}(joint, dParamStopCFM, {cfm:?});\n\
             {setter}(joint, dParamBounce, 0.0);\n\
             {setter}(joint, dParamFMax, 0.0);\n\n\
             // In the loop:\n\
             dWorldStep(world, {step:?}); // dWorldQuickStep: the same\n"
        ),
    );
    export.add_assumption(linear.implicit_assumption(step));
    export.add_assumption(
        "dParamBounce and dParamFMax are 0, as by default: a bounce in addition to the spring changes the \
         restitution by up to 0.06, and a motor adds a force. dParamBounce alone, with dParamStopCFM 0, is the \
         restitution of a rigid stop.",
    );
    export.add_assumption("ODE is built in double precision. Both ends of the range have these values: ODE has but one pair for them.");
    export.add_assumption(
        "ODE's bodies have no rotor inertias: one of a joint with a fixed parent is added to the child's \
         inertia about the axis; other rotors change the effective inertia at the stop.",
    );
    if request.options.constrained {
        export.add_assumption(
            "Loops, mimics, locks: joints of bodies in maximal coordinates, with ODE's own ERP and CFM (1e-10 in double precision), \
             kept the restitution of the stops of a four-bar and of a slider-crank as that of a hinge.",
        );
    }
    Ok(export)
}

/// ERP and CFM of a stiffness, a damping and a time step.
pub(crate) fn erp_and_cfm(stiffness: f64, damping: f64, step: f64) -> (f64, f64) {
    let sum = step * stiffness + damping;
    (step * stiffness / sum, 1.0 / sum)
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let (erp, cfm) = (given.positive("soft_erp")?, given.positive("soft_cfm")?);
    let step = given.positive("time_step")?;
    if erp > 1.0 {
        return Err(given.refuse("soft_erp", format!("{erp:?}; expected a number above 0, at most 1")));
    }
    // The inverse of `erp_and_cfm`.
    let (stiffness, damping) = (erp / (step * cfm), (1.0 - erp) / cfm);
    Ok(vec![SimulatedContact::implicit(given, stiffness, damping, step)?])
}
