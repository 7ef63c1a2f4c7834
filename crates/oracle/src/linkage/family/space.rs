//! Places a planar drawing in space: link frames, loop frames, bodies and axes.

use super::drawing::{Drawing, Motion};
use super::tool::Tool;
use crate::alter::build_with_loops;
use crate::parts::ground;
use crate::random::{body, direction, frame, vector};
use nalgebra::{Matrix3, Vector2, Vector3};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, JointDescription, JointKind, LinkDescription, Mechanism,
};
use percuss_spatial::{Transform, rotation_about, rotation_from_rpy};
use rand::{Rng, rngs::StdRng};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Pose of the plane of a drawing.
pub(super) struct Plane(Transform<f64>);

impl Plane {
    /// Its unit normal.
    pub fn normal(&self) -> Vector3<f64> {
        self.0.vector(&Vector3::z())
    }

    /// Vector of the plane in the world.
    fn direction(&self, v: Vector2<f64>) -> Vector3<f64> {
        self.0.vector(&v.push(0.0))
    }

    /// Velocity of a body point at `point` in the world.
    pub fn velocity(&self, motion: &Motion, point: &Vector3<f64>) -> Vector3<f64> {
        self.direction(motion.velocity_of(self.0.inverse_point(point).xy()))
    }
}

/// Drawing placed in space.
pub(super) struct PlacedDrawing {
    pub mechanism: Mechanism,
    pub plane: Plane,
}

/// Orientation of the frames.
#[derive(Clone, Copy, PartialEq)]
enum FrameStyle {
    /// General orientations.
    General,
    /// Each frame has its z-axis along the joint axis.
    AlongZ,
    /// Each frame has one of ±x, ±y, −z along the joint axis.
    AlongAny,
    /// As `AlongZ`, in a vertical plane: roll, pitch and yaw are multiples of 90° or in the plane, and every
    /// link frame lies in the plane.
    Upright,
}

/// Random orientation of a link frame in a style.
fn random_link_orientation(rng: &mut StdRng, style: FrameStyle, plane: &Plane) -> Matrix3<f64> {
    const AXES: [[f64; 3]; 5] = [
        [FRAC_PI_2, 0.0, 0.0],
        [-FRAC_PI_2, 0.0, 0.0],
        [0.0, FRAC_PI_2, 0.0],
        [0.0, -FRAC_PI_2, 0.0],
        [PI, 0.0, 0.0],
    ];
    let within = plane.0.rotation * rotation_about(&Vector3::z(), rng.random_range(-PI..PI));
    match style {
        FrameStyle::General => frame(rng, 1.0).rotation,
        FrameStyle::AlongZ | FrameStyle::Upright => within,
        FrameStyle::AlongAny => within * rotation_from_rpy(AXES[rng.random_range(0..AXES.len())]),
    }
}

/// Builds a mechanism from a drawing whose first `tree` pins are the tree joints.
pub(super) fn place_in_space(
    rng: &mut StdRng,
    name: &str,
    drawing: &Drawing,
    tree: usize,
    tool: Tool,
) -> PlacedDrawing {
    let style = match rng.random_range(0..6) {
        0..=2 => FrameStyle::General,
        3 => FrameStyle::AlongZ,
        4 => FrameStyle::AlongAny,
        _ => FrameStyle::Upright,
    };
    let mut plane = Plane(frame(rng, 0.5));
    if style == FrameStyle::Upright {
        plane.0.rotation = rotation_from_rpy([FRAC_PI_2, 0.0, [0.0, FRAC_PI_2][rng.random_range(0..2)]]);
    }
    let depth =
        |rng: &mut StdRng| if style == FrameStyle::Upright { 0.0 } else { rng.random_range(-0.2..0.2) };
    let normal = plane.normal();
    // X_wl, with each link's origin on the axis of its parent joint.
    let mut frames = vec![Transform::identity(); drawing.bodies.len()];
    for pin in &drawing.pins[..tree] {
        let origin = plane.0.point(&pin.at.push(depth(rng)));
        frames[pin.bodies[1]] = Transform::new(random_link_orientation(rng, style, &plane), origin);
    }
    let mut links = vec![ground()];
    for (i, own) in drawing.bodies.iter().enumerate().skip(1) {
        let pins: Vec<_> = drawing.pins.iter().filter(|pin| pin.bodies.contains(&i)).collect();
        let middle = pins.iter().map(|pin| pin.at).sum::<Vector2<f64>>() / pins.len() as f64;
        let com = plane.0.point(&middle.push(0.0)) + vector(rng, 0.1);
        links.push(random_body(rng, own, frames[i].inverse_point(&com)));
    }
    let mut joints: Vec<JointDescription> = drawing.pins[..tree]
        .iter()
        .map(|pin| {
            let [parent, child] = pin.bodies;
            let kind = if pin.slide.is_some() { JointKind::Prismatic } else { JointKind::Continuous };
            let axis = pin.slide.map_or(normal, |slide| plane.direction(slide));
            JointDescription {
                axis: frames[child].inverse_vector(&axis),
                ..JointDescription::new(pin.name, kind, drawing.bodies[parent], drawing.bodies[child])
                    .origin(frames[parent].inverse() * frames[child])
            }
        })
        .collect();
    let closures = drawing.pins[tree..]
        .iter()
        .map(|pin| {
            let [before, after] = pin.bodies;
            let at = plane.0.point(&pin.at.push(depth(rng)));
            let first = random_link_orientation(rng, style, &plane);
            let second = rotation_about(&normal, rng.random_range(0.0..TAU)) * first;
            let inside = |body: usize, turn: Matrix3<f64>| frames[body].inverse() * Transform::new(turn, at);
            debug_assert!(pin.slide.is_none(), "slides come first");
            ClosureDescription {
                predecessor_frame: inside(before, first),
                successor_frame: inside(after, second),
                axis: first.tr_mul(&normal),
                ..ClosureDescription::new(
                    pin.name,
                    ClosureKind::Revolute,
                    drawing.bodies[before],
                    drawing.bodies[after],
                )
            }
        })
        .collect();
    if tool != Tool::None {
        let com = vector(rng, 0.1);
        links.push(random_body(rng, "tool", com));
        let kind = if tool == Tool::Hinged { JointKind::Continuous } else { JointKind::Fixed };
        let mut joint = JointDescription::new("tool_joint", kind, drawing.bodies[drawing.coupler], "tool")
            .origin(frame(rng, 0.3));
        joint.axis = direction(rng);
        joints.push(joint);
    }
    let mechanism = build_with_loops(name, links, joints, closures, Vec::new());
    PlacedDrawing { mechanism, plane }
}

/// Random body with a given centre of mass.
fn random_body(rng: &mut StdRng, name: &str, com: Vector3<f64>) -> LinkDescription {
    let mut link = body(rng, 0);
    name.clone_into(&mut link.name);
    if let Some(inertial) = &mut link.inertial {
        inertial.com = com;
    }
    link
}
