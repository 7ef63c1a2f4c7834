//! Impulsive reactions of an impact in maximal coordinates: multipliers of all joint, closure and condition rows at once.

use super::joints::JointInWorld;
use super::minimum::minimum_and_response;
use super::residual::{coupling_entries, loop_frame_in_world};
use super::row::{Row, WORLD, com, rotation, translation};
use super::rows::{armature, assemble};
use super::{Question, loops, pose};
use crate::limits;
use faer::Mat;
use nalgebra::{DMatrix, DVector, Matrix4, Vector3};

/// Impulsive wrench at one place: one solution, and its changes along the kernel of the transposed rows.
#[derive(Clone, Debug)]
pub struct PlaceReaction {
    /// Point to which the moment refers, world frame, m.
    pub point: Vector3<f64>,
    /// Moment and force on the receiving link, world axes: the solution of least norm.
    pub wrench: DVector<f64>,
    /// Changes of the wrench along an orthonormal basis of the kernel, 6 × dimension.
    pub open: DMatrix<f64>,
}

/// Multiplier of the row of a lock, a mimic or a coupling.
#[derive(Clone, Debug)]
pub struct RowReaction {
    /// Value of the solution of least norm.
    pub value: f64,
    /// Changes along an orthonormal basis of the kernel.
    pub open: DVector<f64>,
}

/// Response to a unit impulse −n̂ on the contact link and n̂ on the other link.
#[derive(Clone, Debug)]
pub struct ImpactReactions {
    /// Changes of the angular velocity and of the velocity of the centre of mass of every link, world axes.
    pub changes: Vec<(Vector3<f64>, Vector3<f64>)>,
    /// Changes of the velocities of every joint.
    pub joint_changes: Vec<Vec<f64>>,
    /// Action of the ground on the root link at its origin; zero for a floating base.
    pub ground: PlaceReaction,
    /// Action of the parent on the child of every joint, at the child's origin; armature, mimics, couplings and locks
    /// included.
    pub joints: Vec<PlaceReaction>,
    /// Action of the predecessor on the successor of every closure, at the successor's loop frame.
    pub closures: Vec<PlaceReaction>,
    /// Action of the ground on the held link of every held contact, at the held point.
    pub holds: Vec<PlaceReaction>,
    /// For every joint: impulse of the lock on each velocity; empty for a joint without a lock.
    pub locks: Vec<Vec<RowReaction>>,
    /// For every joint: impulse of the mimic on the joint; the master receives this impulse times −multiplier. `None` without a mimic.
    pub mimics: Vec<Option<RowReaction>>,
    /// For every coupling: impulse on a joint, divided by the factor of this joint in the coupling.
    pub couplings: Vec<RowReaction>,
    /// Largest unbalanced momentum of a link, relative to the impulse at the contact.
    pub imbalance: f64,
    /// Number of redundant rows.
    pub redundant: usize,
}

/// Receiving link of a reaction, and the vector from its centre of mass to the point of the reaction.
#[derive(Clone)]
struct Place {
    receiver: Option<usize>,
    arm: Vector3<f64>,
    point: Vector3<f64>,
    /// Sign of the receiver's entries: −1 if only the reverse side is a link.
    sign: f64,
}

/// Row, with the places through which its multiplier acts and the part of the row at each place. `drive`: the lock, mimic or coupling of
/// the row, if any.
struct ActingRow {
    drive: Option<Drive>,
    row: Row,
    parts: Vec<(usize, Row)>,
}

/// Lock, mimic or coupling of a row.
#[derive(Clone, Copy, PartialEq)]
enum Drive {
    Lock(usize),
    Mimic(usize),
    Coupling,
}

/// Reactions of a contact with a finite effective mass; `None` for other outcomes.
///
/// M ΔV = −jᵀ + Gᵀμ over six velocities per link, with one multiplier for each row of each joint, closure, lock, mimic,
/// coupling and held contact. μ is the solution of least norm by a singular value decomposition of Gᵀ; its kernel
/// contains the multipliers that redundancy leaves open. No row is eliminated by topology.
///
/// # Panics
/// As for [`solve`](super::solve).
pub fn reactions(question: &Question) -> Option<ImpactReactions> {
    let system = assemble(question);
    let (answer, response) = minimum_and_response(&system);
    let change = response? * (-1.0 / answer.outcome.finite()?);
    let mechanism = question.mechanism;
    let (links, joints) = (mechanism.links(), mechanism.joints());
    let x_wl = pose::poses(mechanism, &question.positions);
    let placed: Vec<JointInWorld> = joints
        .iter()
        .zip(&question.positions)
        .map(|(j, q)| JointInWorld::new(j, q, question, &x_wl))
        .collect();
    let places = places(question, &x_wl);
    let rows = acting_rows(question, &placed, &x_wl);

    let length = system.length;
    let dense = |row: &Row| row.dense(links.len(), length);
    let norms: Vec<f64> = rows.iter().map(|r| dense(&r.row).norm()).collect();
    let columns: Vec<DVector<f64>> = rows
        .iter()
        .zip(&norms)
        .map(|(r, norm)| if *norm > 0.0 { dense(&r.row) / *norm } else { dense(&r.row) })
        .collect();
    let wanted = system.energy.tr_mul(&(&system.energy * &change)) + &system.contact;
    let n = 6 * links.len();
    let transposed = Mat::from_fn(n, rows.len(), |i, k| columns[k][i]);
    let svd = transposed.svd().expect("finite rows");
    let values: Vec<f64> = svd.S().column_vector().iter().copied().collect();
    let rank = values.iter().filter(|v| **v > limits::RANK_THRESHOLD * values[0]).count();
    let (u, v) = (svd.U(), svd.V());
    let mut multipliers: DVector<f64> = DVector::zeros(rows.len());
    for k in 0..rank {
        let weight = (0..n).map(|i| u[(i, k)] * wanted[i]).sum::<f64>() / values[k];
        (0..rows.len()).for_each(|r| multipliers[r] += weight * v[(r, k)]);
    }
    let balance: DVector<f64> =
        columns.iter().zip(multipliers.iter()).fold(-wanted, |sum, (column, m)| sum + column * *m);

    let mut found: Vec<PlaceReaction> = places
        .iter()
        .map(|place| PlaceReaction {
            point: place.point,
            wrench: DVector::zeros(6),
            open: DMatrix::zeros(6, rows.len() - rank),
        })
        .collect();
    for (r, row) in rows.iter().enumerate().filter(|(r, _)| norms[*r] > 0.0) {
        for (at, part) in &row.parts {
            let wrench = places[*at].wrench(part) / norms[r];
            found[*at].wrench += &wrench * multipliers[r];
            for k in rank..rows.len() {
                let mut column = found[*at].open.column_mut(k - rank);
                column += &wrench * v[(r, k)];
            }
        }
    }
    let mut joint_changes = Vec::new();
    for (i, joint) in placed.iter().enumerate() {
        let rates = joint.rates();
        let changes: Vec<f64> = rates.iter().map(|rate| dense(rate).dot(&change)).collect();
        // The armature acts on the joint with the reverse of its change of momentum.
        for ((rate, value), by) in rates.iter().zip(armature(question, i)).zip(&changes) {
            found[1 + i].wrench -= places[1 + i].wrench(rate) * (value * by);
        }
        joint_changes.push(changes);
    }
    let changes = (0..links.len())
        .map(|i| {
            let part = |from: usize| Vector3::from_fn(|k, _| change[6 * i + from + k]);
            (part(0) / length, part(3))
        })
        .collect();
    let of_drive = |drive: Drive| {
        let own = rows.iter().enumerate().filter(move |(_, row)| row.drive == Some(drive));
        let reaction = |(r, _): (usize, &ActingRow)| {
            // The norm of a row without entries is zero; its multiplier is open.
            let norm = if norms[r] > 0.0 { norms[r] } else { 1.0 };
            let open = DVector::from_fn(rows.len() - rank, |k, _| v[(r, rank + k)] / norm);
            RowReaction { value: multipliers[r] / norm, open }
        };
        own.map(reaction).collect::<Vec<RowReaction>>()
    };
    let locks = (0..joints.len()).map(|i| of_drive(Drive::Lock(i))).collect();
    let mimics = (0..joints.len()).map(|i| of_drive(Drive::Mimic(i)).pop()).collect();
    let couplings = of_drive(Drive::Coupling);
    let holds = found.split_off(1 + joints.len() + mechanism.closures().len());
    let closures = found.split_off(1 + joints.len());
    let of_joints = found.split_off(1);
    Some(ImpactReactions {
        changes,
        joint_changes,
        ground: found.remove(0),
        joints: of_joints,
        closures,
        holds,
        locks,
        mimics,
        couplings,
        imbalance: balance.amax(),
        redundant: rows.len() - rank,
    })
}

impl Place {
    /// Moment about the point and force on the receiver at unit multiplier of a row.
    fn wrench(&self, row: &Row) -> DVector<f64> {
        let mut wrench = DVector::zeros(6);
        for (_, angular, linear) in row.0.iter().filter(|(link, ..)| Some(*link) == self.receiver) {
            let moment = (angular - self.arm.cross(linear)) * self.sign;
            (0..3).for_each(|k| wrench[k] += moment[k]);
            (0..3).for_each(|k| wrench[3 + k] += self.sign * linear[k]);
        }
        wrench
    }
}

/// Places of reactions: the ground, every joint, every closure, every held contact.
fn places(question: &Question, x_wl: &[Matrix4<f64>]) -> Vec<Place> {
    let mechanism = question.mechanism;
    let at_point = |link: usize, local: Vector3<f64>, sign: f64| {
        let turn = rotation(&x_wl[link]);
        let arm = turn * (local - com(&mechanism.links()[link]));
        Place { receiver: Some(link), arm, point: translation(&x_wl[link]) + turn * local, sign }
    };
    let mut places = vec![at_point(mechanism.root().index(), Vector3::zeros(), 1.0)];
    places.extend(mechanism.joints().iter().map(|j| at_point(j.child().index(), Vector3::zeros(), 1.0)));
    for closure in mechanism.closures() {
        let point = translation(&loop_frame_in_world(closure.successor(), x_wl));
        let local = |link: usize| rotation(&x_wl[link]).transpose() * (point - translation(&x_wl[link]));
        places.push(match (closure.successor().link, closure.predecessor().link) {
            (Some(link), _) => at_point(link.index(), closure.successor().frame.translation, 1.0),
            (None, Some(link)) => at_point(link.index(), local(link.index()), -1.0),
            (None, None) => Place { receiver: None, arm: Vector3::zeros(), point, sign: 1.0 },
        });
    }
    places.extend(question.held.iter().map(|held| at_point(held.link.index(), held.point, 1.0)));
    places
}

/// Rows of the base, of all joints, locks and mimics, and of closures, couplings and held contacts.
fn acting_rows(question: &Question, placed: &[JointInWorld], x_wl: &[Matrix4<f64>]) -> Vec<ActingRow> {
    let mechanism = question.mechanism;
    let mut rows = Vec::new();
    let mut add = |drive: Option<Drive>, row: Row, parts: Vec<(usize, Row)>| {
        rows.push(ActingRow { drive, row, parts });
    };
    if !question.floating_base {
        let root = mechanism.root().index();
        for n in WORLD.map(Vector3::from) {
            for row in [Row(vec![(root, n, Vector3::zeros())]), Row(vec![(root, Vector3::zeros(), n)])] {
                add(None, row.clone(), vec![(0, row)]);
            }
        }
    }
    for (i, joint) in placed.iter().enumerate() {
        joint.constraints().into_iter().for_each(|row| add(None, row.clone(), vec![(1 + i, row)]));
        if question.locked.iter().any(|id| id.index() == i) {
            let lock = Some(Drive::Lock(i));
            joint.rates().into_iter().for_each(|row| add(lock, row.clone(), vec![(1 + i, row)]));
        }
        if let Some(mimic) = joint.joint.mimic() {
            let master = mimic.master.index();
            let own = joint.rates().swap_remove(0);
            let of_master =
                Row::default().add_scaled(-mimic.multiplier, &placed[master].rates().swap_remove(0));
            let row = own.clone().add_scaled(1.0, &of_master);
            add(Some(Drive::Mimic(i)), row, vec![(1 + i, own), (1 + master, of_master)]);
        }
    }
    let mut others = loops::rows(question, placed, x_wl).into_iter();
    let first = 1 + placed.len();
    for (i, closure) in mechanism.closures().iter().enumerate() {
        for row in others.by_ref().take(closure.kind().rows()) {
            add(None, row.clone(), vec![(first + i, row)]);
        }
    }
    for coupling in mechanism.couplings() {
        let row = others.next().expect("a row per coupling");
        let part = |(joint, factor): (percuss_mechanism::JointId, f64)| {
            let rate = placed[joint.index()].rates().swap_remove(0);
            (1 + joint.index(), Row::default().add_scaled(factor, &rate))
        };
        let parts = coupling_entries(coupling, &question.positions).into_iter().map(part).collect();
        add(Some(Drive::Coupling), row, parts);
    }
    let first = first + mechanism.closures().len();
    for (i, held) in question.held.iter().enumerate() {
        for row in others.by_ref().take(if held.normal.is_some() { 1 } else { 3 }) {
            add(None, row.clone(), vec![(first + i, row)]);
        }
    }
    rows
}
