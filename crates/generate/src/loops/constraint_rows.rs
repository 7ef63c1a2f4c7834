//! Constraint rows over the coordinates, and residuals of the closures; all in metres. Angles are multiplied by the
//! characteristic length.

use crate::expression::graph::{Expr, Graph};
use crate::expression::vector::Vector;
use crate::mechanics::body_frames::Bodies;
use crate::mechanics::motion::{FrameExpr, WrenchExpr};
use crate::request::Request;
use nalgebra::Vector3;
use percuss_mechanism::{Closure, ClosureKind, Curve, LoopFrame};
use percuss_spatial::{Transform, plane_basis};

/// Constraint row.
#[derive(Clone, Debug)]
pub(crate) struct ConstraintRow {
    /// Entry of every coordinate.
    pub entries: Vec<Expr>,
    /// Residual of the position; 0 for couplings of rates and held contacts.
    pub residual: Expr,
}

/// All constraints.
#[derive(Clone, Debug, Default)]
pub(crate) struct Constraints {
    pub rows: Vec<ConstraintRow>,
    /// Expressions that vanish in addition to the residuals: they exclude opposite directions of axes.
    pub directions: Vec<Expr>,
}

/// Moment about the successor's loop origin and force, whose power on the relative twist is the rate of a residual.
struct RowWrench {
    moment: Vector,
    force: Vector,
    residual: Expr,
}

/// Rows of all closures, couplings and held contacts.
pub(crate) fn constraints(g: &mut Graph, bodies: &Bodies, request: &Request) -> Constraints {
    let mechanism = request.system.mechanism();
    let reversed: Vec<&str> = request.system.reversed_axes().collect();
    let mut found = Constraints::default();
    for closure in mechanism.closures() {
        let distance = closure.distance().unwrap_or_else(|| drawn_distance(request, bodies, closure));
        add_closure(
            g,
            bodies,
            request.scale(),
            closure,
            reversed.contains(&closure.name()),
            distance,
            &mut found,
        );
    }
    for coupling in mechanism.couplings() {
        let zero = g.zero();
        let mut row = ConstraintRow { entries: vec![zero; bodies.tree.coordinates], residual: zero };
        let mut turns = false;
        for &(id, factor) in coupling.terms() {
            let Some(body) = bodies.tree.body_of_joint[id.index()] else { continue };
            turns |= bodies.tree.bodies[body].kind != percuss_mechanism::JointKind::Prismatic;
            let factor = g.constant(factor);
            add_position(g, bodies, body, factor, &mut row);
        }
        let constant = g.constant(-coupling.constant());
        row.residual = g.add(row.residual, constant);
        if let Some(curve) = coupling.curve() {
            add_curve(g, bodies, curve, &mut row);
        }
        let length = if turns { request.scale() } else { 1.0 };
        row.residual = g.scale(row.residual, length);
        row.entries = row.entries.iter().map(|e| g.scale(*e, length)).collect();
        found.rows.push(row);
    }
    for hold in &request.holds {
        let (body, frame) = bodies.tree.links[hold.link.index()];
        let point = bodies.frame_on(body, &frame).point(&hold.point);
        let directions = hold.normal.map_or_else(
            || vec![Vector3::x(), Vector3::y(), Vector3::z()],
            |normal| vec![normal.normalize()],
        );
        for direction in directions {
            let (point, normal) = (g.vector(&point), g.vector(&direction));
            // Directions are given in the axes of the root link.
            let (root, root_frame) = bodies.tree.links[mechanism.root().index()];
            let axes = bodies.frame_on(root, &root_frame);
            let normal = if root.is_some() {
                let turned = axes.rotation;
                let turned = g.matrix(&turned);
                g.rotate(&turned, normal)
            } else {
                normal
            };
            let normal = bodies.vector_between(g, root, body, normal);
            let wrench = WrenchExpr { moment: g.cross(point, normal), force: normal };
            let tree_row = bodies.wrench_row(g, body, None, wrench);
            let residual = g.zero();
            found.rows.push(ConstraintRow { entries: over_coordinates(g, bodies, &tree_row), residual });
        }
    }
    found
}

/// Adds `factor` times the position of a body's joint to the residual, and the factor to the entries.
fn add_position(g: &mut Graph, bodies: &Bodies, body: usize, factor: Expr, row: &mut ConstraintRow) {
    let position = joint_position(g, bodies, body);
    let term = g.mul(position, factor);
    row.residual = g.add(row.residual, term);
    for v in bodies.tree.bodies[body].velocities.clone() {
        let velocity = bodies.tree.velocities[v];
        let entry = g.scale(factor, velocity.multiplier);
        row.entries[velocity.coordinate] = g.add(row.entries[velocity.coordinate], entry);
    }
}

/// Position of a body's joint: an input, or that of the master of a mimic.
fn joint_position(g: &mut Graph, bodies: &Bodies, body: usize) -> Expr {
    let body = &bodies.tree.bodies[body];
    match body.mimic {
        None => g.input(body.inputs.start),
        Some((master, multiplier, offset)) => {
            let (master, offset) = (g.input(master), g.constant(offset));
            let scaled = g.scale(master, multiplier);
            g.add(scaled, offset)
        }
    }
}

/// Subtracts a₂ s² + a₃ s³ + a₄ s⁴ from the residual, and its derivatives from the entries.
fn add_curve(g: &mut Graph, bodies: &Bodies, curve: &Curve, row: &mut ConstraintRow) {
    let mut argument = g.constant(curve.offset());
    let bound: Vec<(usize, f64)> = curve
        .terms()
        .iter()
        .filter_map(|(id, factor)| Some((bodies.tree.body_of_joint[id.index()]?, *factor)))
        .collect();
    for (body, factor) in &bound {
        let position = joint_position(g, bodies, *body);
        let term = g.scale(position, *factor);
        argument = g.add(argument, term);
    }
    let [a2, a3, a4] = curve.coefficients().map(|a| g.constant(-a));
    // Horner's scheme: value s² (a₂ + s (a₃ + s a₄)), slope s (2 a₂ + s (3 a₃ + s 4 a₄)).
    let horner = |g: &mut Graph, [c2, c3, c4]: [Expr; 3]| {
        let inner = g.mul(argument, c4);
        let inner = g.add(c3, inner);
        let inner = g.mul(argument, inner);
        let inner = g.add(c2, inner);
        g.mul(argument, inner)
    };
    let value = horner(g, [a2, a3, a4]);
    let value = g.mul(argument, value);
    row.residual = g.add(row.residual, value);
    let derived = [g.scale(a2, 2.0), g.scale(a3, 3.0), g.scale(a4, 4.0)];
    let slope = horner(g, derived);
    for (body, factor) in bound {
        for v in bodies.tree.bodies[body].velocities.clone() {
            let velocity = bodies.tree.velocities[v];
            let entry = g.scale(slope, factor * velocity.multiplier);
            row.entries[velocity.coordinate] = g.add(row.entries[velocity.coordinate], entry);
        }
    }
}

/// Distance of the ends of a closure with all joints at 0, m.
fn drawn_distance(request: &Request, bodies: &Bodies, closure: &Closure) -> f64 {
    let end = |end: &LoopFrame| {
        let link = end.link.map_or_else(Transform::identity, |link| bodies.tree.drawn_frame(request, link));
        (link * end.frame).translation
    };
    (end(closure.successor()) - end(closure.predecessor())).norm()
}

/// Sums a row over the tree velocities into a row over the coordinates.
pub(crate) fn over_coordinates(g: &mut Graph, bodies: &Bodies, row: &[Expr]) -> Vec<Expr> {
    let zero = g.zero();
    let mut entries = vec![zero; bodies.tree.coordinates];
    for (value, velocity) in row.iter().zip(&bodies.tree.velocities) {
        let term = g.scale(*value, velocity.multiplier);
        entries[velocity.coordinate] = g.add(entries[velocity.coordinate], term);
    }
    entries
}

/// Body of a loop frame, and the frame in the body's chosen frame.
fn loop_end(bodies: &Bodies, end: &LoopFrame) -> (Option<usize>, Transform<f64>) {
    let ground = (None, Transform::identity());
    let (body, frame) = end.link.map_or(ground, |link| bodies.tree.links[link.index()]);
    (body, bodies.frame_on(body, &(frame * end.frame)))
}

/// Frame of a loop's end in the common ancestor of both ends.
fn loop_frame(
    g: &mut Graph,
    bodies: &Bodies,
    ancestor: Option<usize>,
    end: &(Option<usize>, Transform<f64>),
) -> FrameExpr {
    let body = bodies.frame_in(g, ancestor, end.0);
    let (r, p) = (g.matrix(&end.1.rotation), g.vector(&end.1.translation));
    let mut rotation = body.rotation;
    for (row, of_body) in rotation.iter_mut().zip(&body.rotation) {
        *row = g.rotate_back(&r, *of_body);
    }
    let moved = g.rotate(&body.rotation, p);
    FrameExpr { rotation, origin: g.add3(body.origin, moved) }
}

fn add_closure(
    g: &mut Graph,
    bodies: &Bodies,
    length: f64,
    closure: &Closure,
    is_reversed: bool,
    distance: f64,
    found: &mut Constraints,
) {
    let [predecessor, successor] =
        [closure.predecessor(), closure.successor()].map(|end| loop_end(bodies, end));
    let ancestor = bodies.tree.common_ancestor(predecessor.0, successor.0);
    let [x_p, x_s] = [&predecessor, &successor].map(|end| loop_frame(g, bodies, ancestor, end));
    let (wrenches, directions) = closure_rows(g, closure, &x_p, &x_s, is_reversed, distance, length);
    found.directions.extend(directions);
    let zero = g.zero();
    let mut rows: Vec<ConstraintRow> = wrenches
        .iter()
        .map(|w| ConstraintRow { entries: vec![zero; bodies.tree.coordinates], residual: w.residual })
        .collect();
    for (end, sign) in [(successor.0, 1.0), (predecessor.0, -1.0)] {
        for b in bodies.path(ancestor, end) {
            let frame = bodies.frame_in(g, ancestor, Some(b));
            let arm = g.sub3(x_s.origin, frame.origin);
            for (k, v) in bodies.tree.bodies[b].velocities.clone().enumerate() {
                let column = bodies.bodies[b].columns[k];
                let angular = g.rotate(&frame.rotation, column.angular);
                let linear = g.rotate(&frame.rotation, column.linear);
                let velocity = bodies.tree.velocities[v];
                for (wrench, row) in wrenches.iter().zip(&mut rows) {
                    // a·(m + r × f) + l·f.
                    let turned = g.cross(arm, wrench.force);
                    let moment = g.add3(wrench.moment, turned);
                    let (rotation, translation) = (g.dot(angular, moment), g.dot(linear, wrench.force));
                    let power = g.add(rotation, translation);
                    let power = g.scale(power, sign * velocity.multiplier);
                    row.entries[velocity.coordinate] = g.add(row.entries[velocity.coordinate], power);
                }
            }
        }
    }
    found.rows.extend(rows);
}

/// Wrenches and residuals of a closure, and expressions that exclude opposite axes.
fn closure_rows(
    g: &mut Graph,
    closure: &Closure,
    x_p: &FrameExpr,
    x_s: &FrameExpr,
    is_reversed: bool,
    distance: f64,
    length: f64,
) -> (Vec<RowWrench>, Vec<Expr>) {
    let apart = g.sub3(x_s.origin, x_p.origin);
    let zero = g.zeros();
    let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
    let (n1, n2) = plane_basis(closure.axis());
    let own = if is_reversed { -*closure.axis() } else { *closure.axis() };
    let predecessor = |g: &mut Graph, e: &Vector3<f64>| {
        let e = g.vector(e);
        g.rotate(&x_p.rotation, e)
    };
    let along = |g: &mut Graph, e: &Vector3<f64>| {
        let force = predecessor(g, e);
        RowWrench { moment: zero, force, residual: g.dot(force, apart) }
    };
    let cosine = |g: &mut Graph, e: &Vector3<f64>, b: &Vector3<f64>| {
        let e = predecessor(g, e);
        let b = g.vector(b);
        let b = g.rotate(&x_s.rotation, b);
        let moment = g.cross(b, e);
        let moment = moment.map(|m| g.scale(m, length));
        let dot = g.dot(e, b);
        RowWrench { moment, force: zero, residual: g.scale(dot, length) }
    };
    // Half the skew part of R_pᵀ R_s: the axis times the sine of the angle.
    let columns = |x: &FrameExpr| [0, 1, 2].map(|j| Graph::column(&x.rotation, j));
    let (of_p, of_s) = (columns(x_p), columns(x_s));
    let turn = |g: &mut Graph, k: usize| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let (plus, minus) = (g.dot(of_p[j], of_s[i]), g.dot(of_p[i], of_s[j]));
        let skew = g.sub(plus, minus);
        RowWrench {
            moment: of_p[k].map(|m| g.scale(m, length)),
            force: zero,
            residual: g.scale(skew, 0.5 * length),
        }
    };
    // 1 − cos of the angle between two directions that have to agree.
    let aligned = |g: &mut Graph, a: Vector, b: Vector| {
        let (one, dot) = (g.one(), g.dot(a, b));
        let difference = g.sub(one, dot);
        g.scale(difference, length)
    };
    let mut directions = Vec::new();
    let rows = match closure.kind() {
        ClosureKind::Fixed | ClosureKind::Prismatic => {
            let shifts: Vec<Vector3<f64>> =
                if closure.kind() == ClosureKind::Fixed { axes.to_vec() } else { vec![n1, n2] };
            let mut rows: Vec<RowWrench> = shifts.iter().map(|e| along(g, e)).collect();
            rows.extend([0, 1, 2].map(|k| turn(g, k)));
            directions.push(aligned(g, of_p[0], of_s[0]));
            directions.push(aligned(g, of_p[1], of_s[1]));
            rows
        }
        ClosureKind::Revolute | ClosureKind::Cylindrical | ClosureKind::Planar => {
            let shifts: Vec<Vector3<f64>> = match closure.kind() {
                ClosureKind::Revolute => axes.to_vec(),
                ClosureKind::Cylindrical => vec![n1, n2],
                _ => vec![*closure.axis()],
            };
            let mut rows: Vec<RowWrench> = shifts.iter().map(|e| along(g, e)).collect();
            rows.extend([cosine(g, &n1, &own), cosine(g, &n2, &own)]);
            let axis = predecessor(g, closure.axis());
            let own = g.vector(&own);
            let own = g.rotate(&x_s.rotation, own);
            directions.push(aligned(g, axis, own));
            rows
        }
        ClosureKind::Universal => {
            let mut rows: Vec<RowWrench> = axes.iter().map(|e| along(g, e)).collect();
            rows.push(cosine(g, closure.axis(), closure.axis2()));
            rows
        }
        ClosureKind::Spherical => axes.iter().map(|e| along(g, e)).collect(),
        ClosureKind::Distance => {
            // (|p|² − l²)/(2 l): the length without a square root, exact to first order.
            let square = g.dot(apart, apart);
            let target = g.constant(distance * distance);
            let difference = g.sub(square, target);
            let residual = g.scale(difference, 0.5 / distance);
            let force = apart.map(|x| g.scale(x, 1.0 / distance));
            vec![RowWrench { moment: zero, force, residual }]
        }
    };
    (rows, directions)
}
