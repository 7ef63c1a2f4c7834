//! New Gazebo (gz-sim) with its default physics, the dartsim plugin of gz-physics: rigid restitution.

use crate::error::{LawParameter, positive};
use crate::exports::rigid;
use crate::exports::simulators::simulated::{ContactModel, Given, SimulatedContact};
use crate::exports::{Export, ExportError, Facts, Measurement, Request, Tool};
use crate::limits;

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "gazebo",
    title: "Gazebo (gz-sim, dartsim)",
    aliases: &["gz", "gz-sim", "ignition", "sdf", "sdformat", "dartsim"],
    law: "rigid: the speed of separation is e times the closing speed if the result is above 0.1 m/s, otherwise 0",
    combines: "product of the restitution_coefficients: one side has e and the other 1",
    measured: &[Measurement {
        engine: "ign-physics 5.1.0",
        solver: "dartsim",
        scenes: "ball; pendulums, m̄ = 1.5 and 3.75 kg of a 2 kg body",
        worst: [None, Some(1.6e-5), Some(1.9e-5)],
        by_hand: None,
    }],
    caution: "no rebound below 0.1 m/s: e times the closing speed must be larger",
    sources: &[
        "DART 6.12, dart/constraint/ContactConstraint.cpp: DART_BOUNCING_VELOCITY_THRESHOLD, DART_CFM, mRestitutionCoeff",
        "gz-physics, dartsim/src/SDFFeatures.cc, bullet-featherstone/src/SDFFeatures.cc",
        "SDFormat 1.9, surface.sdf",
    ],
};

/// `restitution_coefficient` = e on one side, 1 on the other: DART multiplies them.
///
/// DART sets the speed after the step to e v where e v is above 0.1 m/s ([`limits::DART_SLOWEST_REBOUND`]) and to no
/// more than 100 m/s ([`limits::DART_FASTEST_REBOUND`]); its constraint force mixing, 1e-5 of the contact's inverse
/// mass, takes (1 + e)·1e-5 off. Measured at 1e-4, 1e-3 and 1e-2 s, for several m̄. With e on both sides the
/// restitution is e²; at 0.3 m/s e = 0.2 does not rebound.
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let e = request.restitution;
    let mut export = Export::new(TOOL);
    match request.speed {
        Some(speed) => check_rebound(e, speed)?,
        None => export.missing.push("closing speed, m/s: there is no rebound below 0.1 m/s"),
    }
    export.time_step = rigid::time_step(request);
    let travel = request.speed.and_then(|_| rigid::travel_error(request, export.time_step));
    export.error_bound = travel.map(|travel| (1.0 + e) * limits::DART_BOUNCE_ERROR + travel);
    export.set("restitution_coefficient", e, "");
    export.set("other_restitution_coefficient", 1.0, "");
    export.set("mu", 0.0, "");
    if let Some(step) = export.time_step {
        export.set("max_step_size", step, "s");
    }
    export.add_snippet("world", "xml", sdf_document(e, export.time_step));
    export.add_assumption(
        "The two collisions of the pair have different surfaces; replace their shapes, which are \
        placeholders.",
    );
    export.add_assumption("The physics engine is gz-physics' dartsim, the default of gz-sim.");
    export.add_assumption(
        "The restitution of a free body holds at any step. The bodies overlap by up to the travel of one step. \
         The contact has no spring: m̄ has no effect.",
    );
    rigid::add_travel_assumption(&mut export, request);
    export.cannot.push("stiffness, compression, duration, peak force: gz-physics does not read kp and kd");
    export.cannot.push("bullet-featherstone: its restitution was not measured");
    Ok(export)
}

/// Error: DART suppresses this rebound.
fn check_rebound(e: f64, speed: f64) -> Result<(), ExportError> {
    let speed = positive(LawParameter::Speed, speed)?;
    let unreachable = |why, remedy| ExportError::Unreachable { tool: TOOL, restitution: e, why, remedy };
    if e > 0.0 && e * speed <= limits::DART_SLOWEST_REBOUND {
        return Err(unreachable(
            "there is no rebound at 0.1 m/s or below (DART_BOUNCING_VELOCITY_THRESHOLD)",
            "use a larger closing speed, or a tool with a spring and damper",
        ));
    }
    if e * speed > limits::DART_FASTEST_REBOUND {
        return Err(unreachable(
            "a rebound is at most 100 m/s (DART_MAX_BOUNCING_VELOCITY)",
            "approach more slowly",
        ));
    }
    Ok(())
}

/// SDF with the physics and the two collisions.
fn sdf_document(e: f64, step: Option<f64>) -> String {
    let physics = step.map_or_else(String::new, |step| {
        format!(
            "    <physics name=\"step\" type=\"ignored\">\n      <max_step_size>{step:?}</max_step_size>\n    </physics>\n"
        )
    });
    let model = |name: &str, coefficient: f64| {
        format!(
            "    <model name=\"{name}\">\n      <link name=\"link\">\n        <collision name=\"collision\">\n          \
             <geometry><sphere><radius>0.1</radius></sphere></geometry>\n          <surface>\n            \
             <friction><ode><mu>0.0</mu><mu2>0.0</mu2></ode></friction>\n            \
             <bounce><restitution_coefficient>{coefficient:?}</restitution_coefficient></bounce>\n          </surface>\n        \
             </collision>\n      </link>\n    </model>\n"
        )
    };
    format!(
        "<sdf version=\"1.9\">\n  <world name=\"default\">\n{physics}{}{}  </world>\n</sdf>\n",
        model("struck", e),
        model("other", 1.0)
    )
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let other = given.optional("other_restitution_coefficient")?.unwrap_or(1.0);
    let restitution = given.restitution("restitution_coefficient")? * other;
    given.assume("mu", 0.0)?;
    given.optional("max_step_size")?;
    let restitution = if restitution < limits::DART_LEAST { 0.0 } else { restitution };
    let slowest = if restitution > 0.0 { limits::DART_SLOWEST / restitution } else { 0.0 };
    Ok(vec![SimulatedContact::of(ContactModel::Rigid { restitution, slowest })])
}
