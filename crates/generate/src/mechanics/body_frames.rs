//! Bodies with expressions: the steps from each body to its parent, motion columns, inertias in the chosen frames.

use super::frame_choice::{ChosenFrame, axis_frame, choose_frames, decompose, sine_cosine};
use super::motion::{FrameExpr, InertiaExpr, Step, TwistExpr};
use super::tree::{Tree, TreeBody};
use crate::expression::graph::{Expr, Graph};
use crate::expression::vector::{Matrix, Vector};
use percuss_mechanism::JointKind;
use percuss_spatial::{SpatialInertia, Transform};
use std::f64::consts::FRAC_PI_2;

/// Entries of a rotational inertia below this multiple of its trace are rounding errors of zero.
const INERTIA_ROUNDING: f64 = f64::EPSILON;

/// Body in its chosen frame.
#[derive(Clone, Debug)]
pub(crate) struct BodyExpr {
    /// Steps from the body to its parent, the parent's side first.
    pub steps: Vec<Step>,
    /// Motion column of every tree velocity of the joint, in the body's frame.
    pub columns: Vec<TwistExpr>,
    pub inertia: InertiaExpr,
}

/// The tree with expressions.
#[derive(Clone, Debug)]
pub(crate) struct Bodies {
    pub tree: Tree,
    pub bodies: Vec<BodyExpr>,
    frames: Vec<ChosenFrame>,
}

impl Bodies {
    /// Bodies of a tree. `preferred`: bodies on the path of the contact. `scale`: characteristic length, m.
    pub fn new(g: &mut Graph, tree: Tree, preferred: &[usize], scale: f64) -> Self {
        let frames = choose_frames(&tree, preferred, scale);
        let bodies = (0..tree.bodies.len())
            .map(|i| {
                let body = &tree.bodies[i];
                let parent = body.parent.map_or_else(Transform::identity, |p| frames[p].frame);
                let (steps, columns) = joint_steps(g, body, &parent, &frames[i], scale);
                let inertia = chosen_inertia(&body.inertia, &frames[i].frame);
                BodyExpr { steps, columns, inertia: constant_inertia(g, &inertia) }
            })
            .collect();
        Self { tree, bodies, frames }
    }

    /// Frame on a body given in the frame of the body's link, in the chosen frame.
    pub fn frame_on(&self, body: Option<usize>, frame: &Transform<f64>) -> Transform<f64> {
        body.map_or(*frame, |b| self.frames[b].frame.inverse() * *frame)
    }

    /// Frame of every body on the path from `ancestor` to `body`, expressed in `ancestor`.
    pub fn frame_in(&self, g: &mut Graph, ancestor: Option<usize>, body: Option<usize>) -> FrameExpr {
        let mut frame = FrameExpr { rotation: identity(g), origin: g.zeros() };
        for b in self.path(ancestor, body) {
            for step in &self.bodies[b].steps {
                frame = step.extend_frame(g, &frame);
            }
        }
        frame
    }

    /// Bodies below `ancestor` on the path down to `body`, parents first.
    pub fn path(&self, ancestor: Option<usize>, body: Option<usize>) -> Vec<usize> {
        let mut path: Vec<usize> =
            self.tree.ancestors(body).into_iter().take_while(|&b| Some(b) != ancestor).collect();
        path.reverse();
        path
    }

    /// Components in body `to` of a vector of body `from`.
    pub fn vector_between(&self, g: &mut Graph, from: Option<usize>, to: Option<usize>, v: Vector) -> Vector {
        self.between(g, from, to, v, Step::vector_to_parent, Step::vector_to_child)
    }

    /// Coordinates in body `to` of a point of body `from`.
    pub fn point_between(&self, g: &mut Graph, from: Option<usize>, to: Option<usize>, p: Vector) -> Vector {
        self.between(g, from, to, p, Step::point_to_parent, Step::point_to_child)
    }

    fn between(
        &self,
        g: &mut Graph,
        from: Option<usize>,
        to: Option<usize>,
        mut v: Vector,
        up: fn(&Step, &mut Graph, Vector) -> Vector,
        down: fn(&Step, &mut Graph, Vector) -> Vector,
    ) -> Vector {
        let ancestor = self.tree.common_ancestor(from, to);
        for b in self.path(ancestor, from).into_iter().rev() {
            for step in self.bodies[b].steps.iter().rev() {
                v = up(step, g, v);
            }
        }
        for b in self.path(ancestor, to) {
            for step in &self.bodies[b].steps {
                v = down(step, g, v);
            }
        }
        v
    }
}

fn identity(g: &mut Graph) -> Matrix {
    [g.unit(0), g.unit(1), g.unit(2)]
}

/// Inertia in the chosen frame, without rounding errors of zero.
fn chosen_inertia(inertia: &SpatialInertia<f64>, frame: &Transform<f64>) -> SpatialInertia<f64> {
    let mut chosen = frame.inverse().inertia(inertia);
    let floor = INERTIA_ROUNDING * chosen.rotational.trace().abs();
    chosen.rotational = chosen.rotational.map(|x| if x.abs() <= floor { 0.0 } else { x });
    let floor = 2.0 * f64::EPSILON * chosen.first_moment.norm();
    chosen.first_moment = chosen.first_moment.map(|x| if x.abs() <= floor { 0.0 } else { x });
    chosen
}

/// Inertia with constant parameters.
fn constant_inertia(g: &mut Graph, inertia: &SpatialInertia<f64>) -> InertiaExpr {
    let r = &inertia.rotational;
    InertiaExpr {
        mass: g.constant(inertia.mass),
        first_moment: g.vector(&inertia.first_moment),
        rotational: g.matrix(&((r + r.transpose()) * 0.5)),
    }
}

/// Steps of a sequence, without motions by zero.
struct Steps(Vec<Step>);

impl Steps {
    fn shift(&mut self, g: &Graph, axis: usize, distance: Expr) {
        if !g.is_zero(distance) {
            self.0.push(Step::Shift { axis, distance });
        }
    }

    fn constant_turn(&mut self, g: &mut Graph, axis: usize, angle: f64) {
        if angle != 0.0 {
            let (sine, cosine) = sine_cosine(angle);
            let (sine, cosine) = (g.constant(sine), g.constant(cosine));
            self.0.push(Step::Turn { axis, cosine, sine });
        }
    }
}

/// Position of a joint with one degree of freedom.
fn single_position(g: &mut Graph, body: &TreeBody) -> Expr {
    match body.mimic {
        None => g.input(body.inputs.start),
        Some((master, multiplier, offset)) => {
            let master = g.input(master);
            let (scaled, offset) = (g.scale(master, multiplier), g.constant(offset));
            g.add(scaled, offset)
        }
    }
}

/// Cosine and sine of q + angle; quarter turns exchange the cosine and the sine of q.
fn cosine_sine(g: &mut Graph, q: Expr, angle: f64) -> (Expr, Expr) {
    let quarters = (angle / FRAC_PI_2).round();
    if (angle - quarters * FRAC_PI_2).abs() > 4.0 * f64::EPSILON {
        let angle = g.constant(angle);
        let q = g.add(q, angle);
        return (g.cos(q), g.sin(q));
    }
    let (c, s) = (g.cos(q), g.sin(q));
    match quarters.rem_euclid(4.0) as u8 {
        0 => (c, s),
        1 => (g.neg(s), c),
        2 => (g.neg(c), g.neg(s)),
        _ => (s, g.neg(c)),
    }
}

/// Steps from a body to its parent, and the motion columns.
fn joint_steps(
    g: &mut Graph,
    body: &TreeBody,
    parent_frame: &Transform<f64>,
    chosen: &ChosenFrame,
    scale: f64,
) -> (Vec<Step>, Vec<TwistExpr>) {
    if body.joint.is_none() {
        let columns = (0..6).map(|k| free_column(g, k)).collect();
        return (Vec::new(), columns);
    }
    let constant = parent_frame.inverse() * body.origin * axis_frame(body.kind, &body.axis);
    let mut steps = Steps(Vec::new());
    let mut columns = Vec::new();
    let turn_column = |g: &mut Graph| TwistExpr { angular: g.unit(2), linear: g.zeros() };
    match body.kind {
        JointKind::Spherical | JointKind::Floating => {
            let positions = body.inputs.clone().map(|i| g.input(i)).collect::<Vec<_>>();
            let free = body.kind == JointKind::Floating;
            let mut origin = g.vector(&constant.translation);
            let fixed = g.matrix(&constant.rotation);
            if free {
                let moved = g.rotate(&fixed, [positions[0], positions[1], positions[2]]);
                origin = g.add3(origin, moved);
            }
            for (axis, distance) in origin.into_iter().enumerate() {
                steps.shift(g, axis, distance);
            }
            let quaternion = &positions[positions.len() - 4..];
            let turned = rotation_of_quaternion(g, quaternion);
            let mut rotation = turned;
            for i in 0..3 {
                for j in 0..3 {
                    rotation[i][j] = g.dot(fixed[i], Graph::column(&turned, j));
                }
            }
            steps.0.push(Step::Rotation(rotation));
            columns = (0..body.kind.dofs()).map(|k| free_column(g, k)).collect();
        }
        JointKind::Fixed => {}
        JointKind::Revolute | JointKind::Continuous | JointKind::Prismatic | JointKind::Planar => {
            let part = decompose(&constant, scale);
            for (axis, distance) in part.shift.into_iter().enumerate() {
                let distance = g.constant(distance);
                steps.shift(g, axis, distance);
            }
            steps.constant_turn(g, 2, part.turn);
            let normal = g.constant(part.normal);
            steps.shift(g, 0, normal);
            steps.constant_turn(g, 0, part.twist);
            let total = part.last + chosen.turn;
            match body.kind {
                JointKind::Prismatic => {
                    let (q, along) = (single_position(g, body), g.constant(part.along + chosen.along));
                    let along = g.add(q, along);
                    steps.shift(g, 2, along);
                    steps.constant_turn(g, 2, total);
                    columns.push(TwistExpr { angular: g.zeros(), linear: g.unit(2) });
                }
                JointKind::Planar => {
                    let [x, y, q] = [0, 1, 2].map(|k| g.input(body.inputs.start + k));
                    let before = g.constant(part.along);
                    steps.shift(g, 2, before);
                    steps.constant_turn(g, 2, part.last);
                    steps.shift(g, 0, x);
                    steps.shift(g, 1, y);
                    let (cosine, sine) = cosine_sine(g, q, chosen.turn);
                    steps.0.push(Step::Turn { axis: 2, cosine, sine });
                    let after = g.constant(chosen.along);
                    steps.shift(g, 2, after);
                    let zero = g.zero();
                    let back = g.neg(sine);
                    columns.push(TwistExpr { angular: g.zeros(), linear: [cosine, back, zero] });
                    columns.push(TwistExpr { angular: g.zeros(), linear: [sine, cosine, zero] });
                    columns.push(turn_column(g));
                }
                _ => {
                    let along = g.constant(part.along + chosen.along);
                    steps.shift(g, 2, along);
                    let q = single_position(g, body);
                    let (cosine, sine) = cosine_sine(g, q, total);
                    steps.0.push(Step::Turn { axis: 2, cosine, sine });
                    columns.push(turn_column(g));
                }
            }
        }
    }
    columns.truncate(body.dofs());
    (steps.0, columns)
}

/// Unit twist number `k`: rotations first.
fn free_column(g: &mut Graph, k: usize) -> TwistExpr {
    let (unit, zero) = (g.unit(k % 3), g.zeros());
    if k < 3 { TwistExpr { angular: unit, linear: zero } } else { TwistExpr { angular: zero, linear: unit } }
}

/// Rotation of a quaternion w, x, y, z of any length: the length is divided out.
pub(crate) fn rotation_of_quaternion(g: &mut Graph, q: &[Expr]) -> Matrix {
    let &[w, x, y, z] = q else { return identity(g) };
    let squares = [w, x, y, z].map(|a| g.square(a));
    let square = g.sum(squares);
    let two = g.constant(2.0);
    let scale = g.div(two, square);
    let [sx, sy, sz] = [x, y, z].map(|a| g.mul(scale, a));
    let (xx, yy, zz) = (g.mul(sx, x), g.mul(sy, y), g.mul(sz, z));
    let (xy, xz, yz) = (g.mul(sx, y), g.mul(sx, z), g.mul(sy, z));
    let (wx, wy, wz) = (g.mul(sx, w), g.mul(sy, w), g.mul(sz, w));
    let one = g.one();
    let diagonal = [(yy, zz), (xx, zz), (xx, yy)].map(|(a, b)| {
        let sum = g.add(a, b);
        g.sub(one, sum)
    });
    [
        [diagonal[0], g.sub(xy, wz), g.add(xz, wy)],
        [g.add(xy, wz), diagonal[1], g.sub(yz, wx)],
        [g.sub(xz, wy), g.add(yz, wx), diagonal[2]],
    ]
}
