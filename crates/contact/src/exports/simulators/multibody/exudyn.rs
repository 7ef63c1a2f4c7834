//! Exudyn: ObjectContactSphereSphere with a linear spring and damper.

use crate::exports::linear::Linear;
use crate::exports::simulators::simulated::{ContactModel, Given, SimulatedContact};
use crate::exports::{Export, ExportError, Facts, Measurement, Request, Tool};
use crate::limits;
use crate::{Separation, kelvin_voigt};

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "exudyn",
    title: "Exudyn (ObjectContactSphereSphere)",
    aliases: &[],
    law: "linear spring and damper until the gap closes: pulls at the end",
    combines: "none: the values apply to the pair",
    measured: &[Measurement {
        engine: "Exudyn 1.13.6",
        solver: "",
        scenes: "ball of 2 kg; pendulums of m̄ = 1.5 and 3.75 kg; four-bar of joints, m̄ = 68.1 kg",
        worst: [Some(6e-4), Some(6e-4), Some(7e-4)],
        by_hand: None,
    }],
    caution: "the half-period damping of textbooks is correct here; the iteration tolerance of contacts is 1 N \
        by default; loops with redundant rows are not supported",
    sources: &[
        "Exudyn, main/src/Objects/CObjectContactSphereSphere.cpp: ComputeContactForces, PostNewtonStep",
        "Exudyn 1.13.6, SimulationSettings.timeIntegration.discontinuous",
    ],
};

/// contactStiffness = k, contactDamping = c = 2ζ√(k m̄), ζ = L/√(π²+L²), L = −ln e; impactModel 0.
///
/// Exudyn's force is k x + c ẋ while x > 0, without a clamp: the contact ends at x = 0 after a half period
/// of the damped oscillation, e = exp(−πζ/√(1−ζ²)).
///
/// Trapezoidal rule. In the steps in which the gap closes and opens, the damper force is present or absent, although
/// the step is divided at the estimated closing of the gap. The error of each is half a step of 2ζω e v, together 2ζe
/// ωh. Bound: 2.5ζe ωh + (ωh)²/2, the second term for the error without damping. Measured in 1.13.6, the worst
/// |Δe|/(2ζe ωh) of fifteen phases at ωh = 0.03 and 0.004: 0.88, 0.92; 1.02, 1.03; 0.99, 0.76; 1.07, 0.99; 1.09, 0.90
/// for e = 0.1, 0.3, 0.5, 0.7, 0.9. With the default iteration tolerance of 1 N, a gap of 1 N/k counts as closed: 1.4
/// for e = 0.2.
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let mut linear = Linear::of(request, TOOL)?;
    if linear.restitution < 1.0 {
        linear.ratio = kelvin_voigt::ratio(linear.restitution, Separation::GapCloses)?;
    }
    let error_slope = 2.5 * linear.ratio * linear.restitution;
    let step = match request.options.time_step {
        Some(step) if linear.frequency * step <= limits::EXUDYN_LONGEST_STEP => step,
        Some(time_step) => {
            let largest = limits::EXUDYN_LONGEST_STEP / linear.frequency;
            return Err(ExportError::StepTooCoarse { tool: TOOL, time_step, largest });
        }
        // slope ωh + (ωh)²/2 = accuracy.
        None => {
            let step = 2.0 * linear.accuracy
                / (error_slope + (error_slope * error_slope + 2.0 * linear.accuracy).sqrt());
            step.min(limits::LONGEST_STEP) / linear.frequency
        }
    };
    let damping = linear.damping(linear.ratio);
    let part = linear.frequency * step;
    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.error_bound = Some(error_slope * part + part * part / 2.0);
    export.add_penetration("", linear.penetration(request.speed));
    export.set("contactStiffness", linear.stiffness, "N/m");
    export.set("contactDamping", damping, "N·s/m");
    export.set("contactStiffnessExponent", 1.0, "");
    export.set("impactModel", 0.0, "");
    export.set("dynamicFriction", 0.0, "");
    export.set("stepSize", step, "s");
    let mut text = format!(
        "import exudyn\nfrom exudyn.itemInterface import ObjectContactSphereSphere\n\n\n\
         def contact(markers, node, radii):\n    \"\"\"markers of the two bodies; node: a NodeGenericData of 4 coordinates, \
         the first the gap at the start.\"\"\"\n    \
         return ObjectContactSphereSphere(\n        markerNumbers=markers, nodeNumber=node, spheresRadii=radii,\n        \
         contactStiffness={:?}, contactDamping={damping:?}, contactStiffnessExponent=1.0,\n        \
         impactModel=0, dynamicFriction=0.0,\n    )\n\n\n\
         def settings(duration):\n    of = exudyn.SimulationSettings()\n    of.timeIntegration.endTime = duration\n    \
         of.timeIntegration.numberOfSteps = round(duration / {step:?})\n",
        linear.stiffness
    );
    match request.speed {
        Some(speed) => {
            let tolerance = limits::EXUDYN_TOLERANCE * linear.stiffness * speed * step;
            export.set("discontinuous.iterationTolerance", tolerance, "N");
            export.set("discontinuous.maxIterations", limits::EXUDYN_MAX_ITERATIONS, "");
            text += &format!(
                "    of.timeIntegration.discontinuous.iterationTolerance = {tolerance:?}\n    \
                 of.timeIntegration.discontinuous.maxIterations = {:?}\n",
                limits::EXUDYN_MAX_ITERATIONS as u32
            );
        }
        None => {
            export.missing.push("closing speed, m/s: the iteration tolerance of contacts is a force, k v h")
        }
    }
    text += "    return of\n";
    export.add_snippet("Exudyn", "python", text);
    export.add_assumption("The solver is the default of SolveDynamic, generalized alpha, with adaptive steps (the default too).");
    export.add_assumption("A plane is a sphere of a radius much larger than the compression.");
    Ok(export)
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let (stiffness, damping) = (given.positive("contactStiffness")?, given.number("contactDamping")?);
    given.assume("contactStiffnessExponent", 1.0)?;
    given.assume("impactModel", 0.0)?;
    given.assume("dynamicFriction", 0.0)?;
    for name in ["stepSize", "discontinuous.iterationTolerance", "discontinuous.maxIterations"] {
        given.optional(name)?;
    }
    let (contact, damper) = given.linear(stiffness, damping, Separation::GapCloses)?;
    Ok(vec![SimulatedContact::of(ContactModel::Compliant(contact, damper))])
}
