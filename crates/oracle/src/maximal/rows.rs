//! Rows of A, W and j: linear forms on the velocities of the links.

use super::joints::JointInWorld;
use super::row::{Row, WORLD, com, rotation, translation, velocity_row};
use super::{Question, loops, pose, residual};
use crate::limits;
use nalgebra::{DMatrix, DVector, Matrix3, Matrix4, SymmetricEigen, Vector3};
use percuss_mechanism::Link;

/// Problem in scaled velocities: six per link, L ω first, then the velocity of the centre of mass.
pub(super) struct System {
    /// Rows of A of the base and the joints: independent by construction, normalised.
    pub tree: DMatrix<f64>,
    /// Other rows of A: mimics, locks, closures, couplings, held contacts; normalised.
    pub extra: DMatrix<f64>,
    /// Ratio to the largest singular value up to which a singular value of the other rows counts as zero.
    pub threshold: f64,
    /// W: twice the kinetic energy is |W v|².
    pub energy: DMatrix<f64>,
    /// Link or joint of each row of W.
    pub owners: Vec<Owner>,
    /// j.
    pub contact: DVector<f64>,
    /// Numbers of links and joints.
    pub counts: (usize, usize),
    /// Length L.
    pub length: f64,
}

/// Owner of the energy in a row of W.
#[derive(Clone, Copy)]
pub(super) enum Owner {
    Link(usize),
    Rotor(usize),
}

/// Rows whose squares sum to twice the kinetic energy of a link.
///
/// Principal moments within the rounding of the parallel-axis theorem count as zero: the square root of this
/// rounding is 1e-8, and a point mass would get an inertia. Negative moments count as zero too (route C does
/// not support indefinite inertias).
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

/// Armature of the question, if given, else of the mechanism.
pub(super) fn armature(question: &Question, joint: usize) -> Vec<f64> {
    let own = &question.mechanism.joints()[joint];
    match question.armature.iter().rev().find(|(id, _)| id.index() == joint) {
        None => own.armature().to_vec(),
        Some((_, values)) if values.len() == 1 => vec![values[0]; own.kind().dofs()],
        Some((_, values)) => values.clone(),
    }
}

/// Length L that scales angular to linear velocities: the longest moment arm on a link other than the root, m.
/// The characteristic length of the mechanism is unsuitable, because a light link with a large inertia
/// increases it.
fn velocity_scale(question: &Question, placed: &[JointInWorld]) -> f64 {
    let mechanism = question.mechanism;
    let frames = mechanism.closures().iter().flat_map(|c| [c.predecessor(), c.successor()]);
    let of_closures = frames.filter_map(|frame| {
        let link = frame.link.filter(|link| *link != mechanism.root())?;
        Some((frame.frame.translation - com(mechanism.link(link))).norm())
    });
    let struck = (question.point - com(mechanism.link(question.on))).norm();
    let below = |joint: &JointInWorld| joint.joint.parent() != mechanism.root();
    let arms = placed.iter().map(|joint| {
        let above = if below(joint) { joint.arm_parent.norm() } else { 0.0 };
        joint.arm_child.norm().max(above)
    });
    let longest = arms.chain(of_closures).fold(struck, f64::max);
    if longest > 0.0 { longest } else { 1.0 }
}

/// Assembles A, W and j.
pub(super) fn assemble(question: &Question) -> System {
    let mechanism = question.mechanism;
    let x_wl = pose::poses(mechanism, &question.positions);
    let (links, joints) = (mechanism.links(), mechanism.joints());
    let placed: Vec<JointInWorld> = joints
        .iter()
        .zip(&question.positions)
        .map(|(j, q)| JointInWorld::new(j, q, question, &x_wl))
        .collect();

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
            extra.push(joint.rates().swap_remove(0).add_scaled(-mimic.multiplier, &master));
        }
        let values = armature(question, i);
        let rates = joint.rates();
        assert_eq!(values.len(), rates.len(), "armature of joint {}", joint.joint.name());
        for (value, rate) in values.iter().zip(&rates).filter(|(value, _)| **value > 0.0) {
            energy.push(Row::default().add_scaled(value.sqrt(), rate));
            owners.push(Owner::Rotor(i));
        }
    }

    extra.extend(loops::rows(question, &placed, &x_wl));

    let length = velocity_scale(question, &placed);
    let stack = |rows: &[Row], normalise: bool| {
        let mut matrix = DMatrix::zeros(rows.len(), 6 * links.len());
        for (i, row) in rows.iter().enumerate() {
            let dense = row.dense(links.len(), length);
            // A zero row (a distance of zero) is no constraint.
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
        length,
    }
}

/// max(1e-10, 10 δ / size), with the loop residual δ at the position of the question (DESIGN §4).
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

/// j: closing speed of the contact point, or relative angular velocity about the axis of a moment.
fn contact_row(question: &Question, x_wl: &[Matrix4<f64>]) -> Row {
    let links = question.mechanism.links();
    let on = question.on.index();
    let n = &question.normal;
    if question.is_moment {
        let angular = |link: usize| Row(vec![(link, *n, Vector3::zeros())]);
        return match question.against {
            Some(against) if against == question.on => Row::default(),
            Some(against) => angular(on).add_scaled(-1.0, &angular(against.index())),
            None => angular(on),
        };
    }
    let arm = rotation(&x_wl[on]) * (question.point - com(&links[on]));
    let row = velocity_row(on, &arm, n);
    let Some(against) = question.against.map(|link| link.index()) else { return row };
    if against == on {
        return Row::default();
    }
    // Point relative to the other link's centre of mass, computed from relative vectors to avoid the rounding
    // of a distant world origin.
    let between = translation(&x_wl[on]) - translation(&x_wl[against]);
    let arm =
        between + rotation(&x_wl[on]) * question.point - rotation(&x_wl[against]) * com(&links[against]);
    row.add_scaled(-1.0, &velocity_row(against, &arm, n))
}
