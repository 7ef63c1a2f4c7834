//! The rows of A, W and j: every one a linear form on the velocities of the links.

use super::joints::Placed;
use super::row::{Row, WORLD, com, rotation, translation, velocity_row};
use super::{Question, loops, pose, residual};
use crate::limits;
use nalgebra::{DMatrix, DVector, Matrix3, Matrix4, SymmetricEigen, Vector3};
use percuss_mechanism::Link;

/// The problem in scaled velocities: six a link, L ω first, then the velocity of the centre of mass.
pub(super) struct System {
    /// The rows of A that the base and the joints impose: independent by construction. Unit vectors.
    pub tree: DMatrix<f64>,
    /// The other rows of A: mimics, locks, closures, couplings, held contacts. Unit vectors.
    pub extra: DMatrix<f64>,
    /// The part of the largest singular value at which one of the other rows counts as zero.
    pub threshold: f64,
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

/// Rows whose squares sum to twice the kinetic energy of a link.
///
/// Principal moments within the rounding of the parallel-axis theorem count as zero: the root of that rounding
/// would be 1e-8, and a point mass would seem to have an inertia. So do negative ones (files that were taken with
/// an indefinite inertia are not supported by this route).
fn energy_rows(index: usize, link: &Link, r_wl: &Matrix3<f64>) -> Vec<Row> {
    let inertia = link.inertia();
    let c = com(link);
    let steiner = Matrix3::from_diagonal_element(c.dot(&c)) - c * c.transpose();
    let about_com = inertia.rotational - steiner * inertia.mass;
    let floor = limits::STEINER_ROUNDING * inertia.rotational.trace().abs();
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
/// root, m. Not the mechanism's characteristic length, which a light link with a large inertia increases.
fn length(question: &Question, placed: &[Placed]) -> f64 {
    let mechanism = question.mechanism;
    let frames = mechanism.closures().iter().flat_map(|c| [c.predecessor(), c.successor()]);
    let of_closures = frames.filter_map(|frame| {
        let link = frame.link.filter(|link| *link != mechanism.root())?;
        Some((frame.frame.translation - com(mechanism.link(link))).norm())
    });
    let struck = (question.point - com(mechanism.link(question.on))).norm();
    let below = |joint: &Placed| joint.joint.parent() != mechanism.root();
    let arms = placed.iter().map(|joint| {
        let above = if below(joint) { joint.arm_parent.norm() } else { 0.0 };
        joint.arm_child.norm().max(above)
    });
    let longest = arms.chain(of_closures).fold(struck, f64::max);
    if longest > 0.0 { longest } else { 1.0 }
}

/// Writes down A, W and j.
pub(super) fn assemble(question: &Question) -> System {
    let mechanism = question.mechanism;
    let x_wl = pose::poses(mechanism, &question.positions);
    let (links, joints) = (mechanism.links(), mechanism.joints());
    let placed: Vec<Placed> =
        joints.iter().zip(&question.positions).map(|(j, q)| Placed::new(j, q, question, &x_wl)).collect();

    let mut tree = Vec::new();
    if !question.floating_base {
        let root = mechanism.root().index();
        for n in WORLD.map(Vector3::from) {
            tree.push(Row(vec![(root, n, Vector3::zeros())]));
            tree.push(Row(vec![(root, Vector3::zeros(), n)]));
        }
    }
    let mut energy = Vec::new();
    let mut owners = Vec::new();
    let mut extra = Vec::new();
    for (i, link) in links.iter().enumerate() {
        let rows = energy_rows(i, link, &rotation(&x_wl[i]));
        owners.extend(rows.iter().map(|_| Owner::Link(i)));
        energy.extend(rows);
    }
    for (i, joint) in placed.iter().enumerate() {
        tree.extend(joint.constraints());
        if question.locked.iter().any(|id| id.index() == i) {
            extra.extend(joint.rates());
        }
        if let Some(mimic) = joint.joint.mimic() {
            let master = placed[mimic.master.index()].rates().swap_remove(0);
            extra.push(joint.rates().swap_remove(0).plus(-mimic.multiplier, &master));
        }
        let values = armature(question, i);
        let rates = joint.rates();
        assert_eq!(values.len(), rates.len(), "armature of joint {}", joint.joint.name());
        for (value, rate) in values.iter().zip(&rates).filter(|(value, _)| **value > 0.0) {
            energy.push(Row::default().plus(value.sqrt(), rate));
            owners.push(Owner::Rotor(i));
        }
    }

    extra.extend(loops::rows(question, &placed, &x_wl));

    let length = length(question, &placed);
    let stack = |rows: &[Row], normalise: bool| {
        let mut matrix = DMatrix::zeros(rows.len(), 6 * links.len());
        for (i, row) in rows.iter().enumerate() {
            let dense = row.dense(links.len(), length);
            // A row without an entry (a distance of zero) forbids nothing.
            let norm = dense.norm();
            let size = if normalise && norm > 0.0 { norm } else { 1.0 };
            matrix.set_row(i, &(dense / size).transpose());
        }
        matrix
    };
    System {
        tree: stack(&tree, true),
        extra: stack(&extra, true),
        threshold: question.threshold.unwrap_or_else(|| threshold(question)),
        energy: stack(&energy, false),
        owners,
        contact: contact_row(question, &x_wl).dense(links.len(), length),
        counts: (links.len(), joints.len()),
    }
}

/// max(1e-10, 10 δ / size), δ the residual of the loops at the position asked about (DESIGN §4).
fn threshold(question: &Question) -> f64 {
    let size = question.mechanism.characteristic_length();
    let residual = residual::residual(question.mechanism, &question.positions) / size;
    assert!(
        residual <= limits::LARGEST_RESIDUAL,
        "{}: open by {residual:e} of its size",
        question.mechanism.name()
    );
    limits::RANK_THRESHOLD.max(limits::RANK_PER_RESIDUAL * residual)
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
