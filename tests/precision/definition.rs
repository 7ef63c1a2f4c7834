//! The effective mass by its definition in 96 digits: m̄ = min { vᵀMv : Av = 0, jv = 1 }, with M, A and j from the
//! bodies' velocities. No code is shared with the crate under test.

use super::linear_algebra::{MassMatrix, eliminate, over_basis, projected, solve};
use super::wide::Wide;
use nalgebra::{Matrix3, Vector3};
use percuss_mechanism::{
    ClosureDescription, ClosureKind, Inertial, JointDescription, JointKind, LinkDescription, Mechanism,
    MechanismBuilder,
};
use percuss_spatial::{Transform, rotation_from_rpy};

type Vector = [Wide; 3];
type Matrix = [Vector; 3];

/// Link: mass (kg), centre of mass (m), inertia about the centre of mass (xx, xy, xz, yy, yz, zz; kg·m²).
#[derive(Clone, Copy, Debug, Default)]
pub struct Link {
    pub mass: f64,
    pub com: [f64; 3],
    pub moments: [f64; 6],
}

/// The joint of a link other than the root.
#[derive(Clone, Copy, Debug)]
pub struct Joint {
    pub kind: JointKind,
    /// Number of the parent link; 0 is the root.
    pub parent: usize,
    pub xyz: [f64; 3],
    pub rpy: [f64; 3],
    pub axis: [f64; 3],
}

/// Closure between two points: a ball, or a rod of a given length (m).
#[derive(Clone, Copy, Debug)]
pub struct Closure {
    /// Numbers of two links, each with a point.
    pub ends: [(usize, [f64; 3]); 2],
    pub rod: Option<f64>,
}

/// Mechanism with exact numbers; joint i is the parent joint of link i + 1.
#[derive(Clone, Debug, Default)]
pub struct Exact {
    pub links: Vec<Link>,
    pub joints: Vec<Joint>,
    pub closures: Vec<Closure>,
    pub floating: bool,
}

/// A contact with the ground: point and normal in the link's frame.
#[derive(Clone, Copy, Debug)]
pub struct Touch {
    pub link: usize,
    pub point: [f64; 3],
    pub normal: [f64; 3],
}

#[derive(Clone, Copy, Debug)]
pub enum Outcome {
    Finite(Wide),
    Massless,
    Immovable,
}

fn wide(v: &[f64; 3]) -> Vector {
    v.map(Wide::new)
}

fn dot(a: &Vector, b: &Vector) -> Wide {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn plus(a: &Vector, b: &Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn minus(a: &Vector, b: &Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn times(a: &Vector, x: Wide) -> Vector {
    a.map(|part| part * x)
}

fn apply(m: &Matrix, v: &Vector) -> Vector {
    [dot(&m[0], v), dot(&m[1], v), dot(&m[2], v)]
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let column = |k: usize| [b[0][k], b[1][k], b[2][k]];
    let columns = [column(0), column(1), column(2)];
    a.map(|row| [dot(&row, &columns[0]), dot(&row, &columns[1]), dot(&row, &columns[2])])
}

fn unit(v: &Vector) -> Vector {
    times(v, Wide::new(1.0) / dot(v, v).sqrt())
}

/// Rotation about coordinate axis `axis`.
fn turn(axis: usize, angle: f64) -> Matrix {
    let ((s, c), (x, y)) = (Wide::sin_cos(angle), ((axis + 1) % 3, (axis + 2) % 3));
    let mut matrix = [[Wide::ZERO; 3]; 3];
    (matrix[axis][axis], matrix[x][x], matrix[y][y]) = (Wide::new(1.0), c, c);
    (matrix[x][y], matrix[y][x]) = (-s, s);
    matrix
}

fn of_rpy([roll, pitch, yaw]: [f64; 3]) -> Matrix {
    product(&turn(2, yaw), &product(&turn(1, pitch), &turn(0, roll)))
}

/// Rotation about a unit axis: R = 1 + sin [e] + (1 − cos) [e]².
fn about(e: &Vector, angle: f64) -> Matrix {
    let (s, c) = Wide::sin_cos(angle);
    let one = Wide::new(1.0);
    let mut matrix = [[Wide::ZERO; 3]; 3];
    for i in 0..3 {
        for k in 0..3 {
            matrix[i][k] += e[i] * e[k] * (one - c);
        }
        matrix[i][i] += c;
        let (x, y) = ((i + 1) % 3, (i + 2) % 3);
        matrix[x][y] -= s * e[i];
        matrix[y][x] += s * e[i];
    }
    matrix
}

fn of_quaternion(q: &[f64]) -> Matrix {
    let q: Vec<Wide> = q.iter().map(|x| Wide::new(*x)).collect();
    let over = Wide::new(1.0) / q.iter().fold(Wide::ZERO, |sum, x| sum + *x * *x);
    let v = [q[1], q[2], q[3]];
    let mut matrix = [[Wide::ZERO; 3]; 3];
    for i in 0..3 {
        for k in 0..3 {
            matrix[i][k] += (v[i] * v[k]).shifted(1) * over;
        }
        matrix[i][i] += (q[0] * q[0] - dot(&v, &v)) * over;
        let (x, y) = ((i + 1) % 3, (i + 2) % 3);
        matrix[x][y] -= (q[0] * v[i]).shifted(1) * over;
        matrix[y][x] += (q[0] * v[i]).shifted(1) * over;
    }
    matrix
}

/// One velocity: the root link of its moving subtree, and the twist at the world's origin.
struct Velocity {
    link: usize,
    angular: Vector,
    linear: Vector,
}

/// Mechanism at a pose, with the factorisation of M.
pub struct Posed {
    parents: Vec<Option<usize>>,
    frames: Vec<(Matrix, Vector)>,
    velocities: Vec<Velocity>,
    /// Basis of the admissible motions, velocities × freedoms; `None`: every motion is admissible.
    basis: Option<Vec<Vec<Wide>>>,
    mass: MassMatrix,
}

impl Exact {
    pub fn mechanism(&self) -> Mechanism {
        let name = |i: usize| format!("l{i}");
        let mut builder = MechanismBuilder::new("exact");
        for (i, link) in self.links.iter().enumerate() {
            let [a, b, c, d, e, f] = link.moments;
            let about_com = Matrix3::new(a, b, c, b, d, e, c, e, f);
            let inertial = Inertial { mass: link.mass, com: link.com.into(), about_com };
            let described = if link.mass > 0.0 {
                LinkDescription::new(name(i), inertial)
            } else {
                LinkDescription::massless(name(i))
            };
            builder = builder.link(described);
        }
        for (i, joint) in self.joints.iter().enumerate() {
            let mut described =
                JointDescription::new(format!("j{i}"), joint.kind, name(joint.parent), name(i + 1));
            described.origin = Transform::new(rotation_from_rpy(joint.rpy), Vector3::from(joint.xyz));
            described.axis = joint.axis.into();
            builder = builder.joint(described);
        }
        for (i, closure) in self.closures.iter().enumerate() {
            let kind = if closure.rod.is_some() { ClosureKind::Distance } else { ClosureKind::Spherical };
            let [(before, at), (after, there)] = closure.ends;
            let mut described = ClosureDescription::new(format!("c{i}"), kind, name(before), name(after));
            described.predecessor_frame.translation = at.into();
            described.successor_frame.translation = there.into();
            described.distance = closure.rod;
            builder = builder.closure(described);
        }
        builder.build().expect("a mechanism").mechanism
    }

    /// M at positions (all joints, concatenated). For loops, the dependent joints are corrected first and written back
    /// as the nearest doubles; `None` if the loops do not close.
    pub fn pose(&self, positions: &mut [f64]) -> Option<Posed> {
        let mut fine: Vec<Wide> = positions.iter().map(|q| Wide::new(*q)).collect();
        let mut posed = self.place(&fine);
        if !self.closures.is_empty() {
            let first = eliminate(self.rows(&posed).0)?;
            for step in 0..12 {
                let (rows, residuals) = self.rows(&posed);
                let off = residuals.iter().fold(0.0, |most: f64, r| most.max(r.abs().to_f64()));
                if off < 1e-60 {
                    break;
                }
                if step == 11 || off > 1.0 {
                    return None;
                }
                for (c, change) in first.columns.iter().zip(solve(&rows, &first.columns, &residuals)?) {
                    // Every joint has one position; the velocities of a base come first and are not corrected.
                    fine[c.checked_sub(if self.floating { 6 } else { 0 })?] -= change;
                }
                posed = self.place(&fine);
            }
            positions.iter_mut().zip(&fine).for_each(|(q, x)| *q = x.to_f64());
            posed.basis = Some(eliminate(self.rows(&posed).0)?.kernel(posed.velocities.len()));
        }
        posed.factorize(&self.links);
        Some(posed)
    }

    fn place(&self, q: &[Wide]) -> Posed {
        let (zero, one) = (Wide::ZERO, Wide::new(1.0));
        let axis = |k: usize| {
            let mut e = [zero; 3];
            e[k] = one;
            e
        };
        let identity = [axis(0), axis(1), axis(2)];
        let mut posed = Posed {
            parents: vec![None],
            frames: vec![(identity, [zero; 3])],
            velocities: Vec::new(),
            basis: None,
            mass: MassMatrix::default(),
        };
        if self.floating {
            for k in 0..3 {
                posed.velocities.push(Velocity { link: 0, angular: axis(k), linear: [zero; 3] });
                posed.velocities.push(Velocity { link: 0, angular: [zero; 3], linear: axis(k) });
            }
        }
        let mut next = 0;
        for (i, joint) in self.joints.iter().enumerate() {
            let (carrier, origin) = &posed.frames[joint.parent];
            let place = plus(origin, &apply(carrier, &wide(&joint.xyz)));
            let own = product(carrier, &of_rpy(joint.rpy));
            let e = unit(&wide(&joint.axis));
            let double = |k: usize| q[k].to_f64();
            // Angles are doubles, except for angles determined by loops.
            let angle = |k: usize| {
                let rest = (q[k] - Wide::new(double(k))).to_f64();
                let near = about(&e, double(k));
                if rest == 0.0 { near } else { product(&near, &about_small(&e, q[k] - Wide::new(double(k)))) }
            };
            let moved = |d: &Vector, r: &Matrix| (product(&own, r), plus(&place, &apply(&own, d)));
            let (x, y) = (axis(0), axis(1));
            let frame = match joint.kind {
                JointKind::Fixed => moved(&[zero; 3], &identity),
                JointKind::Revolute | JointKind::Continuous => moved(&[zero; 3], &angle(next)),
                JointKind::Prismatic => moved(&times(&e, q[next]), &identity),
                JointKind::Planar => {
                    moved(&plus(&times(&x, q[next]), &times(&y, q[next + 1])), &angle(next + 2))
                }
                JointKind::Spherical => {
                    moved(&[zero; 3], &of_quaternion(&[0, 1, 2, 3].map(|k| double(next + k))))
                }
                JointKind::Floating => moved(
                    &[q[next], q[next + 1], q[next + 2]],
                    &of_quaternion(&[3, 4, 5, 6].map(|k| double(next + k))),
                ),
            };
            let mut turns = |e: &Vector, about: &Matrix, at: &Vector| {
                let angular = apply(about, e);
                posed.velocities.push(Velocity { link: i + 1, linear: cross(at, &angular), angular });
            };
            match joint.kind {
                JointKind::Fixed | JointKind::Prismatic => {}
                JointKind::Revolute | JointKind::Continuous | JointKind::Planar => {
                    turns(&e, &frame.0, &frame.1)
                }
                JointKind::Spherical | JointKind::Floating => {
                    (0..3).for_each(|k| turns(&axis(k), &frame.0, &frame.1));
                }
            }
            let mut slides = |e: &Vector| {
                posed.velocities.push(Velocity { link: i + 1, angular: [zero; 3], linear: apply(&own, e) });
            };
            match joint.kind {
                JointKind::Prismatic => slides(&e),
                JointKind::Planar => [x, y].iter().for_each(slides),
                JointKind::Floating => (0..3).for_each(|k| slides(&axis(k))),
                _ => {}
            }
            next += joint.kind.positions();
            posed.frames.push(frame);
            posed.parents.push(Some(joint.parent));
        }
        posed
    }

    /// Rows of A, and the gap of each row (m).
    fn rows(&self, posed: &Posed) -> (Vec<Vec<Wide>>, Vec<Wide>) {
        let (mut rows, mut residuals) = (Vec::new(), Vec::new());
        for closure in &self.closures {
            let places = closure.ends.map(|(link, at)| posed.point(link, &at));
            let apart = minus(&places[1], &places[0]);
            let directions = match closure.rod {
                None => (0..3)
                    .map(|k| {
                        let mut e = [Wide::ZERO; 3];
                        e[k] = Wide::new(1.0);
                        e
                    })
                    .collect(),
                Some(_) => vec![unit(&apart)],
            };
            for e in &directions {
                let [before, after] = [0, 1].map(|k| posed.row(closure.ends[k].0, &places[k], e));
                rows.push(after.iter().zip(&before).map(|(a, b)| *a - *b).collect());
                residuals.push(dot(e, &apart) - Wide::new(closure.rod.unwrap_or(0.0)));
            }
        }
        (rows, residuals)
    }
}

/// Rotation by a small angle: a series of few terms.
fn about_small(e: &Vector, angle: Wide) -> Matrix {
    let mut matrix = [[Wide::ZERO; 3]; 3];
    let one = Wide::new(1.0);
    let square = angle * angle;
    // These angles are below one rounding of a double: the next terms are below 1e-78.
    let s = angle * (one - square / Wide::new(6.0));
    let versine = square.shifted(-1) * (one - square / Wide::new(12.0));
    for i in 0..3 {
        for k in 0..3 {
            matrix[i][k] += e[i] * e[k] * versine;
        }
        matrix[i][i] += one - versine;
        let (x, y) = ((i + 1) % 3, (i + 2) % 3);
        matrix[x][y] -= s * e[i];
        matrix[y][x] += s * e[i];
    }
    matrix
}

impl Posed {
    fn point(&self, link: usize, at: &[f64; 3]) -> Vector {
        let (rotation, place) = &self.frames[link];
        plus(place, &apply(rotation, &wide(at)))
    }

    /// True if a velocity moves a link.
    fn moves(&self, velocity: usize, link: usize) -> bool {
        let mut at = Some(link);
        while let Some(number) = at {
            if number == self.velocities[velocity].link {
                return true;
            }
            at = self.parents[number];
        }
        false
    }

    /// Speed along e of a link's point at unit rates.
    fn row(&self, link: usize, at: &Vector, e: &Vector) -> Vec<Wide> {
        let speed = |(k, v): (usize, &Velocity)| {
            if self.moves(k, link) { dot(e, &plus(&v.linear, &cross(&v.angular, at))) } else { Wide::ZERO }
        };
        self.velocities.iter().enumerate().map(speed).collect()
    }

    fn over_basis(&self, row: Vec<Wide>) -> Vec<Wide> {
        match &self.basis {
            Some(basis) => over_basis(&row, basis),
            None => row,
        }
    }

    fn factorize(&mut self, links: &[Link]) {
        let n = self.velocities.len();
        let mut mass = vec![vec![Wide::ZERO; n]; n];
        for (number, link) in links.iter().enumerate().filter(|(_, link)| link.mass > 0.0) {
            let (rotation, _) = self.frames[number];
            let [a, b, c, d, e, f] = link.moments.map(Wide::new);
            let own = [[a, b, c], [b, d, e], [c, e, f]];
            let place = self.point(number, &link.com);
            let moving: Vec<usize> = (0..n).filter(|k| self.moves(*k, number)).collect();
            let transpose = [0, 1, 2].map(|k| [rotation[0][k], rotation[1][k], rotation[2][k]]);
            let parts: Vec<(Vector, Vector, Vector, Vector)> = moving
                .iter()
                .map(|&k| {
                    let v = &self.velocities[k];
                    let speed = plus(&v.linear, &cross(&v.angular, &place));
                    let turning = apply(&transpose, &v.angular);
                    (speed, times(&speed, Wide::new(link.mass)), turning, apply(&own, &turning))
                })
                .collect();
            for (x, &r) in moving.iter().enumerate() {
                for (y, &c) in moving.iter().enumerate().take(x + 1) {
                    mass[r][c] += dot(&parts[x].0, &parts[y].1) + dot(&parts[x].2, &parts[y].3);
                }
            }
        }
        for r in 0..n {
            for c in 0..r {
                mass[c][r] = mass[r][c];
            }
        }
        if let Some(basis) = &self.basis {
            mass = projected(mass, basis);
        }
        self.mass = MassMatrix::of(mass);
    }

    /// The double nearest to a link's point, root axes.
    pub fn place(&self, link: usize, at: &[f64; 3]) -> [f64; 3] {
        self.point(link, at).map(Wide::to_f64)
    }

    pub fn effective_mass(&self, touch: &Touch) -> Outcome {
        let (rotation, _) = self.frames[touch.link];
        let normal = apply(&rotation, &unit(&wide(&touch.normal)));
        self.mass.effective_mass(self.over_basis(self.row(
            touch.link,
            &self.point(touch.link, &touch.point),
            &normal,
        )))
    }
}
