//! How far m̄ may be off: rounding, closing, file.
//!
//! First-order perturbations of 1/m̄ under a unit impulse, with V the twists, h the wrenches that joints transmit, u the rates
//! and λ the multipliers of the constraints:
//!
//! ```text
//! δ(1/m̄) = −VᵀδI V + 2 Vᵀδf + 2u δSᵀh + 2λᵀδA u
//! ```
//!
//! for changes of a body's inertia, of a wrench on it, of a joint's column, of rows of A. λ balances what the tree leaves on the
//! coordinates that depend: λᵀK = τ. An error made while Iᴬ is summed up is an error of the body's inertia, so the
//! recursion's own terms bound it: each step counts by what is left below it, not by all that hangs there frozen. Running
//! error analysis: Higham, Accuracy and Stability of Numerical Algorithms, 2002, §3.3 (cited from memory).

use crate::contact::LocatedContact;
use crate::kinematics::Kinematics;
use crate::linear::dense::solve_square;
use crate::linear::jacobian::Jacobian;
use crate::mobility::GroupMobility;
use crate::model::{Cluster, Group, Model};
use crate::recursion::{ClusterElimination, Recursion};
use crate::rows::GroupRows;
use nalgebra::{Vector3, Vector6};
use percuss_mechanism::LinkId;
use percuss_spatial::{ArticulatedInertia, Transform, Twist, Wrench};

/// What m̄ may be off by, kg, to first order. A part that nothing measures is none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ErrorBudget {
    /// Rounding of positions, frames, rows and of the route itself.
    pub rounding: Option<f64>,
    /// What the loops' residual leaves open; 0 where nothing closes.
    pub closing: Option<f64>,
    /// How far the file's loops are from fitting. Only redundant rows measure it: none, unknown, where there are none.
    pub file: Option<f64>,
}

impl ErrorBudget {
    /// The sum of what is known, kg: rounding, closing, and the file's part where redundant rows measure it. None where
    /// rounding or closing is unknown: these always have a measure.
    pub fn known(&self) -> Option<f64> {
        Some(self.rounding? + self.closing? + self.file.unwrap_or(0.0))
    }

    pub(crate) fn scaled(self, factor: f64) -> Self {
        let part = |p: Option<f64>| p.map(|p| p * factor);
        Self { rounding: part(self.rounding), closing: part(self.closing), file: part(self.file) }
    }
}

/// Roundings that a product of rotations adds to a frame's orientation; down a chain they add as a random walk.
const TURN: f64 = 3.0;
/// Rounding of a joint's own sine, cosine and origin: alike at every link of a repetitive chain, it adds up.
const REPEATED: f64 = 1.0;
/// Roundings of a sum of a few products: of an entry of an inertia, a wrench, a pivot.
const SUM: f64 = 5.0;
/// Roundings of a row of A and its elimination, each of its terms' size.
const ROW: f64 = 8.0;

/// How far the frames of bodies may be off, in units of ε.
#[derive(Clone, Debug, Default)]
struct FrameErrors {
    /// For every body: orientation (rad) and position (m).
    of: Vec<(f64, f64)>,
}

impl FrameErrors {
    fn fill(&mut self, model: &Model, kinematics: &Kinematics<f64>) {
        // Squares of the random walks, and how many joints carry each body.
        let mut walks: Vec<(f64, f64, f64)> = Vec::with_capacity(model.bodies.len());
        self.of.clear();
        for (i, body) in model.bodies.iter().enumerate() {
            let (turn, place, depth) = body.parent.map_or((0.0, 0.0, 0.0), |p| walks[p]);
            let (carried, from) =
                body.parent.map_or((0.0, 0.0), |p| (self.of[p].0, self.of[p].1 - place.sqrt()));
            let step = kinematics.steps[i].translation.norm();
            let position = kinematics.frames[i].translation.norm();
            let own = SUM * step + 2.0 * position;
            let walk = (turn + TURN * TURN, place + own * own, depth + 1.0);
            self.of.push((walk.0.sqrt() + REPEATED * walk.2, from + carried * step + walk.1.sqrt()));
            walks.push(walk);
        }
    }

    fn at(&self, body: Option<usize>) -> (f64, f64) {
        body.map_or((0.0, 0.0), |b| self.of[b])
    }
}

/// What an error budget is asked about: a route's answer to a unit impulse along the normal.
pub(crate) struct UnitImpulse<'a> {
    pub model: &'a Model,
    pub kinematics: &'a Kinematics<f64>,
    pub groups: &'a [GroupMobility],
    /// For each group, how far its loops are from fitting, as a part of its size.
    pub misfits: &'a [f64],
    pub contact: &'a LocatedContact,
    /// Twists of the bodies, root axes at the contact point.
    pub twists: &'a [Twist<f64>],
    /// Velocities of the tree.
    pub velocities: &'a [f64],
}

/// The parts of the error of 1/m̄, relative to it.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct RelativeErrors {
    pub rounding: f64,
    /// What rows of A do that are off by as much as their loops are from fitting.
    pub file: f64,
    /// The greatest misfit of a group that moves.
    pub misfit: f64,
    /// Whether a group that moves has redundant rows, which measure the misfit.
    pub is_measured: bool,
}

impl UnitImpulse<'_> {
    /// The error of the recursion's answer.
    pub fn of_recursion(&self, recursion: &Recursion<f64, 1>) -> RelativeErrors {
        let mut sum = self.of_data(&self.transmitted(recursion));
        for (number, cluster) in self.model.clusters.iter().enumerate() {
            sum.rounding += match recursion.place[number] {
                None => self.of_joint(recursion, cluster.bodies[0]),
                Some(place) => self.of_cluster(recursion, cluster, &recursion.clusters[place]),
            };
        }
        self.relative(sum, recursion.response(0, 0))
    }

    fn relative(&self, sum: RelativeErrors, response: f64) -> RelativeErrors {
        RelativeErrors {
            rounding: f64::EPSILON * sum.rounding / response,
            file: sum.file / response,
            is_measured: sum.is_measured,
            misfit: sum.misfit,
        }
    }

    /// The wrench that each body's joint transmits; within a bound cluster without those of its constraints.
    fn transmitted(&self, recursion: &Recursion<f64, 1>) -> Vec<Wrench<f64>> {
        let own = |i: usize| recursion.wrenches[i][0] - self.carried(recursion, i).apply(&self.twists[i]);
        let mut transmitted: Vec<Wrench<f64>> = (0..self.model.bodies.len()).map(own).collect();
        for cluster in self.model.clusters.iter().filter(|c| c.is_bound) {
            for at in (0..cluster.bodies.len()).rev() {
                if let Some(parent) = cluster.parents[at] {
                    let below = transmitted[cluster.bodies[at]];
                    transmitted[cluster.bodies[parent]] += below;
                }
            }
        }
        transmitted
    }

    /// What every route shares: frames, bodies' inertias, joints' columns, the contact, rows of A.
    fn of_data(&self, transmitted: &[Wrench<f64>]) -> RelativeErrors {
        let (model, kinematics) = (self.model, self.kinematics);
        let mut frames = FrameErrors::default();
        frames.fill(model, kinematics);
        let on = frames.at(model.body_of(self.contact.link));
        let against = frames.at(self.contact.against.and_then(|l| model.body_of(l)));
        let point = &self.contact.point_root;
        let reach = point.norm();
        let struck =
            (on.0.max(against.0), on.1 + 2.0 * reach + (on.0 + SUM) * self.contact.point_link.norm());
        let mut sum = RelativeErrors::default();
        // The normal turns with a link; the relative velocity there is what it is multiplied with.
        let relative = self.relative_velocity().norm();
        sum.rounding += 2.0 * (TURN + struck.0) * relative;
        if let Some((end, at)) = self.contact.line {
            // A line turns by what its ends are off, over its length.
            let far = frames.at(model.body_of(end));
            let position = kinematics.link_frame(model, end).point(&at);
            let off = far.1 + 2.0 * position.norm() + (far.0 + SUM) * at.norm();
            let length = (position - point).norm();
            sum.rounding += 2.0 * (struck.1 + off) / length * relative;
            sum.file += 2.0 * self.misfit_of([self.contact.link, end]) / length * relative;
        }
        for (i, body) in model.bodies.iter().enumerate() {
            let (turn, place) = frames.of[i];
            let arm = kinematics.frames[i].translation - point;
            let off = place + struck.1 + arm.norm();
            let twist = &self.twists[i];
            let x = Transform::new(kinematics.frames[i].rotation, arm);
            let own = x.inertia(&body.inertia);
            let (omega, speed) = (twist.angular.norm(), twist.linear.norm());
            let root = own.rotational.trace().abs().sqrt() * omega + own.mass.abs().sqrt() * speed;
            sum.rounding += SUM * root * root;
            let at_origin = twist.velocity_at(&arm);
            let own_root = body.inertia.rotational.trace().abs().sqrt() * omega
                + body.inertia.mass.abs().sqrt() * at_origin.norm();
            sum.rounding += 2.0 * (turn + TURN) * own_root * own_root;
            sum.rounding += 2.0 * omega * off * own.momentum(twist).force.norm();
            // A free base is seen from itself.
            for (k, v) in body.v.clone().enumerate().filter(|_| body.joint.is_some()) {
                let rate = self.velocities[v].abs();
                let s = kinematics.column_at(model, i, k, point);
                let (axis, lever) = (s.angular.norm(), s.linear.norm());
                sum.rounding += 2.0
                    * rate
                    * ((turn + TURN) * axis * transmitted[i].moment.norm()
                        + (axis * off + (turn + TURN) * lever) * transmitted[i].force.norm());
            }
        }
        self.add_rows(&frames, transmitted, &mut sum);
        sum
    }

    /// Velocity of the struck link at the contact point against the other side.
    fn relative_velocity(&self) -> Vector3<f64> {
        let twist = |body: Option<usize>| body.map_or_else(Vector3::zeros, |b| self.twists[b].linear);
        twist(self.model.body_of(self.contact.link))
            - twist(self.contact.against.and_then(|l| self.model.body_of(l)))
    }

    /// How far loops that carry any of these links are from fitting, m.
    fn misfit_of(&self, links: [LinkId; 2]) -> f64 {
        let mut carriers = vec![false; self.model.bodies.len()];
        for body in links.into_iter().filter_map(|link| self.model.body_of(link)) {
            std::iter::successors(Some(body), |&b| self.model.bodies[b].parent)
                .for_each(|b| carriers[b] = true);
        }
        let groups = self.model.groups.iter().zip(self.misfits);
        let carrying = groups.filter(|(group, _)| group.bodies.iter().any(|&b| carriers[b]));
        carrying.map(|(group, misfit)| misfit * group.size).fold(0.0, f64::max)
    }

    /// Rows of A that are off change the rates of what depends.
    fn add_rows(&self, frames: &FrameErrors, transmitted: &[Wrench<f64>], sum: &mut RelativeErrors) {
        for cluster in self.model.clusters.iter().filter(|c| !c.groups.is_empty()) {
            let forces = self.tree_forces(cluster, transmitted);
            let mut rates = vec![0.0; cluster.coordinates.len()];
            for v in cluster.velocities.iter().filter(|v| v.multiplier != 0.0) {
                rates[v.coordinate] = self.velocities[v.index] / v.multiplier;
            }
            let worst = cluster.bodies.iter().map(|&b| frames.of[b]);
            let (turn, place) = worst.fold((0.0, 0.0), |(t, p): (f64, f64), (a, b)| (t.max(a), p.max(b)));
            for own in &cluster.groups {
                let (group, known) = (&self.model.groups[own.group], &self.groups[own.group]);
                let scaled = |c: usize| rates[own.coordinates[c]].abs() * group.lengths[c];
                if (0..group.coordinates.len()).all(|c| scaled(c) == 0.0) {
                    continue;
                }
                sum.misfit = sum.misfit.max(self.misfits[own.group]);
                sum.is_measured |= group.rows > known.pivots.rows.len();
                // δ(1/m̄) = 2 λᵀδA u: the multipliers balance what the tree leaves on the coordinates that depend.
                let force = |c: usize| forces[own.coordinates[c]] / group.lengths[c];
                let mut rows = GroupRows::default();
                rows.fill(self.model, group, self.kinematics);
                let multipliers = multipliers(&rows, group, known, &force);
                let mut terms = vec![0.0; group.rows];
                let mut largest = vec![0.0_f64; group.rows];
                rows.for_each(group, |r, c, a| {
                    terms[r] += (a / group.lengths[c]).abs() * scaled(c);
                    largest[r] = largest[r].max((a / group.lengths[c]).abs());
                });
                let speed = (0..group.coordinates.len()).map(scaled).fold(0.0, f64::max);
                let row = ROW + turn + place / group.size;
                for (i, &r) in known.pivots.rows.iter().enumerate() {
                    // Entries that vanish are sums of terms as large as the row's largest.
                    let change = multipliers[i].abs() * terms[r].max(largest[r] * speed);
                    sum.file += 2.0 * self.misfits[own.group] * change;
                    sum.rounding += 2.0 * row * change;
                }
            }
        }
    }

    /// The force that the tree leaves on each coordinate of a cluster: τ = Σ Sᵀh, h without the constraints' own.
    fn tree_forces(&self, cluster: &Cluster, transmitted: &[Wrench<f64>]) -> Vec<f64> {
        let mut forces = vec![0.0; cluster.coordinates.len()];
        for v in &cluster.velocities {
            let body = cluster.bodies[v.body];
            let s = self.kinematics.column_at(self.model, body, v.component, &self.contact.point_root);
            let inertial = v.armature * self.velocities[v.index];
            forces[v.coordinate] += v.multiplier * (transmitted[body].power(&s) - inertial);
        }
        forces
    }

    /// Iᴬ as it arrives at a body, before its own joint is eliminated.
    fn carried(&self, recursion: &Recursion<f64, 1>, i: usize) -> ArticulatedInertia<f64> {
        let mut inertia = recursion.inertias[i];
        if recursion.place[self.model.cluster_of[i]].is_none() {
            for e in self.model.bodies[i].v.clone().map(|v| &recursion.joints[v]).filter(|e| e.counts) {
                inertia.subtract_dyad(&(e.u * (-1.0 / e.d)), &e.u);
            }
        }
        inertia
    }

    /// The elimination of a plain joint.
    fn of_joint(&self, recursion: &Recursion<f64, 1>, i: usize) -> f64 {
        let body = &self.model.bodies[i];
        let roots = roots(&self.carried(recursion, i));
        let own = energy_root(&roots, &components(&self.twists[i]));
        let parent = body.parent.map_or_else(Twist::zero, |p| self.twists[p]);
        let mut sum = SUM * own * own;
        for e in body.v.clone().map(|v| (&recursion.joints[v], self.velocities[v])).filter(|(e, _)| e.counts)
        {
            let (e, rate) = e;
            sum += SUM * (e.d * rate * rate + (e.t[0] * rate).abs());
            let passed = dot_abs(&e.u, &components(&parent)) * (e.t[0] / e.d).abs();
            let left = energy_root(&roots, &components(&parent));
            sum += SUM * (left * left + passed);
        }
        sum + 2.0 * SUM * dot_abs(&recursion.wrenches[i][0], &components(&self.twists[i]))
    }

    /// The elimination of a bound cluster.
    fn of_cluster(
        &self,
        recursion: &Recursion<f64, 1>,
        cluster: &Cluster,
        room: &ClusterElimination<f64, 1>,
    ) -> f64 {
        let d = room.d;
        let carrier = cluster.parent.map_or_else(Twist::zero, |p| self.twists[p]);
        let u = room.independent_rates(&carrier, true, None);
        let carried = components(&carrier);
        let mut sum = 0.0;
        for (at, &b) in cluster.bodies.iter().enumerate() {
            // Roundings of many terms add as a random walk.
            let mut squares = carried.component_mul(&carried);
            for (psi, u) in room.psi[at * d..(at + 1) * d].iter().zip(&u) {
                let part = components(psi) * *u;
                squares += part.component_mul(&part);
            }
            let terms = squares.map(f64::sqrt);
            let root = energy_root(&roots(&recursion.inertias[b]), &terms);
            sum += (SUM + (d as f64).sqrt()) * root * root;
            sum += 2.0 * SUM * dot_abs(&recursion.wrenches[b][0], &terms);
        }
        for &y in &room.order {
            let part = room.t[y][0] / room.factor[y * d + y];
            sum += SUM * (room.t[y][0] * part + 2.0 * dot_abs(&room.u[y], &carried) * part.abs());
        }
        sum
    }

    /// The error of the careful route's answer: a backward error of n ε in M scaled to unit diagonal. `mass`: M's diagonal
    /// entries and the sizes of their terms.
    pub fn of_least_energy(
        &self,
        recursion: &Recursion<f64, 1>,
        mass_size: &[f64],
        coordinates: &[f64],
        response: f64,
    ) -> RelativeErrors {
        let mut sum = self.of_data(&self.transmitted(recursion));
        let root: f64 = mass_size.iter().zip(coordinates).map(|(m, v)| m.abs().sqrt() * v.abs()).sum();
        sum.rounding += SUM * coordinates.len() as f64 * root * root;
        self.relative(sum, response)
    }
}

/// Rows up to which multipliers are found densely.
const DENSE: usize = 64;

/// λ with K ᵀ λ = force on the coordinates that depend; one a pivot row, over coordinates scaled by lengths.
fn multipliers(
    rows: &GroupRows<f64>,
    group: &Group,
    known: &GroupMobility,
    force: &dyn Fn(usize) -> f64,
) -> Vec<f64> {
    let count = known.pivots.rows.len();
    let (mut row_of, mut column_of) =
        (vec![usize::MAX; group.rows], vec![usize::MAX; group.coordinates.len()]);
    known.pivots.rows.iter().enumerate().for_each(|(i, r)| row_of[*r] = i);
    known.pivots.columns.iter().enumerate().for_each(|(i, c)| column_of[*c] = i);
    let mut right: Vec<f64> = known.pivots.columns.iter().map(|&c| force(c)).collect();
    let mut entries = Vec::new();
    rows.for_each(group, |r, c, a| {
        if row_of[r] != usize::MAX && column_of[c] != usize::MAX {
            entries.push((column_of[c], row_of[r], a / group.lengths[c]));
        }
    });
    if count > DENSE {
        return Jacobian { rows: count, columns: count, entries }.shortest(&right, f64::EPSILON);
    }
    let mut square = vec![0.0; count * count];
    entries.into_iter().for_each(|(i, k, a)| square[i * count + k] += a);
    solve_square(&mut square, &mut right);
    right
}

/// Square roots of the diagonal of an inertia: entries of a positive one are at most products of two of them.
fn roots(inertia: &ArticulatedInertia<f64>) -> Vector6<f64> {
    let (a, l) = (&inertia.angular, &inertia.linear);
    Vector6::new(a.m11, a.m22, a.m33, l.m11, l.m22, l.m33).map(|x| x.abs().sqrt())
}

fn components(twist: &Twist<f64>) -> Vector6<f64> {
    let (w, v) = (&twist.angular, &twist.linear);
    Vector6::new(w.x, w.y, w.z, v.x, v.y, v.z).map(f64::abs)
}

fn energy_root(roots: &Vector6<f64>, components: &Vector6<f64>) -> f64 {
    roots.dot(components)
}

fn dot_abs(wrench: &Wrench<f64>, components: &Vector6<f64>) -> f64 {
    let (m, f) = (&wrench.moment, &wrench.force);
    Vector6::new(m.x, m.y, m.z, f.x, f.y, f.z).map(f64::abs).dot(components)
}
