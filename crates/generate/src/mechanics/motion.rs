//! Elementary motions. The transform of a joint is a sequence of rotations and shifts along coordinate axes, so that
//! constant zeros of the frames remove operations.

use crate::expression::graph::{Expr, Graph};
use crate::expression::vector::{Matrix, Vector};

/// Elementary motion from the child's frame to the parent's frame.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Step {
    /// Rotation about coordinate axis `axis`.
    Turn { axis: usize, cosine: Expr, sine: Expr },
    /// Displacement along coordinate axis `axis`, m.
    Shift { axis: usize, distance: Expr },
    /// Rotation by a matrix R_pc.
    Rotation(Matrix),
}

/// Moment (at the frame's origin) and force.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WrenchExpr {
    pub moment: Vector,
    pub force: Vector,
}

/// Angular velocity, and linear velocity at the frame's origin.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TwistExpr {
    pub angular: Vector,
    pub linear: Vector,
}

/// Inertia of a rigid body about the origin of its frame: mass, first moment, rotational inertia.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InertiaExpr {
    pub mass: Expr,
    pub first_moment: Vector,
    pub rotational: Matrix,
}

/// Frame: rotation R and origin p.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FrameExpr {
    pub rotation: Matrix,
    pub origin: Vector,
}

impl Step {
    /// Components in the parent of a vector in the child.
    pub fn vector_to_parent(&self, g: &mut Graph, v: Vector) -> Vector {
        match *self {
            Step::Turn { axis, cosine, sine } => turn(g, axis, cosine, sine, v),
            Step::Shift { .. } => v,
            Step::Rotation(r) => g.rotate(&r, v),
        }
    }

    /// Components in the child of a vector in the parent.
    pub fn vector_to_child(&self, g: &mut Graph, v: Vector) -> Vector {
        match *self {
            Step::Turn { axis, cosine, sine } => {
                let back = g.neg(sine);
                turn(g, axis, cosine, back, v)
            }
            Step::Shift { .. } => v,
            Step::Rotation(r) => g.rotate_back(&r, v),
        }
    }

    /// Coordinates in the parent of a point of the child.
    pub fn point_to_parent(&self, g: &mut Graph, mut p: Vector) -> Vector {
        if let Step::Shift { axis, distance } = *self {
            p[axis] = g.add(p[axis], distance);
            return p;
        }
        self.vector_to_parent(g, p)
    }

    /// Coordinates in the child of a point of the parent.
    pub fn point_to_child(&self, g: &mut Graph, mut p: Vector) -> Vector {
        if let Step::Shift { axis, distance } = *self {
            p[axis] = g.sub(p[axis], distance);
            return p;
        }
        self.vector_to_child(g, p)
    }

    /// Wrench in the parent: n + p × f, f.
    pub fn wrench_to_parent(&self, g: &mut Graph, w: &WrenchExpr) -> WrenchExpr {
        match *self {
            Step::Shift { axis, distance } => {
                WrenchExpr { moment: shifted(g, axis, distance, w.moment, w.force), force: w.force }
            }
            _ => WrenchExpr {
                moment: self.vector_to_parent(g, w.moment),
                force: self.vector_to_parent(g, w.force),
            },
        }
    }

    /// Wrench in the child.
    pub fn wrench_to_child(&self, g: &mut Graph, w: &WrenchExpr) -> WrenchExpr {
        match *self {
            Step::Shift { axis, distance } => {
                let back = g.neg(distance);
                WrenchExpr { moment: shifted(g, axis, back, w.moment, w.force), force: w.force }
            }
            _ => WrenchExpr {
                moment: self.vector_to_child(g, w.moment),
                force: self.vector_to_child(g, w.force),
            },
        }
    }

    /// Inertia in the parent.
    pub fn inertia_to_parent(&self, g: &mut Graph, inertia: &InertiaExpr) -> InertiaExpr {
        let InertiaExpr { mass, first_moment, rotational } = *inertia;
        match *self {
            Step::Turn { axis, cosine, sine } => InertiaExpr {
                mass,
                first_moment: turn(g, axis, cosine, sine, first_moment),
                rotational: turn_tensor(g, axis, cosine, sine, &rotational),
            },
            Step::Shift { axis, distance } => shift_inertia(g, axis, distance, inertia),
            Step::Rotation(r) => {
                // R J Rᵀ, upper triangle.
                let columns = [0, 1, 2].map(|j| g.rotate(&r, Graph::column(&rotational, j)));
                let entry = |g: &mut Graph, i: usize, j: usize| {
                    g.dot([columns[0][i], columns[1][i], columns[2][i]], r[j])
                };
                let mut turned = rotational;
                for i in 0..3 {
                    for j in i..3 {
                        turned[i][j] = entry(g, i, j);
                        turned[j][i] = turned[i][j];
                    }
                }
                InertiaExpr { mass, first_moment: g.rotate(&r, first_moment), rotational: turned }
            }
        }
    }

    /// Frame in the parent of this frame's child: R ← R R_step, p ← p + R d.
    pub fn extend_frame(&self, g: &mut Graph, frame: &FrameExpr) -> FrameExpr {
        let r = &frame.rotation;
        match *self {
            Step::Shift { axis, distance } => {
                let along = g.scale3(distance, Graph::column(r, axis));
                FrameExpr { rotation: *r, origin: g.add3(frame.origin, along) }
            }
            Step::Turn { axis, cosine, sine } => {
                let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
                let mut rotation = *r;
                for (row, old) in rotation.iter_mut().zip(r) {
                    // Columns: e_i ← c e_i + s e_j, e_j ← c e_j − s e_i.
                    let (ci, sj) = (g.mul(cosine, old[i]), g.mul(sine, old[j]));
                    let (cj, si) = (g.mul(cosine, old[j]), g.mul(sine, old[i]));
                    (row[i], row[j]) = (g.add(ci, sj), g.sub(cj, si));
                }
                FrameExpr { rotation, origin: frame.origin }
            }
            Step::Rotation(step) => {
                let mut rotation = *r;
                for (row, old) in rotation.iter_mut().zip(r) {
                    *row = g.rotate_back(&step, *old);
                }
                FrameExpr { rotation, origin: frame.origin }
            }
        }
    }
}

/// Rotation of a vector about a coordinate axis.
fn turn(g: &mut Graph, k: usize, c: Expr, s: Expr, v: Vector) -> Vector {
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    let (ci, sj) = (g.mul(c, v[i]), g.mul(s, v[j]));
    let (si, cj) = (g.mul(s, v[i]), g.mul(c, v[j]));
    let mut turned = v;
    (turned[i], turned[j]) = (g.sub(ci, sj), g.add(si, cj));
    turned
}

/// n + d e_k × f.
fn shifted(g: &mut Graph, k: usize, d: Expr, mut n: Vector, f: Vector) -> Vector {
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    let (di, dj) = (g.mul(d, f[i]), g.mul(d, f[j]));
    (n[i], n[j]) = (g.sub(n[i], dj), g.add(n[j], di));
    n
}

/// R J Rᵀ for a rotation about a coordinate axis: with δ = J_ii − J_jj and ε = 2 J_ij,
/// J_ii − u, J_jj + u, J_ij + w, where u = s (s δ + c ε) and w = s (c δ − s ε).
fn turn_tensor(g: &mut Graph, k: usize, c: Expr, s: Expr, tensor: &Matrix) -> Matrix {
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    let mut turned = *tensor;
    let row = turn(g, k, c, s, tensor[k]);
    for axis in [i, j] {
        (turned[k][axis], turned[axis][k]) = (row[axis], row[axis]);
    }
    if g.is_zero(c) {
        // A quarter turn exchanges the axes.
        (turned[i][i], turned[j][j]) = (tensor[j][j], tensor[i][i]);
        turned[i][j] = g.neg(tensor[i][j]);
        turned[j][i] = turned[i][j];
        return turned;
    }
    let difference = g.sub(tensor[i][i], tensor[j][j]);
    let double = g.scale(tensor[i][j], 2.0);
    let (sd, ce) = (g.mul(s, difference), g.mul(c, double));
    let (cd, se) = (g.mul(c, difference), g.mul(s, double));
    let (u, w) = (g.add(sd, ce), g.sub(cd, se));
    let (u, w) = (g.mul(s, u), g.mul(s, w));
    turned[i][i] = g.sub(tensor[i][i], u);
    turned[j][j] = g.add(tensor[j][j], u);
    turned[i][j] = g.add(tensor[i][j], w);
    turned[j][i] = turned[i][j];
    turned
}

/// Inertia about an origin displaced by −d e_k (parallel-axis theorem).
fn shift_inertia(g: &mut Graph, k: usize, d: Expr, inertia: &InertiaExpr) -> InertiaExpr {
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    let h = inertia.first_moment;
    let mut shifted = *inertia;
    let added = g.mul(d, inertia.mass);
    shifted.first_moment[k] = g.add(h[k], added);
    let spread = g.add(h[k], shifted.first_moment[k]);
    let spread = g.mul(d, spread);
    for axis in [i, j] {
        let (diagonal, product) = (inertia.rotational[axis][axis], g.mul(d, h[axis]));
        shifted.rotational[axis][axis] = g.add(diagonal, spread);
        shifted.rotational[k][axis] = g.sub(inertia.rotational[k][axis], product);
        shifted.rotational[axis][k] = shifted.rotational[k][axis];
    }
    shifted
}

impl InertiaExpr {
    /// Sum of two inertias about the same origin.
    pub fn plus(&self, g: &mut Graph, other: &Self) -> Self {
        let mut sum = Self {
            mass: g.add(self.mass, other.mass),
            first_moment: g.add3(self.first_moment, other.first_moment),
            rotational: self.rotational,
        };
        for i in 0..3 {
            for j in i..3 {
                sum.rotational[i][j] = g.add(self.rotational[i][j], other.rotational[i][j]);
                sum.rotational[j][i] = sum.rotational[i][j];
            }
        }
        sum
    }

    /// Momentum at a twist: (J ω + h × v, m v − h × ω).
    pub fn momentum(&self, g: &mut Graph, twist: &TwistExpr) -> WrenchExpr {
        let rotation = g.rotate(&self.rotational, twist.angular);
        let coupling = g.cross(self.first_moment, twist.linear);
        let translation = g.scale3(self.mass, twist.linear);
        let back = g.cross(self.first_moment, twist.angular);
        WrenchExpr { moment: g.add3(rotation, coupling), force: g.sub3(translation, back) }
    }
}

impl WrenchExpr {
    /// Power on a twist.
    pub fn power(&self, g: &mut Graph, twist: &TwistExpr) -> Expr {
        let (rotation, translation) = (g.dot(self.moment, twist.angular), g.dot(self.force, twist.linear));
        g.add(rotation, translation)
    }
}
