//! Loops in intervals: rows of the closures and couplings, proof of the assembly by the operator of Krawczyk.

use super::plan::{On, Placement, Plan, written, written_transform, written_vector};
use super::subgroup::Circuit;
use crate::model::{CompiledClosure, Constraint, Model};
use crate::tolerances::{
    DRAWN_READING, LEAST_BOX, LEAST_PROVED_PIVOT, LEAST_RADIUS, MOST_PROOF_BOXES, PROOF_NEWTON_STEPS,
    RADIUS_STEP, WIDEST_PROOF,
};
use nalgebra::{DMatrix, Vector3};
use percuss_mechanism::{ClosureKind, Mechanism};
use percuss_spatial::{Interval, Scalar, Transform, Wrench};

/// Component of the relative position of the two loop frames that is zero.
#[derive(Clone, Copy, Debug)]
enum Form {
    /// Coordinate of the successor's origin along a direction of the predecessor, m.
    Along(Vector3<Interval>),
    /// Cosine between a direction of the predecessor and a direction of the successor.
    Cosine(Vector3<Interval>, Vector3<Interval>),
    /// Distance of the origins minus the given one, m.
    Distance(Interval),
}

/// A closure of a loop.
#[derive(Clone, Debug)]
struct Closure {
    predecessor: On<Interval>,
    successor: On<Interval>,
    forms: Vec<Form>,
    /// Directions of the predecessor and of the successor with a positive cosine: other zeros of the forms are no assemblies.
    aligned: Aligned,
    /// Bodies of the loop with their sense.
    path: Vec<(usize, f64)>,
}

/// Σ factor · q = constant.
#[derive(Clone, Debug)]
struct Coupling {
    terms: Vec<(usize, usize, Interval)>,
    constant: Interval,
}

/// Constraints of a model.
#[derive(Clone, Debug)]
pub(super) struct Loops {
    closures: Vec<Closure>,
    couplings: Vec<Coupling>,
    /// Name of the constraint of each row.
    pub names: Vec<String>,
    /// Number of further rows, which are zero at all positions.
    pub implied: usize,
}

/// Rows at a pose.
pub(super) struct Rows {
    /// Residual of each row, m or rad.
    pub residuals: Vec<Interval>,
    /// A: rows × coordinates.
    pub matrix: Vec<Vec<Interval>>,
}

/// Proved assembly.
pub(super) struct Closed {
    /// Positions of all joints.
    pub q: Vec<Interval>,
    /// Independent rows, and the dependent coordinates.
    pub rows: Vec<usize>,
    pub dependent: Vec<usize>,
}

impl Loops {
    /// Constraints of a model; `None` if one of them has no proof: a held contact or a coupling along a curve.
    pub fn of(
        model: &Model,
        plan: &Plan<Interval>,
        links: &[On<Interval>],
        bodies: &[usize],
    ) -> Option<Self> {
        let mut loops = Self { closures: Vec::new(), couplings: Vec::new(), names: Vec::new(), implied: 0 };
        let mechanism = &model.mechanism;
        let floats = model.link_frames[mechanism.root().index()].body.is_some();
        for constraint in model.groups.iter().flat_map(|group| &group.constraints) {
            match constraint.constraint {
                Constraint::Hold(_) => return None,
                Constraint::Coupling(i) => {
                    let coupling = &model.couplings[i];
                    if coupling.curve.is_some() {
                        return None;
                    }
                    let terms =
                        coupling.terms.iter().map(|term| (term.q, bodies[term.body], written(term.factor)));
                    loops
                        .couplings
                        .push(Coupling { terms: terms.collect(), constant: written(coupling.constant) });
                    // Rows of couplings follow those of the closures.
                }
                Constraint::Closure(i) => {
                    let (own, compiled) = (&mechanism.closures()[i], &model.closures[i]);
                    let end = |end: &percuss_mechanism::LoopFrame| {
                        let ground = On { body: None, frame: Transform::identity() };
                        let link = end.link.map_or(ground, |link| links[link.index()]);
                        On { body: link.body, frame: link.frame * written_transform(&end.frame) }
                    };
                    let (predecessor, successor) = (end(own.predecessor()), end(own.successor()));
                    let (forms, aligned) = closure_forms(mechanism, own, compiled, floats);
                    loops.implied += compiled.kind.rows() - forms.len();
                    let path = plan.support(successor.body, predecessor.body);
                    loops.names.extend(forms.iter().map(|_| compiled.name.clone()));
                    loops.closures.push(Closure { predecessor, successor, forms, aligned, path });
                }
            }
        }
        let linear = model.couplings.iter().map(|coupling| coupling.name.clone());
        loops.names.extend(linear.take(loops.couplings.len()));
        Some(loops)
    }

    /// True if the model has no constraints.
    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }

    /// Residuals at positions of the joints.
    pub fn residuals(&self, plan: &Plan<Interval>, q: &[Interval]) -> Vec<Interval> {
        self.evaluate(plan, q, &plan.placements(q), false).residuals
    }

    /// Residuals and rows at positions of the joints.
    pub fn rows(&self, plan: &Plan<Interval>, q: &[Interval], placements: &[Placement<Interval>]) -> Rows {
        self.evaluate(plan, q, placements, true)
    }

    fn evaluate(
        &self,
        plan: &Plan<Interval>,
        q: &[Interval],
        placements: &[Placement<Interval>],
        has_matrix: bool,
    ) -> Rows {
        let frames = plan.frames(placements);
        let at = |on: &On<Interval>| on.body.map_or(on.frame, |body| frames[body] * on.frame);
        let (mut residuals, mut matrix) = (Vec::new(), Vec::new());
        for closure in &self.closures {
            let (x_rp, x_rs) = (at(&closure.predecessor), at(&closure.successor));
            let apart = x_rs.translation - x_rp.translation;
            let path = closure.path.iter().filter(|_| has_matrix);
            let columns: Vec<_> = path
                .flat_map(|&(body, sign)| {
                    let columns = plan.columns_at(body, placements, &frames, &x_rs.translation);
                    columns.map(move |(coordinate, twist)| (coordinate, twist * Interval::point(sign)))
                })
                .collect();
            for form in &closure.forms {
                let (residual, wrench) = match form {
                    Form::Along(e) => {
                        let e = x_rp.vector(e);
                        (e.dot(&apart), Wrench::new(Vector3::zeros(), e))
                    }
                    Form::Cosine(e, b) => {
                        let (e, b) = (x_rp.vector(e), x_rs.vector(b));
                        (e.dot(&b), Wrench::new(b.cross(&e), Vector3::zeros()))
                    }
                    Form::Distance(distance) => {
                        let length = norm(&apart);
                        (length - *distance, Wrench::new(Vector3::zeros(), apart.map(|x| x / length)))
                    }
                };
                let mut row = vec![Interval::point(0.0); plan.coordinates];
                for (coordinate, twist) in &columns {
                    row[*coordinate] += wrench.power(twist);
                }
                residuals.push(residual);
                matrix.push(row);
            }
        }
        for coupling in &self.couplings {
            let mut row = vec![Interval::point(0.0); plan.coordinates];
            let mut residual = -coupling.constant;
            for &(position, body, factor) in &coupling.terms {
                residual += factor * q[position];
                // Couplings relate joints with one velocity.
                for (coordinate, multiplier) in plan.rates(body).take(1) {
                    row[coordinate] += factor * multiplier;
                }
            }
            residuals.push(residual);
            matrix.push(row);
        }
        Rows { residuals, matrix }
    }

    /// True if aligned directions of all closures have a positive cosine.
    fn is_aligned(&self, plan: &Plan<Interval>, q: &[Interval]) -> bool {
        let frames = plan.frames(&plan.placements(q));
        let at = |on: &On<Interval>| on.body.map_or(on.frame, |body| frames[body] * on.frame);
        self.closures.iter().all(|closure| {
            let (x_rp, x_rs) = (at(&closure.predecessor), at(&closure.successor));
            closure.aligned.iter().all(|(e, b)| x_rp.vector(e).dot(&x_rs.vector(b)).lo() > 0.0)
        })
    }
}

/// Directions of the predecessor and of the successor that are parallel.
type Aligned = Vec<(Vector3<Interval>, Vector3<Interval>)>;

/// Zero components of a closure, without those that the joints of the tree imply at all positions; and the aligned directions. `floats`: true
/// for a floating root link.
fn closure_forms(
    mechanism: &Mechanism,
    closure: &percuss_mechanism::Closure,
    compiled: &CompiledClosure,
    floats: bool,
) -> (Vec<Form>, Aligned) {
    let unit = written_vector;
    let axes = [0, 1, 2].map(|k| Vector3::ith(k, 1.0));
    let [n1, n2] = compiled.normals.each_ref().map(unit);
    let (a, b) = (unit(&compiled.axis), unit(&compiled.successor_axis));
    let circuit = Circuit::new(mechanism, closure, floats);
    let keeps = |directions| circuit.as_ref()?.keeps_direction(directions);
    let along_axis = keeps([&compiled.axis, &compiled.successor_axis]);
    let of_frame = [0, 1, 2].map(|k| keeps([&axes[k], &axes[k]]));
    let is_planar = |k: usize| of_frame[k] == Some(true);
    let axes = axes.map(|e: Vector3<f64>| e.map(Interval::point));
    let across = [Form::Along(n1), Form::Along(n2)];
    let point = if circuit.as_ref().is_some_and(Circuit::keeps_origin) {
        Vec::new()
    } else if along_axis == Some(true) {
        across.to_vec()
    } else {
        (0..3).filter(|k| !is_planar(*k)).map(|k| Form::Along(axes[k])).collect()
    };
    let turns = [(1, 2), (2, 0), (0, 1)].into_iter().filter(|(i, k)| of_frame[*i].or(of_frame[*k]).is_none());
    let turns: Vec<Form> = turns.map(|(i, k)| Form::Cosine(axes[i], axes[k])).collect();
    let parallel = match along_axis {
        Some(_) => Vec::new(),
        None => vec![Form::Cosine(n1, b), Form::Cosine(n2, b)],
    };
    let fixed: Vec<_> = axes.iter().map(|e| (*e, *e)).collect();
    match compiled.kind {
        ClosureKind::Fixed => ([point, turns].concat(), fixed),
        ClosureKind::Prismatic => {
            let is_zero =
                |n: &Vector3<f64>| (0..3).any(|k| is_planar(k) && (0..3).all(|i| i == k || n[i] == 0.0));
            let normals = compiled.normals.iter().filter(|n| !is_zero(n));
            (normals.map(|n| Form::Along(unit(n))).chain(turns).collect(), fixed)
        }
        ClosureKind::Revolute => ([point, parallel].concat(), vec![(a, b)]),
        ClosureKind::Cylindrical => ([&across[..], &parallel].concat(), vec![(a, b)]),
        ClosureKind::Universal => ([&point[..], &[Form::Cosine(a, unit(&compiled.axis2))]].concat(), vec![]),
        ClosureKind::Planar => {
            let along = (along_axis != Some(true)).then_some(Form::Along(a));
            (along.into_iter().chain(parallel).collect(), vec![(a, b)])
        }
        ClosureKind::Spherical => (point, vec![]),
        ClosureKind::Distance => {
            // A distance as drawn has the roundings of the frames as drawn.
            let drawn = Interval::around(compiled.distance, DRAWN_READING, mechanism.characteristic_length());
            let distance = closure.distance().map_or(drawn, written);
            (vec![Form::Distance(distance)], vec![])
        }
    }
}

/// Euclidean norm.
fn norm(v: &Vector3<Interval>) -> Interval {
    (v.x.square() + v.y.square() + v.z.square()).sqrt()
}

/// Middles of a matrix of intervals.
pub(super) fn middle(matrix: &[Vec<Interval>]) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.len(), matrix.first().map_or(0, Vec::len), |r, c| matrix[r][c].mid())
}

/// C · (interval vector), with C exact.
pub(super) fn times(c: &DMatrix<f64>, v: &[Interval]) -> Vec<Interval> {
    let row = |r: usize| {
        v.iter().enumerate().fold(Interval::point(0.0), |sum, (k, x)| sum + Interval::point(c[(r, k)]) * *x)
    };
    (0..c.nrows()).map(row).collect()
}

/// Independent rows and dependent coordinates by complete pivoting; the coordinates in `free` are not eliminated.
fn pivots(mut a: DMatrix<f64>, free: &[bool]) -> (Vec<usize>, Vec<usize>) {
    let (mut rows, mut columns) = (Vec::new(), Vec::new());
    let largest = a.amax();
    loop {
        let open = (0..a.nrows()).filter(|r| !rows.contains(r));
        let open = open.flat_map(|r| (0..a.ncols()).map(move |c| (r, c)));
        let open = open.filter(|(_, c)| !free[*c] && !columns.contains(c));
        let Some((r, c)) = open.max_by(|x, y| a[*x].abs().total_cmp(&a[*y].abs())) else { break };
        if a[(r, c)].abs() <= LEAST_PROVED_PIVOT * largest {
            break;
        }
        for other in (0..a.nrows()).filter(|other| *other != r && !rows.contains(other)) {
            let factor = a[(other, c)] / a[(r, c)];
            for k in 0..a.ncols() {
                a[(other, k)] -= factor * a[(r, k)];
            }
        }
        rows.push(r);
        columns.push(c);
    }
    (rows, columns)
}

/// Search for a proved assembly near given positions.
pub(super) struct Closing<'a> {
    pub plan: &'a Plan<Interval>,
    pub loops: &'a Loops,
    /// Position and coordinate of each dependent coordinate with one velocity: coordinate → position.
    pub position_of: &'a [Option<usize>],
    /// Coordinates with given positions.
    pub free: &'a [bool],
}

impl Closing<'_> {
    /// Independent rows and dependent coordinates at the middles of `q`, with the inverse of their matrix. `None` if the dependent
    /// coordinates do not have one position each, or the matrix is singular.
    fn dependents(&self, q: &[Interval]) -> Option<(Vec<usize>, Vec<usize>, DMatrix<f64>)> {
        let mid: Vec<Interval> = q.iter().map(|x| Interval::point(x.mid())).collect();
        let rows = self.loops.rows(self.plan, &mid, &self.plan.placements(&mid));
        let a = middle(&rows.matrix);
        let (rows, columns) = pivots(a.clone(), self.free);
        columns.iter().all(|c| self.position_of[*c].is_some()).then_some(())?;
        let square = DMatrix::from_fn(rows.len(), rows.len(), |r, c| a[(rows[r], columns[c])]);
        let inverse = square.try_inverse()?;
        Some((rows, columns, inverse))
    }

    /// Positions of the dependent coordinates.
    fn positions(&self, dependent: &[usize]) -> Vec<usize> {
        dependent.iter().filter_map(|c| self.position_of[*c]).collect()
    }

    /// q̃ − C F(q̃) for the dependent positions. The given positions may be intervals.
    fn newton(&self, q: &[Interval], rows: &[usize], positions: &[usize], c: &DMatrix<f64>) -> Vec<Interval> {
        let mut centre = q.to_vec();
        positions.iter().for_each(|&p| centre[p] = Interval::point(q[p].mid()));
        let residuals = self.loops.residuals(self.plan, &centre);
        let f: Vec<Interval> = rows.iter().map(|r| residuals[*r]).collect();
        positions.iter().zip(times(c, &f)).map(|(&p, step)| centre[p] - step).collect()
    }

    /// Box of the dependent positions with given radii about the middles `q̃`, if the operator of Krawczyk maps it into itself; otherwise its
    /// image K = q̃ − C F(q̃) + (1 − C F′(q)) (q − q̃). `centre`: q̃ − C F(q̃).
    fn krawczyk(
        &self,
        q: &[Interval],
        (centre, radii): (&[Interval], &[f64]),
        rows: &[usize],
        dependent: &[usize],
        c: &DMatrix<f64>,
    ) -> (Vec<Interval>, bool) {
        let positions = self.positions(dependent);
        let mut q = q.to_vec();
        let steps: Vec<Interval> = radii.iter().map(|r| Interval::symmetric(*r)).collect();
        positions.iter().zip(&steps).for_each(|(&p, step)| q[p] = Interval::point(q[p].mid()) + *step);
        let around = self.loops.rows(self.plan, &q, &self.plan.placements(&q)).matrix;
        let mut image = centre.to_vec();
        for (i, image) in image.iter_mut().enumerate() {
            for (k, column) in dependent.iter().enumerate() {
                let mut entry = Interval::point(if i == k { 1.0 } else { 0.0 });
                for (m, r) in rows.iter().enumerate() {
                    entry -= Interval::point(c[(i, m)]) * around[*r][*column];
                }
                *image += entry * steps[k];
            }
        }
        let is_inside = positions.iter().zip(&image).all(|(&p, x)| x.is_inside(q[p]));
        (image, is_inside)
    }

    /// Proof that the independent rows have exactly one solution near the positions `q`; the middles of the dependent positions are the
    /// approximation, and the given positions may be intervals.
    pub fn close(&self, q: &[Interval]) -> Option<Closed> {
        let (rows, dependent, c) = self.dependents(q)?;
        let mut q = q.to_vec();
        let positions = self.positions(&dependent);
        // One step of Newton gives the middle of the tried box and its first radius.
        let first = self.newton(&q, &rows, &positions, &c);
        let mut radii: Vec<f64> = first.iter().map(|x| x.radius() * 1.1 + LEAST_BOX).collect();
        positions.iter().zip(&first).for_each(|(&p, x)| q[p] = Interval::point(x.mid()));
        let centre = self.newton(&q, &rows, &positions, &c);
        for _ in 0..MOST_PROOF_BOXES {
            let (image, is_inside) = self.krawczyk(&q, (&centre, &radii), &rows, &dependent, &c);
            if is_inside {
                positions.iter().zip(&image).for_each(|(&p, x)| q[p] = *x);
                return self.loops.is_aligned(self.plan, &q).then_some(Closed { q, rows, dependent });
            }
            for ((x, of), r) in image.iter().zip(&first).zip(&mut radii) {
                *r = r.max((*x - Interval::point(of.mid())).magnitude()) * 1.2;
                if *r >= WIDEST_PROOF {
                    return None;
                }
            }
        }
        None
    }

    /// Approximate solution by at most [`PROOF_NEWTON_STEPS`] steps of Newton, at the middles of the given positions.
    pub fn approximate(&self, q: &[Interval]) -> Option<Vec<Interval>> {
        let mut q: Vec<Interval> = q.iter().map(|x| Interval::point(x.mid())).collect();
        for _ in 0..PROOF_NEWTON_STEPS {
            let (rows, dependent, c) = self.dependents(&q)?;
            let positions = self.positions(&dependent);
            for (p, x) in positions.iter().zip(self.newton(&q, &rows, &positions, &c)) {
                q[*p] = Interval::point(x.mid());
            }
        }
        Some(q)
    }

    /// Largest tried radius (rad or m) around a proved assembly without another solution of the independent rows.
    pub fn uniqueness(&self, closed: &Closed) -> Option<f64> {
        let (rows, dependent, c) = self.dependents(&closed.q)?;
        let positions = self.positions(&dependent);
        let centre = self.newton(&closed.q, &rows, &positions, &c);
        let mut radius = WIDEST_PROOF;
        while radius > LEAST_RADIUS {
            let radii = vec![radius; positions.len()];
            if self.krawczyk(&closed.q, (&centre, &radii), &rows, &dependent, &c).1 {
                return Some(radius);
            }
            radius *= RADIUS_STEP;
        }
        None
    }
}
