//! The rows of A, W and j: every one a linear form on the velocities of the links.

use super::{Question, pose};
use nalgebra::{DMatrix, DVector, Matrix3, Matrix4, SymmetricEigen, Vector3};
use percuss_mechanism::{Joint, JointKind, Link};
use percuss_spatial::plane_basis;

/// The problem in scaled velocities: six a link, L ω first, then the velocity of the centre of mass.
pub(super) struct System {
    /// A, its rows unit vectors.
    pub constraints: DMatrix<f64>,
    /// W: twice the kinetic energy is |W v|².
    pub energy: DMatrix<f64>,
    /// Whose energy each row of W is.
    pub owners: Vec<Owner>,
    /// j.
    pub contact: DVector<f64>,
    /// How many links and joints there are.
    pub counts: (usize, usize),
}

/// Whose energy a row of W measures.
#[derive(Clone, Copy)]
pub(super) enum Owner {
    Link(usize),
    Rotor(usize),
}

/// A linear form: coefficients of (ω, v) for some links.
#[derive(Clone, Default)]
struct Row(Vec<(usize, Vector3<f64>, Vector3<f64>)>);

impl Row {
    /// `self` + `factor` · `other`.
    fn plus(mut self, factor: f64, other: &Row) -> Row {
        self.0
            .extend(other.0.iter().map(|&(link, angular, linear)| (link, angular * factor, linear * factor)));
        self
    }

    /// Coefficients of the scaled velocities.
    fn dense(&self, links: usize, length: f64) -> DVector<f64> {
        let mut dense = DVector::zeros(6 * links);
        for (link, angular, linear) in &self.0 {
            for i in 0..3 {
                dense[6 * link + i] += angular[i] / length;
                dense[6 * link + 3 + i] += linear[i];
            }
        }
        dense
    }
}

/// n · (velocity of the point of `link` that is `arm` from its centre of mass).
fn velocity_row(link: usize, arm: &Vector3<f64>, n: &Vector3<f64>) -> Row {
    Row(vec![(link, arm.cross(n), *n)])
}

/// A joint in world axes.
struct Placed<'a> {
    joint: &'a Joint,
    /// From the parent's centre of mass to the child's origin.
    arm_parent: Vector3<f64>,
    /// From the child's centre of mass to its origin.
    arm_child: Vector3<f64>,
    /// e1, e2 of the plane normal to the axis, then the axis.
    frame: [Vector3<f64>; 3],
    /// Axes of the child.
    child_axes: [Vector3<f64>; 3],
}

const WORLD: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl<'a> Placed<'a> {
    fn new(joint: &'a Joint, q: &[f64], question: &Question, x_wl: &[Matrix4<f64>]) -> Self {
        let (parent, child) = (joint.parent().index(), joint.child().index());
        let links = question.mechanism.links();
        let (r_wp, r_wc) = (rotation(&x_wl[parent]), rotation(&x_wl[child]));
        // Arms from the relative pose: a world origin far away costs no digits.
        let x_pc = pose::origin(joint) * pose::motion(joint, q);
        let r_wj = r_wp * joint.origin().rotation;
        let (e1, e2) = plane_basis(joint.axis());
        Self {
            joint,
            arm_parent: r_wp * (translation(&x_pc) - com(&links[parent])),
            arm_child: -(r_wc * com(&links[child])),
            frame: [r_wj * e1, r_wj * e2, r_wj * joint.axis()],
            child_axes: [0, 1, 2].map(|i| r_wc.column(i).into_owned()),
        }
    }

    /// n · (angular velocity of the child relative to the parent).
    fn angular(&self, n: &Vector3<f64>) -> Row {
        let (parent, child) = (self.joint.parent().index(), self.joint.child().index());
        Row(vec![(child, *n, Vector3::zeros()), (parent, -n, Vector3::zeros())])
    }

    /// n · (velocity of the child's origin relative to the point of the parent that is there).
    fn linear(&self, n: &Vector3<f64>) -> Row {
        let (parent, child) = (self.joint.parent().index(), self.joint.child().index());
        velocity_row(child, &self.arm_child, n).plus(-1.0, &velocity_row(parent, &self.arm_parent, n))
    }

    /// What the joint forbids.
    fn constraints(&self, locked: bool) -> Vec<Row> {
        let world = WORLD.map(Vector3::from);
        let [e1, e2, axis] = &self.frame;
        let all_angular = || world.iter().map(|n| self.angular(n));
        let all_linear = || world.iter().map(|n| self.linear(n));
        let no_tilt = || [e1, e2].map(|n| self.angular(n));
        if locked {
            return all_angular().chain(all_linear()).collect();
        }
        match self.joint.kind() {
            JointKind::Fixed => all_angular().chain(all_linear()).collect(),
            JointKind::Revolute | JointKind::Continuous => all_linear().chain(no_tilt()).collect(),
            JointKind::Prismatic => all_angular().chain([e1, e2].map(|n| self.linear(n))).collect(),
            JointKind::Planar => no_tilt().into_iter().chain([self.linear(axis)]).collect(),
            JointKind::Spherical => all_linear().collect(),
            JointKind::Floating => Vec::new(),
        }
    }

    /// Its velocities, in the order of [`JointKind`]'s table.
    fn rates(&self) -> Vec<Row> {
        let [e1, e2, axis] = &self.frame;
        let child_angular = || self.child_axes.iter().map(|n| self.angular(n));
        match self.joint.kind() {
            JointKind::Fixed => Vec::new(),
            JointKind::Revolute | JointKind::Continuous => vec![self.angular(axis)],
            JointKind::Prismatic => vec![self.linear(axis)],
            JointKind::Planar => vec![self.linear(e1), self.linear(e2), self.angular(axis)],
            JointKind::Spherical => child_angular().collect(),
            JointKind::Floating => {
                child_angular().chain(self.child_axes.iter().map(|n| self.linear(n))).collect()
            }
        }
    }
}

fn rotation(x: &Matrix4<f64>) -> Matrix3<f64> {
    x.fixed_view::<3, 3>(0, 0).into_owned()
}

fn translation(x: &Matrix4<f64>) -> Vector3<f64> {
    x.fixed_view::<3, 1>(0, 3).into_owned()
}

/// Centre of mass in the link frame; the origin of a massless link.
fn com(link: &Link) -> Vector3<f64> {
    let inertia = link.inertia();
    if inertia.mass > 0.0 { inertia.first_moment / inertia.mass } else { Vector3::zeros() }
}

/// Rows whose squares sum to twice the kinetic energy of a link.
///
/// Principal moments within the rounding of the parallel-axis theorem count as zero: the root of that rounding
/// would be 1e-8, and a point mass would seem to have an inertia. So do negative ones (files that were taken with
/// an indefinite inertia are not this route's business).
fn energy_rows(index: usize, link: &Link, r_wl: &Matrix3<f64>) -> Vec<Row> {
    const ROUNDING: f64 = 32.0 * f64::EPSILON;
    let inertia = link.inertia();
    let c = com(link);
    let steiner = Matrix3::from_diagonal_element(c.dot(&c)) - c * c.transpose();
    let about_com = inertia.rotational - steiner * inertia.mass;
    let floor = ROUNDING * inertia.rotational.trace().abs();
    let principal = SymmetricEigen::new((about_com + about_com.transpose()) / 2.0);
    let mut rows = Vec::new();
    for i in 0..3 {
        let moment = principal.eigenvalues[i];
        if moment > floor {
            let n = r_wl * principal.eigenvectors.column(i);
            rows.push(Row(vec![(index, n * moment.sqrt(), Vector3::zeros())]));
        }
    }
    if inertia.mass > 0.0 {
        let root = inertia.mass.sqrt();
        rows.extend(WORLD.map(|n| Row(vec![(index, Vector3::zeros(), Vector3::from(n) * root)])));
    }
    rows
}

/// The values in force: those of the question, else those of the mechanism.
fn armature(question: &Question, joint: usize) -> Vec<f64> {
    let own = &question.mechanism.joints()[joint];
    match question.armature.iter().rev().find(|(id, _)| id.index() == joint) {
        None => own.armature().to_vec(),
        Some((_, values)) if values.len() == 1 => vec![values[0]; own.kind().dofs()],
        Some((_, values)) => values.clone(),
    }
}

/// The length L that makes angular velocities comparable with linear ones: the longest arm on a link other than the
/// root, m. Not the mechanism's characteristic length, which a featherweight with a large inertia inflates.
fn length(question: &Question, placed: &[Placed]) -> f64 {
    let mechanism = question.mechanism;
    let struck = (question.point - com(mechanism.link(question.on))).norm();
    let below = |joint: &Placed| joint.joint.parent() != mechanism.root();
    let arms = placed.iter().map(|joint| {
        let above = if below(joint) { joint.arm_parent.norm() } else { 0.0 };
        joint.arm_child.norm().max(above)
    });
    let longest = arms.fold(struck, f64::max);
    if longest > 0.0 { longest } else { 1.0 }
}

/// Writes down A, W and j.
pub(super) fn assemble(question: &Question) -> System {
    let mechanism = question.mechanism;
    let x_wl = pose::poses(mechanism, &question.positions);
    let (links, joints) = (mechanism.links(), mechanism.joints());
    let placed: Vec<Placed> =
        joints.iter().zip(&question.positions).map(|(j, q)| Placed::new(j, q, question, &x_wl)).collect();

    let mut constraints = Vec::new();
    if !question.floating_base {
        let root = mechanism.root().index();
        for n in WORLD.map(Vector3::from) {
            constraints.push(Row(vec![(root, n, Vector3::zeros())]));
            constraints.push(Row(vec![(root, Vector3::zeros(), n)]));
        }
    }
    let mut energy = Vec::new();
    let mut owners = Vec::new();
    for (i, link) in links.iter().enumerate() {
        let rows = energy_rows(i, link, &rotation(&x_wl[i]));
        owners.extend(rows.iter().map(|_| Owner::Link(i)));
        energy.extend(rows);
    }
    for (i, joint) in placed.iter().enumerate() {
        let locked = question.locked.iter().any(|id| id.index() == i);
        constraints.extend(joint.constraints(locked));
        if let Some(mimic) = joint.joint.mimic() {
            let master = placed[mimic.master.index()].rates().swap_remove(0);
            constraints.push(joint.rates().swap_remove(0).plus(-mimic.multiplier, &master));
        }
        let values = armature(question, i);
        let rates = joint.rates();
        assert_eq!(values.len(), rates.len(), "armature of joint {}", joint.joint.name());
        for (value, rate) in values.iter().zip(&rates).filter(|(value, _)| **value > 0.0) {
            energy.push(Row::default().plus(value.sqrt(), rate));
            owners.push(Owner::Rotor(i));
        }
    }

    let length = length(question, &placed);
    let stack = |rows: &[Row], normalise: bool| {
        let mut matrix = DMatrix::zeros(rows.len(), 6 * links.len());
        for (i, row) in rows.iter().enumerate() {
            let dense = row.dense(links.len(), length);
            let size = if normalise { dense.norm() } else { 1.0 };
            matrix.set_row(i, &(dense / size).transpose());
        }
        matrix
    };
    System {
        constraints: stack(&constraints, true),
        energy: stack(&energy, false),
        owners,
        contact: contact_row(question, &x_wl).dense(links.len(), length),
        counts: (links.len(), joints.len()),
    }
}

/// j: the speed at which the struck point closes on the other side.
fn contact_row(question: &Question, x_wl: &[Matrix4<f64>]) -> Row {
    let links = question.mechanism.links();
    let on = question.on.index();
    let n = &question.normal;
    let arm = rotation(&x_wl[on]) * (question.point - com(&links[on]));
    let row = velocity_row(on, &arm, n);
    let Some(against) = question.against.map(|link| link.index()) else { return row };
    if against == on {
        return Row::default();
    }
    // In the other link's frame, seen from the struck link: the point minus the other's centre of mass.
    let between = translation(&x_wl[on]) - translation(&x_wl[against]);
    let arm =
        between + rotation(&x_wl[on]) * question.point - rotation(&x_wl[against]) * com(&links[against]);
    row.plus(-1.0, &velocity_row(against, &arm, n))
}
