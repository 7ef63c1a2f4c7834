//! Planar linkages with results in [`closed_form`](crate::closed_form).

use super::Linkage;
use crate::alter::build_with_loops;
use crate::closed_form::{Crossing, FourBar, PlanarBody, SliderCrank};
use crate::parts::{frame, ground, joint};
use percuss_mechanism::{ClosureDescription, ClosureKind, Inertial, JointKind, LinkDescription};
use percuss_spatial::{Transform, Vector3};
use std::f64::consts::PI;

use JointKind::{Continuous, Prismatic, Revolute};

const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// Frame of the planar linkages in the ground: the linkages lie in the x-y plane.
pub fn plane() -> Transform<f64> {
    frame([0.4, -0.7, 1.1], [0.2, -0.1, 0.5])
}

/// Lengths of [`four_bar`], a crank-rocker.
pub const FOUR_BAR: FourBar = FourBar { ground: 0.9, crank: 0.25, coupler: 0.8, rocker: 0.6 };

/// Crank, coupler and rocker of [`four_bar`].
pub const FOUR_BAR_BODIES: [PlanarBody; 3] =
    [body(1.3, [0.08, -0.02], 0.011), body(2.1, [0.38, 0.11], 0.13), body(1.7, [0.27, -0.05], 0.06)];

/// Lengths of [`parallelogram`] and [`antiparallelogram`].
pub const PARALLELOGRAM: FourBar = FourBar { ground: 1.0, crank: 0.4, coupler: 1.0, rocker: 0.4 };

/// Lengths of [`slider_crank`].
pub const SLIDER_CRANK: SliderCrank = SliderCrank { crank: 0.3, rod: 1.1, offset: 0.12 };

/// Crank, rod and slider of [`slider_crank`].
pub const SLIDER_CRANK_BODIES: [PlanarBody; 3] =
    [body(4.2, [-0.03, 0.01], 0.05), body(1.1, [0.4, 0.02], 0.12), body(0.9, [0.05, 0.03], 0.004)];

/// Body of given mass, centre of mass and central moment of inertia, as a constant.
const fn body(mass: f64, com: [f64; 2], inertia: f64) -> PlanarBody {
    PlanarBody { mass, com: nalgebra::Vector2::new(com[0], com[1]), inertia }
}

/// Link with this body in its x-y plane; inertia components that do not affect planar motion have arbitrary values.
pub(super) fn link(name: &str, body: &PlanarBody) -> LinkDescription {
    if body.mass == 0.0 && body.inertia == 0.0 {
        return LinkDescription::massless(name);
    }
    let moments = [0.7 * body.inertia, 0.5 * body.inertia, body.inertia];
    LinkDescription::new(name, Inertial::diagonal(body.mass, [body.com.x, body.com.y, 0.01], moments))
}

/// Point of the plane in ground coordinates.
pub(super) fn on_ground(x: f64, y: f64) -> Transform<f64> {
    plane() * Transform::from_translation(Vector3::new(x, y, 0.0))
}

/// Revolute closure between points of two links.
pub(super) fn pin(name: &str, before: (&str, [f64; 2]), after: (&str, [f64; 2])) -> ClosureDescription {
    let at = |[x, y]: [f64; 2]| [x, y, 0.0];
    ClosureDescription::new(name, ClosureKind::Revolute, before.0, after.0)
        .at(at(before.1), at(after.1))
        .axis(Z)
}

/// Positions of `crank_hinge`, `crank_pin` and `rocker_hinge` at a crank angle.
fn four_bar_start(bar: &FourBar, theta: f64, crossing: Crossing) -> [(&'static str, f64); 3] {
    let Some([_, coupler, rocker]) = bar.poses(theta, crossing) else { panic!("it does not assemble") };
    [("crank_hinge", theta), ("crank_pin", coupler.angle - theta), ("rocker_hinge", rocker.angle)]
}

/// Four-bar in [`plane`] with links `crank`, `coupler` and `rocker`; driver `crank_hinge`, start at `theta`.
pub fn four_bar_of(
    name: &'static str,
    bar: FourBar,
    bodies: [PlanarBody; 3],
    crossing: Crossing,
    theta: f64,
    range: [f64; 2],
) -> Linkage {
    let links =
        vec![ground(), link("crank", &bodies[0]), link("coupler", &bodies[1]), link("rocker", &bodies[2])];
    let joints = vec![
        joint("crank_hinge", Continuous, "ground", "crank").origin(on_ground(0.0, 0.0)).axis(Z),
        joint("crank_pin", Continuous, "crank", "coupler").at([bar.crank, 0.0, 0.0]).axis(Z),
        joint("rocker_hinge", Continuous, "ground", "rocker").origin(on_ground(bar.ground, 0.0)).axis(Z),
    ];
    let closure = pin("rocker_pin", ("coupler", [bar.coupler, 0.0]), ("rocker", [bar.rocker, 0.0]));
    let mechanism = build_with_loops(name, links, joints, vec![closure], Vec::new());
    Linkage::new(mechanism, name, [("crank_hinge", range)], four_bar_start(&bar, theta, crossing))
}

/// Crank-rocker with the lengths [`FOUR_BAR`], open assembly. Driver `crank_hinge`, a full turn.
pub fn four_bar() -> Linkage {
    four_bar_of("four_bar", FOUR_BAR, FOUR_BAR_BODIES, Crossing::Left, 0.7, [-PI, PI])
}

/// Parallelogram. Driver `crank_hinge`, 0.3 to 2.8; its branch crosses that of [`antiparallelogram`] at 0 and π.
pub fn parallelogram() -> Linkage {
    four_bar_of("parallelogram", PARALLELOGRAM, FOUR_BAR_BODIES, Crossing::Left, 1.2, [0.3, 2.8])
}

/// Crossed assembly of the same lengths. Driver `crank_hinge`, 0.3 to 2.8.
pub fn antiparallelogram() -> Linkage {
    four_bar_of("antiparallelogram", PARALLELOGRAM, FOUR_BAR_BODIES, Crossing::Right, 1.2, [0.3, 2.8])
}

/// Wheel on two equal, parallel, massless arms of 0.4 m, 0.25 m apart (the plane's x is upwards). Driver
/// `crank_hinge`, 1.0 to 2.1, with horizontal arms at π/2. The wheel's link is `coupler`.
pub fn massless_arm_suspension() -> Linkage {
    let bar = FourBar::parallelogram(0.25, 0.4);
    let bodies = [PlanarBody::MASSLESS, body(38.0, [0.13, -0.1], 1.6), PlanarBody::MASSLESS];
    four_bar_of("massless_arm_suspension", bar, bodies, Crossing::Left, 1.4, [1.0, 2.1])
}

/// Slider-crank in [`plane`] with links `crank`, `rod`, `slider`; the closure connects rod and slider. Driver
/// `crank_hinge`, a full turn.
pub fn slider_crank_of(name: &'static str, engine: SliderCrank, bodies: [PlanarBody; 3]) -> Linkage {
    let links =
        vec![ground(), link("crank", &bodies[0]), link("rod", &bodies[1]), link("slider", &bodies[2])];
    let joints = vec![
        joint("crank_hinge", Continuous, "ground", "crank").origin(on_ground(0.0, 0.0)).axis(Z),
        joint("crank_pin", Continuous, "crank", "rod").at([engine.crank, 0.0, 0.0]).axis(Z),
        joint("guide", Prismatic, "ground", "slider").origin(on_ground(0.0, engine.offset)),
    ];
    let closure = pin("wrist_pin", ("rod", [engine.rod, 0.0]), ("slider", [0.0, 0.0]));
    let mechanism = build_with_loops(name, links, joints, vec![closure], Vec::new());
    let theta = 0.8;
    let Some([_, rod, slider]) = engine.poses(theta) else { panic!("it does not assemble") };
    let start = [("crank_hinge", theta), ("crank_pin", rod.angle - theta), ("guide", slider.origin.x)];
    Linkage::new(mechanism, name, [("crank_hinge", [-PI, PI])], start)
}

/// Slider-crank with the lengths [`SLIDER_CRANK`]. Driver `crank_hinge`, a full turn.
pub fn slider_crank() -> Linkage {
    slider_crank_of("slider_crank", SLIDER_CRANK, SLIDER_CRANK_BODIES)
}

/// Six-bar linkage (Stephenson): [`four_bar`] with a dyad `link_5`, `link_6` from a point of its coupler to the
/// ground. Two loops in one group. Driver `crank_hinge`, 0 to 1.6.
pub fn six_bar() -> Linkage {
    let bar = FOUR_BAR;
    let bodies = FOUR_BAR_BODIES;
    let links = vec![
        ground(),
        link("crank", &bodies[0]),
        link("coupler", &bodies[1]),
        link("rocker", &bodies[2]),
        link("link_5", &body(0.8, [0.3, 0.02], 0.03)),
        link("link_6", &body(1.1, [0.2, 0.03], 0.04)),
    ];
    let joints = vec![
        joint("crank_hinge", Continuous, "ground", "crank").origin(on_ground(0.0, 0.0)).axis(Z),
        joint("crank_pin", Continuous, "crank", "coupler").at([bar.crank, 0.0, 0.0]).axis(Z),
        joint("rocker_hinge", Continuous, "ground", "rocker").origin(on_ground(bar.ground, 0.0)).axis(Z),
        joint("coupler_point", Continuous, "coupler", "link_5").at([0.35, 0.3, 0.0]).axis(Z),
        joint("output_hinge", Continuous, "ground", "link_6").origin(on_ground(1.0, 0.5)).axis(Z),
    ];
    let closures = vec![
        pin("rocker_pin", ("coupler", [bar.coupler, 0.0]), ("rocker", [bar.rocker, 0.0])),
        pin("output_pin", ("link_5", [0.7, 0.0]), ("link_6", [0.5, 0.0])),
    ];
    let mechanism = build_with_loops("six_bar", links, joints, closures, Vec::new());
    let mut start = four_bar_start(&bar, 0.7, Crossing::Left).to_vec();
    // The dyad's elbow is above the line to its pivot.
    start.extend([("coupler_point", 0.2), ("output_hinge", 1.6)]);
    Linkage::new(mechanism, "six_bar", [("crank_hinge", [0.0, 1.6])], start)
}

/// Leg with the knee driven from the hip: thigh with a bell crank, push rod and shank; the knee closes the loop
/// from the shank to its ancestor, the thigh. Drivers `hip` and `bell_crank`, ±0.5 rad.
pub fn planar_leg() -> Linkage {
    let links = vec![
        ground(),
        link("thigh", &body(2.6, [0.15, 0.01], 0.04)),
        link("bell_crank", &body(0.3, [0.03, 0.0], 0.0006)),
        link("push_rod", &body(0.2, [0.2, 0.0], 0.003)),
        link("shank", &body(0.9, [0.12, 0.02], 0.012)),
    ];
    let joints = vec![
        joint("hip", Revolute, "ground", "thigh").origin(on_ground(0.1, 0.2)).axis(Z).armature(0.05),
        joint("bell_crank", Revolute, "thigh", "bell_crank").at([0.05, 0.02, 0.0]).axis(Z).armature(0.02),
        joint("upper_pin", Revolute, "bell_crank", "push_rod").at([0.07, 0.0, 0.0]).axis(Z),
        joint("lower_pin", Revolute, "push_rod", "shank").at([0.36, 0.0, 0.0]).axis(Z),
    ];
    // The shank's frame is at its pin to the rod.
    let knee = pin("knee", ("shank", [0.06, 0.0]), ("thigh", [0.4, 0.0]));
    let mechanism = build_with_loops("planar_leg", links, joints, vec![knee], Vec::new());
    let drivers = [("hip", [-0.9, 0.1]), ("bell_crank", [1.1, 2.1])];
    let start = [("hip", -0.4), ("bell_crank", 1.6), ("upper_pin", -1.6), ("lower_pin", -1.7)];
    Linkage::new(mechanism, "planar_leg", drivers, start)
}
