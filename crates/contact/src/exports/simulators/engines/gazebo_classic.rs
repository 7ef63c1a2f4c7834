//! Gazebo Classic with ODE: the `<surface>` of an SDF collision.

use crate::exports::linear::Linear;
use crate::exports::simulators::simulated::{Given, SimulatedContact};
use crate::exports::{Export, ExportError, Facts, Measurement, Request, Tool};
use crate::limits;

const TOOL: Tool = Tool::of(&FACTS);

pub(crate) const FACTS: Facts = Facts {
    name: "gazebo-classic",
    title: "Gazebo Classic (ODE)",
    aliases: &["classic", "gazebo-11"],
    law: "linear spring and damper, never pulling, by implicit Euler",
    combines: "kp in series, kd added, the lesser friction and max_vel",
    measured: &[Measurement {
        engine: "Gazebo Classic 11.1.0",
        solver: "world",
        scenes: "ball; pendulums, m̄ = 1.5 and 3.75 kg of a 2 kg body",
        worst: [Some(5.0e-4), Some(4.1e-4), Some(3.5e-4)],
        by_hand: Some("2026-11-22"),
    }],
    caution: "give the solver \"world\" and friction 0 as written: Gazebo's defaults, \"quick\" and mu = 1, change the restitution",
    sources: &[
        "Gazebo Classic 11, gazebo/physics/ode/ODEPhysics.cc: Collide; deps/opende/src/joints/contact.cpp",
        "SDFormat 1.9, surface.sdf, physics.sdf",
    ],
};

/// For each of two equal collisions kp = 2k, kd = c'/2: ODE gets the springs in series and the sum of the dampers.
///
/// c' as for ODE: 2(ζ − ωh/2)√(k m̄). Measured in Gazebo Classic 11.1.0: to two digits as in ODE, at half and twice
/// the step too. With the solver "quick" 1.2e-3, 1.7e-3, 1.0e-3. With 4k/3 and 4k, c'/4 and 3c'/4 on the two sides a
/// ball rebounds as with equal ones.
pub(crate) fn export(request: &Request) -> Result<Export, ExportError> {
    let linear = Linear::of(request, TOOL)?;
    let step = linear.implicit_step();
    let damping = linear.damping(linear.implicit_ratio(step)?);
    let (kp, kd) = (2.0 * linear.stiffness, damping / 2.0);
    let fastest = request.speed.map_or(limits::GAZEBO_FASTEST, |speed| {
        (limits::GAZEBO_PUSH_RATIO * speed).max(limits::GAZEBO_SLOWEST_PUSH)
    });
    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.error_bound = Some(linear.implicit_error_bound(step));
    export.add_penetration("", linear.penetration(request.speed));
    export.set("kp", kp, "N/m");
    export.set("kd", kd, "N·s/m");
    export.set("max_vel", fastest, "m/s");
    export.set("min_depth", 0.0, "m");
    export.set("mu", 0.0, "");
    export.set("solver", "world", "");
    export.set("max_step_size", step, "s");
    let surface = format!(
        "<surface>\n            <friction><ode><mu>0.0</mu><mu2>0.0</mu2></ode></friction>\n            \
         <contact><ode><kp>{kp:?}</kp><kd>{kd:?}</kd><max_vel>{fastest:?}</max_vel><min_depth>0.0</min_depth></ode></contact>\n          \
         </surface>"
    );
    export.add_snippet(
        "world",
        "xml",
        format!(
            "<sdf version=\"1.6\">\n  <world name=\"default\">\n    \
             <physics name=\"step\" type=\"ode\">\n      <max_step_size>{step:?}</max_step_size>\n      \
             <ode><solver><type>world</type></solver></ode>\n    </physics>\n    \
             <!-- The same surface on the other collision of the pair. -->\n    \
             <model name=\"struck\">\n      <link name=\"link\">\n        <collision name=\"collision\">\n          \
             <geometry><sphere><radius>0.1</radius></sphere></geometry>\n          {surface}\n        \
             </collision>\n      </link>\n    </model>\n  </world>\n</sdf>\n"
        ),
    );
    export
        .add_assumption("Both collisions have the <surface>; the sphere is a placeholder for your geometry.");
    export.add_assumption(linear.implicit_assumption(step));
    export.add_assumption(
        "The solver is \"world\" (ODE's direct one): \"quick\", the default, has an error of 1e-3 to 2e-3 for \
         every step and number of iterations.",
    );
    export.add_assumption(
        "Frictionless: with mu = 1 a pendulum rebounds by up to 0.04 too low. max_vel is for the solver \"quick\", where it caps the \
         spring's push (0.01 m/s by default); \"world\" was the same with it and without.",
    );
    export.cannot.push(
        "an accurate rigid bounce: with the solver \"quick\" max_vel caps the rebound of \
         restitution_coefficient, and above it the rebound \
         depends on where within a step the contact begins",
    );
    Ok(export)
}

/// Contact of given parameters.
pub(crate) fn simulated(given: &mut Given) -> Result<Vec<SimulatedContact<'static>>, ExportError> {
    let (stiffness, damping) = (given.positive("kp")? / 2.0, 2.0 * given.number("kd")?);
    let step = given.positive("max_step_size")?;
    given.assume("min_depth", 0.0)?;
    given.assume("mu", 0.0)?;
    given.optional("max_vel")?;
    Ok(vec![SimulatedContact::implicit(given, stiffness, damping, step)?])
}
