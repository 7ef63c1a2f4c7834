//! Gazebo: the `<surface>` of an SDF collision, for Gazebo Classic; and what the new Gazebo reads of it.

use super::linear::Linear;
use super::{Export, ExportError, Facts, Request, Tool};
use crate::limits;

const TOOL: Tool = Tool::of(&FACTS);

pub(super) const FACTS: Facts = Facts {
    name: "gazebo",
    title: "Gazebo",
    aliases: &["sdf", "sdformat", "gz", "gazebo-classic", "ignition"],
    law: "Gazebo Classic with ODE: linear spring and damper, never pulling, by implicit Euler",
    combines: "Classic: kp in series, kd added, the lesser restitution_coefficient and threshold",
    measured: &[],
    caution: "",
    sources: &[
        "Gazebo Classic, gazebo/physics/ode/ODEPhysics.cc: Collide",
        "SDFormat 1.9, surface.sdf",
        "gz-physics, bullet-featherstone/src/SDFFeatures.cc and dartsim/src/SDFFeatures.cc",
    ],
};

/// For each of two equal collisions kp = 2k, kd = c'/2: ODE gets the springs in series and the sum of the dampers.
///
/// c' as for ODE: 2(ζ − ωh/2)√(k m̄). The rigid alternative is `restitution_coefficient` = e with its threshold
/// lowered, all that the new Gazebo reads.
pub(super) fn export(request: &Request) -> Result<Export, ExportError> {
    let linear = Linear::of(request, TOOL)?;
    let step = linear.implicit_step();
    let damping = linear.damping(linear.implicit_ratio(step)?);
    let (kp, kd) = (2.0 * linear.stiffness, damping / 2.0);
    let fastest = request.speed.map_or(limits::GAZEBO_FASTEST, |speed| 10.0 * speed);
    let threshold =
        request.speed.map_or(limits::GAZEBO_THRESHOLD, |speed| limits::GAZEBO_THRESHOLD.min(speed / 10.0));
    let mut export = Export::new(TOOL);
    export.time_step = Some(step);
    export.error_bound = Some(linear.implicit_error_bound(step));
    export.set("kp", kp, "N/m");
    export.set("kd", kd, "N·s/m");
    export.set("max_vel", fastest, "m/s");
    export.set("min_depth", 0.0, "m");
    export.set("max_step_size", step, "s");
    export.set("restitution_coefficient", request.restitution, "");
    export.set("threshold", threshold, "m/s");
    let spring = format!(
        "<contact><ode><kp>{kp:?}</kp><kd>{kd:?}</kd><max_vel>{fastest:?}</max_vel><min_depth>0.0</min_depth></ode></contact>"
    );
    let rigid = format!(
        "<bounce><restitution_coefficient>{:?}</restitution_coefficient><threshold>{threshold:?}</threshold></bounce>",
        request.restitution
    );
    export.write("Gazebo Classic, spring and damper", "xml", document("ode", step, &spring));
    export.write("new Gazebo, and Classic with a rigid bounce", "xml", document("ignored", step, &rigid));
    words(&mut export, &linear, step);
    Ok(export)
}

/// An SDF with the physics and one collision that has the surface.
fn document(engine: &str, step: f64, surface: &str) -> String {
    format!(
        "<sdf version=\"1.9\">\n  <world name=\"default\">\n    \
         <physics name=\"step\" type=\"{engine}\">\n      <max_step_size>{step:?}</max_step_size>\n    </physics>\n    \
         <model name=\"struck\">\n      <link name=\"link\">\n        <collision name=\"collision\">\n          \
         <geometry><sphere><radius>0.1</radius></sphere></geometry>\n          \
         <surface>{surface}</surface>\n        </collision>\n      </link>\n    </model>\n  </world>\n</sdf>\n"
    )
}

fn words(export: &mut Export, linear: &Linear, step: f64) {
    export.assume("Both collisions have the <surface>; the sphere is a placeholder for your geometry.");
    export.assume(linear.implicit_words(step));
    export.assume(
        "max_vel caps the speed at which ODE pushes bodies apart (0.01 m/s by default), and must be above the \
         rebound's; that it caps the spring too was not measured.",
    );
    export.assume(
        "Of two restitution_coefficients Classic takes the lesser, of two thresholds too; spring and coefficient \
         together would bounce twice, so give one of them.",
    );
    export.assume("Not measured in Gazebo itself: read in its source, and run in a model of ODE's row.");
    export.cannot.push(
        "new Gazebo (dartsim, bullet-featherstone): does not read kp and kd; it bounces by restitution_coefficient alone",
    );
}
