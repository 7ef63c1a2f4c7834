//! OpenSim and Simbody: HuntCrossleyForce.

use crate::exports::impact_function::ImpactFunction;
use crate::exports::simulators::simulated::{ContactModel, Given, SimulatedContact};
use crate::exports::{Export, ExportError, Facts, Measurement, Request, Tool};
use crate::limits;
use crate::{Damper, hunt_crossley};

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "opensim",
    title: "OpenSim (HuntCrossleyForce)",
    aliases: &["simbody"],
    law: "Hunt–Crossley on Hertz's spring, k x^(3/2) (1 + 3/2 c ẋ), never pulling",
    combines: "stiffness^(2/3) in series, dissipations by the share of the deformation; frictions by their harmonic mean",
    measured: &[Measurement {
        engine: "OpenSim 4.6",
        solver: "",
        scenes: "ball of 2 kg; pendulums of m̄ = 1.5 and 3.75 kg; four-bar closed by a PointConstraint, m̄ = 68.1 kg",
        worst: [Some(4e-5), Some(7e-5), Some(7e-5)],
        by_hand: None,
    }],
    caution: "the dissipation is for one closing speed; the greatest step must be set, otherwise the \
        integrator detects the contact too late",
    sources: &[
        "Simbody, Simbody/src/HuntCrossleyForce.cpp: calcForce",
        "OpenSim, OpenSim/Simulation/Model/HuntCrossleyForce.cpp",
    ],
};

/// `stiffness`·√R = 3/√2·k for both geometries, `dissipation` = 2a(e)/(3v).
///
/// Simbody's force between two surfaces is 4/3 E x √(R E x) (1 + 3/2 c ẋ), never pulling, with E = E₁E₂/(E₁+E₂) and
/// c = (c₁E₂ + c₂E₁)/(E₁+E₂); OpenSim takes the stiffness E₁^(3/2) as its parameter. Two equal surfaces: E = E₁/2, so that
/// k = 4/3·√R·stiffness/2^(3/2). Hunt and Crossley's dissipation number is 3/2 c v = a(e), whatever the exponent and the mass.
///
/// Greatest step of the integrator: 0.1 x₀/v, x₀ the penetration without damping; shorter for a smaller error.
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let contact = request.contact;
    let (stiffness, exponent) = request.power_law();
    if exponent != 1.5 {
        return Err(ExportError::Exponent {
            tool: TOOL,
            exponent,
            takes: "Hertz's spring has 3/2",
            remedy: "give the exponent 1.5 and the stiffness in N/m^1.5 that stores the same energy at the same compression",
        });
    }
    let number = hunt_crossley::dissipation_number(request.restitution)?;
    let mut export = Export::new(TOOL);
    let modulus = 3.0 / std::f64::consts::SQRT_2 * stiffness;
    export.set("stiffness·sqrt(R)", modulus, "N/m^(3/2)");
    export.add_assumption("Both geometries are in the force's one ContactParameters. A half space counts with R of the sphere alone.");
    export.add_assumption("No friction: static, dynamic and viscous friction 0.");
    let Some(speed) = request.speed else {
        export.missing.push(
            "closing speed, m/s: the dissipation is proportional to 1/speed, and the greatest step depends on \
             the speed",
        );
        return Ok(export);
    };
    let dissipation = 2.0 * number / (3.0 * speed);
    let depth = ImpactFunction::undamped_penetration(1.5, contact.mass(), stiffness, speed)?;
    let finer = (request.options.accuracy / limits::DEFAULT_ACCURACY).min(1.0);
    let largest = limits::LONGEST_STEP * finer.sqrt() * depth / speed;
    let accuracy = limits::OPENSIM_ACCURACY * finer;
    let impact = Damper::hunt_crossley(number / speed).and_then(|damper| damper.impact(contact, speed));
    export.add_penetration("", impact.ok().map(|impact| impact.max_penetration));
    export.set("dissipation", dissipation, "s/m");
    export.set("integrator_accuracy", accuracy, "");
    export.set("maximum_step_size", largest, "s");
    export.error_bound = Some(limits::OPENSIM_ERROR * request.options.accuracy.min(limits::DEFAULT_ACCURACY));
    export.add_assumption(format!(
        "The dissipation is for approach at {speed:?} m/s (3/2·dissipation·v = {number:?}); faster impacts bounce less. It does \
         not depend on the effective mass."
    ));
    export.add_snippet(
        "OpenSim",
        "python",
        format!(
            "import math\n\nimport opensim\n\n\n\
             def contact_force(geometries, radius):\n    \"\"\"Between contact geometries of these names; radius of the sphere, m.\"\"\"\n    \
             force = opensim.HuntCrossleyForce()\n    for name in geometries:\n        force.addGeometry(name)\n    \
             force.setStiffness({modulus:?} / math.sqrt(radius))\n    force.setDissipation({dissipation:?})\n    \
             force.setStaticFriction(0.0)\n    force.setDynamicFriction(0.0)\n    force.setViscousFriction(0.0)\n    return force\n\n\n\
             def set_integrator(manager):\n    manager.setIntegratorAccuracy({accuracy:?})\n    \
             manager.setIntegratorMaximumStepSize({largest:?})\n"
        ),
    );
    Ok(export)
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let stiffness = given.positive("stiffness·sqrt(R)")? * std::f64::consts::SQRT_2 / 3.0;
    let dissipation = 1.5 * given.number("dissipation")?;
    given.optional("integrator_accuracy")?;
    given.optional("maximum_step_size")?;
    let contact = given.contact(stiffness, 1.5)?;
    Ok(vec![SimulatedContact::of(ContactModel::Compliant(contact, Damper::hunt_crossley(dissipation)?))])
}
