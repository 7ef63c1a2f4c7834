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

    fn direction(&self, v: Vector2<f64>) -> Vector3<f64> {
        self.0.vector(&v.push(0.0))
    }

    /// Velocity of a body point at `point` in the world.
    pub fn velocity(&self, motion: &Motion, point: &Vector3<f64>) -> Vector3<f64> {
        self.direction(motion.velocity_of(self.0.inverse_point(point).xy()))
    }
}

/// Drawing placed in space.
pub(super) struct Stood {
    pub mechanism: Mechanism,
    pub plane: Plane,
}

/// Orientation of the frames.
#[derive(Clone, Copy, PartialEq)]
enum Style {
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

fn link_turn(rng: &mut StdRng, style: Style, plane: &Plane) -> Matrix3<f64> {
    const AXES: [[f64; 3]; 5] = [
        [FRAC_PI_2, 0.0, 0.0],
        [-FRAC_PI_2, 0.0, 0.0],
        [0.0, FRAC_PI_2, 0.0],
        [0.0, -FRAC_PI_2, 0.0],
        [PI, 0.0, 0.0],
    ];
    let within = plane.0.rotation * rotation_about(&Vector3::z(), rng.random_range(-PI..PI));
    match style {
        Style::General => frame(rng, 1.0).rotation,
        Style::AlongZ | Style::Upright => within,
        Style::AlongAny => within * rotation_from_rpy(AXES[rng.random_range(0..AXES.len())]),
    }
}

/// Builds a mechanism from a drawing whose first `tree` pins are the tree joints.
pub(super) fn stand(rng: &mut StdRng, name: &str, drawing: &Drawing, tree: usize, tool: Tool) -> Stood {
    let style = match rng.random_range(0..6) {
        0..=2 => Style::General,
        3 => Style::AlongZ,
        4 => Style::AlongAny,
        _ => Style::Upright,
    };
    let mut plane = Plane(frame(rng, 0.5));
    if style == Style::Upright {
        plane.0.rotation = rotation_from_rpy([FRAC_PI_2, 0.0, [0.0, FRAC_PI_2][rng.random_range(0..2)]]);
    }
    let depth = |rng: &mut StdRng| if style == Style::Upright { 0.0 } else { rng.random_range(-0.2..0.2) };
    let normal = plane.normal();
    // X_wl, with each link's origin on the axis of its parent joint.
    let mut frames = vec![Transform::identity(); drawing.bodies.len()];
    for pin in &drawing.pins[..tree] {
        let origin = plane.0.point(&pin.at.push(depth(rng)));
        frames[pin.bodies[1]] = Transform::new(link_turn(rng, style, &plane), origin);
    }
    let mut links = vec![ground()];
    for (i, own) in drawing.bodies.iter().enumerate().skip(1) {
        let pins: Vec<_> = drawing.pins.iter().filter(|pin| pin.bodies.contains(&i)).collect();
        let middle = pins.iter().map(|pin| pin.at).sum::<Vector2<f64>>() / pins.len() as f64;
        let com = plane.0.point(&middle.push(0.0)) + vector(rng, 0.1);
        links.push(lump(rng, own, frames[i].inverse_point(&com)));
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
            let first = link_turn(rng, style, &plane);
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
        links.push(lump(rng, "tool", com));
        let kind = if tool == Tool::Hinged { JointKind::Continuous } else { JointKind::Fixed };
        let mut joint = JointDescription::new("tool_joint", kind, drawing.bodies[drawing.coupler], "tool")
            .origin(frame(rng, 0.3));
        joint.axis = direction(rng);
        joints.push(joint);
    }
    let mechanism = build_with_loops(name, links, joints, closures, Vec::new());
    Stood { mechanism, plane }
}

fn lump(rng: &mut StdRng, name: &str, com: Vector3<f64>) -> LinkDescription {
    let mut link = body(rng, 0);
    name.clone_into(&mut link.name);
    if let Some(inertial) = &mut link.inertial {
        inertial.com = com;
    }
    link
}
